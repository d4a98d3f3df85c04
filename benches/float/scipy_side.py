"""The other side of benches/float/compare.sh: SciPy on the same points, million points a second."""
import sys
import time

import numpy as np
from scipy.interpolate import BSpline

folder, k, count = sys.argv[1], 3, 20_000
t = np.array([0, 0, 0, 0, 1, 2, 3, 4, 5, 5, 5, 5], float)
x = np.random.default_rng(0).uniform(0, 5, count)
x.tofile(f"{folder}/points")
matrix = BSpline.design_matrix(x, t, k)
matrix.data.reshape(count, k + 1).tofile(f"{folder}/values")
spline = BSpline(t, np.array([1, -2, 3, -4, 5, -6, 7, -8], float), k)


def rate(name, run):
    best = float("inf")
    for _ in range(150):
        start = time.perf_counter()
        run()
        best = min(best, time.perf_counter() - start)
    print(f"{name:<40}  {count / best / 1e6:8.1f}", flush=True)


rate("SciPy design_matrix", lambda: BSpline.design_matrix(x, t, k))
rate("SciPy BSpline.__call__", lambda: spline(x))
