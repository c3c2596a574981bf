#!/usr/bin/env python3
"""Tests of `precision` in formats by name, of own queries and kernels, and of swept parameters."""
import csv
import io
import json
import re
import subprocess
import unittest

import jsonschema
import numpy

from command import MODELS, QUERY, ROOT, Case, axiscert, schema_of
from exact_predicates import truth

QUERIES = ("--family", "tangent", "--trials", 400)


def precision(*args):
    done = axiscert("precision", *args, "--format", "json")
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def wrong(step, exponents="limited"):
    return sum(step[exponents]["verdict"].values())


def number(value):
    return float.fromhex(value) if isinstance(value, str) else float(value)


def columns_of(*plan):
    """The thirteen numbers of each query, as columns."""
    done = axiscert("generate", *plan)
    assert done.returncode == 0, done.stderr
    queries = [json.loads(line) for line in done.stdout.splitlines()]
    return numpy.array([[number(x) for point in "abcp" for x in q[point]] + [number(q["r"])] for q in queries]).T


class Vector:
    """Three columns of a numpy type, which rounds after every operation."""

    def __init__(self, x, y, z):
        self.parts = (x, y, z)

    def __sub__(self, other):
        return Vector(*(a - b for a, b in zip(self.parts, other.parts)))

    def __add__(self, other):
        return Vector(*(a + b for a, b in zip(self.parts, other.parts)))

    def times(self, s):
        return Vector(*(a * s for a in self.parts))

    def dot(self, other):
        x, y, z = (a * b for a, b in zip(self.parts, other.parts))
        return (x + y) + z

    def cross(self, other):
        (ux, uy, uz), (vx, vy, vz) = self.parts, other.parts
        return Vector(uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx)


def is_separated(columns, edges_are_published):
    """The article's test, written from the article: published, or with the edges before centring and cross-multiplying."""
    a, b, c, p = (Vector(*columns[3 * i:3 * i + 3]) for i in range(4))
    r = columns[12]
    A, B, C, rr = a - p, b - p, c - p, r * r
    V = (B - A).cross(C - A)
    d, e = A.dot(V), V.dot(V)
    separated = d * d > rr * e
    for X, Y, Z in ((A, B, C), (B, A, C), (C, A, B)):
        xx = X.dot(X)
        separated |= (xx > rr) & (X.dot(Y) > xx) & (X.dot(Z) > xx)
    for X, Y, Z in ((A, B, C), (B, C, A), (C, A, B)) if edges_are_published else ():
        XY = Y - X
        d, e = X.dot(Y) - X.dot(X), XY.dot(XY)
        Q = X.times(e) - XY.times(d)
        separated |= (Q.dot(Q) > (rr * e) * e) & (Q.dot(Z.times(e) - Q) > 0)
    for x, y, z in () if edges_are_published else ((a, b, c), (b, c, a), (c, a, b)):
        XY = y - x
        d, e = (p - x).dot(XY), XY.dot(XY)
        Q = x + XY.times(d / e)
        QP, QZ = p - Q, z - Q
        separated |= (QP.dot(QP) > rr) & (0 > QP.dot(QZ))
    return separated


