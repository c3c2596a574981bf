#!/usr/bin/env python3
"""`axiscert certify` and `axiscert verify`: a certificate that holds, and every way in which one does not."""
import base64
import hashlib
import json
import shutil
import subprocess
import tempfile
import unittest
from pathlib import Path

import jsonschema

from command import BUILD, ROOT, SCHEMAS, Case, axiscert


def openssl(*args, stdin=None):
    return subprocess.run(["openssl", *map(str, args)], input=stdin, capture_output=True, check=True).stdout


def canonical(value):
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


class CertifyCase(Case):
    """A certificate is made once for each kernel."""
    made = {}

    @classmethod
    def setUpClass(cls):
        super().setUpClass()
        cls.shared = tempfile.TemporaryDirectory()
        cls.addClassCleanup(cls.shared.cleanup)

    @classmethod
    def folder_of(cls, name):
        return Path(cls.shared.name) / name

    def certify(self, kernel, *args, out=None, code=0):
        out = out or self.folder / "certificate"
        done = axiscert("certify", kernel, "--effort", "smoke", *args, "--out", out)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        return done

    def certificate_of(self, kernel, *args, name=None):
        out = self.folder_of(name or kernel.replace("/", "-"))
        if not out.exists():
            self.certify(kernel, *args, out=out)
        return out / "certificate.json"

    def verify(self, cert, *args, code=0, says=()):
        done = axiscert("verify", cert, *args)
        self.assertEqual(done.returncode, code, done.stdout + done.stderr)
        for part in says:
            self.assertIn(part, done.stdout + done.stderr)
        self.assertNotIn("terminate called", done.stderr)
        return done

    def written(self, content, name="cert.json"):
        path = self.folder / name
        path.write_bytes(content)
        return path

    def keys(self, name="key"):
        private, public = self.folder_of(name + ".pem"), self.folder_of(name + ".pub")
        if not private.exists():
            openssl("genpkey", "-algorithm", "ed25519", "-out", private)
            openssl("pkey", "-in", private, "-pubout", "-out", public)
        return private, public


class Certify(CertifyCase):
    def test_a_certificate_is_the_same_again_on_any_number_of_threads_and_without_a_clock(self):
        cert = self.certificate_of("published")
        self.certify("published", "--threads", 1)
        self.assertEqual((self.folder / "certificate/certificate.json").read_bytes(), cert.read_bytes())
        statement = json.loads(cert.read_text())
        schema = json.loads((SCHEMAS / "certificate.schema.json").read_text())
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
            self.assertEqual(level["state"] == "not asked", level["reason"] is not None, level)
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
        self.assertNotIn("not run", words)
        self.assertIn("axiscert: no level met", (folder / "badge.svg").read_text())
        # A witness is one: its command shows that.
        command = predicate["witnesses"][0]["command"].split(" && ")[-1].split()
        query = axiscert("query", predicate["witnesses"][0]["address"]).stdout
        shown = axiscert("check", "-", *command[command.index("--kernel"):], stdin=query)
        self.assertIn("wrong", shown.stdout)

    def test_certified_meets_every_level_that_it_can_and_needs_no_margin(self):
        predicate = json.loads(self.certificate_of("certified").read_text())["predicate"]
        for level in predicate["levels"]:
            self.assertIn(level["state"], ("met", "not asked"), level)
            if level["level"] == "exact":
                self.assertEqual([rest["kind"] for rest in level["rests_on"]], ["proved", "observed", "searched"])
        for margin in predicate["safe_margin"]["precisions"]:
            self.assertEqual((margin["all"]["missed"], margin["factor"], margin["amount"]), (0, None, None))

    def test_a_test_without_a_radius_says_so(self):
        predicate = json.loads(self.certificate_of("box-box/projected").read_text())["predicate"]
        self.assertIn("does not depend on one radius", predicate["safe_margin"]["reason"])
        self.assertEqual(predicate["safe_margin"]["precisions"], [])
        self.assertIsNone(predicate["search"]["reason"])  # a test need not have a radius to be searched
        for precision in predicate["kernel"]["precisions"]:
            search = predicate["search"]["precisions"][precision]
            self.assertGreater(search["evaluations"], 0)
            self.assertIn("missed_contact", search["finds"])
        self.assertEqual(predicate["kernel"]["test"], "box-box")
        self.assertTrue(predicate["witnesses"])
        for witness in predicate["witnesses"]:  # what the page draws
            self.assertEqual(witness["query"]["test"], "box-box")
            self.assertLessEqual({"a.m", "a.s", "b.m", "b.s"}, set(witness["query"]))

    def test_a_run_that_is_out_of_time_lists_what_was_done(self):
        self.certify("published", "--time", "0.001", "--threads", 1)
        cert = self.folder / "certificate/certificate.json"
        predicate = json.loads(cert.read_text())["predicate"]
        self.assertFalse(predicate["asked"]["complete"])
        self.assertLess(predicate["asked"]["stretches_done"], predicate["asked"]["stretches"])
        self.assertEqual(len(predicate["materials"]["tallies"]), predicate["asked"]["stretches_done"])
        self.assertIn("the time given was over", json.dumps(predicate["limits"]))
        self.verify(cert)

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


