"""What each predicate asks, from its definition, over the rationals: shares no formula and no file with the program.

    truth(predicate, entry, numbers) -> ("contact" | "separated" | "invalid", touching)

`numbers` are the floats of a query in the order of the entry's columns, taken as exact. A new predicate needs a line in PREDICATES.
"""
import math
from fractions import Fraction


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def times(t, a):
    return tuple(t * x for x in a)


def dot(a, b):
    return sum(x * y for x, y in zip(a, b))


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def vectors(numbers):
    return [tuple(numbers[k:k + 3]) for k in range(0, len(numbers), 3)]


def whole(*groups):
    """The same vectors in another unit of length, in which all numbers are integers."""
    unit = math.lcm(*(Fraction(x).denominator for group in groups for vector in group for x in vector))
    return [[tuple(int(x * unit) for x in vector) for vector in group] for group in groups]


# Squared distances. A segment is two points and a triangle three; any of them may be equal.
def from_segment(p, a, b):
    along, to = minus(b, a), minus(p, a)
    square = dot(along, along)
    t = min(max(Fraction(dot(to, along), square), 0), 1) if square else 0
    off = minus(to, times(t, along))
    return dot(off, off)


def is_over(p, triangle):
    """Whether the triangle has an area, and p is in the prism that stands on it, its sides included."""
    a, b, c = triangle
    normal = cross(minus(b, a), minus(c, a))
    return any(normal) and all(dot(cross(normal, minus(end, start)), minus(p, start)) >= 0 for start, end in ((a, b), (b, c), (c, a)))


def from_triangle(p, triangle):
    a, b, c = triangle
    if is_over(p, triangle):
        normal = cross(minus(b, a), minus(c, a))
        return Fraction(dot(normal, minus(p, a)) ** 2, dot(normal, normal))
    return min(from_segment(p, a, b), from_segment(p, b, c), from_segment(p, c, a))


def between_segments(p, q, a, b):
    least = min(from_segment(p, a, b), from_segment(q, a, b), from_segment(a, p, q), from_segment(b, p, q))
    u, v, w = minus(q, p), minus(b, a), minus(a, p)
    n = cross(u, v)
    square = dot(n, n)
    if square:  # the nearest points of the two lines, if both segments have them
        s, t = dot(cross(w, v), n), dot(cross(w, u), n)
        if 0 <= s <= square and 0 <= t <= square:
            least = min(least, Fraction(dot(w, n) ** 2, square))
    return least


def segment_from_triangle(p, q, triangle):
    a, b, c = triangle
    normal = cross(minus(b, a), minus(c, a))
    before, after = dot(normal, minus(p, a)), dot(normal, minus(q, a))
    if before * after < 0 and is_over(plus(times(Fraction(after, after - before), p), times(Fraction(before, before - after), q)), triangle):
        return 0
    ends = min(from_triangle(p, triangle), from_triangle(q, triangle))
    return min(ends, *(between_segments(p, q, start, end) for start, end in ((a, b), (b, c), (c, a))))


def of_hulls(a, edges_a, b, edges_b):
    """Whether two convex hulls meet, given by points and the directions of their edges. a - b is a polytope whose facets are spanned by two
    of these; where it is flat the axes in its plane, or along its line, are asked too. They touch where a small translation parts them."""
    a, b, edges_a, edges_b = whole(a, b, edges_a, edges_b)
    edges = [edge for edge in edges_a + edges_b if any(edge)]
    axes = {cross(u, v) for u in edges for v in edges} - {(0, 0, 0)}
    is_flat = all(dot(axis, edge) == 0 for axis in axes for edge in edges)
    if is_flat and axes:
        normal = next(iter(axes))
        axes |= {cross(normal, edge) for edge in edges}
    elif is_flat:
        apart = minus(a[0], b[0])
        line = edges[0] if edges else (0, 0, 0)
        axes = {line, minus(times(dot(line, line), apart), times(dot(line, apart), line)) if edges else apart}
    gaps = [max(min(of_a) - max(of_b), min(of_b) - max(of_a))
            for axis in axes if any(axis) for of_a, of_b in [([dot(axis, p) for p in a], [dot(axis, p) for p in b])]]
    if any(gap > 0 for gap in gaps):
        return "separated", False
    return "contact", is_flat or 0 in gaps


