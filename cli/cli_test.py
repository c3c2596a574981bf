#!/usr/bin/env python3
"""The command as a user meets it: output, exit codes, one clear line for every bad input.

Usage: cli_test.py BUILD_FOLDER MODELS_FOLDER TRIAL_DIVISOR [unittest arguments]
The divisor makes the larger plans smaller for builds that are many times slower.
"""
import json
import math
import os
import signal
import subprocess
import sys
import tempfile
import time
import unittest
from fractions import Fraction
from pathlib import Path

BUILD, MODELS, DIVISOR = Path(sys.argv.pop(1)).resolve(), Path(sys.argv.pop(1)).resolve(), int(sys.argv.pop(1))
ROOT = Path(__file__).resolve().parent.parent
REPORTS = ROOT / "reports"


def axiscert(*args, program="axiscert", stdin=None):
    return subprocess.run([BUILD / program, *map(str, args)], input=stdin, capture_output=True, text=True, timeout=600)


class Case(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)

    def run_ok(self, *args, out="out", code=0):
        done = axiscert("run", *args, "--out", self.folder / out)
        self.assertEqual(done.returncode, code, done.stderr)
        return json.loads((self.folder / out / "record.json").read_text())

    def refused(self, *args, says, stdin=None, code=2):
        done = axiscert(*args, stdin=stdin)
        self.assertEqual(done.returncode, code, f"{args}: {done.stdout}{done.stderr}")
        for part in says:
            self.assertIn(part, done.stderr)
        self.assertNotIn("terminate called", done.stderr)
        return done


def family(record, name, precision="binary32", kernel="published"):
    (entry,) = [k for k in record["kernels"] if k["id"] == kernel and k["precision"] == precision]
    return entry["families"][name]


QUERY = '{"id":"q","precision":"binary32","a":[2,0,0],"b":[2,0,0],"c":[3,0,0],"p":[0,0,0],"r":%s}\n'


