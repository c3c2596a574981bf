#!/usr/bin/env python3
"""`axiscert verify`: a certificate that holds, signed or not, and every way in which one does not."""
import base64
import hashlib
import json
import unittest

from certificates import canonical, CertifyCase, openssl, sealed, without_family
from command import BUILD, ROOT


class Verify(CertifyCase):
    def test_a_certificate_of_this_axiscert_holds(self):
        cert = self.certificate_of("published")
        self.verify(cert, says=["signature: none", "kernel: published is the one", "axiscert: made by this version", "plan: that of its effort and seed",
                                 "promises: published, certified: as they declare here",
                                 "exact: not met", "\nVALID\n"])

    def test_it_begins_with_how_much_was_asked_of_what_and_by_whom(self):
        lines = self.verify(self.certificate_of("published")).stdout.splitlines()[:5]
        self.assertRegex(lines[2], "^certificate: made by axiscert .* with effort smoke, seed 1$")
        self.assertRegex(lines[3], "^asked: [0-9,]+ queries of [23][0-9] families and files, in binary32 and binary64$")
        self.assertRegex(lines[4], "^answers: [0-9,]+ looked at; left out: nothing; [0-9,]+ are no query$")

    def test_a_recheck_says_what_it_runs_and_takes_the_sample_of_its_seed(self):
        cert = self.certificate_of("published")
        done = self.verify(cert, "--recheck", "2%", "--recheck-seed", 7, says=["every tally the same", "(--recheck-seed 7)"])
        self.assertIn("recheck: will run published on", done.stdout.split("judged again")[0])
        self.refused("verify", cert, "--recheck", "0%", says=["--recheck 0%", "as in 1%"])
        self.refused("verify", cert, "--recheck-seed", "7", says=["--recheck"])

    def test_a_recheck_finds_a_tally_that_is_another(self):
        def other(predicate):
            for tally in predicate["materials"]["tallies"]:
                tally["sha256"][0] = "0" * 64
        cert = self.remade(other)
        self.verify(cert)  # no count is another
        self.verify(cert, "--recheck", "1%", code=1, says=["NOT VALID", "the recheck comes out otherwise", "tally of published"])

    def test_another_built_in_kernel_is_told(self):
        cert = self.certificate_of("published")
        self.verify(cert, "--kernel", "certified", code=1, says=["it is about another kernel: about published, not certified"])

    def test_a_changed_byte_and_a_file_that_is_cut_off(self):
        whole = self.certificate_of("published").read_bytes()
        self.verify(self.written(whole.replace(b'"not met"', b'"met"', 1)), code=1, says=["NOT VALID", "changed after it was written"])
        self.verify(self.written(whole[:-200]), code=2, says=["it ends in the middle"])
        self.verify(self.written(b""), code=2, says=["it ends in the middle"])
        self.verify(self.written(b"[1]"), code=2, says=["is no certificate"])
        self.verify(self.folder / "absent.json", code=2, says=["absent.json"])
        self.verify(self.written(b'{"a":1,"a":1}'), code=2, says=["occurs twice"])
        self.verify(self.written(b" " * (64 << 20) + b"{}"), code=2, says=["a certificate has at most"])

    def test_a_version_that_is_not_read(self):
        statement = json.loads(self.certificate_of("published").read_text())
        statement["predicateType"] = "urn:axiscert:certificate:2"
        self.verify(self.written(canonical(statement)), code=2, says=["is a certificate of version urn:axiscert:certificate:2", "reads version urn:axiscert:certificate:7", "certify the kernel anew"])

    def test_a_certificate_of_other_sources_is_not_rechecked_as_if_it_were_of_these(self):
        def of_another(predicate):
            predicate["materials"]["axiscert"] = {"version": "0.0.9", "sources": "0" * 64}
            predicate["materials"]["plan"]["plan"]["generators"]["tangent"]["version"] += 1
        cert = self.remade(of_another)
        self.verify(cert, says=["made by 0.0.9", "plan: NOT CHECKED", "VALID as far as it could be checked"])
        self.verify(cert, "--recheck", "1%", code=2, says=["cannot be rechecked here: it was made by axiscert 0.0.9", "tangent"])

    def test_its_signature_is_that_of_the_standard(self):
        cert, public = self.signed()
        envelope = json.loads(cert.read_text())
        payload = base64.b64decode(envelope["payload"], validate=True)
        kind = envelope["payloadType"].encode()
        authenticated = b"DSSEv1 %d %s %d %s" % (len(kind), kind, len(payload), payload)
        signature = self.written(base64.b64decode(envelope["signatures"][0]["sig"], validate=True), "sig")
        said = openssl("pkeyutl", "-verify", "-pubin", "-inkey", public, "-rawin", "-in", self.written(authenticated, "pae"),
                       "-sigfile", signature)
        self.assertIn(b"Verified Successfully", said)
        der = openssl("pkey", "-pubin", "-in", public, "-outform", "DER")
        self.assertEqual(envelope["signatures"][0]["keyid"], hashlib.sha256(der).hexdigest())
        self.assertRegex(json.loads(payload)["predicate"]["signed_at"], "^20..-..-..T..:..:..Z$")

    def test_it_holds_with_its_key_and_with_no_other(self):
        cert, public = self.signed()
        self.verify(cert, "--key", public, says=["signature: by the key", "VALID"])
        self.verify(cert, says=["signature: NOT CHECKED: it is said to be signed by the key ", "give the public key with --key"])
        other = self.keys("other")[1]
        self.verify(cert, "--key", other, code=1, says=["NOT VALID", "it was not signed with this key"])
        self.verify(cert, "--key", self.keys()[0], code=2, says=["is no public key"])
        self.verify(self.certificate_of("published"), "--key", public, code=1, says=["NOT VALID", "it is not signed"])

    def test_a_changed_payload_signature_or_key_id(self):
        cert, public = self.signed()
        envelope = json.loads(cert.read_text())
        statement = json.loads(base64.b64decode(envelope["payload"]))
        statement["predicate"]["levels"][0]["state"] = "met"
        forged = dict(envelope, payload=base64.b64encode(sealed(statement)[:-1]).decode())
        self.verify(self.written(canonical(forged)), "--key", public, code=1, says=["NOT VALID", "changed after it was signed"])
        signature = bytearray(base64.b64decode(envelope["signatures"][0]["sig"]))
        signature[5] ^= 1
        wrong = dict(envelope["signatures"][0], sig=base64.b64encode(bytes(signature)).decode())
        self.verify(self.written(canonical(dict(envelope, signatures=[wrong]))), "--key", public, code=1,
                    says=["changed after it was signed"])
        self.verify(self.written(canonical(dict(envelope, signatures=[]))), code=2, says=["has no signature"])
        self.verify(self.written(canonical(dict(envelope, payload=envelope["payload"] + "\n"))), code=2, says=["is not base64"])
        self.verify(self.written(canonical(dict(envelope, payloadType="text/plain"))), code=2, says=["payloadType is text/plain"])
        self.verify(self.written(cert.read_bytes()[:-30]), code=2, says=["it ends in the middle"])

    # Each row of the table in docs/certify.md, tried on a certificate that something happened to.
    def of_another_axiscert(self, predicate):
        predicate["materials"]["axiscert"]["sources"] = "0" * 64
        predicate["materials"]["plan"]["plan"]["generators"]["tangent"]["version"] += 1

    def all_met(self, predicate):
        for level in predicate["levels"]:
            level.update(state="met", failures=[], failure_count=0, reason=None)

    def other_tallies(self, predicate):
        for tally in predicate["materials"]["tallies"]:
            tally["sha256"][0] = "0" * 64

    def happened(self, what):
        """The arguments of verify."""
        plain, (signed, public) = self.certificate_of("published"), self.signed()
        whole, envelope = plain.read_bytes(), json.loads(signed.read_text())
        forged = base64.b64encode(canonical(json.loads(self.remade(lambda p: p["limits"].clear()).read_text()))).decode()
        return {
            "nothing": lambda: [signed, "--key", public, "--kernel", "published", "--recheck", "1%"],
            "a word changed": lambda: [self.written(whole.replace(b'"not met"', b'"met"', 1))],
            "a signed payload or a signature changed": lambda: [self.written(canonical(dict(envelope, payload=forged))), "--key", public],
            "another key": lambda: [signed, "--key", self.keys("other")[1]],
            "no signature where a key is given": lambda: [plain, "--key", public],
            "another kernel": lambda: [plain, "--kernel", "certified"],
            "a level edited, and signed anew": lambda: [self.remade(self.all_met)],
            "a stretch left out": lambda: [self.remade(lambda p: p["materials"]["tallies"].pop())],
            "another effort than its plan's": lambda: [self.remade(lambda p: p["asked"].update(effort="deep"))],
            "a family left out of the plan": lambda: [self.remade(without_family)],
            "a tally that comes out otherwise": lambda: [self.remade(self.other_tallies), "--recheck", "1%"],
            "cut off": lambda: [self.written(whole[:-200])],
            "another version of the format": lambda: [self.written(whole.replace(b"certificate:7", b"certificate:2"))],
            "made by another axiscert": lambda: [self.remade(self.of_another_axiscert)],
            "made by another axiscert, `--recheck`": lambda: [self.remade(self.of_another_axiscert), "--recheck", "1%"],
            "a kernel that is to be rechecked and was not given": lambda: [self.certificate_of(f"plugin:{BUILD}/promises/always_contact.so", name="plugin"), "--recheck", "1%"],
        }[what]()

    def test_each_row_of_the_document(self):
        page = (ROOT / "docs/certify.md").read_text()
        rows = [[cell.strip() for cell in line.strip("| \n").split(" | ")] for line in page.splitlines() if line.startswith("| ") and line.count("|") == 4]
        rows = [row for row in rows if row[1] in "012"]
        self.assertEqual(len(rows), 16)
        for what, code, said in rows:
            with self.subTest(what):
                self.verify(*self.happened(what), code=int(code), says=[said.strip("`")])


if __name__ == "__main__":
    unittest.main()
