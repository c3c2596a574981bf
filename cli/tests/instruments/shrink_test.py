#!/usr/bin/env python3
"""Shrinking and the corpus: every query that is printed replays in `check`; one clear line for every bad input."""
import json
import re
import unittest

from command import ROOT, Case, axiscert, family

CORPUS = ROOT / "fuzz" / "corpus"
PHANTOM = {"id": "phantom", "precision": "binary32", "a": [-5, 7, 0], "b": [5, 7, 0], "c": [15, 7, 0], "p": [0, 0, 0],
           "r": "3.3"}
RIGHT = {"id": "right", "precision": "binary32", "a": [1, 0, 0], "b": [0, 1, 0], "c": [0, 0, 1], "p": [0, 0, 0], "r": 2}


def check(query, kernel="published"):
    done = axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=json.dumps(query))
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class Shrink(Case):
    def shrunk(self, query, *args):
        done = axiscert("shrink", "-", *args, "--format", "jsonl", stdin=json.dumps(query))
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_a_wrong_verdict_is_kept_and_check_confirms_it(self):
        found = self.shrunk(PHANTOM)
        self.assertEqual(found["kept"], {"level": "verdict", "name": "verdict", "kind": "false_contact",
                                         "links": ["specification"], "class": "collinear",
                                         "classes": ["collinear"]})
        self.assertLess(found["bits"]["after"], found["bits"]["before"])
        self.assertTrue(found["complete"])
        flip = check(found)["flips"][0]
        self.assertEqual((flip["kind"], flip["links"]), ("false_contact", ["specification"]))
        self.assertEqual(found, self.shrunk(PHANTOM), "the same bytes each time")

    def test_an_address_an_axis_and_an_error(self):
        record = self.run_ok("--family", "tangent", "--trials", 20000, "--precision", "binary32")
        # A family keeps its three deepest.
        witness = max((w for w in record["witnesses"] if "deepest false_separation" in w["shows"]),
                      key=lambda w: w["depth"])
        done = axiscert("shrink", witness["address"], "--format", "jsonl")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual(found["kept"]["kind"], "false_separation")
        (axis,) = [f for f in witness["flips"] if f["level"] == "axis"][:1]
        done = axiscert("shrink", witness["address"], "--what", axis["name"], "--format", "jsonl")
        found = json.loads(done.stdout)
        self.assertEqual((found["kept"]["name"], found["kept"]["links"]), (axis["name"], axis["links"]))
        self.assertIn(axis["name"], [f["name"] for f in check(found)["flips"]])
        found = self.shrunk(witness, "--what", "plane.radius:error")
        self.assertEqual(found["kept"]["kind"], "error")

    def test_text_has_both_and_a_command_that_replays(self):
        done = axiscert("shrink", "-", stdin=json.dumps(PHANTOM))
        self.assertEqual(done.returncode, 0, done.stderr)
        for part in ("phantom: published keeps verdict false_contact [specification]", "before ", "after ", "bits in",
                     "axiscert check - --kernel published"):
            self.assertIn(part, done.stdout)
        limited = axiscert("shrink", "-", "--evaluations", 2, stdin=json.dumps(PHANTOM))
        self.assertIn("--evaluations", limited.stdout)

    def test_the_page_says_what_it_prints(self):
        address, before, after = re.search(
            r"`axiscert shrink (\S+)` makes a missed contact with (\d+) significant bits one with (\d+)\.",
            (ROOT / "docs/queries.md").read_text()).groups()
        shown = axiscert("shrink", address).stdout
        self.assertIn("false_separation", shown.splitlines()[0])
        self.assertRegex(shown, rf"\n  before +{before} bits in")
        self.assertRegex(shown, rf"\n  after +{after} bits in")

    def test_the_class_of_the_input_is_kept_unless_it_is_let_go(self):
        record = self.run_ok("--family", "tangent", "--trials", 20000, "--precision", "binary32")
        witness = min((w for w in record["witnesses"] if w["flips"] and w["flips"][0]["level"] == "verdict" and w["depth"]),
                      key=lambda w: w["depth"])
        kept = self.shrunk(witness, "--evaluations", 3000)
        self.assertEqual(kept["kept"]["class"], "near_tie")
        self.assertLessEqual(float(kept["severity"]["after"].split()[0]), 4.01 * witness["depth"])
        free = self.shrunk(witness, "--evaluations", 3000, "--any-class")
        self.assertIsNone(free["kept"]["class"])
        self.assertGreater(float(free["severity"]["after"].split()[0]), 4.01 * witness["depth"])
        least = self.shrunk(PHANTOM)
        text = axiscert("shrink", "-", stdin=json.dumps(least)).stdout
        self.assertIn("0 steps", text)
        self.assertIn("cannot be made smaller with its class", text)

    def test_witnesses_of_an_asymmetry_are_made_smaller_as_pairs(self):
        record = self.run_ok("--family", "axes", "--family", "scaled", "--trials", 20000, "--precision", "binary32")
        halves = [w for w in record["witnesses"] if not w["flips"] and any("asymmetry" in s for s in w["shows"])]
        self.assertTrue(halves)
        for witness in halves[:2]:
            found = self.shrunk(witness, "--evaluations", 2000)
            self.assertEqual(found["kept"]["kind"], "asymmetry")
            self.assertLessEqual(found["bits"]["after"], found["bits"]["before"])
            if found["kept"]["level"] == "verdict":
                said = [json.loads(axiscert("check", "-", "--format", "jsonl", stdin=json.dumps(q)).stdout)["computed"]["verdict"]
                        for q in (found, found["image"])]
                self.assertEqual(said, found["answers"])
        alone = axiscert("shrink", halves[0]["address"], "--evaluations", 500)
        self.assertEqual(alone.returncode, 0, alone.stderr)
        self.assertIn("keeps asymmetry", alone.stdout)
        self.refused("shrink", "-", "--what", "asymmetry", stdin=json.dumps(PHANTOM), says=["asymmetry", "address"])

    def test_one_that_shows_nothing_does_not_stop_the_others(self):
        both = json.dumps(RIGHT) + "\n" + json.dumps(PHANTOM)
        done = axiscert("shrink", "-", "--format", "jsonl", stdin=both)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(json.loads(done.stdout)["id"], "shrunk-phantom")
        self.assertIn("'right'", done.stderr)
        self.refused("shrink", "-", "--what", "plane", stdin=both, says=["'right'", "'phantom'", "none of the 2"])

    def test_bad_input(self):
        self.refused("shrink", "-", stdin=json.dumps(RIGHT), says=["'right'", "published is not wrong", ":error"])
        self.refused("shrink", "-", "--what", "plane", stdin=json.dumps(PHANTOM),
                     says=["plane", "has it right", "false_contact"])
        self.refused("shrink", "-", "--what", "plain", stdin=json.dumps(PHANTOM),
                     says=["plain", "plane.radius", "verdict"])
        self.refused("shrink", "-", "--what", "plane.radius:error", "--kernel", "minkowski", stdin=json.dumps(PHANTOM),
                     says=["minkowski", "no sides"])
        self.refused("shrink", "-", stdin=json.dumps({**RIGHT, "r": -1}), says=["'right'", "not a valid query"])
        self.refused("shrink", "-", "--kernel", "nosuch", stdin=json.dumps(RIGHT), says=["nosuch", "published"])
        self.refused("shrink", "1:nosuch:1:binary32:0:1", says=["nosuch", "the nearest of "])
        self.refused("shrink", "nosuch.jsonl", says=["nosuch.jsonl"])
        self.refused("shrink", says=["QUERY"])


    def test_run_makes_its_witnesses_smaller(self):
        record = self.run_ok("--family", "repeated", "--trials", 200, "--precision", "binary32", "--shrink", 300)
        wrong = {w["id"]: w for w in record["witnesses"] if w["flips"]}  # `repeated` makes no images
        lines = (self.folder / "out/witnesses-shrunk.jsonl").read_text().splitlines()
        self.assertEqual([json.loads(line)["id"] for line in lines], [f"shrunk-{name}" for name in wrong])
        for found in map(json.loads, lines):
            witness = wrong[found["before"]["id"]]
            self.assertEqual({k: found["before"][k] for k in "abcpr"}, {k: witness[k] for k in "abcpr"})
            self.assertLessEqual(found["bits"]["after"], found["bits"]["before"])
            self.assertEqual(found["kept"]["name"], witness["flips"][0]["name"])
        self.assertIn(found["kept"]["kind"], [f["kind"] for f in check(found)["flips"]])
        self.run_ok("--family", "general", "--trials", 10, out="plain")
        self.assertFalse((self.folder / "plain/witnesses-shrunk.jsonl").exists())


