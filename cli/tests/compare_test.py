#!/usr/bin/env python3
"""Tests of compare, the ratchet, and the files that CI reads."""
import json
import os
import re
import shutil
import subprocess
import unittest
import xml.etree.ElementTree as ElementTree

from command import BUILD, QUERY, REPORTS, SCHEMAS, VALIDATE, Case, axiscert

PLAN = ["--family", "repeated", "--family", "tangent", "--trials", "1000", "--precision", "binary32"]


def validate(schema, *files):
    return subprocess.run(["/usr/bin/python3", VALIDATE, schema, *files],
                          capture_output=True, text=True)


class Compare(Case):
    def compare(self, old, new, *args, code=0):
        done = axiscert("compare", self.folder / old, self.folder / new, *args)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def test_a_run_with_itself_and_with_another_seed(self):
        self.run_ok(*PLAN)
        self.run_ok(*PLAN, "--seed", "2", out="seed2")
        self.assertTrue(self.compare("out", "out").startswith("axiscert compare: no change\n"))
        text = self.compare("out", "seed2")
        self.assertTrue(text.startswith("axiscert compare: no change\n"), text)
        self.assertRegex(text, r"Witnesses of OLD, evaluated again here: \d+ as before\.")

    def test_what_is_worse_is_named_in_every_format(self):
        self.run_ok(*PLAN)
        record = json.loads((self.folder / "out/record.json").read_text())
        worse = self.folder / "worse"
        worse.mkdir()
        verdict = record["kernels"][0]["families"]["repeated"]["verdict"]
        verdict["false_contact"] += 1
        verdict["depths"]["false_contact"]["zero"] = verdict["depths"]["false_contact"].get("zero", 0) + 1
        (worse / "record.json").write_text(json.dumps(record))
        text = self.compare("out", "worse", "--out", self.folder / "compared", code=1)
        self.assertTrue(text.startswith("axiscert compare: worse: 1 worse\n"), text)
        self.assertRegex(text, r"worse +published +binary32 +repeated +verdict\.false_contact")
        self.assertIn("axiscert query", text, "a witness and how it is shown again")
        compared = self.folder / "compared"
        self.assertEqual(validate(SCHEMAS / "comparison.schema.json", compared / "compare.json").stderr, "")
        self.assertEqual(json.loads((compared / "compare.json").read_text())["alarms"], 1)
        self.assertIn("| worse | published |", (compared / "compare.md").read_text())
        self.assertIn("<h1>axiscert compare: worse: 1 worse</h1>", (compared / "compare.html").read_text())
        self.assertEqual(json.loads(self.compare("out", "worse", "--format", "json", code=1))["alarms"], 1)
        self.assertEqual(self.compare("out", "worse", "--quiet", code=1), "")

    def test_bad_records_are_one_clear_error_and_nothing_is_written(self):
        self.run_ok("--family", "repeated", "--trials", "100", "--precision", "binary32")
        good = (self.folder / "out/record.json").read_text()
        bad, out = self.folder / "bad", self.folder / "compared"
        bad.mkdir()
        for text, says in {
            good.replace("axiscert-record/8", "axiscert-record/7"): ['its schema is "axiscert-record/7"', "axiscert-record/8", "again with `axiscert run`"],
            good.replace('"predicate": "sphere-triangle"', '"predicate": "nosuch"'): ["/plan/predicate", "unknown predicate 'nosuch'", "sphere-triangle"],
            good[:-100]: ["cut off"],
            good.replace('"plane.radius"', '"plane.radios"', 1): ["plane.radi"],
            good.replace('"trials": 100', '"trials": 101'): ["do not add up"],
            "": ["not JSON"],
        }.items():
            (bad / "record.json").write_text(text)
            for pair in ((bad, self.folder / "out"), (self.folder / "out", bad)):
                with self.subTest(says=says):
                    done = self.refused("compare", *pair, "--out", out, says=["bad/record.json", *says])
                    self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                    self.assertFalse(out.exists(), "output was begun")
        self.refused("compare", self.folder / "out", self.folder / "none", says=["none/record.json", "does not exist"])


    def test_a_record_that_lost_families_or_is_interrupted_is_no_pass(self):
        self.run_ok(*PLAN)
        self.run_ok(*PLAN[:2], *PLAN[4:], out="few")
        text = self.compare("out", "few", code=1)
        self.assertTrue(text.startswith("axiscert compare: NOT COMPARED: tangent: is only in OLD; the rest: no change\n"), text)
        self.assertTrue(self.compare("few", "out").startswith("axiscert compare: no change; only in NEW: tangent\n"))
        text = self.compare("out", "few", "--allow-not-compared", "tangent")
        self.assertTrue(text.startswith("axiscert compare: no change; NOT COMPARED, as allowed: tangent: is only in OLD\n"), text)
        self.assertIn("--allow-not-compared tangent", self.compare("out", "few", "--allow-not-compared", "tangent", "--format", "markdown"))
        self.refused("compare", self.folder / "out", self.folder / "few", "--allow-not-compared", "repeated",
                     says=["--allow-not-compared 'repeated': not compared is: tangent"])
        self.refused("compare", self.folder / "out", self.folder / "out", "--allow-not-compared", "tangent", says=["everything was compared"])
        # Interrupted: what it did not come to is not right.
        record = json.loads((self.folder / "out/record.json").read_text())
        record["complete"], record["plan"]["units_done"] = False, {family: {"binary32": 1} for family in record["plan"]["families"]}
        (self.folder / "cut").mkdir()
        (self.folder / "cut/record.json").write_text(json.dumps(record))
        for pair, which in ((("out", "cut"), "NEW"), (("cut", "out"), "OLD")):
            text = self.compare(*pair, code=1)
            self.assertTrue(text.startswith(f"axiscert compare: NOT COMPARED: {which}: is INTERRUPTED"), text)
            self.assertEqual(self.compare(*pair, "--quiet", "--allow-not-compared", which), "")

    def test_a_plugin_that_a_record_names_is_loaded_for_who_names_it_alone(self):
        source, kernel, loaded = (self.folder / name for name in ("kernel.c", "kernel.so", "loaded"))
        source.write_text(f'''
#include <stdio.h>
__attribute__((constructor)) static void tell(void) {{ FILE* file = fopen("{loaded}", "w"); if (file) fclose(file); }}''')
        subprocess.run(["cc", "-shared", "-fPIC", source, "-o", kernel], check=True)
        self.run_ok(*PLAN)
        record = (self.folder / "out/record.json").read_text()
        (self.folder / "out/record.json").write_text(record.replace('"published"', json.dumps(f"plugin:{kernel}")))
        text = self.compare("out", "out")
        self.assertIn("not replayed", text)
        self.assertIn(f"--kernel plugin:{kernel}", text)
        self.assertFalse(loaded.exists(), "what the record names was run")
        self.compare("out", "out", "--kernel", f"plugin:{kernel}")
        self.assertTrue(loaded.exists(), "the user named it")
        self.refused("compare", self.folder / "out", self.folder / "out", "--kernel", "plugin:other.so",
                     says=["--kernel plugin:other.so", "which has: plugin:"])

    def test_a_folder_whose_name_is_not_utf8(self):
        def run(*args):
            return subprocess.run([os.fsencode(BUILD / "axiscert"), *map(os.fsencode, args)], capture_output=True, cwd=self.folder)

        out = os.fsdecode(b"caf\xe9 '")
        self.assertEqual(run("run", *PLAN, "--out", out).returncode, 0)
        self.assertEqual(run("report", out).returncode, 0)
        done = run("compare", out, out, "--format", "markdown", "--out", os.fsdecode(b"c\xff"))
        self.assertEqual((done.returncode, done.stderr), (0, b""))
        compared = json.loads((self.folder / os.fsdecode(b"c\xff") / "compare.json").read_text())
        self.assertEqual(compared["old"]["folder"], "caf\\xe9 '")
        # A shell reads the command that is shown as the bytes of the folder's name.
        (line,) = [line for line in done.stdout.decode().splitlines() if "axiscert compare $" in line]
        word = line[line.index("$'"):].split(" $'")[0]
        self.assertEqual(subprocess.run(["bash", "-c", f"printf %s {word}"], capture_output=True).stdout, os.fsencode(out))
        # Names that a record would have to hold are refused, once and clearly.
        queries, mesh, kernel = (os.fsdecode(name) for name in (b"q\xff.jsonl", b"m\xff.obj", b"k\xff.so"))
        for name, text in {queries: QUERY % 1, kernel: "", mesh: "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"}.items():
            (self.folder / name).write_text(text)
        for args in (["--queries", queries], ["--mesh", mesh], ["--kernel", "plugin:" + kernel]):
            done = run("run", *args, "--out", "none")
            self.assertEqual(done.returncode, 2, done.stderr)
            self.assertIn(b"\\xff", done.stderr)
            self.assertIn(b"not UTF-8", done.stderr)
            self.assertEqual(len(done.stderr.splitlines()), 1, done.stderr)
        self.assertFalse((self.folder / "none").exists())


