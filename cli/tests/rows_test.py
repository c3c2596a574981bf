#!/usr/bin/env python3
"""Rows of `check`: one for each query of a range and each kernel, which agree with `check` of one query and with the counts of `run`."""
import csv
import io
import json
import re
import unittest
from fractions import Fraction

import jsonschema

from command import MODELS, Case, axiscert, family, schema_of

# A range of each predicate and entry, with kernels that are wrong in it.
RANGES = {
    "1:repeated:2:binary32:0:0-149": ("published", "eigen"),
    "1:nonfinite:{}:binary64:0:20-59": ("published",),
    "3:moving-sphere/approach:{}:binary32:0:0-99": ("moving-sphere/gated", "moving-sphere/twenty"),
    "1:moving-sphere/ends_general:{}:binary32:0:0-39": ("moving-sphere/ends-twenty",),
    "1:box-box/resting:{}:binary32:0:0-149": ("box-box/textbook",),
    "1:box-triangle/touching:{}:binary32:0:0-149": ("box-triangle/textbook",),
}


def cell(value):
    """A value of JSON as CSV has it, except for numbers."""
    if value is None:
        return ""
    if isinstance(value, bool):
        return str(value).lower()
    return " ".join(map(str, value)) if isinstance(value, list) else value


def nearest_features(row):
    """Of a triangle to a point: among the feet in all parts' insides, those at the least distance."""
    a, b, c, p = ([Fraction(float.fromhex(number)) for number in row[name]] for name in "abcp")

    def minus(v, w):
        return [x - y for x, y in zip(v, w)]

    def dot(v, w):
        return sum(x * y for x, y in zip(v, w))

    squares = {}
    for name, vertex in (("vertex_a", a), ("vertex_b", b), ("vertex_c", c)):
        squares[name] = dot(minus(p, vertex), minus(p, vertex))
    for name, start, end in (("edge_ab", a, b), ("edge_bc", b, c), ("edge_ca", c, a)):
        edge, v = minus(end, start), minus(p, start)
        if 0 < dot(v, edge) < dot(edge, edge):
            squares[name] = dot(v, v) - dot(v, edge) ** 2 / dot(edge, edge)
    u, w, v = minus(b, a), minus(c, a), minus(p, a)
    determinant = dot(u, u) * dot(w, w) - dot(u, w) ** 2
    if determinant:
        s = (dot(w, w) * dot(v, u) - dot(u, w) * dot(v, w)) / determinant
        t = (dot(u, u) * dot(v, w) - dot(u, w) * dot(v, u)) / determinant
        if s > 0 and t > 0 and s + t < 1:
            foot = [x + s * y + t * z for x, y, z in zip(a, u, w)]
            squares["face"] = dot(minus(p, foot), minus(p, foot))
    return [name for name, square in squares.items() if square == min(squares.values())]


