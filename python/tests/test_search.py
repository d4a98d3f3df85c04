"""The search, and how it is stopped."""

import signal
import subprocess
import sys
import time

import pytest

import knotproof
from knotproof import search


def test_a_search_to_its_end():
    states = list(search(3, limit=9))
    last = states[-1]
    assert last.complete and last.done == last.total and last.several > 0 and last.undecided == 0
    finding = last.findings[0]
    assert len(finding.basis.shape(finding.index).maxima) == finding.maxima == 2
    assert 0 < finding.dip[0] <= finding.dip[1] < 1 and finding.again.startswith("knotproof shape ")
    assert last == search(3, limit=9).run()


def test_random_cases_and_parts():
    whole = search(3, count=400, seed=1).run()
    parts = [search(3, count=400, seed=1, shard=f"{part}/2").run() for part in range(2)]
    assert whole.cases == sum(part.cases for part in parts) == 400
    given = search(3, count=50, alpha=["-4", "-1/2"], find="deepest").run()
    assert all(finding.basis.alpha in (-4, knotproof.Basis("0 1", 0, alpha="-1/2").alpha) for finding in given.findings)


def test_a_family():
    state = search(2, family="lupas", q="1/2", limit=4).run()
    assert state.complete and state.cases > 0


def test_two_equal_maxima_are_looked_for():
    assert search(3, "equal", limit=7).run().complete


@pytest.mark.parametrize(
    ("options", "text"),
    [
        ({"degree": 0}, "degree: 0 is out of range: 1 to 16"),
        ({"degree": 3, "find": "all"}, "find: unknown variant `all`, expected one of `several`, `most`"),
        ({"degree": 3, "limit": 2000}, "limit: "),
        ({"degree": 3, "limit": 9, "shard": "4/4"}, "shard: .*numbered from 0 to 3"),
        ({"degree": 3, "alpha": -1}, "count: .*count=10000"),
        ({"degree": 3, "count": 9, "alpha": "1/2"}, r"alpha: 1/2 lies in \[0, 1\]"),
        ({"degree": 3, "count": 9, "limit": 9}, "count: random cases have no limit"),
        ({"degree": 3, "q": 2}, "family: say whose parameters q are"),
        ({"degree": 3, "family": "lupas", "find": "equal"}, "find: two equal maxima"),
    ],
)
def test_wrong_searches_say_what_is_wrong(options, text):
    with pytest.raises(ValueError, match=text):
        search(**options)


def test_a_search_that_is_stopped_ends():
    running = search(6, limit=60)
    assert not next(running).complete
    running.stop()
    begun = time.monotonic()
    states = list(running)
    assert time.monotonic() - begun < 30 and not any(state.complete for state in states)
    with pytest.raises(ValueError, match="the search has ended"):
        running.run()


@pytest.mark.parametrize(
    "work",
    [
        "knotproof.search(9, limit=60).run()",
        "list(knotproof.judge('rational-bsplines'))",
        "knotproof.Basis(range(60), 20, alpha='-1/3').curve(range(39)).to_nurbs()",
    ],
)
def test_ctrl_c_stops_long_work(work):
    # Where the tests run in the background of a script, Ctrl-C is ignored, and Python leaves it so.
    program = f"""
import knotproof, signal
signal.signal(signal.SIGINT, signal.default_int_handler)
print("begun", flush=True)
try:
    {work}
except KeyboardInterrupt:
    print("stopped", flush=True)
"""
    with subprocess.Popen([sys.executable, "-c", program], stdout=subprocess.PIPE, text=True) as process:
        assert process.stdout.readline() == "begun\n"
        time.sleep(1)
        begun = time.monotonic()
        process.send_signal(signal.SIGINT)
        assert process.stdout.readline() == "stopped\n"
        assert process.wait(60) == 0 and time.monotonic() - begun < 20


def test_other_threads_go_on():
    import threading

    ticks, over = [], threading.Event()

    def tick():
        while not over.is_set():
            ticks.append(time.monotonic())
            time.sleep(0.01)

    thread = threading.Thread(target=tick)
    thread.start()
    knotproof.search(4, limit=11).run()
    over.set()
    thread.join()
    assert max((b - a for a, b in zip(ticks, ticks[1:])), default=0) < 5