class Ratchet(Case):
    """A user's own kernel under one name: unchanged, with a fault, and mended."""

    def setUp(self):
        super().setUp()
        self.kernel, self.ratchet = self.folder / "kernel.so", self.folder / "ratchet.txt"

    def judge(self, fault, *args):
        shutil.copy(BUILD / "faults" / f"{fault}.so", self.kernel)
        return axiscert("run", "--kernel", f"plugin:{self.kernel}", *PLAN, "--out", self.folder / "out", *args)

    def accept(self, expiry="never"):
        text = (self.folder / "out/ratchet.txt").read_text()
        self.ratchet.write_text(text.replace("EXPIRY OWNER REASON", f"{expiry} mk rounds"))

    def test_a_planted_regression_is_named_and_its_mending_passes(self):
        self.assertEqual(self.judge("none").returncode, 0)
        self.accept()
        self.assertEqual(self.judge("none", "--ratchet", self.ratchet).returncode, 0)
        done = self.judge("dropped_side", "--ratchet", self.ratchet)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("vertex_b.side_c.false_separation", done.stderr)
        self.assertIn("out/ratchet.txt would accept this run", done.stderr)
        for again in (False, True):  # as the run wrote them, and as `report` writes them again from the folder
            self.assertTrue(not again or axiscert("report", self.folder / "out").returncode == 0)
            junit = ElementTree.parse(self.folder / "out/junit.xml").getroot()
            failed = [case.get("name") for case in junit.iter("testcase") if case.find("failure[@type='ratchet']") is not None]
            self.assertIn("repeated vertex_b.side_c", failed)
            self.assertEqual([case for case in junit.iter("testcase") if case.find("skipped") is not None], [], "all was held")
            (run,) = json.loads((self.folder / "out/report.sarif").read_text())["runs"]
            worse = [r for r in run["results"] if r["ruleId"] == "worse-than-accepted"]
            self.assertEqual(len(worse), done.stderr.count("axiscert: --ratchet: "))
            self.assertIn("the ratchet is not met", (self.folder / "out/report.md").read_text())
        for name, schema in {"report.sarif": REPORTS / "testing/sarif-2.1.0-rtm.5.json",
                             "ratchet.json": SCHEMAS / "ratchet.schema.json"}.items():
            self.assertEqual(validate(schema, self.folder / "out" / name).stderr, "")
        done = self.judge("none", "--ratchet", self.ratchet, "--quiet")
        self.assertEqual((done.returncode, done.stdout, done.stderr), (0, "", ""))
        self.assertEqual(self.judge("none").returncode, 0)
        self.assertFalse((self.folder / "out/ratchet.json").exists(), "of the run before")

    def test_better_prints_the_line_and_holds(self):
        self.judge("none")
        self.accept()
        accepted = self.ratchet.read_text()
        (figure,) = re.findall(r"repeated\nverdict .*false_contact=(\d+) ", accepted)
        self.ratchet.write_text(accepted.replace(f"false_contact={figure} ", f"false_contact={int(figure) + 1} "))
        done = self.judge("none", "--ratchet", self.ratchet)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn(f"verdict.false_contact: {figure}, accepted is {int(figure) + 1}", done.stdout)
        self.assertIn("out/ratchet.txt has what is accepted with the figures of now", done.stdout)
        self.assertEqual(re.sub("^#.*\n", "", (self.folder / "out/ratchet.txt").read_text(), flags=re.M),
                         re.sub("^#.*\n", "", accepted, flags=re.M), "what the run writes holds what it accepts now")

    def test_an_expired_waiver_fails(self):
        self.judge("none")
        self.accept("2001-01-01")
        done = self.judge("none", "--ratchet", self.ratchet)
        self.assertEqual(done.returncode, 1)
        self.assertIn("expired on 2001-01-01 (mk, rounds)", done.stderr)

    def test_what_is_refused(self):
        out = self.folder / "none"
        self.refused("run", "--ratchet", self.folder / "no.txt", "--out", out, says=["no.txt", "cannot be read"])
        for version in "12":
            self.ratchet.write_text(f"axiscert-ratchet/{version} x\n")
            self.refused("run", "--ratchet", self.ratchet, "--out", out,
                         says=[f"ratchet.txt:1: 'axiscert-ratchet/{version}'", "run without --ratchet, and review the ratchet.txt"])
        head = "axiscert-ratchet/5 %s\nkernel: published\npromise: binary32 queries=9 touching=contact\n"
        self.ratchet.write_text(head % "x" + "nonsense\n")
        self.refused("run", "--ratchet", self.ratchet, "--out", out, says=["ratchet.txt:4", "'nonsense' before accept:"])
        self.ratchet.write_text(head % "x")
        self.refused("run", "--ratchet", self.ratchet, "--time", "1", "--out", out, says=["--time", "--ratchet", "--trials"])
        self.refused("run", "--preset", "ci", "--time", "1", "--out", out, says=["--time", "--preset ci"])
        self.refused("run", "--preset", "nosuch", "--out", out, says=["nosuch", "ci"])
        self.assertFalse(out.exists(), "output was begun")
        self.refused("run", "--ratchet", self.ratchet, "--out", self.folder, says=["overwrite it"])
        self.assertEqual(self.ratchet.read_text(), head % "x")
        self.ratchet.write_text(head % "0123456789abcdef")
        done = self.refused("run", *PLAN, "--ratchet", self.ratchet, "--out", out, says=["0123456789abcdef", "not comparable"])
        self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.assertFalse(out.exists(), "the run was done before its ratchet was looked at")


