"""Runs knotproof and its peers on the same cases: compares all results, then times them in turn.

    compare.py FOLDER REPORT PEERS FLINT FLINT3 [REPETITIONS [JOB ...]]

FOLDER takes the cases and results, REPORT the table; PEERS is the program from ours.rs, FLINT that from flint.c, FLINT3 that
from flint3.c. Of jobs that are named there is no report: standard output takes a line for each of our figures and each peer,
`JOB<tab>SIZE<tab>OURS<tab>MILLISECONDS<tab>PEER<tab>MILLISECONDS`.
Exit code 1: two results differ, and nothing is timed. README.md describes the files.
"""

import datetime
import importlib.metadata
import os
import platform
import re
import subprocess
import sys
from collections import defaultdict
from pathlib import Path
from statistics import median

from flint import Ordering, fmpz, fmpz_mpoly_ctx

HERE = Path(__file__).parent

# (job, heading, what one unit is); the figures are seconds for one unit.
JOBS = [
    ("A", "Exact values of the k + 1 functions at rational points x = p/q, q about 2²⁰", "a point"),
    ("B", "The k + 1 functions on one span as reduced P/Q", "a span"),
    ("C", "Counting the critical points of one function on all its spans", "a function"),
    # D, values in f64 against SciPy, has its place here.
    ("E", "The k + 1 functions on one span for every r", "a span"),
    ("growth", "How A grows with the degree and with the number of knots", "a point"),
]
NOTES = {
    "A": "r = 1/3, open uniform knots: 4 inner ones for k = 3, 8 for the others. The peers run the triangle over their "
    "own reduced fractions.",
    "B": "r = 1/3, the knots of A, the span in the middle. Ours are quotients in the span's coordinate u = (x − a)/(b − x), "
    "those of the peers in x. FLINT in C finds what cancels by a gcd, or by trying the known factors.",
    "C": "Uniform: one function, r = 1/3. Non-uniform: eight functions with random gaps from 1 to 9, r = 3. The peers "
    "get the numerators of the derivatives ready made; so does `from polynomials`, and `from the knots` computes "
    "them, or does without. A count from the knots is that of the sign changes: in these cases all roots are simple. "
    "FLINT 3 isolates the roots by Vincent, Collins and Akritas.",
    "E": "The knots of B. The result of knotproof is not reduced, as that in the last column of PARI; all others are.",
    "growth": "r = 1/3, open uniform knots.",
}


# Whose results there have to be.
RESULTS = {
    "A": {"knotproof-reduced", "knotproof-unreduced", "flint-c", "flint-py", "pari"},
    "B": {"knotproof", "flint-c", "flint-c-factors", "flint-3", "flint-3-factors", "flint-py", "pari", "pari-quotients"},
    "C": {"knotproof-from-the-knots", "knotproof-from-polynomials", "flint-c", "flint-3", "pari"},
    "E": {"knotproof", "flint-py", "pari", "pari-quotients"},
}


def run(*command, **options):
    return subprocess.run([str(word) for word in command], check=True, text=True, **options)


def gp(call):
    return run("gp", "-q", "-f", "--default", "recover=0", HERE / "pari.gp", input=call + "\n", stdout=subprocess.PIPE)


class Peers:
    """The systems, each with the jobs that it does."""

    def __init__(self, folder, ours, flint, flint3):
        self.folder, self.ours, self.flint, self.flint3 = folder, ours, flint, flint3
        self.python = (sys.executable, HERE / "python_flint.py")

    def prepare(self):
        run(self.ours, "cases", self.folder)
        run(*self.python, "slopes", self.folder)

    def check(self):
        for program in ((self.ours,), (self.flint,), (self.flint3,), self.python):
            run(*program, "check", self.folder)
        gp(f'check("{self.folder}")')

    def time(self, job):
        """The lines of all systems, in turn."""
        commands = [
            ((self.ours,), "ABCE growth"),
            ((self.flint,), "ABC"),
            ((self.flint3,), "BC"),
            (self.python, "ABE"),
        ]
        for program, jobs in commands:
            if job in jobs:
                yield from run(*program, "time", job, self.folder, stdout=subprocess.PIPE).stdout.splitlines()
        if job in "ABCE":
            yield from gp(f'jobs("{job}", "{self.folder}")').stdout.splitlines()


# ---- Are the results equal?


def cases_of(folder):
    """The results of each case: {("A", "3"): {"flint-c": text, ...}, ...}."""
    cases = defaultdict(dict)
    for path in folder.iterdir():
        job, case, *system = path.name.split(".")
        if system and system != ["slopes"]:
            cases[job, case][system[0]] = path.read_text()
    return cases


def differences(folder):
    cases = cases_of(folder)
    if absent := RESULTS.keys() - {job for job, _ in cases}:
        yield f"no results of the jobs {', '.join(sorted(absent))}"
    for (job, case), results in sorted(cases.items()):
        if missing := RESULTS[job] - results.keys():
            yield f"{job} {case}: no result of {', '.join(sorted(missing))}"
        reference, *others = sorted(results)
        quotients = {name: functions(folder, case, name, text) for name, text in results.items()} if job == "E" else {}
        for other in others:
            if job == "E":
                same = equal(quotients[reference], quotients[other])
            else:
                same = results[reference] == results[other] and results[reference].strip() != ""
            if not same:
                yield f"{job} {case}: {reference} and {other} differ: see {folder}"


