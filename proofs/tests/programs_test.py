#!/usr/bin/env python3
"""programs_test.py WRITTEN: the recorded programs and the header of proved bounds are the committed ones, and each that differs is seen,
with the difference where git has what it was made from."""
import pathlib
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import programs

WRITTEN = pathlib.Path(sys.argv.pop(1))


class Programs(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        # A tree that has what is compared, and a history of it; and what was written.
        self.root, self.written = pathlib.Path(folder.name, "root"), pathlib.Path(folder.name, "written")
        for path in ("proofs/programs.txt", programs.HEADER):
            (self.root / path).parent.mkdir(parents=True)
            shutil.copy(programs.ROOT / path, self.root / path)
        shutil.copytree(WRITTEN, self.written)

    def commit(self):
        for command in (["init", "-q"], ["add", "."], ["-c", "user.name=a", "-c", "user.email=b", "commit", "-qm", "c"]):
            subprocess.run(["git", "-C", self.root, *command], check=True)

    def digest_changed(self, name):
        path = self.root / "proofs/programs.txt"
        digest = programs.committed(self.root)[name]
        path.write_text(path.read_text().replace(digest, digest[::-1]))

    def program_changed(self, name):
        path = self.written / f"programs/{name}.txt"
        path.write_text(path.read_text() + "one more line\n")

    def report(self, name):
        """What is said of one that differs; the sources of a commit need not be built here: they gave what was written."""
        return programs.report(name, self.written, self.root, lambda root, commit: programs.recorded(WRITTEN))

    def test_what_is_committed_is_current(self):
        self.assertEqual(programs.differing(WRITTEN), [])
        self.assertGreaterEqual(len(programs.recorded(WRITTEN)), 29)

    def test_each_digest_and_each_program_that_is_changed_is_seen(self):
        self.commit()
        for name, text in programs.recorded(WRITTEN).items():
            with self.subTest(name):
                self.program_changed(name)
                self.assertEqual(programs.differing(self.written, self.root), [name])
                says = self.report(name)
                self.assertIn(text, says)
                self.assertRegex(says, rf"--- {name} of [0-9a-f]{{40}}\n\+\+\+ {name}, recorded now\n")
                self.assertTrue(says.endswith("\n+one more line\n"))
                self.digest_changed(name)  # then the difference is from the commit before it was changed by hand
                self.assertIn("changed by hand", self.report(name))
                self.assertTrue(self.report(name).endswith("\n+one more line\n"))
                shutil.copy(WRITTEN / f"programs/{name}.txt", self.written / "programs")
                self.assertEqual(programs.differing(self.written, self.root), [name])
                self.assertIn("the program is that of HEAD; the digest alone differs", self.report(name))
                shutil.copy(programs.ROOT / "proofs/programs.txt", self.root / "proofs")

    def test_without_a_history_the_program_is_shown(self):
        self.program_changed("exact")
        says = self.report("exact")
        self.assertIn("Definition recorded_exact ", says)
        self.assertIn("git has no commit", says)

    def test_programs_that_come_and_go_and_a_changed_header_are_seen(self):
        (self.written / "programs/exact.txt").rename(self.written / "programs/more.txt")
        path = self.written / programs.HEADER
        path.write_text(path.read_text().replace("128,", "129,", 1))
        self.assertEqual(programs.differing(self.written, self.root), ["exact", "more", programs.HEADER])
        self.assertIn("nothing records it", self.report("exact"))
        self.assertIn("does not have it", self.report("more"))
        self.assertIn("\n+", self.report(programs.HEADER))

    def test_nothing_written_is_an_error(self):
        done = subprocess.run([sys.executable, programs.__file__, "--written", self.root], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("./dev build proofs write_proofs", done.stderr)


if __name__ == "__main__":
    unittest.main()
