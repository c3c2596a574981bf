"""What is said beside the verdict of a sphere and a triangle: judged by `check`, and found again here by fractions and decimals that share
nothing with it."""
import json
import random
import struct
import subprocess
import unittest
from decimal import Decimal, getcontext
from fractions import Fraction

from command import Case, ROOT, axiscert

getcontext().prec = 60
SEED = 20
PARTS = ["vertex_a", "vertex_b", "vertex_c", "edge_ab", "edge_bc", "edge_ca", "face"]


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def sub(u, v): return [x - y for x, y in zip(u, v)]
def dot(u, v): return sum(x * y for x, y in zip(u, v))
def cross(u, v): return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]


def candidates(triangle, p):
    """{part: its point nearest to p} of the parts, without their rims, that p is over."""
    found = {PARTS[k]: corner for k, corner in enumerate(triangle)}
    for k in range(3):
        start, along = triangle[k], sub(triangle[(k + 1) % 3], triangle[k])
        whole, foot = dot(along, along), dot(sub(p, start), along)
        if 0 < foot < whole:
            found[PARTS[3 + k]] = [x + y * foot / whole for x, y in zip(start, along)]
    normal = cross(sub(triangle[1], triangle[0]), sub(triangle[2], triangle[0]))
    size = dot(normal, normal)
    if size != 0:
        at = [x - n * dot(sub(p, triangle[0]), normal) / size for x, n in zip(p, normal)]
        if all(dot(cross(sub(triangle[(k + 1) % 3], triangle[k]), sub(at, triangle[k])), normal) > 0 for k in range(3)):
            found["face"] = at
    return found


def nearest(triangle, p):
    """Squared distance, the point, and every part that has it."""
    by_part = {part: dot(sub(p, at), sub(p, at)) for part, at in candidates(triangle, p).items()}
    least = min(by_part.values())
    parts = {part for part, squared in by_part.items() if squared == least}
    return least, candidates(triangle, p)[min(parts, key=PARTS.index)], parts


def decimal(x): return Decimal(x.numerator) / Decimal(x.denominator)


def queries(random_numbers):
    """Ordinary ones, small integers, centres on the triangle, and triangles without area."""
    made = []
    for number in range(400):
        kind = number % 5
        whole = lambda: float(random_numbers.randint(-3, 3))  # noqa: E731
        wide = lambda: single(random_numbers.uniform(-2, 2))  # noqa: E731
        one = whole if kind in (1, 3) else wide
        a, b, c, p = ([one() for _ in range(3)] for _ in range(4))
        if kind == 2:  # on an edge, but for rounding
            p = [single((x + y) / 2) for x, y in zip(a, b)]
        if kind == 3:
            c = [2 * y - x for x, y in zip(a, b)] if number % 2 else a
        if kind == 4:  # over a vertex
            p = [single(x + random_numbers.uniform(-1e-3, 1e-3)) for x in a]
        made.append((a, b, c, p, single(random_numbers.choice([0, 0.5, 1, 3]))))
    return made


class Contacts(Case):
    def checked(self, kernel, made):
        file = self.folder / "queries.jsonl"
        file.write_text("".join(json.dumps({"id": str(number), "precision": "binary32", "a": [x.hex() for x in a], "b": [x.hex() for x in b],
                                            "c": [x.hex() for x in c], "p": [x.hex() for x in p], "r": r.hex()}) + "\n"
                                for number, (a, b, c, p, r) in enumerate(made)))
        done = axiscert("check", file, "--kernel", kernel, "--format", "jsonl")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_the_exact_place_is_that_of_fractions(self):
        made = queries(random.Random(SEED))
        for (a, b, c, p, _), line in zip(made, self.checked("minkowski", made), strict=True):
            triangle = [[Fraction(x) for x in corner] for corner in (a, b, c)]
            squared, at, parts = nearest(triangle, [Fraction(x) for x in p])
            exact = line["exact"]
            self.assertEqual(Fraction(exact["squared_distance"]), squared)
            self.assertEqual([Fraction(x) for x in exact["facts"]["nearest_point"]["exact"]], at)
            self.assertEqual(set(exact["facts"]["features"]["value"]), parts)

    def test_the_errors_are_those_of_decimals(self):
        made = queries(random.Random(SEED + 1))
        looked_at = {name: 0 for name in ("separation", "angle", "left", "point", "feature")}
        for kernel in ("minkowski", "closest-point"):
            for (a, b, c, p, r), line in zip(made, self.checked(kernel, made), strict=True):
                measures = line["computed"]["measures"]
                given = {name: float.fromhex(text) for name, text in measures["given"].items()}
                triangle, centre = [[Fraction(x) for x in corner] for corner in (a, b, c)], [Fraction(x) for x in p]
                squared, at, parts = nearest(triangle, centre)
                scene = max(Fraction(r) ** 2, *(dot(sub(v, centre), sub(v, centre)) for v in triangle))
                if scene == 0 or any(x != x for x in given.values()):
                    continue
                distance, size, radius = decimal(squared).sqrt(), decimal(scene).sqrt(), Decimal(r)
                error = abs(Decimal(given["separation"]) - (distance - radius)) / size
                self.assertAlmostEqual(measures["separation_error"], float(error), delta=1e-12 * float(error) + 1e-300)
                looked_at["separation"] += 1
                self.assertEqual(measures["feature_is_right"], PARTS[int(given["feature"])] in parts)
                looked_at["feature"] += not measures["feature_is_right"]
                said = [Fraction(given[f"point_{axis}"]) for axis in "xyz"]
                error = (decimal(dot(sub(said, at), sub(said, at))) / decimal(scene)).sqrt()
                self.assertAlmostEqual(measures["point_error"], float(error), delta=1e-12 * float(error) + 1e-300)
                looked_at["point"] += error > 0
                normal, away = [Fraction(given[f"normal_{axis}"]) for axis in "xyz"], sub(centre, at)
                if squared == 0:
                    self.assertIsNone(measures["normal_angle"])
                else:
                    # sin^2 of the angle: |n x away|^2 / (|n| |away|)^2.
                    sine = (decimal(dot(cross(normal, away), cross(normal, away))) / decimal(dot(normal, normal) * squared)).sqrt()
                    if dot(normal, away) > 0 and sine < Decimal("1e-3"):
                        self.assertAlmostEqual(measures["normal_angle"], float(sine), delta=1e-6 * float(sine) + 1e-12)
                        looked_at["angle"] += 1
                depth = radius - distance
                if depth <= 0:
                    self.assertIsNone(measures["left"])
                    continue
                length = decimal(dot(normal, normal)).sqrt()
                pushed = [Fraction(decimal(x) + depth * decimal(n) / length) for x, n in zip(centre, normal)]
                left = max(Decimal(0), (radius - decimal(nearest(triangle, pushed)[0]).sqrt()) / depth)
                self.assertAlmostEqual(float(measures["left"]), float(left), delta=2e-5 * float(left) + 1e-30, msg=str((kernel, line["id"])))
                looked_at["left"] += left > 0
        for name, count in looked_at.items():
            self.assertGreater(count, 3, f"{name}: {looked_at}")


