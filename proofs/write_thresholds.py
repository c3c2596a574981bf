#!/usr/bin/env python3
"""Exports the filter's thresholds and windows from the Coq theory, where they are proved to suffice.

  write_thresholds.py [--check] [--coq FOLDER] [--headers FOLDER]

reads, in coq/, the files named in READ and writes
  kernel/sphere_triangle/forms/filter_thresholds.h   for the kernels
  kernel/sphere_triangle/forms/margin_bounds.h       for the filters of exact/ and the certified predicate
With --check nothing is written, and exit status 1 names the file that is not current. Exit status 2: the theory is
not as expected. The same figures as theorems about the filters are Exported.v, which prove.py adds to the theory: so the
figures read here are those proved there."""
import argparse
import pathlib
import re
import sys
import textwrap

PROOFS = pathlib.Path(__file__).resolve().parent
FORMS = ["published", "reduced"]
# Bits of the significand, exponent of the overflow threshold: as in Filters.v.
FORMATS = {"binary32": (24, 128), "binary64": (53, 1024)}
# The files of the theory that are read, by folder.
READ = {
    "formulae": ["Thresholds.v", "Filters.v"],
    "certified": ["Margins.v", "Certified.v", "CertifiedStep.v", "CoarseFloat.v", "Conservative.v", "ConservativeStep.v"],
}
# The comparisons in the order of kernel/sphere_triangle/names.h and of Vectors.v.
COMPARISONS = ["plane_radius"] + [
    f"vertex_{v}_{what}" for v, others in (("a", "bc"), ("b", "ac"), ("c", "ab"))
    for what in ("radius", f"side_{others[0]}", f"side_{others[1]}")] + [
    f"edge_{edge}_{what}" for edge, other in (("ab", "c"), ("bc", "a"), ("ca", "b"))
    for what in ("radius", f"side_{other}")]


def stop(message):
    print(f"write_thresholds: {message}", file=sys.stderr)
    sys.exit(2)


def degree(form, comparison):
    """The degree in the coordinates, which Exported.v proves."""
    if comparison.startswith("vertex"):
        return 2
    return 4 if form == "reduced" and comparison.startswith("edge") else 6


def thresholds(text, form):
    """The values that `Definition FORM_threshold` gives for the comparisons."""
    found = re.search(rf"Definition {form}_threshold \(K : comparison\) : Z :=\s*match K with(.*?)end\.", text, re.S)
    if not found:
        stop(f"Thresholds.v: there is no 'Definition {form}_threshold (K : comparison) : Z := match K with ... end.'")
    values, rest = {}, {}
    cases = re.findall(r"((?:\|\s*\w+\s*)+)=>\s*([^|]*[^|\s])", found.group(1))
    for names, value in cases:
        names = [name.strip() for name in names.split("|")[1:]]
        if names == ["_"] and value == "published_threshold K":
            rest = dict(zip(COMPARISONS, thresholds(text, "published")))
            continue
        if not value.isdigit():
            stop(f"Thresholds.v, {form}_threshold: '{' | '.join(names)} => {value}' is not a case with a whole number")
        values |= {name: int(value) for name in names}
    values = rest | values
    if set(values) != set(COMPARISONS):
        stop(f"Thresholds.v, {form}_threshold: comparisons {sorted(set(values) ^ set(COMPARISONS))} missing or unknown")
    return [values[name] for name in COMPARISONS]


def window_end(text, which, number_format):
    """The exponent of `least` or `greatest`, which are powers of two."""
    found = re.search(rf"Definition {which}_{number_format} : [^:]*:= @B754_finite \d+ \d+ false (\d+) \(?(-?\d+)\)? eq_refl",
                      text)
    if not found:
        stop(f"Filters.v: there is no 'Definition {which}_{number_format} ... := @B754_finite ... eq_refl.'")
    significand, exponent = int(found.group(1)), int(found.group(2))
    if significand & (significand - 1):
        stop(f"Filters.v: {which}_{number_format} is not a power of two: its significand is {significand}")
    return significand.bit_length() - 1 + exponent


def constants(theory, file):
    """The real constants that a file defines, with their spelling and in its order."""
    found = dict(re.findall(r"^Definition (\w+) : R := ([\d.]*\d)\.$", theory[file], re.M))
    if not found:
        stop(f"{file}: there is no 'Definition NAME : R := NUMBER.'")
    return found


