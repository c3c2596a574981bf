#!/usr/bin/env python3
"""`axiscert league --contacts`: a plug-in that is right in double, and the same with one number planted wrong, are told apart in words and figures."""
import json
import os
import subprocess
import unittest

import jsonschema

from command import Case, ROOT, axiscert, schema_of

SOURCE = r"""
#include <axiscert/plugin.h>
#include <math.h>
typedef double vec[3];
static void sub(const double* u, const double* v, vec w) { for (int k = 0; k < 3; ++k) w[k] = u[k] - v[k]; }
static double dot(const double* u, const double* v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
static void cross(const double* u, const double* v, vec w) {
  for (int k = 0; k < 3; ++k) w[k] = u[(k + 1) % 3] * v[(k + 2) % 3] - u[(k + 2) % 3] * v[(k + 1) % 3];
}
static int right(const float* a, const float* b, const float* c, const float* p, float r, float* separation, float* feature, float normal[3], float point[3]) {
  vec corner[3], best, way;
  const float* given[3] = {a, b, c};
  double least = INFINITY;
  for (int i = 0; i < 3; ++i) for (int k = 0; k < 3; ++k) corner[i][k] = (double)given[i][k] - p[k]; /* seen from the centre */
  int part = -1;
  for (int i = 0; i < 3; ++i) {
    if (dot(corner[i], corner[i]) < least) { least = dot(corner[i], corner[i]); part = i; for (int k = 0; k < 3; ++k) best[k] = corner[i][k]; }
  }
  vec face, e1, e2;
  int inside = 1;
  sub(corner[1], corner[0], e1);
  sub(corner[2], corner[0], e2);
  cross(e1, e2, face);
  for (int i = 0; i < 3; ++i) {
    vec edge, side, foot;
    sub(corner[(i + 1) % 3], corner[i], edge);
    const double whole = dot(edge, edge), t = -dot(corner[i], edge) / whole;
    cross(edge, face, side);
    if (dot(side, corner[i]) < 0) inside = 0;
    if (!(t > 0 && t < 1)) continue;
    for (int k = 0; k < 3; ++k) foot[k] = corner[i][k] + t * edge[k];
    if (dot(foot, foot) < least) { least = dot(foot, foot); part = 3 + i; for (int k = 0; k < 3; ++k) best[k] = foot[k]; }
  }
  if (inside && dot(face, face) > 0) {
    const double h = dot(corner[0], face) / dot(face, face);
    part = 6;
    for (int k = 0; k < 3; ++k) best[k] = h * face[k];
    least = dot(best, best);
  }
  const double d = sqrt(least);
  for (int k = 0; k < 3; ++k) { way[k] = d > 0 ? -best[k] / d : 0; normal[k] = (float)way[k]; point[k] = (float)(p[k] + best[k]); }
  *separation = (float)(d - r);
  *feature = (float)part;
  return d > r;
}
static int wrong(const float* a, const float* b, const float* c, const float* p, float r, float* separation, float* feature, float normal[3], float point[3]) {
  const int verdict = right(a, b, c, p, r, separation, feature, normal, point);
  PLANTED;
  return verdict;
}
AXISCERT_CONTACT_PLUGIN(float, "planted", wrong, all)
"""

# What is planted, and the words of its column: (column, words, whether the cell has to have them).
EACH = "for (int k = 0; k < 3; ++k)"
PLANTED = {
    "(void)0": (("separation", "off by up to 0 ", False), ("flips", "none of ", True), ("contradictions", "none", True)),
    "*separation *= 0.5f": (("separation", " cm on scenes", True), ("flips", "none of ", True)),
    "*separation = fabsf(*separation)": (("contradictions", " contacts with a separation above 0", True),),
    f"{EACH} normal[k] = -normal[k]": (("flips", "none of ", False), ("flips", "leaves up to 2 of the depth", True), ("normals", "tilted by up to 180 degrees on scenes", True)),
    "normal[0] += 0.1f": (("flips", "none of ", True), ("normals", "length off by up to 0.1", True)),
    f"{EACH} normal[k] = NAN": (("flips", "not given", True), ("normals", "not given", True), ("contradictions", "answers without one of their numbers", True)),
    "*feature = *feature < 6 ? 6 : 0": (("features", "none of ", False), ("points", "not given", False)),
    "*feature = NAN": (("features", "not given", True), ("contradictions", "none", True)),
    f"{EACH} point[k] = p[k]": (("points", " of the scene on scenes", True), ("separation", "not given", False)),
    f"*separation = NAN; {EACH} point[k] = normal[k] = NAN; *feature = NAN": (("separation", "not given", True), ("points", "not given", True), ("contradictions", "-", True)),
}
COLUMNS = ("looked at", "separation", "contradictions", "flips", "normals", "features", "points")
ASKED = ("league", "--contacts", "--trials", "64", "--precision", "binary32", "--family", "scene-walk", "--family", "scene-edge")


