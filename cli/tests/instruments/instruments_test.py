#!/usr/bin/env python3
"""Tests of the measuring subcommands: figures for programs, text, pages, one clear line for every bad input."""
import collections
import json
import math
import unittest
from fractions import Fraction

import jsonschema

from command import Case, axiscert, schema_of


class Instruments(Case):
    # Each with few queries; what is written without a look at the clock.
    COMMANDS = (("ladder", "--trials", 60, "--kernel", "published", "--no-speed"),
                ("precision", "--trials", 500, "--kernel", "reduced", "--bits", 24, "--family", "tangent"),
                ("condition", "--trials", 600, "--kernel", "published", "--family", "tangent"),
                ("critical-radius", "--trials", 300, "--kernel", "published", "--family", "far"))

    def test_threads_and_progress_change_no_byte(self):
        for command in self.COMMANDS:
            one, two = (axiscert(*command, "--format", "json", "--threads", threads, "--progress", progress)
                        for threads, progress in ((1, 0), (2, 0.001)))
            self.assertEqual(one.returncode, 0, one.stderr)
            self.assertEqual(one.stdout, two.stdout, command)
            self.assertEqual(one.stderr, "", command)
            self.assertIn(f"axiscert: {command[0]}", two.stderr)

    def test_what_is_done_within_a_minute_says_nothing(self):
        done = axiscert(*self.COMMANDS[3])
        self.assertEqual(done.stderr, "")
        self.refused("ladder", "--threads", 0, says=["--threads"])
        self.refused("ladder", "--progress", -1, says=["--progress"])


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
            self.assertEqual(tuple(kernel["windows"]["axes"]), self.AXES)
            for result in kernel["families"].values():
                self.assertEqual(tuple(result["axes"]), self.AXES)
                for axis in result["axes"].values():
                    self.assertEqual("worst_u" in axis, kernel["shows_sides"])
                self.assertEqual(result["rates"]["missed"]["failures"], result["verdict"]["false_separation"])
                self.assertEqual(result["rates"]["edge_signs"]["trials"], 6 * result["queries"])
                for rate in result["rates"].values():
                    self.assertLessEqual(rate["low"], rate["rate"])
                    self.assertLessEqual(rate["rate"], rate["high"])
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

    def test_without_kernels_it_measures_every_rung(self):
        listed = json.loads(axiscert("kernels", "--format", "json").stdout)["kernels"]
        rungs = {kernel["formulae"] for kernel in listed if kernel["arithmetics"]} - {"published"}
        data = json.loads(axiscert("ladder", "--trials", 8, "--family", "general", "--no-speed", "--format", "json").stdout)
        measured = [kernel["id"] for kernel in data["kernels"]]
        self.assertEqual(set(measured), rungs)
        self.assertEqual(measured[:11], [f"ladder-{step}" for step in range(10)] + ["reduced"])
        # Each but the first has a rung that it was made from.
        self.assertEqual([step["to"] for step in data["steps"]], measured[1:])

    def test_the_factorial_has_pairs_and_effects_by_family(self):
        done = axiscert("ladder", "--factorial", "--trials", 600, "--family", "tangent", "--family", "orders", "--no-speed",
                        "--format", "json", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        data = json.loads(done.stdout)
        self.assertEqual(len(data["kernels"]), 20)
        kinds = collections.Counter((row["kind"], row["factor"]) for row in data["differences"])
        # Two families; missed, phantom and the signs of the axes that a factor changes.
        for factor in ("frame", "division", "root", "degree"):
            self.assertEqual((kinds["pair", factor], kinds["effect", factor]), (2 * 3 * 8, 2 * 3))
        for factor in ("plane division", "plane root"):
            self.assertEqual((kinds["pair", factor], kinds["effect", factor]), (2 * 3 * 2, 2 * 3))
        rows = [row for row in data["differences"] if row["kind"] == "pair"]
        for row in data["differences"]:
            self.assertEqual(row["only_to"] - row["only_from"], row["failures_to"] - row["failures_from"])
            self.assertAlmostEqual(row["difference"], (row["failures_to"] - row["failures_from"]) / row["trials"])
            self.assertTrue(row["low"] <= row["difference"] <= row["high"], row)
            self.assertTrue(0 < row["p"] <= row["holm_p"] <= 1, row)
            self.assertEqual(row["clusters"], 600 if row["family"] == "tangent" else 100)
        # McNemar's test in rational arithmetic, where each query is by itself; Holm's correction of all pairs.
        for row in rows:
            low, all_ = min(row["only_from"], row["only_to"]), row["only_from"] + row["only_to"]
            exact = min(Fraction(1), Fraction(2 * sum(math.comb(all_, k) for k in range(low + 1)), 2 ** all_))
            self.assertAlmostEqual(row["mcnemar_p"], float(exact), delta=2e-7 * float(exact) + 1e-300)
            if row["family"] == "tangent" and row["figure"] in ("missed", "phantom"):
                self.assertEqual(row["p"], row["mcnemar_p"])
        least = 0
        for i, row in enumerate(sorted(rows, key=lambda row: row["p"])):
            least = max(least, min(1, row["p"] * (len(rows) - i)))
            self.assertAlmostEqual(row["holm_p"], least)
        effect, = (row for row in data["differences"] if (row["kind"], row["factor"], row["family"], row["figure"])
                   == ("effect", "frame", "tangent", "edge_signs"))
        parts = [row for row in rows if (row["factor"], row["family"], row["figure"]) == ("frame", "tangent", "edge_signs")]
        self.assertEqual(effect["only_to"], sum(row["only_to"] for row in parts))
        self.assertLess(effect["high"], 0, "centring has fewer sign errors")
        page = (self.folder / "out/ladder.html").read_text()
        self.assertIn('"intervals":[[', page)

    def test_bad_input(self):
        self.refused("ladder", "--kernel", "nosuch", says=["unknown kernel 'nosuch'", "the nearest of "])
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
        self.assertEqual([number["bits"] for number in figures["numbers"]], [12, 24, 256])
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
        for bits in ("1", "5000", "-24"):
            self.refused("precision", "--bits", bits, says=[f"--bits {bits}", "2 to 4096"])
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
        self.refused("condition", "--family", "nosuch", says=["nosuch", "the nearest of "])
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


class Search(Case):
    PLAN = ("search", "--kernel", "published", "--comparison", "edge_ab.radius", "--comparison", "vertex_b.side_c")

    def search(self, *args, out="out"):
        done = axiscert(*args, "--format", "json", "--out", self.folder / out)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout), json.loads((self.folder / out / "search.json").read_text()))
        return json.loads(done.stdout)

    def test_check_confirms_the_witnesses(self):
        found = self.search(*self.PLAN, "--evaluations", 1000000)
        self.assertEqual([c["name"] for c in found["comparisons"]], ["vertex_b.side_c", "edge_ab.radius"])
        done = axiscert("check", self.folder / "out/witnesses.jsonl", "--format", "jsonl", "--errors")
        errors = {line["id"]: line["errors"] for line in map(json.loads, done.stdout.splitlines())}
        for comparison in found["comparisons"]:
            name = comparison["name"]
            self.assertGreaterEqual(comparison["proved_u"], comparison["attained_u"])
            self.assertEqual(errors["error " + name][name]["absolute_u"], comparison["attained_u"])
            self.assertEqual(errors["relative_error " + name][name]["relative_u"], comparison["relative_u"])
        self.assertGreater(found["comparisons"][1]["attained_u"], 500)

    def test_wrong_verdicts_are_confirmed_by_check_and_the_file_by_its_schema(self):
        found = self.search("search", "--evaluations", 3000000, "--threads", 1)
        self.assertEqual(len(found["comparisons"]), 16)
        missed = found["verdict"]["missed_contact"]
        done = axiscert("check", "-", "--format", "jsonl", stdin=json.dumps(missed["witness"]))
        checked = json.loads(done.stdout)
        self.assertEqual((checked["exact"]["verdict"], checked["computed"]["verdict"]), ("contact", "separated"))
        self.assertEqual(checked["flips"][0]["links"], missed["links"])
        schema = schema_of("search")
        jsonschema.validators.validator_for(schema)(schema).validate(found)

    def test_resuming_is_the_same_as_not_stopping(self):
        whole = self.search(*self.PLAN, "--evaluations", 900000, out="whole")
        self.search(*self.PLAN, "--evaluations", 200000, "--threads", 1, out="parts")
        parts = self.search(*self.PLAN, "--evaluations", 900000, "--resume", out="parts")
        self.assertEqual(whole, parts)
        timed = self.search(*self.PLAN, "--time", 0.1, "--resume", out="parts")
        self.assertGreater(timed["evaluations"], parts["evaluations"], "one island is done in any time")

    def test_bad_input(self):
        self.refused("search", "--kernel", "nosuch", says=["nosuch", "published"])
        self.refused("search", "--comparison", "plane", says=["plane", "plane.radius"])
        self.refused("search", "--kernel", "minkowski", "--comparison", "plane.radius", says=["minkowski"])
        self.refused("search", "--kernel", "published+in-double", "--precision", "binary64", says=["in-double"])
        self.refused("search", "--family", "nosuch", says=["nosuch", "the nearest of "])
        self.refused("search", "--evaluations", "0", says=["--evaluations"])
        self.refused("search", "--time", "0", says=["--time"])
        self.refused("search", "--time", "1", "--evaluations", "1", says=["--time", "excludes"])
        self.refused("search", "--resume", says=["--out"])
        self.refused("search", "--resume", "--out", self.folder / "none", says=["search.state"])
        self.search(*self.PLAN, "--evaluations", 1)
        self.refused("search", "--resume", "--out", self.folder / "out", says=["comparisons"])
        state = self.folder / "out/search.state"
        state.write_text(state.read_text().replace("axiscert-search-state/5", "axiscert-search-state/4"))
        self.refused(*self.PLAN, "--resume", "--out", self.folder / "out",
                     says=["out/search.state: its schema is", "axiscert-search-state/4", "axiscert-search-state/5", "without --resume"])
        state.write_text("no state")
        self.refused(*self.PLAN, "--resume", "--out", self.folder / "out", says=["not the state of a search"])


if __name__ == "__main__":
    unittest.main()
