#!/usr/bin/env python3
"""`check`, and one clear line for every bad query, name, address and file."""
import json
import unittest
from fractions import Fraction

from command import MODELS, QUERY, Case, axiscert


class Check(Case):
    def check(self, text, *args):
        done = axiscert("check", "-", "--format", "jsonl", *args, stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_a_repeated_vertex_is_a_specification_fault(self):
        (line,) = self.check(QUERY % 1)
        self.assertEqual(line["kernel"], "published")
        self.assertEqual(line["exact"]["verdict"], "separated")
        self.assertFalse(line["exact"]["touching"])
        self.assertEqual(Fraction(line["exact"]["squared_distance"]), 4)
        self.assertEqual(line["computed"]["verdict"], "contact")
        self.assertEqual(line["flips"], [{"level": "verdict", "name": "verdict", "kind": "false_contact",
                                          "decisive": True, "links": ["specification"]}])
        for key, length in (("comparisons", 16), ("axes", 7)):
            self.assertEqual(len(line["exact"][key]), length)
            self.assertEqual(line["exact"][key], line["computed"][key])
        self.assertEqual(self.check(QUERY % 1, "--kernel", "nonstrict")[0]["flips"], [])

    def test_touching_is_contact_and_a_tie(self):
        (line,) = self.check(QUERY % 2)
        self.assertEqual((line["exact"]["verdict"], line["exact"]["touching"]), ("contact", True))
        self.assertEqual(line["exact"]["ties"][1], "1", "vertex_a.radius")

    def test_invalid_is_an_answer(self):
        for radius in ('"nan"', '"inf"', '-1', '"-0x1p-149"'):
            (line,) = self.check(QUERY % radius)
            self.assertEqual(line["exact"]["verdict"], "invalid", radius)
            self.assertIsNone(line["exact"]["squared_distance"])
            self.assertEqual(line["flips"], [])

    def test_a_decimal_is_rounded_from_its_text(self):
        # The double nearest to this decimal lies on a midpoint of two floats; only the text decides which is nearer.
        (line,) = self.check(QUERY.replace("[0,0,0]", "[1.00000005960464477540,0,0]") % 0)
        self.assertEqual(Fraction(line["exact"]["squared_distance"]), (2 - Fraction(float.fromhex("0x1.000002p0"))) ** 2)

    def test_text_is_a_line_a_query_and_one_with_what_is_exact(self):
        done = axiscert("check", "-", stdin=QUERY % 1 + QUERY % -1 + QUERY % 2)
        self.assertEqual([line.startswith("  rounded to 9 digits: ") for line in done.stdout.splitlines()], [False, True, False, False, True])
        self.assertIn("specification", done.stdout)


class BadInput(Case):
    def test_queries(self):
        good = QUERY % 1
        for text, says in {
            "{": ["stdin:1", "JSON"],
            good + '{"id":"x"}\n': [":2", "precision"],
            good.replace('"c":[3,0,0],', ""): [":1", "'c'"],
            QUERY % '"0x1.0000001p0"': [":1", "'r'", "not exact"],
            QUERY % "1e39": [":1", "'r'", "1e39"],
            QUERY % "1e999": [":1", "'r'", "1e999"],
            good.replace("binary32", "binary16"): [":1", "binary16", "binary64"],
            good.replace("[3,0,0]", "[3,0]"): [":1", "'c'"],
            good.replace("[3,0,0]", '"x"'): [":1", "'c'"],
            "": ["no queries"],
        }.items():
            with self.subTest(text=text):
                done = self.refused("check", "-", stdin=text, says=says)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertEqual(done.stdout, "", "half-read")

    def test_names(self):
        self.refused("run", "--kernel", "nosuch", says=["unknown kernel 'nosuch'", "published"])
        self.refused("run", "--family", "nosuch", says=["unknown family 'nosuch'; the nearest of ", "`axiscert families --predicate ID` lists them"])
        self.refused("run", "--target", "nosuch", says=["target 'nosuch'", "scalar"])
        self.refused("run", "--precision", "binary16", says=["binary16", "binary64"])
        self.refused("run", "--require", "nosuch", says=["nosuch", "logic"])
        self.refused("run", "--tolerance", "plane.radios=3", says=["plane.radios", "plane.radius"])
        self.refused("run", "--tolerance", "plane.radius=three", says=["three", "decimal"])
        for option, wrong in (("--trials", "0"), ("--trials", "-5"), ("--trials", "many"), ("--seed", "-1"),
                              ("--time", "0"), ("--threads", "0")):
            done = self.refused("run", option, wrong, says=[option, wrong])
            self.assertLess(len(done.stderr), 200, done.stderr)
        self.refused("run", "--trials", "5", "--time", "1", says=["--time"])
        self.refused("check", self.folder / "none.jsonl", says=["none.jsonl"])
        self.refused("frobnicate", says=[])

    def test_addresses(self):
        for address, says in {
            "nonsense": ["SEED:NAME"],
            "1:nosuch:2:binary32:0:0": ["unknown family 'nosuch'"],
            "1:general:99:binary32:0:0": ["version 2", "99"],
            "1:general:2:binary33:0:0": ["binary33"],
            "1:general:2:binary32:0:65536": ["65536"],
            "1:general:2:binary32:-1:0": ["unit '-1'"],
            "1:mesh-00:1:binary32:0:0": ["--mesh FILE"],
        }.items():
            with self.subTest(address=address):
                self.refused("query", address, says=says)
        spider = MODELS / "OBJ/spider.obj"
        self.refused("query", "1:mesh-00:1:binary32:0:0", "--mesh", spider, says=["mesh-00"])

    def test_meshes(self):
        for model in ("invalid/empty.obj", "invalid/malformed.obj", "invalid/OutOfMemory.off", "OBJ/point_cloud.obj",
                      "nosuch.obj"):
            with self.subTest(model=model):
                out = self.folder / "out"
                done = self.refused("run", "--mesh", MODELS / model, "--out", out, says=[model])
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertFalse(out.exists(), "output was begun")

    def test_unwritable_output(self):
        blocked = self.folder / "file"
        blocked.write_text("not a folder")
        self.refused("run", "--family", "general", "--trials", 10, "--out", blocked / "out", says=["--out", "cannot write"])


if __name__ == "__main__":
    unittest.main()
