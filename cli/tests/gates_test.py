#!/usr/bin/env python3
"""A gate over what happens to a user's kernel: the table in docs/ci.md, row by row. compare holds the run of a change
against the run before it, the ratchet against what was accepted then."""
import json
import re
import shutil
import subprocess
import unittest

from command import BUILD, REPORTS, ROOT, SCHEMAS, VALIDATE, Case, axiscert

PLAN = ["--family", "general", "--trials", "2000", "--precision", "binary32"]
SOURCE = (ROOT / "examples/plugin/my_kernel.c").read_text()
COMPARISON = "return squared > r * r ?"
PLUGIN = 'AXISCERT_PLUGIN(float, "my-kernel", my_kernel)'
assert COMPARISON in SOURCE and PLUGIN in SOURCE
# The same with members of axiscert_kernel that the macro leaves out.
PROMISING = """static const axiscert_limits my_limits = {.size = sizeof(axiscert_limits), %s};
AXISCERT_PLUGIN_OF(float, "my-kernel", my_kernel, TRIANGLE, vertices, none, AXISCERT_DECLARE(limits, &my_limits) AXISCERT_DECLARE(may_decline, %d))"""
# Undecided where the margin makes phantom contacts.
DECLINES = "if (squared > r * r && squared <= r * r * 1.1f) return AXISCERT_UNDECIDED;"
ROWS = {row[0]: row[1:] for row in re.findall(r"^\| ([^|]+) \| (\d)[:,]? ?([^|]*) \| (\d)[:,]? ?([^|]*) \|$",
                                             (ROOT / "docs/ci.md").read_text(), re.M)}


def validate(schema, *files):
    return subprocess.run(["/usr/bin/python3", VALIDATE, schema, *files], capture_output=True, text=True)


class GatesCase(Case):
    def built(self, path, margin="0.1f", name="my-kernel", stamp="1", before="", limits="", may_decline=False):
        """A kernel that calls spheres closer than r (1 + margin / 2) contacts; `before` is C in front of that, `stamp` changes nothing but its
        bytes. With limits, or with leave to decline, its promise is less."""
        file = self.folder / path
        file.parent.mkdir(exist_ok=True)
        code = SOURCE.replace(COMPARISON, f"{before} return squared > r * r * (1 + {margin}) ?")
        if limits or may_decline:
            code = code.replace(PLUGIN, PROMISING % (limits or ".least_radius = 0", may_decline))
        code = code.replace('"my-kernel"', f'"{name}"')
        source = self.folder / "my_kernel.c"
        source.write_text(code + f'const char my_stamp[] = "{stamp}";\n')
        subprocess.run(["cc", "-O2", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}/kernel/include", source, "-o", file],
                       check=True)
        return f"plugin:{file}"

    def judged(self, out, *kernels, plan=PLAN, more=()):
        named = [part for kernel in kernels for part in ("--kernel", kernel)]
        return axiscert("run", *named, *plan, "--out", self.folder / out, *more)

    def base(self, plan=PLAN, **how):
        """The run before the change, and the ratchet that accepts it."""
        self.assertEqual(self.judged("base", self.built("build/my_kernel.so", **how), plan=plan).returncode, 0)
        text = (self.folder / "base/ratchet.txt").read_text()
        (self.folder / "accepted.txt").write_text(text.replace("EXPIRY OWNER REASON", "never geometry \"as it was\""))
        return text


