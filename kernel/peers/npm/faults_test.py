#!/usr/bin/env python3
"""The known faults of the engines, each asked of the engine itself through the pipe: faults.jsonl, and faults_moving.jsonl for moving
spheres. A line is a query with the exact answer (`expected`) and the engine's own (`engine`); `found` is the address that it was
shrunk from. An engine that answers otherwise has changed: its line, docs/league.md and docs/upstream have to follow. With a path of
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
import faults_corpus


def lines(name):
    return [json.loads(line) for line in (asking.FOLDER / name).read_text().splitlines()]


AXISCERT = None
if sys.argv[1:2] == ["--axiscert"]:
    AXISCERT = sys.argv[2]
    del sys.argv[1:3]
STILL, MOVING = lines("faults.jsonl"), lines("faults_moving.jsonl")


def manifest(line):
    return json.loads((asking.FOLDER / line["engine"]["manifest"]).read_text())


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
                numbers = [Fraction(x) for x in asking.numbers_of(line, line["test"])]
                gap = lambda t: exact.squared_distance(
                    numbers[:9] + [p + t * d for p, d in zip(numbers[9:12], numbers[12:15])]) - numbers[15] ** 2
                first = Fraction(line["expected"]["first_contact"])
                self.assertTrue(0 < first < 1)
                self.assertEqual(gap(first), 0)
                self.assertGreater(gap(first - Fraction(1, 1000)), 0)
                self.assertLess(gap(first + Fraction(1, 1000)), 0)

    def test_every_line_is_a_fault(self):
        for line in STILL + MOVING:
            self.assertNotEqual(line["engine"]["answer"], line["expected"]["verdict"], line["id"])

    def test_every_line_has_its_own_name(self):
        names = [line["id"] for line in STILL + MOVING]
        self.assertEqual(len(names), len(set(names)))


class Faults(unittest.TestCase):
    """The engines' answers."""

    def check(self, asked, command, precision, test):
        """`asked`: lines of one program. All in one stream, forwards and backwards: nothing is kept from query to query."""
        queries = [asking.numbers_of(line, test) for line in asked]
        forwards, backwards = asking.ask_each(command, asking.FOLDER, [queries, queries[::-1]], precision, test)
        for line, answer, again in zip(asked, forwards, backwards[::-1]):
            with self.subTest(line["id"]):
                package = line["engine"]["package"] + " " + line["engine"]["version"]
                self.assertEqual(answer, line["engine"]["answer"], f"{package} answers otherwise than it did")
                self.assertEqual(again, answer, package)

    def test_each_engine_has_its_known_faults(self):
        programs = defaultdict(list)
        for line in STILL + MOVING:
            programs[line["engine"]["manifest"], line["precision"]].append(line)
        for (_, precision), asked in programs.items():
            of = manifest(asked[0])
            self.assertIn(precision, of["precisions"])
            self.check(asked, of["command"], precision, of["test"])

    def test_the_versions_are_those_that_are_installed(self):
        wanted = json.loads((asking.FOLDER / "package.json").read_text())["dependencies"]
        for line in STILL + MOVING:
            self.assertEqual(wanted[line["engine"]["package"]], line["engine"]["version"], line["id"])


@unittest.skipUnless(AXISCERT, "faults_test.py --axiscert FILE")
class Checks(unittest.TestCase):
    """`axiscert check` of the engines as kernels."""

    def check(self, asked, kernel):
        """`asked`: lines of one program. The command ends with 3 where its oracles disagree."""
        queries = "".join(json.dumps({member: line[member] for member in ("id", "test", "precision", *"abcprd") if member in line}) + "\n"
                          for line in asked)
        done = subprocess.run([AXISCERT, "check", "-", "--kernel", f"program:{kernel}", "--plugin-seconds", "20", "--format", "jsonl"],
                              input=queries, capture_output=True, text=True, timeout=asking.SECONDS)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        found = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["id"] for line in found], [line["id"] for line in asked])
        for line, said in zip(asked, found):
            with self.subTest(line["id"]):
                self.assertEqual(said["computed"]["verdict"], line["engine"]["answer"])
                self.assertEqual(said["findings"], [])
                for member in line["expected"].keys() & {"verdict", "touching", "squared_distance"}:
                    self.assertEqual(said["exact"][member], line["expected"][member], member)

    def test_each_known_fault_is_one_to_axiscert(self):
        programs = defaultdict(list)
        for line in STILL + MOVING:
            programs[line["engine"]["manifest"]].append(line)
        for name, asked in programs.items():
            self.check(asked, asking.FOLDER / name)

    def test_shrink_gives_the_same_again(self):
        for line in STILL:
            if "found" not in line:
                continue
            with self.subTest(line["id"]):
                command = [AXISCERT, "shrink", line["found"], "--kernel", f"program:{asking.FOLDER / line['engine']['manifest']}",
                           "--plugin-seconds", "20", "--format", "jsonl"]
                done = subprocess.run(command, capture_output=True, text=True, timeout=4 * asking.SECONDS)
                self.assertEqual(done.returncode, 0, done.stderr)
                made = json.loads(done.stdout)
                self.assertEqual({member: made[member] for member in "abcpr"}, {member: line[member] for member in "abcpr"})

    def test_each_known_fault_is_in_the_corpus(self):
        """faults_corpus.py writes the file as it is."""
        self.assertEqual(faults_corpus.entries(AXISCERT), (faults_corpus.CORPUS / faults_corpus.FILE).read_text().splitlines())


class Answers(unittest.TestCase):
    """Every program answers plain queries rightly, and says what it declines."""

    LEGS = [0, 0, 0, 4, 0, 0, 0, 4, 0]

    def test_plain_queries_have_the_right_answers(self):
        queries = [self.LEGS + place for place in ([1, 1, .5, 1], [1, 1, 3, 1], [-2, -1, 0, 3], [6, 5, 0, 1], [2, -2, 1, 3], [2, -2, 2, 2])]
        right = [exact.verdict(query)[0] for query in queries]
        for file in sorted(asking.FOLDER.glob("*-*.json")) + [asking.FOLDER / "babylon.json", asking.FOLDER / "cannon.json"]:
            of = json.loads(file.read_text())
            if of.get("format") != "axiscert-program/1" or of["test"] != "sphere-triangle":
                continue
            for precision in of["precisions"]:
                with self.subTest(file.name, precision=precision):
                    self.assertEqual(asking.ask(of["command"], asking.FOLDER, queries, precision), right)

    def test_plain_motions_have_the_right_answers_times_normals_and_points(self):
        # (p, d, r), then what is right: the time, the normal from the triangle to the centre, and the triangle's point.
        motions = [([1, 1, 3], [0, 0, -4], 1, (.5, [0, 0, 1], [1, 1, 0])),  # the face
                   ([2, -3, .5], [0, 4, -.25], .625, None),                  # an edge, beside the plane
                   ([-3, -4, 1], [3, 4, -1], 1, None),                       # a vertex
                   ([1, 1, 3], [0, 0, 4], 1, "separated"), ([1, 1, 3], [0, 0, -1.5], 1, "separated"), ([6, 5, 1], [1, 1, -1], 1, "separated")]
        queries = [self.LEGS + p + d + [r] for p, d, r, _ in motions]
        for file in sorted(asking.FOLDER.glob("*-sweep*.json")):
            of = json.loads(file.read_text())
            with self.subTest(file.name):
                answers = asking.ask_measures(of["command"], asking.FOLDER, queries, of["measures"])
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


if __name__ == "__main__":
    asking.main()
