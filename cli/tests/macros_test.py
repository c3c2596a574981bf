#!/usr/bin/env python3
"""The macros of axiscert/plugin.h that make a kernel of a function of one query: of each predicate and entry, in C99 and C++11, in float and
double, a right function is judged right and a wrong one wrong."""
import json
import re
import subprocess
import unittest

from command import ROOT, Case, axiscert

# Convex bodies by their corners, parted by normals and products of edges; on small integers nothing is rounded. GAP is 0 where it is right.
KERNELS = r"""
#include <axiscert/plugin.h>

typedef struct { real corner[8][3], normal[3][3], edge[3][3]; int corners, normals; } body;

static real dot(const real *u, const real *v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }
static void cross(const real *u, const real *v, real *n) {
  n[0] = u[1] * v[2] - u[2] * v[1];
  n[1] = u[2] * v[0] - u[0] * v[2];
  n[2] = u[0] * v[1] - u[1] * v[0];
}
static int parts(const body *a, const body *b, const real *axis) {
  real most = dot(a->corner[0], axis), least = dot(b->corner[0], axis);
  int i;
  for (i = 1; i < a->corners; ++i) if (dot(a->corner[i], axis) > most) most = dot(a->corner[i], axis);
  for (i = 1; i < b->corners; ++i) if (dot(b->corner[i], axis) < least) least = dot(b->corner[i], axis);
  return least - most > GAP;
}
/* The axes that separate, in the order of box-box: those of a, those of b, the products of their edges. */
static uint64_t separating(const body *a, const body *b) {
  uint64_t bits = 0;
  int i, j, bit = 0;
  for (i = 0; i < a->normals; ++i) bits |= (uint64_t)(parts(a, b, a->normal[i]) | parts(b, a, a->normal[i])) << bit++;
  for (i = 0; i < b->normals; ++i) bits |= (uint64_t)(parts(a, b, b->normal[i]) | parts(b, a, b->normal[i])) << bit++;
  for (i = 0; i < 3; ++i) for (j = 0; j < 3; ++j) {
    real axis[3];
    cross(a->edge[i], b->edge[j], axis);
    bits |= (uint64_t)(parts(a, b, axis) | parts(b, a, axis)) << bit++;
  }
  return bits;
}
static int separated(const body *a, const body *b) { return separating(a, b) ? AXISCERT_SEPARATED : AXISCERT_CONTACT; }
static body triangle(const real *a, const real *b, const real *c) {
  body t;
  int k;
  for (k = 0; k < 3; ++k) {
    t.corner[0][k] = a[k]; t.corner[1][k] = b[k]; t.corner[2][k] = c[k];
    t.edge[0][k] = b[k] - a[k]; t.edge[1][k] = c[k] - b[k]; t.edge[2][k] = a[k] - c[k];
  }
  cross(t.edge[0], t.edge[1], t.normal[0]);
  t.corners = 3; t.normals = 1;
  return t;
}
static body box(const real *centre, const real *half, const real *axes) {
  body b;
  int i, k, m;
  for (i = 0; i < 8; ++i) for (k = 0; k < 3; ++k) {
    b.corner[i][k] = centre[k];
    for (m = 0; m < 3; ++m) b.corner[i][k] += ((i >> m & 1) ? half[m] : -half[m]) * axes[3 * m + k];
  }
  for (m = 0; m < 3; ++m) for (k = 0; k < 3; ++k) b.normal[m][k] = b.edge[m][k] = axes[3 * m + k];
  b.corners = 8; b.normals = 3;
  return b;
}
static body turned(const real *centre, const real *half, const real *q) {
  const real w = q[0], x = q[1], y = q[2], z = q[3], n = w * w + dot(q + 1, q + 1);
  const real axes[9] = {(w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n,
                        2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n,
                        2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n};
  return box(centre, half, axes);
}
static const real upright[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1};
static body between(const real *low, const real *high) {
  real centre[3], half[3];
  int k;
  for (k = 0; k < 3; ++k) { centre[k] = (low[k] + high[k]) / 2; half[k] = (high[k] - low[k]) / 2; }
  return box(centre, half, upright);
}

#define POINT(name) const real name[3]
#define BOX(name) POINT(name##_centre), POINT(name##_half)
static int box_box_matrix(BOX(a), const real a_axes[9], BOX(b), const real b_axes[9]) {
  const body first = box(a_centre, a_half, a_axes), second = box(b_centre, b_half, b_axes);
  return separated(&first, &second);
}
static int box_box_quaternion(BOX(a), const real a_turn[4], BOX(b), const real b_turn[4]) {
  const body first = turned(a_centre, a_half, a_turn), second = turned(b_centre, b_half, b_turn);
  return separated(&first, &second);
}
static int box_box_minmax(POINT(a_low), POINT(a_high), POINT(b_low), POINT(b_high)) {
  const body first = between(a_low, a_high), second = between(b_low, b_high);
  return separated(&first, &second);
}
static int box_box_mixed(POINT(a_low), POINT(a_high), BOX(b), const real b_turn[4]) {
  const body first = between(a_low, a_high), second = turned(b_centre, b_half, b_turn);
  return separated(&first, &second);
}
static int box_triangle_matrix(POINT(centre), POINT(half), const real axes[9], POINT(a), POINT(b), POINT(c)) {
  const body first = box(centre, half, axes), second = triangle(a, b, c);
  return separated(&first, &second);
}
static int box_triangle_centre(POINT(centre), POINT(half), POINT(a), POINT(b), POINT(c)) {
  return box_triangle_matrix(centre, half, upright, a, b, c);
}
static int box_triangle_minmax(POINT(low), POINT(high), POINT(a), POINT(b), POINT(c)) {
  const body first = between(low, high), second = triangle(a, b, c);
  return separated(&first, &second);
}
static int box_triangle_quaternion(POINT(centre), POINT(half), const real turn[4], POINT(a), POINT(b), POINT(c)) {
  const body first = turned(centre, half, turn), second = triangle(a, b, c);
  return separated(&first, &second);
}

/* Falls, in the direction -z, on the front of a triangle in a plane of one z, above a vertex or the face. */
static int all_d(POINT(a), POINT(b), POINT(c), POINT(p), POINT(d), real r, real *time, real *feature, real normal[3], real point[3]) {
  const real height = p[2] - a[2] - r - GAP;
  const real *const corner[3] = {a, b, c};
  int k;
  if (height + d[2] > 0) return AXISCERT_SEPARATED;
  *time = height / -d[2];
  *feature = 6;
  for (k = 0; k < 3; ++k) {
    if (corner[k][0] == p[0] && corner[k][1] == p[1]) *feature = (real)k;
    normal[k] = k == 2;
    point[k] = k == 2 ? a[2] : p[k];
  }
  return AXISCERT_CONTACT;
}
static int time_d(POINT(a), POINT(b), POINT(c), POINT(p), POINT(d), real r, real *time) {
  real feature, normal[3], point[3];
  return all_d(a, b, c, p, d, r, time, &feature, normal, point);
}
static int none_d(POINT(a), POINT(b), POINT(c), POINT(p), POINT(d), real r) {
  real time;
  return time_d(a, b, c, p, d, r, &time);
}
#define FALL(name) const real name[3] = {to[0] - p[0], to[1] - p[1], to[2] - p[2]}
static int all_e(POINT(a), POINT(b), POINT(c), POINT(p), POINT(to), real r, real *time, real *feature, real normal[3], real point[3]) {
  FALL(d);
  return all_d(a, b, c, p, d, r, time, feature, normal, point);
}
static int time_e(POINT(a), POINT(b), POINT(c), POINT(p), POINT(to), real r, real *time) { FALL(d); return time_d(a, b, c, p, d, r, time); }
static int none_e(POINT(a), POINT(b), POINT(c), POINT(p), POINT(to), real r) { FALL(d); return none_d(a, b, c, p, d, r); }
static int rests(POINT(a), POINT(b), POINT(c), POINT(p), real r) { return none_d(a, b, c, p, upright, r); } /* dz 0 */
static int rests_all(POINT(a), POINT(b), POINT(c), POINT(p), real r, real *separation, real *feature, real normal[3], real point[3]) {
  const real to[3] = {0, 0, a[2] - p[2]}; /* it falls to its plane, and tells where */
  real time;
  all_d(a, b, c, p, to, 0, &time, feature, normal, point);
  *separation = p[2] - a[2] - r - GAP;
  return rests(a, b, c, p, r);
}
static int rests_separation(POINT(a), POINT(b), POINT(c), POINT(p), real r, real *separation) {
  *separation = p[2] - a[2] - r - GAP;
  return rests(a, b, c, p, r);
}
static int shows(BOX(a), const real a_axes[9], BOX(b), const real b_axes[9], uint64_t *comparisons) {
  const body first = box(a_centre, a_half, a_axes), second = box(b_centre, b_half, b_axes);
  *comparisons = separating(&first, &second);
  return *comparisons ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}
"""

