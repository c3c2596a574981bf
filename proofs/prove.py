#!/usr/bin/env python3
"""Checks the Coq theory in proofs/coq: builds it, compares the assumptions of each main theorem with
Assumptions.expected and its statement with Statements.expected, and refuses admitted steps. coqc writes beside its
sources, so a copy is built, in build/proofs; files that have not changed since the last time are not built again.
Where everything holds, prove.json beside the copy has each main theorem's name, axioms and statement, and for each step of
the certified predicate what is proved, recorded, on paper, tested and trusted: the table of docs/proofs.md.

  prove.py [--build DIR] [--jobs N]            checks the whole theory
  prove.py --emitted [--build DIR] [--jobs N]  checks, in a minute, that what is emitted is what is proved: every statement,
                                               and the proofs of those about the recorded formulae and exported thresholds
  prove.py --planted [--build DIR]             after that: checks that each planted fault is refused, at the file named

Exit status: 0 everything holds, 1 something does not, 2 coqc or Flocq is missing."""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

SOURCES = pathlib.Path(__file__).resolve().parent / "coq"
# The page with the table of the certified predicate's steps.
PAGE = SOURCES.parents[1] / "docs" / "proofs.md"
STEP_COLUMNS = ["step", "proved", "recorded", "on paper", "tested", "trusted"]
# Everything that would let a theorem rest on something unproved. Print Assumptions decides; this names the line.
FORBIDDEN = re.compile(r"\b(Admitted|admit|give_up|Axioms?|Parameters?|Conjecture|bypass_check|Unset\s+\w+\s+Checking)\b")

# Each file of the theory, by its name, and its place in proofs/coq. Imports name no folder, so no two files have the same name.
PATHS = {path.name: path.relative_to(SOURCES).as_posix() for path in SOURCES.rglob("*.v")}

# Where the theory meets what is generated: the recorded formulae are those of the theorems, the exported thresholds are
# the proved ones.
EMITTED = ["RecordedIsSat7.v", "RecordedIsProgram.v", "Exported.v", "RecordedIsCertified.v", "CoarseKnown.v", "ExactStep.v", "FineStep.v",
           "RecordedIsDeep.v", "RecordedIsConservative.v"]

