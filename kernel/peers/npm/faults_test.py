#!/usr/bin/env python3
"""The known faults of the engines, each asked of the engine itself through the pipe: PREDICATE/faults.jsonl. A line is a query with the
exact answer (`expected`) and the engine's own (`engine`); `found` is the address that it was shrunk from. An engine that answers otherwise has changed: its line and docs/upstream have to follow. With a path of
axiscert, `axiscert check` has to say the same of each, and `shrink` to make the same of what was found. Where the engines are not
installed nothing is checked: exit code 77.

faults_test.py [--axiscert FILE] [unittest arguments]
"""
import json
import subprocess
import sys
import tempfile
import unittest
from collections import defaultdict
from fractions import Fraction
from pathlib import Path

import asking
import exact
import exact_boxes
import faults_corpus


AXISCERT = None
if sys.argv[1:2] == ["--axiscert"]:
    AXISCERT = sys.argv[2]
    del sys.argv[1:3]
FAULTS = asking.faults()
STILL = [line for line in FAULTS if "predicate" not in line]
MOVING = [line for line in FAULTS if line.get("predicate") == "moving-sphere"]
CONTACTS = asking.contact_faults()
SHRUNK_BY = {"flip": "normal"}
BOXES = [line for line in FAULTS if line.get("predicate", "").startswith("box-")]


def manifest(line):
    return json.loads((asking.FOLDER / line["engine"]["manifest"]).read_text())


def by_program(lines):
    """The lines of each manifest and precision."""
    programs = defaultdict(list)
    for line in lines:
        programs[line["engine"]["manifest"], line["precision"]].append(line)
    return programs


class Truth(unittest.TestCase):
    """The expected answers, by rationals alone."""

    def test_every_expected_answer_is_exact(self):
        for line in STILL:
            with self.subTest(line["id"]):
                numbers, expected = asking.numbers_of(line), line["expected"]
                self.assertEqual(exact.verdict(numbers), (expected["verdict"], expected["touching"]))
                self.assertEqual(exact.squared_distance(numbers), Fraction(expected["squared_distance"]))

    def test_every_first_contact_is_one(self):
        for line in MOVING:
            if "first_contact" not in line["expected"]:
                continue
            with self.subTest(line["id"]):
                numbers = [Fraction(x) for x in asking.numbers_of(line)]
                gap = lambda t: exact.squared_distance(
                    numbers[:9] + [p + t * d for p, d in zip(numbers[9:12], numbers[12:15])]) - numbers[15] ** 2
                first = Fraction(line["expected"]["first_contact"])
                self.assertTrue(0 < first < 1)
                self.assertEqual(gap(first), 0)
                self.assertGreater(gap(first - Fraction(1, 1000)), 0)
                self.assertLess(gap(first + Fraction(1, 1000)), 0)

    def test_every_answer_of_boxes_is_exact(self):
        """The penetration or the distance is the number of the query's precision next below it."""
        for line in BOXES:
            with self.subTest(line["id"]):
                expected = line["expected"]
                verdict, touching, squared = exact_boxes.truth(asking.numbers_of(line), asking.question_of(manifest(line)))
                self.assertEqual((verdict, touching), (expected["verdict"], expected["touching"]))
                given = Fraction(float.fromhex(expected["penetration" if verdict == "contact" else "distance"]))
                u = Fraction(1, 2 ** (23 if line["precision"] == "binary32" else 52))
                self.assertLessEqual(abs(given - exact_boxes.root(squared)), u * given)

    def test_every_line_is_a_fault(self):
        for line in FAULTS:
            self.assertNotEqual(line["engine"]["answer"], line["expected"]["verdict"], line["id"])

    def test_every_line_has_its_own_name(self):
        names = [line["id"] for line in FAULTS]
        self.assertEqual(len(names), len(set(names)))


