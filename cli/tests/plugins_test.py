#!/usr/bin/env python3
"""A user's own kernel through the command: its faults are reported, and its own way of computing is not a fault."""
import json
import re
import shutil
import subprocess
import unittest

from command import BUILD, DIVISOR, ROOT, Case, axiscert, family

# A closest-point test in C over `real`; FORM chooses how it is written, RELATION the convention for touching.
OTHER_FORMS = r"""
#include "kernel/include/axiscert/plugin.h"
static real dot(const real *a, const real *b) { return a[2] * b[2] + (a[1] * b[1] + a[0] * b[0]); }
static real min2(real a, real b) { return b < a ? b : a; }
static real to_segment(const real *a, const real *b) {  /* squared, from the origin */
  real ab[3], q[3], t;
  int k;
  for (k = 0; k < 3; ++k) ab[k] = b[k] - a[k];
  t = dot(ab, ab);
  t = t > 0 ? -dot(a, ab) / t : 0;
  t = t < 0 ? 0 : t > 1 ? 1 : t;
  for (k = 0; k < 3; ++k) q[k] = a[k] + t * ab[k];
  return dot(q, q);
}
static void cross(const real *a, const real *b, real *n) {
  n[0] = a[1] * b[2] - a[2] * b[1];
  n[1] = a[2] * b[0] - a[0] * b[2];
  n[2] = a[0] * b[1] - a[1] * b[0];
}
static int kernel(const real a[3], const real b[3], const real c[3], const real p[3], real r) {
  real v[3][3], u[3], w[3], n[3], s[3], d, h;
  int k;
  for (k = 0; k < 3; ++k) {
    v[0][k] = a[k] - p[k]; v[1][k] = b[k] - p[k]; v[2][k] = c[k] - p[k];
    u[k] = b[k] - a[k]; w[k] = c[k] - a[k];
  }
  d = min2(to_segment(v[2], v[0]), min2(to_segment(v[0], v[1]), to_segment(v[1], v[2])));
  cross(u, w, n);
  h = dot(n, n);
  for (k = 0; k < 3; ++k) {
    real m[3];
    cross(v[k], v[(k + 1) % 3], m);
    s[k] = dot(m, n);
  }
  if (h > 0 && s[0] >= 0 && s[1] >= 0 && s[2] >= 0) d = min2(d, dot(v[0], n) * (dot(v[0], n) / h));
  return d RELATION r * r ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
}
static const axiscert_limits limits = {.size = sizeof(axiscert_limits), .greatest_coordinate = 100, .least_radius = 0x1p-20};
AXISCERT_PLUGIN_OF(real, "other-form", kernel, TRIANGLE, vertices, none, MORE)
"""


# Names that a user's functions, texts and types may have: common short ones, and those that the interface itself uses.
SHORT_NAMES = ("k i j v r u n x a b c p bits batch answers kernel verdict index size real name count column run "
               "comparisons one_query batch_function kernel_name").split()


def uses_of(name):
    """Code in C and C++ that passes something of this name to a macro of plugin.h, keyed by the kind of thing."""
    def query(function, real="float", more=("", "")):
        points = "".join(f"const {real} {point}[3], " for point in ("vertex_a", "vertex_b", "vertex_c", "centre"))
        return (f"static int {function}({points}{real} radius{more[0]}) {{{more[1]} return vertex_a[0] + vertex_b[0] + vertex_c[0] + "
                "centre[0] > radius; }\n")

    def plugin(real, text, function):
        """The macro defines the same functions each time, so each use gives them other names."""
        return (f"#undef axiscert_plugin\n#define axiscert_plugin plugin_{name}\n"
                f"#undef axiscert_i_run\n#define axiscert_i_run run_{name}\nAXISCERT_PLUGIN({real}, {text}, {function})\n")

    asked = f"asked_{name}"
    return {"a function": query(name) + plugin("float", '"x"', name),
            "a function that gives comparisons": query(name, more=(", uint64_t* given", " *given = 1;"))
            + f"AXISCERT_BATCH_WITH_COMPARISONS(run_{name}, float, {name})\n"
            + f"void (*use_of_{name})(const axiscert_batch*, const axiscert_answers*) = run_{name};\n",
            "a text": f'static const char {name}[] = "x";\n' + query(asked) + plugin("float", name, asked),
            "a type": f"typedef double {name};\n" + query(asked, "double") + plugin(name, '"x"', asked)}


