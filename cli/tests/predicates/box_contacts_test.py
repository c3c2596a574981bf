"""What is said beside the verdict of two boxes: judged by `check`, and found again here by fractions and decimals that share nothing with it;
and planted faults, each refused by the levels that are for it."""
import json
import random
import re
import struct
import unittest
from decimal import Decimal, getcontext
from fractions import Fraction
from itertools import product

from command import BUILD, Case, axiscert

getcontext().prec = 60
SEED = 23
ROTATIONS = [[[1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 0], [0, 0, 1], [1, 0, 0]], [[0, -1, 0], [1, 0, 0], [0, 0, 1]]]


def single(x):
    return struct.unpack("f", struct.pack("f", x))[0]


def sub(u, v): return [x - y for x, y in zip(u, v)]
def dot(u, v): return sum(x * y for x, y in zip(u, v))
def cross(u, v): return [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]]
def decimal(x): return Decimal(x.numerator) / Decimal(x.denominator)


def corners(box):
    half = [[Fraction(s) * Fraction(x) for x in axis] for s, axis in zip(box["s"], box["b"])]
    return [[Fraction(m) + sum(sign * h[i] for sign, h in zip(signs, half)) for i, m in enumerate(box["m"])]
            for signs in product((-1, 1), repeat=3)]


def directions(a, b):
    """Both ways of every direction that a facet of the bodies' difference can have: products of two of their edges."""
    edges = [[Fraction(x) for x in axis] for box in (a, b) for axis in box["b"]]
    found = [cross(edges[i], edges[k]) for i in range(6) for k in range(i)]
    return [d for one in found if any(one) for d in (one, [-x for x in one])]


def reach(points_a, points_b, d):
    """How far B has to be pushed along d, times its length, until it is beyond A."""
    return max(dot(p, d) for p in points_a) - min(dot(p, d) for p in points_b)


def turned(quaternion):
    w, x, y, z = quaternion
    n = w * w + x * x + y * y + z * z
    columns = [[w * w + x * x - y * y - z * z, 2 * (x * y + w * z), 2 * (x * z - w * y)],
               [2 * (x * y - w * z), w * w - x * x + y * y - z * z, 2 * (y * z + w * x)],
               [2 * (x * z + w * y), 2 * (y * z - w * x), w * w - x * x - y * y + z * z]]
    return [[single(x / n) for x in column] for column in columns]


def box(numbers, kind):
    half = [single(numbers.uniform(0.5, 1.5)) if kind else float(numbers.randint(0, 2)) for _ in range(3)]
    centre = [single(numbers.uniform(-1, 1)) if kind else float(numbers.randint(-1, 1)) for _ in range(3)]
    axes = turned([numbers.randint(-9, 9) or 1 for _ in range(4)]) if kind == 1 else numbers.choice(ROTATIONS)
    return {"m": centre, "s": half, "b": axes}