class LeagueContacts(Case):
    def planted(self, number, fault):
        source, library = self.folder / f"{number}.c", self.folder / f"{number}.so"
        source.write_text(SOURCE)
        subprocess.run([os.environ.get("CC", "cc"), "-O1", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", f"-DPLANTED={fault}", source, "-o", library, "-lm"],
                       check=True)
        return f"plugin:{library}"

    def test_each_planted_number_is_named_in_its_column(self):
        kernels = {self.planted(number, fault): fault for number, fault in enumerate(PLANTED)}
        out = self.folder / "out"
        done = axiscert(*ASKED, *kernels, "--out", out)
        self.assertEqual(done.returncode, 0, done.stderr)
        data = json.loads((out / "league.json").read_text())
        jsonschema.validate(data, schema_of("league"))
        head = next(line for line in done.stdout.splitlines() if line.startswith("  kernel  "))
        for kernel, fault in kernels.items():
            row = next(line for line in done.stdout.splitlines() if line.startswith(f"  {kernel} "))
            cells = self.cells(head, row)
            for column, words, has in PLANTED[fault]:
                with self.subTest(fault, column=column):
                    (self.assertIn if has else self.assertNotIn)(words, cells[column])
        self.assertTrue({"separation", "left", "normal", "point", "contradiction"} <= {one["kind"] for one in data["worst_contacts"]})
        worst = next(one for one in data["worst_contacts"] if one["kind"] == "left")
        self.assertEqual(kernels[worst["kernel"]], f"{EACH} normal[k] = -normal[k]")
        self.assertEqual((worst["size"], worst["query"]["measures"]["is_flip"]), (2, True))
        for kernel in data["kernels"]:
            for name, family in kernel["families"].items():
                self.assertEqual(family["contacts"]["answers"], 64, name)

    @staticmethod
    def cells(head, row):
        starts = [0, *(head.index(f"  {column}") for column in COLUMNS), len(row) + 200]
        return {column: row[start:end].strip() for column, start, end in zip(("kernel", *COLUMNS), starts, starts[1:])}

    def test_its_figures_are_those_of_a_run(self):
        kernel = self.planted(0, "*separation *= 0.5f")
        out, run = self.folder / "league", self.folder / "run"
        self.assertEqual(axiscert(*ASKED, kernel, "--out", out).returncode, 0)
        done = axiscert("run", "--kernel", kernel, *ASKED[2:], "--shrink", "0", "--out", run)
        self.assertEqual(done.returncode, 0, done.stderr)
        families = json.loads((run / "record.json").read_text())["kernels"][0]["families"]
        (league,) = json.loads((out / "league.json").read_text())["kernels"]
        self.assertEqual({name: family["contacts"] for name, family in league["families"].items()},
                         {name: family["contacts"] for name, family in families.items()})

    def test_a_verdict_alone_is_not_given_and_no_fault(self):
        done = axiscert(*ASKED, "published", "closest-point")
        self.assertEqual(done.returncode, 0, done.stderr)
        rows = [line.split() for line in done.stdout.splitlines()]
        self.assertIn(["published", "-", "not", "given", "-", *["not", "given"] * 4], rows)
        self.assertNotIn("not given", next(line for line in done.stdout.splitlines() if line.startswith("  closest-point  ")))


if __name__ == "__main__":
    unittest.main()
