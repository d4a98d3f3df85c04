#!/usr/bin/env python3
"""Writes joins.json: how random curves meet at their knots, by an implementation of its own.

Nothing is shared with the Rust code: the basis and its derivatives are those of generate.py, and the curvature is
det(c', c'')/|c'|^3 in the plane and |c' x c''|/|c'|^3 in space, squared and with its sign. Where a derivative is 0 on
one side there is no case. Only the standard library is used.

Run `python3 tests/golden/generate_joins.py` to write the file again; the seed is fixed, so the result is the same.
"""

import json
import pathlib
import random
from fractions import Fraction

from generate import basis, random_knots, text

CASES = 60
ALPHAS = [None, Fraction(-1), Fraction(2), Fraction(5), Fraction(-1, 7), Fraction(8, 7), Fraction(-4), Fraction(101, 100)]


def dot(a, b):
    return sum(p * q for p, q in zip(a, b))


def branch(alpha, degree, knots, points, x, side):
    functions = basis(alpha, degree, knots, x, side)
    order = lambda d: [sum(g[d] * p[c] for g, p in zip(functions, points)) for c in range(len(points[0]))]
    point, velocity, half = order(0), order(1), order(2)
    return point, velocity, [2 * a for a in half]


def curvature(velocity, acceleration):
    cube = dot(velocity, velocity) ** 3
    if len(velocity) == 2:
        (a, b), (c, d) = velocity, acceleration
        cross = a * d - b * c
        return cross * abs(cross) / cube
    if len(velocity) == 1:
        return Fraction(0)
    (a, b, c), (p, q, r) = velocity, acceleration
    cross = [b * r - c * q, c * p - a * r, a * q - b * p]
    return dot(cross, cross) / cube


def join(alpha, degree, knots, points, x):
    before, after = (branch(alpha, degree, knots, points, x, side) for side in ("left", "right"))
    u, v = before[1], after[1]
    if not any(u) or not any(v):
        return None
    along, left, right = dot(u, v), dot(u, u), dot(v, v)
    return {
        "knot": text(x),
        "g0": before[0] == after[0],
        "cos2": text(along * along / (left * right)),
        "turns_back": along < 0,
        "speed_ratio_squared": text(right / left),
        "before": text(curvature(*before[1:])),
        "after": text(curvature(*after[1:])),
    }


def case(rng, number):
    degree = 1 + number % 4
    knots = random_knots(rng, degree)
    alpha = rng.choice(ALPHAS)
    dimension = rng.randint(1, 3)
    coordinate = lambda: Fraction(rng.randint(-5, 5), rng.choice([1, 1, 1, 2, 3]))
    points = [[coordinate() for _ in range(dimension)] for _ in range(len(knots) - degree - 1)]
    inner = sorted({t for t in knots if knots[0] < t < knots[-1]})
    joins = [join(alpha, degree, knots, points, x) for x in inner]
    return {
        "degree": degree,
        "knots": [text(t) for t in knots],
        "alpha": "inf" if alpha is None else text(alpha),
        "points": [[text(c) for c in point] for point in points],
        "joins": [found for found in joins if found is not None],
    }


def main():
    rng = random.Random(20)
    cases = []
    while len(cases) < CASES:
        one = case(rng, len(cases))
        if one["joins"]:
            cases.append(one)
    lines = ",\n".join(json.dumps(one, separators=(",", ":")) for one in cases)
    path = pathlib.Path(__file__).parent / "joins.json"
    path.write_text('{"source": "tests/golden/generate_joins.py", "cases": [\n' + lines + "\n]}\n")


if __name__ == "__main__":
    main()
