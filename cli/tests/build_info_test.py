#!/usr/bin/env python3
"""What a run says of its build: the flags of its kernels, and the revision."""
import re
import shutil
import subprocess
import unittest

from command import BUILD, ROOT, Case, axiscert, json

# The libraries whose objects are kernels, or evaluate their formulae.
KERNELS = r"^build kernel/CMakeFiles/axiscert_(?:kernel|arithmetics|mutants|called)\.dir/(\S+)\.o:.*\n(?:  .*\n)*?  FLAGS = (.*)$"


def commit(tree):
    """The commit of the tree, or unknown where git cannot tell it."""
    git = subprocess.run(["git", "-C", tree, "rev-parse", "HEAD"], capture_output=True, text=True) if shutil.which("git") else None
    return git.stdout.strip() if git and git.returncode == 0 and (tree / ".git").exists() else "unknown"


class BuildInfo(Case):
    def info(self):
        self.run_ok("--kernel", "published", "--family", "general", "--trials", 8, "--precision", "binary32")
        return json.loads((self.folder / "out/run.json").read_text())

    def test_its_flags_are_those_of_every_kernel(self):
        said = self.info()["flags"].split()
        self.assertIn("-ffp-contract=off", said)
        compiled = re.findall(KERNELS, (BUILD / "build.ninja").read_text(), re.M)
        self.assertGreater(len(compiled), 5)
        for source, flags in compiled:
            self.assertEqual([flag for flag in said if flag not in flags.split()], [], source)
            # No flag beside those changes a rounding.
            self.assertEqual(re.findall(r"-ffast-math|-Ofast|-funsafe\S*|-march\S*|-mfma|-ffp-contract=(?!off)\S*", flags), [], source)

    def test_the_revision_is_a_commit_of_the_tree(self):
        said = re.fullmatch(r"axiscert \S+ \(revision (\w+)(?:-dirty)?\)\n", axiscert("--version").stdout)[1]
        self.assertEqual(self.info()["revision"].removesuffix("-dirty"), said)
        if commit(ROOT) == "unknown":
            self.assertEqual(said, "unknown")
        else:  # of the tree, or of one before it that was built
            subprocess.run(["git", "-C", ROOT, "merge-base", "--is-ancestor", said, "HEAD"], check=True)

    def test_a_record_has_none(self):
        """Else it would be another one after each commit."""
        self.info()
        self.assertNotIn("revision", (self.folder / "out/record.json").read_text())


class Revision(Case):
    def written(self, tree, given="", **more):
        out = self.folder / "revision.cpp"
        done = subprocess.run([shutil.which("cmake"), f"-DROOT={tree}", f"-DGIVEN={given}", f"-DOUTPUT={out}", "-P", ROOT / "cmake/revision.cmake"],
                              capture_output=True, text=True, **more)
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        return re.search(r'axiscert_revision = "(.*)";', out.read_text())[1]

    def git(self, *args):
        subprocess.run(["git", "-c", "user.name=a", "-c", "user.email=a@example.org", "-C", self.tree, *args], check=True, capture_output=True)

    def test_a_tree_without_a_repository_of_its_own_is_unknown(self):
        self.assertEqual(self.written(self.folder), "unknown")
        self.assertEqual(self.written(self.folder, given="1.0-1"), "1.0-1")

    @unittest.skipUnless(shutil.which("git"), "git is not installed")
    def test_a_repository_says_its_commit_and_whether_the_tree_differs(self):
        self.tree = self.folder / "tree"
        (self.tree / "below").mkdir(parents=True)
        (self.tree / "below/a").write_text("1")
        self.git("init", "-q")
        self.git("add", ".")
        self.git("commit", "-q", "-m", "a")
        self.assertRegex(self.written(self.tree), "^[0-9a-f]{40}$")
        self.assertEqual(self.written(self.tree), commit(self.tree))
        self.assertEqual(self.written(self.tree / "below"), "unknown", "unpacked in the repository of something else")
        (self.tree / "new").write_text("2")
        self.assertEqual(self.written(self.tree), commit(self.tree) + "-dirty")

    def test_it_is_written_where_it_changes_alone(self):
        self.written(self.folder)
        before = (self.folder / "revision.cpp").stat().st_mtime_ns
        self.written(self.folder)
        self.assertEqual((self.folder / "revision.cpp").stat().st_mtime_ns, before)


if __name__ == "__main__":
    unittest.main()
