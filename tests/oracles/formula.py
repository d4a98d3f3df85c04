"""The formulas of `knotproof formula`, as SymPy and Maxima read them, against the values of `knotproof eval`; and LaTeX
has to take what is written for it.

usage: formula.py PROGRAM, with SymPy at hand, and `maxima` and `pdflatex` on the path. Every comparison is of exact fractions.
"""

import json
import os
import re
import subprocess
import sys
import tempfile
from fractions import Fraction

import sympy

PROGRAM = sys.argv[1]
# Knots, degree: simple, open, repeated inside, of full multiplicity, with fractions, with functions that are 0.
BASES = [
    ("0 1 2 3 4 5 6", 0),
    ("0 1 2 3 4 5 6", 2),
    ("0 0 0 1 2 3 3 3", 2),
    ("-1 -1/3 0 0 2/5 13/5 3 7/2", 3),
    ("0 0 0 3/4 3/4 3/4 3 3 3", 2),
    ("0 0 0 0 0 5/2 5 5 5 5 5", 4),
    ("0 0 0 0 1 1 1 1", 1),
    # With knots below and at 0, where a factor can be -x: inside, at an end, between others.
    ("-1 -1 -1 0 1 1 1", 2),
    ("-3 -3 -3 -5/2 0 1/3 1/3 1/3", 2),
    ("-3/2 -3/2 -1/2 0 0 1", 1),
    ("-3 -5/2 -3/2 -3/2 -3/2 -1/2 -1/2 0 2 2", 3),
    ("-2 -2 -2 -2 -2 -1 -1 -1 -1 -1", 4),
]
INDICES = ["-1", "2", "5", "-1/7", "1000001/1000000", "inf"]


def run(command, text=""):
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr or done.stdout}")
    return done.stdout


def points(knots):
    """Every knot, close to it on both sides, between knots, and outside."""
    knots = sorted({Fraction(t) for t in knots.split()})
    near = Fraction(1, 10**6)
    found = {x for t in knots for x in (t - near, t, t + near)} | {knots[0] - 1, knots[-1] + 1}
    for a, b in zip(knots, knots[1:]):
        found |= {a + (b - a) * Fraction(c, 7) for c in (1, 3, 5)}
    return sorted(found)


def expected(basis, alpha, xs):
    command = [PROGRAM, "eval", *basis, "--alpha", alpha, "--points-file", "-", "--format", "json"]
    lines = run(command, "\n".join(map(str, xs)) + "\n").splitlines()
    rows = [json.loads(line) for line in lines[1:]]
    return [[Fraction(value) for value in row["values"]] for row in rows]


def by_sympy(source, alpha, xs):
    names = {}
    exec(source, names)  # a program, as the user would run it
    values = {names["x"]: None}
    if "alpha" in source.split("from sympy", 1)[1]:
        values[names["alpha"]] = sympy.Rational(alpha)
    rows = []
    for x in xs:
        values[names["x"]] = sympy.Rational(x.numerator, x.denominator)
        row = [sympy.sympify(names["G"][i]).subs(values) for i in sorted(names["G"])]
        if not all(value.is_Rational for value in row):
            sys.exit(f"SymPy: no exact numbers at x = {x}: {row}")
        rows.append([Fraction(int(value.p), int(value.q)) for value in row])
    return rows


def by_maxima(source, count, alpha, xs):
    """One line of output a value: Maxima ends with code 0 whatever happens, so that each has to be a fraction."""
    last = f", {alpha}" if ", alpha) :=" in source else ""
    calls = [f'print("value", G_{i}({x}{last}))$' for x in xs for i in range(count)]
    # Loaded from a file, as the user would do it.
    with tempfile.NamedTemporaryFile("w", suffix=".mac") as file:
        file.write(source + "\n")
        file.flush()
        printed = run(["maxima", "--very-quiet"], f'display2d: false$ linel: 100000$\nload("{file.name}")$\n' + "\n".join(calls) + "\n")
    found = re.findall(r"^value (-?\d+(?:/\d+)?) *$", printed, re.MULTILINE)
    if len(found) != len(calls):
        sys.exit(f"Maxima: {len(found)} of {len(calls)} values:\n{printed[:3000]}")
    values = iter(map(Fraction, found))
    return [[next(values) for _ in range(count)] for _ in xs]


def compiled(sources):
    """All documents as one: a fault, or a character that the font does not have, ends the run."""
    head = "\\documentclass{article}\n\\usepackage{amsmath}\n\\tracinglostchars=2\n\\begin{document}\n"
    with tempfile.TemporaryDirectory() as folder:
        with open(os.path.join(folder, "formulas.tex"), "w") as file:
            file.write(head + "\n\\clearpage\n".join(sources) + "\\end{document}\n")
        command = ["pdflatex", "-interaction=nonstopmode", "-halt-on-error", "-draftmode", "formulas.tex"]
        done = subprocess.run(command, cwd=folder, capture_output=True, text=True, errors="replace")
    faults = [line for line in done.stdout.splitlines() if line.startswith(("!", "Missing character"))]
    if done.returncode != 0 or faults:
        sys.exit(f"LaTeX: exit code {done.returncode}: {faults}\n{done.stdout[-3000:]}")


def main():
    os.environ["NO_COLOR"] = "1"
    compared = 0
    documents = []
    for knots, degree in BASES:
        basis = ["--degree", str(degree), "--knots", knots]
        xs = points(knots)
        for form in ["--factored", "--expanded"]:
            documents += [
                run([PROGRAM, "formula", *basis, "--alpha", alpha, form, "--as", "latex"])
                for alpha in [*INDICES, "symbolic"]
            ]
            symbolic = {
                language: run([PROGRAM, "formula", *basis, "--alpha", "symbolic", form, "--as", language])
                for language in ["sympy", "maxima"]
            }
            for alpha in INDICES:
                wanted = expected(basis, alpha, xs)
                sources = [
                    {
                        language: run([PROGRAM, "formula", *basis, "--alpha", alpha, form, "--as", language])
                        for language in ["sympy", "maxima"]
                    }
                ]
                if alpha != "inf":
                    sources.append(symbolic)
                for source in sources:
                    results = {
                        "SymPy": by_sympy(source["sympy"], alpha, xs),
                        "Maxima": by_maxima(source["maxima"], len(wanted[0]), alpha, xs),
                    }
                    for system, found in results.items():
                        for x, row, other in zip(xs, wanted, found):
                            if row != other:
                                sys.exit(f"{system}: {knots}, degree {degree}, {alpha}, {x}: {other} and not {row}")
                            compared += len(row)
    if compared < 10000:
        sys.exit(f"only {compared} values were compared")
    compiled(documents)
    version = run(["maxima", "--version"]).strip()
    latex = run(["pdflatex", "--version"]).splitlines()[0]
    print(f"{compared} values agree: SymPy {sympy.__version__}, {version}; {len(documents)} documents: {latex}")


main()
