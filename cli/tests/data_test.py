#!/usr/bin/env python3
"""The data that instruments print for other programs: JSON that its schema describes, and CSV whose columns a schema or docs/data.md does."""
import csv
import fnmatch
import functools
import io
import json
import os
import re
import subprocess
import unittest

import jsonschema

from command import BUILD, QUERY, ROOT, Case, axiscert, schema_of

# By the command in docs/data.md: the schema, and a command with few queries.
MUTATE = ("mutate", "--family", "general", "--trials", 64, "--no-controls", "--precision", "binary32", "--mutant")
COMMANDS = {
    "ladder": ("ladder", ("ladder", "--trials", 16, "--kernel", "ladder-7", "--kernel", "ladder-8", "--kernel", "published", "--kernel", "ladder-8+fma", "--family", "tangent")),
    "precision": ("precision", ("precision", "--trials", 40, "--kernel", "published", "--kernel", "ladder-0", "--bits", 24, "--bits", 12, "--family", "tangent")),
    "condition": ("condition", ("condition", "--trials", 200, "--kernel", "published", "--family", "tangent", "--family", "ratio")),
    "critical-radius": ("critical-radius", ("critical-radius", "--trials", 40, "--kernel", "published", "--kernel", "ladder-0+prescaled", "--family", "scale")),
    "league": ("league", ("league", "--kernel", "published", "--kernel", "fault/none", "--trials", 300, "--family", "tangent", "--no-speed")),
    "search": ("search", ("search", "--kernel", "published", "--evaluations", 100000)),
    "diagnose": ("diagnosis", ("diagnose", "published+ftz")),
    "map": ("maps", ("map", "-", "--size", 8)),
    "mutate": ("mutation", (*MUTATE, "swap")),
    "mutate --verdict-only": ("mutation-by-verdict", (*MUTATE, "drop", "--verdict-only")),
    "mutate --kernel certified": ("mutation-of-certified", ("mutate", "--kernel", "certified", "--trials", 200, "--precision", "binary32")),
    "kernels": ("kernels", ("kernels",)),
    "families": ("families", ("families",)),
    "predicates": ("predicates", ("predicates",)),
}
# The number of each format, which docs/checks/formats_test.py holds.
PAGE = (ROOT / "docs/data.md").read_text()
NUMBERS = {name: int(number) for name, number in re.findall(r"^\| `([a-z-]+)` \| (\d+) \|", PAGE, re.M)}
# Commands that print a line of JSON for each query, by its schema, with their standard input.
MOTION = ('{"id":"m","predicate":"moving-sphere","precision":"binary32","a":[0,0,0],"b":[1,0,0],"c":[0,1,0],"p":[0,0,5],"d":[0,0,-3],"r":1}\n')
LINES = {
    "check": ((("check", "-", "--kernel", "published", "--errors"), QUERY % 1), (("check", "-", "--kernel", "published"), QUERY % -1),
              (("check", "-", "--kernel", "closest-point"), QUERY % 2), (("check", "-", "--kernel", "moving-sphere/twenty"), MOTION)),
    "row": ((("check", "1:repeated:2:binary32:0:0-40", "--kernel", "published", "--kernel", "eigen"), None),
            (("check", "1:nonfinite:2:binary64:0:0-40"), None), (("check", "1:moving-sphere/approach:1:binary32:0:0-40", "--kernel", "moving-sphere/gated"), None)),
    "shrink": ((("shrink", "1:repeated:2:binary64:0:143", "--kernel", "published"), None),
               (("shrink", "1:repeated:2:binary64:0:143", "--kernel", "published", "--any-class"), None),
               (("shrink", "1:orders:1:binary32:0:2", "--kernel", "published", "--what", "asymmetry"), None)),
    "corpus": ((("corpus", "list"), None),),
}
# Which of these write a folder.
WRITTEN = {"ladder", "precision", "condition", "critical-radius", "league", "search", "diagnose", "mutate", "mutate --verdict-only",
           "mutate --kernel certified"}


