#!/usr/bin/env python3
"""`run` as a user sees it: its record, its exit codes, and builds with a planted fault."""
import json
import math
import re
import signal
import subprocess
import sys
import time
import unittest

import jsonschema

from command import BUILD, DIVISOR, MODELS, QUERY, SCHEMAS, VALIDATE, Case, axiscert, family, fewer


class RunCase(Case):
    def check_targets(self, trials):
        plan = ["--trials", trials, "--kernel", "published", "--kernel", "nonstrict", "--family", "all",
                "--mesh", MODELS / "OBJ/spider.obj"]
        self.run_ok(*plan, "--threads", 2)
        reference = (self.folder / "out/record.json").read_bytes()
        targets = json.loads(axiscert("kernels", "--format", "json").stdout)["kernels"][0]["targets"]
        self.assertIn("scalar", targets)
        for target in targets:
            self.run_ok(*plan, "--threads", 1, "--target", target, out=target)
            self.assertEqual((self.folder / target / "record.json").read_bytes(), reference, target)

    def check_filters(self, trials, kernels):
        arguments = ["--family", "all", "--mesh", MODELS / "OBJ/spider.obj", "--trials", trials, "--tolerance", "3",
                     "--tolerance", "plane.radius=0.5"]
        for kernel in kernels:
            arguments += ["--kernel", kernel]
        records = []
        for name, options in (("filtered", []), ("exact", ["--exact-only"])):
            done = axiscert("run", *arguments, *options, "--out", self.folder / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            records.append((self.folder / name / "record.json").read_bytes())
        self.assertEqual(*records)
        counts = [json.loads((self.folder / name / "run.json").read_text()) for name in ("filtered", "exact")]
        self.assertLess(counts[0]["second_opinions"], counts[1]["second_opinions"])


class RunLong(RunCase):
    """As in Run, for more queries and kernels."""

    def test_the_record_does_not_depend_on_threads_or_target(self):
        self.check_targets(fewer(3000 // DIVISOR))

    def test_the_record_does_not_depend_on_the_filters(self):
        self.check_filters(fewer(4100 // DIVISOR), ["published", "nonstrict", "reduced", "published+fma", "packed-nonstrict", "eigen",
                                                    "closest-point"])


def spoiled_records(record):
    """Pairs of a place and the record without a member, or with another type, there."""
    seen = {("schema",)}  # which is refused before the others, in other words

    def places(value, path, shape):
        for key, inner in value.items() if isinstance(value, dict) else enumerate(value):
            kind = "*" if isinstance(value, list) else key
            if (*shape, kind) not in seen:
                seen.add((*shape, kind))
                yield (*path, key)
            if isinstance(inner, (dict, list)):
                yield from places(inner, (*path, key), (*shape, kind))

    for *folder, key in list(places(record, (), ())):
        inner = record
        for step in folder:
            inner = inner[step]
        kept = inner[key]
        inner[key] = [[]] if isinstance(kept, dict) else {"nonsense": 0}
        yield "".join(f"/{step}" for step in (*folder, key)), record
        inner[key] = kept
        if isinstance(inner, dict):
            del inner[key]
            yield f'without "{key}"', record
            inner[key] = kept


class Run(RunCase):
    def test_the_record_does_not_depend_on_threads_or_target(self):
        self.check_targets(fewer(60))

    def test_the_record_does_not_depend_on_the_filters(self):
        self.check_filters(fewer(60), ["published", "packed-nonstrict", "closest-point"])

    def test_record_and_run_info_satisfy_their_schemas(self):
        self.run_ok("--trials", fewer(100), "--kernel", "published", "--kernel", "nonstrict", "--tolerance",
                    "plane.radius=10")
        for name, schema in {name: SCHEMAS / f"{name}.schema.json" for name in ("record", "run")}.items():
            done = subprocess.run([sys.executable, VALIDATE, schema, self.folder / f"out/{name}.json"],
                                  capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for name in ("report.html", "report.md", "junit.xml", "witnesses.jsonl"):
            self.assertTrue((self.folder / "out" / name).stat().st_size > 0, name)

    def test_what_the_schema_refuses_is_refused_with_the_place(self):
        """A record spoiled once for each place of another shape: the schema and the command agree."""
        validator = jsonschema.Draft202012Validator(json.loads((SCHEMAS / "record.schema.json").read_text()))
        record = self.run_ok("--kernel", "moving-sphere/gated", "--family", "moving-sphere/orders", "--trials", 40, "--precision", "binary32")
        refused = 0
        for path, spoiled in spoiled_records(record):
            if validator.is_valid(spoiled):
                continue
            (self.folder / "out/record.json").write_text(json.dumps(spoiled))
            self.refused("report", self.folder / "out", says=[f"record.json", path])
            refused += 1
        self.assertGreater(refused, 150)

    def test_families_say_what_they_cost_and_dear_ones_are_asked_less(self):
        listed = json.loads(axiscert("families", "--format", "json").stdout)["families"]
        costly = [family["name"] for family in listed if family["cost"] > 1]
        self.assertLessEqual({"speck", "bits"}, set(costly))
        shown = [line.split()[0] for line in axiscert("families").stdout.splitlines() if re.search(r" \[cost \d+\]$", line)]
        self.assertEqual(shown, costly, "./dev exhaust reads them there")
        done = axiscert("generate", "--family", "bits", "--precision", "binary64")
        self.assertEqual(done.stdout.count("\n"), 2**14)
        self.assertIn("16384 for bits)", " ".join(axiscert("run", "--help").stdout.split()))

    def test_truth_and_degenerate_families(self):
        record = self.run_ok("--kernel", "published", "--kernel", "nonstrict", "--family", "lattice", "--family",
                             "collinear", "--family", "repeated", "--trials", 20000 // DIVISOR)
        for precision in ("binary32", "binary64"):
            for name in ("lattice", "collinear", "repeated"):
                strict = family(record, name, precision)["verdict"]
                self.assertGreater(strict["links"]["specification"], 0, name)
                mended = family(record, name, precision, "nonstrict")["verdict"]
                self.assertEqual(mended["links"]["specification"], 0, name)
            lattice = family(record, "lattice", precision)["verdict"]
            self.assertEqual(lattice["false_separation"], 0)
            self.assertEqual(lattice["links"]["specification"], lattice["false_contact"])
            mended = family(record, "lattice", precision, "nonstrict")
            self.assertEqual((mended["verdict"]["false_separation"], mended["verdict"]["false_contact"]), (0, 0))
            for comparison in mended["comparisons"].values():
                self.assertEqual(comparison["false_separation"] + comparison["missed_separation"], 0)

    def test_rounding_and_range(self):
        record = self.run_ok("--family", "tangent", "--family", "scale", "--family", "general", "--trials", 20000 // DIVISOR)
        tangent = family(record, "tangent")["verdict"]
        self.assertTrue(tangent["false_separation"] > 0 and tangent["false_contact"] > 0)
        self.assertGreater(tangent["links"]["rounding"], 0)
        self.assertGreater(family(record, "scale")["verdict"]["links"]["range"], 0)
        general = family(record, "general")["verdict"]
        self.assertEqual((general["false_separation"], general["false_contact"]), (0, 0))

    def test_the_smallest_passing_tolerance_passes_and_one_step_below_fails(self):
        plan = ["--family", "tangent", "--family", "seam", "--precision", "binary32", "--trials", 5000 // DIVISOR]
        first = self.run_ok(*plan)
        smallest = {}
        for name in ("tangent", "seam"):
            for comparison, found in family(first, name)["comparisons"].items():
                self.assertIsNone(found["tolerance_failures"])
                smallest[comparison] = max(smallest.get(comparison, 0), found["smallest_passing_tolerance"])

        def failures(tolerances):
            record = self.run_ok(*plan, *[f"--tolerance={c}={t}" for c, t in tolerances.items()])
            return {c: sum(family(record, n)["comparisons"][c]["tolerance_failures"] for n in ("tangent", "seam"))
                    for c in tolerances}

        def step_below(t):
            digits = 5 - math.floor(math.log10(t))
            return f"{t - 10.0 ** -digits:.{max(digits, 0)}f}"

        self.assertEqual(set(failures({c: repr(t) for c, t in smallest.items()}).values()), {0})
        for comparison, count in failures({c: step_below(t) for c, t in smallest.items()}).items():
            self.assertGreater(count, 0, comparison)

    def test_requirements(self):
        degenerate = ["--family", "repeated", "--precision", "binary32", "--trials", 2000]
        self.run_ok(*degenerate, "--require", "logic", code=1)
        self.run_ok(*degenerate, "--require", "logic", "--kernel", "nonstrict", code=0)
        self.run_ok("--family", "scale", "--precision", "binary32", "--trials", 2000, "--require", "range", code=1)
        self.run_ok("--family", "general", "--precision", "binary32", "--trials", 2000, "--require", "exact", code=0)

    def test_each_level_given_has_to_be_met_and_is_told_of_each_kernel(self):
        plan = ["--kernel", "published", "--kernel", "nonstrict", "--family", "repeated", "--precision", "binary32", "--trials", 2000]
        record = self.run_ok(*plan, "--require", "logic", "--require", "depth=1", code=1)
        self.assertEqual(record["plan"]["require"], ["logic", "depth=1"])
        told = json.loads((self.folder / "out/run.json").read_text())["requirements"]
        self.assertEqual([(o["level"], o["kernel"], o["state"]) for o in told],
                         [("logic", "published", "not met"), ("logic", "nonstrict", "met"),
                          ("depth=1", "published", "met"), ("depth=1", "nonstrict", "met")])
        self.assertIn("its reference computes them", told[1]["covers"])
        self.assertIn("rounding and range", told[1]["leaves_out"])

    def test_no_worse_than_another_kernel_of_the_run(self):
        plan = ["--kernel", "published", "--kernel", "nonstrict", "--family", "repeated", "--precision", "binary32", "--trials", 2000]
        self.run_ok(*plan, "--require", "no-worse-than=published", "--require", "logic")  # published itself need not meet it
        done = axiscert("run", *plan, "--require", "no-worse-than=nonstrict", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 1)
        self.assertRegex(done.stderr, r"published binary32 on repeated: phantom contacts, \d+ of 2,000, more than nonstrict with \d+ of")
        self.assertIn("after Holm's correction", done.stderr)

    def test_a_witness_replays_from_its_address_to_the_same_flips(self):
        record = self.run_ok("--family", "sliver", "--trials", 3000, "--mesh", MODELS / "OBJ/spider.obj")
        self.assertTrue(record["witnesses"])
        for witness in record["witnesses"][:40:4]:
            query = axiscert("query", witness["address"], "--mesh", MODELS / "OBJ/spider.obj")
            self.assertEqual(query.returncode, 0, query.stderr)
            self.assertEqual({k: json.loads(query.stdout)[k] for k in "abcpr"}, {k: witness[k] for k in "abcpr"})
            line = json.loads(axiscert("check", "-", "--format", "jsonl", stdin=query.stdout).stdout)
            self.assertEqual(line["flips"], witness["flips"])

    def test_query_files_and_standard_input(self):
        stored = self.folder / "mine.jsonl"
        stored.write_text(QUERY % 1 + QUERY % 2)
        record = self.run_ok("--queries", stored)
        self.assertEqual(family(record, "queries/mine.jsonl")["trials"], 2)
        self.assertEqual(family(record, "queries/mine.jsonl")["truth"]["touching"], 1)

    def test_a_time_limit_ends_the_run_and_lists_the_units(self):
        record = self.run_ok("--family", "general", "--precision", "binary32", "--time", 1)
        self.assertTrue(record["complete"])
        self.assertGreaterEqual(record["plan"]["units_done"]["general"]["binary32"], 1)

    def test_an_interrupt_keeps_what_there_is(self):
        process = subprocess.Popen([BUILD / "axiscert", "run", "--family", "general", "--precision", "binary32",
                                    "--trials", str(1 << 30), "--out", self.folder / "out"],
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        time.sleep(3)
        process.send_signal(signal.SIGINT)
        process.communicate(timeout=120)
        self.assertEqual(process.returncode, 130)
        record = json.loads((self.folder / "out/record.json").read_text())
        self.assertFalse(record["complete"])

    def test_report_renders_again_from_the_record(self):
        self.run_ok("--family", "repeated", "--trials", 500)
        before = (self.folder / "out/report.md").read_text()
        (self.folder / "out/report.md").unlink()
        done = axiscert("report", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual((self.folder / "out/report.md").read_text(), before)
        self.refused("report", self.folder / "nowhere", says=["nowhere"])


class PlantedLong(Case):
    """Faults put into the harness itself: it has to catch each and exit 3."""

    def test_a_corrupted_oracle(self):
        done = axiscert("run", "--family", "general", "--out", self.folder / "out", program="axiscert_planted_oracle")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("the oracles disagree", done.stderr)
        saved = axiscert("check", self.folder / "out/disagreement.jsonl", "--format", "jsonl")
        self.assertEqual(json.loads(saved.stdout)["exact"]["verdict"], "contact")

    def test_a_filter_that_lies(self):
        families = ["--family", "collinear", "--family", "sliver", "--family", "general", "--family", "scale"]
        for fault, says in (("small-bound", "the oracles disagree"), ("no-underflow-guard", "the oracles disagree"),
                            ("swapped-sign", "the oracles disagree"), ("rounding-mode", "rounding mode")):
            done = axiscert("run", "--plant", fault, *families, "--trials", 30000, "--out", self.folder / fault)
            self.assertEqual(done.returncode, 3, done.stderr)
            self.assertIn(says, done.stderr)
            self.assertFalse((self.folder / fault / "record.json").exists())

    def test_a_contracted_build(self):
        for target in json.loads(axiscert("kernels", "--format", "json").stdout)["kernels"][0]["targets"]:
            if not target.startswith("AVX"):
                continue  # the others have no fused operation to contract to
            done = axiscert("run", "--family", "general", "--trials", 10, "--target", target, "--out",
                            self.folder / "out", program="axiscert_planted_contraction")
            self.assertEqual(done.returncode, 3, target)
            self.assertIn("self-check", done.stderr)


if __name__ == "__main__":
    unittest.main()
