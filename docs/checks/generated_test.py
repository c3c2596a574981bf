#!/usr/bin/env python3
"""Only what a person wrote is tracked: no output of a generator but that of generated.txt, a line PATTERN :: what makes it :: the test
that holds it.

    generated_test.py ROOT [WRITTEN]     WRITTEN: what write_proofs wrote

A file counts as a generator's output by its kind, by what its first lines say, by its length, and where write_proofs writes one of its name."""
import fnmatch
import re
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(sys.argv.pop(1)).resolve()
WRITTEN = Path(sys.argv.pop(1)).resolve()
LIST = "docs/checks/generated.txt"
MOST_LINES = 15       # of generated.txt
MOST_BYTES = 40000    # of a picture
LONGEST = 1000        # lines of a file that a person wrote; the longest today has 905
KINDS = re.compile(r"\.(svg|png|pdf|g|fpcore|tex|expected|golden|jsonl|csv|vo|lock)$|/digests\.txt$|/package-lock\.json$|\.min\.js$")
SAYS = re.compile(r"do not edit|@generated|(auto|code )generated", re.I)


def tracked(root):
    """The tracked files; where there is no git, as in an archive, all but what .gitignore names."""
    listed = subprocess.run(["git", "-C", root, "ls-files", "-z"], capture_output=True, text=True)
    if listed.returncode == 0:
        return [file for file in listed.stdout.split("\0") if file and (root / file).is_file()]
    found = (path.relative_to(root).as_posix() for path in root.rglob("*") if path.is_file())
    return [file for file in found if not re.search(r"^(build|out|\.git)/|node_modules/|__pycache__/", file)]


def entries(root):
    """(pattern, what makes it, test) of each line of the list."""
    return [tuple(line.split(" :: ")) for line in (root / LIST).read_text().splitlines()]


def reason(root, file, written):
    """Why a file counts as a generator's output, or nothing."""
    text = (root / file).read_bytes()
    if KINDS.search("/" + file):
        return "its kind"
    if Path(file).name in written:
        return "write_proofs writes one of this name"
    if SAYS.search(b"\n".join(text.split(b"\n")[:5]).decode(errors="replace")):
        return "its first lines say so"
    if text.count(b"\n") > LONGEST:
        return f"it has more than {LONGEST} lines"
    return None


def faults(root, written):
    found = []
    files, listed = tracked(root), entries(root)
    if len(listed) > MOST_LINES:
        found.append(f"{LIST} has {len(listed)} lines, and at most {MOST_LINES} may be")
    for pattern, _, test in listed:
        if not fnmatch.filter(files, pattern):
            found.append(f"{LIST}: no file is {pattern}")
        if not (root / test).is_file():
            found.append(f"{LIST}: {pattern} is held by {test}, which is not there")
    for file in files:
        if not any(fnmatch.fnmatch(file, pattern) for pattern, *_ in listed) and (why := reason(root, file, written)):
            found.append(f"{file}: a generator's output ({why}): make it in the build folder, or give it a line of {LIST}")
        if file.endswith(".svg") and (size := (root / file).stat().st_size) > MOST_BYTES:
            found.append(f"{file}: {size} bytes, and a picture may have {MOST_BYTES}")
    return found


NAMES = {path.name for path in WRITTEN.rglob("*") if path.is_file()} if WRITTEN.is_dir() else set()


class Generated(unittest.TestCase):
    def test_no_tracked_file_is_a_generators_but_those_listed(self):
        self.assertGreater(len(NAMES), 50, f"{WRITTEN}: ./dev build proofs write_proofs writes it")
        self.assertEqual(faults(ROOT, NAMES), [])

    def test_each_kind_is_seen(self):
        with tempfile.TemporaryDirectory() as folder:
            root = Path(folder)
            subprocess.run(["git", "init", "-q", folder], check=True)
            texts = {LIST: "a.svg :: drawn :: test.py\n", "a.svg": "", "test.py": ""}
            planted = {"coq/Recorded.v": "", "b.fpcore": "", "x/digests.txt": "", "c.h": "// Written by c: do not edit.\n", "d.txt": "line\n" * 1001,
                       "big/a.svg": "x" * 40001}
            for file, text in (texts | planted).items():
                (root / file).parent.mkdir(parents=True, exist_ok=True)
                (root / file).write_text(text)
            subprocess.run(["git", "-C", folder, "add", "."], check=True)
            self.assertEqual(sorted({fault.split(":")[0] for fault in faults(root, {"Recorded.v"})}), sorted(planted))
            (root / LIST).write_text("a.svg :: drawn :: gone.py\nnone.* :: nobody :: test.py\n" + "*.x :: y :: test.py\n" * 14)
            says = "\n".join(faults(root, set()))
            for part in ("gone.py, which is not there", "no file is none.*", "has 16 lines"):
                self.assertIn(part, says)


if __name__ == "__main__":
    unittest.main()
