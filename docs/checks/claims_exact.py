"""Exact answers to binary32 queries, in Python's integers.

All numbers of a query are multiples of one power of two; divided by it they are integers, and no sign changes. Arrays of integers (dtype object) go
through the same straight-line arithmetic as any other array. `by_fractions` answers one query at a time with fractions, for the test of this file.
"""
from fractions import Fraction

import numpy as np

from claims_forms import Vector, cross, dot


def integers(columns):
    """The 13 numbers of each query, as integers in the query's own unit: object arrays, in the same order."""
    fraction, exponent = np.frexp(np.asarray(columns, dtype=np.float64))
    mantissa = np.ldexp(fraction, 24).astype(np.int64)
    assert np.array_equal(np.ldexp(mantissa.astype(np.float64), exponent - 24), columns), "numbers of more than 24 bits"
    least = np.where(mantissa == 0, np.iinfo(np.int32).max, exponent).min(axis=0)
    shift = np.where(mantissa == 0, 0, exponent - least)
    powers = np.array([1 << k for k in range(int(shift.max()) + 1)], dtype=object)
    return mantissa.astype(object) * powers[shift]


def sign(x):
    return (x > 0).astype(np.int8) - (x < 0).astype(np.int8)


def vectors(columns):
    """A - P, B - P, C - P and r."""
    ax, ay, az, bx, by, bz, cx, cy, cz, px, py, pz, r = columns
    return Vector(ax - px, ay - py, az - pz), Vector(bx - px, by - py, bz - pz), Vector(cx - px, cy - py, cz - pz), r


def comparison_signs(columns):
    """The sign of left minus right of each of the sixteen comparisons, the same for every form: int8, 16 by n.

    0 is a tie. Where a form is undefined (0/0: A = B, or no area), the sides of the undivided forms are 0 and 0.
    """
    A, B, C, r = vectors(integers(columns))
    rr = r * r
    V = cross(B - A, C - A)
    d = dot(A, V)
    aa, bb, cc, ab, ac, bc = dot(A, A), dot(B, B), dot(C, C), dot(A, B), dot(A, C), dot(B, C)
    signs = [d * d - rr * dot(V, V), aa - rr, ab - aa, ac - aa, bb - rr, ab - bb, bc - bb, cc - rr, ac - cc, bc - cc]
    for U, W in ((A, B), (B, C), (C, A)):
        N, UW = cross(U, W), W - U
        signs += [dot(N, N) - rr * dot(UW, UW), -dot(N, V)]
    return np.array([sign(s) for s in signs])


def distance_sign(columns):
    """The sign of distance minus radius: -1 overlap, 0 touching (a contact too), 1 apart. By regions of the closest point, not by axes."""
    A, B, C, r = vectors(integers(columns))
    rr = r * r
    found = []
    inside = True
    n = cross(B - A, C - A)
    for U, W in ((A, B), (B, C), (C, A)):
        UW = W - U
        t, e = -dot(U, UW), dot(UW, UW)  # the foot of the centre, 0, is at t / e of the way from U to W
        uu, ww = dot(U, U), dot(W, W)
        found.append(np.where(t <= 0, sign(uu - rr), np.where(t >= e, sign(ww - rr), sign(uu * e - t * t - rr * e))))
        inside = inside & (dot(cross(UW, n), U) >= 0)  # the centre is not beyond the edge: UW x n points out of the triangle
    nn, d = dot(n, n), dot(A, n)
    found.append(np.where(inside.astype(bool) & (nn > 0), sign(d * d - rr * nn), 1))
    return np.min(found, axis=0)


def by_fractions(numbers):
    """distance_sign of one query, by minimising over the triangle with fractions: for tests."""
    values = [Fraction(float(x)) for x in numbers]
    a, b, c, p, r = values[0:3], values[3:6], values[6:9], values[9:12], values[12]

    def minus(u, v): return [x - y for x, y in zip(u, v)]
    def product(u, v): return sum(x * y for x, y in zip(u, v))

    def to_segment(u, w):
        along, to_p = minus(w, u), minus(p, u)
        length = product(along, along)
        t = min(max(product(to_p, along) / length, 0), 1) if length else 0
        rest = [x - t * y for x, y in zip(to_p, along)]
        return product(rest, rest)

    least = min(to_segment(a, b), to_segment(b, c), to_segment(c, a))
    # Barycentric coordinates of the foot on the plane, by the two normal equations.
    u, v, w = minus(b, a), minus(c, a), minus(p, a)
    uu, uv, vv, uw, vw = product(u, u), product(u, v), product(v, v), product(u, w), product(v, w)
    area = uu * vv - uv * uv
    if area:
        s, t = (vv * uw - uv * vw) / area, (uu * vw - uv * uw) / area
        if s >= 0 and t >= 0 and s + t <= 1:
            rest = [x - s * y - t * z for x, y, z in zip(w, u, v)]
            least = min(least, product(rest, rest))
    return (least > r * r) - (least < r * r)
