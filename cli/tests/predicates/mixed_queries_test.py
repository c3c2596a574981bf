#!/usr/bin/env python3
"""Query files with queries of several predicates: each part is judged by the kernels of its own predicate and entry."""
import json
import unittest

from command import Case, axiscert

PARTS = {"sphere-triangle": ("tie", 3), "box-box": ("box-box/stacked", 2), "box-box-quaternion": ("box-box/crossed_turned", 2)}
SAYS = "3 queries of sphere-triangle, 2 of box-box, 2 of box-box, entry quaternion"


class MixedQueries(Case):
    def setUp(self):
        super().setUp()
        lines = {part: axiscert("generate", "--family", family, "--trials", count).stdout for part, (family, count) in PARTS.items()}
        self.lines = lines
        self.file = self.folder / "mixed.jsonl"
        # Not one part after the other.
        self.file.write_text(lines["sphere-triangle"] + lines["box-box-quaternion"] + lines["box-box"])
        self.file.write_text("".join(sorted(self.file.read_text().splitlines(True), key=lambda line: ("predicate" in line, '"q"' in line))))

    def test_a_run_judges_each_part_in_a_folder_of_its_own(self):
        done = axiscert("run", "--queries", self.file, "--precision", "binary32", "--require", "exact", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn(f"axiscert: {self.file}: {SAYS}\n", done.stderr)
        wrong = 0
        for part, (_, count) in PARTS.items():
            record = json.loads((self.folder / "out" / part / "record.json").read_text())
            self.assertEqual([file["queries"] for file in record["plan"]["files"]], [count])
            (kernel,) = record["kernels"]
            apart = self.folder / f"{part}.jsonl"
            apart.write_text(self.lines[part])
            alone = self.run_ok("--queries", apart, "--kernel", kernel["id"], "--precision", "binary32", out=f"{part}-alone")
            self.assertEqual(list(alone["kernels"][0]["families"].values())[0]["verdict"], list(kernel["families"].values())[0]["verdict"])
            for witness in record["witnesses"]:
                again = axiscert("query", witness["address"], "--queries", self.file)
                self.assertEqual(again.returncode, 0, again.stderr)
                self.assertIn(json.loads(again.stdout) | {"id": ""}, [json.loads(line) | {"id": ""} for line in self.lines[part].splitlines()])
                wrong += 1
        self.assertGreater(wrong, 0)
        # The level holds on each part: the first two meet it.
        self.assertEqual(done.stdout.count(" exact: "), 2)
        self.assertEqual(done.stderr.count("exact: 2 of 2 promised queries looked at: not met"), 1)

    def test_kernels_are_given_for_each_part_or_for_none(self):
        self.refused("run", "published", "--queries", self.file, says=["no kernel is given for the queries of box-box", SAYS])
        self.refused("run", "moving-sphere/gated", "--queries", self.file, says=["--kernel moving-sphere/gated: it is of moving-sphere", SAYS])
        for option in (("--family", "tie"), ("--preset", "ci"), ("--format", "csv"), ("--ratchet", "r.txt"), ("--corpus",)):
            self.refused("run", "--queries", self.file, *option, says=[option[0], "is of one predicate, and the queries are of 3; choose one with --predicate"])
        self.assertFalse((self.folder / "out").exists())
        done = axiscert("run", "certified", "box-box/rtcd", "box-box/rtcd-turned", "--queries", "-", "--quiet", "--out", self.folder / "out", stdin=self.file.read_text())
        self.assertEqual((done.returncode, done.stderr), (0, f"axiscert: stdin: {SAYS}\n"))
        self.assertEqual(json.loads((self.folder / "out/box-box/record.json").read_text())["plan"]["kernels"], ["box-box/rtcd"])

    def test_a_predicate_chooses_its_part(self):
        for command in ("run", "plan"):
            out = ("--out", self.folder / "one") if command == "run" else ("-o", self.folder / "plan.json")
            done = axiscert(command, "--queries", self.file, "--predicate", "sphere-triangle", *out)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("are taken", done.stderr)
        self.refused("plan", "--queries", self.file, says=[SAYS, "choose one with --predicate"])
        self.refused("generate", "--queries", self.file, says=[SAYS])

    def test_check_and_shrink_ask_the_kernel_of_each_query(self):
        for given, names in (((), ("published", "box-box/projected", "box-box/projected-turned")),
                             (("certified", "box-box/rtcd-turned", "box-box/rtcd"), ("certified", "box-box/rtcd", "box-box/rtcd-turned"))):
            done = axiscert("check", self.file, *given)
            self.assertEqual((done.returncode, done.stderr), (0, f"axiscert: {self.file}: {SAYS}\n"))
            for name, count in zip(names, (3, 2, 2), strict=True):
                self.assertEqual(done.stdout.count(f" {name} "), count, done.stdout)
        self.refused("check", self.file, "published", says=[SAYS, "kernel published of sphere-triangle"])
        self.refused("check", self.file, "published", "box-box/rtcd", says=[SAYS, "of box-box, entry quaternion, and no kernel of it is given"])
        self.refused("check", self.file, "published", "nonstrict", says=["--kernel published and nonstrict: the queries of a file are judged by one kernel of their predicate"])
        done = axiscert("shrink", self.file, "--evaluations", 200, "--format", "jsonl")
        shrunk = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertLessEqual({"box-box/projected", "box-box/projected-turned"}, {line["kernel"] for line in shrunk})

    def test_critical_radii_of_a_file(self):
        apart = self.folder / "ties.jsonl"
        apart.write_text(self.lines["sphere-triangle"])
        one = json.loads(axiscert("critical-radius", "published", "--queries", apart, "--format", "json").stdout)
        self.assertEqual([(row["kernel"], row["family"], row["measured"]) for row in one["rows"]], [("published", "queries/ties.jsonl", 3)])
        both = json.loads(axiscert("critical-radius", "published", "--queries", apart, "--family", "tie", "--trials", 5, "--format", "json").stdout)
        self.assertEqual([row["measured"] for row in both["rows"]], [5, 3])
        done = axiscert("critical-radius", "--queries", self.file, "published", "box-box/rtcd", "box-box/rtcd-turned", "--out", self.folder / "radii")
        self.assertIn(f"axiscert: {self.file}: {SAYS}\n", done.stderr)
        self.assertEqual(done.returncode, int("Nothing was measured of" in done.stdout))
        for part in PARTS:
            rows = json.loads((self.folder / "radii" / part / "critical-radius.json").read_text())["rows"]
            self.assertTrue(rows and all(row["family"] == "queries/mixed.jsonl" for row in rows))


if __name__ == "__main__":
    unittest.main()
