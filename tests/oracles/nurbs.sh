#!/usr/bin/env bash
# The NURBS curves of `knotproof bezier --as` in the real SciPy, NURBS-Python (geomdl) and Open CASCADE: all points are those of
# `knotproof eval`.
#
# Installs the three from Python's package index into a folder of its own below target/; exit code 77 if they can't be had.
#
# usage: tests/oracles/nurbs.sh [PATH OF knotproof]
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}
venv=$repository/target/nurbs-oracle

# Open CASCADE without VTK, which draws: half the size, and the same kernel.
if ! "$venv/bin/python" -c 'import scipy, geomdl, OCP' 2> /dev/null; then
    python3 -m venv --clear "$venv" && "$venv/bin/pip" install --quiet --disable-pip-version-check scipy geomdl cadquery-ocp-novtk || {
        echo "SKIPPED: scipy, geomdl and cadquery-ocp-novtk can't be installed" >&2
        exit 77
    }
fi
"$venv/bin/python" "$repository/tests/oracles/nurbs.py" "$program"
