#!/usr/bin/env python3
"""Checks the Coq theory: builds it, compares each main theorem's axioms and statement with theorems.txt, and refuses admitted steps.
The theory is proofs/coq, what write_proofs recorded from the kernel's sources, and what write_thresholds.py exports. It is built in
build/proofs/coq; files that have not changed since the last time are not built again. Where everything holds, prove.json beside that folder
has each main theorem's name, axioms and statement, and for each step of the certified predicate what is proved, recorded, on paper,
tested and trusted: the table of docs/proofs.md.

  prove.py             checks the whole theory
  prove.py --emitted   checks, in a minute, that what is emitted is what is proved: every statement, and the proofs of those about the
                       recorded formulae and exported thresholds
  prove.py --planted   after that: checks that each planted fault is refused, at the file named
  prove.py --update    checks the whole theory, and writes what Coq prints of the names in theorems.txt there

Exit status: 0 everything holds; 1 something does not; 2 coqc or Flocq is missing, or the target write_proofs has not been built."""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

import theorems
import write_thresholds
from faults import FAULTS, WEAKENED
from names import written_proofs
from programs import git

SOURCES = pathlib.Path(__file__).resolve().parent / "coq"
THEOREMS = SOURCES.parent / "theorems.txt"
# The page with the table of the certified predicate's steps.
PAGE = SOURCES.parents[1] / "docs" / "proofs.md"
STEP_COLUMNS = ["step", "proved", "recorded", "on paper", "tested", "trusted"]
# Everything that would let a theorem rest on something unproved. Print Assumptions decides; this names the line.
FORBIDDEN = re.compile(r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|bypass_check|Unset\s+\w+\s+Checking)\b")

# Each file of the theory, by its name, with its folder, in an order in which each comes after what it imports. Imports name no folder,
# so no two files have the same name.
PATHS = {path.rsplit("/", 1)[-1]: path for path in (SOURCES / "_CoqProject").read_text().split() if path.endswith(".v")}

# Where the theory meets what is generated: the recorded formulae are those of the theorems, the exported thresholds are
# the proved ones.
EMITTED = ["RecordedIsSat7.v", "RecordedIsProgram.v", "Exported.v", "RecordedIsCertified.v", "CoarseKnown.v", "ExactStep.v", "ExactVerdict.v", "Balls.v", "FineStep.v",
           "FineKnown.v", "RecordedIsDeep.v", "RecordedIsBox.v", "BlocksAreRight.v", "WindowsAreRight.v", "RecordedIsConservative.v"]


def fail(message):
    print(f"prove: {message}", file=sys.stderr)
    sys.exit(1)


def theory(written):
    """The text of each file of the theory by its path: written by hand, recorded, and exported."""
    found = {path.relative_to(folder).as_posix(): path.read_text() for folder in (SOURCES, written / "coq") for path in folder.rglob("*.v")}
    found["Exported.v"] = write_thresholds.exported(SOURCES)["Exported.v"]
    if set(found) != set(PATHS.values()):
        fail(f"_CoqProject and the theory have different files: {sorted(set(found) ^ set(PATHS.values()))}")
    return found | {"_CoqProject": (SOURCES / "_CoqProject").read_text()} | theorems.asking(theorems.read(THEOREMS), map(stem, PATHS))


def stem(file):
    return file.removesuffix(".v")


def write_changed(files, build):
    """Writes the files to `build`, keeping the times of those that are unchanged, for make. A file that is gone or has moved leaves
    nothing behind: coqc refuses an import that it finds in two folders."""
    for built in build.rglob("*.v*"):
        if built.relative_to(build).with_suffix(".v").as_posix() not in files:
            built.unlink()
    for name, text in files.items():
        target = build / name
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_text() != text:
            target.write_text(text)


def without_comments(text):
    depth, kept = 0, []
    for token in re.split(r"(\(\*|\*\)|\n)", text):
        if token == "(*":
            depth += 1
        elif token == "*)":
            depth -= 1
        elif depth == 0 or token == "\n":
            kept.append(token)
    return "".join(kept)


def refuse_unproved(files):
    for file in PATHS.values():
        for number, line in enumerate(without_comments(files[file]).splitlines(), 1):
            if found := FORBIDDEN.search(line):
                fail(f"{file}:{number}: '{found.group()}': every step has to be proved")