class Faults(unittest.TestCase):
    """The engines' answers."""

    def check(self, name, asked, precision):
        """`asked`: lines of one program. All in one stream, forwards and backwards: nothing is kept from query to query."""
        of, folder = manifest(asked[0]), (asking.FOLDER / name).parent
        self.assertIn(precision, of["precisions"])
        queries = [asking.numbers_of(line) for line in asked]
        forwards, backwards = asking.ask_each(of["command"], folder, [queries, queries[::-1]], precision, asking.question_of(of))
        for line, answer, again in zip(asked, forwards, backwards[::-1]):
            with self.subTest(line["id"]):
                package = line["engine"]["package"] + " " + line["engine"]["version"]
                self.assertEqual(answer, line["engine"]["answer"], f"{package} answers otherwise than it did")
                self.assertEqual(again, answer, package)

    def test_each_engine_has_its_known_faults(self):
        for (name, precision), asked in by_program(FAULTS).items():
            self.check(name, asked, precision)

    def test_the_versions_are_those_that_are_installed(self):
        wanted = json.loads((asking.FOLDER / "package.json").read_text())["dependencies"]
        for line in FAULTS:
            self.assertEqual(wanted[line["engine"]["package"]], line["engine"]["version"], line["id"])


@unittest.skipUnless(AXISCERT, "faults_test.py --axiscert FILE")
class Checks(unittest.TestCase):
    """`axiscert check` of the engines as kernels."""

    def check(self, asked, kernel):
        """`asked`: lines of one program. The command ends with 3 where its oracles disagree."""
        queries = "".join(json.dumps(asking.query_of(line)) + "\n" for line in asked)
        done = subprocess.run([AXISCERT, "check", "-", "--kernel", f"program:{kernel}", "--plugin-seconds", "20", "--format", "jsonl"],
                              input=queries, capture_output=True, text=True, timeout=asking.SECONDS)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        found = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["id"] for line in found], [line["id"] for line in asked])
        for line, said in zip(asked, found):
            with self.subTest(line["id"]):
                self.assertEqual(said["computed"]["verdict"], line["engine"]["answer"])
                self.assertEqual(said["findings"], [])
                for member in line["expected"].keys() - {"first_contact"}:
                    self.assertEqual(said["exact"][member], line["expected"][member], member)

    def test_each_known_fault_is_one_to_axiscert(self):
        for (name, _), asked in by_program(FAULTS).items():
            self.check(asked, asking.FOLDER / name)

    def test_shrink_gives_the_same_again(self):
        for line in FAULTS:
            if "found" not in line:
                continue
            with self.subTest(line["id"]):
                command = [AXISCERT, "shrink", line["found"], "--kernel", f"program:{asking.FOLDER / line['engine']['manifest']}",
                           "--plugin-seconds", "20", "--format", "jsonl"]
                done = subprocess.run(command, capture_output=True, text=True, timeout=4 * asking.SECONDS)
                self.assertEqual(done.returncode, 0, done.stderr)
                made = json.loads(done.stdout)
                members = asking.MEMBERS[line.get("predicate", "sphere-triangle")]
                self.assertEqual({member: made[member] for member in members}, {member: line[member] for member in members})

    def test_each_known_fault_is_in_the_corpus(self):
        """faults_corpus.py writes the file as it is."""
        self.assertEqual(faults_corpus.entries(AXISCERT), (faults_corpus.CORPUS / faults_corpus.FILE).read_text().splitlines())


