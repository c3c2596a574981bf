#!/usr/bin/env python3
"""A slack of a user's kernel: run names it, the level no-slack refuses it, diagnose has it as a property."""
import json
import subprocess
import unittest

from command import ROOT, Case, axiscert

PLAN = ["--family", "general", "--trials", "2000", "--precision", "binary32"]
SOURCE = (ROOT / "examples/plugin/my_kernel.c").read_text()
COMPARISON = "return squared > r * r ?"
assert COMPARISON in SOURCE


class Slack(Case):
    def built(self, skin):
        """A kernel that calls spheres contacts as if r were r (1 + skin)."""
        return self.with_radius(f"r + r * {skin}f")

    def with_radius(self, grown):
        file, source = self.folder / "my_kernel.so", self.folder / "my_kernel.c"
        source.write_text(SOURCE.replace(COMPARISON, f"const float grown = {grown}; return squared > grown * grown ?"))
        subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", file], check=True)
        return f"plugin:{file}"

    def test_a_slack_is_named_with_its_size_by_run_and_its_level(self):
        out = self.folder / "out"
        done = axiscert("run", "--kernel", self.built("1e-3"), *PLAN, "--require", "no-slack=1e-4", "--out", out)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stdout, r"a slack: contact comes too early by 0\.001 of r on \d+ of \d+ queries nearest to any feature")
        slack = json.loads((out / "record.json").read_text())["kernels"][0]["slack"]
        self.assertEqual((slack["found"][0]["kind"], slack["found"][0]["to"], slack["found"][0]["side"]), ("relative", "r", "early"))
        self.assertIn("no-slack=1e-4", (out / "junit.xml").read_text())

    def test_a_least_radius_is_an_absolute_number_that_is_said_before_the_class(self):
        families = ["--family", "units", "--family", "general", "--trials", "8192", "--precision", "binary32"]
        done = axiscert("run", "--kernel", self.with_radius("r < 0.01f ? 0.01f : r"), *families, "--out", self.folder / "out")
        self.assertRegex(done.stdout.splitlines()[0], r"binary32: as if an absolute number near 0\.0[01]\S+ \(squared \S+\) were compared with \S+.*; wrong on ")

    def test_a_right_kernel_meets_the_level_and_is_told_what_would_be_seen(self):
        done = axiscert("run", "--kernel", "published", *PLAN, "--require", "no-slack=1e-2", "--require", "no-slack=1e-3")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("published binary32: no-slack=1e-2: met", done.stdout)
        # A slack may be in one branch alone: the kinds of queries that would not show it are named.
        self.assertRegex(done.stderr, r"no-slack=1e-3: NOT CHECKED: the least slack that would be seen is \S+ of a length on queries be")

    def test_a_kernel_that_is_far_off_does_not_meet_the_level(self):
        done = axiscert("run", "--kernel", self.built("1e-1"), *PLAN, "--require", "no-slack=1e-2")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("no-slack=1e-2: not met", done.stderr)

    def test_a_diagnosis_has_it_as_a_property(self):
        done = axiscert("diagnose", self.built("1e-3"), "--format", "json")
        slack = next(p for p in json.loads(done.stdout)["properties"] if p["name"] == "slack")
        self.assertEqual(slack["value"], "early")
        self.assertIn("contact comes too early by 0.001 of r", slack["sentence"])

    def test_a_size_is_a_part_or_a_length(self):
        self.refused("run", *PLAN, "--require", "no-slack=1parsec", says=["no-slack=1parsec", "1e-4", "1mm"])
        self.refused("run", *PLAN, "--require", "no-slack", says=["no-slack=SIZE"])


if __name__ == "__main__":
    unittest.main()