class Formats(Case):
    def test_binary16_is_what_numpy_computes(self):
        columns = columns_of("--family", "tangent", "--trials", 400, "--precision", "binary32").astype(numpy.float16)
        exact = [truth("sphere-triangle", "vertices", [float(x) for x in column])[0] for column in columns.T]
        truly_separated = numpy.array([verdict == "separated" for verdict in exact])
        found = precision(*QUERIES, "--number", "binary16", "--round-inputs", "--kernel", "published", "--kernel", "ladder-5")
        for kernel, is_published in (("published", True), ("ladder-5", False)):
            with numpy.errstate(all="ignore"):
                computed = is_separated(columns, is_published)
            (step,) = found["all"]["kernels"][kernel]["precisions"]
            self.assertEqual(step["queries"], 400)
            self.assertEqual(step["limited"]["verdict"],
                             {"false_separation": int((computed & ~truly_separated).sum()),
                              "false_contact": int((~computed & truly_separated).sum())}, kernel)
            self.assertGreater(wrong(step), 20)

    def test_bits_with_exponents_are_the_format_of_that_name(self):
        found = precision(*QUERIES, "--kernel", "published", "--number", "bits=8,emax=127", "--number", "bfloat16", "--bits", 8,
                          "--number", "fp8-e4m3", "--number", "fp8-e4m3-saturating")
        self.assertEqual([n["number"] for n in found["numbers"]],
                         ["fp8-e4m3", "fp8-e4m3-saturating", "bits=8", "bits=8,emax=127", "bfloat16"])
        nan, saturating, *eight = found["all"]["kernels"]["published"]["precisions"]
        for step in eight[1:]:
            self.assertEqual({**step, "number": ""}, {**eight[0], "number": ""})
        self.assertEqual(nan["unlimited"], saturating["unlimited"])
        self.assertEqual([n["overflow"] for n in found["numbers"]][:2], ["nan", "greatest"])

    def test_the_table_of_docs_queries_is_of_these_formats(self):
        page = (ROOT / "docs/queries.md").read_text()
        rows = re.findall(r"^\| (`[^|]*`) \| (\d+) \| (-\d+) to (\d+) \| ([^|]*) \|$", page, re.M)
        listed = {}
        for names, *numbers, beyond in rows:
            for name in re.findall("`(.*?)`", names):
                listed[name] = (*map(int, numbers), "greatest" if name.endswith("-saturating") else
                                "nan" if beyond.startswith("NaN") else "infinity")
        found = precision("--family", "tangent", "--trials", 1, "--kernel", "published",
                          *(word for name in listed for word in ("--number", name)))
        self.assertEqual({n["number"]: (n["bits"], n["e_min"], n["e_max"], n["overflow"]) for n in found["numbers"]}, listed)
        known = re.search(r"number formats: (.*)", axiscert("precision", "--number", "half").stderr).group(1).split(", ")
        self.assertEqual({*known} - {"bits=P,emax=E"}, {*listed})

    def test_rounding_by_chance_says_its_seeds_and_repeats(self):
        plan = (*QUERIES, "--kernel", "published", "--number", "binary16", "--rounding", "stochastic", "--rounding-seeds", 4)
        found = precision(*plan)
        self.assertEqual(found["rounding_seeds"], [1, 2, 3, 4])
        steps = found["all"]["kernels"]["published"]["precisions"]
        self.assertEqual([step["rounding_seed"] for step in steps], [1, 2, 3, 4])
        self.assertGreater(len({wrong(step) for step in steps}), 1)
        self.assertEqual(precision(*plan, "--threads", 1), precision(*plan, "--threads", 2))
        self.assertEqual(precision(*found["command"].split()[2:]), found)
        text = axiscert("precision", *plan).stdout
        self.assertIn("seeds 1 to 4", text)

    def test_bad_input(self):
        for given, says in (("bits=1", ["2 to 4096"]), ("bits=9,emax=0", ["emax", "from 1 to"]), ("half", ["unknown number format 'half'"]),
                            ("bfloat", ["bfloat16"]), ("bits=9,emin=1", ["emax=E"])):
            self.refused("precision", "--number", given, says=["--number", *says])
        self.refused("precision", "--rounding", "up-and-down", says=["up-and-down", "stochastic"])
        self.refused("precision", "--rounding-seeds", 0, says=["--rounding-seeds"])
        for rounding in ((), ("--rounding", "up")):
            self.refused("precision", *rounding, "--rounding-seeds", 3, says=["--rounding-seeds 3: --rounding", "draws no numbers"])
        self.refused("precision", "--kernel", "minkowski", "--contraction", "dots", says=["minkowski", "fused"])


class OwnQueries(Case):
    COMMANDS = (("ladder", "--no-speed"), ("precision", "--bits", 24), ("condition",), ("critical-radius",))

    def test_a_file_a_mesh_and_the_corpus_are_measured_by_each(self):
        queries = self.folder / "mine.jsonl"
        queries.write_text(axiscert("generate", "--family", "tangent", "--trials", 50, "--precision", "binary32").stdout)
        mesh = MODELS / "OBJ/spider.obj"
        for command in self.COMMANDS:
            done = axiscert(*command, "--kernel", "published", "--queries", queries, "--mesh", mesh, "--corpus", "--trials", 40,
                            "--format", "json")
            self.assertEqual(done.returncode, 0, done.stderr)
            found = json.loads(done.stdout)
            for source in ("queries/mine.jsonl", "mesh/spider.obj", "corpus"):
                self.assertIn(source, done.stdout, command)
            schema = schema_of(command[0])
            self.assertNotIn("sweep", found)
            self.assertIn("schema", found)
            again = axiscert(*found["command"].split()[1:], "--format", "json")
            self.assertEqual(json.loads(again.stdout), found, schema["title"])

    def test_a_file_that_cannot_be_measured_is_refused(self):
        empty, boxes, invalid, other = (self.folder / name for name in ("empty.jsonl", "boxes.jsonl", "invalid.jsonl", "other.jsonl"))
        empty.write_text("")
        boxes.write_text(axiscert("generate", "--family", "box-box/resting", "--trials", 3, "--precision", "binary32").stdout)
        invalid.write_text(QUERY % "-1")
        other.write_text(axiscert("generate", "--family", "general", "--trials", 3, "--precision", "binary64").stdout)
        for command in self.COMMANDS:
            plan = (*command, "--kernel", "published", "--queries")
            self.refused(*plan, empty, says=["empty.jsonl"])
            self.refused(*plan, boxes, says=["boxes.jsonl", "box-box", "sphere-triangle"])
            self.refused(*plan, invalid, says=["invalid.jsonl", "none of its 1 queries", "valid"])
            self.refused(*plan, other, says=["other.jsonl", "binary64"])
            self.refused(*plan, self.folder / "none.jsonl", says=["none.jsonl"])


