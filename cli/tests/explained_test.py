#!/usr/bin/env python3
"""`axiscert explain` knows the words that commands print: headings of tables, levels, findings, properties, classes, causes and the words of every schema."""
import json
import re
import unittest
from concurrent.futures import ThreadPoolExecutor

from command import BUILD, Case, axiscert, schema_of

FAMILIES = ("--family", "repeated", "--family", "far", "--trials", 300, "--precision", "binary32")
# Commands whose tables are read, small.
TABLES = {
    "league": ("league", "published", "nonstrict", "--trials", 60, "--no-speed", "--no-engines"),
    "ladder": ("ladder", "published", "--trials", 60, "--no-speed"),
    "precision": ("precision", "published", "--bits", 24, "--family", "tangent", "--trials", 20),
    "condition": ("condition", "published", "--family", "tangent", "--trials", 50),
    "critical-radius": ("critical-radius", "published", "--family", "tangent", "--trials", 20),
    "mutate": ("mutate", "nonstrict", "--family", "lattice", "--trials", 30, "--no-controls"),
    "mutate by the verdict": ("mutate", "nonstrict", "--verdict-only", "--mutant", "sign", "--family", "lattice", "--trials", 30),
    "search": ("search", "published", "--evaluations", 500),
    "diagnose": ("diagnose", "published"),
}


def cells_of(line):
    return re.split(r" {2,}", line.strip()) if line.startswith("  ") else []


def headings(text):
    """The headings of the tables of a text: the first line of several columns after one that has not."""
    lines, found = text.split("\n"), []
    for before, line in zip(lines, lines[1:]):
        cells = cells_of(line)
        if len(cells) > 2 and (len(cells_of(before)) < 2 or cells[0] == "kernel"):
            found += cells
    return found


# Words of everyday language.
PLAIN = {"which", "how", "what was asked", "input is", "zero"}


def is_word(term):
    """No number, bin of one, or id of a file."""
    return term not in PLAIN and not re.match(r"[<>-]? ?[\d.]|plugin:|-$", term)


def enumerated(schema):
    """The words that a schema lists, in it and in those inside it."""
    if isinstance(schema, list):
        return {word for part in schema for word in enumerated(part)}
    if not isinstance(schema, dict):
        return set()
    own = {word for word in schema.get("enum", []) if isinstance(word, str)}
    return own.union(*(enumerated(part) for key, part in schema.items() if key not in ("enum", "required", "description")))


class Explained(Case):
    def unexplained(self, terms):
        def is_known(term):
            return axiscert("explain", *term.split(" ")).returncode == 0
        words = sorted({term for term in terms if is_word(term)})
        with ThreadPoolExecutor(4) as pool:
            return [word for word, known in zip(words, pool.map(is_known, words)) if not known]

    def test_the_headings_of_every_table(self):
        for name, command in TABLES.items():
            done = axiscert(*command)
            found = headings(done.stdout)
            self.assertGreater(len(found), 2, name + done.stdout + done.stderr)
            self.assertEqual(self.unexplained(found), [], name)

    def test_what_a_run_says(self):
        levels = ["logic", "exact", "range", "never-misses", "conservative", "depth=0.1", "decided=0.9", "invariant=order"]
        levels = [level for level in levels if level.split("=")[0] in axiscert("run", "--help").stdout]
        done = axiscert("run", "published", f"plugin:{BUILD}/misbehaving/crash.so", *FAMILIES, *[word for level in levels for word in ("--require", level)],
                        "--out", self.folder / "out")
        record = json.loads((self.folder / "out/record.json").read_text())
        terms = headings(done.stdout) + levels + ["met", "not met", "NOT CHECKED"]
        terms += re.findall(r"crash\.so binary32: (\w+) on family", done.stdout)
        for kernel in record["kernels"]:
            terms += [*kernel["families"], *(kernel["cause"] or {}).get("traits", [])]
        self.assertIn("vertex_b", terms)
        self.assertEqual(self.unexplained(terms), [])

    def test_what_a_diagnosis_says(self):
        for kernel in ("published", "minkowski"):
            properties = json.loads(axiscert("diagnose", kernel, "--format", "json").stdout)["properties"]
            self.assertEqual(self.unexplained([one[part] for one in properties for part in ("name", "value")]), [])

    def test_every_word_that_a_schema_lists(self):
        names = axiscert("explain", "--schema", "none").stderr.split("schemas: ")[1].strip().split(", ")
        words = set().union(*(enumerated(schema_of(name)) for name in names))
        self.assertGreater(len(words), 100)
        self.assertEqual(self.unexplained(words), [])

    def test_the_names_of_every_list(self):
        for predicate in json.loads(axiscert("predicates", "--format", "json").stdout)["predicates"]:
            parts = [one["name"] for kind in ("entries", "comparisons", "clauses", "measures", "wrong_answers") for one in predicate[kind]]
            some = predicate["kernels"][:3] + predicate["families"][:3] + parts[:9] + parts[-9:] + [predicate["id"]]
            self.assertEqual(self.unexplained(some), [])

    def test_a_word_without_an_entry_is_seen(self):
        self.assertEqual(self.unexplained(["depth", "dpeth of it", "0.1", "< 1e-8"]), ["dpeth of it"])
        self.assertEqual(headings("Title\n  kernel  new word  b, ulps\n  x  1  2\n"), ["kernel", "new word", "b, ulps"])

    def test_a_word_has_the_text_of_what_it_names(self):
        for word, says in (("tangent", "tangent, family: of sphere-triangle: "), ("logic", "logic, level: logic: "), ("touching", "touching, property: "),
                           ("certified", "certified, kernel: of sphere-triangle: "), ("plane.radius", "plane.radius, comparison: of sphere-triangle, of the axis plane"),
                           ("near_tie", "near_tie, class of the input: "), ("upward", "upward, way to call a kernel: ")):
            self.assertIn(says, axiscert("explain", word).stdout)


if __name__ == "__main__":
    unittest.main()
