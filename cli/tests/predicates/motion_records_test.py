#!/usr/bin/env python3
"""The record of motions is the same bytes however it was made: by threads, instruction sets, and parts of a plan."""
import json
import unittest

from command import MODELS, Case, axiscert, fewer

# A kernel in lanes, a kernel of times, one beside arithmetic of its own; contacts, points and a mesh.
MOTIONS = ["--predicate", "moving-sphere", "--kernel", "moving-sphere/twenty", "--kernel", "moving-sphere/rounded", "--kernel",
           "moving-sphere/gated", "--kernel", "moving-sphere/twenty+fma", "--family", "moving-sphere/general", "--family",
           "moving-sphere/graze", "--family", "moving-sphere/point", "--family", "moving-sphere/split", "--mesh",
           MODELS / "OBJ/spider.obj", "--trials", fewer(60)]


class MotionRecords(Case):
    made = None

    def ok(self, *args):
        done = axiscert(*args)
        self.assertEqual(done.returncode, 0, done.stdout + done.stderr)

    def record(self, *args, out, command=("run",)):
        self.ok(*command, *args, "--out", self.folder / out)
        return (self.folder / out / "record.json").read_bytes()

    def whole(self):
        """The record of one thread, made once."""
        if self.made is None:
            type(self).made = self.record(*MOTIONS, "--threads", 1, out="one")
        return self.made

    def test_are_the_same_by_threads_and_instruction_sets(self):
        reference = self.whole()
        times = json.loads(reference)["kernels"][2]["families"]["moving-sphere/graze"]["contacts"]["time"]
        self.assertGreater(times["late"] + times["early"], 0, "times are in it")
        self.assertEqual(self.record(*MOTIONS, "--threads", 3, out="three"), reference)
        targets = json.loads(axiscert("kernels", "--format", "json").stdout)["kernels"][0]["targets"]
        self.assertIn("scalar", targets)
        for target in targets:
            self.assertEqual(self.record(*MOTIONS, "--target", target, out=target), reference, target)

    def test_are_the_same_in_parts_that_are_merged(self):
        plan = self.folder / "plan.json"
        self.ok("plan", *MOTIONS, "--units-per-stretch", 1, "-o", plan)
        for part in ("2/3", "1/3", "3/3"):
            self.ok("run", "--plan", plan, "--shard", part, "--out", self.folder / part[0])
        merged = self.record(*(self.folder / part for part in "132"), out="merged", command=("merge",))
        self.assertEqual(merged, self.whole())
        self.assertEqual(merged, self.record("--plan", plan, "--threads", 2, out="at-once"))

    def test_another_seed_is_another_record(self):
        self.assertNotEqual(self.record(*MOTIONS, "--seed", 2, out="other"), self.whole())


if __name__ == "__main__":
    unittest.main()