class Verify(CertifyCase):
    def test_a_certificate_of_this_axiscert_holds(self):
        cert = self.certificate_of("published")
        self.verify(cert, says=["signature: none", "kernel: published is the one", "axiscert: made by this version", "VALID"])

    def test_a_recheck_says_what_it_runs_and_takes_the_sample_of_its_seed(self):
        cert = self.certificate_of("published")
        done = self.verify(cert, "--recheck", "2%", "--recheck-seed", 7, says=["every tally the same (--recheck-seed 7)"])
        self.assertIn("recheck: will run published on", done.stdout.split("judged again")[0])
        self.refused("verify", cert, "--recheck", "0%", says=["--recheck 0%", "as in 1%"])
        self.refused("verify", cert, "--recheck-seed", "7", says=["--recheck"])

    def test_a_recheck_finds_a_tally_that_is_another(self):
        statement = json.loads(self.certificate_of("published").read_text())
        predicate = statement["predicate"]
        predicate.pop("digest")
        for tally in predicate["materials"]["tallies"]:
            tally["sha256"][0] = "0" * 64
        predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        cert = self.written(canonical(statement) + b"\n")
        self.verify(cert)  # whoever forges it can make the digest too: that is what the signature and the recheck are for
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
        statement["predicateType"] = "urn:axiscert:certificate:0"
        self.verify(self.written(canonical(statement)), code=2, says=["is a certificate of version urn:axiscert:certificate:0"])

    def test_a_certificate_of_other_sources_is_not_rechecked_as_if_it_were_of_these(self):
        statement = json.loads(self.certificate_of("published").read_text())
        predicate = statement["predicate"]
        predicate.pop("digest")
        predicate["materials"]["axiscert"] = {"version": "0.0.9", "sources": "0" * 64}
        plan = predicate["materials"]["plan"]
        plan["plan"]["generators"]["tangent"]["version"] += 1
        plan["digest"] = hashlib.sha256(canonical(plan["plan"])).hexdigest()
        predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        cert = self.written(canonical(statement) + b"\n")
        self.verify(cert, says=["made by 0.0.9"])
        self.verify(cert, "--recheck", "1%", code=2, says=["cannot be rechecked here: it was made by axiscert 0.0.9", "tangent"])


class Signed(CertifyCase):
    def signed(self):
        private, public = self.keys()
        return self.certificate_of("published", "--key", private, name="signed"), public

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
        self.verify(cert, says=["signature: NOT CHECKED: give the public key with --key"])
        other = self.keys("other")[1]
        self.verify(cert, "--key", other, code=1, says=["NOT VALID", "it was not signed with this key"])
        self.verify(cert, "--key", self.keys()[0], code=2, says=["is no public key"])
        self.verify(self.certificate_of("published"), "--key", public, code=1, says=["NOT VALID", "it is not signed"])

    def test_a_changed_payload_signature_or_key_id(self):
        cert, public = self.signed()
        envelope = json.loads(cert.read_text())
        statement = json.loads(base64.b64decode(envelope["payload"]))
        predicate = statement["predicate"]
        predicate.pop("digest")
        predicate["levels"][0]["state"] = "met"
        predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        forged = dict(envelope, payload=base64.b64encode(canonical(statement)).decode())
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