def definers(files):
    """The files that define each name."""
    defined = {}
    for file in PATHS.values():
        for name in re.findall(r"^\s*(?:Definition|Fixpoint|Inductive|Record|Lemma|Theorem|Corollary)\s+([\w']+)", without_comments(files[file]), re.M):
            defined.setdefault(name, []).append(file)
    return defined


def refuse_ambiguous(files):
    """A name in theorems.txt that two files define says which is printed: Coq takes the one that was imported last, and the other could
    be weakened unseen."""
    defined, held = definers(files), theorems.read(THEOREMS)
    for name in [*held.theorems, *held.definitions]:
        if len(found := defined.get(name, ())) > 1:
            fail(f"theorems.txt has '{name}', which {' and '.join(found)} define: say which, '{stem(found[0].rsplit('/', 1)[-1])}.{name}'")


def coqc(build, file, *flags):
    return subprocess.run(["coqc", "-q", "-Q", ".", "Axiscert", *flags, file], cwd=build, text=True, capture_output=True)


def make(build, jobs, *targets):
    subprocess.run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], cwd=build, check=True)
    result = subprocess.run(["make", "--no-print-directory", f"-j{jobs}", *targets], cwd=build, text=True,
                            capture_output=True)
    if result.returncode:
        fail(f"the theory does not check:\n{result.stdout}{result.stderr}")


def printed_by(build, file, *flags):
    """What Coq prints of each name that theorems.txt has: Statements.v, Assumptions.v."""
    result = coqc(build, file, *flags)
    if result.returncode:
        fail(f"{file}, which asks Coq for what theorems.txt holds, does not check:\n{result.stdout}{result.stderr}")
    return theorems.by_name(result.stdout)


def statements(build, *flags):
    """The statement of each main theorem and the text of each definition, as Coq prints them."""
    return {name: theorems.statement_in(name, text) for name, text in printed_by(build, "Statements.v", *flags).items()}


def changed_statements(printed):
    """The theorems and definitions of what Coq printed that differ from theorems.txt, with what they say now and should: a definition's
    text, and a digest."""
    held, changed = theorems.read(THEOREMS), {}
    for name, says in printed.items():
        should, is_theorem = (held.theorems[name][1], True) if name in held.theorems else (held.definitions[name], False)
        if (says if is_theorem else theorems.digest_of(says)) != should:
            changed[name] = (says, should)
    return changed


def require_statements(files, printed):
    for name, (says, should) in changed_statements(printed).items():
        if name in theorems.read(THEOREMS).theorems:
            fail(f"{name} says\n  {says}\nand should, by theorems.txt,\n  {should}")
        fail(f"{name} is now\n  {says}\nwhich is not the definition of theorems.txt, {should}{difference(files, name, should)}")


def difference(files, name, digest):
    """How the file that has a definition has changed since the commit that recorded its digest, where git can tell."""
    paths = [f"proofs/coq/{file}" for file in definers(files).get(name.rsplit(".", 1)[-1], ())]
    commits = git(SOURCES, "log", "--format=%H", f"-S{digest}", "--", str(THEOREMS)).decode().split() if digest and paths else []
    return "".join(f"\n{git(SOURCES.parents[1], 'diff', commit, '--', *paths).decode()}" for commit in commits[-1:])


def compare(files, build):
    """Prints a line for each main theorem, and writes prove.json, with statements and axioms, where everything holds."""
    held, says = theorems.read(THEOREMS), statements(build)
    listed = []
    for name, text in printed_by(build, "Assumptions.v").items():
        axioms, should = theorems.axioms_in(text), [held.axioms[letter] for letter in held.theorems[name][0] or ""]
        if sorted(axioms) != sorted(should):
            fail(f"{name} depends on\n  {axioms}\nand should, by theorems.txt, depend on\n  {should}")
        shown = [re.match(r"[\w.]+\.(\w+) :", axiom)[1] for axiom in axioms]
        listed.append({"name": name, "axioms": shown, "statement": f"{name} : {says[name]}"})
        print(f"proved  {name:36} {', '.join(shown) or 'no axioms'}")
    require_statements(files, says)
    version = subprocess.run(["coqc", "--print-version"], text=True, capture_output=True).stdout.split()
    text = json.dumps({"schema": "axiscert-theorems/3", "coq": version[0], "theorems": listed, "steps": certified_steps()}, indent=1)
    (build.parent / "prove.json").write_text(text + "\n")


