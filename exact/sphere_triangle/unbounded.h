// R-infinity: a kernel's precision, operation order and rounding with an unbounded exponent. Any difference between it
// and the kernel's reference is due to range. And the formulae at any precision.
#pragma once

#include "exact/judge/judge.h"
#include "exact/numbers/floating.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
// The decisions of the scalar reference (R), and of the same rounding steps without over- or underflow (R-infinity),
// for a valid query. The latter is unbounded() if the reference raised the overflow or underflow flag; if it raised
// neither, every result was in the normal range or exact, so that the two evaluations are the same. In an arithmetic in
// which the flags are not reliable it is always unbounded().
template <class Real>
RoundedDecisions rounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);

// R-infinity itself. By MPFR, except for formulae without divisions and roots in binary32 and plain operations, which
// run on the processor (exact/sphere_triangle/wide_range_float.h) with the same bits.
template <class Real>
Outcome unbounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);
template <class Real>
Outcome unbounded_by_mpfr(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);

// The formulae at any precision: every operation is rounded once, to nearest even, to a number of bits chosen at run
// time. Inputs are not rounded, so that any difference from the exact formulae comes from the operations alone.

// `exponents`: with gradual underflow; empty: unbounded. At 24 bits with the exponents of binary32, or 53 with those of
// binary64, this equals the plain scalar reference.
template <class Real>
Outcome at_precision(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                     std::optional<ExponentLimits> exponents);

// Which operations are fused: none, or those of dot and cross products, as the arithmetic `fma` has them.
enum class Contraction : std::uint8_t { none, dots };
template <>
inline constexpr std::size_t enum_count<Contraction> = 2;
inline constexpr EnumArray<Contraction, std::string_view> contraction_names = {"none", "dots"};
constexpr std::string_view name(Contraction contraction) { return contraction_names[contraction]; }
// Whether the formulae have a form with it: every one without, the rungs with fused dot and cross products.
bool has_contraction(Formulae formulae, Contraction contraction);

// Results for both exponent ranges: unbounded, and those of the format, which has some. If no operation over- or
// underflows, the second evaluation would repeat the first bit for bit and is omitted. The formulae have the
// contraction.
struct BothRanges {
  Outcome unlimited, limited;
};
template <class Real>
BothRanges in_both_ranges(Formulae formulae, Strictness strictness, const Query<Real>& q, const FloatingFormat& format,
                          Contraction contraction = Contraction::none);

// Both sides of every comparison in the format, each as the nearest binary64 number: itself, where the format's numbers
// are such. Empty for formulae without comparisons. The formulae have the contraction.
template <class Real>
std::optional<Sides<double>> sides_in_format(Formulae formulae, const Query<Real>& q, const FloatingFormat& format,
                                             Contraction contraction = Contraction::none);

// The query whose numbers are rounded to the format, to nearest even; empty where one of them becomes infinite or NaN,
// or is beyond the query's own precision.
template <class Real>
std::optional<Query<Real>> rounded_to(const Query<Real>& q, const FloatingFormat& format);

}  // namespace axiscert