RING = fmpz_mpoly_ctx.get(["x", "r"], Ordering.lex)
X, R = RING.gens()


def functions(folder, case, name, text):
    """The quotients of job E in x and r. Those of knotproof are in u = (x - a)/(b - x), [a, b] the span."""
    knots, span = (folder / f"E.{case}").read_text().splitlines()
    a, b = [int(knot) for knot in knots.split()][int(span) :][:2]
    return [quotient(line, (X - a, b - X) if name.startswith("knotproof") else (X, RING.constant(1))) for line in text.splitlines()]


def quotient(line, over):
    """P/Q from the terms c:a:b of both, each for c·y^a·r^b with y = over[0]/over[1]."""
    sides = [[tuple(map(int, term.split(":"))) for term in side.split()] for side in line.split("/")]
    top = max(a for side in sides for _, a, _ in side)
    return [
        sum((fmpz(c) * over[0] ** a * over[1] ** (top - a) * R**b for c, a, b in side), RING.constant(0))
        for side in sides
    ]


def equal(left, right):
    products = [(p * s, q * r, q * s) for (p, q), (r, s) in zip(left, right)]
    return 0 < len(left) == len(right) and all(ps == qr and qs != 0 for ps, qr, qs in products)


# ---- The report.


def microseconds(seconds):
    return f"{seconds * 1e6:,.3g}" if seconds < 1e-3 else f"{seconds * 1e6:,.0f}"


def table(figures):
    """One row a case; each of ours with the factor by which it is faster than each of theirs."""
    variants = list(dict.fromkeys(variant for _, variant in figures))
    ours = [variant for variant in variants if variant.startswith("knotproof")]
    peers = [variant for variant in variants if variant not in ours]
    heads = [*ours, *peers, *(f"{o.removeprefix('knotproof, ')} against {p}" for o in ours for p in peers)]
    yield "| | " + " | ".join(heads) + " |"
    yield "|---|" + "---:|" * len(heads)
    for case in dict.fromkeys(case for case, _ in figures):
        cells = [microseconds(figures[case, v]) if (case, v) in figures else "–" for v in ours + peers]
        for o in ours:
            for p in peers:
                known = (case, o) in figures and (case, p) in figures
                cells.append(f"{figures[case, p] / figures[case, o]:.2f}×" if known else "–")
        yield f"| {case} | " + " | ".join(cells) + " |"


def machine():
    names = re.findall(r"model name\s*:\s*(.*)", Path("/proc/cpuinfo").read_text())
    return f"{names[0] if names else platform.machine()}, one of {os.cpu_count()} cores, {platform.system()} {platform.release()}"


def versions(peers):
    first = lambda *command: run(*command, stdout=subprocess.PIPE).stdout.split("\n")[0]
    return [
        f"knotproof {first('git', '-C', HERE, 'describe', '--always', '--dirty')}, {first('rustc', '--version')}",
        first(peers.flint, "version"),
        first(peers.flint3, "version"),
        f"python-flint {importlib.metadata.version('python-flint')}, Python {platform.python_version()}",
        f"PARI/GP {first('gp', '--version-short')}",
    ]


def report(figures, repetitions, peers):
    yield "# knotproof beside FLINT and PARI"
    yield ""
    yield "Written by `benches/peers.sh`, not by hand. All results were compared and found equal before the clock ran."
    yield (
        f"Figures are microseconds, medians of {repetitions} repetitions in which the systems took turns; a ratio of 2 says "
        "that knotproof is twice as fast."
    )
    yield ""
    yield f"- {datetime.date.today()}, {machine()}"
    yield from (f"- {line}" for line in versions(peers))
    for job, heading, unit in JOBS:
        yield f"\n## {job}. {heading}" if len(job) == 1 else f"\n## {heading}"
        yield f"\nMicroseconds for {unit}. {NOTES[job]}\n"
        yield from table(figures[job])


def rows(job, figures):
    """One line for each of ours and each of theirs."""
    for (case, ours), seconds in figures.items():
        if ours.startswith("knotproof"):
            for (other, peer), theirs in figures.items():
                if other == case and not peer.startswith("knotproof"):
                    own = ours.removeprefix("knotproof").removeprefix(", ")
                    yield f"{job}\t{case}\t{own}\t{seconds * 1e3}\t{peer}\t{theirs * 1e3}"


def main(folder, target, ours, flint, flint3, repetitions=5, *jobs):
    folder, repetitions = Path(folder), int(repetitions)
    peers = Peers(folder, ours, flint, flint3)
    peers.prepare()
    peers.check()
    if differing := list(differences(folder)):
        sys.exit("\n".join(differing))
    tell = lambda text: print(text, file=sys.stderr if jobs else sys.stdout, flush=True)
    tell("All results are equal.")
    figures = {}
    for job, heading, _ in JOBS:
        if jobs and job not in jobs:
            continue
        tell(f"{job}: {heading}")
        seconds = defaultdict(list)
        for _ in range(repetitions):
            for line in peers.time(job):
                _, case, variant, figure = line.split("\t")
                seconds[case, variant].append(float(figure))
        figures[job] = {key: median(values) for key, values in seconds.items()}
    if jobs:
        print("\n".join(row for job in figures for row in rows(job, figures[job])))
    else:
        Path(target).write_text("\n".join(report(figures, repetitions, peers)) + "\n")


if __name__ == "__main__":
    main(*sys.argv[1:])
