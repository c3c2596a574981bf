#!/usr/bin/env python3
"""Uses of a fault that a run found, for the moving sphere: it is made smaller, and looked for deeper."""
import json
import unittest

import jsonschema

from command import Case, axiscert, schema_of

ROUNDED = ("--kernel", "moving-sphere/rounded")
# A sphere that falls on the face from height 3.
FALLS = ('{"id":"falls","predicate":"moving-sphere","precision":"binary32","a":[0,0,0],"b":[4,0,0],"c":[0,4,0],'
         '"p":[1,1,3],"d":[0,0,-4],"r":1}\n')
# Along a triangle that is a segment, at height 2.25 with radius 1: strict sides invent a contact.
PHANTOM = ('{"id":"line","predicate":"moving-sphere","precision":"binary32","a":[-5,7,0],"b":[5,7,0],"c":[15,7,0],'
           '"p":[1,3,0],"d":[1.5,0,0],"r":"3.3"}\n')


def checked(query, *kernel):
    done = axiscert("check", "-", *kernel, "--format", "jsonl", stdin=json.dumps(query))
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


class ShrinkMotion(Case):
    def test_a_wrong_verdict_is_kept_and_check_confirms_it(self):
        first = axiscert("shrink", "-", "--evaluations", 400, "--format", "jsonl", stdin=PHANTOM)
        self.assertEqual(first.returncode, 0, first.stderr)
        found = json.loads(first.stdout)
        self.assertEqual((found["predicate"], found["kernel"]), ("moving-sphere", "moving-sphere/twenty"))
        self.assertEqual(found["kept"], {"level": "verdict", "name": "verdict", "kind": "false_contact",
                                         "links": ["specification"], "class": "collinear",
                                         "classes": ["collinear", "parallel"]})
        self.assertLess(found["bits"]["after"], found["bits"]["before"])
        flip = checked(found)["flips"][0]
        self.assertEqual((flip["kind"], flip["links"]), ("false_contact", ["specification"]))
        again = axiscert("shrink", "-", "--evaluations", 400, "--format", "jsonl", stdin=PHANTOM)
        self.assertEqual(again.stdout, first.stdout, "the same bytes each time")
        text = axiscert("shrink", "-", "--evaluations", 400, stdin=PHANTOM).stdout
        self.assertIn("line: moving-sphere/twenty keeps verdict false_contact [specification]", text)
        self.assertIn("input of class collinear", text)

    def test_a_run_makes_its_witnesses_smaller(self):
        record = self.run_ok("--predicate", "moving-sphere", *ROUNDED, "--family", "moving-sphere/approach", "--trials", 60,
                             "--precision", "binary32", "--shrink", 60)
        wrong = {w["id"]: w for w in record["witnesses"] if w["flips"]}
        self.assertTrue(wrong)
        lines = (self.folder / "out/witnesses-shrunk.jsonl").read_text().splitlines()
        found_by = {found["before"]["id"]: found for found in map(json.loads, lines)}
        self.assertLessEqual(set(wrong), set(found_by))  # a wrong time, or a wrong feature, is kept too
        for found in (found_by[id] for id in wrong):
            self.assertLess(found["bits"]["after"], found["bits"]["before"])
            (flip,) = checked(found, *ROUNDED)["flips"]
            self.assertEqual(flip["kind"], found["kept"]["kind"])

    def test_what_it_cannot_keep_is_said(self):
        self.refused("shrink", "-", stdin=FALLS, says=["'falls'", "moving-sphere/twenty is not wrong"])
        self.refused("shrink", "-", "--what", "asymmetry", stdin=FALLS,
                     says=["query 'falls': --what asymmetry: give an address, or a witness, of a family of images"])
        self.refused("shrink", "-", "--what", "start.plane.radius:error", "--kernel", "moving-sphere/segment", stdin=FALLS,
                     says=["moving-sphere/segment has no measurable error there: it shows no sides"])
        self.refused("shrink", "-", "--what", "start.plain", stdin=FALLS, says=["did you mean 'start.plane'"])
        self.refused("shrink", "-", "--kernel", "published", stdin=FALLS,
                     says=["query 'falls' is of the predicate moving-sphere", "kernel published of sphere-triangle"])
        self.refused("shrink", "-", stdin=FALLS.replace('"r":1', '"r":-1'),
                     says=["'falls'", "not a valid query", "the radius not negative"])


class MotionCorpus(Case):
    def test_a_run_replays_it_and_its_kernels_are_wrong_there(self):
        record = self.run_ok("--predicate", "moving-sphere", "--corpus", *ROUNDED, "--kernel", "moving-sphere/segment",
                             "--kernel", "moving-sphere/twenty-nonstrict", "--precision", "binary32")
        self.assertEqual(record["plan"]["families"], ["corpus"])
        wrong = {k["id"]: sum(k["families"]["corpus"]["verdict"][f] or 0 for f in ("false_separation", "false_contact"))
                 for k in record["kernels"]}
        self.assertGreaterEqual(wrong["moving-sphere/rounded"], 3)
        self.assertGreaterEqual(wrong["moving-sphere/segment"], 1)
        address = next(w["address"] for w in record["witnesses"])
        again = axiscert("query", address)
        self.assertEqual(json.loads(again.stdout)["predicate"], "moving-sphere", again.stderr)


class SearchMotion(Case):
    def test_it_finds_what_check_confirms_and_goes_on(self):
        plan = ("search", *ROUNDED, "--family", "moving-sphere/general", "--out", self.folder / "out")
        done = axiscert(*plan, "--evaluations", 1024, "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual(set(found["verdict"]), {"missed_contact", "phantom_contact"})
        self.assertEqual(found["comparisons"], [])
        for goal, kind in (("missed_contact", "false_separation"), ("phantom_contact", "false_contact")):
            worst = found["verdict"][goal]
            if worst is None:
                continue
            (flip,) = checked(worst["witness"], *ROUNDED)["flips"]
            self.assertEqual(flip["kind"], kind)
        self.assertTrue(any(found["verdict"].values()))
        jsonschema.validate(json.loads((self.folder / "out/search.json").read_text()), schema_of("search"))
        more = axiscert(*plan, "--evaluations", 2048, "--resume", "--format", "json")
        self.assertEqual(more.returncode, 0, more.stderr)
        at_once = axiscert("search", *ROUNDED, "--family", "moving-sphere/general", "--evaluations", 2048, "--format", "json")
        self.assertEqual(more.stdout, at_once.stdout)

    def test_what_it_cannot_look_for_is_said(self):
        self.refused("search", *ROUNDED, "--comparison", "plane.radius", says=["--comparison does not serve the predicate"])
        self.refused("search", *ROUNDED, "--family", "general", says=["moving-sphere/rounded", "'general'"])
        self.refused("search", "--predicate", "moving-sphere", "--kernel", "published", says=["published", "moving-sphere"])


if __name__ == "__main__":
    unittest.main()
