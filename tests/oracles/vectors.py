"""The exact values of `knotproof vectors` against what other libraries compute in floats.

Each library is asked for the functions in its own way, at points and on knots that floats have exactly. A number agrees if it is within
1e-8 of the exact one, relative to the largest function (or derivative) there. What comes out is the tables of docs/vectors.md.

usage: vectors.py PROGRAM PAGE [--write], with SciPy, geomdl and Splipy at hand.
"""

import json
import subprocess
import sys
import tempfile
import warnings
from collections import Counter
from fractions import Fraction
from importlib.metadata import version
from pathlib import Path

import numpy
from geomdl import helpers
from scipy.interpolate import BSpline
from splipy import BSplineBasis

PROGRAM, PAGE, WRITE = sys.argv[1], Path(sys.argv[2]), sys.argv[3:] == ["--write"]
TOLERANCE = Fraction(1, 10**8)
BEGIN, END = "<!-- generated: begin -->\n", "<!-- generated: end -->\n"


class NotOffered(Exception):
    """The library has no call that asks this."""


def scipy(t, k, x, left, nu):
    """`BSpline` with unit coefficients. It has one side: the right one, at t_{n+1} the left one."""
    n = len(t) - k - 1
    if left and x != t[n]:
        raise NotOffered
    return BSpline(t, numpy.eye(n), k, extrapolate=False)(x, nu)


def scipy_elements(t, k, x, left, nu):
    """`BSpline.basis_element`, function by function, as 0 outside of its knots."""
    if left:
        raise NotOffered
    values = [BSpline.basis_element(t[i : i + k + 2], extrapolate=False)(x, nu) for i in range(len(t) - k - 1)]
    return numpy.nan_to_num(numpy.array(values, dtype=float), nan=0.0)


def geomdl(t, k, x, left, nu):
    """`basis_function_one` and `basis_function_ders_one`, function by function."""
    if left:
        raise NotOffered
    knots = list(t)
    functions = range(len(t) - k - 1)
    if nu == 0:
        return numpy.array([helpers.basis_function_one(k, knots, i, x) for i in functions])
    return numpy.array([helpers.basis_function_ders_one(k, knots, i, x, nu)[nu] for i in functions])


def splipy(t, k, x, left, nu):
    """`BSplineBasis.evaluate`, which can be asked for either side."""
    return BSplineBasis(k + 1, t).evaluate(x, d=nu, from_right=not left)[0]


LIBRARIES = [
    ("SciPy", f"`BSpline`, {version('scipy')}", scipy),
    ("SciPy", "`BSpline.basis_element`", scipy_elements),
    ("geomdl", f"`basis_function_one`, {version('geomdl')}", geomdl),
    ("Splipy", f"`BSplineBasis`, {version('splipy')}", splipy),
]

SITUATIONS = [
    "between knots of [t_k, t_{n+1}]",
    "at such a knot, from the right",
    "at such a knot, from the left",
    "at t_{n+1}, from the left",
    "in [t_0, t_k) or (t_{n+1}, t_m]",
    "outside of [t_0, t_m]",
]


def situation(t, k, x, left):
    """Which of the situations it is."""
    first, last = t[k], t[len(t) - k - 1]
    if x < t[0] or x > t[-1]:
        return 5
    if x == last and (left or x == t[-1]):
        return 3
    if x < first or x > last or (left and x == first) or (not left and x == last):
        return 4
    return 0 if x not in t else 2 if left else 1


def vectors():
    """The file, with fractions for its texts."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "vectors.json"
        command = [PROGRAM, "vectors", "--out", str(path), "--format", "json"]
        subprocess.run(command, check=True, capture_output=True)
        return json.loads(path.read_text())


def exact(case, side, nu):
    """All derivatives of one order, as fractions."""
    values = [Fraction(0)] * case["functions"]
    if side["derivatives"]:
        own = side["derivatives"][nu]
        values[side["first"] : side["first"] + len(own)] = map(Fraction, own)
    return values


def agrees(found, expected):
    """Is it a list of as many numbers, all close enough?"""
    found = numpy.atleast_1d(numpy.asarray(found, dtype=float))
    if found.shape != (len(expected),) or not numpy.isfinite(found).all():
        return False
    scale = max(map(abs, expected)) or Fraction(1)
    return all(abs(Fraction(float(f)) - e) <= TOLERANCE * scale for f, e in zip(found, expected))


def asked(call, t, k, x, left, nu):
    """What a library answers: numbers, a refusal in words, or nothing where it can't be asked."""
    with warnings.catch_warnings(), numpy.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        try:
            answer = call(t, k, x, left, nu)
        except NotOffered:
            return None
        except Exception as error:  # whatever a library raises is an answer
            return f"{type(error).__name__}: {error}"
    return "nan" if numpy.isnan(numpy.asarray(answer, dtype=float)).any() else answer