class Numbers(unittest.TestCase):
    """The engines' faults in what they say beside a verdict on a sphere and a triangle. `said` has the separation, the normal and the point."""

    @staticmethod
    def numbers_of(said):
        return [said["separation"], *said["normal"], *said["point"]]

    def errors(self, line):
        """Of the separation and the point, as shares of the scene; whether the normal is more than a right angle off, and its cosine."""
        query, said = asking.numbers_of(line), line["engine"]["said"]
        centre, radius, way = query[9:12], query[12], [float(x) for x in exact.away(query)]
        size = lambda v: exact.dot(v, v) ** 0.5
        scene = max(radius, *(size(exact.minus(query[k:k + 3], centre)) for k in (0, 3, 6)))
        on = exact.minus(centre, way)
        cosine = exact.dot(way, said["normal"]) / (size(way) * size(said["normal"]) or 1)
        return {"separation": abs(said["separation"] - (size(way) - radius)) / scene, "point": size(exact.minus(said["point"], on)) / scene,
                "flip": cosine < 0, "normal": 1 - cosine}

    def test_each_is_one_by_fractions(self):
        for line in CONTACTS:
            with self.subTest(line["id"]):
                numbers = asking.numbers_of(line)
                self.assertEqual(exact.verdict(numbers)[0], line["engine"]["answer"], "these verdicts are right")
                self.assertGreater(self.errors(line)[line["what"]], 1e-4)

    def test_each_engine_says_them(self):
        for (name, precision), asked in by_program(CONTACTS).items():
            of = manifest(asked[0])
            answers = asking.ask_measures(of["command"], (asking.FOLDER / name).parent, [asking.numbers_of(line) for line in asked], of["measures"],
                                          precision, asking.question_of(of))
            for line, (verdict, (separation, _, *rest)) in zip(asked, answers):
                with self.subTest(line["id"]):
                    self.assertEqual(verdict, line["engine"]["answer"])
                    for given, known in zip([separation, *rest], self.numbers_of(line["engine"]["said"])):
                        self.assertAlmostEqual(given, known, delta=1e-6 * max(1, abs(known)))

    @unittest.skipUnless(AXISCERT, "faults_test.py --axiscert FILE")
    def test_each_is_one_to_axiscert(self):
        members = {"separation": "separation_error", "normal": "normal_angle", "flip": "is_flip", "point": "point_error"}
        for line in CONTACTS:
            with self.subTest(line["id"]):
                done = subprocess.run([AXISCERT, "check", "-", "--kernel", f"program:{asking.FOLDER / line['engine']['manifest']}", "--format", "jsonl"],
                                      input=json.dumps(asking.query_of(line)), capture_output=True, text=True, timeout=asking.SECONDS)
                self.assertEqual((done.returncode, done.stderr), (0, ""))
                self.assertGreater(json.loads(done.stdout)["computed"]["measures"][members[line["what"]]], 1e-4)

    @unittest.skipUnless(AXISCERT, "faults_test.py --axiscert FILE")
    def test_shrink_gives_the_same_again(self):
        for line in CONTACTS:
            if "found" not in line:
                continue
            with self.subTest(line["id"]):
                kernel = f"program:{asking.FOLDER / line['engine']['manifest']}"
                done = subprocess.run([AXISCERT, "shrink", line["found"], "--kernel", kernel, "--what", SHRUNK_BY.get(line["what"], line["what"]), "--format", "jsonl"],
                                      capture_output=True, text=True, timeout=4 * asking.SECONDS)
                self.assertEqual(done.returncode, 0, done.stderr)
                made = json.loads(done.stdout)
                self.assertEqual({member: made[member] for member in asking.MEMBERS["sphere-triangle"]},
                                 {member: line[member] for member in asking.MEMBERS["sphere-triangle"]})


