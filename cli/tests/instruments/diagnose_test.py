#!/usr/bin/env python3
"""`axiscert diagnose`: the values for a reader, a program and a page; witnesses that can be asked again; bad input."""
import json
import re
import unittest

import jsonschema

from command import BUILD, Case, axiscert, schema_of

PROPERTIES = ["touching", "sides", "overlap_at_start", "degenerate_triangles", "absolute_threshold", "slack", "range_window", "subnormal_numbers", "operation_order",
              "inner_precision", "repeated", "position_in_batch", "batch_length", "neighbours", "regions", "on_triangle", "obtuse", "parallel", "flat", "aligned",
              "separation", "normal", "feature", "contact_point", "evaluation", "nearest_form"]


class Diagnose(Case):
    def diagnosed(self, *args):
        done = axiscert("diagnose", *args, "--format", "json")
        self.assertEqual(done.returncode, 0, done.stderr)
        data = json.loads(done.stdout)
        jsonschema.validate(data, schema_of("diagnosis"))
        self.assertEqual([p["name"] for p in data["properties"]], PROPERTIES)
        return data, {p["name"]: p["value"] for p in data["properties"]}

    def test_values_as_json_and_witnesses_that_are_answered_so_again(self):
        data, values = self.diagnosed("published", "--out", self.folder / "out")
        self.assertEqual(values["touching"], "closed")
        self.assertEqual(values["nearest_form"], "published")
        self.assertEqual(json.loads((self.folder / "out" / "diagnosis.json").read_text()), data)
        self.assertIn("touching", (self.folder / "out" / "diagnosis.html").read_text())
        witnesses = [w for p in data["properties"] for w in p["witnesses"]]
        file = self.folder / "out" / "witnesses.jsonl"
        self.assertEqual(len(file.read_text().splitlines()), len(witnesses))
        done = axiscert("check", file, "--kernel", "published", "--format", "jsonl")
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_text_has_each_property_with_its_sentence(self):
        done = axiscert("diagnose", "published+fma", "--progress", 0)
        self.assertEqual(done.returncode, 0, done.stderr)
        self.assertEqual(done.stderr, "")
        for name in PROPERTIES:
            self.assertRegex(done.stdout, rf"(?m)^{name}: \w")
        self.assertIn("operation_order: contracted. ", done.stdout)

    def test_a_plug_in_and_its_epsilon(self):
        data, values = self.diagnosed(f"plugin:{BUILD}/absolute/clamped_radius.so")
        self.assertEqual(values["absolute_threshold"], "present")
        compared = {p["name"]: p for p in data["properties"]}["absolute_threshold"]["measured"]["compared"]
        self.assertTrue(any(c["degree"] == 1 and 0.0025 <= c["least"] <= c["greatest"] <= 0.04 for c in compared), compared)

    def test_the_sentences_begin_with_the_number_of_its_own_which_is_named_once(self):
        done = axiscert("diagnose", f"plugin:{BUILD}/absolute/least_area.so", "--progress", 0)
        self.assertEqual(done.returncode, 0, done.stderr)
        sentences = [line for line in done.stdout.splitlines() if line.split(":")[0] in PROPERTIES]
        # Wrong verdicts by their class come first, then the number that explains them.
        wrong = [line for line in sentences if re.match(r"\w+: wrong\. ", line)]
        number = sentences[len(wrong)]
        self.assertEqual(sentences[:len(wrong)], wrong)
        self.assertTrue(number.startswith("absolute_threshold: present. "), number)
        self.assertRegex(number, r"What explains them best: \|AB x AC\| (near|between) [0-9.e-]+( and [0-9.e-]+)?\.")

    def test_a_kernel_without_errors_is_like_no_form(self):
        data, values = self.diagnosed("certified")
        self.assertEqual(values["nearest_form"], "not_known")
        measured = {p["name"]: p for p in data["properties"]}["nearest_form"]["measured"]
        self.assertEqual(measured["both_wrong"], 0)

    def test_the_precision_is_the_first_that_the_kernel_has(self):
        data, values = self.diagnosed("published+world-double")
        self.assertEqual(data["precision"], "binary64")
        self.assertEqual(values["inner_precision"], "narrower")

    def test_another_test(self):
        data, values = self.diagnosed("box-triangle/textbook-minmax")
        self.assertEqual(data["predicate"], "box-triangle")
        self.assertEqual(values["sides"], "both")
        self.assertEqual(values["operation_order"], "not_asked")
        self.assertEqual(values["repeated"], "same")

    def test_bad_input_is_refused_in_one_line(self):
        self.refused("diagnose", says=["KERNEL"])
        self.refused("diagnose", "publishd", says=["publishd", "published"])
        self.refused("diagnose", "published", "--precision", "binary16", says=["binary16", "binary64"])
        self.refused("diagnose", "published+in-double", "--precision", "binary64", says=["binary64", "published+in-double"])
        self.refused("diagnose", "published", "--seed", "-1", says=["--seed", "-1"])
        self.refused("diagnose", f"plugin:{BUILD}/declarations/wrong_abi.so", says=["wrong_abi"])


if __name__ == "__main__":
    unittest.main()