def compare(cases):
    """Of each library and situation how often it agrees, differs, refuses and can't be asked; and the first difference in each."""
    counts, first, by_name = Counter(), {}, Counter()
    for case in cases:
        k, knots = case["degree"], [Fraction(t) for t in case["knots"]]
        t = numpy.array([float(value) for value in knots])
        for point in case["points"]:
            x = Fraction(point["x"])
            for name, left in [("right", False), ("left", True)]:
                if name not in point:
                    continue
                where = situation(knots, k, x, left)
                for nu in range(3):
                    expected = exact(case, point[name], nu)
                    for library, (_, _, call) in enumerate(LIBRARIES):
                        answer = asked(call, t, k, float(x), left, nu)
                        if answer is None:
                            what = "not offered"
                        elif isinstance(answer, str):
                            what = "refused"
                        else:
                            what = "agrees" if agrees(answer, expected) else "differs"
                        counts[library, where, what] += 1
                        if what == "differs":
                            by_name[library, case["name"]] += 1
                            size = (k, len(knots), nu)
                            known = first.get((library, where))
                            if known is None or size < known[0]:
                                first[library, where] = (size, case, x, left, nu, expected, answer)
    return counts, first, by_name


def shown(number):
    """A float, short."""
    return f"{float(number):.6g}"


def tables(cases):
    """The text between the marks of the page."""
    counts, first, by_name = compare(cases)
    lines = [f"{len(cases)} bases of degree 0 to {max(case['degree'] for case in cases)}; values and two derivatives.", ""]
    lines += ["| | " + " | ".join(f"{name}, {call}" for name, call, _ in LIBRARIES) + " |"]
    lines += ["|---|" + "---|" * len(LIBRARIES)]
    for where, situation_name in enumerate(SITUATIONS):
        row = []
        for library in range(len(LIBRARIES)):
            parts = [f"{counts[library, where, what]} {what}" for what in ("agrees", "differs", "refused", "not offered")]
            row.append(", ".join(part for part in parts if not part.startswith("0 ")).replace("agrees", "agree").replace("differs", "**differ**"))
        lines.append(f"| {situation_name} | " + " | ".join(row) + " |")
    lines += ["", "The smallest difference of each kind:", ""]
    for (library, where), (_, case, x, left, nu, expected, answer) in sorted(first.items(), key=lambda item: item[0]):
        name, call, _ = LIBRARIES[library]
        scale = max(map(abs, expected)) or Fraction(1)
        i = next(i for i, (f, e) in enumerate(zip(answer, expected)) if abs(Fraction(float(f)) - e) > TOLERANCE * scale)
        knots = ", ".join(case["knots"])
        order = ["the value", "the first derivative", "the second derivative"][nu]
        side = "from the left" if left else "from the right"
        lines.append(
            f"- {name}, {call.split(',')[0]}, {SITUATIONS[where]}: k = {case['degree']}, U = ({knots}), i = {i}, x = {x}, {side}: "
            f"{order} is {shown(expected[i])}, and it says {shown(answer[i])}."
        )
    kinds = sorted({(library, name) for library, name in by_name})
    lines += ["", "Knots with differences:", ""]
    for library, (name, call, _) in enumerate(LIBRARIES):
        own = [f"{kind} ({by_name[library, kind]})" for of, kind in kinds if of == library]
        lines.append(f"- {name}, {call.split(',')[0]}: {', '.join(own) or 'none'}.")
    return "\n".join(lines) + "\n"


def main():
    """Compares the page with what comes out, or writes it."""
    text = PAGE.read_text()
    head, rest = text.split(BEGIN)
    old, tail = rest.split(END)
    new = tables(vectors()["cases"])
    if WRITE:
        PAGE.write_text(head + BEGIN + new + END + tail)
    elif old != new:
        print(new)
        sys.exit(f"{PAGE} says something else: tests/oracles/vectors.sh PROGRAM --write")
    print(new)


if __name__ == "__main__":
    main()