class BrokenCertificates(CertifyCase):
    """What each row of the table in docs/certify.md says of a certificate that something happened to."""

    def remade(self, change):
        """The certificate of published with its statement changed, whole by its own digest."""
        statement = json.loads(self.certificate_of("published").read_text())
        statement["predicate"].pop("digest")
        change(statement)
        statement["predicate"]["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        return self.written(canonical(statement) + b"\n")

    def of_another_axiscert(self, statement):
        plan = statement["predicate"]["materials"]["plan"]
        plan["plan"]["generators"]["tangent"]["version"] += 1
        plan["digest"] = hashlib.sha256(canonical(plan["plan"])).hexdigest()

    def of_a_file(self, statement):
        statement["predicate"]["kernel"]["kind"] = "plugin"

    def other_tallies(self, statement):
        for tally in statement["predicate"]["materials"]["tallies"]:
            tally["sha256"][0] = "0" * 64

    def happened(self, what):
        """The arguments of verify."""
        private, public = self.keys()
        plain = self.certificate_of("published")
        signed = self.certificate_of("published", "--key", private, name="signed")
        whole, envelope = plain.read_bytes(), json.loads(signed.read_text())
        forged = base64.b64encode(canonical(json.loads(self.remade(lambda s: s["predicate"]["limits"].clear()).read_text()))).decode()
        return {
            "nothing": lambda: [signed, "--key", public, "--kernel", "published", "--recheck", "1%"],
            "a word changed": lambda: [self.written(whole.replace(b'"not met"', b'"met"', 1))],
            "a signed payload or a signature changed": lambda: [self.written(canonical(dict(envelope, payload=forged))), "--key", public],
            "another key": lambda: [signed, "--key", self.keys("other")[1]],
            "no signature where a key is given": lambda: [plain, "--key", public],
            "another kernel": lambda: [plain, "--kernel", "certified"],
            "a tally that comes out otherwise": lambda: [self.remade(self.other_tallies), "--recheck", "1%"],
            "cut off": lambda: [self.written(whole[:-200])],
            "another version of the format": lambda: [self.remade(lambda s: s.update(predicateType="urn:axiscert:certificate:0"))],
            "made by another axiscert, `--recheck`": lambda: [self.remade(self.of_another_axiscert), "--recheck", "1%"],
            "a kernel that is to be rechecked and was not given": lambda: [self.remade(self.of_a_file), "--recheck", "1%"],
        }[what]()

    def test_each_row_of_the_document(self):
        page = (ROOT / "docs/certify.md").read_text()
        rows = [[cell.strip() for cell in line.strip("| \n").split(" | ")] for line in page.splitlines() if line.startswith("| ") and line.count("|") == 4]
        rows = [row for row in rows if row[1] in "012"]
        self.assertEqual(len(rows), 11)
        for what, code, said in rows:
            with self.subTest(what):
                self.verify(*self.happened(what), code=int(code), says=[said.strip("`")])


class CertifiedFiles(CertifyCase):
    def plugin(self, name="mine", fault="none"):
        path = self.folder_of(f"{name}.so")
        if not path.exists():
            shutil.copy(BUILD / f"faults/{fault}.so", path)
        return path

    def test_a_plug_in_is_known_by_its_bytes_wherever_it_lies(self):
        mine, other = self.plugin(), self.plugin("other", "wrong_sign")
        cert = self.certificate_of(f"plugin:{mine}", name="plugin")
        statement = json.loads(cert.read_text())
        self.assertEqual(statement["subject"], [{"name": "mine.so", "annotations": {"what": "plugin"},
                                                 "digest": {"sha256": hashlib.sha256(mine.read_bytes()).hexdigest()}}])
        self.assertNotIn(str(self.folder_of("")), json.dumps(statement["predicate"]["materials"]))
        self.verify(cert, says=["kernel: NOT CHECKED"])
        moved = self.folder / "moved.so"
        shutil.copy(mine, moved)
        self.verify(cert, "--kernel", moved, says=["moved.so is the one"])
        self.verify(cert, "--kernel", other, code=1, says=["NOT VALID", "it is about another kernel: the plugin of", "has the SHA-256"])
        self.verify(cert, "--kernel", "published", code=1, says=["it is about another kernel"])
        self.verify(cert, "--kernel", self.folder / "absent.so", code=2, says=["is no file, and no kernel"])
        self.verify(cert, "--recheck", "1%", code=2, says=["give the kernel that is to be run"])
        self.verify(cert, "--kernel", moved, "--recheck", "1%", says=["recheck: will run plugin:", "every tally the same"])

    def test_nobodys_code_is_run_without_a_recheck(self):
        mine = self.plugin()
        cert = self.certificate_of(f"plugin:{mine}", name="plugin")
        statement = json.loads(cert.read_text())
        marker = self.folder / "ran"
        evil = self.folder / "evil.so"
        source = self.written(b'#include <fcntl.h>\n__attribute__((constructor)) static void run(void) { open("%s", O_CREAT | O_WRONLY, 0600); }\n'
                              % str(marker).encode(), "evil.c")
        subprocess.run(["cc", "-shared", "-fPIC", source, "-o", evil], check=True)
        # A certificate that is about it, whole by its own digest: looked at, not loaded.
        predicate = statement["predicate"]
        predicate.pop("digest")
        predicate["kernel"].update(id=f"plugin:{evil}")
        statement["subject"][0]["digest"]["sha256"] = hashlib.sha256(evil.read_bytes()).hexdigest()
        predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        forged = self.written(canonical(statement) + b"\n")
        self.verify(forged)
        self.verify(forged, "--kernel", evil, says=["is the one"])
        predicate.pop("digest")
        predicate["kernel"]["kind"] = "built-in"
        predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
        self.verify(self.written(canonical(statement)), code=1, says=["this axiscert has no kernel plugin:"])
        self.assertFalse(marker.exists(), "verify has loaded a file that it was not asked to run")

    def test_replies_are_judged_as_they_are_and_known_by_their_bytes(self):
        program, files = self.folder / "program", []
        for precision, real in (("binary32", "float"), ("binary64", "double")):
            subprocess.run(["cc", "-std=c99", "-O2", "-ffp-contract=off", f"-DREAL={real}", "-o", program, ROOT / "examples/pipe/published.c"],
                           check=True)
            queries = self.folder / precision
            done = axiscert("generate", "--family", "all", "--trials", 256, "--precision", precision, "--binary", "-o", queries)
            self.assertEqual(done.returncode, 0, done.stderr)
            files.append(self.written(subprocess.run([program], input=queries.read_bytes(), capture_output=True, check=True).stdout,
                                      f"{precision}.replies"))
        given = [word for file in files for word in ("--replies", file)]
        made = []
        for threads in (1, 2):
            out = self.folder / f"replies-{threads}"
            done = axiscert("certify", *given, "--conforms-to", "published", "--effort", "smoke", "--threads", threads, "--out", out)
            self.assertEqual(done.returncode, 0, done.stdout + done.stderr)
            made.append((out / "certificate.json").read_bytes())
        self.assertEqual(*made)
        predicate = json.loads(made[0])["predicate"]
        self.assertIn("cannot be asked again", predicate["search"]["reason"])
        self.assertIn("Asked by a program's replies", (out / "certificate.txt").read_text())
        cert = out / "certificate.json"
        self.verify(cert, says=["kernel: NOT CHECKED"])
        # Their claim is in the certificate.
        self.verify(cert, *given, "--recheck", "10%", says=["will judge the replies of pipe", "every tally the same"])
        self.verify(cert, "--recheck", "10%", code=2, says=["give the replies that are to be judged again"])
        changed = bytearray(files[0].read_bytes())
        changed[-1] ^= 1
        self.verify(cert, "--replies", self.written(bytes(changed), "changed"), "--replies", files[1], code=1, says=["about other replies"])

    def test_a_program_is_its_manifest_and_its_files(self):
        folder = self.folder_of("program")
        if not folder.exists():
            folder.mkdir()
            shutil.copy(ROOT / "examples/pipe/published_c.json", folder)
            subprocess.run(["cc", "-std=c99", "-O2", "-ffp-contract=off", "-o", folder / "published", ROOT / "examples/pipe/published.c"],
                           check=True)
        manifest = folder / "published_c.json"
        cert = self.certificate_of(f"program:{manifest}", name="program-certificate")
        subjects = json.loads(cert.read_text())["subject"]
        self.assertIn("manifest", [s["annotations"]["what"] for s in subjects])
        self.assertEqual(len(subjects), 2)
        self.verify(cert, "--kernel", manifest, says=["is the one"])
        again = self.folder / "again"
        shutil.copytree(folder, again)
        with open(again / "published", "ab") as program:
            program.write(b"\0")
        self.verify(cert, "--kernel", again / manifest.name, code=1, says=["it is about another kernel", "has the SHA-256"])


if __name__ == "__main__":
    unittest.main()
