#!/usr/bin/env bash
# Basis values in f64, degree 3: here, by SciPy, and by a plain triangle with divisions, in one run on one core.
# Prints million points a second and the ratios.
#
#   benches/float/compare.sh [PYTHON]        a Python with numpy and scipy, python3 unless given
#   benches/float/compare.sh PYTHON rows     prints the rows that benches/table.rs reads, milliseconds for a million points
#
# PROFILE=dev runs what the tests were built with: to see that the results are equal, for times are of no use then.
set -euo pipefail
cd "$(dirname "$0")/../.."
python=${1:-python3}
rows=${2:-}
"$python" -c 'import scipy' 2>/dev/null || { echo "compare.sh: $python has no SciPy: name one that has" >&2; exit 2; }

profile=${PROFILE:-release}
cargo build --locked --profile "$profile" --quiet --example float-throughput
one_core=()
command -v taskset >/dev/null && one_core=(taskset -c "$(taskset -cp $$ | sed 's/.*[ ,-]//')")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
figures() { if [[ $rows ]]; then cat > "$1"; else tee "$1"; fi; }

# SciPy writes its points and its values for α = ∞, which are compared before anything is timed here.
"${one_core[@]}" "$python" benches/float/scipy_side.py "$folder" | figures "$folder/scipy"
"${one_core[@]}" "target/${profile/dev/debug}/examples/float-throughput" "$folder" | figures "$folder/ours"

awk -F'  +' -v rows="$rows" '
    { rate[$1] = $2 }
    function ratio(a, b) {
        if (rows) printf "F\tk = 3, a million points\t%s\t%.6g\t%s\t%.6g\n", a, 1000 / rate[a], b, 1000 / rate[b]
        else printf "%-40s %6.1f times %s\n", a, rate[a] / rate[b], b
    }
    END {
        if (!rows) print ""
        ratio("fast, scattered", "SciPy design_matrix")
        ratio("accurate, scattered", "SciPy design_matrix")
        ratio("fast curve, scattered", "SciPy BSpline.__call__")
        ratio("fast curve, scattered, portable", "SciPy BSpline.__call__")
        ratio("accurate, scattered", "SciPy BSpline.__call__")
        ratio("accurate, scattered, portable", "SciPy BSpline.__call__")
        ratio("accurate curve, scattered", "SciPy BSpline.__call__")
        ratio("accurate curve, scattered, portable", "SciPy BSpline.__call__")
        ratio("fast, one span", "plain triangle, one span")
        ratio("fast, one span, portable", "plain triangle, one span")
    }' "$folder/scipy" "$folder/ours"
