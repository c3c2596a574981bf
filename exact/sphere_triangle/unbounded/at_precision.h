// The formulae at any precision: every operation is rounded once, to nearest even, to a number of bits chosen at run
// time. Inputs are not rounded, so that any difference from the exact formulae comes from the operations alone.
#pragma once

#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/reference/scalar.h"

namespace axiscert {

inline constexpr int least_bits = 2, greatest_bits = 256;

// `exponents`: those of binary32 or binary64 with gradual underflow; empty: unbounded. At 24 bits with the exponents of
// binary32, or 53 with those of binary64, this equals the plain scalar reference.
template <class Real>
Outcome at_precision(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                     std::optional<Precision> exponents);

// Results for both exponent ranges. If no operation over- or underflows, the second evaluation would repeat the first
// bit for bit and is omitted.
struct BothRanges {
  Outcome unlimited, limited;
};
template <class Real>
BothRanges at_precision_in_both_ranges(Formulae formulae, Strictness strictness, const Query<Real>& q, int bits,
                                       Precision exponents);

}  // namespace axiscert
