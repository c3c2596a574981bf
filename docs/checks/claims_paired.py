"""Two forms on the same queries: is the one wrong more often, and by how much.

Queries on one triangle are no independent witnesses: all sums are over triangles, each with the errors of both forms on it. No more than integers,
fractions and one quantile of the normal distribution.
"""
from fractions import Fraction
from math import comb
from statistics import NormalDist

import numpy as np

NORMAL = NormalDist()


def by_triangle(errors, triangle):
    """The sum of the errors on each triangle, in the order of the triangles' numbers."""
    _, place = np.unique(triangle, return_inverse=True)
    return np.bincount(place, weights=errors)


def sign_test(more, fewer):
    """McNemar's exact test, a vote for each triangle: the probability, were both forms alike, that so many of the triangles on which they differ would
    be on one side. Two-sided."""
    n, least = more + fewer, min(more, fewer)
    tail = sum(comb(n, k) for k in range(least + 1)) if n < 3000 else None
    if tail is not None:
        return float(min(Fraction(1), Fraction(2 * tail, 2 ** n)))
    # Beyond: the tail is at most its greatest term times a geometric series.
    ratio = Fraction(least, n - least + 1)
    return float(min(Fraction(1), 2 * Fraction(comb(n, least), 2 ** n) / (1 - ratio))) if ratio < 1 else 1.0


class Ratio:
    """Errors of `ours` over errors of `theirs`; arrays by triangle, of the same triangles, or with paired=False of two samples."""

    def __init__(self, ours, theirs, paired=True):
        self.ours, self.theirs, self.paired = ours, theirs, paired
        self.total = (int(ours.sum()), int(theirs.sum()))
        self.triangles = min(len(ours), len(theirs))
        # Variances and covariance of the sums.
        def spread(x, y): return len(x) / (len(x) - 1) * float(((x - x.mean()) * (y - y.mean())).sum())
        self.var = (spread(ours, ours), spread(theirs, theirs), spread(ours, theirs) if paired else 0.0)
        if paired:
            self.more, self.fewer = int((ours > theirs).sum()), int((ours < theirs).sum())

    def value(self):
        return self.total[0] / self.total[1] if self.total[1] else float("inf")

    def z(self, rho):
        """How many standard deviations ours lies above rho times theirs (Fieller)."""
        variance = self.var[0] + rho * rho * self.var[1] - 2 * rho * self.var[2]
        difference = self.total[0] - rho * self.total[1]
        return difference / variance ** 0.5 if variance > 0 else (0.0 if difference == 0 else float("inf") * difference)

    def p_above(self, rho):
        """Of a ratio that is rho or less: the probability of one as great as this. Few triangles prove nothing by a normal law: 1 below 25."""
        return NORMAL.cdf(-self.z(rho)) if self.enough() else 1.0

    def p_below(self, rho):
        return NORMAL.cdf(self.z(rho)) if self.enough() else 1.0

    def enough(self):
        return int(((self.ours != 0) | (self.theirs != 0)).sum() if self.paired else min((self.ours != 0).sum(), (self.theirs != 0).sum())) >= 25

    def interval(self, level):
        """The ratios that a two-sided test at `level` does not refuse: (least, most); most is infinite where theirs may be 0."""
        limit = -NORMAL.inv_cdf(level / 2)
        return self.edge(lambda rho: self.z(rho) <= limit, 0.0), self.edge(lambda rho: self.z(rho) < -limit, float("inf"))

    @staticmethod
    def edge(holds, never):
        """The least rho from which on `holds` is true, by bisection of 0 to 10^6."""
        low, high = 0.0, 1e6
        if holds(low):
            return low
        if not holds(high):
            return float("inf") if never else 0.0
        for _ in range(80):
            middle = (low + high) / 2
            low, high = (low, middle) if holds(middle) else (middle, high)
        return high

    def least_effect(self, level):
        """The ratio above 1 that a sample of this size and spread would show in nine tries of ten."""
        if not self.total[1]:
            return float("inf")
        return 1 + (NORMAL.inv_cdf(0.9) - NORMAL.inv_cdf(level)) * (self.var[0] + self.var[1] - 2 * self.var[2]) ** 0.5 / self.total[1]


def holm(p_values, level):
    """Which hypotheses are rejected, with at most `level` for any false rejection among all of them."""
    order = sorted(range(len(p_values)), key=lambda i: p_values[i])
    rejected = [False] * len(p_values)
    for step, i in enumerate(order):
        if p_values[i] > level / (len(p_values) - step):
            break
        rejected[i] = True
    return rejected
