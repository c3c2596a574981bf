#!/usr/bin/env python3
"""theorems_test.py WRITTEN: theorems.txt is read as it is written, and the faults that `prove.py --planted` plants are there to plant.
What needs no Coq; the theory itself is checked by proofs.coq, proofs.coq_emitted and proofs.coq_planted."""
import contextlib
import io
import pathlib
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import prove
import theorems
from faults import FAULTS, WEAKENED

WRITTEN = pathlib.Path(sys.argv.pop(1))


def refusal(run, *arguments):
    """What is said where `run` exits."""
    says = io.StringIO()
    with contextlib.redirect_stderr(says):
        try:
            run(*arguments)
        except SystemExit as exit:
            return says.getvalue() + str(exit.code)
    return ""


class Theorems(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.path = pathlib.Path(folder.name, "theorems.txt")

    def test_it_is_read_as_it_is_written(self):
        held = theorems.read(prove.THEOREMS)
        self.assertEqual(held.text(), prove.THEOREMS.read_text())
        self.assertGreaterEqual(len(held.theorems), 102)
        self.assertEqual({letter for letters, _ in held.theorems.values() for letter in letters} - set(held.axioms), set())

    def test_a_new_name_waits_for_an_update_and_another_line_is_refused(self):
        text = prove.THEOREMS.read_text()
        self.path.write_text(text.replace("\nsat7_exact [", "\nanew\nsat7_exact [").replace("\nvec ", "\nnew_one\nvec "))
        held = theorems.read(self.path)
        self.assertEqual((held.theorems["anew"], held.definitions["new_one"]), ((None, None), None))
        self.path.write_text(text.replace("sat7_exact [", "sat7_exact ("))
        self.assertIn("'sat7_exact (dfn]", refusal(theorems.read, self.path))
        self.path.write_text(text.replace("\n\n", "\n", 1))
        self.assertIn("three parts", refusal(theorems.read, self.path))

    def test_what_coq_prints_is_taken_apart(self):
        printed = "== f\nf : nat ->\n  nat\n== M.g\nAxioms:\na.b : P\n  Q\nc : R\n== h\nClosed under the global context\n"
        pieces = theorems.by_name(printed)
        self.assertEqual(theorems.statement_in("f", pieces["f"]), "nat -> nat")
        self.assertEqual(theorems.axioms_in(pieces["M.g"]), ["a.b : P Q", "c : R"])
        self.assertEqual(theorems.axioms_in(pieces["h"]), [])

    def test_a_name_that_two_files_define_says_which(self):
        files = prove.theory(WRITTEN)
        prove.refuse_ambiguous(files)
        files["numbers/Vectors.v"] += "Definition never_lies := 1.\n"
        self.assertIn("theorems.txt has 'never_lies'", refusal(prove.refuse_ambiguous, files))

    def test_an_admitted_step_is_refused_at_its_line(self):
        files = prove.theory(WRITTEN)
        prove.refuse_unproved(files)
        files["numbers/Sat7.v"] = "(* Admitted. *)\nAdmitted.\n"
        self.assertIn("numbers/Sat7.v:2: 'Admitted'", refusal(prove.refuse_unproved, files))


class Faults(unittest.TestCase):
    def test_each_has_its_place(self):
        files = prove.theory(WRITTEN)
        for name, (file, old, new, seen) in {**FAULTS, **WEAKENED}.items():
            with self.subTest(name):
                self.assertIn(old, files[prove.PATHS[file]])
                self.assertNotEqual(old, new)
                self.assertTrue(seen in prove.PATHS or seen in theorems.read(prove.THEOREMS).definitions
                                or seen in theorems.read(prove.THEOREMS).theorems)

    def test_one_whose_file_is_missing_is_an_error(self):
        self.assertIn("the theory has no file Gone.v", refusal(prove.planted_copy, self, "a fault", "Gone.v", "x", "y"))


if __name__ == "__main__":
    unittest.main()
