#!/usr/bin/env bash
# The Python package: built, installed into a folder of its own below target/, tested against SciPy, SymPy and fractions, and the cells
# of its pages run.
#
# Takes what it needs from Python's package index; exit code 77 if that can't be had. With the build of the tests: an optimised one
# takes ten minutes.
set -euo pipefail
# The profile of .ci/run, which has built most of it.
export CARGO_INCREMENTAL=0 CARGO_PROFILE_DEV_DEBUG=0
repository=$(cd "$(dirname "$0")/.." && pwd)
venv=$repository/target/python

if ! "$venv/bin/python" -c 'import numpy, scipy, sympy, pytest, hypothesis, sybil, mypy' 2> /dev/null || ! "$venv/bin/maturin" --version > /dev/null 2>&1; then
    python3 -m venv --clear "$venv" && "$venv/bin/pip" install --quiet --disable-pip-version-check maturin numpy scipy sympy pytest hypothesis sybil mypy || {
        echo "SKIPPED: maturin, numpy, scipy, sympy, pytest, hypothesis, sybil and mypy can't be installed" >&2
        exit 77
    }
fi
rm -rf "$venv/wheels"
"$venv/bin/maturin" build --quiet --profile dev --interpreter "$venv/bin/python" --manifest-path "$repository/python/Cargo.toml" --out "$venv/wheels"
"$venv/bin/pip" install --quiet --disable-pip-version-check --force-reinstall --no-deps "$venv"/wheels/*.whl
cd "$repository/python"
"$venv/bin/pytest" -q
"$venv/bin/pytest" -q --doctest-modules --pyargs knotproof
"$venv/bin/mypy" package/knotproof
