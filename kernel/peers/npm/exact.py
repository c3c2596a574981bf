"""The point of a closed triangle that is nearest to another point, exactly, in rationals: of the four candidates (the face, where the foot of
the perpendicular is in it, and the three edges) the nearest. Any triangle, those without area too."""
from fractions import Fraction


def dot(u, v):
    return sum(x * y for x, y in zip(u, v))


def minus(u, v):
    return [x - y for x, y in zip(u, v)]


def cross(u, v):
    return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def from_segment(p, a, b):
    """From the segment's nearest point to p."""
    edge, off = minus(b, a), minus(p, a)
    whole = dot(edge, edge)
    t = min(max(dot(edge, off) / whole, Fraction(0)), Fraction(1)) if whole else Fraction(0)
    return [x - t * y for x, y in zip(off, edge)]


def to_segment(p, a, b):
    """The squared distance."""
    way = from_segment(p, a, b)
    return dot(way, way)


def away(numbers):
    """From the triangle's nearest point to the centre: numbers are ax ay az bx by bz cx cy cz px py pz and what follows them."""
    v = [Fraction(x) for x in numbers]
    a, b, c, p = v[0:3], v[3:6], v[6:9], v[9:12]
    ways = [from_segment(p, a, b), from_segment(p, b, c), from_segment(p, c, a)]
    n = cross(minus(b, a), minus(c, a))
    if any(n) and all(dot(cross(minus(w, u), minus(p, u)), n) >= 0 for u, w in ((a, b), (b, c), (c, a))):
        ways.append([dot(n, minus(p, a)) / dot(n, n) * x for x in n])
    return min(ways, key=lambda way: dot(way, way))


def squared_distance(numbers):
    """That of the centre from the triangle."""
    way = away(numbers)
    return dot(way, way)


def verdict(numbers):
    """(verdict, whether they touch) of a query of sphere-triangle."""
    squared, radius = squared_distance(numbers), Fraction(numbers[12])
    return "contact" if squared <= radius * radius else "separated", squared == radius * radius