class Answers(unittest.TestCase):
    """Every program answers plain queries rightly, and says what it declines."""

    LEGS = [0, 0, 0, 4, 0, 0, 0, 4, 0]

    def test_plain_queries_have_the_right_answers(self):
        queries = [self.LEGS + place for place in ([1, 1, .5, 1], [1, 1, 3, 1], [-2, -1, 0, 3], [6, 5, 0, 1], [2, -2, 1, 3], [2, -2, 2, 2])]
        right = [exact.verdict(query)[0] for query in queries]
        for file, of in asking.manifests().items():
            if of["predicate"] != "sphere-triangle":
                continue
            for precision in of["precisions"]:
                with self.subTest(file.name, precision=precision):
                    self.assertEqual(asking.ask(of["command"], file.parent, queries, precision), right)

    def test_plain_motions_have_the_right_answers_times_normals_and_points(self):
        # (p, d, r), then what is right: the time, the normal from the triangle to the centre, and the triangle's point.
        motions = [([1, 1, 3], [0, 0, -4], 1, (.5, [0, 0, 1], [1, 1, 0])),  # the face
                   ([2, -3, .5], [0, 4, -.25], .625, None),                  # an edge, beside the plane
                   ([-3, -4, 1], [3, 4, -1], 1, None),                       # a vertex
                   ([1, 1, 3], [0, 0, 4], 1, "separated"), ([1, 1, 3], [0, 0, -1.5], 1, "separated"), ([6, 5, 1], [1, 1, -1], 1, "separated")]
        queries = [self.LEGS + p + d + [r] for p, d, r, _ in motions]
        for file, of in asking.manifests().items():
            if of["predicate"] != "moving-sphere":
                continue
            with self.subTest(file.name):
                answers = asking.ask_measures(of["command"], file.parent, queries, of["measures"])
                for (p, d, r, right), (verdict, (time, _, *rest)) in zip(motions, answers):
                    self.assertEqual(verdict, "separated" if right == "separated" else "contact")
                    if right == "separated":
                        continue
                    centre = [x + time * y for x, y in zip(p, d)]
                    self.assertAlmostEqual(exact.squared_distance(self.LEGS + centre) ** .5, r, delta=2e-3)
                    normal, point = rest[:3], rest[3:]
                    for on, n, x in zip(point, normal, centre):
                        self.assertAlmostEqual(on + r * n, x, delta=5e-3)
                    if right:
                        self.assertAlmostEqual(time, right[0], delta=1e-3)
                        for given, wanted in zip(normal + point, right[1] + right[2]):
                            self.assertAlmostEqual(given, wanted, delta=2e-3)

    # p, r, then what is right: the separation, the normal that pushes the sphere, and the triangle's point.
    NUMBERS = [([1, 1, 0.5, 1], (-0.5, [0, 0, 1], [1, 1, 0])), ([2, -0.5, 0, 1], (-0.5, [0, -1, 0], [2, 0, 0])),
               ([2.5, 2.5, 0.25, 1], (-0.25, [2 / 3, 2 / 3, 1 / 3], [2, 2, 0])), ([-0.375, -0.5, 0, 1], (-0.375, [-0.6, -0.8, 0], [0, 0, 0]))]
    # By design: hulls stand about their points, by 0.04 and by what Havok makes them larger.
    MARGINS = {"ammo-hull-margin": 0.04, "havok-hull": 0.015}

    def test_plain_spheres_have_the_right_numbers(self):
        queries = [self.LEGS + q for q, _ in self.NUMBERS]
        for file, of in asking.manifests().items():
            if of["predicate"] != "sphere-triangle" or not of.get("measures"):
                continue
            margin = self.MARGINS.get(file.stem, 0)
            for precision in of["precisions"]:
                with self.subTest(file.name, precision=precision):
                    answers = asking.ask_measures(of["command"], file.parent, queries, of["measures"], precision, "sphere-triangle")
                    for (_, (separation, normal, point)), (verdict, (gap, feature, *rest)) in zip(self.NUMBERS, answers):
                        self.assertEqual(verdict, "contact")
                        self.assertNotEqual(feature, feature, "no engine names a part")
                        wanted = [separation - margin, *normal, *(on + margin * n for on, n in zip(point, normal))]
                        for given, right in zip([gap, *rest], wanted):
                            self.assertAlmostEqual(given, right, delta=2e-5)

    def test_plain_boxes_have_the_right_numbers(self):
        """Cubes on one another, the upper turned or not: its lowest point is 0.125 in the lower."""
        upright, turned = [1.0, 0, 0, 0], [0.9238795325112867, 0.3826834323650898, 0, 0]  # by 45 degrees about x
        cubes = [[0.0, 0, 0, 1, 1, 1, *upright, 0.5, 0.25, 1.875, 1, 1, 1, *upright], [0.0, 0, 0, 1, 1, 1, *upright, 0.5, 0.25, 0.875 + 2**0.5, 1, 1, 1, *turned]]
        for file, of in asking.manifests().items():
            if of["predicate"] != "box-box" or not of.get("measures") or file.stem == "jolt-box":  # that one rounds its edges
                continue
            answers = asking.ask_measures(of["command"], file.parent, cubes, of["measures"], of["precisions"][0], asking.question_of(of))
            for verdict, (separation, *normal_and_points) in answers:
                with self.subTest(file.name):
                    self.assertEqual(verdict, "contact")
                    slack = 0.02 if file.stem == "havok-box" else 1e-5  # its edges are rounded too
                    self.assertAlmostEqual(separation, -0.125, delta=slack)
                    for given, right in zip(normal_and_points[:3], [0, 0, 1]):
                        self.assertAlmostEqual(given, right, delta=1e-3)
                    self.assertAlmostEqual(normal_and_points[5], 1, delta=slack, msg="the top of the first")
                    self.assertAlmostEqual(normal_and_points[8], 0.875, delta=slack, msg="the bottom of the second")

    def test_a_box_and_a_triangle_have_the_right_numbers(self):
        """The triangle is the face of a box's bottom, 0.5 into it."""
        query = [1.0, 1, 0.5, 1, 0.75, 1] + self.LEGS
        for file, of in asking.manifests().items():
            if of["predicate"] != "box-triangle" or not of.get("measures"):
                continue
            (verdict, (separation, *rest)), = asking.ask_measures(of["command"], file.parent, [query], of["measures"], "binary32", asking.question_of(of))
            with self.subTest(file.name):
                self.assertEqual(verdict, "contact")
                for given, right in zip([separation, *rest[:3], rest[5], rest[8]], [-0.5, 0, 0, -1, -0.5, 0]):
                    self.assertAlmostEqual(given, right, delta=1e-5)

    UPRIGHT, TURNED = [1.0, 0, 0, 0], [0.75, 0.25, -0.5, 0.125]  # w x y z; any length

    def plain_boxes(self, question):
        """Queries of ordinary size, far from touching, in the order of the question's columns."""
        predicate, entry = question.split("/")
        axes = lambda turn: [float(round(x * 2**20)) / 2**20 for column in exact_boxes.rotation(*map(Fraction, turn)) for x in column]
        how = {"matrix": axes, "quaternion": list, "centre": lambda _: []}
        if predicate == "box-box":
            for turn in (self.UPRIGHT, self.TURNED):
                for m, half in (([1.5, 0, 0], [1.0, 1, 1]), ([3.5, 0, 0], [1.0, 1, 1]), ([1.25, 1.25, -0.5], [0.5, 1, 2]), ([-2, 2, 3], [0.5, 1, 0.75])):
                    yield [0.0, 0, 0, 1, 1, 1] + how[entry](self.UPRIGHT) + m + half + how[entry](turn)
            return
        for m in ([1.0, 1, 0.5], [1.0, 1, 1.5], [3.5, 3.5, 0], [-1.5, -0.5, 0]):
            if entry == "minmax":
                yield [x - 1 for x in m] + [x + 1 for x in m] + self.LEGS
            else:
                yield m + [1.0, 0.75, 1] + how[entry](self.UPRIGHT) + self.LEGS

    def test_plain_boxes_have_the_right_answers(self):
        for file, of in asking.manifests().items():
            if not of["predicate"].startswith("box-") or file.name == "three-mesh-bvh-oriented-box-made.json":  # this one is never right
                continue
            question = asking.question_of(of)
            queries = list(self.plain_boxes(question))
            right = [exact_boxes.truth(query, question)[0] for query in queries]
            self.assertEqual(set(right), {"contact", "separated"})
            for precision in of["precisions"]:
                with self.subTest(file.name, precision=precision):
                    self.assertEqual(asking.ask(of["command"], file.parent, queries, precision, question), right)

    def test_axes_that_are_no_rotation_are_declined_and_left_handed_ones_are_not(self):
        for file, of in asking.manifests().items():
            question = asking.question_of(of)
            if not question.endswith("/matrix"):
                continue
            query = next(self.plain_boxes(question))
            slanted = query[:7] + [0.5] + query[8:]
            mirrored = query[:6] + [-x for x in query[6:15]] + query[15:]
            with self.subTest(file.name):
                plain, declined, left = asking.ask(of["command"], file.parent, [query, slanted, mirrored], question=question)
                self.assertEqual((declined, left), ("undecided", plain))


if __name__ == "__main__":
    asking.main()
