#!/usr/bin/env python3
"""planted_sources_test.py CXX PROOFS_LIBRARY WRITTEN [unittest arguments]: a fault in a source of the proofs, a formula or a
claimed figure, passes through the recorder and is refused at the file that states it.

Each fault is one token of a source, in a copy that the compiler finds first. The recorder built from it writes its
own proofs. programs.py reports at once that its programs are not the committed ones; and if somebody updated those, the
checker would refuse the proofs at the file named."""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import unittest

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1]))
import programs
import prove

CXX, LIBRARY, WRITTEN = sys.argv[1], *(pathlib.Path(path).resolve() for path in sys.argv[2:4])
PROOFS = pathlib.Path(__file__).resolve().parents[1]
ROOT = PROOFS.parent
COQ_BUILD = ROOT / "build" / "proofs" / "coq"


class Planted(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.work = pathlib.Path(folder.name)

    def written(self, source, old, new, unit):
        """What write_proofs writes with `old` replaced by `new` in `source`, which translation unit `unit` includes or is."""
        text = (ROOT / source).read_text()
        self.assertEqual(text.count(old), 1, f"the fault finds '{old}' {text.count(old)} times in {source}")
        overlay = self.work / "overlay"
        (overlay / source).parent.mkdir(parents=True)
        (overlay / source).write_text(text.replace(old, new))
        planted = overlay / unit if source == unit else ROOT / unit
        # The unit's own definitions take precedence over those of the library.
        beside = (ROOT / source).parent  # for what the source includes by its name alone
        subprocess.run([CXX, "-std=c++20", "-O0", "-ffp-contract=off", "-iquote", beside, "-I", overlay, "-I", ROOT, planted,
                        PROOFS / "write_proofs.cpp", LIBRARY, "-lfmt", "-o", self.work / "write_proofs"], check=True)
        subprocess.run([self.work / "write_proofs", self.work / "written"], check=True)
        return self.work / "written"

    def refused_by_coq(self, made, target, *recorded):
        """The file at which the check of `target` stops, with what is `recorded` now: its proofs, and the others' statements."""
        theory = self.work / "coq"
        shutil.copytree(COQ_BUILD, theory)  # with times, so that only what depends on these files is built again
        for path in (prove.PATHS[name] for name in recorded):
            (theory / path).write_bytes((made / "coq" / path).read_bytes())
        result = subprocess.run(["make", "--no-print-directory", prove.PATHS[target] + "ok"], cwd=theory, text=True, capture_output=True)
        self.assertNotEqual(result.returncode, 0, "the theory accepts it")
        return os.path.basename(re.search(r'File "\./([\w/]+\.v)"', result.stderr).group(1))


class PlantedSources(Planted):
    def formula(self, source, old, new, refused_at):
        made = self.written(source, old, new, "proofs/record.cpp")
        self.assertTrue({"published_plain", "reduced_plain"} & set(programs.differing(made)))
        self.assertEqual(self.refused_by_coq(made, refused_at, "Recorded.v"), refused_at)

    def test_a_wrong_coefficient(self):
        self.formula("kernel/sphere_triangle/formulae.h", "A * e1 - AB * d1", "A * e1 + AB * d1", "RecordedIsSat7.v")

    def test_a_wrong_coefficient_in_the_reduced_form(self):
        self.formula("kernel/sphere_triangle/forms/reduced.h", "emit(edge_ab_radius, dot(N1, N1), rr * dot(AB, AB))",
                     "emit(edge_ab_radius, dot(N1, N1), rr * dot(AB, BC))", "RecordedIsSat7.v")

    def test_a_swapped_comparison(self):
        self.formula("kernel/sphere_triangle/formulae.h", "emit(vertex_a_side_b, ab, aa)", "emit(vertex_a_side_b, aa, ab)",
                     "RecordedIsSat7.v")

    def test_another_order_of_operations(self):
        """Over the reals the formula is the same; the program of the rounding proofs differs."""
        self.formula("kernel/base/geometry.h", "(u.x * v.x + u.y * v.y) + u.z * v.z", "u.x * v.x + (u.y * v.y + u.z * v.z)",
                     "RecordedIsProgram.v")

    def test_a_bound_halved(self):
        made = self.written("proofs/bounds.cpp", "{1761, 1569}", "{880, 1569}", "proofs/bounds.cpp")
        self.assertEqual(programs.differing(made), [programs.HEADER])
        for written, accepted in ((WRITTEN, True), (made, False)):
            done = subprocess.run(["gappa", written / "gappa/binary32/scaled/reduced_plain_edge_ab_radius.g"], capture_output=True, text=True)
            self.assertEqual(done.returncode == 0, accepted, done.stderr)

    def test_a_range_too_narrow(self):
        row = '{Domain::scaled, "V",  true,  "-4",'
        made = self.written("proofs/bounds.cpp", row, row.replace("-4", "-3"), "proofs/bounds.cpp") / "ranges"
        shutil.copy(PROOFS / "coq" / "formulae" / "Ranges.v", made)
        for name, accepted in (("Ranges.v", True), ("RangesClaimed.v", False)):
            done = subprocess.run(["coqc", "-Q", ".", "Axiscert", name], cwd=made, capture_output=True, text=True)
            self.assertEqual(done.returncode == 0, accepted, done.stderr)
        self.assertIn("RangesClaimed.v", done.stderr)


CERTIFIED = "kernel/sphere_triangle/certified"
BOUNDS = "kernel/sphere_triangle/forms/margin_bounds.h"
STEPS, EXACT, BLOCKS, WINDOWS = (f"proofs/certified/record_{unit}.cpp" for unit in ("steps", "exact", "blocks", "windows"))
# The recorder itself refuses to write a program.
RECORDER = "the recorder"
# Faults of the certified predicate: the source and what is replaced in it, the unit that records it, and the file of the
# theory at which what is recorded then stops. None: the theory states no more of it than that it is the committed program.
STEP_FAULTS = {
    # Faults that an audit planted, and no random query showed.
    "coarse thresholds a quarter of what is proved": (
        f"{CERTIFIED}/coarse_step-inl.h", "static_cast<Real>(n * u)", "static_cast<Real>(n * u / 4)", STEPS, "RecordedIsCertified.v"),
    "coarse thresholds a sixteenth of what is proved": (
        f"{CERTIFIED}/coarse_step-inl.h", "static_cast<Real>(n * u)", "static_cast<Real>(n * u / 16)", STEPS, "RecordedIsCertified.v"),
    "a coarse range in binary32 from 2^-60": (
        BOUNDS, "least_square_binary32 = 0x1p-21", "least_square_binary32 = 0x1p-60", STEPS, "RecordedIsCertified.v"),
    "a unit of pairs of 2^-106": (
        f"{CERTIFIED}/numbers/pairs-inl.h", "unit = 0x1p-102", "unit = 0x1p-106", STEPS, "RecordedIsDeep.v"),
    "residues known below 2^64 units": (
        f"{CERTIFIED}/numbers/wrapped-inl.h", "hn::Set(d_, 0x1p60)", "hn::Set(d_, 0x1p64)", STEPS, "RecordedIsDeep.v"),
    "errors of the conservative test a quarter of what is proved": (
        f"{CERTIFIED}/conservative_step-inl.h", "units(Bounds::error) * W", "units(Bounds::error / 4) * W", STEPS, "RecordedIsConservative.v"),
    "a promised depth of phantoms that is not proved": (
        "kernel/include/axiscert/certified.h", "DEPTH_F32 0.0048828125", "DEPTH_F32 0.004638671875", "proofs/emit_certified.cpp",
        "RecordedIsConservative.v"),
    # Constants written by hand.
    "an upper end of the conservative test that is not proved": (
        f"{CERTIFIED}/conservative_step-inl.h", "is_float ? 0x1p60 : 0x1p400", "is_float ? 0x1p62 : 0x1p400", STEPS,
        "RecordedIsConservative.v"),
    "a range of leaves from 2^-200": (
        f"{CERTIFIED}/thresholds.h", "least_fine_leaf = 0x1p-100", "least_fine_leaf = 0x1p-200", STEPS, None),
    "a fine bound a half of what is proved": (BOUNDS, "vertex_side_units = 15", "vertex_side_units = 7.5", STEPS, "FineStep.v"),
    # An operation, an operand, a guard or a comparison in each step.
    "another formula in the coarse step: A x B for A x AB": (
        f"{CERTIFIED}/coarse_step-inl.h", "edge(A, AB, e1)", "edge(A, B, e1)", STEPS, "RecordedIsCertified.v"),
    "another order of additions in the coarse step": (
        f"{CERTIFIED}/coarse_step-inl.h", "((aa + bb) + cc) + rr", "(aa + bb) + (cc + rr)", STEPS, "RecordedIsCertified.v"),
    "a bit told for a margin that only reaches its threshold": (
        f"{CERTIFIED}/coarse_step-inl.h", "axis.sides = hn::Gt(side.v", "axis.sides = hn::Ge(side.v", STEPS, "CoarseKnown.v"),
    "a lane of the single pair with its own vertex for the next": (
        f"{CERTIFIED}/pair_step-inl.h", "permuted<1, 2, 0>", "permuted<0, 1, 2>", STEPS, "RecordedIsCertified.v"),
    "a product's operand exchanged in the fine and deep margins": (
        f"{CERTIFIED}/margins-inl.h", "rr * dot(along.v, along.v)", "rr * dot(along.v, N.v)", STEPS, "FineStep.v"),
    "a tie that the fine step takes as certain": (
        f"{CERTIFIED}/fine_step-inl.h", "hn::Lt(margin.value, hn::Neg(margin.bound)));", "hn::Le(margin.value, hn::Neg(margin.bound)));",
        STEPS, "FineKnown.v"),
    "a range of the deep step that is not asked": (
        f"{CERTIFIED}/deep_step-inl.h", "sound = hn::And(sound, in_range(m_.ab));", "", STEPS, None),
    "a pair's sum with an error of the wrong sign": (
        f"{CERTIFIED}/numbers/pairs-inl.h", "hn::Sub(y, part))", "hn::Sub(part, y))", STEPS, None),
    "a unit that is not the least bit": (
        f"{CERTIFIED}/numbers/wrapped-inl.h", "hn::And(any, hn::Sub(words(0), any))", "hn::And(any, any)", STEPS, None),
    "a thin triangle's plane in the conservative test": (
        f"{CERTIFIED}/conservative_step-inl.h", "hn::And(usable, passes)", "passes", STEPS, "RecordedIsConservative.v"),
    "a difference reversed in the exact step": (
        f"{CERTIFIED}/numbers/exact_margins.h", "return {u.x - v.x,", "return {v.x - u.x,", EXACT, "ExactStep.v"),
    # One token each, that no random query showed.
    "integers of 94 bits for numbers of 95": (
        f"{CERTIFIED}/numbers/widths.h", "if (bits <= size) return size;", "if (bits <= size + 1) return size;", EXACT, "ExactVerdict.v"),
    "integers of 126 bits with the words of 110": (
        f"{CERTIFIED}/numbers/widths.h", "(bits(degree) + 63) / 64", "(bits(degree) + 31) / 64", EXACT, "ExactVerdict.v"),
    "a negligible radius that is not": (
        f"{CERTIFIED}/numbers/widths.h", "return -2 * n - 2;", "return -2 * n - 1;", EXACT, "ExactVerdict.v"),
    "a number that lost all of its bits taken for one that lost none": (
        f"{CERTIFIED}/range_step-inl.h", "hn::Eq(hn::Mul(scaled, up), x)",
        "hn::Or(hn::Ne(scaled, hn::Zero(d)), hn::Eq(x, hn::Zero(d)))", STEPS, None),
    "any lane of a pair for all of them": (
        f"{CERTIFIED}/pair_step-inl.h", "contact_ = hn::AllTrue(", "contact_ = !hn::AllFalse(", STEPS, "RecordedIsCertified.v"),
    "low parts dropped where every lane has one": (
        f"{CERTIFIED}/numbers/wrapped-inl.h", "has_low_ = !hn::AllTrue(", "has_low_ = hn::AllFalse(", STEPS, None),
    "a tie of the open sphere as contact": (
        f"{CERTIFIED}/exact_test.h", "open_ ? !margin.is_negative()", "open_ ? margin.is_positive()", EXACT, "ExactVerdict.v"),
    "an edge without length as an axis": (
        f"{CERTIFIED}/exact_test.h", "if (along.is_zero()) return false;", "", EXACT, "ExactVerdict.v"),
    "a plane without a normal as an axis": (
        f"{CERTIFIED}/exact_test.h", "!V.is_zero() && ", "", EXACT, "ExactVerdict.v"),
    "an axis that is never asked": (
        f"{CERTIFIED}/exact_test.h", "if (test.plane_separates(V)) return true;", "", EXACT, "ExactVerdict.v"),
    "V left out where an edge's sides are known": (
        f"{CERTIFIED}/exact_test.h", "(sides & edges)", "edges", EXACT, "ExactVerdict.v"),
    "an edge's side that balls tell from the wrong sign": (
        f"{CERTIFIED}/exact_test.h", "side.is_at_most_zero()", "side.is_at_least_zero()", EXACT, "Balls.v"),
    "a side that is added in the exact step": (
        f"{CERTIFIED}/numbers/exact_margins.h", "dot<Four>(N, N) - product", "dot<Four>(N, N) + product", EXACT, "ExactStep.v"),
    # The box.
    "a low end on the wrong side of the centre": (
        f"{CERTIFIED}/box_step-inl.h", "chosen(is_sphere, p[k] - r, -infinity)", "chosen(is_sphere, p[k] + r, -infinity)", STEPS, "RecordedIsBox.v"),
    "a triangle beyond a face by its least vertex": (
        f"{CERTIFIED}/box_step-inl.h", "hn::Or(hn::Lt(greatest, hn::Set", "hn::Or(hn::Lt(least, hn::Set", STEPS, "RecordedIsBox.v"),
    "a vector that is passed over where some lane is beyond": (
        f"{CERTIFIED}/box_step-inl.h", "return hn::AllTrue(d, hn::And(any,", "return !hn::AllFalse(d, hn::And(any,", STEPS, RECORDER),
    "vertices that are beyond all faces": (
        f"{CERTIFIED}/box_step-inl.h", "!hn::AllFalse(d, hn::And(xyz, beyond))", "hn::AllTrue(d, hn::Or(fourth, beyond))", STEPS, "RecordedIsBox.v"),
    "a fourth lane that counts": (
        f"{CERTIFIED}/box_step-inl.h", "hn::FirstN(d, 3)", "hn::FirstN(d, 4)", STEPS, "RecordedIsBox.v"),
    "an outcode's bit for the face across": (
        f"{CERTIFIED}/box_step-inl.h", "hn::Set(d, box.high[k])), 2 * k + 1)", "hn::Set(d, box.high[k])), 2 * k)", STEPS, "RecordedIsBox.v"),
    "a vertex on a face that counts as beyond": (
        f"{CERTIFIED}/box_step-inl.h", "face(hn::Lt(v, hn::Set(d, box.low[k])), 2 * k)", "face(hn::Le(v, hn::Set(d, box.low[k])), 2 * k)", STEPS,
        "RecordedIsBox.v"),
    "a vertex that is not finite with an outcode": (
        f"{CERTIFIED}/box_step-inl.h", "hn::IfThenElseZero(is_finite, hn::Or(",
        "hn::IfThenElseZero(hn::RebindMask(bits, hn::Eq(x, x)), hn::Or(", STEPS, "RecordedIsBox.v"),
    # What becomes of blocks: tails, masks, packing, queues, and which step runs when.
    "a tail's vector whose lanes all count": (
        f"{CERTIFIED}/block-inl.h", "coarse_vector(tail.block, 0, size - i,", "coarse_vector(tail.block, 0, lanes,", BLOCKS, RECORDER),
    "a mask of one bit too many": (
        f"{CERTIFIED}/leftovers-inl.h", "(std::uint64_t{1} << count) - 1;", "(std::uint64_t{2} << count) - 1;", BLOCKS, RECORDER),
    "contacts of a tail's padding": (
        f"{CERTIFIED}/block-inl.h", "return contact & low_bits(count);", "return contact;", BLOCKS, RECORDER),
    "what one answer leaves open, for what neither decides": (
        f"{CERTIFIED}/block-inl.h", "~(contact | separated) & low_bits(count)", "~(contact & separated) & low_bits(count)", BLOCKS, None),
    "a chunk that is hard where a quarter is left": (
        f"{CERTIFIED}/block-inl.h", "chunk_size * 3 / 4", "chunk_size * 1 / 4", BLOCKS, None),
    "a query with one open comparison, or in range, for both": (
        f"{CERTIFIED}/block-inl.h", "hn::And(has_one_open(d, known), limits", "hn::Or(has_one_open(d, known), limits", BLOCKS, "BlocksAreRight.v"),
    "the few for the many": (
        f"{CERTIFIED}/block-inl.h", "many = pending & ~few", "many = pending & few", BLOCKS, "BlocksAreRight.v"),
    "binary64 whose range nothing asks": (
        f"{CERTIFIED}/block-inl.h", "sizeof(Real) == 8 ? bits_of(d, step.is_sound())", "sizeof(Real) == 4 ? bits_of(d, step.is_sound())",
        BLOCKS, "BlocksAreRight.v"),
    "contacts of lanes out of range": (
        f"{CERTIFIED}/block-inl.h", "bits_of(d, found.decided.contact) & sound", "bits_of(d, found.decided.contact) & queries",
        BLOCKS, "BlocksAreRight.v"),
    "queries out of range that go to the deep step": (
        f"{CERTIFIED}/block-inl.h", "const std::uint64_t pending = sound & ~", "const std::uint64_t pending = valid & ~", BLOCKS, "BlocksAreRight.v"),
    "valid queries out of range that nothing takes": (
        f"{CERTIFIED}/block-inl.h", "rest = queries & ~sound", "rest = queries & ~valid", BLOCKS, "BlocksAreRight.v"),
    "invalid where either test says so": (
        f"{CERTIFIED}/block-inl.h", "!has_bit(valid, lane) && !is_valid(q)", "!has_bit(valid, lane) || !is_valid(q)", BLOCKS, "BlocksAreRight.v"),
    "a scaled query with the numbers of the first lane": (
        f"{CERTIFIED}/block-inl.h", "scaled[k][lane]", "scaled[k][0]", BLOCKS, "BlocksAreRight.v"),
    "a contact where the bits say separated": (
        f"{CERTIFIED}/block-inl.h", "std::uint64_t{known.is_contact()} <<", "std::uint64_t{known.is_separated()} <<", BLOCKS, "BlocksAreRight.v"),
    # Which integers the exact step takes, and when it asks balls.
    "balls asked at 126 bits": (
        f"{CERTIFIED}/exact_step.cpp", "if (bits > before_balls)", "if (bits >= before_balls)", WINDOWS, "WindowsAreRight.v"),
    "digits from 126 bits on": (
        f"{CERTIFIED}/exact_step.cpp", "return bits <= widest ?", "return bits < widest ?", WINDOWS, "WindowsAreRight.v"),
    "a radius that is negligible at the end of its range only below": (
        f"{CERTIFIED}/exact_step.cpp", "r.top() <= span.unit", "r.top() < span.unit", WINDOWS, None),
    "an open sphere that stays open where its radius is taken as zero": (
        f"{CERTIFIED}/exact_step.cpp", "    open = false;\n", "    open = open;\n", WINDOWS, "WindowsAreRight.v"),
    "a closed sphere of radius 0 that is empty": (
        f"{CERTIFIED}/exact_step.cpp", "if (open && query[12] == 0)", "if (open || query[12] == 0)", WINDOWS, "WindowsAreRight.v"),
    "a span of one bit less": (
        f"{CERTIFIED}/numbers/widths.h", "top - unit + 1", "top - unit", WINDOWS, "WindowsAreRight.v"),
}


# What each unit records: the programs, where these are all, and the files of the theory.
PROGRAMS = {EXACT: ["exact"], BLOCKS: ["blocks"], WINDOWS: ["windows"]}
FILES = {BLOCKS: ["RecordedBlocks.v"], WINDOWS: ["RecordedWindows.v"]}


class PlantedSteps(Planted):
    def fault(self, name, source, old, new, unit, refused_at):
        if refused_at == RECORDER:
            with self.assertRaises(subprocess.CalledProcessError) as stopped:
                self.written(source, old, new, unit)
            self.assertEqual(stopped.exception.cmd, [self.work / "write_proofs", self.work / "written"])
            print(f"refused {name:60} {RECORDER}")
            return
        made = self.written(source, old, new, unit)
        stale = programs.differing(made)
        if unit in PROGRAMS:
            self.assertEqual(stale, PROGRAMS[unit])
        elif unit == STEPS:
            unfused = "conservative" in source or "box" in source
            self.assertLessEqual({"plain"} if unfused else {"plain", "fma"}, {word for name in stale for word in name.split("_")})
        if refused_at:
            self.assertEqual(self.refused_by_coq(made, refused_at, *FILES.get(unit, ["RecordedCertified.v", "RecordedExact.v"])), refused_at)
        print(f"refused {name:60} {refused_at or 'another program: ' + ', '.join(stale)}")


for number, (name, given) in enumerate(STEP_FAULTS.items()):
    def planted(self, name=name, given=given):
        self.fault(name, *given)
    planted.__doc__ = name
    setattr(PlantedSteps, f"test_step_{number:02}_" + re.sub(r"\W+", "_", name), planted)


if __name__ == "__main__":
    prove.write_changed(prove.theory(WRITTEN), COQ_BUILD)
    prove.make(COQ_BUILD, 1, "vos")
    unittest.main(argv=[sys.argv[0], *sys.argv[4:]])
