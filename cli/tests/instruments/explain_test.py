#!/usr/bin/env python3
"""`axiscert explain`, and the words that the other commands use."""
import re
import unittest

import jsonschema

from command import ROOT, Case, axiscert, schema_of

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
            self.assertTrue(self.explained(*form).startswith("missed contact, false_separation"), form)

    def test_what_the_terminal_prints_is_explained(self):
        """The heads of the table of a run, the links and the outcomes of levels."""
        printed = axiscert("run", "--kernel", "published", "--family", "lattice", "--trials", 1000, "--precision", "binary32",
                           "--out", self.folder / "out").stdout
        for word in ("kernel", "missed contacts", "phantom contacts"):
            self.assertIn(word, printed)
            self.explained(word)
        for word in ("query", "specification", "rounding", "range", "implementation", "unattributed", "level", "not checked"):
            self.explained(word)

    def test_a_figure_of_the_record_has_its_sentence_and_unit(self):
        said = self.explained("max_error_u")
        self.assertTrue(said.startswith("kernels.families.axes.max_error_u, kernels.families.comparisons.max_error_u (u): The largest "), said)
        self.assertIn("kernels.families.base_triangles: Number of different triangles", self.explained("base-triangles"))

    def test_the_schema_of_a_record_says_the_same(self):
        schema = schema_of("record")
        jsonschema.validators.validator_for(schema).check_schema(schema)
        self.assertEqual(schema["properties"]["schema"], {"const": "axiscert-record/8", "description": schema["properties"]["schema"]["description"]})
        self.refused("explain", "--schema", "recrd", says=["--schema", "record"])

    def test_an_unknown_word_is_told_its_neighbours(self):
        self.refused("explain", "dept", says=["unknown word 'dept'", "did you mean 'depth'?"])


if __name__ == "__main__":
    unittest.main()
