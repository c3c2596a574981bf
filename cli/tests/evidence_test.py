#!/usr/bin/env python3
"""Met means looked at: kinds of kernels that decline, call valid queries invalid, answer nothing or promise little, and what each level and
each command has to say of them. The kernels are those of kernel/plugin and kernel/plugin/misbehaving."""
import json
import re
import unittest
import xml.etree.ElementTree as xml

from command import BUILD, Case, axiscert

TRIALS = 1024
FAMILIES = ["lattice", "general", "orders", "units", "far"]
LEVELS = ["exact", "depth=1", "conservative=1", "logic", "range", "invariant=order", "invariant=scale", "decided=0.5",
          "no-worse-than=keeps_its_promise"]
PLAN = [part for family in FAMILIES for part in ("--family", family)] + ["--trials", str(TRIALS), "--precision", "binary32"]


def promise(kind):
    return f"plugin:{BUILD}/promises/{kind}.so"


def misbehaving(kind):
    return f"plugin:{BUILD}/misbehaving/{kind}.so"


YARDSTICK = promise("keeps_its_promise")
# The state of each level, in the order of LEVELS, and words that its sentence has; "!" stands for met, "-" for not met, "?" for not checked.
# Exact and range are not asked of a kernel that is right but for ties: "." is either.
KINDS = {
    promise("declines"): ("---------", "does not declare may_decline"),
    promise("declines_declared"): (".!...!!!!", " declined"),
    promise("declines_contacts"): (".??..??-?", "it declines"),
    promise("declines_separations"): (".??..??-?", "it declines"),
    promise("one_size"): (".??..??-?", "it declines"),
    promise("answers_invalid"): ("---------", "answers `invalid` to valid queries"),
    promise("answers_77"): ("---------", "without an answer"),
    promise("limited_to_nothing"): ("?????????", "every valid query is outside the limits"),
    promise("limited_to_far"): (".!.????!?", "within its limits: 1 of 5 families"),
    misbehaving("crash"): ("---------", "crash"),
    misbehaving("hang"): ("---------", "hang"),
}


class Levels(Case):
    """Each kind at each level: state, exit code, how much was looked at."""

    def test_what_each_level_says_of_each_kind(self):
        kernels = [part for kernel in (*KINDS, YARDSTICK) for part in ("--kernel", kernel)]
        levels = [part for level in LEVELS for part in ("--require", level.replace("keeps_its_promise", YARDSTICK))]
        done = axiscert("run", *kernels, *PLAN, *levels, "--plugin-seconds", "0.1", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 1, done.stderr)
        outcomes = json.loads((self.folder / "out/run.json").read_text())["requirements"]
        for kernel, (states, words) in KINDS.items():
            found = [one for one in outcomes if one["kernel"] == kernel]
            told = "".join({"met": "!", "not met": "-", "NOT CHECKED": "?"}[one["state"]] for one in found)
            fitting = "".join(state if wanted == "." else wanted for state, wanted in zip(told, states))
            with self.subTest(kernel=kernel):
                self.assertEqual(len(told), len(LEVELS))
                self.assertEqual(told, fitting, "\n".join(one["text"] for one in found))
                said = [one["text"] for one in found] + [failure["what"] for one in found for failure in one["failures"]]
                self.assertTrue(any(words in text for text in said), said)
                for one in found:
                    if one["level"].startswith(("exact", "depth", "conservative")):
                        self.assertRegex(one["text"], r"[\d,]+ of [\d,]+ promised queries looked at")
                    if one["state"] == "met":
                        self.assertGreaterEqual(one["looked_at"], 59)

    def test_the_control_meets_what_it_should(self):
        done = axiscert("run", "--kernel", YARDSTICK, *PLAN, "--require", "depth=1", "--require", "invariant=scale", "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertIn("depth=1: 5,120 of 5,120 promised queries looked at: met", done.stdout)

    def test_a_precision_in_which_it_is_not(self):
        done = axiscert("run", "--kernel", promise("binary64_alone"), *PLAN, "--require", "depth=1", "--out", self.folder / "out")
        self.assertNotEqual(done.returncode, 0, done.stdout)
        self.assertIn("binary32", done.stderr)

    def test_formats_for_ci_say_how_much_was_looked_at(self):
        axiscert("run", "--kernel", promise("limited_to_far"), "--kernel", promise("declines_contacts"), *PLAN, "--require", "depth=1",
                 "--out", self.folder / "out")
        markdown = (self.folder / "out/report.md").read_text()
        self.assertIn("within its limits: 1 of 5 families", markdown)
        self.assertRegex(markdown, r"of [\d,]+ promised queries looked at, [\d,]+ declined")
        cases = [case.get("name") for case in xml.parse(self.folder / "out/junit.xml").getroot().iter("testcase")
                 if case.find("failure") is not None]
        self.assertIn("requirement depth=1", cases)
        results = json.loads((self.folder / "out/report.sarif").read_text())["runs"][0]["results"]
        self.assertTrue(any("it declines" in result["message"]["text"] for result in results))


class WithoutALevel(Case):
    """No answers at all, or none that count: exit 1, and the first line says it."""

    def test_a_kernel_that_decided_nothing(self):
        for kernel, words in {promise("answers_77"): "without an answer", promise("limited_to_nothing"): "outside the limits"}.items():
            done = axiscert("run", "--kernel", kernel, *PLAN, "--out", self.folder / "out")
            with self.subTest(kernel=kernel):
                self.assertEqual(done.returncode, 1, done.stdout)
                for stream in (done.stdout, done.stderr):
                    first = stream.splitlines()[0]
                    self.assertTrue("NOT JUDGED" in first or "it answers none of 251 queries" in first, first)
                    self.assertIn("NOT JUDGED", stream)
                    self.assertIn(words, stream)
                for file in ("report.md", "junit.xml", "report.sarif"):
                    self.assertIn("NOT JUDGED", (self.folder / "out" / file).read_text(), file)

    def test_undecided_invalid_and_unanswered_stand_beside_missed_and_phantom(self):
        done = axiscert("run", "--kernel", promise("declines_declared"), *PLAN, "--out", self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stderr)
        head = next(line for line in done.stdout.splitlines() if "missed contacts" in line)
        self.assertRegex(head, r"missed contacts +deepest +phantom contacts +deepest +undecided +invalid +no answer")


class NotMeasured(Case):
    def test_errors_of_a_kernel_without_sides_are_null(self):
        record = self.run_ok("--kernel", "fault/none", "--kernel", "published", "--family", "general", "--trials", "64", "--tolerance", "8")
        for kernel in record["kernels"]:
            tally = kernel["families"]["general"]["comparisons"]["plane.radius"]
            shows = "sides" in kernel["exposes"]
            for member in ("max_error_u", "smallest_passing_tolerance", "tolerance_failures", "range_events", "error_without_scale"):
                self.assertEqual(tally[member] is not None, shows, f"{kernel['id']} {member}")
        self.assertIn("not measured", (self.folder / "out/report.md").read_text())


if __name__ == "__main__":
    unittest.main(verbosity=2)