class CiFormats(Case):
    def test_they_conform_to_their_schemas(self):
        self.run_ok(*PLAN, "--require", "logic", "--tolerance", "plane.radius=1", code=1)
        stored = self.folder / "stored"  # with findings and names that have to be escaped
        shutil.copytree(REPORTS / "testing", stored)
        record = json.loads((stored / "record.json").read_text())
        self.assertEqual(axiscert("report", stored).returncode, 0)
        for folder in (self.folder / "out", stored):
            done = subprocess.run(["xmllint", "--noout", "--schema", REPORTS / "testing/junit.xsd", folder / "junit.xml"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual(validate(REPORTS / "testing/sarif-2.1.0-rtm.5.json", folder / "report.sarif").stderr, "")
        # One case for each kernel, family and comparison, and one verdict for each.
        suites = ElementTree.parse(self.folder / "out/junit.xml").getroot()
        self.assertEqual(sum(len(suite.findall("testcase")) for suite in suites), 2 * 17)
        for suite in suites:
            for outcome in ("failure", "skipped"):
                counted = suite.get("failures" if outcome == "failure" else outcome)
                self.assertEqual(int(counted), len(suite.findall(f"testcase/{outcome}")))
        results = json.loads((stored / "report.sarif").read_text())["runs"][0]["results"]
        lines = (stored / "witnesses.jsonl").read_text().splitlines()
        for result in results:
            line = result["locations"][0]["physicalLocation"]["region"]["startLine"]
            if "Reproduced by" in result["message"]["text"]:
                self.assertIn(json.loads(lines[line - 1])["id"], [w["id"] for w in record["witnesses"]])

    def test_the_schemas_are_not_blind(self):
        self.run_ok("--family", "repeated", "--trials", "100", "--precision", "binary32")
        sarif, junit = self.folder / "out/report.sarif", self.folder / "out/junit.xml"
        log = json.loads(sarif.read_text())
        log["runs"][0]["results"][0]["locations"][0]["physicalLocation"]["region"]["startLine"] = 0
        sarif.write_text(json.dumps(log))
        self.assertEqual(validate(REPORTS / "testing/sarif-2.1.0-rtm.5.json", sarif).returncode, 1)
        junit.write_text(junit.read_text().replace(" hostname=\"localhost\"", ""))
        done = subprocess.run(["xmllint", "--noout", "--schema", REPORTS / "testing/junit.xsd", junit], capture_output=True)
        self.assertNotEqual(done.returncode, 0)

    def test_fingerprints_are_the_same_in_every_run(self):
        def prints(seed):
            self.run_ok("--family", "repeated", "--trials", "1000", "--precision", "binary32", "--seed", seed)
            results = json.loads((self.folder / "out/report.sarif").read_text())["runs"][0]["results"]
            found = {r["locations"][0]["logicalLocations"][0]["fullyQualifiedName"]: r["partialFingerprints"]["axiscertCell/v1"]
                     for r in results}
            self.assertEqual(len(found), len(set(found.values())), "one a cell")
            return found

        first, second = prints(1), prints(2)
        both = first.keys() & second.keys()
        self.assertIn("published/binary32/repeated/verdict.false_contact", both)
        for name in both:
            self.assertEqual(first[name], second[name])


if __name__ == "__main__":
    unittest.main()
