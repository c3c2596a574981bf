#!/usr/bin/env python3
"""Motions given by their ends, P and P1: the entry `endpoints` of moving-sphere from the command."""
import json
import unittest

from command import Case, axiscert

# From z = 10^8 down to z = 1, half a radius above the face: P1 - P is no number of binary32.
CLEAR = ('{"id":"clear","predicate":"moving-sphere","precision":"binary32","a":[0,0,0],"b":[4,0,0],"c":[0,4,0],'
         '"p":[1,1,100000000],"p1":[1,1,1],"r":0.5}\n')
FALLS = CLEAR.replace("100000000", "3").replace('"p1":[1,1,1]', '"p1":[1,1,-1]').replace("0.5", "1")
SURE, ROUNDED = "moving-sphere/ends-twenty-nonstrict", "moving-sphere/ends-difference"


class Ends(Case):
    def checked(self, line, *kernel):
        done = axiscert("check", "-", *kernel, "--format", "jsonl", stdin=line)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_a_line_with_p1_is_judged_by_a_kernel_of_its_entry(self):
        found = self.checked(FALLS)
        self.assertEqual(found["kernel"], "moving-sphere/ends-twenty")
        self.assertEqual([found["exact"][name] for name in ("verdict", "time", "features", "start")],
                         ["contact", "0x1p-1", ["face"], "clear"])
        self.assertEqual(self.checked(FALLS.replace('"p":', '"entry":"endpoints","p":'))["exact"], found["exact"])
        self.refused("check", "-", "--kernel", "moving-sphere/twenty", stdin=FALLS,
                     says=["entry endpoints", "entry displacement", "a query is judged by a kernel of its own predicate and entry"])
        csv = "id,ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,p1x,p1y,p1z,r\nfalls,0,0,0,4,0,0,0,4,0,1,1,3,1,1,-1,1\n"
        self.assertEqual(self.checked(csv)["exact"], found["exact"])

    def test_the_displacement_is_exact_and_one_that_is_rounded_is_another_motion(self):
        sure, rounded = self.checked(CLEAR, "--kernel", SURE), self.checked(CLEAR, "--kernel", ROUNDED)
        self.assertEqual((sure["exact"]["verdict"], sure["computed"]["verdict"]), ("separated", "separated"))
        self.assertEqual((rounded["exact"]["verdict"], rounded["computed"]["verdict"]), ("separated", "contact"))
        text = axiscert("check", "-", "--kernel", "moving-sphere/ends-gated", stdin=FALLS).stdout
        self.assertIn("exact contact (start clear), moving-sphere/ends-gated contact (time 0.5", text)

    def test_a_run_is_of_one_entry_and_its_witnesses_have_p1(self):
        record = self.run_ok("--kernel", SURE, "--kernel", ROUNDED, "--kernel", "moving-sphere/ends-rounded", "--trials", 60,
                             "--precision", "binary32")
        names = record["plan"]["families"]
        self.assertEqual(len(names), 16)
        self.assertTrue(all(name.startswith("moving-sphere/ends_") for name in names), names)
        lattice = record["kernels"][0]["families"]["moving-sphere/ends_lattice"]["verdict"]
        self.assertEqual((lattice["false_separation"], lattice["false_contact"]), (0, 0))
        witness = next(w for w in record["witnesses"] if w["kernel"] == "moving-sphere/ends-rounded" and w["truth"] == "contact")
        self.assertEqual((len(witness["p1"]), "d" in witness), (3, False))
        line = axiscert("query", witness["address"])
        again = self.checked(line.stdout, "--kernel", "moving-sphere/ends-rounded")
        self.assertEqual(again["exact"]["time"], witness["exact_contact"]["time"])
        self.refused("run", "--kernel", SURE, "--kernel", "moving-sphere/twenty", "--out", self.folder / "mixed",
                     says=["entry"])
        self.refused("run", "--kernel", SURE, "--family", "moving-sphere/general", "--out", self.folder / "mixed",
                     says=["endpoints", "displacement", "its own entry"])

    def test_bad_lines_are_told_with_their_field(self):
        self.refused("check", "-", stdin=FALLS.replace("[1,1,-1]", "[1,1]"), says=["field 'p1'", "three numbers"])
        self.refused("check", "-", stdin=FALLS.replace("[1,1,-1]", '[1,1,"x"]'), says=["field 'p1'"])
        for beyond in ('"inf"', '"nan"'):
            found = self.checked(FALLS.replace("[1,1,-1]", f"[1,1,{beyond}]"))
            self.assertEqual(found["exact"]["verdict"], "invalid")

    def test_what_does_not_serve_the_entry_says_so_in_one_line(self):
        says = ["does not serve the entry endpoints of the predicate moving-sphere yet; it serves displacement"]
        for command in (("search", "--kernel", SURE),
                        ("critical-radius", "--kernel", SURE, "--family", "moving-sphere/ends_general")):
            done = self.refused(*command, says=says)
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)


if __name__ == "__main__":
    unittest.main()
