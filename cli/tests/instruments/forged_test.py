#!/usr/bin/env python3
"""Certificates that contradict themselves, signed anew by whoever forged them: each is refused by name, without the kernel."""
import base64
import json
import unittest

from command import BUILD
from certificates import canonical, CertifyCase, openssl, sealed, without_family


def tallies(predicate):
    return predicate["materials"]["tallies"]


def plan(predicate):
    return predicate["materials"]["plan"]["plan"]


class Forged(CertifyCase):
    def not_valid(self, change, *says, kernel="published", args=()):
        done = self.verify(self.remade(change, kernel), *args, code=1, says=["NOT VALID", *says])
        self.assertNotIn("\nVALID", done.stdout)

    def test_the_same_statement_written_again_holds(self):
        self.verify(self.remade(lambda predicate: None), says=["\nVALID\n"])

    def test_a_file_with_the_id_of_a_built_in_kernel_of_which_something_is_proved(self):
        def renamed(predicate):
            for row in predicate["comparison"]:
                if row["kernel"] == predicate["kernel"]["id"]:
                    row["kernel"] = "conservative"
            predicate["kernel"]["id"] = "conservative"
        path = f"{BUILD}/promises/always_contact.so"
        self.not_valid(renamed, "its kernel is of kind plugin, and has the id of a built-in one, conservative", kernel=f"plugin:{path}",
                       args=["--kernel", path])

    def test_levels_that_are_edited_to_met(self):
        def all_met(predicate):
            for level in predicate["levels"]:
                level.update(state="met", failures=[], failure_count=0, reason=None)
        self.not_valid(all_met, "it states", "met, and its counts say: not met: ")
        self.not_valid(lambda p: p["levels"].pop(0), "it leaves out the level")
        self.not_valid(lambda p: p["levels"].append(dict(p["levels"][0], level="perfect")), "its counts say nothing of it")
        self.not_valid(lambda p: p["levels"][0].update(looked_at="everything"), "is not what its counts say")

    def test_levels_and_signed_by_a_key_of_the_forger(self):
        signed, public = self.signed()
        envelope = json.loads(signed.read_text())
        statement = json.loads(base64.b64decode(envelope["payload"]))
        for level in statement["predicate"]["levels"]:
            if level["level"] == "exact":
                level.update(state="met", failures=[], failure_count=0)
        payload = sealed(statement)[:-1]
        kind = envelope["payloadType"].encode()
        bytes_signed = self.written(b"DSSEv1 %d %s %d %s" % (len(kind), kind, len(payload), payload), "pae")
        signature = openssl("pkeyutl", "-sign", "-inkey", self.keys()[0], "-rawin", "-in", bytes_signed)
        envelope["payload"] = base64.b64encode(payload).decode()
        envelope["signatures"][0]["sig"] = base64.b64encode(signature).decode()
        self.verify(self.written(canonical(envelope)), "--key", public, code=1,
                    says=["NOT VALID", "it states exact in binary32 met, and its counts say: not met"])

    def test_counts_that_are_edited_with_the_levels_are_found_by_a_recheck(self):
        def right(predicate):
            """As if published had been right on all queries of one family: everything that a forger can make agree."""
            for tally in tallies(predicate):
                if not tally["of"].startswith("tangent "):
                    continue
                mine = tally["counts"][0]
                mine["verdict"] = {name: count for name, count in mine["verdict"].items() if name.startswith("decided")}
                mine.pop("classes", None)
        # A forger has to make all that follows from the counts, which is another then; the recheck is left.
        self.not_valid(right, "its counts say")
        self.not_valid(right, "its counts say", args=["--recheck", "100%"])

        def another_digest(predicate):
            tallies(predicate)[3]["sha256"][0] = "0" * 64
        self.verify(self.remade(another_digest))
        self.not_valid(another_digest, "the recheck comes out otherwise", "has the digest", args=["--recheck", "100%"])

        def other_figures(predicate):
            """A count from which no level, and no number that is stated besides, follows."""
            verdicts = (tally["counts"][0].get("verdict", {}) for tally in tallies(predicate))
            links = next(verdict for verdict in verdicts if "decided_touching" in verdict).setdefault("touching_links", {})
            links["rounding"] = links.get("rounding", 0) + 1
        self.verify(self.remade(other_figures))
        self.not_valid(other_figures, "the recheck comes out otherwise", "has other counts: here", args=["--recheck", "100%"])

    def test_a_promise_that_a_built_in_kernel_does_not_make_is_refused_by_name(self):
        def strictness(predicate):
            for entry in predicate["materials"]["kernels"]:
                entry["strictness"] = "nonstrict"
        self.not_valid(strictness, 'published in binary32 is stated with another strictness: here "strict"')
        self.not_valid(strictness, "is stated with another strictness: here", args=["--recheck", "1%"])

        def declines(predicate):
            """Both copies of one kernel's promise; its words follow the second."""
            predicate["kernel"]["may_decline"] = True
            predicate["limits"].insert(-1, "The kernel may decline: what it does not decide has to be asked of another predicate.")
            for entry in predicate["materials"]["kernels"]:
                if entry["id"] == "kernel":
                    entry["may_decline"] = True
        self.not_valid(declines, "published in binary32 is stated with another may_decline: here false, in it true; 1 more differ")

        def yardstick(predicate):
            for entry in predicate["materials"]["kernels"]:
                if entry["id"] == "certified":
                    entry["may_decline"] = True
        self.not_valid(yardstick, "certified in binary32 is stated with another may_decline: here false, in it true; 1 more differ")

        def of_triangles(predicate):
            predicate["materials"]["kernels"][0]["families"]["lattice"]["base_triangles"] -= 1
        self.not_valid(of_triangles, "published in binary32 on lattice is stated with another base_triangles: here")

        def of_another_version(predicate):
            """Whose kernels may declare something else: they are not compared, and it is said."""
            predicate["materials"]["axiscert"] = {"version": "0.0.9", "sources": "0" * 64}
            declines(predicate)
        self.verify(self.remade(of_another_version), says=["promises: NOT COMPARED: made by another version", "and promises NOT COMPARED"])

    def test_what_switches_a_check_off_is_refused(self):
        def replies(predicate):
            predicate["kernel"]["kind"] = predicate["asked"]["effort"] = "replies"
        self.not_valid(replies, "its kernel is said to be replies, and its subject is built-in")

        def no_margin(predicate):
            predicate["safe_margin"] = {"reason": "none is needed", "precisions": []}
        self.not_valid(no_margin, "it has no safe margin")

        def another_axiscert(predicate):
            """Whose words are not compared: a level that is refused is not left out all the same."""
            predicate["materials"]["axiscert"]["sources"] = "0" * 64
            predicate["levels"] = [level for level in predicate["levels"] if level["state"] != "not met"]
        self.not_valid(another_axiscert, "it leaves out the level")

        def of_triangles(predicate):
            for entry in predicate["materials"]["kernels"]:
                for family in entry["families"].values():
                    family["base_triangles"] = max(0, family["base_triangles"] - 1)
        self.not_valid(of_triangles, args=["--recheck", "1%"])
        self.not_valid(lambda p: p["materials"]["axiscert"].update(version="9.9.9"), "it states version")

    def test_stretches_that_are_missing_doubled_or_of_another_size(self):
        count = len(tallies(json.loads(self.certificate_of("published").read_text())["predicate"]))
        self.not_valid(lambda p: p["materials"].update(tallies=tallies(p)[:1]), f"it has 1 of the plan's {count} stretches")
        self.not_valid(lambda p: tallies(p).pop(5), f"it has {count - 1} of the plan's {count} stretches", "is missing")
        self.not_valid(lambda p: tallies(p).insert(5, tallies(p)[5]), "its stretches are not in rising order, each once")
        self.not_valid(lambda p: tallies(p).append(dict(tallies(p)[0], stretch=count)), f"it has a stretch {count}, and its plan has {count}")
        self.not_valid(lambda p: tallies(p)[0].update(of=tallies(p)[1]["of"]), "its stretch 0 is said to be")
        self.not_valid(lambda p: p["materials"]["plan"].update(units_per_stretch=7), "its stretches have 7 units, and `certify` makes them of 1")

        def smaller(predicate):
            counts = tallies(predicate)[0]["counts"]
            for mine in counts:
                mine["trials"] -= 1
        self.not_valid(smaller, "255 queries, and its plan has 256 there")

    def test_counts_that_contradict_each_other(self):
        def with_counts(change, k=0):
            def made(predicate):
                counts = tallies(predicate)[0]["counts"][k]
                counts.setdefault("verdict", {})  # nothing is wrong there
                change(counts)
            return made
        self.not_valid(with_counts(lambda c: c["truth"].update(contact=c["truth"].get("contact", 0) + 1)), "the truths do not add up")
        self.not_valid(with_counts(lambda c: c["verdict"].update(undecided=300)), "answers than")
        self.not_valid(with_counts(lambda c: c["verdict"].update(false_separation=-1)), "a count there is from 0 to")
        self.not_valid(with_counts(lambda c: c["verdict"].update(false_separation="1")), "a count there is from 0 to")
        self.not_valid(with_counts(lambda c: c["verdict"].update(mistakes=1)), "which no count is called")
        self.not_valid(with_counts(lambda c: c["verdict"].update(deepest="deep")), "which is no number")
        self.not_valid(with_counts(lambda c: c["verdict"].update(touching_flips=c["verdict"].get("decided_touching", 0) + 1)), "touching_flips")
        self.not_valid(with_counts(lambda c: c["verdict"].update(clear={"queries": 1, "undecided": 1}), k=1), "answers of one kind to clear")
        self.not_valid(lambda p: tallies(p)[0]["counts"].pop(), "tallies")

        def another_truth(counts):
            truth = counts["truth"]
            truth.update(contact=truth.get("contact", 0) + 1, separated=truth["separated"] - 1)
            for decided in (counts["verdict"], counts["verdict"]["clear"]):
                decided.update(decided_contacts=decided.get("decided_contacts", 0) + 1, decided_separations=decided["decided_separations"] - 1)
        self.not_valid(with_counts(another_truth, k=1), "the truth of the same queries is another")

    def test_an_effort_that_its_plan_is_not(self):
        def deep(predicate):
            predicate["asked"]["effort"] = "deep"
        self.not_valid(deep, "effort deep asks 16,777,216 queries of `", "its plan has 256")

    def test_a_plan_that_is_not_that_of_the_effort(self):
        self.not_valid(without_family, "its plan is not that of effort smoke: here families/")
        self.not_valid(lambda p: plan(p)["generators"]["tangent"].update(version=99), "its plan is not that of effort smoke")
        self.not_valid(lambda p: plan(p).update(seed=2), "seed")

        def of_another(predicate):
            predicate["materials"]["axiscert"]["sources"] = "0" * 64
            plan(predicate)["generators"]["tangent"]["version"] = 99
        done = self.verify(self.remade(of_another), says=["plan: NOT CHECKED: made by another axiscert"])
        self.assertRegex(done.stdout, "\nVALID as far as it could be checked: .*\n$")
        self.not_valid(lambda p: plan(p)["trials"]["tangent"].update(binary32=32), "effort smoke asks 256 queries of `tangent` in binary32, and its plan has 32")

    def test_margins_that_are_edited(self):
        def with_margin(change):
            return lambda predicate: change(predicate["safe_margin"]["precisions"][0])
        self.not_valid(with_margin(lambda m: m["all"].update(missed=0)), "its safe margin in", "missed: 0, and its parts say")
        self.not_valid(with_margin(lambda m: m.update(queries=m["queries"] + 1)), "promised queries:")
        self.not_valid(with_margin(lambda m: m.update(phantoms=m["phantoms"] + 1)), "phantom contacts:")
        self.not_valid(with_margin(lambda m: m["contacts"]["of_run"].update(missed=0)), "missed contacts of the run: 0, and its counts say")
        self.not_valid(with_margin(lambda m: m["factor"].update(value="1.00001")), "factor: 1.00001, and its parts say")

        def all_parts(margin):
            margin["factor"]["value"] = "1"
            for part in margin["decades"]:
                if part["factor"] is not None:
                    part["factor"] = "1"
        self.not_valid(with_margin(all_parts), "factor: 1, and its radii say")
        self.not_valid(lambda p: p["safe_margin"]["precisions"].pop(), "safe margins of 1 of 2 precisions")

    def test_a_comparison_and_numbers_that_are_edited(self):
        self.not_valid(lambda p: p["comparison"][0].update(missed=0), "its comparison states missed 0 of published in binary32, and its counts say")
        self.not_valid(lambda p: p["comparison"].pop(), "its comparison has 3 rows, and its counts make 4")
        self.not_valid(lambda p: p["asked"].update(queries=10**9), "it states `queries` 1000000000, and its plan and counts say")
        self.not_valid(lambda p: p["asked"]["left_out"].update(no_query=0), "it states `left_out`")
        self.not_valid(lambda p: p["kernel"].update(limits="r from 1"), "of its kernel: it states `limits`")
        self.not_valid(lambda p: p.update(breaks_first=None), "what it states to break first")
        self.not_valid(lambda p: p["breaks_first"].update(count=1), "what it states to break first")
        self.not_valid(lambda p: p["limits"].clear(), "its limits are not those that follow")

    def test_images_that_are_edited(self):
        def images(predicate):
            for entry in predicate["materials"]["kernels"]:
                for family in entry["families"].values():
                    yield from family.get("invariance", {}).values()

        def fewer(predicate):
            for changes in images(predicate):
                changes["changed"] = changes["images"] + 1
        self.not_valid(fewer, "more images changed than were compared")

        def dropped(predicate):
            for entry in predicate["materials"]["kernels"]:
                for family in entry["families"].values():
                    family.pop("invariance", None)
        self.not_valid(dropped, "it does not say what its images came to")

        def one_less(predicate):
            """No level changes, and only asking again shows it."""
            changes = next(c for c in images(predicate) if c["images"] > 10 and c["changed"] == 0 and not c.get("range"))
            changes["images"] -= 1
        cert = self.remade(one_less)
        done = self.verify(cert, "--recheck", "100%", code=1, says=["NOT VALID"])
        self.assertTrue("come to something else" in done.stderr or "its counts say" in done.stderr, done.stderr)

    def test_a_signer_that_has_not_signed(self):
        self.not_valid(lambda p: p.update(signed_by="0" * 64), "it is said to be signed by the key 0000000000000000, and is not signed")

    def test_a_median_that_is_edited_is_found_where_all_is_done_again(self):
        def median(predicate):
            predicate["comparison"][0]["median_ulps"] = "1"
            predicate["materials"]["kernels"][0]["critical_radius"]["median_ulps"] = "1"
        cert = self.remade(median)
        self.verify(cert)
        self.verify(cert, "--recheck", "100%", code=1, says=["the critical radius of published in binary32"])


if __name__ == "__main__":
    unittest.main()
