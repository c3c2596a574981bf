#!/usr/bin/env python3
"""`axiscert certify`: what a certificate says, that it is the same again, and what cannot be certified."""
import hashlib
import json
import shutil
import unittest

import jsonschema

from certificates import canonical, CertifyCase
from closest_point import UPWARDS, built
from command import BUILD, axiscert, schema_of


class Certify(CertifyCase):
    def test_a_certificate_is_of_its_schema_and_without_a_clock(self):
        cert = self.certificate_of("published")
        statement = json.loads(cert.read_text())
        schema = schema_of("certificate")
        jsonschema.validators.validator_for(schema)(schema).validate(statement)
        self.assertEqual(cert.read_bytes(), canonical(statement) + b"\n")
        self.assertIsNone(statement["predicate"]["signed_at"])
        digest = statement["predicate"].pop("digest")
        self.assertEqual(digest, hashlib.sha256(canonical(statement)).hexdigest())

    def test_it_says_what_published_is_and_leaves_nothing_out(self):
        cert = self.certificate_of("published")
        predicate = json.loads(cert.read_text())["predicate"]
        state = {(level["level"], level["precision"]): level["state"] for level in predicate["levels"]}
        for precision in ("binary32", "binary64"):
            self.assertEqual(state["exact", precision], "not met")
            self.assertEqual(state["logic", precision], "not met")  # strict sides are wrong on triangles without area
        for level in predicate["levels"]:
            self.assertEqual(level["state"] == "NOT CHECKED", level["reason"] is not None, level)
            self.assertEqual(level["state"] == "met", bool(level["rests_on"]), level)
            self.assertEqual(level["state"] == "not met", bool(level["failures"]), level)
        self.assertEqual(len(predicate["witnesses"]), 3)
        self.assertEqual({row["kernel"] for row in predicate["comparison"]}, {"published", "certified"})
        self.assertEqual(set(predicate["search"]["precisions"]), {"binary32", "binary64"})
        self.assertIsNotNone(predicate["breaks_first"])
        folder = cert.parent
        words, page = (folder / "certificate.txt").read_text(), (folder / "certificate.html").read_text()
        for part in ("Safe margin in binary32", "What breaks first", "What this does not say", "Diagnosis", "Beside other kernels"):
            self.assertIn(part, words)
            self.assertIn(part, page)
        first = " ".join(words.splitlines()[:5])
        for part in ("made by axiscert", "effort smoke, seed 1; not signed", "queries of", "looked at; left out: nothing", "Met: "):
            self.assertIn(part.lower(), first.lower())
            self.assertIn(part.split(";")[0].lower(), page.lower())
        self.assertIn(">no level met; smoke, ", (folder / "badge.svg").read_text())
        # A witness is one: its command shows that.
        command = predicate["witnesses"][0]["command"].split(" && ")[-1].split()
        query = axiscert("query", predicate["witnesses"][0]["address"]).stdout
        shown = axiscert("check", "-", *command[command.index("--kernel"):], stdin=query)
        self.assertIn("wrong", shown.stdout)

    def test_certified_meets_every_level_that_it_can_and_needs_no_margin(self):
        predicate = json.loads(self.certificate_of("certified").read_text())["predicate"]
        for level in predicate["levels"]:
            self.assertIn(level["state"], ("met", "NOT CHECKED"), level)
            if level["level"] == "exact":
                self.assertEqual([rest["kind"] for rest in level["rests_on"]], ["proved", "observed", "searched"])
        for margin in predicate["safe_margin"]["precisions"]:
            self.assertEqual((margin["all"]["missed"], margin["factor"], margin["amount"]), (0, None, None))

    def test_a_run_that_is_out_of_time_has_no_certificate_until_it_is_resumed_and_then_the_same_on_any_number_of_threads(self):
        out = self.folder / "certificate"
        done = self.certify("published", "--time", "0.001", "--threads", 1, code=1)
        self.assertRegex(done.stderr, r"[0-9]+ of the plan's [0-9]+ stretches are done, and a certificate has all of them: none is written in ")
        self.assertIn("--time is over: the rest is done without it; this goes on:\n  axiscert certify published ", done.stderr)
        self.assertIn("--resume", done.stderr.splitlines()[-1])
        self.assertNotIn("--time", done.stderr.splitlines()[-1])
        self.assertFalse((out / "certificate.json").exists())
        self.certify("published", "--resume", "--threads", 1)
        self.assertEqual((out / "certificate.json").read_bytes(), self.certificate_of("published").read_bytes())

    def certified_promise(self, name, code=0):
        """The predicate and the text of the certificate of one of kernel/plugin/promises_testing.c."""
        out = self.folder / name
        self.certify(f"plugin:{BUILD}/promises/{name}.so", out=out, code=code)
        self.verify(out / "certificate.json")
        return json.loads((out / "certificate.json").read_text())["predicate"], (out / "certificate.txt").read_text(), (out / "badge.svg").read_text()

    def test_a_kernel_that_answers_nothing_is_told_so_first(self):
        predicate, words, badge = self.certified_promise("answers_77", code=1)
        said = "it gave no answer that counts in binary32"
        self.assertIn(said, " ".join(words.splitlines()[:2]))
        self.assertIn(said, badge)
        self.assertFalse([level for level in predicate["levels"] if level["state"] == "met"])
        self.assertIn("not known: it answered none of", words)
        self.assertNotIn("none is needed", words)
        self.assertNotIn("Nothing broke", words)
        self.assertEqual(predicate["asked"]["looked_at"], 0)
        (search,) = predicate["search"]["precisions"].values()
        self.assertEqual((set(search["finds"]), set(search["looked_at"].values())), (set(search["looked_at"]), {0}))
        self.assertRegex(words, r"missed_contact +not looked at")

    def test_what_a_kernel_leaves_out_is_said_first(self):
        for name, left_out, said in (("declines_declared", "declined", "Met of the 9"), ("limited_to_far", "outside_limits", "outside its limits")):
            predicate, words, badge = self.certified_promise(name)
            count = predicate["asked"]["left_out"][left_out]
            self.assertGreater(count, 100)
            first = " ".join(words.splitlines()[:5])
            self.assertIn(said, first)
            self.assertIn(f"{count:,} ", first)
            self.assertIn(f"{count:,} ", badge)
            (margin,) = predicate["safe_margin"]["precisions"]
            self.assertLessEqual(margin["contacts"]["of_run"]["declined"], predicate["asked"]["left_out"]["declined"])

    def test_it_is_resumed_and_comes_to_the_same(self):
        whole = self.certificate_of("published").parent
        out = self.folder / "again"
        shutil.copytree(whole, out)
        (out / "certificate.json").unlink()
        stages = json.loads((out / "stages.json").read_text())
        stages.pop("harness")
        (out / "stages.json").write_text(json.dumps(stages))
        journal = out / "run/journal"
        journal.write_bytes(journal.read_bytes()[:-1000])  # as a kill leaves it
        self.assertIn("--resume continues it", self.certify("published", out=out, code=2).stderr)
        self.certify("published", "--resume", out=out)
        self.assertEqual((out / "certificate.json").read_bytes(), (whole / "certificate.json").read_bytes())

    def test_what_cannot_be_certified_is_refused(self):
        self.refused("certify", "publishd", says=["publishd", "did you mean 'published'"])
        self.refused("certify", "published", "--effort", "quik", says=["--effort", "quick"])
        self.refused("certify", "published", "--key", self.written(b"hello"), says=["is no private key in PEM"])
        self.refused("certify", says=["KERNEL"])


class NumbersCertified(CertifyCase):
    """A certificate is of the numbers beside a verdict too: a change of one, planted in a plug-in, is not certified, and not verified."""
    def levels_of(self, kernel, name):
        predicate = json.loads(self.certificate_of(kernel, name=name).read_text())["predicate"]
        return {level["level"]: level["state"] for level in predicate["levels"]}

    def test_a_certificate_is_of_the_numbers_too(self):
        kernel = built(self.folder, "mine")
        good = self.levels_of(kernel, "good")
        bad = self.levels_of(built(self.folder, "changed", "*feature = 6"), "bad")
        self.assertEqual({name for name, state in good.items() if bad.get(name) != state and state == "met"}, {"feature=0.001"}, f"{good}\n{bad}")
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", kernel)
        self.verify(self.folder_of("good") / "certificate.json", "--kernel", built(self.folder, "mine", "*feature = 6"), code=1)

    def test_numbers_have_to_follow_exact_images(self):
        for name, kernel, state in (("exact", "contact", "met"), ("uneven", built(self.folder, "upwards", UPWARDS), "not met")):
            self.assertEqual(self.levels_of(kernel, name)["follows=0.001"], state, name)


if __name__ == "__main__":
    unittest.main()
