#!/usr/bin/env python3
"""First contacts of motions in a run's folder: exact in its witnesses, and held by compare and by a ratchet."""
import json
import math
import re
import shutil
import subprocess
import unittest

from command import SCHEMAS, VALIDATE, Case, axiscert

PLAN = ["--predicate", "moving-sphere", "--family", "moving-sphere/general", "--family", "moving-sphere/approach", "--kernel",
        "moving-sphere/gated", "--precision", "binary32", "--trials", "100"]


def numbers(words):
    return [float.fromhex(word) for word in words]


class FirstContacts(Case):
    def edited(self, record, change, name="edited"):
        """A folder with the record of `out`, changed."""
        folder = self.folder / name
        shutil.copytree(self.folder / "out", folder)
        copy = json.loads(json.dumps(record))
        change(copy["kernels"][0])
        (folder / "record.json").write_text(json.dumps(copy))
        return folder

    def test_a_witness_has_the_exact_first_contact(self):
        record = self.run_ok(*PLAN)
        seen = 0
        for witness in record["witnesses"]:
            exact = witness["exact_contact"]
            if witness["truth"] != "contact":
                self.assertEqual((exact["time"], exact["features"], exact["start"]), (None, None, "clear"))
                continue
            with self.subTest(witness["id"]):
                a, p, d = (numbers(witness[name]) for name in "apd")
                r, time = float.fromhex(witness["r"]), float.fromhex(exact["time"])
                # Each is rounded once, to one part in 2^53 of what it is made of; so is what is computed here.
                size = max(map(abs, [*a, *p, *d, r]))
                for k in range(3):
                    self.assertAlmostEqual(exact["point"][k] - a[k], exact["point_from_a"][k], delta=1e-14 * size)
                    if exact["start"] != "overlap":
                        centre = p[k] + time * d[k] + exact["after_time"] * d[k]
                        self.assertAlmostEqual(exact["point"][k] + r * exact["normal"][k], centre, delta=1e-14 * size)
                if exact["normal"] is not None:
                    self.assertAlmostEqual(math.hypot(*exact["normal"]), 1, delta=1e-15)
                if len(exact["features"]) == 1 and exact["features"][0] == "vertex_a":
                    self.assertEqual(exact["point"], a)
                    self.assertEqual(exact["point_from_a"], [0, 0, 0])
                self.assertGreaterEqual(exact["after_time"], 0)
                self.assertLess(exact["after_time"], 2.0 ** -23 * max(time, 2.0 ** -126))
                seen += 1
        self.assertGreater(seen, 5)

    def test_one_late_time_more_is_worse(self):
        record = self.run_ok(*PLAN)
        general = record["kernels"][0]["families"]["moving-sphere/general"]["contacts"]["time"]
        self.assertGreater(general["late"], 0)

        def later(kernel):
            time = kernel["families"]["moving-sphere/general"]["contacts"]["time"]
            time["late"], time["best"] = time["late"] + 1, time["best"] - 1
            powers = time["late_errors"]["by_power"]
            powers[min(powers)] += 1

        worse = self.edited(record, later)
        same = axiscert("compare", self.folder / "out", self.folder / "out")
        self.assertEqual((same.returncode, "no change" in same.stdout), (0, True), same.stdout)
        for before, after, code, says in ((self.folder / "out", worse, 1, "worse: 1 worse"), (worse, self.folder / "out", 0, "better: 1 better")):
            done = axiscert("compare", before, after)
            self.assertEqual(done.returncode, code, done.stdout + done.stderr)
            self.assertIn(says, done.stdout)
            self.assertIn("time.late", done.stdout)
        done = axiscert("compare", self.folder / "out", worse, "--out", self.folder / "compared")
        self.assertEqual(done.returncode, 1)
        checked = subprocess.run(["/usr/bin/python3", VALIDATE, SCHEMAS / "comparison.schema.json",
                                  self.folder / "compared/compare.json"], capture_output=True, text=True)
        self.assertEqual(checked.stderr, "")

    def test_a_run_without_times_is_not_no_change(self):
        record = self.run_ok(*PLAN)

        def silent(kernel):
            kernel["measures"] = []
            for family in kernel["families"].values():
                for name in ("time", "feature", "normal", "point"):
                    family["contacts"][name] = None

        without = self.edited(record, silent)
        done = axiscert("compare", self.folder / "out", without)
        self.assertEqual(done.returncode, 1, done.stdout)
        self.assertIn("NOT COMPARED: moving-sphere/gated binary32: 'time' of contacts: it gives that in OLD and not in NEW", done.stdout)
        done = axiscert("compare", without, self.folder / "out")
        self.assertEqual(done.returncode, 0, done.stdout)
        self.assertIn("only in NEW: moving-sphere/gated binary32: 'time' of contacts", done.stdout)

    def test_a_policy_that_leaves_more_out_is_worse(self):
        """It was "61 fixed": motions that the kernel is wrong about are beyond its policies now."""
        record = self.run_ok(*PLAN)

        def ignores_starts(kernel):
            kernel["motion"]["start"] = "ignored"
            for family in kernel["families"].values():
                time = family["contacts"]["time"]
                time["late"], time["best"] = 0, time["late"] + time["best"]
                time["late_errors"] = dict.fromkeys(("largest_ulps", "largest_in_u", "largest_share", "largest_length"), 0) | {"by_power": {}}
                time["late_tunnels"] = {"through": 0, "deepest_tunnel": 0}
                family["verdict"]["outside_limits"] = dict.fromkeys(
                    ("trials", "decided_contacts", "decided_separations", "decided", "false_separation", "false_contact", "unanswered", "contact",
                     "touching", "deepest"), 0)

        less = self.edited(record, ignores_starts)
        done = axiscert("compare", self.folder / "out", less)
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("worse: moving-sphere/gated binary32 promises less: start ignored, was reported; NOT COMPARED", done.stdout)
        self.assertNotIn("fixed:", done.stdout)
        accepted = self.folder / "ratchet.txt"
        accepted.write_text((less / "ratchet.txt").read_text().replace("EXPIRY OWNER REASON", "never mk why"))
        self.assertIn(" start=reported still=reported sides=both time=", accepted.read_text())
        # A file that promises more than this kernel: the words of a policy are read again.
        accepted.write_text(accepted.read_text().replace("start=reported", "start=approaching"))
        done = axiscert("run", *PLAN, "--ratchet", accepted, "--out", self.folder / "held")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("promises other things than the ratchet: start reported, was approaching", done.stderr)

    def test_a_ratchet_holds_late_times(self):
        self.run_ok(*PLAN)
        text = (self.folder / "out/ratchet.txt").read_text()
        self.assertIn("\ntime late=", text)
        accepted = self.folder / "ratchet.txt"
        text = text.replace("EXPIRY OWNER REASON\n", 'never mk "rounds to nearest"\n')
        accepted.write_text(text)
        self.run_ok(*PLAN, "--ratchet", accepted, out="held")
        late = int(re.search(r"\ntime late=([0-9]+)", text)[1])
        less = text.replace(f"\ntime late={late}", f"\ntime late={late - 1}", 1)
        accepted.write_text(less)
        done = axiscert("run", *PLAN, "--ratchet", accepted, "--out", self.folder / "worse")
        self.assertEqual(done.returncode, 1, done.stdout + done.stderr)
        self.assertIn("time.late: ", done.stdout + done.stderr)


if __name__ == "__main__":
    unittest.main()