class OwnKernels(Case):
    def plugin(self, name, *flags):
        """The published kernel as a plug-in."""
        made = self.folder / f"{name}.so"
        subprocess.run(["cc", "-O2", "-std=c11", "-ffp-contract=off", "-shared", "-fPIC", f"-I{ROOT}", *flags,
                        ROOT / "kernel" / "sphere_triangle" / "faults" / "none.c", "-o", made], check=True)
        return f"plugin:{made}"

    def test_a_plug_in_that_shows_its_comparisons_is_measured_as_the_built_in_kernel_of_its_formulae(self):
        own = self.plugin("own")
        plan = ("--kernel", "published", "--kernel", own, "--family", "tangent", "--trials", 300, "--format", "json")
        published, plugin = json.loads(axiscert("condition", *plan).stdout)["rows"]
        self.assertEqual(plugin, {**published, "kernel": own})
        self.assertGreater(published["total"]["flips"], 20)
        published, plugin = json.loads(axiscert("ladder", *plan, "--no-speed").stdout)["kernels"]
        own, built_in = plugin["families"]["tangent"], published["families"]["tangent"]
        self.assertEqual((own["verdict"], own["queries"]), (built_in["verdict"], built_in["queries"]))
        for name, counts in own["comparisons"].items():  # it shows no sides, so that errors are not measured
            self.assertEqual(counts, {member: built_in["comparisons"][name][member] for member in counts}, name)

    def test_one_that_does_not_is_told_what_it_needs(self):
        bare = self.plugin("bare", "-DEXPOSES=AXISCERT_VERDICT_ONLY")
        for command in ("ladder", "condition"):
            self.refused(command, "--kernel", bare, says=["bare.so", "declare `formulae`", "expose comparisons", "its verdict alone"])
        self.refused("precision", "--kernel", self.plugin("own"), says=["own.so", "built-in formulae"])


class Sweeps(Case):
    def test_the_parameter_is_an_axis_of_each_instrument(self):
        for command in OwnQueries.COMMANDS:
            done = axiscert(*command, "--kernel", "published", "--family", "tangent", "--trials", 60, "--sweep", "offset=-8,0,2^4,2^12",
                            "--format", "json", "--out", self.folder / command[0])
            self.assertEqual(done.returncode, 0, done.stderr)
            found = json.loads(done.stdout)
            self.assertEqual(found["sweep"], {"parameter": "offset", "values": [-8, 0, 16, 4096]}, command)
            self.assertEqual([error.message for error in jsonschema.Draft202012Validator(schema_of(command[0])).iter_errors(found)], [])
            for name in ("tangent offset=-8", "tangent offset=0", "tangent offset=2^4", "tangent offset=2^12"):
                self.assertIn(name, done.stdout, command)
            page = (self.folder / command[0] / f"{command[0]}.html").read_text()
            self.assertIn("over the swept parameter", page, command)
            rows = list(csv.DictReader(io.StringIO((self.folder / command[0] / f"{command[0]}.csv").read_text())))
            self.assertTrue({"-8", "0", "16", "4096"} <= {value.removesuffix(".0") for row in rows for value in row.values() if value}, command)

    def test_an_address_makes_the_query_again_as_it_was_judged(self):
        done = axiscert("critical-radius", "--kernel", "published", "--family", "tangent", "--trials", 100, "--sweep", "offset=2^6", "--format", "json")
        (row,) = json.loads(done.stdout)["rows"]
        addresses = [row[worst]["address"] for worst in ("worst_early", "worst_late")]
        for address in addresses:
            self.assertIn(":tangent+offset=2^6:", address)
            moved = json.loads(axiscert("query", address).stdout)
            base = json.loads(axiscert("query", address.replace("+offset=2^6", "")).stdout)
            for point in "abcp":
                for x, y in zip(moved[point], base[point]):
                    self.assertEqual(number(x), float(numpy.float32(number(y) + 64)))
        self.refused("query", "1:tangent+ofset=2^6:2:binary32:0:1", says=["'ofset'", "offset"])

    def test_a_radius_that_is_doubled_ends_near_contact(self):
        found = precision("--kernel", "published", "--family", "tangent", "--trials", 200, "--bits", 8, "--sweep", "radius=1,2")
        one, two = (found["families"][f"tangent radius={value}"] for value in (1, 2))
        self.assertEqual((one["swept"], two["swept"]), (1, 2))
        self.assertGreater(wrong(one["kernels"]["published"]["precisions"][0]), wrong(two["kernels"]["published"]["precisions"][0]))

    def test_what_a_sweep_cannot_change_is_refused(self):
        self.refused("query", "1:box-box/general_minmax+radius=2:1:binary32:0:7", says=["have no radius", "box-box/general_minmax"])
        self.refused("query", "1:tangent+offset=2^200:2:binary32:0:7", says=["offset=2^200", "--precision binary64"])
        self.refused("ladder", "published", "--factorial", says=["--factorial", "published"])

    def test_bad_input(self):
        for given, says in (("ofset=1", "did you mean 'offset'"), ("offset=2^3..2^1", "empty"), ("offset=1..3", "2^A..2^B"),
                            ("offset=2^200", "binary32"), ("size=0", "above 0"), ("size", "PARAMETER=VALUES")):
            self.refused("precision", "--bits", 24, "--sweep", given, says=[says])


if __name__ == "__main__":
    unittest.main()
