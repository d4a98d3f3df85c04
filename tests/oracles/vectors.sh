#!/usr/bin/env bash
# The exact values of `knotproof vectors` against SciPy, NURBS-Python (geomdl) and Splipy: what each of them says of the same
# functions at the same points. docs/vectors.md has the table, which has to be the one that comes out.
#
# Installs the three from Python's package index into a folder of its own below target/; exit code 77 if they can't be had.
#
# usage: tests/oracles/vectors.sh [PATH OF knotproof] [--write]
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}
venv=$repository/target/vectors-oracle

if ! "$venv/bin/python" -c 'import scipy, geomdl, splipy' 2> /dev/null; then
    python3 -m venv --clear "$venv" \
        && "$venv/bin/pip" install --quiet --disable-pip-version-check scipy==1.17.1 geomdl==5.4.0 splipy==1.10.1 || {
        echo "SKIPPED: scipy, geomdl and splipy can't be installed" >&2
        exit 77
    }
fi
"$venv/bin/python" "$repository/tests/oracles/vectors.py" "$program" "$repository/docs/vectors.md" "${2:-}"