# Faults: what is replaced in which file, and the file at which coqc has to stop.
FAULTS = {
    "a wrong coefficient in a recorded formula, exact": (
        "Recorded.v", "let Q1_x := a_x * e1 - AB_x * d1 in", "let Q1_x := a_x * e1 + AB_x * d1 in", "RecordedIsSat7.v"),
    "a recorded float program in another order": (
        "Recorded.v", "let rr := rnd (r * r) in", "let rr := rnd (r * rnd (r * 1)) in", "RecordedIsProgram.v"),
    "a swapped comparison": (
        "Recorded.v", "Definition published_exact_vertex_a_radius_lhs (Ax Ay Az Bx By Bz Cx Cy Cz Px Py Pz r : R) : R :=",
        "Definition published_exact_vertex_a_radius_lhs (Bx By Bz Ax Ay Az Cx Cy Cz Px Py Pz r : R) : R :=",
        "RecordedIsSat7.v"),
    "a threshold halved": ("Thresholds.v", "=> 13240", "=> 6620", "Thresholds.v"),
    "a range too narrow": ("Programs.v", "capped 8", "capped 7", "Caps.v"),
    "a side reversed": (
        "Sat7.v", "Definition vertex_side_sides (A B : vec) := (dot A B, dot A A).",
        "Definition vertex_side_sides (A B : vec) := (dot A A, dot A B).", "Sound.v"),
    "an exported threshold that is not the proved one": ("Exported.v", "(13240, 6%nat)", "(13241, 6%nat)", "Exported.v"),
    "a filter's window too wide": ("Filters.v", "8388608 (-4) eq_refl", "8388608 (-3) eq_refl", "Filters.v"),
    "a comparison's window too wide": (
        "Windows.v", "edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 20", "edge_ab_side_c | edge_bc_side_a | edge_ca_side_b => 21",
        "Windows.v"),
    "a bound beside a margin too small": (
        "Margins.v", "Definition edge_side_units : R := 3.", "Definition edge_side_units : R := 2.", "Margins.v"),
    "a coarse threshold too small": (
        "Certified.v", "Definition coarse_degree_4 : R := 11.15625.", "Definition coarse_degree_4 : R := 10.", "Certified.v"),
    "a coarse range that overflows": ("CoarseFloat.v", "24 128 (-21) 19 eq_refl", "24 128 (-21) 20 eq_refl", "CoarseFloat.v"),
    "a fused product of the wrong sign": (
        "Sizes.v", "if fused then Bfma mode_NE (Bopp y) z x", "if fused then Bfma mode_NE y z x", "Sizes.v"),
    "an error of the conservative test too small": (
        "Conservative.v", "Definition conservative_error : R := 10.", "Definition conservative_error : R := 7.", "Conservative.v"),
    "a range of the conservative test too wide": (
        "ConservativeStep.v", "conservative_never_misses 24 (-149) (-42)", "conservative_never_misses 24 (-149) (-43)", "ConservativeStep.v"),
    "a margin of the conservative test with the error added": (
        "ConservativeStep.v", "(mix s xz yz) - error)", "(mix s xz yz) + error)", "ConservativeStep.v"),
    "an open sphere that a triangle without area is apart from by its plane": (
        "OpenSphere.v", "| plane_radius => normal A B C <> Vec 0 0 0", "| plane_radius => True", "OpenSphere.v"),
    "an open sphere that an edge without length is an axis of": (
        "OpenSphere.v", "| edge_bc_radius => sub C B <> Vec 0 0 0", "| edge_bc_radius => True", "OpenSphere.v"),
    "an open sphere that touching counts as contact with": (
        "OpenSphere.v", "in_triangle X A B C -> r <= distance P X", "in_triangle X A B C -> r < distance P X", "OpenSphere.v"),
    "an open sphere's coarse range that overflows": (
        "OpenCoarse.v", "24 128 (-21) 19 eq_refl", "24 128 (-21) 20 eq_refl", "OpenCoarse.v"),
    "a pair's difference with an error of four units": (
        "Margins.v", "Rabs (M - (x - y)) <= u * (Rabs x", "Rabs (M - (x - y)) <= 4 * u * (Rabs x", "Margins.v"),
    "a leading double with an error of a sixteenth": (
        "Margins.v", "Rabs (L - M) <= / 1048576 * Rabs M", "Rabs (L - M) <= / 16 * Rabs M", "Margins.v"),
    "a pair's difference with a sum of one error more": (
        "Pairs.v", "(rnd (x - rnd (sum - part)) + rnd (y - part))", "(rnd (x - rnd (sum - part)) + (rnd y - part))", "Pairs.v"),
    "a pair's difference without its low parts": (
        "Pairs.v", "(plus (minus (pair_low x) (pair_low y)) (pair_low s))", "(pair_low s)", "Pairs.v"),
    "a lane that has the axis of another edge": (
        "PairStep.v", "(holds edge_ab_radius /\\ holds edge_ab_side_c).", "(holds edge_bc_radius /\\ holds edge_bc_side_a).", "PairStep.v"),
    "a lane that is not renamed": (
        "PairStep.v", "lane_contact a b c p r && lane_contact b c a p r && lane_contact c a b p r",
        "lane_contact a b c p r && lane_contact a b c p r && lane_contact c a b p r", "PairStep.v"),
    "a face of the box on the wrong side": (
        "Box.v", "then Bminus mode_NE p r else B754_infinity true", "then Bplus mode_NE p r else B754_infinity true", "Box.v"),
    "a box about a sphere that is not valid": (
        "Box.v", "then Bplus mode_NE p r else B754_infinity false", "then Bplus mode_NE p r else p", "Box.v"),
    "a tie that counts as beyond for the closed sphere": (
        "Known.v", "q = open_sphere /\\ has_normal A B C K)", "has_normal A B C K)", "Known.v"),
    "a contact that one axis without a bit is enough for": (
        "Known.v", "is_contact (k : known) : bool := forallb", "is_contact (k : known) : bool := existsb", "Known.v"),
    # Faults that an audit planted in the sources of the certified predicate and no random query showed, as the recorder would emit them.
    "coarse thresholds a quarter of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 323 (-28))", "m_multiply m (m_constant m 323 (-30))", "RecordedIsCertified.v"),
    "coarse thresholds a sixteenth of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 187 (-29))", "m_multiply m (m_constant m 187 (-33))", "RecordedIsCertified.v"),
    "a coarse range in binary32 from 2^-60": (
        "RecordedCertified.v", "m_at_most m (m_constant m 1 (-21))", "m_at_most m (m_constant m 1 (-60))", "RecordedIsCertified.v"),
    "a unit of pairs of 2^-106": ("RecordedCertified.v", "(51, (-105))", "(51, (-109))", "RecordedIsDeep.v"),
    "residues known below 2^64 units": ("RecordedCertified.v", "(1, 60)", "(1, 64)", "RecordedIsDeep.v"),
    "an error of the conservative test a quarter of what is proved": (
        "RecordedCertified.v", "m_multiply m (m_constant m 5 (-23))", "m_multiply m (m_constant m 5 (-25))", "RecordedIsConservative.v"),
    "a promised depth of phantoms that is not proved": (
        "RecordedCertified.v", "binary32 : Z * Z := (5, (-10))", "binary32 : Z * Z := (19, (-12))", "RecordedIsConservative.v"),
    "a lane of the single pair with its neighbour's vertices": (
        "RecordedCertified.v", "Definition pair_fma_binary32_answers (m : machine) (ax ay az bx by_ bz",
        "Definition pair_fma_binary32_answers (m : machine) (bx by_ bz ax ay az", "RecordedIsCertified.v"),
    "an operand exchanged in the exact step": ("RecordedExact.v", "(Minus 0 9, 1)", "(Minus 9 0, 1)", "ExactStep.v"),
    "a word too few for a product of the exact step": (
        "ExactProgram.v", "then 1 else degree + 2)", "then 1 else degree - 2)", "ExactProgram.v"),
    "a fine bound too small": (
        "FineStep.v", "Definition fine_vertex_side := number 255 (-57).", "Definition fine_vertex_side := number 255 (-58).", "FineStep.v"),
    "a coarse step that tells that a comparison holds where it may not": (
        "CoarseKnown.v", "(fun i => Bltb (t (radius_of i)) (m (radius_of i)))", "(fun i => Bltb (Bopp (t (radius_of i))) (m (radius_of i)))",
        "CoarseKnown.v"),
    "a radius taken as zero that is not negligible": (
        "Negligible.v", "r <= bpow radix2 (-2 * n - 2))%R.", "r <= bpow radix2 (-2 * n - 1))%R.", "Negligible.v"),
    "a conservative test's range that overflows": (
        "ConservativeFloat.v", "float_answers 24 128 (-42) 30 (-60)", "float_answers 24 128 (-42) 32 (-60)", "ConservativeFloat.v"),
    "a share of an edge that is not clamped from above": (
        "ConservativeProgram.v", "(product X along)) e else zero) zero) one", "(product X along)) e else zero) zero) zero", "ConservativeProgram.v"),
    "a side of the plane by another vertex": (
        "ConservativeProgram.v", "m_with_sign m one (product A n)", "m_with_sign m one (product B n)", "ConservativeProgram.v"),
    "a power of two from bits with another bias": ("InversePower.v", "0x7f000000 0x7f800000", "0x7f800000 0x7f800000", "InversePower.v"),
    "an upper end of the conservative test that is not proved": (
        "RecordedCertified.v", "(m_constant m 1 60)", "(m_constant m 1 64)", "RecordedIsConservative.v"),
    "a share that is not clamped from above in the code": (
        "RecordedCertified.v", "let t71 := m_least m t70 (m_constant m 1 0) in", "let t71 := t70 in", "RecordedIsConservative.v"),
    "a quotient that is taken where the edge has no length": (
        "RecordedCertified.v", "let t69 := if t61 then t68 else (m_zero m) in", "let t69 := t68 in", "RecordedIsConservative.v"),
    # Theorems made weaker, which the theorems that use them refuse.
    "a coarse step that may be wrong for an infinite radius": (
        "CoarseFloat.v", "(r : binary_float prec emax),\n", "(r : binary_float prec emax), is_finite r = true ->\n",
        "PairStep.v"),
    "a conservative test that may miss a point's contact": (
        "ConservativeStep.v", "in_format prec emin p -> 0 <= r ->\n  let rnd", "in_format prec emin p -> 0 < r ->\n  let rnd",
        "ConservativeFloat.v"),
    "phantoms too shallow": ("PhantomStep.v", "Definition phantom_depth : R := 20.", "Definition phantom_depth : R := 19.", "PhantomStep.v"),
}

