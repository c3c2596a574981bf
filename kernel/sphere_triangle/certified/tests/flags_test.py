#!/usr/bin/env python3
"""flags_test.py CXX SUITE: the library under flags that change arithmetic. `Refused`: what g++ tells by its macros does not
compile. `Checked`: what it does not tell, or was hidden from the sources here, is seen by the check of the first call."""
import pathlib
import subprocess
import sys
import tempfile
import unittest

CXX = sys.argv[1]
ROOT = pathlib.Path(__file__).resolve().parents[4]
FOLDER = ROOT / "kernel/sphere_triangle/certified"
SOURCES = ["exact_only.cpp", "exact_step.cpp", "forms.cpp", "library.cpp", "self_check.cpp",
           "contact_forms.cpp", "contact_library.cpp", "exact_contact.cpp"]
SENTENCE = "libaxiscert is right"
USER = """
#include "kernel/include/axiscert/certified.hpp"
int main() {
  const double triangle[] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, sphere[] = {0, 0, 0, 0.5}, one[] = {0, 0, 0, 1};
  if (axiscert::certified::pair(triangle, sphere) != AXISCERT_SEPARATED) return 3;
  if (axiscert::certified::pair(triangle, one) != AXISCERT_CONTACT) return 3;
  return axiscert::certified::passed_self_check() ? 0 : 1;
}
"""


class Refused(unittest.TestCase):
    def preprocessed(self, source, *flags):
        return subprocess.run([CXX, "-std=c++20", "-I", ROOT, *flags, "-E", "-o", "/dev/null", FOLDER / source], text=True, capture_output=True)

    def test_flags_that_the_compiler_tells(self):
        for flags in (["-ffast-math"], ["-Ofast"], ["-funsafe-math-optimizations"], ["-freciprocal-math"], ["-ffinite-math-only"],
                      ["-fno-signed-zeros"], ["-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math"], ["-mfpmath=387"]):
            done = self.preprocessed("exact_step.cpp", *flags)
            self.assertNotEqual(done.returncode, 0, flags)
            self.assertIn(SENTENCE, done.stderr)

    def test_every_source(self):
        for source in SOURCES:
            self.assertIn(SENTENCE, self.preprocessed(source, "-ffast-math").stderr, source)

    def test_flags_that_change_no_answer(self):
        for flags in (["-O3"], ["-frounding-math"], ["-fno-math-errno"], ["-fno-trapping-math"], ["-march=x86-64-v3"]):
            self.assertEqual(self.preprocessed("exact_step.cpp", *flags).returncode, 0, flags)

    def test_installed_headers_take_any(self):
        with tempfile.TemporaryDirectory() as folder:
            source = pathlib.Path(folder) / "user.cpp"
            source.write_text(USER)
            subprocess.run([CXX, "-std=c++17", "-Ofast", "-I", ROOT, "-fsyntax-only", source], check=True)


class Checked(unittest.TestCase):
    def user(self, *flags, without=("SSSE3", "SSE4", "AVX3", "AVX3_DL")):
        """A program with the library compiled with these flags, for few instruction sets: one takes half a minute."""
        hidden = ["-U__FAST_MATH__", "-U__FINITE_MATH_ONLY__", "-U__GCC_IEC_559"]
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        source, program = pathlib.Path(folder.name) / "user.cpp", pathlib.Path(folder.name) / "user"
        source.write_text(USER)
        subprocess.run([CXX, "-std=c++20", "-O2", "-w", "-I", ROOT,
                        f"-DHWY_DISABLED_TARGETS=({'|'.join('HWY_' + target for target in without)})", *hidden, *flags,
                        source, *(FOLDER / name for name in SOURCES), "-lhwy", "-o", program], check=True)
        return subprocess.run([program], text=True, capture_output=True)

    def test_as_it_is_built(self):
        self.assertEqual(self.user("-ffp-contract=off").returncode, 0)

    def test_contraction(self):
        self.assertEqual(self.user("-ffp-contract=fast").returncode, 1, "integers answer where the steps fail")

    def test_sums_in_another_order(self):
        done = self.user("-ffp-contract=off", "-fassociative-math", "-fno-signed-zeros", "-fno-trapping-math")
        self.assertEqual(done.returncode, 1, "integers answer where the steps fail")

    def test_x87(self):
        # Scalars alone: no step on vectors, and no integer, takes an instruction of x87.
        done = self.user("-ffp-contract=off", "-mfpmath=387", "-U__FLT_EVAL_METHOD__", "-D__FLT_EVAL_METHOD__=0",
                         without=("SSSE3", "SSE4", "AVX2", "AVX3", "AVX3_DL"))
        self.assertEqual(done.returncode, 1, "integers answer where the steps fail")

    def test_fast_math(self):
        done = self.user("-ffast-math")
        self.assertLess(done.returncode, 0, "integers fail too, as none is infinite any more")
        self.assertIn("libaxiscert: its exact step fails its own check", done.stderr)


if __name__ == "__main__":
    unittest.main(argv=[sys.argv[0], *sys.argv[2:]])
