"""The NURBS curves of `knotproof bezier --as` against the values of `knotproof eval`: in exact fractions here, and read back by
SciPy, NURBS-Python (geomdl) and Open CASCADE, which compute in floats.

usage: nurbs.py PROGRAM, with SciPy, geomdl and OCP at hand.
"""

import json
import os
import subprocess
import sys
import tempfile
from fractions import Fraction
from importlib.metadata import version

import numpy
from geomdl import exchange
from OCP.BRep import BRep_Tool
from OCP.Geom import Geom_BSplineCurve
from OCP.IFSelect import IFSelect_RetDone
from OCP.STEPControl import STEPControl_Reader
from OCP.TopAbs import TopAbs_EDGE
from OCP.TopExp import TopExp_Explorer
from OCP.TopoDS import TopoDS
from scipy.interpolate import BSpline

PROGRAM = sys.argv[1]
POINTS = 200
# Of these so many in exact fractions, which take longer.
EXACT = 20
# How far floats may be away, relative to the largest coordinate; they are within 2e-15.
FLOATS = 1e-12

FLAT = "0,0 1,2 2,2 3,0"
# A curve, and what is asked of its NURBS form.
CURVES = [
    ("--degree 2 --alpha 5", "0 0 0 1 2 2 2", FLAT, ""),
    ("--degree 2 --alpha 5", "0 0 0 1 2 2 2", FLAT, "--degree-to 7"),
    ("--degree 2 --alpha 5", "0 0 0 1 2 2 2", FLAT, "--from 1/3 --to 7/4 --standard-form"),
    ("--degree 2 --alpha inf", "0 0 0 1 2 2 2", FLAT, ""),
    ("--degree 3 --alpha inf", "0 0 0 0 1 1 2 4 4 4 4", "0,0,0 1,2,1 2,2,0 3,0,5 4,-1,2 5,1,1 3,3,3", ""),
    ("--degree 3 --alpha inf", "0 0 0 0 1 1 2 4 4 4 4", "0,0,0 1,2,1 2,2,0 3,0,5 4,-1,2 5,1,1 3,3,3", "--degree-to 5"),
    # Knots that are not clamped: from 0 to 0, and without that.
    ("--degree 3 --alpha inf", "0 1 2 4 5 7 8 9", "1,1 2,5 -1,3 4,0", ""),
    ("--degree 3 --alpha -1", "0 1 2 4 5 7 8 9 11", "1,1 2,5 -1,3 4,0 2,2", ""),
    ("--degree 3 --alpha -1", "0 1 2 4 5 7 8 9 11", "1,1 2,5 -1,3 4,0 2,2", "--from 4 --to 7 --standard-form"),
    # Jumps, one of them where the control points agree.
    ("--degree 1 --alpha -1", "0 0 1 1 2 2 3 3", "0,0 1,1 1,1 2,0 5,5 4,1", ""),
    ("--degree 2 --alpha 2", "0 0 0 1 1 1 3/2 2 2 2", "0,0 1,1 2,0 3,3 4,1 5,2 6,0", "--standard-form"),
    # Functions, of one coordinate.
    ("--degree 4 --alpha -1/7", "0 0 0 0 0 5/2 3 5 5 5 5 5", "0 0 1 0 2 -1 0", "--standard-form"),
    ("--degree 5 --alpha 3", "0 0 0 0 0 0 1 2 4 4 4 4 4 4", "0,1,0 1,2,1 2,0,0 0,-1,3 4,4,4 5,1,2 3,3,0 6,0,1", "--standard-form"),
    # r = 100: weights 10^90 apart, and in standard form 10^4.
    ("--degree 6 --alpha 100/99", "0 0 0 0 0 0 0 1 3 4 8 9 9 9 9 9 9 9", "0,0 1,1 2,4 3,4 4,1 5,0 6,1 7,4 8,4 9,1 9,0", ""),
    ("--degree 6 --alpha 100/99", "0 0 0 0 0 0 0 1 3 4 8 9 9 9 9 9 9 9", "0,0 1,1 2,4 3,4 4,1 5,0 6,1 7,4 8,4 9,1 9,0", "--standard-form"),
    ("--degree 3 --alpha 100/99", "0 0 0 0 1 3 4 8 8 8 8", "0,0 1,1 2,4 3,4 4,1 5,0 6,1", ""),
    ("--degree 2 --family nurbs --set omega=1,2,1/2,3", "0 0 0 1 2 2 2", FLAT, ""),
    ("--degree 2 --family lupas --set q=1/2", "0 0 0 1 2 2 2", FLAT, "--standard-form"),
    ("--degree 2 --family smoothstep", "0 0 0 1/2 2 3 3 3", "0,1 1,4 2,-1 3,2 5,0", ""),
    ("--degree 2 --alpha 1000001/1000000", "0 0 0 1/3 2 5/2 5/2 3 3 3", "0,0 1,2 2,2 3,0 4,4 5,5 6,0", "--standard-form"),
]


def run(command, text=""):
    done = subprocess.run(command, input=text, capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"{' '.join(command)}: exit code {done.returncode}: {done.stderr or done.stdout}")
    return done.stdout


def parameters(curve):
    """For one NURBS curve its parameters y, with the x of the source and the side that the limit is taken from."""
    knots = [Fraction(t) for t in curve["knots"]]
    changes = curve.get("parameter") or [
        {"from": a, "to": b, "ratio": 1} for a, b in zip(curve["knots"], curve["knots"][1:]) if Fraction(a) < Fraction(b)
    ]
    count = POINTS // len(changes) + 1
    for change in changes:
        a, b, ratio = (Fraction(change[name]) for name in ["from", "to", "ratio"])
        for step in range(count + 1):
            s = Fraction(step, count)
            x = a + (b - a) * ratio * s / (ratio * s + 1 - s)
            yield a + (b - a) * s, x, "left" if step == count else "right"
    assert changes[0]["from"] == curve["knots"][0] and Fraction(changes[-1]["to"]) == knots[-1]


