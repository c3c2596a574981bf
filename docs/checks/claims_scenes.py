"""Queries on which the claims are tested: made here, by numpy's generators, and by no family of the project.

A scene has corners (3, n, 3), centres (n, 3) and the number of each query's triangle, which queries on one mesh share; one third of the feet lie inside
the triangle, one third on an edge, one third at a vertex. `sample` rounds the coordinates to binary32 (or to fewer bits) and then sets the radius: the
distance of the rounded numbers times 1 + g. g is uniform within 4 roundings of a vertex as seen from the centre; in `coarse` scenes, of a vertex in the
world, which is more where the scene is far from the origin; in `broad` ones g is within 1/16 at any number of bits. So the number of wrong signs is in
proportion to how far a form is off.
"""
import zlib
from dataclasses import dataclass

import numpy as np


def unit(v):
    return v / np.linalg.norm(v, axis=-1, keepdims=True)


def inner(u, v):
    return np.sum(u * v, axis=-1, keepdims=True)


def directions(rng, n):
    return unit(rng.normal(size=(n, 3)))


def powers(rng, n, low, high):
    """2 to a uniform power."""
    return np.exp2(rng.uniform(low, high, size=(n, 1)))


def triangles(rng, n, size=1.0):
    """Three points of a ball each; those whose height is less than a tenth of their longest edge are taken again."""
    points = rng.uniform(-1, 1, size=(3, n, 3))
    while True:
        normal = np.linalg.norm(np.cross(points[1] - points[0], points[2] - points[0]), axis=1)
        longest = np.max([np.linalg.norm(points[i] - points[i - 1], axis=1) for i in range(3)], axis=0)
        thin = normal < 0.1 * longest ** 2
        if not thin.any():
            return points * size
        points[:, thin] = rng.uniform(-1, 1, size=(3, thin.sum(), 3))


def slivers(rng, n, low, high):
    """One vertex at 2^low to 2^high of the longest edge from it; which vertex is drawn."""
    a, along = rng.uniform(-1, 1, size=(n, 3)), directions(rng, n)
    up = unit(np.cross(along, directions(rng, n)))
    c = a + along * rng.uniform(-0.2, 1.2, size=(n, 1)) + up * powers(rng, n, low, high)
    turned = np.stack([a, a + along, c])
    turn = rng.integers(0, 3, size=n)
    return np.stack([turned[(i + turn) % 3, np.arange(n)] for i in range(3)])


def centres(rng, corners, distance):
    """A point at `distance` from each triangle, its foot inside, on an edge or at a vertex."""
    n = corners.shape[1]
    turn = rng.integers(0, 3, size=n)
    a, b, c = (corners[(i + turn) % 3, np.arange(n)] for i in range(3))
    normal = unit(np.cross(b - a, c - a))
    out_ab, out_ca = unit(np.cross(b - a, normal)), unit(np.cross(a - c, normal))
    weights = rng.dirichlet((1, 1, 1), size=n)
    s, t = rng.uniform(0, 1, size=(n, 1)), rng.normal(size=(n, 1))
    side = rng.choice((-1.0, 1.0), size=(n, 1))
    feature = rng.integers(0, 3, size=(n, 1))
    foot = np.where(feature == 0, weights[:, :1] * a + weights[:, 1:2] * b + weights[:, 2:] * c, np.where(feature == 1, a + s * (b - a), a))
    away = np.where(feature == 0, side * normal, np.where(feature == 1, out_ab + t * normal, s * out_ab + (1 - s) * out_ca + t * normal))
    return foot + unit(away) * distance


def distances(corners, p):
    """From p to the triangles, in binary64."""
    best = np.full(p.shape[0], np.inf)
    for i in range(3):
        u, w = corners[i], corners[(i + 1) % 3]
        length = inner(w - u, w - u)
        t = np.clip(inner(p - u, w - u) / np.where(length > 0, length, 1), 0, 1)
        best = np.minimum(best, np.linalg.norm(p - (u + t * (w - u)), axis=1))
    a, b, c = corners
    normal = np.cross(b - a, c - a)
    inside = np.ones(p.shape[0], dtype=bool)
    for u, w in ((a, b), (b, c), (c, a)):
        inside &= inner(np.cross(w - u, normal), p - u)[:, 0] <= 0
    height = np.abs(inner(normal, p - a)[:, 0]) / np.maximum(np.linalg.norm(normal, axis=1), 1e-300)
    return np.where(inside & (np.linalg.norm(normal, axis=1) > 0), np.minimum(best, height), best)


@dataclass
class Scene:
    corners: np.ndarray           # 3 by n by 3
    p: np.ndarray                 # n by 3
    triangle: np.ndarray = None   # of each query; None: each has its own
    steps: np.ndarray = None      # of the radius, in binary32, from the distance; None: within ROUNDINGS


# ---- The distributions.

def grazing(rng, n):
    """Ordinary triangles of size 1 about the origin, spheres of a quarter to 4 that graze them."""
    corners = triangles(rng, n)
    return Scene(corners, centres(rng, corners, powers(rng, n, -2, 2)))


def near(rng, n):
    """The centre 2^-12 to 2^-4 from a triangle of size 1, the sphere as small."""
    corners = triangles(rng, n)
    return Scene(corners, centres(rng, corners, powers(rng, n, -12, -4)))


def sliver(rng, n):
    """Triangles whose height is 2^-14 to 2^-4 of their length, spheres of a quarter to 2."""
    corners = slivers(rng, n, -14, -4)
    return Scene(corners, centres(rng, corners, powers(rng, n, -2, 1)))


