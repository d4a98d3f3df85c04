#!/usr/bin/env bash
# knotproof beside FLINT (in C and in Python) and PARI/GP on the same jobs, in one run and on one core: compares all
# results, then times the systems in turn, and writes benches/peers.md. About three minutes.
#
# FLINT in C is that of the distribution, which has headers; for the jobs B and C also FLINT 3, which is much faster at C: the
# one that python-flint brings with it.
#
#   benches/peers.sh setup            installs what is missing, on Debian or Ubuntu, as root
#   benches/peers.sh [REPETITIONS]    runs; 5 repetitions unless given
#   benches/peers.sh rows REPETITIONS JOB...
#                                     runs these of the jobs A, B, C, E and writes to standard output, in place of benches/peers.md,
#                                     the rows that benches/table.rs reads
#
# PROFILE=dev runs what the tests were built with: to see that the results are equal, for times are of no use then.
#
# The virtual environment of python-flint is target/peers/venv, or $PEERS_VENV.
set -euo pipefail
cd "$(dirname "$0")/.."
out=$PWD/target/peers
venv=${PEERS_VENV:-$out/venv}

if [[ ${1:-} == setup ]]; then
    apt-get install -y --no-install-recommends pari-gp libflint-dev libgmp-dev gcc python3-venv
    python3 -m venv "$venv"
    "$venv/bin/pip" install --quiet python-flint==0.9.0 numpy scipy
    exit
fi
rows=()
if [[ ${1:-} == rows ]]; then
    rows=("${@:3}")
    shift
fi
repetitions=${1:-5}
[[ $repetitions =~ ^[1-9][0-9]?$ ]] || { echo "peers.sh: the number of repetitions is '$repetitions': write 1 to 99" >&2; exit 2; }
for program in gp gcc "$venv/bin/python"; do
    command -v "$program" >/dev/null || { echo "peers.sh: $program is missing: run benches/peers.sh setup" >&2; exit 2; }
done

rm -rf "$out/cases"
mkdir -p "$out/cases"
profile=${PROFILE:-release}
cargo build --locked --profile "$profile" --quiet --example peers
gcc -O3 benches/peers/flint.c -lflint -lgmp -o "$out/flint"
libraries=$("$venv/bin/python" -c 'import flint, pathlib; print(pathlib.Path(flint.__file__).parents[1] / "python_flint.libs")')
gcc -O3 benches/peers/flint3.c "$libraries"/libflint-*.so* "$libraries"/libgmp-*.so* "-Wl,-rpath,$libraries" -o "$out/flint3"
one_core=()
command -v taskset >/dev/null && one_core=(taskset -c "$(taskset -cp $$ | sed 's/.*[ ,-]//')")
"${one_core[@]}" "$venv/bin/python" benches/peers/compare.py \
    "$out/cases" benches/peers.md "target/${profile/dev/debug}/examples/peers" "$out/flint" "$out/flint3" "$repetitions" "${rows[@]}"
((${#rows[@]})) || echo "Written: benches/peers.md"
