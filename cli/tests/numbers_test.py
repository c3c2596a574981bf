#!/usr/bin/env python3
"""A change of one number beside a verdict, planted in a plug-in, is told by the levels, by compare, by a ratchet and by a certificate; a margin that
a plug-in declares is what its separations are judged by."""
import json
import subprocess
import unittest

from command import BUILD, ROOT, Case, axiscert
from certificates import CertifyCase

# The closest point by the region it is in (C. Ericson, Real-Time Collision Detection, 5.1.5), in double. MARGIN is added to the sphere, and CHANGE is
# what is done to the numbers.
PLUGIN = r"""
#include <axiscert/plugin.h>
#include <math.h>
static double dot(const double *u, const double *v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
static int part(const double *ab, const double *ac, const double *ap, const double *bp, const double *cp, double *v, double *w) {
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp), d6 = dot(ac, cp);
  const double vc = d1 * d4 - d3 * d2, vb = d5 * d2 - d1 * d6, va = d3 * d6 - d5 * d4;
  *v = *w = 0;
  if (d1 <= 0 && d2 <= 0) return 0;
  if (d3 >= 0 && d4 <= d3) { *v = 1; return 1; }
  if (vc <= 0 && d1 >= 0 && d3 <= 0) { *v = d1 / (d1 - d3); return 3; }
  if (d6 >= 0 && d5 <= d6) { *w = 1; return 2; }
  if (vb <= 0 && d2 >= 0 && d6 <= 0) { *w = d2 / (d2 - d6); return 5; }
  if (va <= 0 && d4 >= d3 && d5 >= d6) { *w = (d4 - d3) / ((d4 - d3) + (d5 - d6)); *v = 1 - *w; return 4; }
  *v = vb / (va + vb + vc); *w = vc / (va + vb + vc);
  return 6;
}
static int mine(const float *a, const float *b, const float *c, const float *p, float r, float *separation, float *feature, float *normal,
                float *point) {
  double ab[3], ac[3], ap[3], bp[3], cp[3], n[3], v, w, d;
  float added = MARGIN;
  int k, where;
  for (k = 0; k < 3; ++k) {
    ab[k] = (double)b[k] - a[k]; ac[k] = (double)c[k] - a[k];
    ap[k] = (double)p[k] - a[k]; bp[k] = (double)p[k] - b[k]; cp[k] = (double)p[k] - c[k];
  }
  where = part(ab, ac, ap, bp, cp, &v, &w);
  for (k = 0; k < 3; ++k) n[k] = ap[k] - v * ab[k] - w * ac[k];
  d = sqrt(dot(n, n));
  for (k = 0; k < 3; ++k) {
    normal[k] = d > 0 ? (float)(n[k] / d) : 0;
    point[k] = (float)(p[k] - n[k]);
  }
  *feature = (float)where;
  *separation = (float)(d - r - added);
  CHANGE;
  return d <= (double)r + added ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
}
static const axiscert_limits kept = {sizeof(axiscert_limits), 0, 0, 0, 0, 0, PROMISED};
AXISCERT_PLUGIN_OF(float, "mine", mine, TRIANGLE, vertices, all, DECLARED)
"""
UPWARDS = "if (normal[2] < 0) for (k = 0; k < 3; ++k) normal[k] = -normal[k]"


def built(folder, name, change="(void)0", margin="0", promised=None):
    source, made = folder / f"{name}.c", folder / f"{name}.so"
    source.write_text(PLUGIN.replace("CHANGE", change).replace("MARGIN", margin).replace("PROMISED", promised or "0")
                      .replace("DECLARED", "AXISCERT_DECLARE(limits, &kept)" if promised else ""))
    subprocess.run(["cc", "-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", made, "-lm"], check=True)
    return f"plugin:{made}"


def refused_levels(done):
    return {line.split("not met: ")[1].split("=")[0].split(";")[0].split(",")[0] for line in done.stderr.splitlines() if ": not met: " in line}


class Numbers(Case):
    def asked(self, kernel, *args, families=("scene-walk",), trials=1500):
        return axiscert("run", "--kernel", kernel, *(word for name in families for word in ("--family", name)), "--trials", trials,
                        "--precision", "binary32", "--out", self.folder / "out", *args)

    def met(self, kernel, level, **plan):
        done = self.asked(kernel, "--require", level, **plan)
        self.assertIn(done.returncode, (0, 1, 4), done.stderr)
        return done.returncode == 0, done.stdout + done.stderr

    # A margin that is added is what separations are less by: it has to be declared, and be that one on every query.
    MARGINS = {"keeps": ("0.005F", "0.005F", True), "gives the distance": ("0", "0.005F", True), "adds more": ("0.01F", "0.005F", False),
               "adds it now and then": ("p[0] > p[1] ? 0.005F : 0", "0.005F", False), "does not declare it": ("0.005F", None, False)}

    def test_a_declared_margin_is_what_separations_are_judged_by(self):
        for name, (margin, declared, is_kept) in self.MARGINS.items():
            with self.subTest(margin=name):
                met, said = self.met(built(self.folder, "mine", margin=margin, promised=declared), "separation=0.1mm")
                self.assertEqual(met, is_kept, said)

    def test_numbers_have_to_follow_exact_images(self):
        images = ("axes", "orders", "translated")
        for kernel, is_right in (("contact", True), (built(self.folder, "upwards", UPWARDS), False),
                                 (built(self.folder, "snapped", "point[0] = floorf(point[0] * 16) / 16"), False)):
            with self.subTest(kernel=kernel):
                met, said = self.met(kernel, "follows=0.001", families=images)
                self.assertEqual(met, is_right, said)
                if not is_right:
                    self.assertIn("of an image off by", said)
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

    def test_compare_and_a_ratchet_tell_a_number_that_got_worse(self):
        before = self.asked(built(self.folder, "mine"))
        self.assertEqual(before.returncode, 0, before.stderr)
        (self.folder / "out").rename(self.folder / "before")
        accepted = self.folder / "accepted.txt"
        accepted.write_text((self.folder / "before/ratchet.txt").read_text().replace("EXPIRY OWNER REASON", "never geometry \"as it was\""))
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


class NumbersCertified(CertifyCase):
    def levels_of(self, kernel, name):
        predicate = json.loads(self.certificate_of(kernel, name=name).read_text())["predicate"]
        return {level["level"]: level["state"] for level in predicate["levels"]}

    def test_a_certificate_is_of_the_numbers_too(self):
        kernel = built(self.folder, "mine")
        good = self.levels_of(kernel, "good")
        bad = self.levels_of(built(self.folder, "changed", "*separation *= 1.02F"), "bad")
        self.assertEqual({name for name, state in good.items() if bad.get(name) != state and state == "met"}, {"separation=0.001"}, f"{good}\n{bad}")
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", kernel)
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", built(self.folder, "mine", "*separation *= 1.02F"), code=1)


if __name__ == "__main__":
    unittest.main()