# Theorems made weaker, which still have their proofs: what is replaced in which file, and the statement that says less
# then.
WEAKENED = {
    "a conservative test that may be wrong for an infinite radius": (
        "ConservativeFloat.v", "  forall a b c p r,\n  let says := nth 0 (answers", "  forall a b c p r, is_finite r = true ->\n  let says := nth 0 (answers",
        "conservative_is_right"),
    "a filter that may be wrong for an infinite radius": (
        "Filters.v", "-> Prop) : Prop := forall q,", "-> Prop) : Prop := forall q, is_finite (fr prec emax q) = true ->",
        "never_lies"),
    "a program recorded for one comparison only": (
        "RecordedIsProgram.v", "Theorem published_float_program rnd q m K :",
        "Theorem published_float_program rnd q m K : K = plane_radius ->", "published_float_program"),
    "a single pair that may be wrong for an infinite radius": (
        "PairStep.v", "(r : binary_float prec emax),\n  let closed", "(r : binary_float prec emax), is_finite r = true ->\n  let closed",
        "float_pair_never_lies"),
    "an open coarse step that may be wrong with fused products": (
        "OpenCoarse.v", "  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax),\n  let apart",
        "  forall fused (a b c p : float_vec prec emax) (r : binary_float prec emax), fused = false ->\n  let apart",
        "float_coarse_never_lies_open"),
    "phantoms that may be deeper": (
        "PhantomStep.v", "Definition phantom_depth : R := 20.", "Definition phantom_depth : R := 21.", "phantom_depth"),
}