def closed(squared_distance, r):
    return ("separated" if squared_distance > r * r else "contact"), squared_distance == r * r


def sphere_triangle(numbers, entry):
    *triangle, p, (r, *_) = vectors(numbers)
    if r < 0:
        return "invalid", False
    triangle, [p, (r, *_)] = whole(triangle, [p, (r,)])
    return closed(from_triangle(p, triangle), r)


def moving_sphere(numbers, entry):
    *triangle, p, end, (r, *_) = vectors(numbers)
    if r < 0:
        return "invalid", False
    triangle, [p, q, (r, *_)] = whole(triangle, [p, plus(p, end) if entry == "displacement" else end, (r,)])
    if r == 0:  # a point that crosses the inside of the face does not touch
        a, b, c = triangle
        return of_hulls([p, q], [minus(q, p)], triangle, [minus(b, a), minus(c, b), minus(a, c)])
    return closed(segment_from_triangle(p, q, triangle), r)


def capsule_triangle(numbers, entry):
    return moving_sphere(numbers, "endpoints")


def box(centre, half, axes):
    """The corners of a box and its edges; empty if there is no such box."""
    if min(half) < 0 or dot(axes[0], cross(axes[1], axes[2])) == 0:
        return None
    edges = [times(s, axis) for s, axis in zip(half, axes)]
    corners = [centre]
    for edge in edges:
        corners = [moved for corner in corners for moved in (plus(corner, edge), minus(corner, edge))]
    return corners, edges


UPRIGHT = [(1, 0, 0), (0, 1, 0), (0, 0, 1)]


def turned(w, x, y, z):
    """The axes that the quaternion turns the upright ones into, whatever its length; dependent ones if it is 0."""
    n = w * w + x * x + y * y + z * z or 1
    v = (x, y, z)
    return [times(Fraction(1) / n, plus(plus(times(w * w - dot(v, v), e), times(2 * dot(v, e), v)), times(2 * w, cross(v, e)))) for e in UPRIGHT]


def upright_box(low, high):
    return box(times(Fraction(1, 2), plus(low, high)), times(Fraction(1, 2), minus(high, low)), UPRIGHT)


def box_box(numbers, entry):
    half = 6 if entry.startswith("minmax") else len(numbers) // 2
    both = []
    for own in (numbers[:half], numbers[half:]):
        if len(own) == 6:
            both.append(upright_box(*vectors(own)))
        else:
            both.append(box(tuple(own[:3]), own[3:6], vectors(own[6:]) if entry == "matrix" else turned(*own[6:])))
    return of_hulls(*both[0], *both[1]) if all(both) else ("invalid", False)


def box_triangle(numbers, entry):
    first, second, *more = vectors(numbers[:-9])
    a, b, c = vectors(numbers[-9:])
    if entry == "minmax":
        own = upright_box(first, second)
    else:
        own = box(first, second, more if entry == "matrix" else turned(*numbers[6:10]) if entry == "quaternion" else UPRIGHT)
    return of_hulls(*own, [a, b, c], [minus(b, a), minus(c, b), minus(a, c)]) if own else ("invalid", False)


def point_box(numbers, entry):
    p, low, high = vectors(numbers)
    if any(l > h for l, h in zip(low, high)):
        return "invalid", False
    if any(x < l or x > h for x, l, h in zip(p, low, high)):
        return "separated", False
    return "contact", any(x in (l, h) for x, l, h in zip(p, low, high))


PREDICATES = {"sphere-triangle": sphere_triangle, "moving-sphere": moving_sphere, "box-box": box_box, "box-triangle": box_triangle,
              "capsule-triangle": capsule_triangle, "point-box": point_box}


def truth(predicate, entry, numbers):
    if not all(map(math.isfinite, numbers)):
        return "invalid", False
    return PREDICATES[predicate](list(map(Fraction, numbers)), entry)
