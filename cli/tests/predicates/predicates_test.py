#!/usr/bin/env python3
"""Every command over every predicate, and what it says of verdicts beside the rationals of exact_predicates.py.

TABLE states for each predicate what each command does. A predicate or a command without a place in it fails, and so does a command that
serves a predicate and has no comparison in predicate_case.py. Each comparison is repeated with one truth turned round, and has to see that.
"""
import json
import unittest

from command import Case, axiscert
from exact_predicates import PREDICATES
from predicate_case import PLANS, PredicateCase
from predicate_queries import turned_round

# In order: sphere-triangle, moving-sphere, box-box, box-triangle, capsule-triangle, point-box (the suite's own, fuzz/testing/point_box).
# x: works; -: is refused, in one line that names the predicate and the command; .: asks about no predicate.
TABLE = {
    "run":             "x x x x x x", "certify":   "x x x x x x", "verify":   "x x x x x x", "check":      "x x x x x x",
    "report":          "x x x x x x", "diagnose":  "x x x x x x", "shrink":   "x x x x x x", "search":     "x x x x x x",
    "map":             "x x x x x x", "generate":  "x x x x x x", "judge":    "x x x x x x", "league":     "x - - - - -",
    "kernels":         "x x x x x x", "predicates": "x x x x x x", "compare":  "x x x x x x", "corpus":     "x x x x x x",
    "plan":            "x x x x x x", "merge":     "x x x x x x", "ladder":   "x - - - - -", "precision":  "x - - - - -",
    "condition":       "x - - - - -", "mutate":    "x x - - - -", "prove":    ". . . . . .", "explain":    ". . . . . .",
    "critical-radius": "x x x - - -", "families":  "x x x x x x", "query":    "x x x x x x", "completion": ". . . . . .",
}
# These repeat queries, names or files, and say nothing of a verdict.
SILENT = {"generate", "kernels", "predicates", "families", "query", "plan", "verify"}
# Search and critical radii serve the other entries of a predicate too, but this one, whose numbers depend on each other: a
# kernel of each, a family in which it is wrong, and two numbers that a map changes.
ENTRIES = {
    "moving-sphere": {"endpoints": None},
    "box-box": {"quaternion": ("box-box/textbook-turned", "box-box/crossed_turned", ("b.m.x", "b.s.x")),
                "minmax": ("box-box/textbook-minmax", "box-box/touching_minmax", ("a.min.x", "b.max.x")),
                "minmax-quaternion": ("box-box/textbook-mixed", "box-box/tangent_mixed", ("a.max.x", "b.s.x"))},
    "box-triangle": {"minmax": ("box-triangle/textbook-minmax", "box-triangle/touching_minmax", ("box.min.x", "a.x")),
                     "matrix": ("box-triangle/textbook-oriented", "box-triangle/touching_oriented", ("box.b.1.x", "c.z")),
                     "quaternion": ("box-triangle/textbook-turned", "box-triangle/touching_turned", ("box.m.x", "c.z"))},
}


class EveryCommand:
    def compare(self, all_told):
        for told in all_told:
            truths = [query.truth() for query in told.queries]
            self.assertEqual(told.expected(truths), told.shown, told.what)
            if any(verdict != "invalid" for verdict, _ in truths):
                self.assertNotEqual(told.expected(turned_round(truths)), told.shown, f"{told.what}: a wrong truth is not seen")

    def test_every_command(self):
        for command, marks in TABLE.items():
            mark = dict(zip(PLANS, marks.split(), strict=True))[self.predicate]
            with self.subTest(command=command):
                if mark == "-":
                    self.ask_refused(command)
                if mark != "x":
                    continue
                all_told = list(getattr(self, "ask_" + command.replace("-", "_"))())
                self.assertEqual(bool(all_told), command not in SILENT, "commands that say something of verdicts are compared")
                self.compare(all_told)

    def test_every_other_entry(self):
        self.assertEqual([entry["name"] for entry in self.description["entries"][1:]], list(ENTRIES.get(self.predicate, {})))
        for (entry, served), kernel in zip(ENTRIES.get(self.predicate, {}).items(), self.plan.kernels[1:], strict=True):
            with self.subTest(entry=entry):
                if served:
                    kernel, family, axes = served
                    finds = list(self.ask_search(kernel, family))
                    (query, *_) = finds[0].queries
                    self.assertEqual(query.entry["name"], entry)
                    self.compare([*finds, *self.ask_shrink(kernel, query), *self.ask_map(kernel, query, axes)])
                    continue
                line = json.dumps(self.queries(self.families_of(kernel)[0][:1], 1)[0].line)
                for command in ("search", "critical-radius"):
                    self.ask_refused(command, "--kernel", kernel, lacks=f"the entry {entry} of ", stdin=line)


class SphereTriangleCommands(EveryCommand, PredicateCase):
    predicate = "sphere-triangle"


class MovingSphereCommands(EveryCommand, PredicateCase):
    predicate = "moving-sphere"


class BoxBoxCommands(EveryCommand, PredicateCase):
    predicate = "box-box"


class BoxTriangleCommands(EveryCommand, PredicateCase):
    predicate = "box-triangle"


class CapsuleTriangleCommands(EveryCommand, PredicateCase):
    predicate = "capsule-triangle"


class PointBoxCommands(EveryCommand, PredicateCase):
    predicate = "point-box"


class CommandTable(Case):
    def test_it_has_every_predicate_and_every_command(self):
        for program in ("axiscert", "axiscert_toy"):
            listed = [one["id"] for one in json.loads(axiscert("predicates", "--format", "json", program=program).stdout)["predicates"]]
            self.assertEqual(listed, [one for one, plan in PLANS.items() if program == "axiscert_toy" or plan.program == program])
            shown = axiscert("--help", program=program).stdout
            commands = {line.split()[0] for line in shown.splitlines() if line.startswith("  ") and line[2].isalpha()}
            self.assertEqual(commands, set(TABLE))
        self.assertEqual(set(PLANS), set(PREDICATES))
        self.assertEqual({case.predicate for case in PredicateCase.__subclasses__()}, set(PLANS))
        for command, marks in TABLE.items():
            self.assertEqual(len(marks.split()), len(PLANS), command)
            self.assertEqual(hasattr(PredicateCase, "ask_" + command.replace("-", "_")), "x" in marks, command)

    def test_what_asks_about_no_predicate_takes_none(self):
        for command, marks in TABLE.items():
            if "." in marks:
                shown = axiscert(command, "--help").stdout
                self.assertIn("Usage", shown)
                self.assertNotRegex(shown, "--(predicate|kernel|family)\\b", command)


if __name__ == "__main__":
    unittest.main()