def expected(source, places):
    text = "\n".join(f"{x},{side}" for _, x, side in places) + "\n"
    lines = run([PROGRAM, "eval", *source, "--points-file", "-", "--format", "json"], "x,side\n" + text).splitlines()
    return [[Fraction(c) for c in json.loads(line)["curve"]] for line in lines[1:]]


def exactly(curve, y, side):
    """De Boor's algorithm in homogeneous coordinates."""
    knots, degree = [Fraction(t) for t in curve["knots"]], curve["degree"]
    below = [j for j in range(len(knots) - 1) if knots[j] < knots[j + 1] and (knots[j] < y if side == "left" else knots[j] <= y)]
    span = below[-1]
    level = []
    for i in range(span - degree, span + 1):
        weight = Fraction(curve["weights"][i])
        level.append([weight, *(weight * Fraction(c) for c in curve["points"][i])])
    for r in range(1, degree + 1):
        for i in range(degree, r - 1, -1):
            low, high = knots[span - degree + i], knots[span + 1 + i - r]
            share = (y - low) / (high - low)
            level[i] = [(1 - share) * a + share * b for a, b in zip(level[i - 1], level[i])]
    return [c / level[degree][0] for c in level[degree][1:]]


def by_scipy(curves):
    def value(curve):
        knots, weights = (numpy.array([float(Fraction(x)) for x in curve[name]]) for name in ["knots", "weights"])
        points = numpy.array([[float(Fraction(c)) for c in point] for point in curve["points"]])
        above = BSpline(knots, points * weights[:, None], curve["degree"])
        below = BSpline(knots, weights, curve["degree"])
        return lambda y: above(y) / below(y)

    return [value(curve) for curve in curves]


def by_geomdl(text):
    with tempfile.NamedTemporaryFile("w", suffix=".json") as file:
        file.write(text)
        file.flush()
        curves = exchange.import_json(file.name)
    ends = [(curve["knotvector"][0], curve["knotvector"][-1]) for curve in json.loads(text)["shape"]["data"]]
    # It moves the knots to [0, 1].
    return [lambda y, c=curve, e=end: c.evaluate_single((y - e[0]) / (e[1] - e[0])) for curve, end in zip(curves, ends)]


def by_open_cascade(text, curves):
    with tempfile.NamedTemporaryFile("w", suffix=".step") as file:
        file.write(text)
        file.flush()
        reader = STEPControl_Reader()
        if reader.ReadFile(file.name) != IFSelect_RetDone:
            sys.exit("Open CASCADE can't read the file")
        reader.TransferRoots()
    explorer = TopExp_Explorer(reader.OneShape(), TopAbs_EDGE)
    # Its name has changed between versions.
    edge = getattr(TopoDS, "Edge_s", None) or TopoDS.Edge
    found = []
    while explorer.More():
        curve = BRep_Tool.Curve_s(edge(explorer.Current()), 0.0, 0.0)
        found.append(curve)
        explorer.Next()
    shapes = [(curve.Degree(), curve.NbPoles()) for curve in found]
    if shapes != [(curve["degree"], len(curve["weights"])) for curve in curves]:
        sys.exit(f"Open CASCADE reads other curves: {shapes}")

    def value(curve):
        def at(y):
            point = curve.Value(y)
            return [point.X(), point.Y(), point.Z()]

        return at

    return [value(curve) for curve in found]


def main():
    os.environ["NO_COLOR"] = "1"
    worst = {}
    compared = 0
    for source, knots, points, asked in CURVES:
        source = [*source.split(), "--knots", knots, "--points", points]
        bezier = [PROGRAM, "bezier", *source, *asked.split()]
        curves = json.loads(run([*bezier, "--as", "nurbs", "--format", "json"]))["curves"]
        systems = {
            "SciPy": by_scipy(curves),
            "geomdl": by_geomdl(run([*bezier, "--as", "geomdl"])),
            "Open CASCADE": by_open_cascade(run([*bezier, "--as", "step"]), curves),
        }
        for number, curve in enumerate(curves):
            places = list(parameters(curve))
            wanted = expected(source, places)
            compared += len(wanted)
            for (y, x, side), point in list(zip(places, wanted))[:: max(1, len(places) // EXACT)]:
                if exactly(curve, y, side) != point:
                    sys.exit(f"{' '.join(bezier)}: not the curve at x = {x}")
            scale = max(abs(float(c)) for point in wanted for c in point) or 1.0
            for system, values in systems.items():
                for (y, x, _), point in zip(places, wanted):
                    found = values[number](float(y))
                    difference = max(abs(float(c) - a) for c, a in zip(point, found)) / scale
                    worst[system] = max(worst.get(system, (0.0, "")), (difference, f"{' '.join(bezier[2:])} at x = {float(x)}"))
    for system, (difference, where) in worst.items():
        print(f"{system}: within {difference:.1e} of the largest coordinate; the worst: {where}")
        if not difference <= FLOATS:
            sys.exit(f"{system}: further away than {FLOATS}")
    # Why the program warns above this degree.
    if Geom_BSplineCurve.MaxDegree_s() != 25:
        sys.exit(f"the highest degree of Open CASCADE is {Geom_BSplineCurve.MaxDegree_s()} and no longer 25")
    systems = ", ".join(f"{name} {version(name)}" for name in ["scipy", "geomdl", "cadquery-ocp-proxy"])
    print(f"{len(CURVES)} curves, {compared} points: {systems}")


main()
