#!/usr/bin/env bash
# The formulas of `knotproof formula` in the real Maxima and the real SymPy: all values are those of `knotproof eval`. And in
# the real LaTeX, which has to take them.
#
# Needs root and Debian's packages maxima, python3-sympy and texlive-latex-base, which it installs if they are missing; without
# them it fails.
#
# usage: tests/oracles/formula.sh [PATH OF knotproof]
set -euo pipefail
repository=$(cd "$(dirname "$0")/../.." && pwd)
program=${1:-$repository/target/release/knotproof}

if ! command -v maxima > /dev/null || ! command -v pdflatex > /dev/null || ! /usr/bin/python3 -c 'import sympy' 2> /dev/null; then
    apt-get update -qq
    DEBIAN_FRONTEND=noninteractive apt-get install -y -qq --no-install-recommends maxima python3-sympy texlive-latex-base > /dev/null
fi
/usr/bin/python3 "$repository/tests/oracles/formula.py" "$program"
