#!/usr/bin/env bash
# The commands that pages mark with `# takes a while`; tests/pages.rs runs all others.
#
# usage: tests/pages.sh [FOLDER OF knotproof]
set -euo pipefail
cd "$(dirname "$0")/.."
programs=$(cd "${1:-target/release}" && pwd)
export PATH="$programs:$PATH"
folder=$(mktemp -d)
trap 'rm -rf "$folder"' EXIT
passed=0 failed=0
while IFS= read -r line; do
    command=${line%%  \#*}
    printf '%s\n' "$command"
    if (cd "$folder" && bash -c "$command" > /dev/null); then passed=$((passed + 1)); else failed=$((failed + 1)); fi
done < <(grep -h '^knotproof .*  # takes a while$' README.md docs/*.md)
echo "$passed passed, $failed failed"
[ "$failed" -eq 0 ] && [ "$passed" -gt 0 ]