def exponents(theory, file, theorem, number_format):
    """The exponents in parentheses that follow the precision and the least exponent in a theorem about a step."""
    precision, emax = FORMATS[number_format]
    says = f"{theorem} {precision} ({3 - emax - precision})"
    found = re.search(rf"Theorem {theorem}\d+ : {re.escape(says)}((?: \(-?\d+\))+)\.", theory[file])
    if not found:
        stop(f"{file}: there is no 'Theorem {theorem}... : {says} (...).'")
    return [int(exponent) for exponent in re.findall(r"-?\d+", found.group(1))]


def float_exponents(text, number_format):
    """The exponents of the least and the greatest S of the theorem about the coarse step over IEEE-754 numbers."""
    precision, emax = FORMATS[number_format]
    found = re.search(rf"Theorem float_coarse_never_lies\d+ : float_coarse_never_lies {precision} {emax} \((-?\d+)\) (\d+) ", text)
    if not found:
        stop(f"CoarseFloat.v: there is no 'Theorem float_coarse_never_lies... : float_coarse_never_lies {precision} {emax} (...) ...'")
    return [int(found.group(1)), 2 * int(found.group(2))]


def dotted(comparison):
    """The name as reports spell it: vertex_a.side_b."""
    return re.sub("_(radius|side)", r".\1", comparison)


def header(exported, windows):
    tables = "\n".join(
        f"inline constexpr std::array<Threshold, comparison_count> {form}_thresholds = {{{{\n"
        + "".join(f"    {{{n}, {degree(form, name)}}},{'':{6 - len(str(n))}}// {dotted(name)}\n"
                  for n, name in zip(exported[form], COMPARISONS))
        + "}};" for form in FORMS)
    ends = {(f, i): f"static_cast<Real>(0x1p{windows[f][i]:+d})".replace("p+", "p") for f in FORMATS for i in range(2)}
    return f"""// The thresholds of the filter that is proved never to lie (docs/proofs.md). Written by
// proofs/write_thresholds.py out of the Coq theory: do not edit.
#pragma once

#include <array>

#include "kernel/sphere_triangle/names.h"

// clang-format off
namespace axiscert::filter {{

// A comparison's sides are of this degree in the coordinates; lhs > rhs is certain where lhs - rhs, as computed, exceeds
// n u m^degree, as computed: u = 2^-24 or 2^-53, m the greatest magnitude of a translated coordinate or the radius.
struct Threshold {{
  int n, degree;
}};
// By comparison. The same for both precisions, with fused multiply-adds or without.
{tables}

// The window of m, inclusive: inside it nothing overflows, and underflow is part of the thresholds.
template <class Real>
inline constexpr Real least_magnitude =
    sizeof(Real) == 4 ? {ends['binary32', 0]} : {ends['binary64', 0]};
template <class Real>
inline constexpr Real greatest_magnitude =
    sizeof(Real) == 4 ? {ends['binary32', 1]} : {ends['binary64', 1]};

}}  // namespace axiscert::filter
// clang-format on
"""


def margins_header(bounds, coarse, conservative, ends):
    def members(of):
        return "\n".join(f"  static constexpr double {name} = {value};" for name, value in of.items())

    coarse = {name.removeprefix("coarse_"): value for name, value in coarse.items()}
    conservative = {name.removeprefix("conservative_"): value for name, value in conservative.items()}
    for f in FORMATS:
        coarse[f"least_square_{f}"], coarse[f"greatest_square_{f}"] = (f"0x1p{exponent:+d}" for exponent in ends["coarse", f])
        conservative[f"least_square_{f}"], conservative[f"least_normal_{f}"] = (
            f"0x1p{exponent:+d}" for exponent in ends["conservative", f])
    return f"""// The constants of the bounds beside each margin, proved to suffice (docs/proofs.md). Written by
// proofs/write_thresholds.py out of the Coq theory: do not edit.
#pragma once

namespace axiscert::filter {{

// `units` are multiples of the relative error of an operation times unit_factor; the others are factors of what was
// bounded before (exact/sphere_triangle/oracles/margins-inl.h).
struct MarginBounds {{
{members(bounds)}
}};

// Multiples of u: of S, S E and S E^2, where S as computed is from least_square to greatest_square
// (kernel/sphere_triangle/certified/thresholds.h).
struct CoarseBounds {{
{members(coarse)}
}};

// Multiples of u W, W as computed no less than least_square and the scaled normal's square no less than least_normal
// (kernel/sphere_triangle/certified/conservative_step-inl.h).
struct ConservativeBounds {{
{members(conservative)}
}};

}}  // namespace axiscert::filter
"""


def listed(items):
    whole = "; ".join(item.replace(" ", "\0") for item in items)
    return "[" + textwrap.fill(whole, 112, subsequent_indent=" " * 5).replace("\0", " ") + "]"