# What people reported of libraries: the query, a kernel that gives numbers, and the separation that is right.
REPORTED = {
    "github.com/RiSearcher/GeometRi.CSharp/issues/26": (
        {"precision": "binary64", "a": [0, 0, 0], "b": [10000, 0, 0], "c": [0, 10000, 0], "p": ["3286.5999999974479", 5000, 0], "r": 1}, "closest-point", -1),
    "github.com/flexible-collision-library/fcl/issues/293": (
        {"predicate": "box-box", "precision": "binary64", "a": {"m": ["1.625", 0, 0.5], "s": [1.375, 3, "0.025"], "q": [1, 0, 0, 0]},
         "b": {"m": ["0.192074", "-0.277870", "0.273546"], "s": ["0.212", "0.075", "0.0843"], "q": ["0.672811", "0.340674", "0.155066", "0.638138"]}},
        "box-box/cofactor-turned", 0.053516162824549275),
    "github.com/google-deepmind/mujoco_warp/issues/1430": (
        {"predicate": "box-box", "precision": "binary32", "a": {"m": [0, 0, 0.25], "s": [100, 100, 0.25], "b": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]},
         "b": {"m": [0, 0, "0.5995"], "s": ["0.1", "0.1", "0.1"], "b": [[1, 0, 0], [0, 1, 0], [0, 0, 1]]}}, "box-box/cofactor", -0.0005000010132789612),
    "github.com/google-deepmind/mujoco/issues/3476": (
        {"predicate": "box-box", "precision": "binary64", "a": {"m": [0, 0, 0], "s": [35.5, 35.5, 20], "q": [1, 0, 0, 0]},
         "b": {"m": [10, "71.02", 0], "s": [35.5, 35.5, 20], "q": ["0.9999994", 0, 0, "0.00107"]}}, "box-box/cofactor-turned", -0.055888670699442415),
}
# A sphere of radius 50, 5 deep, whose contact is said to be 54.72 from its centre (github.com/coal-library/coal/issues/440).
OUTSIDE = r"""
#include <axiscert/plugin.h>
static int outside(const float a[3], const float b[3], const float c[3], const float p[3], float r, float *separation, float *feature, float normal[3], float point[3]) {
  (void)a; (void)b; (void)c;
  *separation = p[2] - r;
  *feature = 6;
  normal[0] = normal[1] = 0; normal[2] = 1;
  point[0] = p[0]; point[1] = p[1]; point[2] = p[2] - 54.72f;
  return AXISCERT_CONTACT;
}
AXISCERT_CONTACT_PLUGIN(float, "outside", outside, all)
"""


class Reported(Case):
    def answer(self, query, kernel):
        done = axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=json.dumps({"id": "x", **query}))
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return json.loads(done.stdout)

    def test_each_has_its_exact_separation_and_a_kernel_that_is_right(self):
        for where, (query, kernel, right) in REPORTED.items():
            with self.subTest(where):
                said = self.answer(query, kernel)
                self.assertEqual(said["exact"]["verdict"], "separated" if right > 0 else "contact")
                self.assertAlmostEqual(float(said["exact"]["facts"]["distance" if right > 0 else "penetration"]["value"]), abs(right), delta=1e-12)
                if right < 0:  # axes tell no distance
                    self.assertLess(said["computed"]["measures"]["separation_error"], 1e-6)

    def test_a_point_outside_of_the_sphere_is_told(self):
        source, library = self.folder / "outside.c", self.folder / "outside.so"
        source.write_text(OUTSIDE)
        subprocess.run(["cc", "-O1", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", library], check=True)
        query = {"precision": "binary32", "a": [-200, -200, 0], "b": [200, -200, 0], "c": [0, 300, 0], "p": [0, 0, 45], "r": 50}
        measures = self.answer(query, f"plugin:{library}")["computed"]["measures"]
        self.assertEqual((measures["separation_error"], measures["normal_angle"]), (0, 0))
        scene = dot([200, 200, 45], [200, 200, 45]) ** 0.5
        self.assertAlmostEqual(measures["point_error"], 9.72 / max(scene, dot([0, 300, 45], [0, 300, 45]) ** 0.5), delta=1e-6)


if __name__ == "__main__":
    unittest.main()