class Plugins(Case):
    def compiled(self, name, *flags, real="float", relation=">", more="", fault=("", "")):
        """`more`: declarations of the kernel; `fault`: a text and its replacement."""
        source, plugin = self.folder / f"{name}.c", self.folder / f"{name}.so"
        source.write_text(OTHER_FORMS.replace(*fault))
        subprocess.run(["cc", "-O2", "-shared", "-fPIC", f"-I{ROOT}", f"-Dreal={real}", f"-DRELATION={relation}",
                        f"-DMORE={more}", *flags, source, "-o", plugin], check=True)
        return f"plugin:{plugin}"

    def test_six_plugins_that_misbehave_are_six_findings(self):
        kinds = {"crash": "crash", "hang": "hang", "out_of_bounds": "out_of_bounds", "random": "nondeterministic",
                 "last_lane": "batch_dependent", "flush_to_zero": "environment"}
        ids = {name: f"plugin:{BUILD}/misbehaving/{name}.so" for name in kinds}
        kernels = [part for id in ids.values() for part in ("--kernel", id)]
        record = self.run_ok("--kernel", "published", *kernels, "--family", "scale", "--family", "general", "--trials",
                             "3001", "--precision", "binary32", "--plugin-seconds", "0.1")
        self.assertTrue(record["complete"])
        found = {(f["kernel"], f["kind"]) for f in record["findings"]}
        self.assertEqual(found, {(ids[name], kind) for name, kind in kinds.items()})
        for finding in record["findings"]:
            self.assertEqual(len(finding["a"] + finding["b"] + finding["c"] + finding["p"]), 12)
            again = axiscert("query", finding["address"])
            self.assertIn(finding["r"], again.stdout)
        for kernel in record["kernels"]:
            for name, result in kernel["families"].items():
                self.assertEqual(result["trials"], 3001, (kernel["id"], name))
        text = axiscert("report", self.folder / "out").stdout + (self.folder / "out/report.md").read_text()
        for id in ids.values():
            self.assertIn(id.split("/")[-1], text)

    def test_a_finding_fails_every_requirement(self):
        for name in ("misbehaving/random", "declarations/wrong_abi"):
            for level in ("logic", "range", "conservative=1"):
                done = axiscert("run", "--kernel", f"plugin:{BUILD}/{name}.so", "--family", "general",
                                "--trials", "2000", "--require", level, "--out", self.folder / "out")
                self.assertEqual(done.returncode, 1, (name, level, done.stderr))
                self.assertIn(name, done.stderr)

    def test_what_verdicts_alone_cannot_show_is_not_checked_and_does_not_pass(self):
        plan = ["run", "--kernel", self.compiled("other"), "--family", "tie", "--precision", "binary32", "--trials", "4000",
                "--out", self.folder / "out"]
        done = axiscert(*plan, "--require", "logic")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("logic: NOT CHECKED: no clear query was decided, and none of a family of exact arithmetic", done.stderr)
        self.assertIn("add --family lattice", done.stderr)
        plan += ["--family", "lattice"]
        done = axiscert(*plan, "--require", "range")
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertRegex(done.stderr, r"range: [\d,]+ of [\d,]+ promised queries looked at: NOT CHECKED: the kernel shows verdicts alone: a "
                         r"wrong verdict \(")
        self.assertIn("missed   ", done.stdout)  # the table of depths
        done = axiscert(*plan, "--require", "range", "--require", "logic", "--allow-unchecked", "range")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("NOT CHECKED, which is allowed: the kernel shows verdicts alone", done.stdout)
        self.assertRegex(done.stdout, r"logic: [\d,]+ of [\d,]+ promised queries looked at: met\n  covers verdicts on ")
        self.assertIn("\n  leaves out other units of length, and a wrong verdict on any other query: ", done.stdout)

    def test_a_file_that_is_no_plugin_passes_no_gate(self):
        text = self.folder / "text.so"
        text.write_text("this is text\n")
        for level in ("logic", "depth=1", "no-worse-than=published"):
            done = axiscert("run", "--kernel", f"plugin:{text}", "--kernel", "published", "--family", "lattice", "--trials", "500",
                            "--require", level, "--allow-unchecked", level, "--out", self.folder / "out")
            self.assertEqual(done.returncode, 1, (level, done.stderr))
            self.assertIn("text.so", done.stderr)

    def test_the_macros_take_no_name_from_their_users(self):
        """The compilers that built axiscert give no warning, in C or in C++."""
        cache = (BUILD / "CMakeCache.txt").read_text()
        for language, standard in (("C", "c99"), ("CXX", "c++11")):
            compiler = re.search(rf"^CMAKE_{language}_COMPILER:\w+=(.*)$", cache, re.MULTILINE)[1]
            for kind in uses_of("k"):
                source = self.folder / f"names.{'c' if language == 'C' else 'cpp'}"
                source.write_text("#include <axiscert/plugin.h>\n" + "".join(uses_of(name)[kind] for name in SHORT_NAMES))
                done = subprocess.run([compiler, f"-std={standard}", "-fsyntax-only", "-Wall", "-Wextra", "-Wshadow",
                                       "-pedantic", "-Werror", f"-I{ROOT}/kernel/include", source],
                                      capture_output=True, text=True)
                self.assertEqual(done.returncode, 0, f"{compiler}, each name as {kind}: {done.stderr[:2000]}")

    def test_one_kernel_is_listed_with_its_test_and_its_source(self):
        for id, source in (("fault/none", "kernel/sphere_triangle/faults/none.c:1"),
                           (f"plugin:{BUILD}/declarations/short_kernel.so", None), ("published", None)):
            (listed,) = json.loads(axiscert("kernels", "--kernel", id, "--format", "json").stdout)["kernels"]
            self.assertEqual((listed["id"], listed["predicate"], listed["entry"], listed["source"], listed["findings"]),
                             (id, "sphere-triangle", "vertices", source, []))
            text = axiscert("kernels", "--kernel", id).stdout
            self.assertIn("predicate sphere-triangle, entry vertices\n", text)
            self.assertEqual(f"source {source}\n" in text, source is not None, text)
        refused = axiscert("kernels", "--kernel", f"plugin:{BUILD}/declarations/unknown_predicate.so").stdout
        self.assertIn("load: what it answers: unknown predicate 'sphere-cube'", refused)
        self.refused("kernels", "--kernel", "nosuch", says=["unknown kernel 'nosuch'"])

    def test_a_plugin_for_another_version_leaves_the_run_whole(self):
        for name, number in (("declarations/abi_1", 1), ("declarations/abi_2", 2), ("declarations/wrong_abi", 4)):
            record = self.run_ok("--kernel", f"plugin:{BUILD}/{name}.so", "--kernel", "published", "--family",
                                 "general", "--trials", "2000", code=1)
            (finding,) = record["findings"]
            self.assertEqual((finding["kind"], finding["address"]), ("abi", None))
            self.assertIn(f"version {number} of the plug-in interface, but this axiscert takes 3: build it again", finding["detail"])
            self.assertEqual(family(record, "general")["trials"], 2000)

    def test_a_correct_kernel_written_differently_is_no_logic_fault(self):
        for real, precision in (("float", "binary32"), ("double", "binary64")):
            for flags in (["-ffp-contract=off"], ["-mfma", "-ffp-contract=fast"]):
                with self.subTest(real=real, flags=flags):
                    kernel = self.compiled("other", *flags, real=real)
                    record = self.run_ok("--kernel", kernel, "--precision", precision, "--family", "all", "--trials",
                                         str(3000 // DIVISOR), "--require", "logic")
                    (entry,) = record["kernels"]
                    wrong = sum(f["verdict"][kind] or 0 for f in entry["families"].values() for kind in ("false_separation", "false_contact"))
                    self.assertGreater(wrong, 0, "it rounds")
                    self.assertEqual(record["findings"], [])

    def test_a_wrong_vertex_is_a_logic_fault(self):
        kernel = self.compiled("faulty", fault=("to_segment(v[2], v[0])", "to_segment(v[1], v[0])"))
        done = axiscert("run", "--kernel", kernel, "--family", "lattice", "--trials", "5000", "--require", "logic",
                        "--out", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        self.assertIn("exact arithmetic", done.stderr)

    def test_touching_is_judged_by_what_the_plugin_says(self):
        touching = '{"id":"q","precision":"binary32","a":[2,0,0],"b":[3,0,0],"c":[2,1,0],"p":[0,0,0],"r":2}\n'
        for relation, more, right in ((">", "", True), (">=", "", False),
                                      (">=", "AXISCERT_DECLARE(touching, AXISCERT_TOUCHING_IS_SEPARATED)", True),
                                      (">", "AXISCERT_DECLARE(touching, AXISCERT_TOUCHING_IS_SEPARATED)", False),
                                      (">", "AXISCERT_DECLARE(touching, AXISCERT_TOUCHING_IS_EITHER)", True),
                                      (">=", "AXISCERT_DECLARE(touching, AXISCERT_TOUCHING_IS_EITHER)", True)):
            with self.subTest(relation=relation, more=more):
                kernel = self.compiled(f"touching{len(more)}{len(relation)}", relation=relation, more=more)
                done = axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=touching)
                self.assertEqual(done.returncode, 0, done.stderr)
                self.assertEqual(json.loads(done.stdout)["flips"] == [], right)

    def test_wrong_answers_outside_its_limits_fail_nothing(self):
        for more, code in (("", 1), ("AXISCERT_DECLARE(limits, &limits)", 0)):
            kernel = self.compiled(f"limits{code}", more=more, real="float")
            done = axiscert("run", "--kernel", kernel, "--family", "scale", "--trials", "3000", "--precision", "binary32",
                            "--require", "conservative=0.01", "--out", self.folder / "out")
            self.assertEqual(done.returncode, code, done.stderr)
        (entry,) = json.loads((self.folder / "out/record.json").read_text())["kernels"]
        outside = entry["families"]["scale"]["verdict"]["outside_limits"]
        self.assertGreater(outside["trials"], 0)
        self.assertGreater(outside["false_contact"], 0)

    def test_the_record_does_not_depend_on_threads(self):
        plan = ("--kernel", f"plugin:{BUILD}/misbehaving/random.so", "--kernel", self.compiled("other"), "--family",
                "tangent", "--trials", "70000", "--precision", "binary32")
        self.assertEqual(self.run_ok(*plan, "--threads", "1", out="one"), self.run_ok(*plan, "--threads", "2", out="two"))

    def test_no_such_plugin(self):
        self.refused("run", "--kernel", "plugin:/nosuch.so", says=["/nosuch.so", "no file"])
        self.refused("run", "--kernel", "peer/nosuch", says=["peer/nosuch"])

    def test_the_path_of_a_plugin_may_look_like_a_call(self):
        """Its name is used as it is; a mode added to it is refused."""
        plain = self.compiled("other")
        for name in ("a@b/c.so", "c.so", "c.so@upward"):
            path = self.folder / name
            path.parent.mkdir(exist_ok=True)
            shutil.copy(plain.removeprefix("plugin:"), path)
            record = self.run_ok("--kernel", f"plugin:{path}", "--family", "lattice", "--trials", "100", "--require", "logic")
            self.assertEqual([k["id"] for k in record["kernels"]], [f"plugin:{path}"])
        self.refused("run", "--kernel", f"plugin:{self.folder}/a@b/c.so@flushed", says=["c.so@flushed", "process of its own"])
        self.refused("run", "--kernel", f"plugin:{self.folder}/a@b/nosuch.so", says=["a@b/nosuch.so", "no file"])

    def test_the_league_takes_times_as_multiples_of_the_certified_kernel(self):
        plan = ("--kernel", "published", "--family", "general", "--trials", "64", "--precision", "binary32")
        self.assertNotIn("where certified takes 1", axiscert("league", *plan).stdout)
        shown = axiscert("league", *plan, "--kernel", "certified").stdout
        header, published, certified = shown.split("over all families\n")[1].splitlines()[:3]
        self.assertTrue(header.endswith("where certified takes 1"), header)
        self.assertEqual(certified.split()[-1], "1")
        ns = [float(row.split()[-2]) for row in (published, certified)]
        self.assertAlmostEqual(float(published.split()[-1]), ns[0] / ns[1], delta=0.02 * ns[0] / ns[1])

    def test_what_evaluates_formulae_itself_takes_no_plugin(self):
        self.refused("precision", "--kernel", "fault/none", says=["fault/none", "critical-radius"])


if __name__ == "__main__":
    unittest.main()