def update(build):
    held = theorems.read(THEOREMS)
    says, assumed = statements(build), printed_by(build, "Assumptions.v")
    letters = {axiom: letter for letter, axiom in held.axioms.items()}
    for name in held.theorems:
        axioms = theorems.axioms_in(assumed[name])
        if unknown := [axiom for axiom in axioms if axiom not in letters]:
            fail(f"{name} depends on an axiom that theorems.txt does not list: {unknown[0]}")
        held.theorems[name] = ("".join(sorted(letters[axiom] for axiom in axioms)), says[name])
    held.definitions = {name: theorems.digest_of(says[name]) for name in held.definitions}
    THEOREMS.write_text(held.text())


def certified_steps():
    """The rows of the table of docs/proofs.md, by column; docs.records asks that the theorems named there are main ones."""
    page = PAGE.read_text().split("## The certified predicate, step by step", 1)[1].split("\n## ", 1)[0]
    head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in page.splitlines() if line.startswith("|")]
    if head != STEP_COLUMNS or not rows:
        fail(f"{PAGE}: the table of the steps has the columns {head}, and should have {STEP_COLUMNS}")
    return [dict(zip(head, row, strict=True)) for row in rows]


def check_emitted(files, build, jobs):
    """`-vos` reads definitions and statements and leaves out the proofs; `-vok` checks the proofs of one file with no more
    of the others than that."""
    make(build, jobs, "vos")
    require_statements(files, statements(build, "-vok"))
    for file in EMITTED:
        result = coqc(build, PATHS[file], "-vok")
        if result.returncode:
            fail(f"{file}: what is emitted is not what is proved:\n{result.stdout}{result.stderr}")
        print(f"emitted is proved  {file}")


def planted_copy(build, name, file, old, new):
    """A copy of the build, with its times, in which one file is changed, so that only what depends on that file is
    built again."""
    if file not in PATHS:
        fail(f"the fault '{name}': the theory has no file {file}")
    planted = build.parent / "planted"
    shutil.rmtree(planted, ignore_errors=True)
    shutil.copytree(build, planted)
    text = (planted / PATHS[file]).read_text()
    if old not in text:
        fail(f"the fault '{name}': '{old}' is not in {file}")
    (planted / PATHS[file]).write_text(text.replace(old, new))
    return planted


def plant(build):
    for name, (file, old, new, refused_at) in FAULTS.items():
        planted = planted_copy(build, name, file, old, new)
        # The statements of the others and the proofs of this file.
        result = subprocess.run(["make", "--no-print-directory", PATHS[refused_at] + "ok"], cwd=planted, text=True,
                                capture_output=True)
        where = re.search(r'File "\./([\w/]+\.v)", line (\d+)', result.stderr)
        if result.returncode == 0 or not where or where.group(1) != PATHS[refused_at]:
            fail(f"{name}: should be refused at {refused_at}\n{result.stdout}{result.stderr}")
        print(f"refused {name:50} {where.group(1)}:{where.group(2)}")
    for name, (file, old, new, weaker) in WEAKENED.items():
        planted = planted_copy(build, name, file, old, new)
        # The statements of all, and the proofs of this file: those of files that use the theorem may fail then.
        make(planted, 1, "vos", PATHS[file] + "ok")
        if set(changed := changed_statements(statements(planted, "-vok"))) != {weaker}:
            fail(f"{name}: only {weaker} should differ from theorems.txt, but {sorted(changed)} do")
        print(f"seen    {name:50} theorems.txt, {weaker}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=SOURCES.parents[1] / "build" / "proofs" / "coq")
    parser.add_argument("--written", type=pathlib.Path, help="where write_proofs wrote; default: where it did last")
    parser.add_argument("--jobs", type=int, default=1)
    what = parser.add_mutually_exclusive_group()
    for option in ("--emitted", "--planted", "--update"):
        what.add_argument(option, action="store_true")
    options = parser.parse_args()
    if not shutil.which("coqc"):
        print("prove: NOT CHECKED: coqc is missing; install the Debian packages coq and libcoq-flocq", file=sys.stderr)
        sys.exit(2)
    files = theory(written_proofs(options.written))
    refuse_unproved(files)
    refuse_ambiguous(files)
    write_changed(files, options.build)
    (options.build.parent / "prove.json").unlink(missing_ok=True)
    if options.emitted:
        check_emitted(files, options.build, options.jobs)
        return
    make(options.build, options.jobs)
    if options.planted:
        plant(options.build)
    elif options.update:
        update(options.build)
    else:
        compare(files, options.build)


if __name__ == "__main__":
    main()