def speck(rng, n):
    """Triangles 2^-10 to 2^-4 the size of the sphere that grazes them."""
    size = powers(rng, n, -10, -4)
    corners = triangles(rng, n) * size + directions(rng, n)
    return Scene(corners, centres(rng, corners, powers(rng, n, -0.5, 0.5)))


def origin(rng, n):
    """Grazing spheres whose centre is the origin, so that A - P rounds nothing."""
    corners = triangles(rng, n)
    p = centres(rng, corners, powers(rng, n, -2, 2))
    return Scene(corners - p, np.zeros_like(p))


def offset_by(low, high):
    def far(rng, n):
        corners = triangles(rng, n)
        p = centres(rng, corners, powers(rng, n, -2, 2))
        away = directions(rng, n) * powers(rng, n, low, high)
        return Scene(corners + away, p + away)
    far.__doc__ = f"As grazing, moved by 2^{low} to 2^{high}."
    return far


def terrain(rng, n):
    """A height field of 96 by 96 cells of 1, sums of waves, its corner at (500, 0, 300); spheres of 0.3 to 1.2 graze it."""
    cells = 96
    x, z = np.meshgrid(np.arange(cells + 1.0), np.arange(cells + 1.0), indexing="ij")
    height = np.zeros_like(x)
    for _ in range(24):
        wave, phase = rng.normal(size=2) * rng.choice((0.1, 0.3, 1.0)), rng.uniform(0, 2 * np.pi)
        height += 0.4 / np.linalg.norm(wave) ** 0.8 * np.sin(wave[0] * x + wave[1] * z + phase)
    points = np.stack([x + 500, height + 40, z + 300], axis=-1)
    triangle = rng.integers(0, 2 * cells * cells, size=n)
    i, j, upper = triangle // 2 // cells, triangle // 2 % cells, triangle % 2 == 1
    corners = np.stack([points[i, j], points[i + 1, j + 1], np.where(upper[:, None], points[i + 1, j], points[i, j + 1])])
    return Scene(corners, centres(rng, corners, rng.uniform(0.3, 1.2, size=(n, 1))), triangle)


def level(rng, n):
    """Boxes and floors whose corners are whole quarters within 64 of the origin; spheres over their faces, at grid heights, that touch or miss by a step of r."""
    count = 2048
    least, size = rng.integers(-256, 256, size=(count, 3)), rng.integers(1, 33, size=(count, 3))
    triangle = rng.integers(0, count, size=n)
    axis, upper = rng.integers(0, 3, size=n), rng.integers(0, 2, size=n)
    low, extent = least[triangle], size[triangle]
    rows = np.arange(n)
    u, v = (axis + 1) % 3, (axis + 2) % 3
    base = low.astype(np.float64).copy()
    base[rows, axis] += extent[rows, axis] * rng.integers(0, 2, size=n)
    b, c, d = base.copy(), base.copy(), base.copy()
    b[rows, u] += extent[rows, u]
    c[rows, v] += extent[rows, v]
    d[rows, u], d[rows, v] = b[rows, u], c[rows, v]
    corners = np.stack([np.where(upper[:, None] == 1, d, base), b, c]) / 4
    p = base.copy()
    p[rows, u] += rng.integers(-8, 41, size=n)
    p[rows, v] += rng.integers(-8, 41, size=n)
    p[rows, axis] += rng.choice((-1, 1), size=n) * rng.integers(1, 17, size=n)
    p = p / 4 + (rng.integers(0, 2, size=(n, 1)) == 1) * rng.choice((0.1, 0.3, 0.7), size=(n, 1))
    return Scene(corners, p, triangle, rng.integers(-2, 3, size=n))


ROUNDINGS = 4
SCENES = {f.__name__: f for f in (grazing, near, sliver, speck, origin, terrain, level)}
SCENES |= {"far": offset_by(8, 20)} | {f"far-{k}": offset_by(k, k) for k in range(21)}


def rounded(values, bits):
    """To nearest, ties to even, with the exponents of binary64."""
    fraction, exponent = np.frexp(values)
    return np.ldexp(np.rint(np.ldexp(fraction, bits)), exponent - bits)


def sample(name, seed, n, bits=24):
    """n queries of a scene, `NAME[ coarse| broad][ times 2^K]`: 13 rows of binary32 numbers (A, B, C, P, r) of at most `bits` bits, and their triangles."""
    scene_name, _, power = name.partition(" times 2^")
    scene_name, _, radii = scene_name.partition(" ")
    rng = np.random.default_rng([seed, zlib.crc32(name.encode()), bits])
    scene = SCENES[scene_name](rng, n)
    corners, p = rounded(scene.corners, bits), rounded(scene.p, bits)
    distance = distances(corners, p)
    if scene.steps is not None:
        factor = 1 + scene.steps * 2.0 ** -bits
    else:
        coordinate = np.abs(np.concatenate([corners, p[None]]) if radii == "coarse" else corners - p).max(axis=(0, 2))
        width = 1 / 16 if radii == "broad" else ROUNDINGS * 2.0 ** -bits * coordinate / distance
        factor = 1 + rng.uniform(-1, 1, size=n) * np.minimum(width, 0.25)
    r = rounded(distance * factor, bits)
    columns = np.concatenate([corners[0].T, corners[1].T, corners[2].T, p.T, r[None]])
    return np.ldexp(columns, int(power or 0)).astype(np.float32), np.arange(n) if scene.triangle is None else scene.triangle
