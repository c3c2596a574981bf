#!/usr/bin/env python3
"""Absolute numbers in somebody's kernel: `--require logic` refuses each and names its size; right kernels are not refused."""
import re
import subprocess
import unittest

from command import BUILD, ROOT, Case, axiscert

# The number of each kernel in kernel/sphere_triangle/absolute; none for a control.
NUMBERS = {
    "clamped_radius": 0.01, "coarse_grid": 1e-4, "far_world": 1e6, "greatest_radius": 1000, "in_plane": 1e-7,
    "inside_epsilon": 1e-10, "least_area": 1e-8, "none": None, "none64": None, "short_edge": 1e-12,
    "slack_distance": 1e-5, "slack_squared": 1e-6, "strict_squared": 1e-6, "tiny_sphere": 1e-9,
}
FAMILIES = ("--family", "lattice", "--family", "units", "--family", "spans")
TRIALS = "12000"  # in every build: of fewer flips the size that is named is farther off


def sizes_in(text):
    """Every number that a message names, and its square."""
    return [float(number.replace(",", "")) for pair in re.findall(r"near (\S+) \(squared (\S+)\)", text) for number in pair]


class Units(Case):
    def judged(self, kernel, *options, families=FAMILIES):
        return axiscert("run", "--kernel", kernel, *families, "--trials", TRIALS, *options, "--out", self.folder / "out")

    def test_every_kernel_with_an_absolute_number_has_a_row(self):
        files = {path.stem for end in ("c", "cpp") for path in (ROOT / "kernel/sphere_triangle/absolute").glob(f"*.{end}")}
        self.assertEqual(files, set(NUMBERS), "NUMBERS of this file has a row for each file of absolute/")

    def test_logic_refuses_each_number_and_names_its_size(self):
        for name, number in NUMBERS.items():
            with self.subTest(kernel=name):
                done = self.judged(f"plugin:{BUILD}/absolute/{name}.so", "--require", "logic")
                if number is None:
                    self.assertEqual(done.returncode, 0, done.stderr)
                    continue
                self.assertEqual(done.returncode, 1, done.stderr)
                self.assertIn("another unit of length", done.stderr)
                named = sizes_in(done.stderr)
                self.assertTrue(any(number / 4 <= size <= number * 4 for size in named),
                                f"{number} is not named within a factor of 4 by {named}:\n{done.stderr}")

    def test_levels_of_invariance_are_asked_by_name(self):
        kernel = f"plugin:{BUILD}/absolute/clamped_radius.so"
        done = self.judged(kernel, "--require", "invariant=scale")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertRegex(done.stderr, r"times powers of two from 2\^-\d+ down")
        done = self.judged(kernel, "--require", "invariant=translation")
        self.assertEqual(done.returncode, 0, "it subtracts P first: " + done.stderr)
        done = self.judged(kernel, "--require", "invariant=order")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("NOT CHECKED", done.stderr)
        self.assertIn("--family orders", done.stderr)
        self.refused("run", "--kernel", kernel, "--require", "invariant=size", says=["order, axes, mirror, scale, translation"])

    def test_order_changes_the_roundings_of_a_right_kernel_which_logic_allows(self):
        kernel = f"plugin:{BUILD}/absolute/none.so"
        families = (*FAMILIES, "--family", "orders", "--family", "axes", "--family", "inverted")
        done = self.judged(kernel, "--require", "logic", "--require", "invariant=order", families=families)
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("its vertices in another order", done.stderr)
        self.assertNotIn("logic: not met", done.stdout + done.stderr)
        self.assertEqual(self.judged(kernel, "--require", "invariant=mirror", families=families).returncode, 0)

    def test_right_kernels_in_other_orders_and_precisions_are_not_refused(self):
        source = ROOT / "examples/plugin/my_kernel.c"
        # All that -ffast-math allows to the compiler; linked with it, a library would flush subnormal numbers too.
        reordered = ["-O3", "-fassociative-math", "-freciprocal-math", "-fno-signed-zeros", "-fno-trapping-math"]
        for name, flags in (("plain", ["-O2", "-ffp-contract=off"]), ("reordered", reordered),
                            ("fused", ["-O2", "-mfma", "-ffp-contract=fast"]),
                            ("wider", ["-O2", "-mfpmath=387"]), ("source", ["-O0"])):
            with self.subTest(form=name):
                made = self.folder / f"{name}.so"
                subprocess.run(["cc", *flags, "-shared", "-fPIC", "-I", ROOT / "kernel/include", source, "-o", made],
                               check=True)
                done = self.judged(f"plugin:{made}", "--require", "logic")
                self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