class Check(Case):
    def check(self, text, *args):
        done = axiscert("check", "-", "--format", "jsonl", *args, stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_a_repeated_vertex_is_a_specification_fault(self):
        (line,) = self.check(QUERY % 1)
        self.assertEqual(line["kernel"], "published")
        self.assertEqual(line["exact"]["verdict"], "separated")
        self.assertFalse(line["exact"]["touching"])
        self.assertEqual(Fraction(line["exact"]["squared_distance"]), 4)
        self.assertEqual(line["computed"]["verdict"], "contact")
        self.assertEqual(line["flips"], [{"level": "verdict", "name": "verdict", "kind": "false_contact",
                                          "decisive": True, "links": ["specification"]}])
        for key, length in (("comparisons", 16), ("axes", 7)):
            self.assertEqual(len(line["exact"][key]), length)
            self.assertEqual(line["exact"][key], line["computed"][key])
        self.assertEqual(self.check(QUERY % 1, "--kernel", "nonstrict")[0]["flips"], [])

    def test_touching_is_contact_and_a_tie(self):
        (line,) = self.check(QUERY % 2)
        self.assertEqual((line["exact"]["verdict"], line["exact"]["touching"]), ("contact", True))
        self.assertEqual(line["exact"]["ties"][1], "1", "vertex_a.radius")

    def test_invalid_is_an_answer(self):
        for radius in ('"nan"', '"inf"', '-1', '"-0x1p-149"'):
            (line,) = self.check(QUERY % radius)
            self.assertEqual(line["exact"]["verdict"], "invalid", radius)
            self.assertIsNone(line["exact"]["squared_distance"])
            self.assertEqual(line["flips"], [])

    def test_a_decimal_is_rounded_from_its_text(self):
        # The double nearest to this decimal lies on a midpoint of two floats; only the text says which is nearer.
        (line,) = self.check(QUERY.replace("[0,0,0]", "[1.00000005960464477540,0,0]") % 0)
        self.assertEqual(Fraction(line["exact"]["squared_distance"]), (2 - Fraction(float.fromhex("0x1.000002p0"))) ** 2)

    def test_text_is_one_line_a_query(self):
        done = axiscert("check", "-", stdin=QUERY % 1 + QUERY % 2)
        self.assertEqual(len(done.stdout.splitlines()), 2)
        self.assertIn("specification", done.stdout)


class BadInput(Case):
    def test_queries(self):
        good = QUERY % 1
        for text, says in {
            "{": ["stdin:1", "JSON"],
            good + '{"id":"x"}\n': [":2", "precision"],
            good.replace('"c":[3,0,0],', ""): [":1", "'c'"],
            QUERY % '"0x1.0000001p0"': [":1", "'r'", "not exact"],
            QUERY % "1e39": [":1", "'r'", "1e39"],
            QUERY % "1e999": [":1", "'r'", "1e999"],
            good.replace("binary32", "binary16"): [":1", "binary16", "binary64"],
            good.replace("[3,0,0]", "[3,0]"): [":1", "'c'"],
            good.replace("[3,0,0]", '"x"'): [":1", "'c'"],
            "": ["no queries"],
        }.items():
            with self.subTest(text=text):
                done = self.refused("check", "-", stdin=text, says=says)
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertEqual(done.stdout, "", "half-read")

    def test_names(self):
        self.refused("run", "--kernel", "nosuch", says=["unknown kernel 'nosuch'", "published"])
        self.refused("run", "--family", "nosuch", says=["unknown family 'nosuch'", "tangent"])
        self.refused("run", "--target", "nosuch", says=["target 'nosuch'", "scalar"])
        self.refused("run", "--precision", "binary16", says=["binary16", "binary64"])
        self.refused("run", "--require", "nosuch", says=["nosuch", "logic"])
        self.refused("run", "--tolerance", "plane.radios=3", says=["plane.radios", "plane.radius"])
        self.refused("run", "--tolerance", "plane.radius=three", says=["three", "decimal"])
        for option, wrong in (("--trials", "0"), ("--trials", "-5"), ("--trials", "many"), ("--seed", "-1"),
                              ("--time", "0"), ("--threads", "0")):
            done = self.refused("run", option, wrong, says=[option, wrong])
            self.assertLess(len(done.stderr), 200, done.stderr)
        self.refused("run", "--trials", "5", "--time", "1", says=["--time"])
        self.refused("check", self.folder / "none.jsonl", says=["none.jsonl"])
        self.refused("frobnicate", says=[])

    def test_addresses(self):
        for address, says in {
            "nonsense": ["SEED:NAME"],
            "1:nosuch:1:binary32:0:0": ["unknown family 'nosuch'"],
            "1:general:99:binary32:0:0": ["version 1", "99"],
            "1:general:1:binary33:0:0": ["binary33"],
            "1:general:1:binary32:0:65536": ["65536"],
            "1:general:1:binary32:-1:0": ["unit '-1'"],
            "1:mesh-00:1:binary32:0:0": ["--mesh FILE"],
        }.items():
            with self.subTest(address=address):
                self.refused("query", address, says=says)
        spider = MODELS / "OBJ/spider.obj"
        self.refused("query", "1:mesh-00:1:binary32:0:0", "--mesh", spider, says=["mesh-00"])

    def test_meshes(self):
        for model in ("invalid/empty.obj", "invalid/malformed.obj", "invalid/OutOfMemory.off", "OBJ/point_cloud.obj",
                      "nosuch.obj"):
            with self.subTest(model=model):
                out = self.folder / "out"
                done = self.refused("run", "--mesh", MODELS / model, "--out", out, says=[model])
                self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
                self.assertFalse(out.exists(), "output was begun")

    def test_unwritable_output(self):
        blocked = self.folder / "file"
        blocked.write_text("not a folder")
        self.refused("run", "--family", "general", "--trials", 10, "--out", blocked / "out", says=["--out", "cannot write"])


class Run(Case):
    def test_the_record_does_not_depend_on_threads_or_target(self):
        plan = ["--trials", 3000 // DIVISOR, "--kernel", "published", "--kernel", "nonstrict", "--family", "all",
                "--mesh", MODELS / "OBJ/spider.obj"]
        self.run_ok(*plan, "--threads", 2)
        reference = (self.folder / "out/record.json").read_bytes()
        targets = json.loads(axiscert("kernels", "--format", "json").stdout)[0]["targets"]
        self.assertIn("scalar", targets)
        for target in targets:
            self.run_ok(*plan, "--threads", 1, "--target", target, out=target)
            self.assertEqual((self.folder / target / "record.json").read_bytes(), reference, target)

    def test_record_and_run_info_satisfy_their_schemas(self):
        self.run_ok("--trials", 500, "--kernel", "published", "--kernel", "nonstrict", "--tolerance", "plane.radius=10")
        for name in ("record", "run"):
            done = subprocess.run([sys.executable, REPORTS / "validate.py", REPORTS / f"{name}.schema.json",
                                   self.folder / f"out/{name}.json"], capture_output=True, text=True)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
        for name in ("report.html", "report.md", "junit.xml", "witnesses.jsonl"):
            self.assertTrue((self.folder / "out" / name).stat().st_size > 0, name)

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

    def test_a_witness_replays_from_its_address_to_the_same_flips(self):
        record = self.run_ok("--family", "sliver", "--trials", 3000, "--mesh", MODELS / "OBJ/spider.obj")
        self.assertTrue(record["witnesses"])
        for witness in record["witnesses"][:40]:
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


class Ladder(Case):
    AXES = ("plane", "vertex_a", "vertex_b", "vertex_c", "edge_ab", "edge_bc", "edge_ca")
    PLAN = ("ladder", "--trials", 300, "--kernel", "ladder-8", "--kernel", "ladder-9", "--kernel", "reduced",
            "--kernel", "ladder-9+in-double")

    def test_figures_as_json(self):
        done = axiscert(*self.PLAN, "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        data = json.loads(done.stdout)
        self.assertEqual([k["id"] for k in data["kernels"]], ["ladder-8", "ladder-9", "reduced", "ladder-9+in-double"])
        for kernel in data["kernels"]:
            self.assertEqual(tuple(kernel["axes"]), self.AXES)
            for axis in kernel["axes"].values():
                self.assertEqual("worst_u" in axis, kernel["shows_sides"])
            self.assertEqual(sum(f["queries"] for f in kernel["families"].values()), kernel["queries"])
        self.assertEqual([(s["from"], s["to"]) for s in data["steps"]],
                         [("ladder-8", "ladder-9"), ("ladder-9", "reduced"), ("ladder-9", "ladder-9+in-double")])
        self.assertIn("reduced", data["speed"]["kernels"])

    def test_without_times_it_repeats_to_the_byte(self):
        first, second = (axiscert(*self.PLAN, "--no-speed", "--format", "json").stdout for _ in range(2))
        self.assertEqual(first, second)
        self.assertNotIn("speed", json.loads(first))

    def test_text_has_every_axis_and_out_gets_both_files(self):
        done = axiscert(*self.PLAN, "--precision", "binary64", "--kernel", "segments", "--no-speed", "--out",
                        self.folder / "out")
        self.assertEqual(done.returncode, 2, "in-double is of binary32 alone")
        self.assertIn("ladder-9+in-double", done.stderr)
        done = axiscert(*self.PLAN, "--no-speed", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        for axis in self.AXES:
            self.assertIn(axis, done.stdout)
        self.assertIn("no sides shown", done.stdout)
        self.assertTrue(json.loads((self.folder / "out/ladder.json").read_text())["kernels"])
        self.assertTrue((self.folder / "out/ladder.html").stat().st_size > 0)

    def test_bad_input(self):
        self.refused("ladder", "--kernel", "nosuch", says=["unknown kernel 'nosuch'", "ladder-9"])
        self.refused("ladder", "--kernel", "minkowski", says=["minkowski", "only its verdict", "ladder-0"])
        self.refused("ladder", "--kernel", "minkowski+fma", says=["minkowski"])
        self.refused("ladder", "--family", "nosuch", says=["unknown family 'nosuch'"])
        self.refused("ladder", "--precision", "binary16", says=["binary16"])
        self.refused("ladder", "--trials", "0", says=["--trials"])


class Precision(Case):
    KERNELS = ["--kernel", "ladder-0", "--kernel", "published", "--kernel", "nonstrict"]

    def test_figures_for_programs_and_a_page(self):
        done = axiscert("precision", *self.KERNELS, "--family", "tangent", "--family", "lattice", "--trials", 90,
                        "--bits", 12, "--bits", 256, "--bits", 24, "--format", "json", "--out", self.folder)
        self.assertEqual(done.returncode, 0, done.stderr)
        figures = json.loads(done.stdout)
        self.assertEqual(figures["bits"], [12, 24, 256])
        self.assertEqual(set(figures["families"]), {"tangent", "lattice"})
        self.assertEqual(figures["all"]["queries"], 180)
        twelve, single, most = figures["families"]["tangent"]["kernels"]["published"]["precisions"]
        self.assertGreater(twelve["rounding"], single["rounding"])
        self.assertEqual(most["unlimited"]["comparisons"]["plane.radius"], 0)
        plane = figures["sufficient"]["published"]["comparisons"]["plane.radius"]
        self.assertEqual((plane["degree_lhs"], plane["integer_bits"]), (6, {"per_bit": 6, "constant": 16}))
        self.assertIsNone(figures["sufficient"]["ladder-0"]["comparisons"]["plane.radius"]["integer_bits"])
        exact = {k: v["exact"] for k, v in figures["all"]["kernels"].items()}
        self.assertEqual(exact["published"], exact["ladder-0"])
        self.assertEqual(exact["nonstrict"], {"false_separation": 0, "false_contact": 0})
        self.assertEqual(json.loads((self.folder / "precision.json").read_text()), figures)
        self.assertTrue((self.folder / "precision.html").exists())
        again = axiscert(*figures["command"].split()[1:], "--format", "json")
        self.assertEqual(json.loads(again.stdout), figures)

    def test_text(self):
        done = axiscert("precision", "--family", "general", "--trials", 2, "--precision", "binary64", "--bits", 53)
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("exponents of binary64", "reduced-nonstrict", "6 b + 16", "exact"):
            self.assertIn(part, done.stdout)

    def test_bad_input(self):
        for bits in ("1", "300", "-24"):
            self.refused("precision", "--bits", bits, says=[f"--bits {bits}", "2 to 256"])
        self.refused("precision", "--bits", "many", says=["--bits", "many"])
        self.refused("precision", "--kernel", "nosuch", says=["unknown kernel 'nosuch'", "published"])
        self.refused("precision", "--family", "nosuch", says=["unknown family 'nosuch'"])
        self.refused("precision", "--precision", "binary16", says=["binary16", "binary64"])
        self.refused("precision", "--kernel", "published+fma", says=["published+fma", "plain arithmetic"])


class Condition(Case):
    def measure(self, *args):
        done = axiscert("condition", "--format", "json", *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_every_flip_is_accounted_for_and_its_address_shows_it(self):
        found = self.measure("--trials", 500, "--family", "tangent", "--family", "ratio", "--flips", 20)
        self.assertEqual({row["kernel"] for row in found["rows"]}, {"published", "reduced", "ladder-0"})
        for row in found["rows"]:
            for name, counts in row["comparisons"].items():
                self.assertEqual(counts["evaluated"], min(counts["flips"], 20))
                self.assertEqual(counts["evaluated"], sum(counts[k] for k in ("ill_conditioned", "unstable", "undefined",
                                                                              "not_decided")))
                if counts["least_unstable"]:
                    self.assertLess(counts["least_unstable"]["kappa_u"], 1.00001)
                    query = axiscert("query", counts["least_unstable"]["address"]).stdout
                    line = json.loads(axiscert("check", "-", "--format", "jsonl", "--kernel", row["kernel"],
                                               stdin=query).stdout)
                    self.assertIn(name, [flip["name"] for flip in line["flips"]])

    def test_text_and_files(self):
        plan = ["condition", "--trials", 200, "--family", "tangent", "--precision", "binary64"]
        done = axiscert(*plan, "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("ill-conditioned", done.stdout)
        stored = json.loads((self.folder / "out/condition.json").read_text())
        self.assertEqual(stored, self.measure(*plan[1:]))
        self.assertTrue((self.folder / "out/condition.html").exists())

    def test_bad_input(self):
        self.refused("condition", "--kernel", "minkowski", says=["minkowski", "verdict alone"])
        self.refused("condition", "--kernel", "nosuch", says=["nosuch", "published"])
        self.refused("condition", "--family", "nosuch", says=["nosuch", "tangent"])
        self.refused("condition", "--flips", "-1", says=["--flips", "-1"])
        self.refused("condition", "--kernel", "published+in-double", "--precision", "binary64", says=["in-double"])


class CriticalRadius(Case):
    def measure(self, *args):
        done = axiscert("critical-radius", "--format", "json", *args)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_every_triangle_is_accounted_for(self):
        found = self.measure("--trials", 64)
        self.assertEqual(len(found["rows"]), 64)
        for row in found["rows"]:
            self.assertEqual(row["measured"], row["right"] + row["early"] + row["late"] + row["unbounded"])
            self.assertEqual(row["not_monotone"], 0, row["kernel"])

    def test_a_witness_against_monotonicity_replays(self):
        kernel = "ladder-0+prescaled"
        (row,) = self.measure("--trials", 64, "--kernel", kernel, "--family", "scale")["rows"]
        self.assertGreater(row["not_monotone"], 0)
        pair = "".join(json.dumps(line) + "\n" for line in row["not_monotone_witness"])
        done = axiscert("check", "-", "--format", "jsonl", "--kernel", kernel, stdin=pair)
        verdicts = [json.loads(line)["computed"]["verdict"] for line in done.stdout.splitlines()]
        self.assertEqual(verdicts, ["contact", "separated"])

    def test_bad_input(self):
        self.refused("critical-radius", "--kernel", "nosuch", says=["nosuch", "published"])
        self.refused("critical-radius", "--trials", "0", says=["--trials", "0"])
        self.refused("critical-radius", "--precision", "binary16", says=["binary16", "binary64"])


class Kernels(Case):
    """The rungs, the other methods and the arithmetics, by their ids."""

    def listed(self):
        done = axiscert("kernels", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_every_kernel_and_every_arithmetic_is_listed_once(self):
        listed = self.listed()
        ids = [kernel["id"] for kernel in listed] + [c["id"] for kernel in listed for c in kernel["arithmetics"]]
        self.assertEqual(len(ids), len(set(ids)))
        arithmetics = [c["arithmetic"] for c in listed[0]["arithmetics"]]
        self.assertEqual(len(arithmetics), len(set(arithmetics)))
        for kernel in listed:
            self.assertIn([c["arithmetic"] for c in kernel["arithmetics"]], [arithmetics, []], kernel["id"])
        refused = axiscert("check", "-", "--kernel", "nosuch").stderr.strip()
        self.assertEqual(refused.split("; kernels: ")[1].split(", "), [kernel["id"] for kernel in listed])
        refused = axiscert("check", "-", "--kernel", "published+nosuch").stderr.strip()
        self.assertEqual(refused.split("; arithmetics: ")[1].split(", "), arithmetics)
        text = axiscert("kernels").stdout.splitlines()
        for name in [kernel["id"] for kernel in listed] + ["+" + a for a in arithmetics]:
            self.assertEqual(len([line for line in text if line.split()[:1] == [name]]), 1, name)

    def test_what_is_listed_exists_in_the_precisions_it_says(self):
        queries = {p: QUERY.replace("binary32", p) % 1 for p in ("binary32", "binary64")}
        for composed in self.listed()[2]["arithmetics"] + self.listed():
            for precision, query in queries.items():
                done = axiscert("check", "-", "--kernel", composed["id"], stdin=query)
                self.assertEqual(done.returncode, 0 if precision in composed["precisions"] else 2, done.stderr)

    def test_the_documentation_names_what_is_registered(self):
        tables, header = {}, None
        for line in (ROOT / "docs/kernels.md").read_text().splitlines():
            cells = [cell.strip() for cell in line.strip("|").split(" | ")] if line.startswith("|") else None
            if cells is None:
                header = None
            elif header is None:
                header = tuple(cells)
                tables[header] = []
            elif cells[0].startswith("`"):
                tables[header].append([cell.strip("`") for cell in cells])
        named = {header: [row[0] for row in rows] for header, rows in tables.items()}
        listed = self.listed()
        ids, arithmetics = [k["id"] for k in listed], [c["arithmetic"] for c in listed[0]["arithmetics"]]
        self.assertEqual([names for header, names in named.items() if header[0] == "kernel"], [ids, ids])
        self.assertEqual([names for header, names in named.items() if header[0] == "arithmetic"], [arithmetics])
        (shown,) = [rows for header, rows in tables.items() if header[-1] == "exposes"]
        for row, kernel in zip(shown, listed):
            self.assertIn(row[-1], kernel["exposes"], kernel["id"])
            self.assertEqual("sides" in kernel["exposes"], row[-1] == "sides", kernel["id"])

    def test_the_slips_are_specification_faults(self):
        for kernel in ("first-publication", "vertex-typo"):
            record = self.run_ok("--kernel", kernel, "--family", "general", "--trials", 100000 // DIVISOR,
                                 "--precision", "binary32", "--require", "logic", code=1)
            self.assertGreater(family(record, "general", kernel=kernel)["verdict"]["links"]["specification"], 0)

    def test_the_reduced_test_has_no_fault_of_logic(self):
        self.run_ok("--kernel", "reduced-nonstrict", "--family", "all", "--trials", 1000, "--require", "logic")

    def test_every_kernel_is_judged_by_its_own_formulae(self):
        listed = self.listed()
        plan = [f"--kernel={kernel['id']}" for kernel in listed]
        plan += [f"--kernel={c['id']}" for c in listed[0]["arithmetics"] if c["precisions"] == ["binary32", "binary64"]]
        record = self.run_ok(*plan, "--family", "sliver", "--family", "repeated", "--family", "scale", "--trials", 200)
        self.assertEqual(len(record["kernels"]), 2 * len(plan))
        for entry in record["kernels"]:
            for name, found in entry["families"].items():
                # Eigen chooses its own order of operations: there, what differs from the reference is its own.
                if entry["id"] != "eigen":
                    self.assertEqual(found["verdict"]["links"]["implementation"], 0, (entry["id"], name))

    def test_a_precision_that_an_arithmetic_lacks(self):
        self.refused("run", "--kernel", "published+spu", "--precision", "binary64", "--out", self.folder / "out",
                     says=["--precision binary64", "published+spu", "binary32 only"])
        self.refused("check", "-", "--kernel", "published+world-double", stdin=QUERY % 1,
                     says=["query 'q'", "binary32", "published+world-double"])
        for wrong, says in (("published+nope", "unknown arithmetic 'nope'"), ("minkowski+fma", "'minkowski' is no rung"),
                            ("nope+fma", "'nope' is no rung")):
            done = self.refused("run", "--kernel", wrong, says=[wrong, says])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


class Planted(Case):
    """Faults put into the harness itself: it has to catch each and exit 3."""

    def test_a_corrupted_oracle(self):
        done = axiscert("run", "--family", "general", "--out", self.folder / "out", program="axiscert_planted_oracle")
        self.assertEqual(done.returncode, 3, done.stderr)
        self.assertIn("the oracles disagree", done.stderr)
        saved = axiscert("check", self.folder / "out/disagreement.jsonl", "--format", "jsonl")
        self.assertEqual(json.loads(saved.stdout)["exact"]["verdict"], "contact")

    def test_a_contracted_build(self):
        for target in json.loads(axiscert("kernels", "--format", "json").stdout)[0]["targets"]:
            if not target.startswith("AVX"):
                continue  # the others have no fused operation to contract to
            done = axiscert("run", "--family", "general", "--trials", 10, "--target", target, "--out",
                            self.folder / "out", program="axiscert_planted_contraction")
            self.assertEqual(done.returncode, 3, target)
            self.assertIn("self-check", done.stderr)


if __name__ == "__main__":
    unittest.main()
