#!/usr/bin/env python3
"""run --preset game, and levels of some families: what a game programmer asks first, and what is no answer."""
import json
import re
import subprocess
import unittest

from command import ROOT, Case, axiscert

SOURCE = (ROOT / "examples/plugin/c/my_kernel.c").read_text()
PREDICATES = ("sphere-triangle", "moving-sphere", "box-box", "box-triangle")


class Game(Case):
    def built(self, change=lambda text: text):
        source, file = self.folder / "mine.c", self.folder / "mine.so"
        source.write_text(change(SOURCE))
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", file], check=True)
        return f"plugin:{file}"

    def game(self, kernel, *more):
        return axiscert("run", "--kernel", kernel, "--preset", "game", "--trials", "4096", "--out", self.folder / "out", *more)

    def test_a_right_kernel_meets_it_in_ten_lines(self):
        done = self.game(self.built())
        self.assertEqual(done.returncode, 0, done.stderr)
        lines = done.stdout.splitlines()
        self.assertLessEqual(len(lines), 10, done.stdout)
        self.assertEqual(lines[-1], "verdict: met")
        self.assertRegex(lines[0], r"binary32: 8,192 everyday scenes: \d+ contacts? missed, worst [\d.]+ um, ")
        plan = json.loads((self.folder / "out/record.json").read_text())["plan"]
        self.assertEqual((plan["families"], plan["unit"], plan["require"]), (["scene-walk", "scene-edge"], "m", ["depth=1mm", "logic"]))

    def test_a_centimetre_is_said_and_refused(self):
        done = self.game(self.built(lambda text: text.replace("squared > r * r", "squared > (r + 0.01f) * (r + 0.01f)")))
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stdout, r"contacts invented, worst (9\.\d+ mm|1 cm), ")
        self.assertTrue(done.stdout.endswith("verdict: not met\n"), done.stdout)
        self.assertIn("depth=1mm: 8,192 of 8,192 promised queries looked at: not met", done.stderr)
        self.assertLessEqual(len((done.stdout + done.stderr).splitlines()), 10)

    def test_every_predicate_has_scenes(self):
        for predicate in PREDICATES:
            done = axiscert("run", "--predicate", predicate, "--preset", "game", "--trials", "64", "--out", self.folder / predicate)
            self.assertIn("everyday scenes", done.stdout, predicate)
            self.assertRegex(done.stdout, r"\nverdict: (not )?met\n$")

    def test_a_level_of_families_leaves_the_others_out(self):
        def of(level, *more):
            return axiscert("run", "--kernel", "published", "--family", "general", "--family", "lattice", "--trials", "2000", "--precision", "binary32",
                            "--require", level, "--out", self.folder / "out", *more)
        self.assertEqual(of("exact").returncode, 1)
        self.assertEqual(of("exact in gen*").returncode, 0)
        self.assertIn("covers 2,000 queries of general", of("exact in gen*").stdout)
        for level, says in (("exact in latice", "no family of this run matches 'latice'; did you mean 'lattice'?"),
                            ("exact in", "unknown requirement 'exact in'"),
                            ("depth=1furlong", "or a length in m, cm, mm, um, km, in, ft, as in depth=1mm")):
            refused = of(level)
            self.assertEqual((refused.returncode, says in refused.stderr), (2, True), refused.stderr)

    def test_the_unit_of_the_queries_is_that_of_lengths(self):
        kernel = self.built(lambda text: text.replace("squared > r * r", "squared > (r + 0.01f) * (r + 0.01f)"))
        for unit, code in (("m", 1), ("mm", 0)):
            done = self.game(kernel, "--unit", unit, "--require", "depth=1mm")
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        self.assertTrue(re.search(r"worst (9\.\d+|10) um", done.stdout), done.stdout)
        refused = self.game(kernel, "--unit", "mile")
        self.assertEqual(refused.returncode, 2)


if __name__ == "__main__":
    unittest.main()