class Gates(GatesCase):
    def row(self, name, *kernels, plan=PLAN, edit=None):
        """Runs the row: exit codes as the table has them, and its words in what is printed."""
        compare_code, compare_says, ratchet_code, ratchet_says = ROWS[name]
        words = lambda cell: re.findall(r"`([^`]+)`", cell)
        held = self.judged("new", *kernels, plan=plan, more=("--ratchet", self.folder / "accepted.txt"))
        self.assertEqual(held.returncode, int(ratchet_code), f"{name}: {held.stdout}{held.stderr}")
        for word in words(ratchet_says):
            self.assertIn(word, held.stdout + held.stderr, name)
        if held.returncode == 2:  # nothing was run
            self.judged("new", *kernels, plan=plan)
        if edit is not None:
            record = json.loads((self.folder / "new/record.json").read_text())
            edit(record)
            (self.folder / "new/record.json").write_text(json.dumps(record))
        done = axiscert("compare", self.folder / "base", self.folder / "new", "--no-replay")
        self.assertEqual(done.returncode, int(compare_code), f"{name}: {done.stdout}{done.stderr}")
        for word in words(compare_says):
            self.assertIn(word, done.stdout + done.stderr, name)
        self.done.add(name)
        return done.stdout, held.stdout + held.stderr

    def test_every_row_of_the_table(self):
        self.base()
        self.done = set()
        same = self.built("build/my_kernel.so")
        self.row("nothing", same)
        self.row("a regression", self.built("build/my_kernel.so", margin="0.3f"))
        self.row("an improvement", self.built("build/my_kernel.so", margin="0.03f"))
        self.row("the same errors, built anew", self.built("build/my_kernel.so", stamp="2"))
        self.built("build/my_kernel.so")
        moved = "the file renamed or moved, or its path spelt otherwise"
        shutil.copy(self.folder / "build/my_kernel.so", self.folder / "build/other_name.so")
        self.row(moved, f"plugin:{self.folder}/build/other_name.so")
        (self.folder / "elsewhere").mkdir()
        shutil.copy(self.folder / "build/my_kernel.so", self.folder / "elsewhere/my_kernel.so")
        compared, _ = self.row(moved, f"plugin:{self.folder}/elsewhere/my_kernel.so")
        self.assertRegex(compared, r"plugin/my-kernel +plugin:\S+build/my_kernel.so +plugin:\S+elsewhere/my_kernel.so +the same")
        self.row(moved, f"plugin:{self.folder}/build/../build/my_kernel.so")
        self.row("another declared name", self.built("build/my_kernel.so", name="my-kernel-2"))
        (self.folder / "build/my_kernel.so").write_text("no shared object\n")
        self.row("a file that cannot be loaded", f"plugin:{self.folder}/build/my_kernel.so")
        self.row("the kernel left out", "published")
        same = self.built("build/my_kernel.so")
        self.row("another kernel, without errors, beside it", same, "certified")
        self.row("another seed", same, plan=[*PLAN, "--seed", "2"])
        self.row("another family", same, plan=["--family", "sliver", *PLAN[2:]])

        def other_version(record):
            record["plan"]["axiscert"] = "99.0.0"
        compared, _ = self.row("another version of axiscert", same, edit=other_version)
        self.assertIn("axiscert 99.0.0", compared)

        path = "build/my_kernel.so"
        self.row("limits to where it is right", self.built(path, margin="0", limits=".greatest_radius = 1"))
        self.row('an answer "undecided" in place of wrong ones', self.built(path, margin="0", before=DECLINES))
        self.row("the same, declared", self.built(path, margin="0", before=DECLINES, may_decline=True))
        self.base(limits=".greatest_radius = 1")
        self.row("wider limits", self.built(path, limits=".greatest_radius = 2"))
        self.base(plan=["--family", "repeated", *PLAN])
        self.row("a family left out", self.built(path))
        self.assertEqual(self.done, set(ROWS), "rows that were not tried")

    def test_a_version_of_a_generator_makes_other_queries(self):
        """A family whose version was raised has other queries: its cells are compared by their rates, and a ratchet of the
        queries before is refused."""
        accepted = self.base()
        record = json.loads((self.folder / "base/record.json").read_text())
        record["plan"]["generators"]["general"]["version"] += 1
        (self.folder / "later").mkdir()
        (self.folder / "later/record.json").write_text(json.dumps(record))
        done = axiscert("compare", self.folder / "base", self.folder / "later", "--no-replay", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertGreater(json.loads(done.stdout)["tested"], 0)
        self.assertEqual(axiscert("report", self.folder / "later").returncode, 0)
        later = (self.folder / "later/ratchet.txt").read_text()
        self.assertNotEqual(accepted.split()[1], later.split()[1], "the plan's fingerprint")

    def test_a_kernel_that_limits_itself_to_nothing(self):
        """The same name, later, with limits r >= 1e30 and always separated: nothing is better, mended or passed in silence."""
        self.base()
        self.assertGreater(json.loads((self.folder / "base/record.json").read_text())["witnesses"], [])
        later = self.built("build/my_kernel.so", before="return AXISCERT_SEPARATED;", limits=".least_radius = 1e30")
        held = self.judged("new", later, more=("--ratchet", self.folder / "accepted.txt"))
        self.assertEqual(held.returncode, 1, held.stdout + held.stderr)
        lines = [line for line in held.stderr.splitlines() if "--ratchet: " in line]
        self.assertRegex(lines[0], r"binary32 promises less than the ratchet: radius from 1e\+30, was none: 2,000 of its queries then, 0 now")
        self.assertIn("decided none of its 0 promised queries", held.stderr)
        self.assertIn("no ratchet accepts a run in which something is NOT JUDGED", held.stderr)
        self.assertNotIn("would accept this run", held.stderr)
        self.assertNotIn("better", held.stdout)
        done = axiscert("compare", self.folder / "base", self.folder / "new", "--kernel", later, "--out", self.folder / "compared")
        self.assertEqual(done.returncode, 1, done.stdout)
        first = done.stdout.splitlines()[0]
        self.assertRegex(first, r"^axiscert compare: worse: \d+ known witnesses no longer promised; plugin/my-kernel binary32 promises less: radius from "
                                r"1e\+30, was none; NOT COMPARED: nothing was compared")
        for word in ("mended", "fixed:", "better:"):
            self.assertNotIn(word, done.stdout)
        self.assertRegex(done.stdout, r"evaluated again here: \d+ no longer promised\.")
        self.assertEqual(validate(SCHEMAS / "comparison.schema.json", self.folder / "compared/compare.json").stderr, "")
        allowed = axiscert("compare", self.folder / "base", self.folder / "new", "--no-replay", "--allow-not-compared", "plugin/my-kernel")
        self.assertEqual(allowed.returncode, 1, "promising less is no matter of comparing")

    def test_a_kernel_that_answers_invalid_or_nothing_mends_nothing(self):
        self.base()
        for answer in ("AXISCERT_INVALID", "77"):
            later = self.built("build/my_kernel.so", before=f"return {answer};")
            self.judged("new", later)
            done = axiscert("compare", self.folder / "base", self.folder / "new", "--kernel", later)
            self.assertEqual(done.returncode, 1, done.stdout)
            self.assertTrue(done.stdout.startswith("axiscert compare: worse: "), done.stdout)
            self.assertNotIn("mended", done.stdout)


class NotJudged(GatesCase):
    def test_a_kernel_that_cannot_be_loaded_is_never_a_pass(self):
        text = self.folder / "text.so"
        text.write_text("no shared object\n")
        for kernel in (text, *(BUILD / f"declarations/{name}.so" for name in ("no_symbol", "wrong_abi", "unknown_predicate"))):
            for beside in ((), ("published",)):
                with self.subTest(kernel=kernel, beside=beside):
                    done = self.judged("out", f"plugin:{kernel}", *beside)
                    self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
                    self.assertIn(f"plugin:{kernel}: NOT JUDGED: it could not be loaded", done.stderr)
                    self.assertEqual(done.stderr.count(f"plugin:{kernel}: it could not be loaded"), len(beside), "before others are asked")
                    self.assertEqual([line for line in done.stdout.splitlines() if line.startswith(f"plugin:{kernel}: load")], [])

    def test_a_process_that_dies_while_it_loads(self):
        source, kernel = self.folder / "dies.c", self.folder / "dies.so"
        source.write_text("#include <stdlib.h>\n__attribute__((constructor)) static void die(void) { abort(); }\n")
        subprocess.run(["cc", "-shared", "-fPIC", source, "-o", kernel], check=True)
        done = self.judged("out", f"plugin:{kernel}")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("NOT JUDGED: it could not be loaded: while it was loaded", done.stderr)
        # Nor is the comparison of two such runs.
        compared = axiscert("compare", self.folder / "out", self.folder / "out", "--out", self.folder / "compared")
        self.assertEqual(compared.returncode, 1, compared.stdout + compared.stderr)
        self.assertIn("NOT COMPARED: nothing was compared", compared.stdout.splitlines()[0])
        written = json.loads((self.folder / "compared/compare.json").read_text())
        self.assertEqual((written["compared"], written["passes"]), (0, False))
        self.assertEqual(validate(SCHEMAS / "comparison.schema.json", self.folder / "compared/compare.json").stderr, "")
        self.assertIn("NOT COMPARED: nothing was compared", (self.folder / "compared/compare.html").read_text())

    def test_a_family_without_a_query(self):
        queries = self.folder / "double.jsonl"
        queries.write_text('{"id":"q","precision":"binary64","a":[2,0,0],"b":[2,1,0],"c":[3,0,0],"p":[0,0,0],"r":1}\n')
        kernel = self.built("build/my_kernel.so")  # in binary32
        done = self.judged("out", kernel, plan=[*PLAN, "--queries", queries])
        self.assertEqual(done.returncode, 2 if "no queries" in done.stderr else 1, done.stderr)
        if done.returncode == 1:
            self.assertIn("NOT JUDGED on queries/double.jsonl: no valid query", done.stderr)

    def test_conservative_takes_a_contact(self):
        for distance, code, said in ((20, 1, "NOT CHECKED: no query is a contact that it could miss"), (0, 0, "1 of 1 promised contacts looked at: met")):
            queries = self.folder / "one.jsonl"
            queries.write_text(json.dumps({"id": "q", "precision": "binary32", "a": [distance, 0, 0], "b": [distance, 1, 0],
                                           "c": [distance + 1, 0, 0], "p": [0, 0, 0], "r": 1}))
            done = axiscert("run", "--kernel", "published", "--queries", queries, "--precision", "binary32", "--require", "conservative",
                            "--out", self.folder / f"out-{distance}")
            self.assertEqual(done.returncode, code, done.stderr)
            self.assertIn(said, done.stdout + done.stderr)

    def test_two_spellings_of_a_path_are_one_kernel(self):
        kernel = self.built("build/my_kernel.so")
        done = self.judged("out", kernel, kernel.replace("/build/", "/build/./"))
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("which is judged once", done.stderr)
        record = json.loads((self.folder / "out/record.json").read_text())
        self.assertEqual([k["id"] for k in record["kernels"]], [kernel])
        self.assertEqual(record["kernels"][0]["name"], "my-kernel")

    def test_two_kernels_of_one_name_are_known_by_their_ids(self):
        first, second = self.built("build/my_kernel.so"), self.built("build/again.so", margin="0.3f")
        for out in ("one", "two"):
            self.assertEqual(self.judged(out, first, second).returncode, 0)
        done = axiscert("compare", self.folder / "one", self.folder / "two", "--no-replay", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual([k["name"] for k in json.loads(done.stdout)["kernels"]], [first, second])
        self.assertIn(f"kernel: {first} plugin:", (self.folder / "one/ratchet.txt").read_text())

    def test_witnesses_are_evaluated_by_the_plugin_wherever_it_is(self):
        self.base()
        (self.folder / "elsewhere").mkdir()
        moved = shutil.move(self.folder / "build/my_kernel.so", self.folder / "elsewhere")
        args = ("compare", self.folder / "base", self.folder / "base", "--kernel", f"plugin:{moved}")
        done = axiscert(*args)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        self.assertRegex(done.stdout, r"evaluated again here: \d+ as before\.")
        other = self.built("build/other.so", name="other")
        self.refused(*args[:3], "--kernel", other, says=["not in", "it declares the name 'other'"])


class CodeScanning(GatesCase):
    def results(self, out="new"):
        sarif = self.folder / out / "report.sarif"
        self.assertEqual(validate(REPORTS / "testing/sarif-2.1.0-rtm.5.json", sarif).stderr, "")
        return json.loads(sarif.read_text())["runs"][0]["results"]

    def test_what_is_accepted_is_suppressed(self):
        self.base()
        self.assertEqual({r["level"] for r in self.results("base")} - {"note"}, {"warning"})
        done = self.judged("new", f"plugin:{self.folder}/build/my_kernel.so", more=("--ratchet", self.folder / "accepted.txt"))
        self.assertEqual(done.returncode, 0, done.stderr)
        results = self.results()
        self.assertTrue(results)
        for result in results:
            (suppression,) = result["suppressions"]
            self.assertEqual((result["level"], suppression["kind"]), ("note", "external"))
            self.assertIn("accepted.txt by geometry: as it was", suppression["justification"])
        worse = self.built("build/my_kernel.so", margin="0.3f")
        self.assertEqual(self.judged("new", worse, more=("--ratchet", self.folder / "accepted.txt")).returncode, 1)
        open_ones = [r for r in self.results() if not r["suppressions"]]
        self.assertIn("phantom-contact", {r["ruleId"] for r in open_ones})
        self.assertIn("worse-than-accepted", {r["ruleId"] for r in open_ones})

    def test_results_are_at_the_source(self):
        def places(*args):
            self.assertEqual(self.judged("new", kernel, "published", plan=[*PLAN, "--family", "repeated"], more=args).returncode, 0)
            return {(r["locations"][0]["logicalLocations"][0]["fullyQualifiedName"].split("/binary32")[0],
                     r["locations"][0]["physicalLocation"]["artifactLocation"]["uri"],
                     r["locations"][0]["physicalLocation"]["region"]["startLine"] if "jsonl" not in str(r["locations"]) else 0)
                    for r in self.results()}

        kernel = self.built("build/my_kernel.so")
        line = SOURCE[:SOURCE.index("\nAXISCERT_PLUGIN(")].count("\n") + 2
        own = f"file://{self.folder}/my_kernel.c"
        self.assertEqual(places(), {("plugin/my-kernel", own, line), ("published", "witnesses.jsonl", 0)})
        given = self.folder / "my kernel.c"
        given.write_text("\n")
        uri = f"file://{self.folder}/my%20kernel.c"
        self.assertEqual(places("--source", f"{given}:7"), {("plugin/my-kernel", uri, 7), ("published", uri, 7)})
        self.assertEqual(places("--source", f"published={given}:7"), {("plugin/my-kernel", own, line), ("published", uri, 7)})
        for value, says in ((str(given), "give FILE:LINE"), (f"{given}:0", "give FILE:LINE"), ("nosuch.c:1", "no file nosuch.c")):
            self.refused("run", *PLAN, "--source", value, "--out", self.folder / "none", says=[f"--source {value}", says])
        self.assertFalse((self.folder / "none").exists())

    def test_a_kernel_that_shows_only_verdicts_has_no_cases_of_comparisons(self):
        self.base()
        junit = (self.folder / "base/junit.xml").read_text()
        self.assertEqual(re.findall(r'<testcase [^>]*name="([^"]*)"', junit), ["general verdict", "comparisons"])
        self.assertIn("NOT CHECKED: the kernel shows only verdicts", junit)
        done = subprocess.run(["xmllint", "--noout", "--schema", REPORTS / "testing/junit.xsd", self.folder / "base/junit.xml"],
                              capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)


if __name__ == "__main__":
    unittest.main()
