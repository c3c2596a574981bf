"""Every form of the sphere-triangle test that docs/precision.md speaks of, over arrays, one rounding an operation.

Written from the article and from the mathematics; nothing here reads the project's formulae. A number is whatever has + - * /, abs, > and a root:
arrays of numpy.float32 (the processor's binary32), or Rounded, binary64 arrays that each operation rounds to fewer bits. Nothing is fused, and sums are
(x + y) + z. A comparison is an array of bool: the computed left side is greater than the computed right one. NaN is greater than nothing.
"""
import numpy as np

COMPARISONS = ("plane.radius", "vertex_a.radius", "vertex_a.side_b", "vertex_a.side_c", "vertex_b.radius", "vertex_b.side_a", "vertex_b.side_c",
               "vertex_c.radius", "vertex_c.side_a", "vertex_c.side_b", "edge_ab.radius", "edge_ab.side_c", "edge_bc.radius", "edge_bc.side_a",
               "edge_ca.radius", "edge_ca.side_b")
EDGES = slice(10, 16)
# The comparisons of each axis, all of which have to hold where it separates.
AXES = ((0,), (1, 2, 3), (4, 5, 6), (7, 8, 9), (10, 11), (12, 13), (14, 15))


class Rounded:
    """Binary64 numbers rounded to `bits` bits, to nearest, ties to even; exponents are those of binary64, so in effect unlimited.

    Rounding a binary64 result once more gives what one rounding would have given where bits <= 25 (2 bits + 2 <= 53), for + - * / and the root.
    """
    def __init__(self, values, bits):
        assert bits <= 25
        fraction, exponent = np.frexp(values)
        self.values, self.bits = np.ldexp(np.rint(np.ldexp(fraction, bits)), exponent - bits), bits

    def __add__(self, other): return Rounded(self.values + other.values, self.bits)
    def __sub__(self, other): return Rounded(self.values - other.values, self.bits)
    def __mul__(self, other): return Rounded(self.values * other.values, self.bits)
    def __truediv__(self, other): return Rounded(self.values / other.values, self.bits)
    def __abs__(self): return Rounded(np.abs(self.values), self.bits)
    def __gt__(self, other): return self.values > getattr(other, "values", other)
    def __lt__(self, other): return self.values < getattr(other, "values", other)
    def root(self): return Rounded(np.sqrt(self.values), self.bits)


def root(x):
    return x.root() if isinstance(x, Rounded) else np.sqrt(x)


class Vector:
    def __init__(self, x, y, z): self.x, self.y, self.z = x, y, z
    def __add__(self, v): return Vector(self.x + v.x, self.y + v.y, self.z + v.z)
    def __sub__(self, v): return Vector(self.x - v.x, self.y - v.y, self.z - v.z)
    def __mul__(self, s): return Vector(self.x * s, self.y * s, self.z * s)
    def __truediv__(self, s): return Vector(self.x / s, self.y / s, self.z / s)


def dot(u, v):
    return (u.x * v.x + u.y * v.y) + u.z * v.z


def cross(u, v):
    return Vector(u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x)


# ---- The plane of ABC, centred. Four forms of "farther than r".

def plane(form, A, B, C, r):
    V = cross(B - A, C - A)
    if form == "normalised":
        return [abs(dot(A, V / root(dot(V, V)))) > r]
    if form == "squared":
        d = dot(A, V) / root(dot(V, V))
        return [d * d > r * r]
    d, e = dot(A, V), dot(V, V)
    if form == "divided rooted":
        return [abs(d) / root(e) > r]
    if form == "multiplied rooted":
        return [abs(d) > r * root(e)]
    if form == "divided":
        return [(d * d) / e > r * r]
    return [d * d > (r * r) * e]  # multiplied


# ---- A vertex, centred: outside the sphere, and both others beyond the plane through it that faces the centre.

def vertex(form, A, B, C, r):
    aa = dot(A, A)
    if form == "rooted":
        return [root(aa) > r, dot(B - A, A) > 0, dot(C - A, A) > 0]
    return [aa > r * r, dot(A, B) > aa, dot(A, C) > aa]


# ---- An edge AB, C the other vertex: its line outside the sphere, and C beyond the plane along it. `world` and `centred` are (A, B, C, P).

def article_edge(form, world, centred, r):
    if form in ("centred", "distributed"):
        A, B, C = centred[:3]
        AB = B - A
        d, e = (dot(A, AB) if form == "centred" else dot(A, B) - dot(A, A)), dot(AB, AB)
        Q = A * e - AB * d
        return [dot(Q, Q) > ((r * r) * e) * e, dot(Q, C * e - Q) > 0]
    A, B, C, P = world
    AB = B - A
    d, e = dot(P - A, AB), dot(AB, AB)
    if form == "undivided":
        Q = A * e + AB * d
        QP = P * e - Q
        return [dot(QP, QP) > ((r * r) * e) * e, dot(QP, C * e - Q) < 0]
    Q = A + AB * (d / e)
    QP, QC = P - Q, C - Q
    if form == "scaled":
        QPe = QP * e
        return [dot(QPe, QPe) > ((r * r) * e) * e, dot(QPe, QC * e) < 0]
    far = root(dot(QP, QP)) > r if form == "rooted" else dot(QP, QP) > r * r
    return [far, dot(QP, QC) < 0]


