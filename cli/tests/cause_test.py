#!/usr/bin/env python3
"""The cause of wrong verdicts, as `run` says it and record.json has it: of a kernel whose edge CA never separates, and of a right one."""
import json
import subprocess
import unittest

from command import ROOT, Case, axiscert


class Cause(Case):
    FAMILIES = [word for name in ("general", "ratio", "far") for word in ("--family", name)]

    def plugin(self, name):
        """A fault of kernel/sphere_triangle/faults of which the verdicts alone are seen."""
        made = self.folder / f"{name}.so"
        subprocess.run(["cc", "-O2", "-std=c11", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}", "-DEXPOSES=AXISCERT_VERDICT_ONLY",
                        ROOT / "kernel" / "sphere_triangle" / "faults" / f"{name}.c", "-o", made], check=True)
        return f"plugin:{made}"

    def asked(self, kernel):
        done = axiscert("run", "--kernel", kernel, *self.FAMILIES, "--trials", "4096", "--precision", "binary32", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        (entry,) = json.loads((self.folder / "out/record.json").read_text())["kernels"]
        return done.stdout, entry["cause"]

    def test_an_edge_that_never_separates_is_named_first(self):
        shown, cause = self.asked(self.plugin("dropped_axis"))
        self.assertTrue(cause["known"], cause)
        self.assertIn("edge_ca", cause["traits"])
        self.assertEqual(cause["direction"], "phantom")
        self.assertEqual((cause["witness"]["answered"], cause["witness"]["truth"]), ("contact", "separated"))
        self.assertGreaterEqual(2 * cause["explained"], cause["looked_at"])
        first = shown.splitlines()[0]
        self.assertIn("binary32: wrong on ", first)
        self.assertIn("nearest to edge ca", first)
        self.assertIn(cause["sentence"], (self.folder / "out/report.md").read_text().replace("\\", ""))

    def test_a_right_kernel_has_none(self):
        shown, cause = self.asked(self.plugin("none"))
        self.assertIsNone(cause)
        self.assertNotIn("wrong on", shown)


if __name__ == "__main__":
    unittest.main()
