#!/usr/bin/env python3
"""Compares what is committed of the output of write_proofs with what it wrote: programs.txt, a line of SHA-256 and name for each program
that is recorded from the kernel's sources, and kernel/sphere_triangle/proved_bounds.h.

  programs.py [--written DIR]           fails where they differ. Of a program it prints what is recorded now and, where git has the
                                        sources that the committed digest was made from, the difference from what those give
  programs.py --update [--written DIR]  writes both files

Exit status: 0 they are the same, or are written; 1 they differ; 2 the target write_proofs has not been built."""
import argparse
import difflib
import functools
import hashlib
import pathlib
import subprocess
import sys
import tempfile

from names import ROOT, written_proofs

HEADER = "kernel/sphere_triangle/proved_bounds.h"


def digest_of(text):
    return hashlib.sha256(text.encode()).hexdigest()


def recorded(written):
    """The text of each program by its name."""
    return {path.stem: path.read_text() for path in sorted((written / "programs").glob("*.txt"))}


def digests_in(text):
    return {name: digest for digest, name in (line.split() for line in text.splitlines())}


def committed(root=ROOT):
    return digests_in((root / "proofs" / "programs.txt").read_text())


def differing(written, root=ROOT):
    """The names of the programs that are not those of programs.txt, and the header where it is not current."""
    now, then = recorded(written), committed(root)
    names = [name for name in sorted(now.keys() | then.keys()) if name not in now or digest_of(now[name]) != then.get(name)]
    return names + ([HEADER] if (written / HEADER).read_text() != (root / HEADER).read_text() else [])


def git(root, *arguments):
    """Standard output, or nothing where git is missing or refuses."""
    try:
        return subprocess.run(["git", "-C", root, *arguments], capture_output=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return b""


def commit_of(root, digest):
    """The first commit whose programs.txt has the digest, or nothing."""
    found = git(root, "log", "--format=%H", f"-S{digest}", "--", "proofs/programs.txt").decode().split()
    return found[-1] if found else None


@functools.cache
def recorded_at(root, commit):
    """The programs recorded from the sources of a commit, which are built for it."""
    with tempfile.TemporaryDirectory() as folder:
        sources, build = pathlib.Path(folder, "sources"), pathlib.Path(folder, "build")
        sources.mkdir()
        subprocess.run(["tar", "-x", "-C", sources], input=git(root, "archive", commit), check=True)
        for step in (["cmake", "-S", sources, "-B", build, "-G", "Ninja", "-DAXISCERT_ONLY_PROOFS=ON"], ["cmake", "--build", build]):
            done = subprocess.run(step, capture_output=True, text=True)
            if done.returncode:
                raise RuntimeError(f"the sources of {commit} do not build: {done.stdout}{done.stderr}")
        return recorded(build / "written_proofs")


def difference(old, new, old_name, new_name):
    return "".join(difflib.unified_diff(old.splitlines(True), new.splitlines(True), old_name, new_name))


def report(name, written, root, at=recorded_at):
    """What there is to say of one that differs."""
    if name == HEADER:
        return f"{HEADER} is not current:\n" + difference((root / HEADER).read_text(), (written / HEADER).read_text(), "committed", "written now")
    now, then = recorded(written), committed(root)
    if name not in now:
        return f"{name}: programs.txt has it, and nothing records it\n"
    says = f"{name}: recorded now, with the digest {digest_of(now[name])}:\n{now[name]}"
    if name not in then:
        return says + f"{name}: programs.txt does not have it\n"
    digest = then[name]
    commit = commit_of(root, digest)
    if not commit:
        says += f"{name}: git has no commit whose programs.txt has {digest}: it was changed by hand, or the history is not all here\n"
        digest = digests_in(git(root, "show", "HEAD:proofs/programs.txt").decode()).get(name)
        if digest == digest_of(now[name]):
            return says + f"{name}: the program is that of HEAD; the digest alone differs\n"
        commit = commit_of(root, digest) if digest else None
    return says + (difference(at(root, commit)[name], now[name], f"{name} of {commit}", f"{name}, recorded now") if commit else "")


def update(written):
    lines = (f"{digest_of(text)}  {name}\n" for name, text in recorded(written).items())
    (ROOT / "proofs" / "programs.txt").write_text("".join(lines))
    (ROOT / HEADER).write_text((written / HEADER).read_text())


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--written", type=pathlib.Path, help="where write_proofs wrote; default: where it did last")
    parser.add_argument("--update", action="store_true")
    options = parser.parse_args()
    written = written_proofs(options.written)
    if options.update:
        update(written)
        return
    names = differing(written)
    for name in names:
        print(report(name, written, ROOT), end="")
    if names:
        print(f"programs.py: not current: {', '.join(names)}. Where the change is meant, ./dev prove says whether it is proved, and "
              "proofs/programs.py --update writes it", file=sys.stderr)
        sys.exit(1)
    print(f"{len(recorded(written))} programs and {HEADER} are what is committed")


if __name__ == "__main__":
    main()
