#!/usr/bin/env python3
"""Two boxes from the command: query files in either entry, a run with its record and reports, search, shrink, map and the critical
extent, and what does not serve them yet."""
import json
import math
import subprocess
import unittest

from command import ROOT, Case, axiscert

UPRIGHT = [[1, 0, 0], [0, 1, 0], [0, 0, 1]]


def cube(at=(0, 0, 0), columns=None, half=(1, 1, 1)):
    return {"m": list(at), "s": list(half), "b": columns or UPRIGHT}


def turned(at=(0, 0, 0), quaternion=(1, 0, 0, 0), half=(1, 1, 1)):
    return {"m": list(at), "s": list(half), "q": list(quaternion)}


def line(a, b, id="q", precision="binary64"):
    return json.dumps({"id": id, "predicate": "box-box", "precision": precision, "a": a, "b": b}) + "\n"


def columns_by(x, y, z):
    """The columns of Rz(z) Ry(y) Rx(x), angles in degrees."""
    (cx, sx), (cy, sy), (cz, sz) = [(math.cos(math.radians(t)), math.sin(math.radians(t))) for t in (x, y, z)]
    return [[cz * cy, sz * cy, -sy], [cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx],
            [cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx]]


# Unit cubes, one a quarter turn further than the other: ODE 0.16.2 finds no contact.
QUARTER_TURN = line(cube(columns=columns_by(65, 20, 10)), cube((0.5, 1, -0.75), columns_by(155, 20, 10)), "quarter-turn")


