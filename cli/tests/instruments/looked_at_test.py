#!/usr/bin/env python3
"""How much each instrument looked at: nothing wrong among no answers is no clean bill, whatever kind of kernel it is."""
import json
import unittest

import jsonschema

from command import BUILD, Case, axiscert, schema_of

CONTACT = {"id": "contact", "precision": "binary32", "a": [1, 0, 0], "b": [0, 1, 0], "c": [0, 0, 1], "p": [0, 0, 0], "r": 2}
APART = {**CONTACT, "id": "apart", "r": 0.5}
NO_QUERY = json.dumps({**CONTACT, "a": ["nan", 0, 0]}) + "\n"
BOTH = "".join(json.dumps(query) + "\n" for query in (CONTACT, APART))
QUICK = ("--plugin-seconds", "0.1")


def promise(name):
    return f"plugin:{BUILD}/promises/{name}.so"


# Kernels that decide nothing, with what the first line says of them.
SILENT = {
    promise("answers_77"): "without an answer",
    promise("limited_to_nothing"): "outside its limits",
}


class LookedAt(Case):
    def json(self, schema, *args, code=0, stdin=None):
        done = axiscert(*args, *QUICK, "--format", "json", stdin=stdin)
        self.assertEqual(done.returncode, code, f"{args}: {done.stdout[:300]}{done.stderr}")
        data = json.loads(done.stdout)
        jsonschema.validate(data, schema_of(schema))
        return data

    def text(self, *args, code=0, stdin=None):
        done = axiscert(*args, *QUICK, stdin=stdin)
        self.assertEqual(done.returncode, code, f"{args}: {done.stdout[:300]}{done.stderr}")
        return done.stdout

    def search(self, kernel, **options):
        return self.json("search", "search", "--kernel", kernel, "--family", "general", "--evaluations", 1, **options)

    def test_a_search_of_a_kernel_that_decides_nothing_says_so_first(self):
        for kernel, why in SILENT.items():
            shown = self.text("search", "--kernel", kernel, "--family", "general", "--evaluations", 1, code=1).splitlines()
            self.assertTrue(shown[0].startswith("Nothing was looked at: "), shown[0])
            self.assertIn(why, shown[0])
            self.assertIn("not looked at", "\n".join(shown))

    def test_a_search_counts_what_was_declined(self):
        declared = self.search(promise("declines_contacts"))
        self.assertTrue(declared["may_decline"])
        self.assertGreater(declared["looked_at"]["undecided"], 0)
        self.assertIsNone(declared["looked_at"]["first_fault"])
        searched = declared["looked_at_by_goal"]["phantom_contact"]
        self.assertIsNone(declared["verdict"]["phantom_contact"])
        self.assertEqual(searched["asked"], sum(searched[part] for part in searched if part not in ("asked", "first_fault")))
        shown = self.text("search", "--kernel", promise("declines_contacts"), "--family", "general", "--evaluations", 1)
        self.assertIn(" queries that it decided (", shown.splitlines()[0])
        self.assertRegex(shown, r"phantom_contact +none among [\d,]+ decided|phantom_contact +not looked at")
        self.assertNotIn("Fault:", shown)

    def test_a_search_reports_an_answer_that_no_kernel_may_give_with_its_first_query(self):
        for kernel, said in ((promise("declines"), "undecided"), (promise("answers_invalid"), "invalid")):
            looked_at = self.search(kernel)["looked_at"]
            self.assertGreater(looked_at[said], 0)
            self.assertEqual(looked_at["first_fault"]["said"], said)
            line = json.dumps(looked_at["first_fault"]["query"])
            answer = json.loads(axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=line).stdout)
            self.assertEqual(answer["computed"]["verdict"], said)
            shown = self.text("search", "--kernel", kernel, "--family", "general", "--evaluations", 1)
            self.assertRegex(shown, rf"(?m)^Fault: no verdict on [\d,]+ valid queries within its limits. The first, {said}: {{")

    def map(self, kernel, code):
        done = axiscert("map", "-", "--size", 16, "--kernel", kernel, *QUICK, "--out", self.folder, "--format", "json", stdin=json.dumps(CONTACT))
        self.assertEqual(done.returncode, code, done.stderr)
        data = json.loads(done.stdout)
        jsonschema.validate(data, schema_of("maps"))
        return data["maps"][0]["pictures"][0]

    def test_a_map_without_a_decided_pixel_says_so_first(self):
        for kernel, pixels in ((promise("answers_77"), "unanswered"), (promise("limited_to_nothing"), "outside_limits"),
                               (promise("declines_contacts"), "undecided")):
            picture = self.map(kernel, 1)
            self.assertEqual((picture["decided"], picture["counts"][pixels]), (0, 256), kernel)
            shown = self.text("map", "-", "--size", 16, "--kernel", kernel, "--out", self.folder, code=1, stdin=json.dumps(CONTACT))
            self.assertTrue(shown.startswith("Nothing was looked at in verdict: no pixel is decided. "), shown[:200])
        self.assertEqual(self.map(promise("keeps_its_promise"), 0)["decided"], 256)

    def test_a_diagnosis_knows_nothing_of_a_kernel_that_decides_nothing(self):
        for kernel, why in SILENT.items():
            data = self.json("diagnosis", "diagnose", kernel, code=1)
            self.assertEqual({p["value"] for p in data["properties"]} - {"not_known", "not_asked"}, set(), kernel)
            self.assertEqual(data["looked_at"]["decided"], 0)
            shown = self.text("diagnose", kernel, code=1).splitlines()[0]
            self.assertTrue(shown.startswith("Nothing was looked at. "), shown)
            self.assertIn(why, shown)

    def test_a_diagnosis_knows_little_of_a_kernel_that_decides_separations_alone(self):
        data = self.json("diagnosis", "diagnose", promise("declines_contacts"))
        values = {p["name"]: p["value"] for p in data["properties"]}
        self.assertEqual({values[name] for name in ("touching", "sides", "degenerate_triangles", "range_window", "inner_precision")}, {"not_known"})
        self.assertGreater(data["looked_at"]["undecided"], 0)

    LEAGUE = ("league", "--no-speed", "--trials", 256, "--precision", "binary32", "--family", "general", "--family", "far")

    def trust(self, kernel, code=0):
        data = self.json("league", *self.LEAGUE, "--kernel", kernel, code=code)["kernels"][0]
        return data, data["trust"]["far"]

    def test_a_league_trusts_nobody_who_was_not_looked_at(self):
        self.assertEqual(self.trust(promise("keeps_its_promise"))[1]["answer"], "yes")
        for name, answer, words in (("declines_contacts", "too few", " contacts decided; declines "), ("declines_separations", "too few", " separations decided; declines "),
                                    ("declines", "no", " and does not declare that it may"), ("answers_invalid", "no", "; calls "),
                                    ("always_contact", "no", " invented")):
            data, trust = self.trust(promise(name))
            self.assertEqual(trust["answer"], answer, f"{name}: {trust}")
            self.assertIn(words, trust["words"], name)
        for name, answer, words in (("answers_77", "no", "no answer to 256"), ("limited_to_nothing", "not looked at", "256 outside its limits")):
            data, trust = self.trust(promise(name), code=1)
            self.assertEqual(trust["answer"], answer, f"{name}: {trust}")
            self.assertIn(words, trust["words"])
            figures = data["families"]["far"]
            self.assertEqual(figures["decided"], 0)
            self.assertEqual([figures[name] for name in ("false_separation", "false_contact", "deepest_false_separation", "deepest_false_contact")], [None] * 4)
            shown = self.text(*self.LEAGUE, "--kernel", promise(name), code=1)
            self.assertTrue(shown.startswith("Nothing was looked at of plugin:"), shown[:100])
            self.assertIn("not measured", shown)

    def test_a_critical_radius_is_measured_only_where_every_radius_is_decided(self):
        for kernel, part in ((promise("declines_contacts"), "undecided"), (promise("answers_77"), "unanswered"), (promise("limited_to_nothing"), "outside_limits")):
            arguments = ("critical-radius", "--kernel", kernel, "--trials", 64, "--family", "general")
            total = self.json("critical-radius", *arguments, code=1)["totals"][0]
            self.assertEqual((total["measured"], total[part]), (0, 64), kernel)
            self.assertIsNone(total["right"])
            self.assertTrue(self.text(*arguments, code=1).startswith("Nothing was measured of "))

    def test_no_bits_suffice_in_a_format_that_has_no_query(self):
        big = json.dumps({"id": "big", "precision": "binary32", "a": [200000, 0, 0], "b": [200000, 0, 0], "c": [300000, 0, 0], "p": [0, 0, 0], "r": 100000})
        (self.folder / "big.jsonl").write_text(big + "\n")
        rounded = ("precision", "--kernel", "published", "--queries", self.folder / "big.jsonl", "--number", "fp8-e4m3", "--round-inputs")
        data = self.json("precision", *rounded, code=1)
        sufficient = data["sufficient"]["published"]
        self.assertEqual({sufficient["verdict"], sufficient["own_verdict"]} | {c["sufficient_bits"] for c in sufficient["comparisons"].values()}, {None})
        (step,) = data["all"]["kernels"]["published"]["precisions"]
        self.assertEqual((step["queries"], step["unlimited_rate"], step["limited_rate"]), (0, None, None))
        shown = self.text(*rounded, code=1)
        self.assertTrue(shown.startswith("Nothing was measured. "), shown[:100])
        self.assertIn("not measured", shown)
        self.assertNotIn("means less than", shown)
        both = self.json("precision", *rounded, "--number", "binary32")
        self.assertEqual(both["sufficient"]["published"]["own_verdict"], 24)

    def test_no_form_is_right_on_no_query(self):
        for command, rows in (("ladder", lambda data: [kernel["families"]["nonfinite"]["verdict"] for kernel in data["kernels"]]),
                              ("condition", lambda data: [row["wrong_verdicts"] for row in data["rows"]])):
            arguments = (command, "published", "--family", "nonfinite", "--trials", 1, *(("--no-speed",) if command == "ladder" else ()))
            self.assertEqual(rows(self.json(command, *arguments, code=1)), [None], command)
            shown = self.text(*arguments, code=1)
            self.assertTrue(shown.startswith("Nothing was measured. "), shown[:100])
            self.assertIn("not measured", shown)

    def test_a_check_says_of_each_query_what_became_of_it(self):
        for kernel, standings, is_silent in ((promise("keeps_its_promise"), ["decided", "decided"], False),
                                             (promise("declines_contacts"), ["declined", "decided"], False),
                                             (promise("answers_77"), ["unanswered", "unanswered"], True),
                                             (promise("limited_to_nothing"), ["outside_limits", "outside_limits"], True)):
            done = axiscert("check", "-", "--kernel", kernel, "--format", "jsonl", stdin=BOTH)
            self.assertEqual(done.returncode, 0, done.stderr)
            self.assertEqual([json.loads(line)["standing"] for line in done.stdout.splitlines()], standings, kernel)
            self.assertEqual("nothing was looked at: " in done.stderr, is_silent, done.stderr)
        done = axiscert("check", "-", "--kernel", "published", stdin=NO_QUERY)
        self.assertIn("nothing was looked at: published decided none of 1 queries (1 no_query)", done.stderr)
        shown = self.text("check", "-", "--kernel", promise("declines_contacts"), stdin=BOTH)
        self.assertIn("undecided (it declines)", shown)
        shown = self.text("check", "-", "--kernel", promise("answers_77"), stdin=BOTH)
        self.assertIn("gave no answer (a fault: the query is valid)", shown)

    def test_a_shrink_keeps_no_answer_that_is_no_verdict(self):
        for kernel, says in ((promise("declines_contacts"), "it declines to say"), (promise("answers_77"), "it gives no answer"),
                             (promise("limited_to_nothing"), "outside the limits that it declares")):
            for what in ((), ("--what", "verdict"), ("--what", "normal")):
                self.refused("shrink", "-", "--kernel", kernel, *what, stdin=json.dumps(CONTACT), says=["has no verdict to keep: ", says])
        self.refused("shrink", "-", "--kernel", promise("keeps_its_promise"), stdin=json.dumps(CONTACT), says=["is not wrong on it"])

    def test_a_precision_that_a_kernel_has_not_is_refused_by_every_instrument(self):
        alone = promise("binary64_alone")
        for command in (("search", "--kernel", alone), ("map", "-", "--kernel", alone), ("shrink", "-", "--kernel", alone), ("check", "-", "--kernel", alone),
                        ("diagnose", alone, "--precision", "binary32"), ("critical-radius", "--kernel", alone),
                        ("league", "--kernel", alone, "--no-speed", "--precision", "binary32")):
            self.refused(*command, stdin=json.dumps(CONTACT), says=["does not exist"])

    def test_instruments_of_formulae_say_what_a_plug_in_needs(self):
        for command, says in (("ladder", "declare `formulae`"), ("condition", "declare `formulae`"),
                              ("precision", "evaluates built-in formulae itself")):
            self.refused(command, "--kernel", promise("keeps_its_promise"), says=[says])


if __name__ == "__main__":
    unittest.main()
