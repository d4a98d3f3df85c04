#!/usr/bin/env python3
"""Writes eval.json: values and derivatives of random bases, by an implementation of its own.

Nothing is shared with the Rust code. The weight is the paper's formula D2.3 as printed,
alpha (x - a) / (x + (alpha - 1) b - alpha a), the basis is the recursion D3.3 word for word over all functions of
all degrees, and derivatives come from the truncated power series below. Only the standard library is used.

Run `python3 tests/golden/generate.py` to write the file again; the seed is fixed, so the result is the same.
"""

import json
import pathlib
import random
from fractions import Fraction

ORDER = 3
CASES = 300


# Truncated power series in e: lists c with c[d] the coefficient of e^d, d = 0..ORDER.

def constant(value):
    return [Fraction(value)] + [Fraction(0)] * ORDER


def add(a, b):
    return [p + q for p, q in zip(a, b)]


def subtract(a, b):
    return [p - q for p, q in zip(a, b)]


def scale(factor, a):
    return [factor * p for p in a]


def multiply(a, b):
    return [sum(a[s] * b[d - s] for s in range(d + 1)) for d in range(ORDER + 1)]


def divide(a, b):
    # q b = a, solved one coefficient after the other.
    quotient = []
    for d in range(ORDER + 1):
        known = sum(quotient[s] * b[d - s] for s in range(d))
        quotient.append((a[d] - known) / b[0])
    return quotient


# D2.3 and D3.3. Limits from the left use intervals (a, b] in place of [a, b).

def inside(x, a, b, side):
    return a < x <= b if side == "left" else a <= x < b


def phi(alpha, x, a, b, side):
    if not inside(x, a, b, side):
        return constant(0)
    series = [Fraction(x), Fraction(1)] + [Fraction(0)] * (ORDER - 1)
    rise = subtract(series, constant(a))
    if alpha is None:
        return scale(1 / (b - a), rise)
    return divide(scale(alpha, rise), add(series, constant((alpha - 1) * b - alpha * a)))


def basis(alpha, degree, knots, x, side):
    m = len(knots) - 1
    if x == knots[m]:
        side = "left"
    level = [constant(1 if inside(x, knots[i], knots[i + 1], side) else 0) for i in range(m)]
    for k in range(1, degree + 1):
        w = [phi(alpha, x, knots[i], knots[i + k], side) for i in range(m - k + 1)]
        level = [
            add(multiply(w[i], level[i]), multiply(subtract(constant(1), w[i + 1]), level[i + 1]))
            for i in range(m - k)
        ]
    return level


# Random cases that lean towards trouble.

def random_knots(rng, degree):
    """A knot vector with m >= max(2k, k + 1), t_0 < t_m, and any multiplicities."""
    while True:
        open_ends = rng.random() < 0.5
        stops, t = [], Fraction(rng.randint(-3, 3))
        for _ in range(rng.randint(2, 5)):
            stops.append(t)
            t += rng.choice([Fraction(1), Fraction(1), Fraction(1, 2), Fraction(2, 3), Fraction(3), Fraction(1, 1000)])
        knots = []
        for place, stop in enumerate(stops):
            end = place in (0, len(stops) - 1)
            if end and open_ends:
                multiplicity = degree + 1
            else:
                multiplicity = rng.choice([1, 1, 1, 2, degree, degree + 1, degree + 2, degree + 3])
            knots += [stop] * max(multiplicity, 1)
        if len(knots) - 1 >= max(2 * degree, degree + 1):
            return knots


def random_alpha(rng):
    kind = rng.randrange(6)
    if kind == 0:
        return None
    if kind == 1:
        return Fraction(-1, rng.choice([7, 50, 10**6]))
    if kind == 2:
        return 1 + Fraction(1, rng.choice([7, 50, 10**6]))
    if kind == 3:
        return rng.choice([-1, 1]) * Fraction(10 ** rng.randint(1, 6))
    if kind == 4:
        return -Fraction(rng.randint(1, 9), rng.randint(1, 5))
    return 1 + Fraction(rng.randint(1, 9), rng.randint(1, 5))


def random_x(rng, knots):
    kind = rng.randrange(12)
    if kind == 0:
        return knots[-1]
    if kind == 1:
        return knots[0]
    if kind == 2:
        return rng.choice([knots[0] - Fraction(1, 3), knots[-1] + 1])
    if kind <= 7:
        return rng.choice(knots)
    return knots[0] + (knots[-1] - knots[0]) * Fraction(rng.randint(1, 11), 12)


def text(value):
    return str(value)


def case(rng, number):
    degree = number % 7
    knots = random_knots(rng, degree)
    alpha = random_alpha(rng)
    x = random_x(rng, knots)
    side = rng.choice(["left", "right"])
    functions = basis(alpha, degree, knots, x, side)
    factorials = [1, 1, 2, 6]
    orders = [[text(factorials[d] * f[d]) for f in functions] for d in range(ORDER + 1)]
    return {
        "degree": degree,
        "knots": [text(t) for t in knots],
        "alpha": "inf" if alpha is None else text(alpha),
        "x": text(x),
        "side": side,
        "values": orders[0],
        "derivatives": orders[1:],
    }


def main():
    rng = random.Random(1805)
    cases = [case(rng, number) for number in range(CASES)]
    head = '{"source": "tests/golden/generate.py", "cases": [\n'
    lines = ",\n".join(json.dumps(c, separators=(",", ":")) for c in cases)
    path = pathlib.Path(__file__).with_name("eval.json")
    path.write_text(head + lines + "\n]}\n", encoding="utf-8")


if __name__ == "__main__":
    main()