def documented():
    """The columns that docs/data.md describes itself, as patterns, by the command."""
    rows = re.findall(r"^\| `([a-z][a-z -]*)` \| `([a-z-]+)` \| [^|]+ \| ([^|]*)\|$", PAGE, re.M)
    return {heading: (schema, re.findall(r"`([^`]+)`", columns)) for heading, schema, columns in rows}


def described(schema):
    """The names of all members that have a description."""
    names = set()
    if isinstance(schema, dict):
        names |= {name for name, member in schema.get("properties", {}).items() if "description" in member}
    for part in schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ():
        names |= described(part)
    return names


def unexplained(heading, head):
    """The columns that neither the command's schema nor the page describes."""
    schema, patterns = documented()[heading]
    names = described(schema_of(schema))
    return [column for column in head if column.split(".")[-1] not in names and not any(fnmatch.fnmatch(column, pattern) for pattern in patterns)]


@functools.cache
def validator_of(name):
    schema = schema_of(name)
    validator = jsonschema.validators.validator_for(schema)
    validator.check_schema(schema)
    return validator(schema)


class Data(Case):
    printed = {}  # by heading and format: each command runs once for each

    def text(self, heading, form):
        if (heading, form) not in self.printed:
            folder = ("--out", self.folder / "out") if heading == "map" else ()
            done = axiscert(*COMMANDS[heading][1], "--format", form, *folder, stdin=QUERY % 1 if heading == "map" else None)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.printed[heading, form] = done.stdout
        return self.printed[heading, form]

    def json(self, heading):
        return json.loads(self.text(heading, "json"))

    def csv(self, heading):
        rows = list(csv.reader(io.StringIO(self.text(heading, "csv")), strict=True))
        self.assertEqual({len(row) for row in rows}, {len(rows[0])}, heading)
        self.assertGreater(len(rows), 1, heading)
        return rows[0], [dict(zip(rows[0], row)) for row in rows[1:]]

    def test_json_says_its_schema_and_conforms_to_it(self):
        version, revision = re.fullmatch(r"axiscert ([\d.]+) \(revision (\w+(?:-dirty)?)\)\n", axiscert("--version").stdout).groups()
        for heading, (name, _) in COMMANDS.items():
            with self.subTest(heading):
                data = self.json(heading)
                self.assertEqual(list(data)[:3], ["schema", "axiscert", "revision"])
                self.assertEqual((data["schema"], data["axiscert"], data["revision"]), (f"axiscert-{name}/{NUMBERS[name]}", version, revision))
                self.assertEqual([error.message[:200] for error in validator_of(name).iter_errors(data)], [])

    def test_the_schemas_are_not_blind(self):
        for heading, (name, _) in COMMANDS.items():
            data = self.json(heading)
            for wrong in ({**data, "schema": f"axiscert-{name}/{NUMBERS[name] - 1}"}, {**data, "other": 1}, {k: v for k, v in data.items() if k != "revision"}):
                self.assertTrue(list(validator_of(name).iter_errors(wrong)), name)

    def test_each_schema_is_of_something_that_is_written(self):
        others = {"record", "run", "ratchet", "comparison", "proofs", "certificate", *LINES}
        made = axiscert("explain", "--schema", "none").stderr.split("schemas: ")[1].strip().split(", ")
        self.assertEqual({*made}, others | {name for name, _ in COMMANDS.values()})

    def test_a_line_of_json_conforms_to_its_schema(self):
        for name, commands in LINES.items():
            for command, stdin in commands:
                done = axiscert(*command, "--format", "jsonl", stdin=stdin)
                self.assertEqual(done.returncode, 0, done.stderr)
                lines = [json.loads(line) for line in done.stdout.splitlines()]
                self.assertGreater(len(lines), 0)
                for line in lines:
                    self.assertEqual([error.message[:200] for error in validator_of(name).iter_errors(line)], [], command)
                if name == "corpus":
                    continue
                self.assertEqual(list(lines[0])[:3], ["schema", "axiscert", "revision"])
                wrong = {**lines[0], "schema": f"axiscert-{name}/{NUMBERS[name] - 1}"}, {k: v for k, v in lines[0].items() if k != "kernel"}
                self.assertTrue(all(list(validator_of(name).iter_errors(line)) for line in wrong), name)

    def test_every_column_of_csv_is_described(self):
        self.assertEqual({heading: schema for heading, (schema, _) in documented().items()},
                         {**{heading: name for heading, (name, _) in COMMANDS.items()}, "prove": "proofs", "run": "record"})
        for heading in COMMANDS:
            head = self.csv(heading)[0]
            self.assertEqual(unexplained(heading, head), [], heading)
            self.assertEqual(unexplained(heading, [*head, "caught.whither"]), ["caught.whither"])

    def test_every_column_of_a_record_is_explained(self):
        done = axiscert("run", "--kernel", "published", "--family", "general", "--trials", 40, "--out", self.folder / "out", "--format", "csv")
        (head, *_) = csv.reader(io.StringIO(done.stdout), strict=True)
        named = documented()["run"][1]
        self.assertEqual(head[:len(named)], named)
        # Every figure of one place, and one figure of every place: a name is a place and a figure.
        figures, places = {}, {}
        for column in head[len(named):]:
            place, _, figure = column.rpartition(".")
            figures.setdefault(figure, column)
            places.setdefault(place, column)
        self.assertLess(len({*figures.values(), *places.values()}), len(head))
        for column in sorted({*figures.values(), *places.values()}):
            said = axiscert("explain", column)
            self.assertEqual(said.returncode, 0, column + said.stderr)
        self.assertIn("Missed contacts: the kernel says separated", axiscert("explain", "verdict.false_separation").stdout)
        self.refused("explain", "verdict.false_separatoin", says=["verdict.false_separatoin"])

    def test_every_column_is_filled_somewhere(self):
        # Columns that need more than these few queries to have a value.
        rare = {"swept", "rounding_seed", "caught_after", "ns", "overflow.exponent", "underflow.exponent", "unanswered", "left_out", "reason", "source", "equivalent", "touching_flips", "undefined", "not_decided"}
        for heading in ("ladder", "precision", "condition", "critical-radius", "league", "search", "diagnose", "map", "kernels", "families", "predicates"):
            head, rows = self.csv(heading)
            empty = {name for name in head if not any(row[name] for row in rows)}
            self.assertLessEqual(empty, rare, heading)

    def test_csv_has_the_figures_of_the_json(self):
        for kernel in self.json("ladder")["kernels"]:
            rows = {(row["family"], row["level"], row["name"]): row for row in self.csv("ladder")[1] if row["kernel"] == kernel["id"]}
            self.assertEqual(int(rows["tangent", "verdict", "verdict"]["false_contact"]), kernel["families"]["tangent"]["verdict"]["false_contact"])
            self.assertEqual(float(rows["tangent", "rate", "missed"]["high"]), kernel["families"]["tangent"]["rates"]["missed"]["high"])
            self.assertEqual(int(rows["tangent", "comparison", "edge_ab.side_c"]["missed_separation"]),
                             kernel["families"]["tangent"]["comparisons"]["edge_ab.side_c"]["missed_separation"])
            self.assertEqual([int(rows["", "axis", "plane"][f"window.{end}"]) for end in ("low", "high")], kernel["windows"]["axes"]["plane"])
        steps = [row for row in self.csv("ladder")[1] if row["level"] in ("step", "pair", "effect")]
        self.assertEqual([(row["level"], row["from"], row["kernel"], row["name"]) for row in steps],
                         [(row["kind"], row["from"], row["to"], row["figure"]) for row in self.json("ladder")["differences"]])
        self.assertEqual([float(row["holm_p"]) for row in steps], [row["holm_p"] for row in self.json("ladder")["differences"]])
        for name, kernel in self.json("precision")["all"]["kernels"].items():
            rows = [row for row in self.csv("precision")[1] if (row["kernel"], row["family"]) == (name, "")]
            self.assertEqual([(row["bits"], row["exponents"]) for row in rows],
                             [("", ""), ("12", "unlimited"), ("12", "limited"), ("24", "unlimited"), ("24", "limited")])
            self.assertEqual(int(rows[1]["plane.radius"]), kernel["precisions"][0]["unlimited"]["comparisons"]["plane.radius"])
            self.assertEqual(int(rows[0]["false_contact"]), kernel["exact"]["false_contact"])
        for data in self.json("condition")["rows"]:
            rows = [row for row in self.csv("condition")[1] if row["family"] == data["family"]]
            self.assertEqual(sum(int(row["flips"]) for row in rows if row["comparison"]), data["total"]["flips"])
        for data in self.json("league")["kernels"]:
            (row,) = [row for row in self.csv("league")[1] if (row["kernel"], row["precision"]) == (data["id"], data["precision"])]
            self.assertEqual(float(row["deepest_false_contact"]), data["families"]["tangent"]["deepest_false_contact"])
            self.assertEqual((row["decided"], row["may_decline"]), (str(data["families"]["tangent"]["decided"]), "false"))
        comparisons = {row["name"]: row for row in self.csv("search")[1] if row["level"] == "comparison"}
        for data in self.json("search")["comparisons"]:
            self.assertEqual(float(comparisons[data["name"]]["attained_u"]), data["attained_u"])
            self.assertEqual(int(comparisons[data["name"]]["decided"]), self.json("search")["looked_at_by_goal"]["error " + data["name"]]["decided"])
        for data, row in zip(self.json("diagnose")["properties"], self.csv("diagnose")[1], strict=True):
            self.assertEqual([row[name] for name in ("name", "value", "sentence")], [data[name] for name in ("name", "value", "sentence")])
            self.assertEqual((int(row["queries"]), int(row["witnesses"])), (data["queries"], len(data["witnesses"])))
            self.assertEqual([row[f"witness.{name}"] for name in ("answered", "truth", "shows")],
                             [data["witnesses"][0][name] if data["witnesses"] else "" for name in ("answered", "truth", "shows")])
        pictures = self.json("map")["maps"][0]["pictures"]
        self.assertEqual([int(row["tie"]) for row in self.csv("map")[1]], [picture["counts"]["tie"] for picture in pictures])
        for heading in ("mutate", "mutate --verdict-only"):
            self.assertEqual([row["id"] for row in self.csv(heading)[1]], [mutant["id"] for mutant in self.json(heading)["mutants"]])
        # Summaries have commas and quotes in them.
        for heading, text in (("kernels", "summary"), ("families", "purpose"), ("predicates", "asks")):
            self.assertEqual([row[text] for row in self.csv(heading)[1]], [one[text] for one in self.json(heading)[heading]])
        self.assertIn('"', self.text("kernels", "csv"))

    def test_the_folder_has_both(self):
        for heading in sorted(WRITTEN):
            name, command = COMMANDS[heading]
            done = axiscert(*command, "--out", self.folder / name)
            self.assertEqual(done.returncode, 0, done.stderr)
            data = json.loads((self.folder / name / f"{name}.json").read_text())
            head = (self.folder / name / f"{name}.csv").read_text().split("\n")[0]
            self.assertEqual((data["schema"], head), (f"axiscert-{name}/{NUMBERS[name]}", ",".join(self.csv(heading)[0])))

    def test_bounds_are_rows_too(self):
        bare = {**os.environ, "PATH": "/nonexistent"}  # without a checker, nothing is checked and all is listed
        done = {form: subprocess.run([BUILD / "axiscert", "prove", "--format", form], capture_output=True, text=True, env=bare)
                for form in ("json", "csv")}
        data, rows = json.loads(done["json"].stdout), list(csv.reader(io.StringIO(done["csv"].stdout)))
        self.assertEqual(unexplained("prove", rows[0]), [])
        self.assertEqual([row[7] for row in rows[1:]], [bound["status"] for bound in data["bounds"]])
        self.assertEqual([error.message for error in validator_of("proofs").iter_errors(data)], [])

    def test_another_format_is_told_which_there_are(self):
        self.refused("ladder", "--format", "cvs", says=["--format", "csv"])
        self.refused("kernels", "--format", "xml", says=["--format", "text", "json", "csv"])


if __name__ == "__main__":
    unittest.main()