class Corpus(Case):
    def test_run_replays_it_beside_families(self):
        record = self.run_ok("--corpus", CORPUS, "--kernel", "nonstrict", "--kernel", "published")
        entries = [json.loads(line) for f in sorted(CORPUS.glob("*.jsonl")) for line in f.read_text().splitlines()]
        entries = [entry for entry in entries if "predicate" not in entry]  # a run is of one predicate
        for precision in ("binary32", "binary64"):
            expected = [e["expected"] for e in entries if e["precision"] == precision]
            truth = family(record, "corpus", precision)["truth"]
            self.assertEqual(truth["touching"], sum(e["touching"] for e in expected))
            self.assertEqual(truth["separated"], sum(e["verdict"] == "separated" for e in expected))
            self.assertEqual(truth["invalid"], sum(e["verdict"] == "invalid" for e in expected))
        self.assertEqual(record["plan"]["families"], ["corpus"])
        both = self.run_ok("--corpus", "--family", "general", "--trials", 100, out="both")
        self.assertEqual(both["plan"]["families"], ["general", "corpus"])
        self.assertEqual(family(both, "corpus")["truth"], family(record, "corpus")["truth"])
        self.assertIn("--corpus", (self.folder / "both/report.md").read_text())
        made_again = axiscert("query", record["witnesses"][0]["address"])
        self.assertEqual(made_again.returncode, 0, made_again.stderr)
        self.assertEqual(json.loads(made_again.stdout)["a"], record["witnesses"][0]["a"])

    def test_the_corpus_is_a_query_file_too(self):
        listed = axiscert("corpus", "list", "--format", "jsonl").stdout.splitlines()
        by_entry = {}  # a check is of one entry of a predicate
        for line in listed:
            entry = json.loads(line)
            by_entry.setdefault((entry.get("predicate"), entry.get("entry")), []).append(line)
        self.assertEqual({predicate for predicate, _ in by_entry}, {None, "moving-sphere", "box-box", "box-triangle"})
        for (predicate, _), lines in by_entry.items():
            done = axiscert("check", "-", "--format", "jsonl", stdin="\n".join(lines))
            self.assertEqual(done.returncode, 0, done.stderr)
            for entry, checked in zip(map(json.loads, lines), map(json.loads, done.stdout.splitlines())):
                # null: what the corpus does not state of a query of another predicate
                stated = {k: v for k, v in entry["expected"].items() if v is not None or predicate is None}
                self.assertEqual({k: checked["exact"][k] for k in stated}, stated, entry["id"])

    def test_add_admits_once_up_to_symmetry(self):
        add = ("corpus", "add", "-", "--folder", self.folder)
        made = ("--provenance", "made:by hand")
        first = axiscert(*add, "--name", "phantom", *made, "--note", "why", stdin=json.dumps(PHANTOM))
        self.assertEqual(first.returncode, 0, first.stderr)
        entry = json.loads((self.folder / "made.jsonl").read_text())
        self.assertEqual(entry["provenance"], {"kind": "made", "where": "by hand"})
        self.assertEqual(entry["expected"]["verdict"], "separated")
        turned = {**PHANTOM, "a": [32, 4, 14], "b": [32, 4, -6], "c": [32, 4, 34], "p": [18, 4, 4],
                  "r": float.hex(float.fromhex("0x1.a66666p+1") * 2)}
        self.refused(*add, "--name", "other", *made, stdin=json.dumps(turned), says=["phantom", "made.jsonl:1"])
        self.refused(*add, "--name", "phantom", *made, stdin=json.dumps(RIGHT), says=["phantom", "made.jsonl:1"])
        second = axiscert(*add, "--name", "x", "--provenance", "report:https://example.org/1", "--about", "static",
                          stdin=json.dumps(RIGHT))
        self.assertEqual(second.returncode, 0, second.stderr)
        listed = axiscert("corpus", "list", "--folder", self.folder)
        self.assertEqual([line.split()[0] for line in listed.stdout.splitlines()], ["phantom", "x"])

    def test_bad_input(self):
        add = ("corpus", "add", "-", "--folder", self.folder, "--name", "n")
        query = json.dumps(RIGHT)
        self.refused(*add, stdin=query, says=["--provenance"])
        self.refused(*add, "--provenance", "dream:x", stdin=query, says=["dream", "report"])
        self.refused(*add, "--provenance", "report:x", stdin=query, says=["about", "static"])
        self.refused(*add, "--provenance", "made:x", "--about", "static", stdin=query, says=["about"])
        self.refused(*add, "--provenance", "made:x", stdin=query + "\n" + query, says=["2 queries"])
        self.refused(*add, "--provenance", "made:x", stdin="nothing", says=["stdin:1"])
        self.refused("corpus", "list", "--folder", self.folder, says=[str(self.folder), "empty"])
        self.refused("corpus", "list", "--folder", "nosuch", says=["nosuch", "cannot be read"])
        self.refused("run", "--corpus", self.folder, says=[str(self.folder), "empty"])
        (self.folder / "x.jsonl").write_text(query)
        self.refused("run", "--corpus", self.folder, says=["x.jsonl:1", "provenance"])
        self.refused("corpus", says=["subcommand"])


if __name__ == "__main__":
    unittest.main()