class BoxBox(Case):
    def checked(self, text, *options):
        done = axiscert("check", "-", "--format", "jsonl", *options, stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(each) for each in done.stdout.splitlines()]

    def test_check_tells_penetration_or_distance_and_the_axes_that_decide(self):
        lines = line(cube(), cube((0.5, 1.5, 0))) + line(cube(), cube((3, 0, 0), half=(0.5, 4, 4)))
        inside, apart = self.checked(lines, "--kernel", "box-box/textbook")
        self.assertEqual((inside["predicate"], inside["kernel"]), ("box-box", "box-box/textbook"))
        exact = inside["exact"]
        self.assertEqual((exact["verdict"], exact["penetration"], exact["distance"]), ("contact", "0x1p-1", None))
        self.assertEqual(exact["deciding_axes"], ["a1", "b1", "a0b2", "a2b0"])
        exact = apart["exact"]
        self.assertEqual((exact["verdict"], exact["penetration"], exact["distance"]), ("separated", None, "0x1.8p+0"))
        self.assertIn("a0", exact["deciding_axes"])
        self.assertEqual(len(exact["comparisons"]), 15)
        done = axiscert("check", "-", stdin=lines)
        self.assertEqual(done.stdout.splitlines()[0], "q: exact contact (deciding_axes a1 b1 a0b2 a2b0, defect 0), box-box/projected contact")
        self.assertIn("exact separated (deciding_axes a0 b0", done.stdout)

    def test_a_box_of_a_quaternion_is_the_other_entry(self):
        (found,) = self.checked(line(turned(), turned((2, 0, 0), (0, 5, 0, 0))))
        self.assertEqual((found["kernel"], found["exact"]["touching"]), ("box-box/projected-turned", True))
        self.refused("check", "-", "--kernel", "box-box/textbook", stdin=line(turned(), turned()),
                     says=["entry quaternion", "entry matrix", "a query is judged by a kernel of its own predicate and entry"])

    def test_boxes_by_min_and_max_are_judged_as_they_are(self):
        """A half extent is no number of binary32: 2^24 + 1 is a size."""
        found = self.checked((ROOT / "examples/boxes-by-corners.jsonl").read_text(), "--kernel", "box-box/intervals-minmax")
        self.assertEqual([(each["exact"]["verdict"], each["exact"]["touching"]) for each in found],
                         [("contact", True), ("separated", False), ("separated", False)])
        self.assertEqual([each["computed"]["verdict"] for each in found], ["contact", "separated", "separated"])
        self.assertEqual([each["exact"]["facts"].get("distance", {}).get("exact") for each in found], [None, "2", "1"])
        csv = "id," + ",".join(f"{box}.{end}{axis}" for box in "ab" for end in ("min", "max") for axis in "xyz") + "\nq,0,0,0,1,1,1,1,1,1,2,2,2\n"
        (from_csv,) = self.checked(csv)
        self.assertEqual((from_csv["exact"]["verdict"], from_csv["exact"]["touching"]), ("contact", True))
        good = {"min": [0, 0, 0], "max": [1, 1, 1]}
        (upside_down,) = self.checked(line({"min": [0, 2, 0], "max": [1, 1, 1]}, good))
        self.assertEqual(upside_down["exact"]["reason"], "a.min on y is 2, above 1 in a.max; on each axis min is at most max")
        (mixed,) = self.checked(line(good, turned((2, 0.5, 0.5), (3, 0, 0, 3)), precision="binary32"))
        self.assertEqual((mixed["kernel"], mixed["exact"]["touching"]), ("box-box/projected-mixed", True))
        self.refused("check", "-", stdin=line(good, cube()), says=["a is given by min and max and b by m, s and b", "both are given in one way"])

    def test_an_invalid_box_says_why(self):
        flat = [[1, 0, 0], [2, 0, 0], [0, 0, 1]]
        lines = (line(cube(columns=flat), cube()) + line(cube(), cube(half=(1, -1, 1))) + line(turned(), turned(quaternion=[0] * 4)))
        self.assertIn("exact invalid (a.b has the determinant 0; the axes of a box are linearly independent)",
                      axiscert("check", "-", stdin=lines.splitlines()[0] + "\n").stdout)
        found = [self.checked(each + "\n")[0]["exact"] for each in lines.splitlines()]
        self.assertEqual([each["verdict"] for each in found], ["invalid"] * 3)
        self.assertEqual([each["reason"] for each in found[1:]], ["b.s, element 2, is -1; half extents are 0 or more",
                                                                  "b.q is 0, 0, 0, 0; a quaternion has an element other than 0"])

    def test_what_is_missing_is_named_by_its_path(self):
        wrong = {"m": [0, 0, 0], "s": [1, 1], "b": UPRIGHT}
        self.refused("check", "-", stdin=line(wrong, cube()), says=["stdin:1: field 'a.s': an array of 2"])
        self.refused("check", "-", stdin=line({"m": [0, 0, 0], "s": [1, 1, 1]}, cube()), says=["field 'a.b': missing"])
        self.refused("check", "-", stdin=line({"m": [0, 0, 0], "s": [1, 1, 1], "q": [1, 0, 0, 0], "b": UPRIGHT}, cube()),
                     says=["stdin:1: field 'a.q': not read beside m, s and b"])

    def test_a_run_has_a_record_witnesses_and_reports(self):
        record = self.run_ok("--predicate", "box-box", "--trials", "96", "--precision", "binary32", "--kernel", "box-box/textbook",
                             "--kernel", "box-box/cofactor", "--kernel", "box-box/gottschalk")
        self.assertEqual(record["plan"]["predicate"], "box-box")
        by = {kernel["id"]: kernel["families"] for kernel in record["kernels"]}
        self.assertEqual(len(by["box-box/textbook"]), 28)
        resting = {id: families["box-box/resting"]["verdict"] for id, families in by.items()}
        self.assertGreater(resting["box-box/textbook"]["links"]["specification"], 3)
        self.assertEqual(resting["box-box/cofactor"]["false_separation"], 0)
        self.assertGreater(by["box-box/gottschalk"]["box-box/crossed"]["verdict"]["false_contact"], 3)
        witnesses = (self.folder / "out" / "witnesses.jsonl").read_text()
        self.assertTrue(witnesses)
        first = json.loads(witnesses.splitlines()[0])
        self.assertEqual([len(first["a"][name]) for name in "msb"], [3, 3, 3])
        done = axiscert("check", "-", stdin=witnesses)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(axiscert("report", self.folder / "out").returncode, 0)
        address = next(w["address"] for w in record["witnesses"])
        again = json.loads(axiscert("query", address).stdout)
        self.assertEqual(again["a"], first["a"])

    def test_a_run_of_quaternions_has_their_families(self):
        record = self.run_ok("--predicate", "box-box", "--trials", "16", "--precision", "binary32", "--kernel", "box-box/homogeneous",
                             "--kernel", "box-box/textbook-turned")
        self.assertEqual({name[-7:] for name in record["kernels"][0]["families"]}, {"_turned"})
        record = self.run_ok("--predicate", "box-box", "--family", "box-box/lattice_turned", "--trials", "8", "--precision", "binary32", out="one")
        self.assertEqual(record["plan"]["kernels"], ["box-box/projected-turned"])

    def test_what_does_not_serve_the_test_says_so_in_one_line(self):
        kernel = ("--kernel", "box-box/textbook")
        for command in (("ladder", *kernel), ("precision", *kernel), ("condition", *kernel), ("league", *kernel),
                        ("run", "--predicate", "box-box", "--mesh", "x.obj")):
            done = self.refused(*command, says=["does not serve the predicate box-box"])
            self.assertEqual(len(done.stderr.strip().splitlines()), 1, done.stderr)
        self.refused("mutate", *kernel, says=["box-box/textbook"])

    def test_a_search_finds_a_deep_miss_and_shrink_and_map_take_it(self):
        done = axiscert("search", "--kernel", "box-box/textbook", "--family", "box-box/resting", "--evaluations", "1024", "--format", "json",
                        "--out", self.folder / "found")
        self.assertEqual(done.returncode, 0, done.stderr)
        witnesses = (self.folder / "found" / "witnesses.jsonl").read_text()
        (missed,) = [line for line in witnesses.splitlines() if "missed" in json.loads(line)["id"]]
        (judged,) = self.checked(missed + "\n", "--kernel", "box-box/textbook")
        self.assertEqual(judged["exact"]["verdict"], "contact")
        self.assertLess(float.fromhex(judged["exact"]["defect"]), 32)
        done = axiscert("shrink", "-", "--kernel", "box-box/textbook", "--evaluations", "150", stdin=missed + "\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("keeps verdict false_separation", done.stdout)
        done = axiscert("map", "-", "--kernel", "box-box/textbook", "--size", "4", "--out", self.folder / "drawn", stdin=missed + "\n")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("16 pictures", done.stdout)
        record = self.run_ok("--kernel", "box-box/textbook", "--family", "box-box/resting", "--trials", "32", "--precision", "binary32",
                             "--shrink", "40")
        self.assertTrue(record["witnesses"])
        self.assertTrue((self.folder / "out" / "witnesses-shrunk.jsonl").read_text())

    def test_the_critical_extent_of_each_entry(self):
        for kernel, family in (("box-box/cofactor", "general"), ("box-box/homogeneous", "general_turned")):
            done = axiscert("critical-radius", "--kernel", kernel, "--family", f"box-box/{family}", "--trials", "40")
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertIn("half extent of A's first axis", done.stdout)

    def test_a_query_goes_through_a_pipe(self):
        made = axiscert("generate", "--family", "box-box/resting", "--trials", "3")
        self.assertEqual(made.returncode, 0, made.stderr)
        self.assertEqual(len(self.checked(made.stdout, "--kernel", "box-box/cofactor")), 3)


    def test_the_example_is_the_kernel_with_cofactors_bit_for_bit(self):
        plugin = self.folder / "box_kernel.so"
        source = ROOT / "examples" / "plugin" / "box_kernel.c"
        subprocess.run(["cc", "-O2", "-std=c99", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT / 'kernel' / 'include'}", source,
                        "-o", plugin, "-lm"], check=True)
        families = [word for name in ("resting", "tangent", "bits") for word in ("--family", f"box-box/{name}")]
        record = self.run_ok("--kernel", f"plugin:{plugin}", "--kernel", "box-box/cofactor", "--kernel", "box-box/textbook", *families,
                             "--trials", "64", "--precision", "binary32")
        example, cofactor, _ = (kernel["families"] for kernel in record["kernels"])
        for family, found in example.items():
            self.assertEqual(found["verdict"], cofactor[family]["verdict"], family)
            self.assertEqual(found["verdict"]["links"]["implementation"], 0)


