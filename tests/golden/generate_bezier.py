#!/usr/bin/env python3
"""Writes bezier.json: random curves as rational Bezier curves, by an implementation of its own.

Nothing is shared with the Rust code, and the way is another one: every basis function becomes a quotient of two
polynomials in s = (x - from)/(to - from), by the recursion D3.3 with the weight D2.3 as printed; the least common
denominator comes from Euclid's algorithm; and powers of s become Bernstein polynomials by
s^l = sum over m >= l of C(m, l)/C(N, l) B_m^N(s). Only the standard library is used.

Run `python3 tests/golden/generate_bezier.py` to write the file again; the seed is fixed, so the result is the same.
"""

import json
import pathlib
import random
from fractions import Fraction
from math import comb

from generate import random_knots, text

CASES = 60
ALPHAS = [None, Fraction(-1), Fraction(2), Fraction(5), Fraction(-1, 7), Fraction(8, 7), Fraction(-4), Fraction(101, 100)]


# Polynomials in s: lists of coefficients without trailing zeros; [] is 0.

def trim(a):
    while a and a[-1] == 0:
        a = a[:-1]
    return a


def add(a, b):
    longer = max(len(a), len(b))
    return trim([sum(p[i] for p in (a, b) if i < len(p)) for i in range(longer)])


def multiply(a, b):
    product = [Fraction(0)] * max(len(a) + len(b) - 1, 0)
    for i, p in enumerate(a):
        for j, q in enumerate(b):
            product[i + j] += p * q
    return trim(product)


def divide(a, b):
    quotient, rest = [Fraction(0)] * max(len(a) - len(b) + 1, 0), list(a)
    while len(rest) >= len(b):
        shift, factor = len(rest) - len(b), rest[-1] / b[-1]
        quotient[shift] = factor
        rest = trim([c - (factor * b[i - shift] if i >= shift else 0) for i, c in enumerate(rest[:-1])])
    return trim(quotient), rest


def gcd(a, b):
    while b:
        a, b = b, divide(a, b)[1]
    return [c / a[-1] for c in a]


# Quotients (p, q).

def reduce(p, q):
    common = gcd(q, p)
    return divide(p, common)[0], divide(q, common)[0]


def plus(f, g):
    return reduce(add(multiply(f[0], g[1]), multiply(g[0], f[1])), multiply(f[1], g[1]))


def times(f, g):
    return reduce(multiply(f[0], g[0]), multiply(f[1], g[1]))


ZERO, ONE = ([], [Fraction(1)]), ([Fraction(1)], [Fraction(1)])


def phi(alpha, a, b, start, end):
    """D2.3 on the span [start, end], as a function of s."""
    if not (a <= start and end <= b):
        return ZERO
    x = trim([start, end - start])
    rise = add(x, [-a])
    if alpha is None:
        return reduce(rise, [b - a])
    return reduce(multiply([alpha], rise), add(x, [(alpha - 1) * b - alpha * a]))


def basis(alpha, degree, knots, j):
    m, start, end = len(knots) - 1, knots[j], knots[j + 1]
    level = [ONE if i == j else ZERO for i in range(m)]
    for k in range(1, degree + 1):
        w = [phi(alpha, knots[i], knots[i + k], start, end) for i in range(m - k + 1)]
        rest = [plus(ONE, times(f, ([Fraction(-1)], [Fraction(1)]))) for f in w]
        level = [plus(times(w[i], level[i]), times(rest[i + 1], level[i + 1])) for i in range(m - k)]
    return level


def bernstein(a, degree):
    coefficient = lambda l: a[l] if l < len(a) else Fraction(0)
    return [sum(Fraction(comb(m, l), comb(degree, l)) * coefficient(l) for l in range(m + 1)) for m in range(degree + 1)]


def piece(alpha, degree, knots, points, j):
    functions = basis(alpha, degree, knots, j)
    curve = []
    for c in range(len(points[0])):
        coordinate = ZERO
        for function, point in zip(functions, points):
            coordinate = plus(coordinate, times(function, (trim([point[c]]), [Fraction(1)])))
        curve.append(coordinate)
    denominator = [Fraction(1)]
    for _, q in curve:
        denominator = multiply(denominator, divide(q, gcd(denominator, q))[0])
    numerators = [multiply(p, divide(denominator, q)[0]) for p, q in curve]
    least = max(len(p) - 1 for p in [denominator] + numerators)
    weights = bernstein(denominator, least)
    rows = [bernstein(p, least) for p in numerators]
    return {
        "span": j,
        "from": text(knots[j]),
        "to": text(knots[j + 1]),
        "base": degree <= j <= len(knots) - degree - 2,
        "degree": least,
        "weights": [text(w / weights[0]) for w in weights],
        "points": [[text(row[m] / weights[m]) for row in rows] for m in range(least + 1)],
    }


def case(rng, number):
    degree = number % 5
    knots = random_knots(rng, degree)
    while len(knots) > 2 * degree + 5:
        knots = random_knots(rng, degree)
    alpha = rng.choice(ALPHAS)
    dimension = rng.randint(1, 3)
    coordinate = lambda: Fraction(rng.randint(-5, 5), rng.choice([1, 1, 1, 2, 3]))
    points = [[coordinate() for _ in range(dimension)] for _ in range(len(knots) - degree - 1)]
    spans = [j for j in range(len(knots) - 1) if knots[j] < knots[j + 1]]
    return {
        "degree": degree,
        "knots": [text(t) for t in knots],
        "alpha": "inf" if alpha is None else text(alpha),
        "points": [[text(c) for c in point] for point in points],
        "pieces": [piece(alpha, degree, knots, points, j) for j in spans],
    }


def main():
    rng = random.Random(1986)
    cases = [case(rng, number) for number in range(CASES)]
    head = '{"source": "tests/golden/generate_bezier.py", "cases": [\n'
    lines = ",\n".join(json.dumps(c, separators=(",", ":")) for c in cases)
    path = pathlib.Path(__file__).with_name("bezier.json")
    path.write_text(head + lines + "\n]}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
