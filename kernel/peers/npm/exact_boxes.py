"""Two boxes, and a box and a triangle, exactly, in rationals: by the normals of facets and the products of edges as the numbers give them,
which are enough where the axes of a box are a basis; and the distance, which is that of a vertex and a facet or of two edges."""
from fractions import Fraction
from itertools import product
from math import isqrt

from exact import cross, dot, minus, squared_distance, to_segment


def plus(u, v):
    return [x + y for x, y in zip(u, v)]


def times(k, v):
    return [k * x for x in v]


class Box:
    """Centre, three basis vectors and half extents, which may be 0; whatever the basis, the body of all m + sum t_k s_k b_k, |t_k| <= 1."""

    def __init__(self, m, s, b):
        self.m, self.s, self.b = m, s, b
        self.halves = [times(k, v) for k, v in zip(s, b)]

    normals = property(lambda self: [cross(self.b[1], self.b[2]), cross(self.b[2], self.b[0]), cross(self.b[0], self.b[1])])
    edges = property(lambda self: self.b)

    def vertices(self):
        return [plus(self.m, plus(times(i, self.halves[0]), plus(times(j, self.halves[1]), times(k, self.halves[2]))))
                for i, j, k in product((-1, 1), repeat=3)]

    def sides(self):
        """The edges as pairs of points."""
        v = self.vertices()
        return [(v[i], v[i | bit]) for bit in (1, 2, 4) for i in range(8) if not i & bit]

    def facets(self):
        """As triangles, two a facet."""
        v = self.vertices()
        for one, two, three in ((1, 2, 4), (1, 4, 2), (2, 4, 1)):
            for at in (0, three):
                yield v[at], v[at | one], v[at | one | two]
                yield v[at], v[at | two], v[at | one | two]


class Triangle:
    """Three points, which may be equal or on a line; the products of sides of length 0 are no axes."""

    def __init__(self, *corners):
        self.corners = list(corners)

    edges = property(lambda self: [minus(v, u) for u, v in self.sides()])
    normals = property(lambda self: [cross(self.edges[0], self.edges[1])])

    def vertices(self):
        return self.corners

    def sides(self):
        a, b, c = self.corners
        return [(a, b), (b, c), (c, a)]

    def facets(self):
        yield tuple(self.corners)


def rotation(w, x, y, z):
    """The columns of the rotation by a quaternion of any length other than 0."""
    n = w * w + x * x + y * y + z * z
    rows = [[w * w + x * x - y * y - z * z, 2 * (x * y - w * z), 2 * (x * z + w * y)],
            [2 * (x * y + w * z), w * w - x * x + y * y - z * z, 2 * (y * z - w * x)],
            [2 * (x * z - w * y), 2 * (y * z + w * x), w * w - x * x - y * y + z * z]]
    return [[rows[i][k] / n for i in range(3)] for k in range(3)]


UNIT = [[Fraction(i == k) for i in range(3)] for k in range(3)]


def box_of(v, entry):
    """The box that a query's numbers begin with, and the other numbers."""
    if entry == "minmax":
        low, high = v[0:3], v[3:6]
        return Box([(x + y) / 2 for x, y in zip(low, high)], [(y - x) / 2 for x, y in zip(low, high)], UNIT), v[6:]
    if entry == "centre":
        return Box(v[0:3], v[3:6], UNIT), v[6:]
    if entry == "matrix":
        return Box(v[0:3], v[3:6], [v[6:9], v[9:12], v[12:15]]), v[15:]
    return Box(v[0:3], v[3:6], rotation(*v[6:10])), v[10:]


def bodies(numbers, question):
    predicate, entry = question.split("/")
    first, rest = box_of([Fraction(x) for x in numbers], entry)
    return (first, box_of(rest, entry)[0] if predicate == "box-box" else Triangle(rest[0:3], rest[3:6], rest[6:9]))


def between_segments(p, q):
    """The squared distance of two segments: at ends, or where both are crossed by the line at right angles to both."""
    least = min(to_segment(p[0], *q), to_segment(p[1], *q), to_segment(q[0], *p), to_segment(q[1], *p))
    u, v, w = minus(p[1], p[0]), minus(q[1], q[0]), minus(p[0], q[0])
    n = cross(u, v)
    if any(n):
        whole = dot(n, n)
        s, t = dot(cross(v, w), n) / whole, dot(cross(u, w), n) / whole
        if 0 <= s <= 1 and 0 <= t <= 1:
            least = min(least, dot(w, n) ** 2 / whole)
    return least


def squared_gap(first, second):
    """The squared distance of two bodies that are apart."""
    least = min(between_segments(p, q) for p in first.sides() for q in second.sides())
    for solid, other in ((first, second), (second, first)):
        for facet in solid.facets():
            for point in other.vertices():
                least = min(least, squared_distance([*facet[0], *facet[1], *facet[2], *point]))
    return least


def gap_along(axis, first, second):
    """How far the two are apart along an axis, times its length; negative where they overlap."""
    one, two = ([dot(axis, v) for v in body.vertices()] for body in (first, second))
    return max(min(two) - max(one), min(one) - max(two))


def truth(numbers, question):
    """(verdict, whether they touch, the square of the penetration or of the distance)."""
    first, second = bodies(numbers, question)
    axes = first.normals + second.normals + [cross(u, v) for u in first.edges for v in second.edges]
    gaps = [(gap_along(axis, first, second), dot(axis, axis)) for axis in axes if any(axis)]
    if any(gap > 0 for gap, _ in gaps):
        return "separated", False, squared_gap(first, second)
    least = min(gap * gap / squared for gap, squared in gaps)
    return "contact", least == 0, least


def root(squared):
    """The square root to about 60 bits, rounded down."""
    scale = 1 << 200
    return Fraction(isqrt(squared.numerator * scale * scale // squared.denominator), scale)
