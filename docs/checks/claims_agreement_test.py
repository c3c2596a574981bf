#!/usr/bin/python3
"""claims_agreement_test.py AXISCERT: the forms and the exact answers of claims_*.py are those of `axiscert check`, comparison by comparison, bit for bit.

Both were written from the article, apart. Every form that the command has as a kernel is asked about queries of every scene.
"""
import json
import subprocess
import sys
import unittest

import numpy as np

import claims_exact as exact
import claims_forms as forms
import claims_scenes as scenes

AXISCERT = sys.argv.pop(1)
EACH = {"level": 400} | {name: 60 for name in (  # queries of a scene; one in sixty of level touches
    "grazing", "near", "sliver", "speck", "origin", "terrain", "terrain coarse", "far", "far coarse", "far-8 broad", "grazing times 2^-26",
    "grazing times 2^22", "speck times 2^-30")}


def text(columns):
    """The queries as JSON Lines."""
    def hexadecimal(numbers): return [float(x).hex() for x in numbers]
    return "".join(json.dumps({"id": str(i), "precision": "binary32", "a": hexadecimal(q[0:3]), "b": hexadecimal(q[3:6]), "c": hexadecimal(q[6:9]),
                               "p": hexadecimal(q[9:12]), "r": float(q[12]).hex()}) + "\n" for i, q in enumerate(columns.T))


def bits(held):
    return ["".join("01"[int(x)] for x in column) for column in held.T]


class Agreement(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.columns = np.concatenate([scenes.sample(name, 1, n)[0] for name, n in EACH.items()], axis=1)
        cls.some = cls.columns[:, ::4]  # for each of the forms
        listed = subprocess.run([AXISCERT, "kernels"], text=True, capture_output=True, check=True).stdout
        cls.kernels = {line.split()[0] for line in listed.splitlines() if line and ";" in line}

    def ask(self, kernel, columns):
        done = subprocess.run([AXISCERT, "check", "-", "--kernel", kernel, "--format", "jsonl"], input=text(columns), text=True, capture_output=True)
        self.assertEqual(done.returncode, 0, done.stderr)
        return [json.loads(line) for line in done.stdout.splitlines()]

    def test_every_form_that_is_a_kernel_has_the_same_bits(self):
        asked = [name for name in forms.FORMS if name in self.kernels]
        self.assertLessEqual({*forms.LADDER, "reduced", "reduced-along"}, set(asked))
        if "edges-centred-divided-squared-6" in self.kernels:  # one cell is a kernel: so are all that are no rungs
            self.assertEqual(set(asked), set(forms.FORMS) - set(forms.RUNG_OF_CELL))
        for name in asked:
            answers = [row["computed"]["comparisons"] for row in self.ask(name, self.some)]
            self.assertEqual(answers, bits(forms.comparisons(name, self.some)), name)

    def test_the_exact_answers_are_the_same(self):
        rows = self.ask("published", self.columns)
        signs, distance = exact.comparison_signs(self.columns), exact.distance_sign(self.columns)
        self.assertEqual([row["exact"]["comparisons"] for row in rows], bits(signs > 0))
        self.assertEqual([row["exact"]["ties"] for row in rows], bits(signs == 0))
        self.assertEqual([row["exact"]["verdict"] == "separated" for row in rows], list(distance > 0))
        self.assertEqual([row["exact"]["touching"] for row in rows], list(distance == 0))
        # Neither list is of one kind.
        self.assertTrue((signs == 0).any() and (distance == 0).any() and (distance > 0).any() and (distance < 0).any())


if __name__ == "__main__":
    unittest.main()