def fail(message):
    print(f"prove: {message}", file=sys.stderr)
    sys.exit(1)


def copy_changed(sources, build):
    """Copies the sources to `build`, keeping the times of those that are unchanged, for make. A file that is gone or
    has moved leaves nothing behind: coqc refuses an import that it finds in two folders."""
    for built in build.rglob("*.v*"):
        if not (sources / built.relative_to(build)).with_suffix(".v").exists():
            built.unlink()
    for source in [*sources.rglob("*.v"), sources / "_CoqProject"]:
        target = build / source.relative_to(sources)
        target.parent.mkdir(parents=True, exist_ok=True)
        if not target.exists() or target.read_bytes() != source.read_bytes():
            target.write_bytes(source.read_bytes())


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


def refuse_unproved(sources):
    for source in sorted(sources.rglob("*.v")):
        for number, line in enumerate(without_comments(source.read_text()).splitlines(), 1):
            if found := FORBIDDEN.search(line):
                fail(f"{source.name}:{number}: '{found.group()}': every step has to be proved")


def refuse_ambiguous(sources):
    """A name in Statements.v that two files define says which is printed: Coq takes the one that was imported last, and
    the other could be weakened unseen."""
    defined = {}
    for source in sorted(sources.rglob("*.v")):
        for name in re.findall(r"^\s*(?:Definition|Fixpoint|Inductive|Record|Lemma|Theorem|Corollary)\s+([\w']+)", without_comments(source.read_text()),
                               re.M):
            defined.setdefault(name, set()).add(source.stem)
    for name in re.findall(r"^(?:Print|Check) ([\w']+)\.$", without_comments((sources / "Statements.v").read_text()), re.M):
        if len(files := sorted(defined.get(name, ()))) > 1:
            fail(f"Statements.v prints '{name}', which {' and '.join(files)} define: say which, '{files[0]}.{name}'")


def coqc(build, file, *flags):
    return subprocess.run(["coqc", "-q", "-Q", ".", "Axiscert", *flags, file], cwd=build, text=True, capture_output=True)


def make(build, jobs, *targets):
    subprocess.run(["coq_makefile", "-f", "_CoqProject", "-o", "Makefile"], cwd=build, check=True)
    result = subprocess.run(["make", "--no-print-directory", f"-j{jobs}", *targets], cwd=build, text=True,
                            capture_output=True)
    if result.returncode:
        fail(f"the theory does not check:\n{result.stdout}{result.stderr}")


def by_theorem(printed):
    """The output of Assumptions.v, by theorem."""
    pieces = re.split(r'^== "?(\w+)"?\n', printed, flags=re.M)
    return dict(zip(pieces[1::2], (" ".join(piece.split()) for piece in pieces[2::2])))