class Rows(Case):
    @classmethod
    def setUpClass(cls):
        cls.versions = {}
        for predicate in ("sphere-triangle", "moving-sphere", "box-box", "box-triangle"):
            listed = json.loads(axiscert("families", "--predicate", predicate, "--format", "json").stdout)["families"]
            cls.versions.update({entry["name"]: entry["version"] for entry in listed})

    def ranges(self):
        for text, kernels in RANGES.items():
            yield text.format(self.versions[text.split(":")[1]]), kernels

    def rows(self, text, kernels, form, *more):
        done = axiscert("check", text, *(part for kernel in kernels for part in ("--kernel", kernel)), "--format", form, *more)
        self.assertEqual(done.returncode, 0, done.stderr)
        if form == "jsonl":
            return [json.loads(line) for line in done.stdout.splitlines()], done
        return list(csv.DictReader(io.StringIO(done.stdout, newline=""), strict=True)), done

    def test_a_row_says_what_check_says_of_the_query(self):
        for text, kernels in self.ranges():
            head, (first, last) = text.rsplit(":", 1)[0], map(int, text.rsplit(":", 1)[1].split("-"))
            addresses = [f"{head}:{index}" for index in range(first, last + 1)]
            rows, _ = self.rows(text, kernels, "jsonl")
            self.assertEqual([(row["address"], row["kernel"]) for row in rows], [(address, kernel) for address in addresses for kernel in kernels])
            seed, name, _, precision, *_ = text.split(":")
            made = axiscert("generate", "--family", name, "--seed", seed, "--precision", precision, "--trials", last + 1).stdout
            queries = "".join(made.splitlines(True)[first:])
            self.assertEqual([json.loads(line)["id"] for line in queries.splitlines()], addresses)
            for kernel in kernels:
                lines = [json.loads(line) for line in axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=queries).stdout.splitlines()]
                for line, row in zip(lines, (row for row in rows if row["kernel"] == kernel), strict=True):
                    with self.subTest(row["address"]):
                        self.same(line, row)
            self.assertTrue(any(row["wrong"] for row in rows) or "nonfinite" in text or "ends" in text, text)

    def same(self, line, row):
        exact = dict(line["exact"])
        for other in ("reason", "squared_distance", "facts", "axes", "ties"):  # of `check` alone
            exact.pop(other, None)
        mine = dict(row["exact"])
        depth, input_class = mine.pop("depth"), mine.pop("class", None)
        if "features" not in exact:
            mine.pop("features", None)  # of rows alone
        self.assertEqual(mine, exact)
        self.assertEqual((row["standing"], row["kernel"]), (line["standing"], line["kernel"]))
        self.assertEqual(row["computed"], {name: line["computed"][name] for name in ("verdict", "comparisons")})
        self.assertEqual(row.get("measures"), line["computed"].get("measures"))
        flips = [flip for flip in line["flips"] if flip["level"] == "verdict"]
        self.assertEqual((row["wrong"], row["links"]), (bool(flips), flips[0]["links"] if flips else []))
        self.assertEqual(row["findings"], [finding["kind"] for finding in line["findings"]])
        self.assertEqual(depth is None, exact["verdict"] == "invalid")
        if exact["touching"]:
            self.assertEqual(depth, 0)
        self.assertLessEqual(input_class is None, "predicate" in line or exact["verdict"] == "invalid")

    def test_features_are_those_that_are_nearest(self):
        for text in ("1:general:2:binary32:0:0-49", "1:repeated:2:binary64:0:0-49", "1:collinear:2:binary32:0:0-49"):
            rows, _ = self.rows(text, ("published",), "jsonl")
            for row in rows:
                if row["exact"]["verdict"] != "invalid":
                    self.assertEqual(row["exact"]["features"], nearest_features(row), row["address"])
            self.assertGreater(len({feature for row in rows for feature in row["exact"].get("features", [])}), 3)

    def test_numbers_are_those_of_the_query(self):
        for text, kernels in self.ranges():
            (row, *_), _ = self.rows(text, kernels, "jsonl")
            line = json.loads(axiscert("query", row["address"]).stdout)
            groups = [name for name in row if name not in schema_of("row")["properties"]]
            self.assertTrue(groups)
            for group in groups:
                here = line
                for part in group.split("."):
                    here = here[int(part)] if isinstance(here, list) else here[part]
                self.assertEqual(row[group], here, group)

    def test_csv_has_the_figures_of_the_json(self):
        for text, kernels in self.ranges():
            lines, told = self.rows(text, kernels, "jsonl")
            rows, told_of_csv = self.rows(text, kernels, "csv")
            self.assertEqual(len(rows), len(lines))
            for done in (told, told_of_csv):
                # How many and about how many bytes, before the first.
                count, size = map(int, re.match(r"axiscert: (\d+) rows?, about (\d+) bytes\n", done.stderr).groups())
                self.assertEqual(count, len(lines))
                self.assertLess(len(done.stdout) / 1.5, size)
                self.assertLess(size, len(done.stdout) * 1.5)
            for line, row in zip(lines, rows, strict=True):
                self.assertLessEqual({f"exact.{member}" for member in line["exact"]}, set(row))
                for column, value in row.items():
                    self.assertNotIn(column, ("schema", "axiscert", "revision"))
                    found = line
                    parts = column.split(".")
                    if column in line:  # the numbers of a group
                        found = line[column]
                    else:
                        for part in parts:
                            found = found.get(part) if isinstance(found, dict) else None
                    if isinstance(found, (int, float)) and not isinstance(found, bool):
                        self.assertEqual(float(value), found, column)
                    else:
                        self.assertEqual(value, cell(found), column)

    def test_lines_conform_to_their_schema(self):
        validator = jsonschema.Draft202012Validator(schema_of("row"))
        for text, kernels in self.ranges():
            for row in self.rows(text, kernels, "jsonl")[0]:
                self.assertEqual([error.message[:200] for error in validator.iter_errors(row)], [])

    def test_wrong_rows_are_those_that_a_run_counts(self):
        # Counts of the same first queries of the first unit.
        for name, kernel, precision in (("tangent", "published", "binary32"), ("orders", "certified", "binary64"),
                                        ("moving-sphere/approach", "moving-sphere/gated", "binary32"),
                                        ("box-box/resting", "box-box/textbook", "binary32"),
                                        ("box-triangle/touching", "box-triangle/textbook", "binary32")):
            trials = 300
            record = self.run_ok("--kernel", kernel, "--family", name, "--trials", trials, "--precision", precision, out=name.replace("/", "-"))
            counted = family(record, name, precision, kernel)
            rows, _ = self.rows(f"1:{name}:{self.versions[name]}:{precision}:0:0-{trials - 1}", (kernel,), "csv")
            decided = [row for row in rows if row["standing"] == "decided"]
            wrong = [row["computed.verdict"] for row in decided if row["wrong"] == "true"]
            self.assertEqual((wrong.count("separated"), wrong.count("contact")),
                             tuple(counted["verdict"][kind] or 0 for kind in ("false_separation", "false_contact")), name)
            truths = [row["exact.verdict"] for row in rows]
            self.assertEqual([truths.count(truth) for truth in ("separated", "contact", "invalid")],
                             [counted["truth"][truth] for truth in ("separated", "contact", "invalid")], name)
            deepest = max((float(row["exact.depth"]) for row in decided if row["wrong"] == "true"), default=0)
            self.assertEqual(deepest, counted["verdict"]["deepest"] or 0, name)
            for link, count in counted["verdict"]["links"].items():
                self.assertEqual(sum(link in row["links"].split() for row in decided), count, (name, link))

    def test_the_kernel_is_that_of_check_where_none_is_given(self):
        rows, _ = self.rows("1:general:2:binary32:3:65535-65535", (), "csv")
        self.assertEqual([(row["address"], row["kernel"]) for row in rows], [("1:general:2:binary32:3:65535", "published")])
        self.assertEqual(self.rows("1:general:2:binary32:3:65535", (), "csv")[0], rows)

    def test_a_file_has_rows_too(self):
        queries = self.folder / "mine.jsonl"
        queries.write_text("".join(axiscert("query", f"1:repeated:2:binary32:0:{i}").stdout for i in range(20)))
        out = self.folder / "out"
        self.run_ok("--queries", queries, "--kernel", "published")
        sha = next(entry["sha256"] for entry in json.loads((out / "record.json").read_text())["plan"]["files"] if entry["kind"] == "queries")
        rows, _ = self.rows(f"1:queries-{sha}:1:binary32:0:0-19", ("published",), "jsonl", "--queries", queries)
        there, _ = self.rows("1:repeated:2:binary32:0:0-19", ("published",), "jsonl")
        for mine, other in zip(rows, there, strict=True):
            self.assertEqual({**mine, "address": ""}, {**other, "address": ""})
        self.refused("check", f"1:queries-{sha}:1:binary32:0:0-20", "--queries", queries, "--format", "csv", says=["20 queries"])

    def test_what_cannot_be_is_refused(self):
        rows = ("--format", "csv")
        for text, says in {
            "1:general:2:binary32:0:9-3": ["FIRST 9 is greater than LAST 3", "1:general:2:binary32:0:3-9"],
            "1:general:2:binary32:0:0-65536": ["65536", "at most 65535"],
            "1:general:2:binary32:0:70000-70001": ["70000", "at most 65535"],
            "1:general:2:binary32:0:3-": ["FIRST-LAST", "index ''"],
            "1:general:2:binary32:0:-3": ["FIRST-LAST", "index ''"],
            "1:general:2:binary32:0:1-2-3": ["FIRST-LAST", "'2-3'"],
            "1:general:2:binary32:0-9": ["FIRST-LAST", "5 fields"],
            "1:genral:2:binary32:0:0-9": ["unknown family 'genral'", "general"],
            "1:general:99:binary32:0:0-9": ["version 2", "99"],
            "1:general:2:binary33:0:0-9": ["binary33", "binary64"],
            "1:mesh-00:1:binary32:0:0-9": ["--mesh FILE"],
        }.items():
            with self.subTest(text):
                done = self.refused("check", text, *rows, says=says)
                self.assertEqual(done.stdout, "")
        good = "1:general:2:binary32:0:0-9"
        self.refused("check", good, says=["--format csv or jsonl"])
        self.refused("check", good, *rows, "--kernel", "nosuch", says=["unknown kernel 'nosuch'"])
        self.refused("check", good, *rows, "--kernel", "box-box/textbook", says=["sphere-triangle", "box-box", "its own predicate"])
        self.refused("check", good, *rows, "--errors", says=["--errors"])
        self.refused("check", MODELS / "none.jsonl", *rows, says=["--format csv", "FIRST-LAST"])
        self.refused("check", "-", "--kernel", "published", "--kernel", "eigen", stdin="", says=["--kernel", "one kernel"])


if __name__ == "__main__":
    unittest.main()
