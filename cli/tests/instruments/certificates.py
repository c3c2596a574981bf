"""Parts that the tests of `certify` and `verify` share: certificates that are made once, keys, and files that were written by hand."""
import hashlib
import json
import shutil
import subprocess
import tempfile
from pathlib import Path

from command import Case, axiscert


def openssl(*args, stdin=None):
    return subprocess.run(["openssl", *map(str, args)], input=stdin, capture_output=True, check=True).stdout


def canonical(value):
    return json.dumps(value, sort_keys=True, separators=(",", ":"), ensure_ascii=False).encode()


def sealed(statement):
    """The statement's bytes, whole by its own digests: whoever forges one can make these too."""
    predicate = statement["predicate"]
    plan = predicate["materials"]["plan"]
    plan["digest"] = hashlib.sha256(canonical(plan["plan"])).hexdigest()
    predicate.pop("digest", None)
    predicate["digest"] = hashlib.sha256(canonical(statement)).hexdigest()
    return canonical(statement) + b"\n"


def without_family(predicate, family=None):
    """Leaves a family, or one of which no critical radius was sampled, out of the plan and of everything that is counted."""
    materials = predicate["materials"]
    sampled = {tally["of"].split()[0] for tally in materials["tallies"] if any("critical_radius" in counts for counts in tally["counts"])}
    family = family or next(name for name in materials["plan"]["plan"]["families"] if name not in sampled)
    kept = [tally for tally in materials["tallies"] if not tally["of"].startswith(family + " ")]
    materials["tallies"] = [dict(tally, stretch=i) for i, tally in enumerate(kept)]
    plan = materials["plan"]["plan"]
    plan["families"].remove(family)
    plan["generators"].pop(family)
    plan["trials"].pop(family)
    for entry in materials["kernels"]:
        entry["families"].pop(family, None)


class CertifyCase(Case):
    """A certificate is made once for each kernel."""

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

    def signed(self):
        """The certificate of published with a signature, and the key that checks it: what was asked is not asked again."""
        private, public = self.keys()
        out = self.folder_of("signed")
        if not out.exists():
            shutil.copytree(self.certificate_of("published").parent, out)
            (out / "certificate.json").unlink()
            self.certify("published", "--key", private, "--resume", out=out)
        return out / "certificate.json", public

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

    def remade(self, change, kernel="published", what=None):
        """The certificate of a kernel with its predicate changed, and `what` its subject is; whole by its own digests."""
        statement = json.loads(self.certificate_of(kernel).read_text())
        change(statement["predicate"])
        for subject in statement["subject"] if what else []:
            subject["annotations"]["what"] = what
        return self.written(sealed(statement))

    def keys(self, name="key"):
        private, public = self.folder_of(name + ".pem"), self.folder_of(name + ".pub")
        if not private.exists():
            openssl("genpkey", "-algorithm", "ed25519", "-out", private)
            openssl("pkey", "-in", private, "-pubout", "-out", public)
        return private, public
