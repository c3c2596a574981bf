#!/usr/bin/env python3
"""thresholds_test.py: the exported headers of kernel/sphere_triangle/forms have the figures of the Coq theory, and a
changed figure is reported for the right one. Coq checks Exported.v, which is made of the same figures."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

PROOFS = pathlib.Path(__file__).resolve().parents[1]
HEADERS = PROOFS.parent / "kernel" / "sphere_triangle" / "forms"


def check(coq, headers):
    return subprocess.run([sys.executable, PROOFS / "write_thresholds.py", "--check", "--coq", coq, "--headers", headers],
                          capture_output=True, text=True)


class Thresholds(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)
        self.coq = pathlib.Path(self.folder.name)
        shutil.copytree(PROOFS / "coq", self.coq, dirs_exist_ok=True)
        for name in ("filter_thresholds.h", "margin_bounds.h"):
            shutil.copy(HEADERS / name, self.coq)

    def replace(self, file, old, new):
        path, = self.coq.rglob(file)
        text = path.read_text()
        self.assertIn(old, text)
        path.write_text(text.replace(old, new))

    def test_what_is_committed_is_current(self):
        done = check(PROOFS / "coq", HEADERS)
        self.assertEqual((done.returncode, done.stderr), (0, ""))

    def test_a_changed_figure_is_seen_at_its_file(self):
        for file, old, new, stale in (
                ("filter_thresholds.h", "{2642, 6}", "{2641, 6}", {"filter_thresholds.h"}),
                ("filter_thresholds.h", "0x1p19", "0x1p20", {"filter_thresholds.h"}),
                ("Thresholds.v", "=> 13240", "=> 6620", {"filter_thresholds.h"}),
                ("Filters.v", "8388608 (-42)", "8388608 (-43)", {"filter_thresholds.h"}),
                ("margin_bounds.h", "= 15;", "= 14;", {"margin_bounds.h"}),
                ("Margins.v", ": R := 3.2.", ": R := 3.3.", {"margin_bounds.h"}),
                ("Certified.v", ": R := 20.1875.", ": R := 20.", {"margin_bounds.h"}),
                ("CoarseFloat.v", "53 1024 (-300) 150", "53 1024 (-300) 151", {"margin_bounds.h"}),
                ("Conservative.v", ": R := 19.125.", ": R := 19.", {"margin_bounds.h"}),
                ("ConservativeStep.v", "(-42) (-60)", "(-42) (-61)", {"margin_bounds.h"})):
            with self.subTest(file=file, new=new):
                self.setUp()
                self.replace(file, old, new)
                done = check(self.coq, self.coq)
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertEqual({name for name in ("filter_thresholds.h", "margin_bounds.h") if f"{name} is not current" in done.stderr}, stale)

    def test_a_theory_of_another_shape_is_refused(self):
        for file, old, new, says in (
                ("Thresholds.v", "=> 2642", "=> 2642 + 1", "2642 + 1"),
                ("Thresholds.v", "  | plane_radius => 2642\n", "", "plane_radius"),
                ("Margins.v", " : R := ", " : R := 1 * ", "Margins.v"),
                ("CertifiedStep.v", "24 (-149) (-21)", "24 (-149) l", "coarse_never_lies 24 (-149)"),
                ("CertifiedStep.v", "53 (-1074) (-300)", "53 (-1074) (-301)", "binary64"),
                ("Filters.v", "8388608 (-42)", "8388609 (-42)", "8388609")):
            with self.subTest(new=new):
                self.setUp()
                self.replace(file, old, new)
                done = check(self.coq, self.coq)
                self.assertEqual(done.returncode, 2, done.stderr)
                self.assertIn(says, done.stderr)


if __name__ == "__main__":
    unittest.main()
