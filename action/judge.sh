#!/usr/bin/env bash
# Judges every paper below a folder, and writes the page of each below another one:
#
#     action/judge.sh PAPERS OUT
#
# A paper is a folder with a paper.toml. With a verdicts.json in it, as `knotproof judge FOLDER --record` writes it, each verdict has to be the recorded
# one; without, each claim has to hold as printed. Exit code 0: so it is; 1: somewhere it is not, or a folder is not in order; 2: there is
# nothing to judge. On GitHub what is wrong is also told as an error of the job.
set -euo pipefail
export KNOTPROOF_PROGRESS=never

[ $# -eq 2 ] || { echo "usage: $0 PAPERS OUT" >&2; exit 2; }
papers=${1%/} out=$2
on_github() { [ "${GITHUB_ACTIONS:-}" = true ]; }

# What is wrong with the papers; the annotation is one line, with what its syntax wants for line breaks.
failed=0
fail() {
    failed=$((failed + 1))
    printf 'error: %s\n' "$1" >&2
    if on_github; then
        local text=${1//'%'/%25}
        printf '::error::%s\n' "${text//$'\n'/%0A}"
    fi
}

count=0
while IFS= read -r paper; do
    folder=$(dirname "$paper")
    name=${folder#"$papers"}
    name=${name#/}
    # A folder that is itself a paper.
    name=${name:-$(basename "$(cd "$folder" && pwd)")}
    recorded=$folder/verdicts.json
    arguments=("$folder" --out "$out/$name")
    [ ! -f "$recorded" ] || arguments+=(--baseline "$recorded")
    count=$((count + 1))
    mkdir -p "$(dirname "$out/$name")"
    ! on_github || echo "::group::$folder"
    code=0
    said=$(knotproof judge "${arguments[@]}" 2>&1) || code=$?
    printf '%s\n' "$said"
    ! on_github || echo "::endgroup::"
    record="knotproof judge $folder --record $recorded"
    case $code in
        0) ;;
        1 | 3)
            if [ -f "$recorded" ]; then
                fail "$folder: $(sed -n '/^Not as recorded: /,$p' <<< "$said")
If that is right: $record"
            else
                # Each counterexample stands below the names of the files.
                fail "$folder: a claim does not hold as printed, or is not decided, and no verdicts are recorded:
$(awk '/^(Written|Not drawn): / { found = ""; next } { found = found $0 "\n" } END { printf "%s", found }' <<< "$said")
If that is right: $record"
            fi
            ;;
        *) fail "$folder: $said" ;;
    esac
done < <(find "$papers" -name paper.toml -type f | LC_ALL=C sort)

if [ "$count" -eq 0 ]; then
    echo "error: there is no paper below $papers: no folder with a paper.toml; \`knotproof new FOLDER\` makes one" >&2
    exit 2
fi
printf '\n%d of %d papers are as they should be; their pages: %s\n' "$((count - failed))" "$count" "$out"
[ "$failed" -eq 0 ]
