#!/usr/bin/env python3
"""The queries of moving-sphere that are kept: each has the exact answers that `axiscert check` gives."""
import json
import re
import unittest

from command import ROOT, Case, axiscert

CORPUS = ROOT / "fuzz/corpus"
MOTIONS = CORPUS / "moving-sphere.jsonl"


class Motions(Case):
    ENTRIES = [json.loads(line) for line in MOTIONS.read_text().splitlines()]

    def test_each_has_the_exact_answers_that_check_gives(self):
        done = axiscert("check", MOTIONS, "--kernel", "moving-sphere/twenty-nonstrict", "--format", "jsonl")
        self.assertEqual(done.returncode, 0, done.stderr)
        found = [json.loads(line) for line in done.stdout.splitlines()]
        self.assertEqual([line["id"] for line in found], [entry["id"] for entry in self.ENTRIES])
        for entry, said in zip(self.ENTRIES, found):
            with self.subTest(entry["id"]):
                self.assertEqual({member: said["exact"][member] for member in entry["expected"]}, entry["expected"])
                self.assertEqual(set(entry["expected"]), {"verdict", "touching", "time", "features", "start"})

    def test_each_is_of_the_test_and_says_where_it_came_from_and_why_it_is_hard(self):
        self.assertGreaterEqual(len(self.ENTRIES), 15)
        for entry in self.ENTRIES:
            with self.subTest(entry["id"]):
                self.assertEqual(entry["predicate"], "moving-sphere")
                self.assertTrue(entry["provenance"]["where"] and entry["note"])
                kind = entry["provenance"]["kind"]
                self.assertEqual(entry["provenance"].get("about"), "sweep" if kind == "report" else None)

    def test_no_two_have_one_name(self):
        names = [json.loads(line)["id"] for file in CORPUS.glob("*.jsonl") for line in file.read_text().splitlines()]
        self.assertEqual(len(names), len(set(names)))

    def test_the_names_in_the_tests_of_peers_are_here(self):
        text = (ROOT / "kernel/peers/moving_sphere/sweep_faults_test.cpp").read_text()
        named = re.findall(r"(?:bullet|fcl|ode|wildmagic)-[a-z-]+(?=[,:\n])", "\n".join(re.findall(r"^// (.*)$", text, re.MULTILINE)) + "\n")
        self.assertTrue(named)
        self.assertLessEqual(set(named), {entry["id"] for entry in self.ENTRIES})


if __name__ == "__main__":
    unittest.main()