class BoxContacts(Case):
    def checked(self, kernel, made):
        def written(one):
            return {"m": [float(x).hex() for x in one["m"]], "s": [float(x).hex() for x in one["s"]],
                    "b": [[float(x).hex() for x in axis] for axis in one["b"]]}
        file = self.folder / "boxes.jsonl"
        file.write_text("".join(json.dumps({"id": str(number), "predicate": "box-box", "precision": "binary32", "a": written(a), "b": written(b)}) + "\n"
                                for number, (a, b) in enumerate(made)))
        done = axiscert("check", file, "--kernel", kernel, "--format", "jsonl")
        self.assertIn(done.returncode, (0, 1), done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_the_errors_are_those_of_decimals(self):
        numbers = random.Random(SEED)
        made = [(box(numbers, kind % 3), box(numbers, kind % 3)) for kind in range(150)]
        looked_at = {name: 0 for name in ("deep", "tilted", "left")}
        for kernel in ("box-box/cofactor", "box-box/favours-facets"):
            for (a, b), line in zip(made, self.checked(kernel, made), strict=True):
                measures = line["computed"]["measures"]
                if line["exact"]["verdict"] != "contact" or measures is None:
                    continue
                given = {name: float.fromhex(text) for name, text in measures["given"].items()}
                points_a, points_b, ways = corners(a), corners(b), directions(a, b)
                squares = [reach(points_a, points_b, d) ** 2 / dot(d, d) for d in ways]
                depth = decimal(min(squares)).sqrt()
                between = [Fraction(y) - Fraction(x) for x, y in zip(a["m"], b["m"])]
                scene = decimal(max(dot(between, between), *(dot(sub(p, [Fraction(x) for x in one["m"]]), sub(p, [Fraction(x) for x in one["m"]]))
                                                             for one, all_of in ((a, points_a), (b, points_b)) for p in all_of))).sqrt()
                if scene == 0 or any(x != x for x in given.values()):
                    continue
                error = abs(Decimal(given["separation"]) + depth) / scene
                self.assertAlmostEqual(measures["separation_error"], float(error), delta=1e-6 * float(error) + 1e-300)
                at = [[Fraction(given[f"point_{which}_{axis}"]) for axis in "xyz"] for which in "ab"]
                apart = decimal(dot(sub(*at), sub(*at))).sqrt()

                def rest_after(way):
                    return min((decimal(reach(points_a, points_b, d)) - sum(decimal(x) * y for x, y in zip(d, way))) / decimal(dot(d, d)).sqrt()
                               for d in ways)
                points_off = max(apart - depth, rest_after([decimal(x) for x in sub(*at)])) / scene
                self.assertAlmostEqual(measures["points_apart"], float(points_off), delta=1e-12)
                if depth == 0:
                    self.assertIsNone(measures["left"])
                    continue
                looked_at["deep"] += 1
                normal = [Fraction(given[f"normal_{axis}"]) for axis in "xyz"]
                left = max(Decimal(0), rest_after([depth * decimal(x) / decimal(dot(normal, normal)).sqrt() for x in normal]) / depth)
                self.assertAlmostEqual(float(measures["left"]), float(left), delta=2e-5 * float(left) + 1e-40, msg=str((kernel, line["id"])))
                looked_at["left"] += left > Decimal("1e-3")
                looked_at["tilted"] += measures["normal_angle"] is not None and measures["normal_angle"] > 0
        for name, count in looked_at.items():
            self.assertGreater(count, 3, f"{name}: {looked_at}")


class BoxFaults(Case):
    LEVELS = ["separation=1e-5", "normal=0.05", "unit=1e-5", "no-flip", "left=1e-5", "point=1e-4"]
    # The levels that refuse each fault. Points are right or wrong whatever the normal.
    REFUSED = {"none": [], "flipped": ["normal=0.05", "no-flip", "left=1e-5"], "tilted": ["normal=0.05"],
               "not_unit": ["unit=1e-5"], "halved": ["separation=1e-5"], "margin": ["separation=1e-5"],
               "one_axis": ["separation=1e-5", "normal=0.05", "no-flip", "left=1e-5"], "swapped": ["point=1e-4"]}

    def not_met(self, faults, levels, *asked):
        """The levels that each fault does not meet, in one run: the truth about a query costs more than the kernels."""
        kernels = {fault: f"plugin:{BUILD}/contact_faults/{fault}.so" for fault in faults}
        done = axiscert("run", *(f"--kernel={kernel}" for kernel in kernels.values()), *asked, "--precision", "binary32", "--out",
                        self.folder / "out", *(f"--require={level}" for level in levels))
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        return {fault: [level for level in levels if re.search(rf"--require: {kernel} binary32: {level}: .*: not met\n", done.stderr)]
                for fault, kernel in kernels.items()}

    def test_each_is_refused_by_the_levels_for_it(self):
        self.assertEqual(self.not_met(self.REFUSED, self.LEVELS, "--family", "box-box/general", "--trials", 300), self.REFUSED)

    # A fault that is alike on both follows; one that prefers a side of the world does not.
    FOLLOWS = {"none": True, "flipped": True, "one_sided": False}

    def test_numbers_follow_boxes_that_are_exchanged_or_turned_half_round(self):
        found = self.not_met(self.FOLLOWS, ["follows=0.01"], "--family", "box-box/symmetric", "--trials", 1200)
        self.assertEqual({fault: not refused for fault, refused in found.items()}, self.FOLLOWS)

    # What the numbers of each are like, in the words of a diagnosis; of the others see fuzz/diagnosis/contacts_test.cpp.
    NAMED = {"none": {}, "swapped": {"contact_point": "exchanged"}, "halved_level": {"separation": "wrong"}}

    def test_some_are_named_by_their_diagnosis(self):
        for fault, named in self.NAMED.items():
            with self.subTest(fault=fault):
                done = axiscert("diagnose", f"plugin:{BUILD}/contact_faults/{fault}.so", "--format", "json")
                self.assertEqual(done.returncode, 0, done.stderr)
                values = {one["name"]: one["value"] for one in json.loads(done.stdout)["properties"]}
                self.assertEqual({name: values[name] for name in ("separation", "normal", "contact_point")},
                                 {"separation": "right", "normal": "right", "contact_point": "right"} | named)


if __name__ == "__main__":
    unittest.main()