class BoxTriangle(Case):
    TRIANGLE = {"a": [1, 0, 0], "b": [3, 0, 0], "c": [2, 1, 0]}

    def line(self, box, precision="binary32"):
        return json.dumps({"id": "q", "predicate": "box-triangle", "precision": precision, "box": box, **self.TRIANGLE}) + "\n"

    def checked(self, text, *options):
        done = axiscert("check", "-", "--format", "jsonl", *options, stdin=text)
        self.assertEqual(done.returncode, 0, done.stderr)
        return json.loads(done.stdout)

    def test_each_form_of_the_box_is_an_entry(self):
        half = {"m": [0, 0, 0], "s": [1, 1, 1]}
        for box, kernel in ((half, "textbook"), ({"min": [-1, -1, -1], "max": [1, 1, 1]}, "textbook-minmax"),
                            ({**half, "b": UPRIGHT}, "textbook-oriented"), ({**half, "q": [0, 3, 0, 0]}, "textbook-turned")):
            found = self.checked(self.line(box))
            self.assertEqual(found["kernel"], f"box-triangle/{kernel}")
            self.assertEqual((found["exact"]["verdict"], found["exact"]["touching"]), ("contact", True))
            self.assertEqual(found["exact"]["penetration"], "0x0p+0")
        found = self.checked(self.line({"min": [2, 0, 0], "max": [1, 1, 1]}))
        self.assertEqual(found["exact"]["reason"], "box.min on x is 2, above 1 in box.max; on each axis min is at most max")

    def test_a_run_is_of_one_entry(self):
        record = self.run_ok("--predicate", "box-triangle", "--trials", "40", "--precision", "binary32")
        self.assertEqual(set(record["kernels"][0]["families"]),
                         {f"box-triangle/{name}" for name in ("general", "touching", "lattice", "degenerate", "terrain", "ramp", "level_voxel",
                                                      "one_axis", "units", "spans", "thin", "aligned")})
        record = self.run_ok("--kernel", "box-triangle/textbook-minmax", "--kernel", "box-triangle/thirteen-minmax", "--trials", "200",
                             "--precision", "binary32", out="minmax")
        for kernel in record["kernels"]:
            for name, family in kernel["families"].items():
                self.assertEqual(family["verdict"]["links"]["specification"], 0, name)
        self.assertGreater(record["kernels"][0]["families"]["box-triangle/touching_minmax"]["verdict"]["links"]["rounding"], 5)

    def test_a_mesh_is_asked_against_the_cells_of_a_grid(self):
        (self.folder / "one.obj").write_text("v 0 0 0\nv 1 0 0\nv 0.3 1 0.2\nf 1 2 3\n")
        record = self.run_ok("--predicate", "box-triangle", "--mesh", str(self.folder / "one.obj"), "--trials", "200", "--precision", "binary32")
        self.assertEqual(record["plan"]["kernels"], ["box-triangle/textbook-minmax"])
        (found,) = record["kernels"][0]["families"].values()
        self.assertEqual(found["trials"], 200)
        self.assertGreater(found["truth"]["contact"], 20)

    def test_an_oriented_box_is_missed_by_specification(self):
        record = self.run_ok("--kernel", "box-triangle/textbook-oriented", "--kernel", "box-triangle/thirteen-oriented", "--trials", "200",
                             "--precision", "binary32")
        wrong = [kernel["families"]["box-triangle/touching_oriented"]["verdict"]["links"]["specification"] for kernel in record["kernels"]]
        self.assertGreater(wrong[0], 3)
        self.assertEqual(wrong[1], 0)


