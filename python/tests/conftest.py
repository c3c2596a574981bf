"""What the tests of the package share: the command beside it, and kernels that are written in NumPy."""
import os
import signal
import subprocess

import numpy as np
import pytest

import axiscert as ax

# A shell's background job ignores Ctrl-C, and so would the processes that tests interrupt.
signal.signal(signal.SIGINT, signal.default_int_handler)

# Of ./dev python --sanitized: for processes that import the package, not for those of the command and of supervised functions, whose memory
# is limited.
PRELOADED = {name: os.environ.pop(name) for name in ("LD_PRELOAD",) if name in os.environ}
BIN = os.path.join(os.path.dirname(ax.__file__), "bin")


@pytest.fixture(scope="session")
def command():
    """Runs the command, and returns what it printed; `code` is its exit status, None of a run that may be met or not."""
    environment = dict(os.environ, PATH=os.pathsep.join(["/usr/bin", os.environ["PATH"]]))  # Debian's python3, which has numpy

    def run(*words, code=0, cwd=None):
        ended = subprocess.run([os.path.join(BIN, "axiscert"), *map(str, words)], capture_output=True, text=True, cwd=cwd, env=environment)
        assert ended.returncode in ((0, 1) if code is None else (code,)), ended.stderr
        return ended.stdout
    return run


def squared_distance(a, b, c, p):
    """Of a point and a triangle by its regions, in NumPy, with a usual slip: an edge that is left out."""
    ab, ac, ap = b - a, c - a, p - a
    dot = lambda u, v: (u * v).sum(axis=1)
    with np.errstate(all="ignore"):
        d1, d2 = dot(ab, ap), dot(ac, ap)
        bp, cp = p - b, p - c
        d3, d4, d5, d6 = dot(ab, bp), dot(ac, bp), dot(ab, cp), dot(ac, cp)
        va, vb, vc = d3 * d6 - d5 * d4, d5 * d2 - d1 * d6, d1 * d4 - d3 * d2
        denominator = va + vb + vc
        point = a + ab * (vb / denominator)[:, None] + ac * (vc / denominator)[:, None]
        t = d2 / (d2 - d6)
        point = np.where(((vb <= 0) & (d2 >= 0) & (d6 <= 0))[:, None], a + ac * t[:, None], point)
        t = d1 / (d1 - d3)
        point = np.where(((vc <= 0) & (d1 >= 0) & (d3 <= 0))[:, None], a + ab * t[:, None], point)
        point = np.where(((d6 >= 0) & (d5 <= d6))[:, None], c, point)
        point = np.where(((d3 >= 0) & (d4 <= d3))[:, None], b, point)
        point = np.where(((d1 <= 0) & (d2 <= 0))[:, None], a, point)
        away = p - point
        return dot(away, away)


def nearest_point_test(a, b, c, p, r):
    """A usual kernel."""
    with np.errstate(all="ignore"):
        return squared_distance(a, b, c, p) <= r * r
