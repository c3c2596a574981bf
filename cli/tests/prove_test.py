#!/usr/bin/env python3
"""`axiscert prove`: which bounds it calls proved, by which checkers, and its answer where a checker is missing."""
import json
import os
import shutil
import stat
import unittest
from unittest import mock

import jsonschema

from command import ROOT, Case, axiscert, schema_of

KERNELS = ("published", "published+fma", "reduced", "reduced+fma")


class Prove(Case):
    """Real checkers take minutes (ctest's proofs.* run them); here a program that accepts or refuses replaces each."""

    def checker(self, name, refuses="no-such-text"):
        """A program of that name, alone with /usr/bin's, that accepts every file except those that contain `refuses`."""
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        path = folder / name
        path.write_text('#!/bin/sh\n[ "$1" = --version ] && { echo "stand-in %s 0"; exit 0; }\n'
                        'for last; do :; done\n! grep -q -e "%s" "$last"\n' % (name, refuses))
        path.chmod(path.stat().st_mode | stat.S_IXUSR)

    def prove(self, *args, code=0):
        """proofs.json of a run that finds no checkers but the stand-ins; valid by the schema, and equal to the printed text."""
        folder = self.folder / "bin"
        folder.mkdir(exist_ok=True)
        for tool in ("sh", "grep"):
            if not (folder / tool).exists():
                (folder / tool).symlink_to(shutil.which(tool))
        with mock.patch.dict(os.environ, PATH=str(folder)):
            done = axiscert("prove", *args, "--format", "json", "--out", self.folder / "out")
        self.assertEqual(done.returncode, code, done.stderr)
        data = json.loads(done.stdout)
        schema = schema_of("proofs")
        jsonschema.validators.validator_for(schema)(schema).validate(data)
        self.assertEqual(json.loads((self.folder / "out/proofs.json").read_text()), data)
        return data

    def test_without_checkers_nothing_counts_as_checked(self):
        data = self.prove()
        self.assertEqual(data["checkers"], {"gappa": "NOT CHECKED", "coq": "NOT CHECKED"})
        self.assertEqual({b["status"] for b in data["bounds"]}, {"NOT CHECKED"})
        self.assertEqual(len(data["bounds"]), 16 * len(KERNELS) * 2 * 2)
        self.assertEqual({b["kernel"] for b in data["bounds"]}, set(KERNELS))
        for b in data["bounds"]:
            self.assertIn(b["comparison"], (self.folder / "out" / b["file"]).read_text().partition("\n")[0])

    def test_each_checker_has_its_word(self):
        self.checker("gappa")
        data = self.prove("--precision", "binary64")
        self.assertEqual({(b["domain"], b["status"]) for b in data["bounds"]}, {("scaled", "NOT CHECKED"), ("absolute", "open")})
        self.checker("coqc")
        data = self.prove("--precision", "binary64")
        self.assertEqual(data["checkers"], {"gappa": "stand-in gappa 0", "coq": "stand-in coqc 0"})
        self.assertEqual({(b["domain"], b["status"]) for b in data["bounds"]}, {("scaled", "proved"), ("absolute", "open")})
        self.assertEqual({b["precision"] for b in data["bounds"]}, {"binary64"})
        data = self.prove("--precision", "binary64", "--without-coq")
        self.assertEqual(data["checkers"]["coq"], "NOT CHECKED")
        self.assertNotIn("proved", {b["status"] for b in data["bounds"]})

    def test_what_a_checker_refuses_fails(self):
        self.checker("coqc")
        self.checker("gappa", refuses="edge_ab.side_c of reduced, plain, binary32, on the scaled")
        data = self.prove("--precision", "binary32", code=1)
        refused = [(b["kernel"], b["comparison"], b["domain"]) for b in data["bounds"] if b["status"] == "refused"]
        self.assertEqual(refused, [("reduced", "edge_ab.side_c", "scaled")])
        # A script that two kernels share is refused for both.
        self.checker("gappa", refuses="plane.radius of published, plain, binary32, on the absolute")
        data = self.prove("--precision", "binary32", code=1)
        refused = [(b["kernel"], b["comparison"], b["domain"]) for b in data["bounds"] if b["status"] == "refused"]
        self.assertEqual(refused, [(k, "plane.radius", "absolute") for k in ("published", "reduced")])
        # Without its ranges no bound is proved.
        self.checker("gappa")
        self.checker("coqc", refuses="RangesClaimed.v\\|Theorem exact_V_x")
        data = self.prove("--precision", "binary32", code=1)
        self.assertEqual({b["status"] for b in data["bounds"]}, {"refused"})

    def test_bounds_and_ratios(self):
        bounds = {(b["kernel"], b["comparison"]): b for b in self.prove("--precision", "binary32")["bounds"]
                  if b["domain"] == "scaled"}
        for (kernel, comparison), b in bounds.items():
            if b["attained_u"] is None:
                self.assertIsNone(b["ratio"])
            else:
                self.assertLessEqual(b["attained_u"], b["bound_u"], (kernel, comparison))
                self.assertAlmostEqual(b["ratio"], b["bound_u"] / b["attained_u"])
            fused = bounds[kernel.removesuffix("+fma") + "+fma", comparison]
            self.assertLessEqual(fused["bound_u"], b["bound_u"])
        for comparison in ("plane.radius", "vertex_a.radius", "vertex_c.side_b"):  # the same program
            self.assertEqual(bounds["reduced", comparison] | {"kernel": "published"}, bounds["published", comparison])
        self.assertEqual(bounds["published", "vertex_a.radius"]["bound_u"], 8)
        self.assertLess(bounds["reduced", "edge_ab.side_c"]["bound_u"], bounds["published", "edge_ab.side_c"]["bound_u"] / 40)

    def test_text(self):
        with mock.patch.dict(os.environ, PATH=str(self.folder)):
            text = axiscert("prove", "--precision", "binary32").stdout
        self.assertIn("gappa: NOT CHECKED\ncoq: NOT CHECKED\n", text)
        self.assertRegex(text, r"published +binary32 +scaled +vertex_a.radius +bound +8.00 u +attained +7.99 +ratio +1.001 +NOT CHECKED")
        self.assertEqual(len(text.splitlines()), 2 + 16 * len(KERNELS) * 2)

    def test_bad_input(self):
        self.refused("prove", "--precision", "binary16", says=["binary16"])
        self.refused("prove", "--format", "xml", says=["--format"])
        self.refused("prove", "nothing", says=["nothing"])
        self.refused("prove", "--out", "/dev/null/x", says=["/dev/null/x"])
        self.checker("gappa")
        self.checker("coqc")
        with mock.patch.dict(os.environ, PATH=str(self.folder / "bin")):
            self.refused("prove", "--proofs", self.folder, says=["coq/formulae/Ranges.v: cannot be read"])


if __name__ == "__main__":
    unittest.main()