class BoxPeersLong(Case):
    def test_cgal_in_epick_is_wrong_on_a_triangle_with_two_equal_corners_alone(self):
        done = axiscert("check", ROOT / "fuzz/corpus/box-triangle.jsonl", "--kernel", "box-triangle/peer/cgal-epick")
        self.assertIn("cgal-two-equal-corners: exact separated", done.stdout)
        self.assertIn("box-triangle/peer/cgal-epick contact", done.stdout)
        record = self.run_ok("--kernel", "box-triangle/peer/cgal-epick", "--trials", "1000", "--precision", "binary32")
        (kernel,) = record["kernels"]
        wrong = {name: sum(family["verdict"][kind] or 0 for kind in ("false_separation", "false_contact"))
                 for name, family in kernel["families"].items()}
        self.assertEqual({name for name, count in wrong.items() if count}, {"box-triangle/lattice_minmax"}, wrong)

    def test_ode_misses_a_contact_of_nearly_a_half_extent(self):
        done = axiscert("check", "-", "--kernel", "box-box/peer/ode", stdin=QUARTER_TURN)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("quarter-turn: exact contact (deciding_axes b1 a0b2,", done.stdout)
        self.assertIn("\n  rounded to 17 digits: penetration 0.98", done.stdout)
        self.assertIn("box-box/peer/ode separated", done.stdout)


if __name__ == "__main__":
    unittest.main()
