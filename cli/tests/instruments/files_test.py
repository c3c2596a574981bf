#!/usr/bin/env python3
"""Certificates of plug-ins, programs and replies: each is known by its bytes, and nobody's code is run without being asked for."""
import hashlib
import json
import shutil
import subprocess
import unittest

from certificates import CertifyCase, sealed
from command import BUILD, ROOT, axiscert


class CertifiedFiles(CertifyCase):
    def plugin(self, name="mine", file="promises/always_contact"):  # of one precision
        path = self.folder_of(f"{name}.so")
        if not path.exists():
            shutil.copy(BUILD / f"{file}.so", path)
        return path

    def test_a_plug_in_is_known_by_its_bytes_wherever_it_lies(self):
        mine, other = self.plugin(), self.plugin("other", "faults/wrong_sign")
        cert = self.certificate_of(f"plugin:{mine}", name="plugin")
        statement = json.loads(cert.read_text())
        self.assertEqual(statement["subject"], [{"name": "mine.so", "annotations": {"what": "plugin"},
                                                 "digest": {"sha256": hashlib.sha256(mine.read_bytes()).hexdigest()}}])
        self.assertNotIn(str(self.folder_of("")), json.dumps(statement["predicate"]["materials"]))
        self.verify(cert, says=["kernel: NOT CHECKED", "promises: published, certified: as they declare here; ", " NOT COMPARED: not built in"])
        moved = self.folder / "moved.so"
        shutil.copy(mine, moved)
        self.verify(cert, "--kernel", moved, says=["moved.so is the one"])
        self.verify(cert, "--kernel", other, code=1, says=["NOT VALID", "it is about another kernel: the plugin of", "has the SHA-256"])
        self.verify(cert, "--kernel", "published", code=1, says=["it is about another kernel"])
        self.verify(cert, "--kernel", self.folder / "absent.so", code=2, says=["is no file, and no kernel"])
        self.verify(cert, "publishd", code=2, says=["is no file, and no kernel; did you mean 'published'?"])
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
        predicate["kernel"].update(id=f"plugin:{evil}")
        for row in predicate["comparison"]:
            if row["kernel"] == f"plugin:{mine}":
                row["kernel"] = f"plugin:{evil}"
        statement["subject"][0]["digest"]["sha256"] = hashlib.sha256(evil.read_bytes()).hexdigest()
        forged = self.written(sealed(statement))
        self.verify(forged)
        self.verify(forged, "--kernel", evil, says=["is the one"])
        predicate["kernel"]["kind"] = "built-in"
        self.verify(self.written(sealed(statement)), code=1, says=["NOT VALID"])
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
        self.assertIn("from a program's replies, seed 1; not signed", (out / "certificate.txt").read_text())
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
