#!/usr/bin/env python3
"""`axiscert mutate`: a mutant that it catches is also caught by `run --require logic`, and at the query that it names."""
import json
import unittest

import jsonschema

from command import DIVISOR, SCHEMAS, Case, axiscert


class Mutate(Case):
    def mutate(self, *args):
        done = axiscert("mutate", *args, "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

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
        schema = json.loads((SCHEMAS / "mutation.schema.json").read_text())
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
        self.refused("mutate", "--family", "nosuch", says=["nosuch", "tangent"])
        self.refused("mutate", "--precision", "binary16", says=["binary16"])
        self.refused("mutate", "--trials", "0", says=["--trials"])
        self.refused("run", "--kernel", "nonstrict~swap:9999", says=["nonstrict~swap:9999", "--list"])


if __name__ == "__main__":
    unittest.main()
