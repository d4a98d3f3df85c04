"""python-flint on the jobs A (fmpq), B (fmpz_poly) and E (fmpz_mpoly), for benches/peers.sh.

    python_flint.py slopes FOLDER      writes the polynomials that job C starts from
    python_flint.py check FOLDER       writes the results, to be compared
    python_flint.py time JOB FOLDER    prints lines JOB CASE VARIANT SECONDS, separated by tabs

Cases and results are files as README.md describes them.
"""

import sys
import time
from math import gcd
from pathlib import Path

from flint import Ordering, fmpq, fmpz, fmpz_mpoly_ctx, fmpz_poly

BUDGET = 0.1
CHECKED = 25
FAMILIES = ("uniform", "non-uniform")


def integers(line):
    return [int(word) for word in line.split()]


def timed(job, case, variant, units, run):
    """Runs the job until the time is over, and prints the seconds for each of its units."""
    run()
    runs, start = 0, time.perf_counter()
    while (elapsed := time.perf_counter() - start) < BUDGET:
        run()
        runs += 1
    print(job, case, variant, f"{elapsed / runs / units:.6e}", sep="\t")


# ---- A: the triangle over fmpq, r = 1/3.


def values(x, t, ratio, j, k):
    row, rise, fall = [fmpq(1)], [None], [None]
    for d in range(1, k + 1):
        rise.append(ratio * (x - t[j + 1 - d]))
        fall.append(t[j + d] - x)
        carry = fmpq(0)
        for c in range(d):
            share = row[c] / (rise[d - c] + fall[c + 1])
            row[c] = carry + fall[c + 1] * share
            carry = rise[d - c] * share
        row.append(carry)
    return row


def job_a(folder, check):
    for k in (3, 5, 10, 20):
        lines = (folder / f"A.{k}").read_text().splitlines()
        knots = integers(lines[0])
        points = [integers(line) for line in lines[1:]]
        t, ratio = [fmpq(knot) for knot in knots], fmpq(1, 3)

        def at(point):
            p, q = point
            j = k
            while p >= knots[j + 1] * q:
                j += 1
            return values(fmpq(p, q), t, ratio, j, k)

        if check:
            rows = [" ".join(f"{g.p}/{g.q}" for g in at(point)) for point in points[:CHECKED]]
            (folder / f"A.{k}.flint-py").write_text("\n".join(rows) + "\n")
        else:
            timed("A", f"k = {k}", "python-flint, fmpq", len(points), lambda: [at(point) for point in points])


# ---- B, E and the slopes: numerators over known products of linear factors, then one gcd a function.


