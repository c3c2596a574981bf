#!/usr/bin/env python3
"""The moving sphere from the command: a run, query lines, and what does not serve it yet."""
import hashlib
import json
import unittest

from command import Case, axiscert

# Passes over the face at height 1, with radius 1: it touches.
GRAZE = ('{"id":"graze","predicate":"moving-sphere","precision":"binary32","a":[0,0,0],"b":[4,0,0],"c":[0,4,0],'
         '"p":[1,1,1],"d":[1,0,0],"r":1}\n')
# Along a triangle that is a segment, at height 2 with radius 1: strict sides invent a contact.
PHANTOM = ('{"id":"line","predicate":"moving-sphere","precision":"binary32","a":[0,0,0],"b":[4,0,0],"c":[8,0,0],'
           '"p":[1,0,2],"d":[1,0,0],"r":1}\n')


class MovingSphere(Case):
    def test_a_run_judges_every_kernel_and_family_of_the_test(self):
        record = self.run_ok("--predicate", "moving-sphere", "--trials", "16", "--kernel", "moving-sphere/twenty",
                             "--kernel", "moving-sphere/twenty-nonstrict", "--kernel", "moving-sphere/rounded")
        self.assertEqual(record["plan"]["predicate"], "moving-sphere")
        listed = json.loads(axiscert("families", "--predicate", "moving-sphere", "--format", "json").stdout)["families"]
        by_displacement = {family["name"] for family in listed if not family["name"].startswith("moving-sphere/ends_")}
        for entry in record["kernels"]:
            self.assertEqual(set(entry["families"]), by_displacement, entry["id"])
        by = {(k["id"], k["precision"]): k["families"]["moving-sphere/lattice"] for k in record["kernels"]}
        for precision in ("binary32", "binary64"):
            exact = by["moving-sphere/twenty-nonstrict", precision]["verdict"]
            self.assertEqual((exact["false_separation"], exact["false_contact"]), (0, 0))

    def test_check_takes_query_lines_and_the_kernel_of_their_test(self):
        done = axiscert("check", "-", "--format", "jsonl", stdin=GRAZE)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual((found["predicate"], found["kernel"]), ("moving-sphere", "moving-sphere/twenty"))
        self.assertEqual(found["exact"]["verdict"], "contact")
        self.assertTrue(found["exact"]["touching"])
        self.assertEqual(len(found["exact"]["comparisons"]), 61)
        self.assertEqual(len(found["computed"]["axes"]), 20)

    def test_check_tells_the_first_contact(self):
        # Down on the face from height 3 to -1: at height 1 after half of the way. Then |(4 t - 2, -1)| = 2 at 1/2 - sqrt(3)/4.
        falls = GRAZE.replace('"p":[1,1,1],"d":[1,0,0]', '"p":[1,1,3],"d":[0,0,-4]')
        passes = GRAZE.replace('"p":[1,1,1],"d":[1,0,0],"r":1', '"p":[-2,-1,0],"d":[4,0,0],"r":2')
        rises = GRAZE.replace('"p":[1,1,1],"d":[1,0,0]', '"p":[1,1,3],"d":[0,0,4]')
        nowhere = GRAZE.replace('"d":[1,0,0]', '"d":["inf",0,0]')
        lines = falls + passes + passes.replace("binary32", "binary64") + rises + GRAZE + nowhere
        done = axiscert("check", "-", "--format", "jsonl", stdin=lines)
        exact = [json.loads(line)["exact"] for line in done.stdout.splitlines()]
        self.assertEqual([tuple(found.get(name) for name in ("time", "features", "start")) for found in exact],
                         [("0x1p-1", ["face"], "clear"), ("0x1.126144p-4", ["vertex_a"], "clear"),
                          ("0x1.126145e9ecd56p-4", ["vertex_a"], "clear"), (None, None, "clear"),
                          ("0x0p+0", ["face"], "touching"), (None, None, None)])
        self.assertIn("graze: exact contact (start clear), moving-sphere/twenty contact\n",
                      axiscert("check", "-", stdin=falls).stdout)

    def test_check_tells_a_kernels_contact_beside_the_exact_one(self):
        falls = GRAZE.replace('"p":[1,1,1],"d":[1,0,0]', '"p":[1,1,3],"d":[0,0,-4]')
        done = axiscert("check", "-", "--kernel", "moving-sphere/rounded", "--format", "jsonl", stdin=falls)
        told = json.loads(done.stdout)["computed"]["measures"]
        self.assertEqual([told["given"][name] for name in ("time", "feature", "normal_z", "point_x")],
                         ["0x1p-1", "0x1.8p+2", "0x1p+0", "0x1p+0"])
        self.assertEqual((told["time"], told["feature_is_right"], told["normal_angle"], told["point_error"]),
                         ("best", True, 0.0, 0.0))
        self.assertIn("moving-sphere/rounded contact (time 0.5, feature 6, ", axiscert(
            "check", "-", "--kernel", "moving-sphere/rounded", stdin=falls).stdout)

    def test_a_run_says_how_late_its_kernels_are(self):
        record = self.run_ok("--predicate", "moving-sphere", "--trials", "200", "--kernel", "moving-sphere/rounded",
                             "--kernel", "moving-sphere/twenty", "--family", "moving-sphere/approach",
                             "--require", "never-late", "--require", "no-tunnel", code=1)
        for entry in record["kernels"]:
            motion = entry["families"]["moving-sphere/approach"]["contacts"]
            if entry["id"] == "moving-sphere/twenty":
                self.assertEqual((entry["measures"], motion["time"]), ([], None))
                continue
            time = motion["time"]
            self.assertEqual(sum(time[name] for name in ("none", "invalid", "early", "best", "late")), motion["answers"])
            self.assertGreater(time["late"], 0)

    def test_check_says_why_strict_sides_are_wrong(self):
        done = axiscert("check", "-", stdin=PHANTOM)
        self.assertIn("line: exact separated, moving-sphere/twenty contact", done.stdout)
        self.assertIn("verdict false_contact [specification]", done.stdout)
        right = axiscert("check", "-", "--kernel", "moving-sphere/twenty-nonstrict", stdin=PHANTOM)
        self.assertIn("line: exact separated, moving-sphere/twenty-nonstrict separated\n", right.stdout)

    def test_a_query_of_one_test_is_not_judged_by_a_kernel_of_another(self):
        self.refused("check", "-", "--kernel", "published", stdin=GRAZE,
                     says=["query 'graze' is of the predicate moving-sphere", "kernel published of sphere-triangle"])

    def test_what_does_not_serve_the_test_says_so_in_one_line(self):
        kernel = ("--kernel", "moving-sphere/twenty")
        for command in (("ladder", *kernel), ("precision", *kernel), ("condition", *kernel)):
            done = self.refused(*command, says=["does not serve the predicate moving-sphere yet; it serves sphere-triangle"])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)

    def test_check_measures_the_sides_that_a_kernel_shows(self):
        done = axiscert("check", "-", "--errors", stdin=GRAZE)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertRegex(done.stdout, r"(?m)^  start\.plane\.radius: error 0 u, relative 0 u$")

    def test_a_mesh_is_swept_and_an_address_gives_its_query_again(self):
        mesh = self.folder / "floor.obj"
        mesh.write_text("v 0 0 0\nv 4 0 0\nv 0 4 0\nv 4 4 1\nf 1 2 3\nf 2 4 3\n")
        record = self.run_ok("--predicate", "moving-sphere", "--mesh", mesh, "--trials", "60", "--precision", "binary32",
                             "--kernel", "moving-sphere/twenty", "--kernel", "moving-sphere/rounded")
        family = record["kernels"][0]["families"]["mesh/floor.obj"]
        self.assertEqual((family["trials"], family["base_triangles"]), (60, 2))
        self.assertGreater(family["truth"]["contact"], 10)
        address = "1:moving-sphere/mesh-%s:1:binary32:0:7" % hashlib.sha256(mesh.read_bytes()).hexdigest()
        line = axiscert("query", address, "--mesh", mesh)
        self.assertEqual(line.returncode, 0, line.stderr)
        done = axiscert("check", "-", "--format", "jsonl", stdin=line.stdout)
        self.assertEqual(done.returncode, 0, done.stderr)
        found = json.loads(done.stdout)
        self.assertEqual((found["predicate"], found["id"]), ("moving-sphere", address))
        self.refused("query", address, says=["--mesh FILE"])

    def test_images_judge_a_kernel_without_an_oracle(self):
        families = [word for name in ("inverted", "reversed", "split", "halved", "units")
                    for word in ("--family", "moving-sphere/" + name)]
        done = axiscert("run", "--kernel", "moving-sphere/twenty-nonstrict", *families, "--trials", "210",
                        "--precision", "binary32", "--require", "invariant=mirror", "--require", "invariant=scale",
                        "--out", self.folder / "images")
        self.assertEqual(done.returncode, 0, done.stderr)
        record = json.loads((self.folder / "images" / "record.json").read_text())
        families = record["kernels"][0]["families"]
        self.assertEqual(families["moving-sphere/reversed"]["invariance"]["reversal"]["images"], 105)
        self.assertEqual(families["moving-sphere/split"]["invariance"]["split"]["images"], 90)
        halving = families["moving-sphere/halved"]["invariance"]["halving"]["images"]
        self.assertTrue(0 < halving < 156 and halving % 3 == 0, halving)  # three of each contact
        done = axiscert("run", "--kernel", "moving-sphere/twenty", "--family", "moving-sphere/general", "--trials", "10",
                        "--require", "invariant=reversal", "--out", self.folder / "none")
        self.assertIn("add --family moving-sphere/reversed", done.stdout + done.stderr)

    def test_a_map_is_drawn_around_a_motion(self):
        done = axiscert("map", "-", "--along", "d.x", "--size", "8", "--what", "verdict", "--what", "start.plane.radius",
                        "--format", "json", "--out", self.folder / "maps", stdin=PHANTOM)
        self.assertEqual(done.returncode, 0, done.stderr)
        (found,) = json.loads(done.stdout)["maps"]
        self.assertEqual(found["kernel"], "moving-sphere/twenty")
        self.assertEqual([picture["name"] for picture in found["pictures"]], ["verdict", "start.plane.radius"])
        self.assertEqual(found["pictures"][0]["counts"]["missed_separation"], 64)
        self.refused("map", "-", "--along", "e.x", stdin=PHANTOM, says=["'e.x'", "a.x", "r"])
        self.refused("map", "-", "--kernel", "published", stdin=PHANTOM, says=["is of the predicate moving-sphere"])

    def test_critical_radii_are_measured_from_the_least_distance(self):
        done = axiscert("critical-radius", "--kernel", "moving-sphere/twenty-nonstrict", "--family",
                        "moving-sphere/general", "--trials", "40", "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        (total,) = json.loads(done.stdout)["totals"]
        self.assertEqual(total["measured"], 40)
        self.refused("critical-radius", "--kernel", "moving-sphere/twenty", "--family", "general",
                     says=["its queries are of sphere-triangle, but the kernels are of moving-sphere"])

    def test_bad_numbers_are_told_with_their_field(self):
        self.refused("check", "-", stdin=GRAZE.replace('"d":[1,0,0]', '"d":[1,0]'), says=["field 'd'", "three numbers"])
        self.refused("check", "-", stdin=GRAZE.replace('"d":[1,0,0],', ""), says=["field 'd'", "missing"])
        done = axiscert("check", "-", "--format", "jsonl", stdin=GRAZE.replace('"d":[1,0,0]', '"d":["nan",0,0]'))
        self.assertEqual(json.loads(done.stdout)["exact"]["verdict"], "invalid")


if __name__ == "__main__":
    unittest.main()
