#!/usr/bin/env python3
"""The programs in docs/upstream print what is said there, and every known fault has its text. Where the engines are not installed nothing
is checked: exit code 77.

upstream_test.py [unittest arguments]
"""
import re
import subprocess
import unittest

import asking

UPSTREAM = asking.FOLDER.parents[2] / "docs/upstream"
README = (UPSTREAM / "README.md").read_text()
TEXTS = {file.relative_to(UPSTREAM).as_posix(): file.read_text() for file in sorted(UPSTREAM.glob("*-*.md"))}
PROGRAM = re.compile(r"\n```js\n(.*?)\n```\n\nIt prints\n\n```\n(.*?)\n```\n", re.DOTALL)


class Texts(unittest.TestCase):
    def test_each_fault_is_the_subject_of_one_text(self):
        faults = asking.faults() + asking.contact_faults()
        subjects = [(predicate, text) for text in TEXTS.values()
                    for predicate in re.findall("`([a-z-]+)`", re.search(r"; (?:tests?|shader) (.*)\.\n", text)[1])]
        self.assertEqual(sorted(predicate for predicate, _ in subjects), sorted(line["id"] for line in faults))
        for line in faults:
            version = f"{line['engine']['package']} {line['engine']['version']}"
            self.assertIn(version, dict(subjects)[line["id"]], line["id"])

    def test_the_list_has_each_text(self):
        self.assertEqual(sorted(re.findall(r"\]\(([a-z]+-[a-z-]+\.md)\)", README)), sorted(TEXTS))


class Programs(unittest.TestCase):
    def test_each_prints_what_is_said(self):
        for name, text in TEXTS.items():
            program, printed = PROGRAM.search(text).groups()
            if "from 'webgpu'" in program:
                continue  # kernel/gpu/languages_test.py runs it
            with self.subTest(name):
                done = subprocess.run(["node", "--input-type=module"], cwd=asking.FOLDER, input=program, capture_output=True, text=True,
                                      timeout=asking.SECONDS)
                self.assertEqual(done.returncode, 0, done.stderr[-2000:])
                # Havok prints a warning of its own in brackets and above.
                lines = [line for line in done.stdout.splitlines() if line and not line.startswith((" [", "Info:"))]
                self.assertEqual(lines, printed.splitlines())


if __name__ == "__main__":
    asking.main()