def pieces(t, j, k, rise, fall, one):
    """The k + 1 functions on the span [t_j, t_{j+1}), as pairs without a common factor.

    `rise(a)` and `fall(b)` are numerators of r(x - a) and b - x over one denominator. A denominator is a dictionary
    from (a, b) to the exponent of rise(a) + fall(b), so that equal factors are never multiplied in twice.
    """
    factors = {}

    def factor(a, b):
        if (a, b) not in factors:
            factors[a, b] = rise(a) + fall(b)
        return factors[a, b]

    def product(p, exponents):
        for pair, exponent in exponents.items():
            for _ in range(exponent):
                p = p * factors[pair]
        return p

    def over_one_more(numerator, exponents, a, b):
        factor(a, b)
        return numerator, {**exponents, (a, b): exponents.get((a, b), 0) + 1}

    def add(f, g):
        (p, left), (q, right) = f, g
        common = {pair: max(left.get(pair, 0), right.get(pair, 0)) for pair in left | right}
        lacks = lambda own: {pair: exponent - own.get(pair, 0) for pair, exponent in common.items()}
        return product(p, lacks(left)) + product(q, lacks(right)), common

    level = [(one, {})]  # G_{j-d}, ..., G_j of degree d
    for d in range(1, k + 1):
        parts = [[] for _ in range(d + 1)]
        for c, (p, exponents) in enumerate(level):
            a, b = t[j - d + 1 + c], t[j + 1 + c]
            parts[c].append(over_one_more(fall(b) * p, exponents, a, b))
            parts[c + 1].append(over_one_more(rise(a) * p, exponents, a, b))
        level = [part[0] if len(part) == 1 else add(*part) for part in parts]
    quotients = []
    for p, exponents in level:
        q = product(one, exponents)
        common = p.gcd(q)
        quotients.append((p, q) if common == 1 else (p // common, q // common))
    return quotients


def pieces_in_x(t, j, k, ratio):
    """For a given slope ratio (p, q), in x."""
    p, q = ratio
    return pieces(t, j, k, lambda a: fmpz_poly([-p * a, p]), lambda b: fmpz_poly([q * b, -q]), fmpz_poly([1]))


def pieces_in_x_and_r(t, j, k):
    """For every slope ratio r, in x and r."""
    context = fmpz_mpoly_ctx.get(["x", "r"], Ordering.lex)
    x, r = context.gens()
    return pieces(t, j, k, lambda a: r * (x - a), lambda b: b - x, context.constant(1))


def span_case(folder, job, k):
    knots, (j,) = map(integers, (folder / f"{job}.{k}").read_text().splitlines())
    return knots, j


def normal(p, q):
    """P / Q by rising powers of x, with coprime integers, the last of Q positive."""
    p, q = ([int(c) for c in f.coeffs()] for f in (p, q))
    unit = gcd(*p, *q) * (-1 if q[-1] < 0 else 1)
    return " / ".join(" ".join(str(c // unit) for c in f) for f in (p, q))


def job_b(folder, check):
    for k in (*range(3, 11), 12, 14, 16):
        knots, j = span_case(folder, "B", k)
        run = lambda: pieces_in_x(knots, j, k, (1, 3))
        if check:
            (folder / f"B.{k}.flint-py").write_text("".join(normal(p, q) + "\n" for p, q in run()))
        else:
            timed("B", f"k = {k}", "python-flint, fmpz_poly", 1, run)


def terms(f):
    return " ".join(f"{c}:{a}:{b}" for (a, b), c in f.to_dict().items())


def job_e(folder, check):
    for k in range(3, 6):
        knots, j = span_case(folder, "E", k)
        run = lambda: pieces_in_x_and_r(knots, j, k)
        if check:
            (folder / f"E.{k}.flint-py").write_text("".join(f"{terms(p)} / {terms(q)}\n" for p, q in run()))
        else:
            timed("E", f"k = {k}", "python-flint, fmpz_mpoly", 1, run)


def slope(p, q, ends):
    """What decides the sign of (P/Q)' inside the span: its numerator without factors that vanish at the ends only."""
    n = p.derivative() * q - p * q.derivative()
    n = n // q.gcd(q.derivative())
    for end in ends:
        while n and n(fmpz(end)) == 0:
            n = n // fmpz_poly([-end, 1])
    return [int(c) // int(n.content()) for c in n.coeffs()]


def write_slopes(folder):
    for k in range(2, 9):
        for family in FAMILIES:
            rows = []
            for line in (folder / f"C.{k}-{family}").read_text().splitlines():
                p, q, *gaps = integers(line)
                own = [sum(gaps[:i]) for i in range(k + 2)]
                # More knots on both sides, so that every span has all its k + 1 functions.
                t = [-i for i in range(k, 0, -1)] + own + [own[-1] + i for i in range(1, k + 1)]
                for s in range(k + 1):
                    function = pieces_in_x(t, k + s, k, (p, q))[k - s]
                    ends = own[s : s + 2]
                    rows.append(" ".join(map(str, ends + slope(*function, ends))))
            (folder / f"C.{k}-{family}.slopes").write_text("\n".join(rows) + "\n")


JOBS = {"A": job_a, "B": job_b, "E": job_e}

match sys.argv[1:]:
    case ["slopes", folder]:
        write_slopes(Path(folder))
    case ["check", folder]:
        for job in JOBS.values():
            job(Path(folder), check=True)
    case ["time", job, folder]:
        JOBS[job](Path(folder), check=False)
    case _:
        sys.exit(__doc__)
