#!/usr/bin/env python3
"""The formulae of kernel/ compile for a GPU as they are (cuda_program.cu); what nvcc's host compiler makes of the same functions answers as
the kernels of their names, bit for bit, which needs no GPU. Where nvcc is missing nothing is checked: exit code 77.

cuda_test.py AXISCERT [unittest arguments]
"""
import json
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
AXISCERT = Path(sys.argv.pop(1)).resolve()
SOURCE = ROOT / "kernel" / "gpu" / "cuda_program.cu"
NVCC = ["nvcc", "-std=c++20", "-O2", "-arch=sm_90", "--expt-relaxed-constexpr", f"-I{ROOT}", "-Xcompiler", "-ffp-contract=off", str(SOURCE)]


class Cuda(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.folder = Path(folder.name)
        done = subprocess.run([*NVCC, "-fmad=false", "-o", "program"], cwd=cls.folder, capture_output=True, text=True, timeout=900)
        assert done.returncode == 0, done.stderr
        cls.warnings = done.stderr

    def run_program(self, *words, **more):
        return subprocess.run([self.folder / "program", *words], cwd=self.folder, timeout=300, **more)

    def verdict(self, *words):
        """What a record of one kernel and family has on its verdicts."""
        done = subprocess.run([AXISCERT, *words, "--out", "out"], cwd=self.folder, capture_output=True, text=True, timeout=300)
        self.assertIn(done.returncode, (0, 1), done.stderr)
        [kernel] = json.loads((self.folder / "out" / "record.json").read_text())["kernels"]
        [family] = kernel["families"].values()
        kinds = ("false_separation", "false_contact", "deepest_false_separation", "deepest_false_contact", "undecided", "invalid")
        faults = [(family["verdict"][links] or {}).get("implementation", 0) for links in ("links", "masked_links")]
        return {kind: family["verdict"][kind] for kind in kinds}, faults

    def test_it_compiles_without_a_warning(self):
        self.assertEqual(self.warnings, "")

    def test_on_the_host_it_answers_as_the_kernels_of_these_names(self):
        kernels = re.findall(r'^    kernel<.*\("(.*)"\),$', SOURCE.read_text(), re.MULTILINE)
        self.assertEqual(len(kernels), 9)
        for id in kernels:
            family = {"moving-sphere": "moving-sphere/graze", "box-box": "box-box/tangent"}.get(id.split("/")[0], "tangent")
            for precision in ("binary32", "binary64"):
                with self.subTest(f"{id} {precision}"):
                    subprocess.run([AXISCERT, "generate", "--binary", "--family", family, "--trials", "2000", "--precision", precision, "-o", "queries"],
                                   cwd=self.folder, check=True)
                    with open(self.folder / "queries") as sent, open(self.folder / "replies", "w") as got:
                        self.assertEqual(self.run_program("--host", id, stdin=sent, stdout=got).returncode, 0)
                    # Where a kernel's order of operations is its own, its verdicts are compared.
                    conforms = [] if id in ("certified-filter", "moving-sphere/segment") else ["--conforms-to", id]
                    self.assertEqual(self.verdict("judge", "replies", "--may-decline", *conforms),
                                     self.verdict("run", "--kernel", id, "--family", family, "--trials", "2000", "--precision", precision))

    def test_without_a_device_or_a_kernel_it_says_so(self):
        done = self.run_program("nobody", capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("cuda_program [--host] KERNEL, one of: published", done.stderr)
        done = self.run_program("published", input=b"not a stream" * 10, capture_output=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn(b"is not a query stream of version 3", done.stderr)


if __name__ == "__main__":
    if shutil.which("nvcc") is None:
        print("NOT CHECKED: nvcc is not there", file=sys.stderr)
        sys.exit(77)
    unittest.main()
