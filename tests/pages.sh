#!/usr/bin/env bash
# The commands that pages mark with `# takes a while`; tests/pages.rs runs all others.
#
# usage: tests/pages.sh [FOLDER OF knotproof [FOLDER FOR WHAT THEY WRITE]]
set -euo pipefail
cd "$(dirname "$0")/.."
programs=$(cd "${1:-target/release}" && pwd)
export PATH="$programs:$PATH"
if [ $# -ge 2 ]; then
    rm -rf "$2" && mkdir -p "$2"
    folder=$(cd "$2" && pwd)
else
    folder=$(mktemp -d)
    trap 'rm -rf "$folder"' EXIT
fi
# As in a clone: the page of the report leads to the certificates.
ln -s "$PWD/proofs" "$folder/proofs"
passed=0 failed=0
while IFS= read -r line; do
    command=${line%%  \#*}
    begun=$SECONDS
    if (cd "$folder" && bash -c "$command" > /dev/null); then passed=$((passed + 1)); else failed=$((failed + 1)); fi
    printf '%s  # %d s\n' "$command" $((SECONDS - begun))
done < <(grep -h '^knotproof .*  # takes a while$' README.md docs/*.md)
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
