#!/usr/bin/env python3
"""Words that were replaced are nowhere but in CHANGELOG.md: a question of geometry was a test, and is a predicate; the plug-in interface and the pipe
had several versions at once, and have one.

    former_words_test.py ROOT
"""
import re
import subprocess
import sys
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve() if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
# What each was, and a line with it.
FORMER = {
    r"(?<![\w-])--test(?![\w-])": "axiscert run --test moving-sphere",
    r"\baxiscert tests\b": "`axiscert tests` lists them",
    r"\\?\"test\\?\"\s*:|(?<![\w.\"'])'test'\s*:": '{"test": "box-box", "precision": "binary32"}',
    r"\b(?:TestDescription|TestEntry|find_test|first_test)\b": "const TestDescription& test = find_test(name);",
    r"\baxiscert-tests\b": '"schema": "axiscert-tests/1"',
    r"\binterface[_ ]1\b": '#include "kernel/plugin/interface_1.h"',
    r"\b(?:first_version|general_version|WideReplyRecord)\b": "std::vector<pipe::WideReplyRecord> wide_replies;",
}
MORE_LINES = ["run --test=box-box", r'"{\"test\":\"box-box\"}"', "[--test ID]", "fmt::format(R\"({\"test\" : 1})\")", "interface 1 of plug-ins", "{'test': 1}"]
NOT_THESE = ["ctest --test-dir build/release", "./dev test --long", '"tests": 3', "axiscert-predicates/2", "interface 12", "/x/.test(text)", "find_tests_of(kernel)",
             '<testsuite name="ratchet" tests="1">']
EXEMPT = {"CHANGELOG.md", "docs/checks/former_words_test.py"}


def places(files):
    """[FILE:LINE: line] of what any pattern finds."""
    pattern = re.compile("|".join(FORMER))
    return [f"{name}:{number}: {line.strip()[:160]}" for name, text in files.items() if name not in EXEMPT and pattern.search(text)
            for number, line in enumerate(text.split("\n"), 1) if pattern.search(line)]


def tracked():
    """Path and text of every tracked file; where there is no git, as in an archive, of all but what .gitignore names."""
    listed = subprocess.run(["git", "-C", ROOT, "ls-files", "-z"], capture_output=True, text=True)
    names = [name for name in listed.stdout.split("\0") if name] if listed.returncode == 0 else \
        [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*") if path.is_file()]
    left_out = re.compile(r"^(build|out|\.git)/|node_modules/|__pycache__/")
    return {name: (ROOT / name).read_text(errors="replace") for name in names if not left_out.search(name) and (ROOT / name).is_file()}


class FormerWords(unittest.TestCase):
    def test_none_is_left(self):
        files = tracked()
        self.assertGreater(len(files), 1000)
        told = places(files)
        self.assertFalse(told, "\n" + "\n".join(told))

    def test_the_names_of_files_have_none(self):
        self.assertEqual([name for name in tracked() if places({"x": Path(name).name})], [])

    def test_what_is_planted_is_seen(self):
        for pattern, line in FORMER.items():
            self.assertRegex(line, pattern)
        for line in [*FORMER.values(), *MORE_LINES]:
            for file in ("docs/moving.md", "kernel/plugin/load.cpp", "fuzz/corpus/box-box.jsonl"):
                self.assertEqual(places({file: "first\n" + line}), [f"{file}:2: {line}"])
        self.assertEqual(places({"CHANGELOG.md": "`axiscert tests`"}), [])

    def test_what_is_another_word_is_not(self):
        for line in NOT_THESE:
            self.assertEqual(places({"x.md": line}), [], line)


if __name__ == "__main__":
    unittest.main()
