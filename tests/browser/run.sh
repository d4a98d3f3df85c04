#!/usr/bin/env bash
# The page of the report in headless Chromium: tests/browser/page.mjs says what is tried.
#
# Needs Chromium and Node 18 or later; as root, it installs Debian's packages chromium and nodejs if they are missing. Without
# them it fails: a test that did not run has not passed.
#
# usage: tests/browser/run.sh [PATH OF knotproof [PAGE [FOLDER FOR PICTURES]]]
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}
page=${2:-$repository/target/pages/my-report/index.html}

missing=()
command -v chromium > /dev/null || [ -n "${CHROMIUM:-}" ] || missing+=(chromium)
command -v node > /dev/null || missing+=(nodejs)
if [ ${#missing[@]} -gt 0 ]; then
    if [ "$(id -u)" -ne 0 ] || ! command -v apt-get > /dev/null; then
        echo "FAILED  ${missing[*]} must be installed first" >&2
        exit 1
    fi
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -qq -y --no-install-recommends "${missing[@]}"
fi
if [ ! -e "$page" ]; then
    echo "FAILED  there is no $page: knotproof report --out ${page%/*} writes it" >&2
    exit 1
fi
exec timeout "${DEADLINE:-180}" node "$repository/tests/browser/page.mjs" "$page" "$program" "${@:3}"
