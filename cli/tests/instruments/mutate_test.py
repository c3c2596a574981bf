#!/usr/bin/env python3
"""`axiscert mutate`: a mutant that it catches is also caught by `run --require logic`, and at the query that it names."""
import json
import unittest

import jsonschema

from command import DIVISOR, Case, axiscert, schema_of


class MutateCase(Case):
    def mutate(self, *args):
        done = axiscert("mutate", *args, "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)


class MutateByVerdict(MutateCase):
    PLAN = ("--verdict-only", "--trials", 8192, "--precision", "binary32", "--family", "lattice", "--family", "tangent")

    def test_what_survives_has_its_reason_on_any_number_of_threads(self):
        out = self.folder / "out"
        faults = ("drop", "fma", "clamp", "plus-relative", "early-contact")
        chosen = [word for fault in faults for word in ("--mutant", fault)]
        found = self.mutate(*self.PLAN, *chosen, "--magnitude", 0.1, "--magnitude", "1e-20", "--out", out)
        schema = schema_of("mutation-by-verdict")
        jsonschema.validators.validator_for(schema)(schema).validate(found)
        self.assertEqual(json.loads((out / "mutation-by-verdict.json").read_text()), found)
        again = axiscert(*found["command"].split()[1:], "--format", "json", "--threads", 1)
        self.assertEqual(json.loads(again.stdout), found)
        by_id = {m["id"]: m for m in found["mutants"]}
        self.assertEqual({m["fault"] for m in found["mutants"]}, set(faults))
        self.assertEqual({m["magnitude"] for m in found["mutants"]}, {None, 0.1, 1e-20})
        for mutant in found["mutants"]:
            self.assertNotEqual(mutant["refused"] is None, mutant["reason"] is None, mutant)
            if mutant["fault"] == "drop":
                self.assertIsNotNone(mutant["refused"], mutant)
            if mutant["fault"] == "fma":  # another order of roundings is no fault of logic
                self.assertIn(mutant["reason"], ("no-other-verdict", "never-wrong", "not-in-exact-arithmetic"))
        self.assertEqual(by_id["nonstrict~plus-relative:r:1e-20"]["reason"], "equivalent")
        self.assertEqual(by_id["nonstrict~clamp:r:1e-20"]["reason"], "no-other-verdict")
        self.assertIsNotNone(by_id["nonstrict~early-contact:verdict:0.1"])
        self.assertEqual({c["refused"] for c in found["controls"]}, {None})
        counts = found["score"]["binary32"]
        self.assertEqual(counts["mutants"], counts["equivalent"] + counts["refused"] + counts["survived"])
        self.assertIn("no verdict differs", (out / "mutation-by-verdict.md").read_text())

    def test_a_run_takes_the_names_that_it_gives(self):
        self.assertIn("nonstrict~clamp:r:0.01  the radius, E = 0.01; E for an x below E",
                      axiscert("mutate", "--verdict-only", "--list").stdout.splitlines())
        run = axiscert("run", "--kernel", "nonstrict~clamp:r:2", "--family", "lattice", "--trials", 2000, "--require",
                       "logic", "--out", self.folder / "run")
        self.assertEqual(run.returncode, 1, run.stderr)
        self.refused("run", "--kernel", "nonstrict~clamp:nosuch:0.1", says=["nonstrict~clamp:nosuch:0.1", "clamp-relative"])
        self.refused("mutate", "--magnitude", "0.1", says=["--verdict-only"])
        self.refused("mutate", "--verdict-only", "--magnitude", "-1", says=["--magnitude", "'-1' is not a number > 0"])


class MutateMotions(MutateCase):
    TWENTY = "moving-sphere/twenty-nonstrict"

    def test_faults_of_the_twenty_axes_are_caught_by_families_of_motions(self):
        found = self.mutate("--predicate", "moving-sphere", "--mutant", "drop", "--mutant", "index-left:37", "--trials", 500,
                            "--precision", "binary32", "--no-controls")
        self.assertEqual(found["kernel"], self.TWENTY)
        self.assertEqual({name.split("/")[0] for name in found["families"]}, {"moving-sphere"})
        self.assertEqual(found["score"]["binary32"]["mutants"], 20 + 1)
        self.assertEqual([m["id"] for m in found["mutants"] if m["caught"] is None], [])
        schema = schema_of("mutation")
        jsonschema.validators.validator_for(schema)(schema).validate(found)
        again = axiscert(*found["command"].split()[1:], "--format", "json", "--threads", 1)
        self.assertEqual(json.loads(again.stdout), found)
        caught = next(m for m in found["mutants"] if m["fault"] == "drop")
        query = axiscert("query", caught["caught"]["address"]).stdout
        checked = json.loads(axiscert("check", "-", "--format", "jsonl", "--kernel", caught["id"], stdin=query).stdout)
        self.assertIn("implementation", checked["flips"][0]["links"])

    def test_by_its_verdict_alone_a_fault_of_logic_is_refused_and_the_kernel_itself_is_not(self):
        found = self.mutate("--predicate", "moving-sphere", "--verdict-only", "--mutant", "drop:start.edge_ab", "--mutant",
                            "clamp:r:0.5", "--mutant", "plus-relative:r:1e-20", "--family", "moving-sphere/lattice",
                            "--trials", 2000, "--precision", "binary32")
        refused = {m["id"].split("~")[1]: m["refused"] is not None for m in found["mutants"]}
        self.assertEqual(refused, {"drop:start.edge_ab": True, "clamp:r:0.5": True, "plus-relative:r:1e-20": False})
        self.assertEqual([(c["kernel"], c["refused"]) for c in found["controls"]], [(self.TWENTY, None)])

    def test_bad_input(self):
        self.refused("mutate", "--kernel", "moving-sphere/twenty", says=["moving-sphere/twenty", self.TWENTY])
        self.refused("mutate", "--kernel", "nonstrict", "--predicate", "moving-sphere", says=["nonstrict", "--predicate is moving-sphere"])
        self.refused("mutate", "--family", "moving-sphere/lattice", says=["nonstrict", "moving-sphere/lattice"])
        self.refused("mutate", "--predicate", "nosuch", says=["nosuch", "moving-sphere"])


class Mutate(MutateCase):
    def test_a_fault_of_each_kind_is_caught_and_the_files_are_written(self):
        out = self.folder / "out"
        kinds = ("drop", "reverse", "lane", "tail", "always", "strictness")
        found = self.mutate(*(word for kind in kinds for word in ("--mutant", kind)), "--trials", 40000 // DIVISOR,
                            "--no-controls", "--out", out)
        self.assertEqual({m["fault"] for m in found["mutants"]}, set(kinds))
        for score in found["score"].values():
            self.assertEqual(score["mutants"], 7 + 16 + 8 + 4 + 16 + 16)
            if DIVISOR == 1:
                self.assertEqual(score["survived"], 0)
            self.assertGreater(score["caught_within_10000"], score["mutants"] / 2)
        schema = schema_of("mutation")
        jsonschema.validators.validator_for(schema)(schema).validate(found)
        self.assertEqual(json.loads((out / "mutation.json").read_text()), found)
        self.assertIn("nonstrict\\~drop:edge_ab", (out / "mutation.md").read_text())
        self.assertTrue((out / "mutation.html").exists())
        again = axiscert(*found["command"].split()[1:], "--format", "json", "--threads", 1)
        self.assertEqual(json.loads(again.stdout), found)

    def test_run_catches_what_mutate_says_at_the_query_that_it_names(self):
        for mutant in ("nonstrict~index-left:20", "nonstrict~fma:41", "nonstrict~tail:8"):
            found = self.mutate("--mutant", mutant, "--precision", "binary32", "--trials", 2000, "--no-controls")
            caught = found["mutants"][0]["caught"]
            run = axiscert("run", "--kernel", mutant, "--family", caught["family"], "--trials", 2000, "--precision",
                           "binary32", "--require", "logic", "--out", self.folder / "run")
            self.assertEqual(run.returncode, 1, run.stderr)
            if "tail" in mutant:
                continue  # one query has no tail to show
            query = axiscert("query", caught["address"]).stdout
            line = json.loads(axiscert("check", "-", "--format", "jsonl", "--kernel", mutant, stdin=query).stdout)
            self.assertIn("implementation", line["flips"][0]["links"])
            self.assertEqual(line["flips"][0]["kind"], caught["kind"])
        base = axiscert("run", "--kernel", "nonstrict", "--trials", 500, "--require", "logic", "--out", self.folder / "run")
        self.assertEqual(base.returncode, 0, base.stderr)

    def test_on_queries_that_are_not_valid_nothing_survives(self):
        for words, said in (((), "mutation"), (("--verdict-only",), "mutation-by-verdict")):
            plan = ("mutate", *words, "--family", "nonfinite", "--trials", 1, "--mutant", "operator", "--precision", "binary32")
            done = axiscert(*plan, "--format", "json")
            self.assertEqual(done.returncode, 1, done.stderr)
            found = json.loads(done.stdout)
            schema = schema_of(said)
            jsonschema.validators.validator_for(schema)(schema).validate(found)
            score = found["score"]["binary32"]
            self.assertEqual((score["judged"], score["not_judged"]), (0, score["mutants"] - score["equivalent"]))
            for figure in ("survived",) + (("refused",) if words else ("caught", "caught_within_10000", "caught_by_formulae_alone")):
                self.assertIsNone(score[figure], figure)
            self.assertGreater(score["not_judged"], 0)
            if not words:
                self.assertEqual({(c["queries"], c["flagged"]) for c in found["controls"]}, {(0, None)})
            shown = axiscert(*plan).stdout
            self.assertTrue(shown.startswith("Nothing was judged"), shown[:100])
            self.assertIn("not judged", shown)

    def test_controls_are_not_flagged(self):
        found = self.mutate("--mutant", "drop:plane", "--trials", 64 * 20, "--kernel", "reduced-nonstrict")
        claims = {(c["kernel"], c["claims"]) for c in found["controls"]}
        self.assertIn(("reduced-nonstrict+dot-yz-x", "formulae"), claims)
        self.assertIn(("minkowski", "bits"), claims)
        self.assertEqual({c["flagged"] for c in found["controls"]}, {0})

    def test_list_and_text(self):
        listed = axiscert("mutate", "--list").stdout.splitlines()
        self.assertGreaterEqual(len(listed), 100)
        self.assertIn("nonstrict~sign:28  28: #23 + #27; the result negated", listed)
        text = axiscert("mutate", "--mutant", "sign:28", "--trials", 500, "--no-controls").stdout
        for part in ("Score", "By fault", "Not caught", "used as d d alone"):
            self.assertIn(part, text)

    def test_bad_input(self):
        self.refused("mutate", "--kernel", "published", says=["published", "nonstrict, reduced-nonstrict"])
        self.refused("mutate", "--mutant", "nosuch", says=["nonstrict~nosuch", "swap", "--list"])
        self.refused("mutate", "--mutant", "reduced-nonstrict~sign:28", says=["not a mutant of nonstrict"])
        self.refused("mutate", "--family", "nosuch", says=["nosuch", "the nearest of "])
        self.refused("mutate", "--precision", "binary16", says=["binary16"])
        self.refused("mutate", "--trials", "0", says=["--trials"])
        self.refused("run", "--kernel", "nonstrict~swap:9999", says=["nonstrict~swap:9999", "--list"])


if __name__ == "__main__":
    unittest.main()
