#!/usr/bin/env python3
"""A change of one number beside a verdict, planted in a plug-in, is told by the levels, by compare and by a ratchet; a margin that
a plug-in declares is what its separations are judged by."""
import json
import re
import shutil
import unittest

from command import Case, axiscert
from closest_point import UPWARDS, built


class Numbers(Case):
    def asked(self, *args, families=("scene-walk",), trials=1500):
        return axiscert("run", *args, *(word for name in families for word in ("--family", name)), "--trials", trials,
                        "--precision", "binary32", "--out", self.folder / "out")

    # A margin that is added is what separations are less by: it has to be declared, and be that one on every query.
    MARGINS = {"keeps": ("0.005F", "0.005F", True), "gives the distance": ("0", "0.005F", True), "adds more": ("0.01F", "0.005F", False),
               "adds it now and then": ("p[0] > p[1] ? 0.005F : 0", "0.005F", False), "does not declare it": ("0.005F", None, False)}

    def test_a_declared_margin_is_what_separations_are_judged_by_and_contact_is_within_it(self):
        """All in one run: the truth about a query costs more than the kernels."""
        kernels = {built(self.folder, name.replace(" ", "-"), margin=margin, promised=declared): name
                   for name, (margin, declared, _) in self.MARGINS.items()}
        done = self.asked(*kernels, "--require", "separation=0.1mm", "--require", "keeps-margin")
        states = {(told["level"], kernels[told["kernel"]]): told["state"]
                  for told in json.loads((self.folder / "out/run.json").read_text())["requirements"]}
        report = (self.folder / "out/report.md").read_text()
        for kernel, name in kernels.items():
            _, declared, is_kept = self.MARGINS[name]
            with self.subTest(margin=name):
                self.assertEqual(states["separation=0.1mm", name] == "met", is_kept, done.stderr)
                self.assertEqual(states["keeps-margin", name] == "met", name in ("keeps", "adds more"), done.stderr)
                self.assertEqual(f"{kernel} binary32: keeps-margin: NOT CHECKED: the kernel declares no margin" in done.stderr, declared is None, done.stderr)
                self.assertEqual(f"\n- {kernel} in binary32 declares a margin of " in report, name in ("gives the distance", "adds it now and then"), report)

    def test_numbers_have_to_follow_exact_images(self):
        images = ("axes", "orders", "translated")
        kernels = {"contact": True, built(self.folder, "upwards", UPWARDS): False,
                   built(self.folder, "snapped", "point[0] = floorf(point[0] * 16) / 16"): False}
        done = self.asked(*kernels, "--require", "follows=0.001", families=images)
        told = json.loads((self.folder / "out/run.json").read_text())["requirements"]
        self.assertEqual({one["kernel"]: one["state"] == "met" for one in told}, kernels, done.stderr)
        for kernel, is_right in kernels.items():
            self.assertEqual(bool(re.search(rf"{kernel} .*of an image off by", done.stderr)), not is_right, done.stderr)
        for kernel, families, why in (("published", images, "the kernel gives no"), (built(self.folder, "mine"), ("general",), "--family orders")):
            done = self.asked(kernel, "--require", "follows=0.001", families=families)
            self.assertIn("NOT CHECKED", done.stdout + done.stderr)
            self.assertIn(why, done.stdout + done.stderr)

    def test_a_run_says_the_worst_separation_in_metres_and_flips(self):
        said = self.asked(built(self.folder, "mine", "*separation += 0.0032F")).stdout
        self.assertRegex(said, r"everyday scenes: .*; separations off by 3\.2\d* mm at most;.* no flip")
        said = self.asked(built(self.folder, "mine", "for (k = 0; k < 3; ++k) normal[k] = -normal[k]")).stdout
        self.assertRegex(said, r"everyday scenes: .*; [0-9,]+ flips")
        self.assertIn(" flips", (self.folder / "out/report.md").read_text())
        self.assertNotIn("separations off", self.asked("published").stdout)

    CHANGES = {"separation": "*separation += 0.001F", "normal": "normal[0] += 0.01F", "feature": "*feature = 6"}

    def accepted(self, *change):
        """The ratchet that accepts the plug-in with a change; its run is in before/."""
        before = self.asked(built(self.folder, "mine", *change))
        self.assertEqual(before.returncode, 0, before.stderr)
        (self.folder / "out").rename(self.folder / "before")
        accepted = self.folder / "accepted.txt"
        accepted.write_text((self.folder / "before/ratchet.txt").read_text().replace("EXPIRY OWNER REASON", "never geometry \"as it was\""))
        return accepted

    NONE = "*separation = *feature = normal[0] = normal[1] = normal[2] = point[0] = point[1] = point[2] = NAN"
    SILENT = {"wherever the two are apart": ("if (d > r) *separation += 0.01F", f"if (d > r) {NONE}"),
              "on the other side": (f"if (d > r) {{ *separation += 0.01F; if (p[0] > a[0]) {NONE}; }}", f"if (d > r && p[0] <= a[0]) {NONE}"),
              "where another verdict was mended": ("if (d > r) { *separation += 0.01F; if (p[0] > a[0]) d = r; }", f"if (d > r && p[0] <= a[0]) {NONE}")}

    def test_numbers_beside_other_answers_are_no_better(self):
        """A separation that is off is not mended by giving none there, and others in their place."""
        for where, (off, silent) in self.SILENT.items():
            with self.subTest(silent=where):
                accepted = self.accepted(off)
                held = self.asked(built(self.folder, "mine", silent), "--ratchet", accepted)
                self.assertEqual(held.returncode, 1, held.stdout + held.stderr)
                self.assertRegex(held.stderr, r"shows less than the ratchet: separation beside [0-9,]+ of [0-9,]+ answers `separated`, [0-9,]+ before; feature ")
                self.assertNotIn("separation.largest_error", held.stdout + held.stderr)
                compared = axiscert("compare", self.folder / "before", self.folder / "out", "--no-replay")
                self.assertEqual(compared.returncode, 1, compared.stdout + compared.stderr)
                self.assertRegex(compared.stdout, "NOT COMPARED: [^\n]*separation beside ")
                self.assertNotRegex(compared.stdout, "(better|fixed) .*scene-walk +separation")
                for folder in ("before", "out"):
                    shutil.rmtree(self.folder / folder)

    def test_compare_and_a_ratchet_tell_a_number_that_got_worse(self):
        accepted = self.accepted()
        again = self.asked(built(self.folder, "mine"), "--ratchet", accepted)
        self.assertEqual(again.returncode, 0, again.stderr)
        for place, change in self.CHANGES.items():
            with self.subTest(place=place):
                held = self.asked(built(self.folder, "mine", change), "--ratchet", accepted)
                self.assertEqual(held.returncode, 1, held.stdout + held.stderr)
                self.assertIn(place, held.stderr)
                compared = axiscert("compare", self.folder / "before", self.folder / "out")
                self.assertEqual(compared.returncode, 1, compared.stdout + compared.stderr)
                self.assertRegex(compared.stdout, rf"(worse|new) .*scene-walk +{place}\.")


if __name__ == "__main__":
    unittest.main()
