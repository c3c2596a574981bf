#!/usr/bin/env python3
"""`axiscert explain`, and the words that the other commands use."""
import re
import unittest

from command import ROOT, Case, axiscert

HEADINGS = re.findall(r"^## (.*)$", (ROOT / "docs/glossary.md").read_text(), re.MULTILINE)


class Explain(Case):
    def explained(self, *words):
        done = axiscert("explain", *words)
        self.assertEqual(done.returncode, 0, done.stderr)
        return done.stdout

    def test_the_list_is_the_page_and_no_word_stands_twice(self):
        self.assertEqual(self.explained().splitlines(), HEADINGS)
        words = [word for heading in HEADINGS for word in heading.split(", ")]
        self.assertEqual(len(words), len(set(words)))

    def test_each_word_is_found_in_any_form(self):
        self.assertTrue(self.explained("depth").startswith("depth: How far a wrong verdict is from being right"))
        for form in (["missed", "contacts"], ["Missed contact"], ["false-separation"], ["false_separation"]):
            self.assertTrue(self.explained(*form).startswith("missed contact, false_separation: "), form)

    def test_what_the_terminal_prints_is_explained(self):
        """The heads of the table of a run, the links and the outcomes of levels."""
        printed = axiscert("run", "--kernel", "published", "--family", "lattice", "--trials", 1000, "--precision", "binary32",
                           "--out", self.folder / "out").stdout
        for word in ("kernel", "missed contacts", "phantom contacts"):
            self.assertIn(word, printed)
            self.explained(word)
        for word in ("query", "specification", "rounding", "range", "implementation", "unattributed", "level", "not checked"):
            self.explained(word)

    def test_an_unknown_word_is_told_its_neighbours(self):
        self.refused("explain", "dept", says=["unknown word 'dept'", "did you mean 'depth'?"])


if __name__ == "__main__":
    unittest.main()
