#!/usr/bin/env bash
# Decides the number of local maxima of the same random functions, degrees 3 to 5, here and by PARI/GP with
# polsturm, in one run and on one core; checks that all counts agree; prints functions a second and the ratio.
#
#   benches/unimodality/compare.sh [COUNT]        COUNT functions of each degree, 2000 unless given
#   benches/unimodality/compare.sh COUNT rows     prints the rows that benches/table.rs reads, milliseconds for a function
#
# PROFILE=dev runs what the tests were built with: to see that the results are equal, for times are of no use then.
#
# PARI/GP is the package pari-gp of Debian and Ubuntu: apt-get install pari-gp.
set -euo pipefail
cd "$(dirname "$0")/../.."
count=${1:-2000}
rows=${2:-}
[[ $count =~ ^[1-9][0-9]{0,6}$ ]] || { echo "compare.sh: the number of functions is '$count': write 1 to 9999999" >&2; exit 2; }
command -v gp >/dev/null || { echo "compare.sh: gp is missing: install PARI/GP, on Debian: apt-get install pari-gp" >&2; exit 2; }

profile=${PROFILE:-release}
cargo build --locked --profile "$profile" --quiet --example throughput
one_core=()
command -v taskset >/dev/null && one_core=(taskset -c "$(taskset -cp $$ | sed 's/.*[ ,-]//')")
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT

[[ $rows ]] || echo "degree  route                 functions/s   knotproof is"
for degree in 3 4 5; do
    # Twice each in turn, the better run counts: other work on the machine disturbs neither side alone.
    declare -A best=()
    for round in 1 2; do
        read -r seconds share < <("${one_core[@]}" "target/${profile/dev/debug}/examples/throughput" "$degree" "$count" "$folder")
        best[knotproof]=$(awk -v a="$seconds" -v b="${best[knotproof]:-1e9}" 'BEGIN { print a < b ? a : b }')
        for route in by_numerators by_quotients by_quotients_in_u; do
            seconds=$(echo "run(\"$folder\", \"$route\", $route)" |
                "${one_core[@]}" gp --quiet --fast --stacksize 64M benches/unimodality/polsturm.gp)
            best[$route]=$(awk -v a="$seconds" -v b="${best[$route]:-1e9}" 'BEGIN { print a < b ? a : b }')
            if ! cmp --silent "$folder/knotproof" "$folder/$route"; then
                echo "compare.sh: degree $degree: the counts differ from those of polsturm, $route:" >&2
                paste "$folder/cases" "$folder/knotproof" "$folder/$route" | awk -F'\t' '$2 != $3' | head -5 >&2
                exit 1
            fi
        done
    done
    own=${best[knotproof]}
    if [[ $rows ]]; then
        for route in by_numerators by_quotients by_quotients_in_u; do
            awk -v d="$degree" -v n="$count" -v own="$own" -v r="PARI, polsturm, ${route//_/ }" -v t="${best[$route]}" \
                'BEGIN { printf "S\tk = %d\tnumber of maxima\t%.6g\t%s\t%.6g\n", d, 1000 * own / n, r, 1000 * t / n }'
        done
        continue
    fi
    awk -v d="$degree" -v n="$count" -v t="$own" -v s="$share" \
        'BEGIN { printf "%-7s %-20s %12.0f   (%s %% of the spans by intervals)\n", d, "knotproof", n / t, s }'
    for route in by_numerators by_quotients by_quotients_in_u; do
        awk -v n="$count" -v r="polsturm $route" -v t="${best[$route]}" -v own="$own" \
            'BEGIN { printf "        %-20s %10.0f   %.1f times as fast\n", r, n / t, t / own }'
    done
done
[[ $rows ]] || echo "All counts agree: $count functions of each degree, by four routes."