def exported_v(exported, windows, bounds, coarse, conservative):
    def rows(form):
        pairs = [f"({n}, {degree(form, name)}%nat)" for n, name in zip(exported[form], COMPARISONS)]
        return listed(pairs)

    text = """(* The numbers of filter_thresholds.h in kernel/sphere_triangle/forms, proved of the filters that never lie, and those of
   margin_bounds.h beside it. Written by write_thresholds.py: do not edit. *)
From Coq Require Import Reals ZArith List.
From Flocq Require Import Core BinarySingleNaN.
From Axiscert Require Import Vectors Expression Programs Filter Thresholds Filters Margins Certified Conservative.
Import ListNotations.

Definition in_order :=
  """ + listed(COMPARISONS) + ".\n"
    for form in FORMS:
        text += f"""
(* n and the degree, by comparison. *)
Theorem exported_{form}_thresholds fused :
  map (fun K => ({form}_threshold K, degree (fst ({form}_program fused K)))) in_order =
    {rows(form)}%Z.
Proof. destruct fused; vm_compute; reflexivity. Qed.
"""
    for number_format, (precision, emax) in FORMATS.items():
        low, high = windows[number_format]
        bits = number_format.removeprefix("binary")
        text += f"""
(* The window of m in {number_format}, and that the filters are those of these thresholds in it. *)
Theorem exported_window_{number_format} :
  B2R least_{number_format} = bpow radix2 ({low}) /\\ B2R greatest_{number_format} = bpow radix2 {high}.
Proof. split; [apply least_{number_format}_value | apply greatest_{number_format}_value]. Qed.
Theorem exported_filters_{number_format} fused :
""" + " /\\\n".join(
            f"  {form}_filter{bits} fused =\n    filter {precision} {emax} _ _ ({form}_program fused) {form}_threshold "
            f"least_{number_format} greatest_{number_format}"
            for form in FORMS) + ".\nProof. split; reflexivity. Qed.\n"
    text += f"""
(* The constants of the theorems about margins. *)
Theorem exported_margin_bounds :
  {listed(bounds)} =
    {listed(bounds.values())}%R.
Proof. reflexivity. Qed.

(* The constants of the certified predicate's coarse step. *)
Theorem exported_coarse_bounds :
  {listed(coarse)} =
    {listed(coarse.values())}%R.
Proof. reflexivity. Qed.

(* The constants of its conservative test. *)
Theorem exported_conservative_bounds :
  {listed(conservative)} =
    {listed(conservative.values())}%R.
Proof. reflexivity. Qed.
"""
    return text


def exported(coq):
    """The text of each file by its name: of the headers, and of Exported.v."""
    theory = {name: (coq / folder / name).read_text() for folder, names in READ.items() for name in names}
    proved = {form: thresholds(theory["Thresholds.v"], form) for form in FORMS}
    windows = {f: [window_end(theory["Filters.v"], which, f) for which in ("least", "greatest")] for f in FORMATS}
    bounds, coarse, conservative = (constants(theory, file) for file in ("Margins.v", "Certified.v", "Conservative.v"))
    ends = {("conservative", f): exponents(theory, "ConservativeStep.v", "conservative_never_misses", f) for f in FORMATS}
    for f in FORMATS:
        ends["coarse", f] = float_exponents(theory["CoarseFloat.v"], f)
        if ends["coarse", f][:1] != exponents(theory, "CertifiedStep.v", "coarse_never_lies", f):
            stop(f"CertifiedStep.v and CoarseFloat.v: the least S differs in {f}")
    return {"filter_thresholds.h": header(proved, windows), "margin_bounds.h": margins_header(bounds, coarse, conservative, ends),
            "Exported.v": exported_v(proved, windows, bounds, coarse, conservative)}


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--coq", type=pathlib.Path, default=PROOFS / "coq")
    parser.add_argument("--headers", type=pathlib.Path, default=PROOFS.parent / "kernel" / "sphere_triangle" / "forms")
    options = parser.parse_args()
    texts = exported(options.coq)
    stale = False
    for name in ("filter_thresholds.h", "margin_bounds.h"):
        path = options.headers / name
        if options.check and (not path.exists() or path.read_text() != texts[name]):
            print(f"write_thresholds: {path} is not current: run proofs/write_thresholds.py", file=sys.stderr)
            stale = True
        elif not options.check:
            path.write_text(texts[name])
    sys.exit(1 if stale else 0)


if __name__ == "__main__":
    main()