TIMES = ("never-late", "early=1")
# Each macro, with where its queries are (a family, or `queries` below) and what it is required to meet.
MACROS = [
    ('AXISCERT_PLUGIN(real, "x", rests)', "p", ()),
    ('AXISCERT_CONTACT_PLUGIN(real, "x", rests_all, all)', "p", ("separation=0", "feature", "normal=0", "unit=0", "point=0")),
    ('AXISCERT_CONTACT_PLUGIN(real, "x", rests_separation, separation)', "p", ("separation=0",)),
    ('AXISCERT_CONTACT_PLUGIN(real, "x", rests, none)', "p", ()),
    ('AXISCERT_MOTION_PLUGIN(real, "x", none_d, displacement, none)', "d", ()),
    ('AXISCERT_MOTION_PLUGIN(real, "x", time_d, displacement, time)', "d", TIMES),
    ('AXISCERT_MOTION_PLUGIN(real, "x", all_d, displacement, all)', "d", (*TIMES, "feature", "normal=0", "unit=0", "point=0")),
    ('AXISCERT_MOTION_PLUGIN(real, "x", none_e, endpoints, none)', "p1", ()),
    ('AXISCERT_MOTION_PLUGIN(real, "x", time_e, endpoints, time)', "p1", TIMES),
    ('AXISCERT_MOTION_PLUGIN(real, "x", all_e, endpoints, all)', "p1", (*TIMES, "feature", "normal=0", "unit=0", "point=0")),
    ('AXISCERT_BOX_PLUGIN(real, "x", box_box_matrix, matrix)', "box-box/lattice", ()),
    ('AXISCERT_BOX_PLUGIN(real, "x", box_box_quaternion, quaternion)', "box-box/lattice_turned", ()),
    ('AXISCERT_BOX_PLUGIN(real, "x", box_box_minmax, minmax)', "box-box/lattice_minmax", ()),
    ('AXISCERT_BOX_PLUGIN(real, "x", box_box_mixed, minmax_quaternion)', "box-box/lattice_mixed", ()),
    ('AXISCERT_PLUGIN_OF(real, "x", shows, BOX, matrix, comparisons, AXISCERT_DECLARE(summary, "shown") AXISCERT_DECLARE(formulae, "box-box/projected"))',
     "box-box/lattice", ()),
    ('AXISCERT_BOX_TRIANGLE_PLUGIN(real, "x", box_triangle_centre, centre)', "box-triangle/lattice", ()),
    ('AXISCERT_BOX_TRIANGLE_PLUGIN(real, "x", box_triangle_minmax, minmax)', "box-triangle/lattice_minmax", ()),
    ('AXISCERT_BOX_TRIANGLE_PLUGIN(real, "x", box_triangle_matrix, matrix)', "box-triangle/lattice_oriented", ()),
    ('AXISCERT_BOX_TRIANGLE_PLUGIN(real, "x", box_triangle_quaternion, quaternion)', "box-triangle/lattice_turned", ()),
]
COMPILERS = {"c": ["cc", "-std=c99"], "cpp": ["c++", "-std=c++11"]}
PRECISIONS = {"float": "binary32", "double": "binary64"}