def printed_by(build, name, *flags):
    """The output of NAME.v and the content of NAME.expected, by theorem or definition. Both have to name the same ones."""
    result = coqc(build, f"{name}.v", *flags)
    if result.returncode:
        fail(f"{name}.v does not check:\n{result.stdout}{result.stderr}")
    printed, expected = by_theorem(result.stdout), by_theorem((SOURCES / f"{name}.expected").read_text())
    if set(printed) != set(expected):
        fail(f"{name}.v and {name}.expected name different theorems: {sorted(set(printed) ^ set(expected))}")
    return printed, expected


def changed_statements(build, *flags):
    """The theorems and definitions that differ from Statements.expected."""
    printed, expected = printed_by(build, "Statements", *flags)
    return {name: (text, expected[name]) for name, text in printed.items() if text != expected[name]}


def compare(build):
    """Prints a line for each main theorem, and writes prove.json, with statements and axioms, where everything holds."""
    assumed, expected = printed_by(build, "Assumptions")
    result = {}
    for theorem, assumptions in assumed.items():
        if assumptions != expected[theorem]:
            fail(f"{theorem} depends on\n  {assumptions}\nand should depend on\n  {expected[theorem]}")
        axioms = re.findall(r"[\w.]+\.(\w+) :", assumptions)
        result[theorem] = axioms
        print(f"proved  {theorem:36} {', '.join(axioms) or 'no axioms'}")
    if unread := set(assumed) - set(by_theorem((SOURCES / "Statements.expected").read_text())):
        fail(f"Statements.v does not print {sorted(unread)}")
    require_statements(build)
    statements = by_theorem((SOURCES / "Statements.expected").read_text())
    version = subprocess.run(["coqc", "--print-version"], text=True, capture_output=True).stdout.split()
    theorems = [{"name": name, "axioms": axioms, "statement": statements[name]} for name, axioms in result.items()]
    text = json.dumps({"schema": "axiscert-theorems/2", "coq": version[0], "theorems": theorems,
                       "steps": certified_steps()}, indent=1)
    (build.parent / "prove.json").write_text(text + "\n")


def certified_steps():
    """The rows of the table of docs/proofs.md, by column; docs.records asks that the theorems named there are main ones."""
    page = PAGE.read_text().split("## The certified predicate, step by step", 1)[1].split("\n## ", 1)[0]
    head, _, *rows = [[cell.strip() for cell in line.strip("|").split("|")] for line in page.splitlines() if line.startswith("|")]
    if head != STEP_COLUMNS or not rows:
        fail(f"{PAGE}: the table of the steps has the columns {head}, and should have {STEP_COLUMNS}")
    return [dict(zip(head, row, strict=True)) for row in rows]


def require_statements(build, *flags):
    for name, (says, should) in changed_statements(build, *flags).items():
        fail(f"{name} says\n  {says}\nand should, by Statements.expected,\n  {should}")


def check_emitted(build, jobs):
    """`-vos` reads definitions and statements and leaves out the proofs; `-vok` checks the proofs of one file with no more
    of the others than that."""
    make(build, jobs, "vos")
    require_statements(build, "-vok")
    for file in EMITTED:
        result = coqc(build, PATHS[file], "-vok")
        if result.returncode:
            fail(f"{file}: what is emitted is not what is proved:\n{result.stdout}{result.stderr}")
        print(f"emitted is proved  {file}")


def planted_copy(build, name, file, old, new):
    """A copy of the build, with its times, in which one file is changed, so that only what depends on that file is
    built again."""
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
        if set(changed := changed_statements(planted, "-vok")) != {weaker}:
            fail(f"{name}: only {weaker} should differ from Statements.expected, but {sorted(changed)} do")
        print(f"seen    {name:50} Statements.expected, {weaker}")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--build", type=pathlib.Path, default=SOURCES.parents[1] / "build" / "proofs" / "coq")
    parser.add_argument("--jobs", type=int, default=1)
    parser.add_argument("--emitted", action="store_true")
    parser.add_argument("--planted", action="store_true")
    options = parser.parse_args()
    if not shutil.which("coqc"):
        print("prove: NOT CHECKED: coqc is missing; install the Debian packages coq and libcoq-flocq", file=sys.stderr)
        sys.exit(2)
    refuse_unproved(SOURCES)
    refuse_ambiguous(SOURCES)
    copy_changed(SOURCES, options.build)
    (options.build.parent / "prove.json").unlink(missing_ok=True)
    if options.emitted:
        check_emitted(options.build, options.jobs)
        return
    make(options.build, options.jobs)
    if options.planted:
        plant(options.build)
    else:
        compare(options.build)


if __name__ == "__main__":
    main()
