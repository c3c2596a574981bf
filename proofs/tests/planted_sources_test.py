#!/usr/bin/env python3
"""planted_sources_test.py CXX PROOFS_LIBRARY [unittest arguments]: a fault in a source of the proofs, a formula or a
claimed figure, passes through the recorder and is refused at the file that states it.

Each fault is one token of a source, in a copy that the compiler finds first. The recorder built from it writes its
own proofs. `--check` reports at once that the committed ones are not current; and if somebody wrote them again, the
checker would refuse them at the file named."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import prove

CXX, LIBRARY = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
PROOFS = pathlib.Path(__file__).resolve().parents[1]
ROOT = PROOFS.parent
COQ_BUILD = ROOT / "build" / "proofs" / "coq"


class PlantedSources(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = pathlib.Path(folder.name)

    def writer(self, source, old, new, unit):
        """write_proofs with `old` replaced by `new` in `source`, which translation unit `unit` includes or is."""
        text = (ROOT / source).read_text()
        self.assertEqual(text.count(old), 1, f"the fault finds '{old}' {text.count(old)} times in {source}")
        overlay = self.work / "overlay"
        (overlay / source).parent.mkdir(parents=True)
        (overlay / source).write_text(text.replace(old, new))
        planted = overlay / unit if source == unit else ROOT / unit
        # The unit's own definitions take precedence over those of the library.
        subprocess.run([CXX, "-std=c++20", "-O0", "-ffp-contract=off", "-I", overlay, "-I", ROOT, planted,
                        PROOFS / "emit" / "write_proofs.cpp", LIBRARY, "-lfmt", "-o", self.work / "write_proofs"], check=True)
        return self.work / "write_proofs"

    def stale(self, writer):
        """The committed files that differ from those that this recorder writes."""
        done = subprocess.run([writer, "--check", PROOFS], capture_output=True, text=True)
        self.assertEqual(done.returncode, 1, done.stderr)
        return {os.path.basename(line.split(": not what")[0]) for line in done.stderr.splitlines()}

    def written(self, writer):
        made = self.work / "tree" / "proofs"
        made.mkdir(parents=True)
        (self.work / "tree" / "kernel" / "sphere_triangle").mkdir(parents=True)
        subprocess.run([writer, made], check=True, stdout=subprocess.DEVNULL)
        return made

    def refused_by_coq(self, made, target):
        """The file at which the build of the theory with this Recorded.v stops, on the way to `target`."""
        theory = self.work / "coq"
        shutil.copytree(COQ_BUILD, theory)  # with times, so that only what depends on Recorded.v is built again
        (theory / "Recorded.v").write_bytes((made / "coq" / "Recorded.v").read_bytes())
        result = subprocess.run(["make", "--no-print-directory", target + "o"], cwd=theory, text=True, capture_output=True)
        self.assertNotEqual(result.returncode, 0, "the theory accepts it")
        return re.search(r'File "\./(\w+\.v)"', result.stderr).group(1)

    def formula(self, source, old, new, refused_at):
        writer = self.writer(source, old, new, "proofs/record.cpp")
        self.assertIn("Recorded.v", self.stale(writer))
        self.assertEqual(self.refused_by_coq(self.written(writer), refused_at), refused_at)

    def test_a_wrong_coefficient(self):
        self.formula("kernel/sphere_triangle/formulae.h", "A * e1 - AB * d1", "A * e1 + AB * d1", "RecordedIsSat7.v")

    def test_a_wrong_coefficient_in_the_reduced_form(self):
        self.formula("kernel/sphere_triangle/rungs/reduced.h", "emit(edge_ab_radius, dot(N1, N1), rr * dot(AB, AB))",
                     "emit(edge_ab_radius, dot(N1, N1), rr * dot(AB, BC))", "RecordedIsSat7.v")

    def test_a_swapped_comparison(self):
        self.formula("kernel/sphere_triangle/formulae.h", "emit(vertex_a_side_b, ab, aa)", "emit(vertex_a_side_b, aa, ab)",
                     "RecordedIsSat7.v")

    def test_another_order_of_operations(self):
        """Over the reals the formula is the same; the program of the rounding proofs differs."""
        self.formula("kernel/base/geometry.h", "(u.x * v.x + u.y * v.y) + u.z * v.z", "u.x * v.x + (u.y * v.y + u.z * v.z)",
                     "RecordedIsProgram.v")

    def test_a_bound_halved(self):
        writer = self.writer("proofs/bounds.cpp", "{1761, 1569}", "{880, 1569}", "proofs/bounds.cpp")
        script = "reduced_plain_edge_ab_radius.g"
        stale = self.stale(writer)
        self.assertLessEqual({"proved_bounds.h", script}, stale)
        self.assertNotIn("Recorded.v", stale)
        for made, accepted in ((PROOFS, True), (self.written(writer), False)):
            done = subprocess.run(["gappa", made / "gappa" / "binary32" / "scaled" / script], capture_output=True, text=True)
            self.assertEqual(done.returncode == 0, accepted, done.stderr)

    def test_a_range_too_narrow(self):
        row = '{Domain::scaled, "V",  true,  "-4",'
        writer = self.writer("proofs/ranges.cpp", row, row.replace("-4", "-3"),
                             "proofs/ranges.cpp")
        self.assertIn("RangesClaimed.v", self.stale(writer))
        made = self.written(writer) / "coq"
        shutil.copy(PROOFS / "coq" / "Ranges.v", made)
        for name, accepted in (("Ranges.v", True), ("RangesClaimed.v", False)):
            done = subprocess.run(["coqc", "-Q", ".", "Axiscert", name], cwd=made, capture_output=True, text=True)
            self.assertEqual(done.returncode == 0, accepted, done.stderr)
        self.assertIn("RangesClaimed.v", done.stderr)


if __name__ == "__main__":
    prove.copy_changed(prove.SOURCES, COQ_BUILD)
    prove.make(COQ_BUILD, 1)
    unittest.main(argv=[sys.argv[0], *sys.argv[3:]])
