#!/usr/bin/env python3
"""run --preset game, and levels of some families: what a game programmer asks first, and what is no answer."""
import json
import re
import subprocess
import unittest

from command import ROOT, Case, axiscert

SOURCE = (ROOT / "examples/plugin/my_kernel.c").read_text()
# A motion's first time by bisection of its distance from the triangle, late by a centimetre of the way.
LATE = """
#include "axiscert/plugin.h"
#include <math.h>
typedef struct { double x, y, z; } vec;
static vec add(vec u, vec v, double s) { vec w = {u.x + s * v.x, u.y + s * v.y, u.z + s * v.z}; return w; }
static double dot(vec u, vec v) { return u.x * v.x + u.y * v.y + u.z * v.z; }
static vec cross(vec u, vec v) { vec w = {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x}; return w; }
static double from_edge(vec p, vec a, vec b) {
  vec e = add(b, a, -1), to = add(p, a, -1);
  double s = dot(e, e) > 0 ? dot(to, e) / dot(e, e) : 0;
  to = add(to, e, -(s < 0 ? 0 : s > 1 ? 1 : s));
  return sqrt(dot(to, to));
}
static double distance(vec p, const vec *t) {
  vec n = cross(add(t[1], t[0], -1), add(t[2], t[0], -1));
  double least = HUGE_VAL;
  int k, inside = dot(n, n) > 0;
  for (k = 0; k < 3; ++k) {
    double d = from_edge(p, t[k], t[(k + 1) % 3]);
    if (d < least) least = d;
    if (dot(cross(add(t[(k + 1) % 3], t[k], -1), add(p, t[k], -1)), n) < 0) inside = 0;
  }
  return inside ? fabs(dot(add(p, t[0], -1), n)) / sqrt(dot(n, n)) : least;
}
static vec of(const float *v) { vec w = {v[0], v[1], v[2]}; return w; }
static int f(const float a[3], const float b[3], const float c[3], const float p[3], const float d[3], float r, float *time) {
  vec t[3] = {of(a), of(b), of(c)}, at = of(p), by = of(d);
  double low = 0, high = 1, least;
  int k;
  for (k = 0; k < 200; ++k) {
    double s = low + (high - low) / 3, u = high - (high - low) / 3;
    if (distance(add(at, by, s), t) < distance(add(at, by, u), t)) high = u; else low = s;
  }
  least = high;
  if (distance(add(at, by, least), t) > r && distance(at, t) > r) return AXISCERT_SEPARATED;
  for (low = 0, high = least, k = 0; k < 60; ++k) {
    double s = (low + high) / 2;
    if (distance(add(at, by, s), t) > r) low = s; else high = s;
  }
  high = distance(at, t) <= r ? 0 : high;
  *time = (float)fmin(1, high + 0.01 / sqrt(dot(by, by)));
  return AXISCERT_CONTACT;
}
AXISCERT_MOTION_PLUGIN(float, "late", f, displacement, time)
"""
UNTIMED = LATE.replace(", float *time)", ")").replace("displacement, time", "displacement, none").replace("  *time = (float)fmin(1, high + 0.01 / sqrt(dot(by, by)));\n", "")
PREDICATES = ("sphere-triangle", "moving-sphere", "box-box", "box-triangle", "capsule-triangle")


class Game(Case):
    def built(self, change=lambda text: text):
        source, file = self.folder / "mine.c", self.folder / "mine.so"
        source.write_text(change(SOURCE))
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", file, "-lm"], check=True)
        return f"plugin:{file}"

    def game(self, *kernels_and_more, trials=4096):
        return axiscert("run", *kernels_and_more, "--preset", "game", "--trials", trials, "--out", self.folder / "out")

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
        self.assertRegex(done.stderr, r"^axiscert: --require: plugin:\S+: not met: depth=1mm, logic; most on scene-edge: [0-9,]+ phantom contacts\n$")
        self.assertLessEqual(len((done.stdout + done.stderr).splitlines()), 10)

    def test_two_precisions_are_ten_lines_too(self):
        for kernel in ("published", "minkowski", "moving-sphere/fauerby", "moving-sphere/rounded", "box-box/slip-book", "box-triangle/thirteen"):
            done = self.game(kernel, trials=512)
            printed = (done.stdout + done.stderr).splitlines()
            self.assertLessEqual(len(printed), 10, done.stdout + done.stderr)
            for precision in ("binary32", "binary64"):
                self.assertRegex(done.stdout, rf"\n?{kernel} .*{precision}.*: [0-9,]+ everyday scenes: ")
            self.assertEqual(len([line for line in printed if "in other units: " in line]), 1, printed)
            self.assertEqual(len([line for line in printed if ": met: " in line or ": not met: " in line]), 1 + (": not met: " in done.stderr and ": met: " in done.stdout))

    def test_times_are_held_to_a_millimetre_where_there_are_some(self):
        done = self.game("moving-sphere/rounded", trials=96)
        self.assertRegex(done.stdout, r"everyday scenes: .*; [0-9,]+ times late, by \S+ \S+ at most, \S+ of the way; [0-9,]+ times early, by \S+ \S+ at most")
        plan = json.loads((self.folder / "out/record.json").read_text())["plan"]
        self.assertEqual(plan["require"], ["depth=1mm", "logic", "early=1mm", "never-late=1mm"])
        late = self.built(lambda _: LATE)
        done = self.game(late, trials=512)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"times late, by (9\.\d+ mm|1 cm|1\.0\d cm) at most")
        self.assertRegex(done.stderr, r": not met: .*never-late=1mm")
        self.assertNotIn("early=1mm", done.stderr)
        untimed = self.game("moving-sphere/rounded", self.built(lambda _: UNTIMED), "--precision", "binary32", trials=32)
        self.assertIn("NOT CHECKED, which is allowed: early=1mm, never-late=1mm: the kernel gives no time of contact\n", untimed.stdout)

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
                            ("exact in", "requirement 'exact in': name families after `in`"),
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