def queries(moves_by, precision):
    """Falls by 8 on a triangle in the plane z = 3: above a vertex or the face, clear, touching on the way or at its end, and short of it.
    `moves_by` is d or p1; p: spheres that rest there."""
    lines = []
    for x, y in ((0, 0), (8, 0), (0, 8), (2, 2)):
        for height in (0.5, 1, 2, 4.5, 8.5, 9, 12):
            line = {"id": f"{x},{y},{height}", "precision": precision, "a": [0, 0, 3], "b": [8, 0, 3], "c": [0, 8, 3], "p": [x, y, 3 + height], "r": 0.5}
            if moves_by != "p":
                line |= {"predicate": "moving-sphere", moves_by: [0, 0, -8] if moves_by == "d" else [x, y, height - 5]}
            lines.append(json.dumps(line) + "\n")
    return "".join(lines)


class Macros(Case):
    # Of right functions; a wrong one is in the other language.
    languages = {"float": ["c"], "double": ["cpp"]}

    def compiled(self, name, language, real, gap, line, code=0):
        source, plugin = self.folder / f"{name}.{language}", self.folder / f"{name}-{language}-{real}-{gap}.so"
        source.write_text(f"{KERNELS}{line}\n")
        done = subprocess.run([*COMPILERS[language], "-O1", "-Wall", "-Wextra", "-Wno-unused-function", "-Wshadow", "-pedantic", "-Werror",
                               "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", f"-Dreal={real}", f"-DGAP={gap}", source,
                               "-o", plugin], capture_output=True, text=True)
        self.assertEqual(done.returncode, code, done.stderr)
        return f"plugin:{plugin}"

    def judged(self, kernels, place, precision, requirements):
        """A run of the kernels over the place's queries."""
        file = self.folder / f"{place.replace('/', '-')}.jsonl"
        file.write_text(queries(place, precision) if place in ("p", "d", "p1") else "")
        source = ["--queries", file] if file.read_text() else ["--family", place, "--trials", "200"]
        return axiscert("run", *(f"--kernel={kernel}" for kernel in kernels), *source, "--precision", precision,
                        *(f"--require={level}" for level in requirements), "--out", self.folder / "out")

    def test_a_right_function_is_right_and_a_wrong_one_wrong(self):
        """All of one place in one run."""
        for place in dict.fromkeys(place for _, place, _ in MACROS):
            lines = [(number, line, ("exact", *levels)) for number, (line, own, levels) in enumerate(MACROS) if own == place]
            for real, precision in PRECISIONS.items():
                right = {line: [self.compiled(f"right{number}", language, real, 0, line) for language in self.languages[real]]
                         for number, line, _ in lines}
                wrong = {line: self.compiled(f"wrong{number}", "cpp" if real == "float" else "c", real, 1, line) for number, line, _ in lines}
                done = self.judged([*sum(right.values(), []), *wrong.values()], place, precision,
                                   dict.fromkeys(level for _, _, levels in lines for level in levels))
                self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                told = {(one["kernel"], one["level"]): one["state"] for one in json.loads((self.folder / "out/run.json").read_text())["requirements"]}
                for _, line, levels in lines:
                    with self.subTest(line, real=real):
                        for kernel in right[line]:
                            self.assertEqual({level: told[kernel, level] for level in levels}, dict.fromkeys(levels, "met"), done.stderr)
                        for level in levels:
                            if level == "exact" or "late" in level or "separation" in level:
                                self.assertEqual(told[wrong[line], level], "not met", done.stderr)

    def test_what_a_function_does_not_give_is_not_given(self):
        """Its time and normal alone, where the kernel has room for all."""
        only = ("static int time_and_normal(POINT(a), POINT(b), POINT(c), POINT(p), POINT(d), real r, real *time, real *feature, real normal[3], "
                "real point[3]) {\n  real unsaid[4];\n  (void)feature; (void)point;\n  return all_d(a, b, c, p, d, r, time, unsaid, normal, "
                "unsaid + 1);\n}\n")
        kernel = self.compiled("some", "c", "float", 0, only + 'AXISCERT_MOTION_PLUGIN(real, "x", time_and_normal, displacement, all)')
        self.assertEqual(self.judged([kernel], "d", "binary32", ("exact", *TIMES, "normal=0", "unit=0")).returncode, 0)
        record = json.loads((self.folder / "out/record.json").read_text())
        (motion,) = (found["contacts"] for found in record["kernels"][0]["families"].values())
        none = {measure: motion[measure]["none"] for measure in ("time", "feature", "normal", "point")}
        self.assertEqual(none, {"time": 0, "feature": motion["answers"], "normal": 0, "point": motion["answers"]})
        self.assertGreater(motion["answers"], 10)

    def test_what_a_line_declares_is_listed(self):
        """Predicate, entry, source, and the declarations of AXISCERT_PLUGIN_OF."""
        line = next(line for line, _, _ in MACROS if "_OF" in line)
        (listed,) = json.loads(axiscert("kernels", "--format", "json", "--kernel",
                                        self.compiled("listed", "c", "float", 0, line)).stdout)["kernels"]
        self.assertEqual((listed["predicate"], listed["entry"], listed["summary"], listed["findings"]), ("box-box", "matrix", "x: shown", []))
        self.assertEqual(listed["source"], f"{self.folder}/listed.c:{KERNELS.count(chr(10)) + 1}")

    def test_the_page_has_these_lines(self):
        """With the words that each may end in."""
        rows = re.findall(r"^\| [^|]+ \| `(\w+)\(float, \"mine\", f(.*?)\)` \| (.*) ?\|$", (ROOT / "docs/plugins.md").read_text(), re.M)
        words = {macro: set(re.findall(r"\w+", f"{first} {more}")) for macro, first, more in rows}
        here = {}
        for line, _, _ in MACROS:
            macro, more = re.match(r'(\w+)\(real, "x", \w+(.*)\)', line).groups()
            here.setdefault(macro, set()).update(re.findall(r"\w+", more))
        self.assertEqual(words, {macro: more for macro, more in here.items() if not macro.endswith("_OF")})

    def test_a_word_that_no_entry_has_does_not_compile(self):
        for line in ('AXISCERT_BOX_PLUGIN(real, "x", box_box_matrix, matrices)', 'AXISCERT_MOTION_PLUGIN(real, "x", time_d, displacement, times)',
                     'AXISCERT_MOTION_PLUGIN(real, "x", time_d, displacement, none)'):
            self.compiled("none", "c", "float", 0, line, code=1)


class MacrosLong(Macros):
    languages = {real: [*COMPILERS] for real in PRECISIONS}


if __name__ == "__main__":
    unittest.main()
