#!/usr/bin/env python3
"""Answers are stored and replayed on the same machine; an answer that is changed in between is found, with its query.
Usage: replay_test.py BUILD_FOLDER MODELS_FOLDER TRIAL_DIVISOR"""
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

BUILD, MODELS, DIVISOR = Path(sys.argv.pop(1)), Path(sys.argv.pop(1)), int(sys.argv.pop(1))
ROOT = Path(__file__).resolve().parents[4]
SIZE = 20 // DIVISOR + 11
HEADER, COLUMNS = 64, 13 * 4 * SIZE  # sizes of the first section's header and columns, in bytes


class Replay(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        folder = tempfile.TemporaryDirectory()
        cls.addClassCleanup(folder.cleanup)
        cls.file = Path(folder.name) / "answers"
        subprocess.run([BUILD / "write_certified_answers", cls.file, str(SIZE), ROOT / "fuzz/corpus", MODELS / "OBJ/spider.obj"],
                       check=True, timeout=600)

    def replayed(self, code):
        done = subprocess.run([BUILD / "replay_answers", self.file], capture_output=True, text=True, timeout=600)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done.stdout

    def test_the_same_answers_on_every_instruction_set(self):
        lines = self.replayed(0).splitlines()
        self.assertGreaterEqual(len(lines), 2, lines)
        for line in lines:
            self.assertRegex(line, r"^\w+: \d{5,} answers, 0 wrong$")

    def test_another_answer_is_found(self):
        right = self.file.read_bytes()
        changed = bytearray(right)
        at = HEADER + COLUMNS + 3  # the order of distance and radius of query 3
        changed[at] = 1 if changed[at] != 1 else 255
        self.file.write_bytes(changed)
        self.assertRegex(self.replayed(1), r"pairs, general, binary32, question 0, mode 0, query 3: \d and not \d: -?0x")
        self.file.write_bytes(right)

    def test_a_file_that_is_cut_short_is_refused(self):
        right = self.file.read_bytes()
        for size in (0, HEADER, len(right) - 1):
            self.file.write_bytes(right[:size])
            self.assertIn("cut short", self.replayed(2))
        self.file.write_bytes(right)


if __name__ == "__main__":
    unittest.main()
