#!/usr/bin/env bash
# Every benchmark runs, and every comparison of `cargo bench --bench table` with FLINT, PARI/GP and SciPy: they compare all results before
# they time anything. Built as the tests are, so that the times are of no use.
#
# Needs root: it installs PARI/GP, FLINT and a compiler for C as Debian packages, and python-flint, NumPy and SciPy into a folder of its
# own below target/. Exit code 77 if they can't be had.
set -euo pipefail
cd "$(dirname "$0")/../.."
export PROFILE=dev

cargo test --locked --quiet --bench kernels --bench unimodality --bench float
benches/peers.sh setup > target/peers.txt 2>&1 || {
    cat target/peers.txt >&2
    exit 77
}
rows=$(cargo test --locked --quiet --bench table -- --json --repetitions 1)
for job in A B C E F S; do
    count=$(grep --count "^{\"job\":\"$job\"" <<< "$rows") || { echo "FAILED  no row of job $job" >&2; exit 1; }
    echo "job $job: $count comparisons"
done