def cell_edge(cell, world, centred, r, normals):
    """A cell of the factorial: (start, undivided or not, rooted or not, degree). One axis in all of its ways, each step a change of one of the four.

    Degree 6 finds the foot Q of the centre on AB, scaled by e = |AB|^2 where nothing is divided. Degree 4 takes N = (A - P) x (B - P), which in the
    world is A x B - P x AB: |Q - P| = |N| / |AB|, and (Q - P).(C - Q) has the sign of -N.V, V = AB x AC in the same coordinates.
    """
    start, division, roots, degree = cell
    A, B, C, P = world if start == "world" else centred
    AB = B - A
    e = dot(AB, AB)
    if degree != "6":
        along = AB if degree == "4 along" else B  # A x AB = A x B
        N = cross(A, along) - cross(P, AB) if start == "world" else cross(A, along)
        squared, beyond = dot(N, N), dot(N, normals[start]) < 0
        if division == "divided":
            squared = squared / e
    else:
        d = dot(P - A, AB) if start == "world" else dot(A, AB)
        if division == "divided":
            Q = A + AB * (d / e) if start == "world" else A - AB * (d / e)
            QC = C - Q
        else:
            Q = A * e + AB * d if start == "world" else A * e - AB * d
            QC = C * e - Q
        if start == "world":
            QP = (P if division == "divided" else P * e) - Q
            squared, beyond = dot(QP, QP), dot(QP, QC) < 0
        else:
            squared, beyond = dot(Q, Q), dot(Q, QC) > 0
    if division == "divided":
        return [root(squared) > r if roots == "rooted" else squared > r * r, beyond]
    if roots == "rooted":
        return [root(squared) > r * (e if degree == "6" else root(e)), beyond]
    rr = r * r
    return [squared > ((rr * e) * e if degree == "6" else rr * e), beyond]


# name: (plane, vertex, edge), in the article's order
LADDER = {
    "ladder-0": ("normalised", "rooted", "rooted"),
    "ladder-1": ("squared", "rooted", "rooted"),
    "ladder-2": ("divided", "rooted", "rooted"),
    "ladder-3": ("multiplied", "rooted", "rooted"),
    "ladder-4": ("multiplied", "distributed", "rooted"),
    "ladder-5": ("multiplied", "distributed", "squared"),
    "ladder-6": ("multiplied", "distributed", "scaled"),
    "ladder-7": ("multiplied", "distributed", "undivided"),
    "ladder-8": ("multiplied", "distributed", "centred"),
    "published": ("multiplied", "distributed", "distributed"),
}
CELLS = {f"edges-{start}-{division}-{roots}-{degree}": ("multiplied", "distributed", (start, division, roots, degree))
         for start in ("world", "centred") for division in ("divided", "multiplied") for roots in ("rooted", "squared") for degree in "64"}
CELLS |= {f"plane-{division}-rooted": (f"{division} rooted", "rooted", "rooted") for division in ("divided", "multiplied")}
# Cells that are rungs, by both names.
RUNG_OF_CELL = {"edges-world-divided-rooted-6": "ladder-4", "edges-world-divided-squared-6": "ladder-5",
                "edges-world-multiplied-squared-6": "ladder-7", "edges-centred-multiplied-squared-6": "ladder-8",
                "edges-centred-multiplied-squared-4": "reduced"}
FORMS = LADDER | CELLS | {"reduced": CELLS["edges-centred-multiplied-squared-4"],
                          "reduced-along": ("multiplied", "distributed", ("centred", "multiplied", "squared", "4 along"))}


def comparisons(name, columns, bits=24, emulated=False):
    """The sixteen comparisons of a form on queries (13 rows of binary32): 16 by n, bool. bits < 24 rounds the input first, then every operation.

    24 bits are the processor's binary32, with its exponents, unless `emulated`; fewer have those of binary64.
    """
    kind = (lambda row: row) if bits == 24 and not emulated else (lambda row: Rounded(row.astype(np.float64), bits))
    rows = [kind(row) for row in columns]
    A, B, C, P = (Vector(*rows[3 * i:3 * i + 3]) for i in range(4))
    r = rows[12]
    plane_form, vertex_form, edge_form = FORMS[name]
    with np.errstate(all="ignore"):
        world, centred = (A, B, C, P), (A - P, B - P, C - P, None)
        a, b, c, _ = centred
        normals = {"world": cross(B - A, C - A), "centred": cross(b - a, c - a)}

        def edge(i, j, k):
            ends = [[points[x] for x in (i, j, k, 3)] for points in (world, centred)]
            return cell_edge(edge_form, *ends, r, normals) if isinstance(edge_form, tuple) else article_edge(edge_form, *ends, r)
        return np.array([*plane(plane_form, a, b, c, r), *vertex(vertex_form, a, b, c, r), *vertex(vertex_form, b, a, c, r),
                         *vertex(vertex_form, c, a, b, r), *edge(0, 1, 2), *edge(1, 2, 0), *edge(2, 0, 1)])


def separated(held):
    """The verdict of the sixteen comparisons: some axis has all of its own."""
    return np.any([np.all(held[list(axis)], axis=0) for axis in AXES], axis=0)
