// R-infinity: the kernel's precision and operation order with an unbounded exponent. What differs from it is range.
#pragma once

#include "kernel/evaluate.h"

namespace axiscert {

// Bits of the scalar reference (R) and of the same rounding steps without over- or underflow (R-infinity), for a valid
// query. MPFR at 24 or 53 bits where the reference raised the overflow or underflow flag; where it raised neither,
// every result was in the normal range or exact, so the two evaluations are the same.
struct RoundedBits {
  ComparisonBits range_free, reference;
};
template <class Real>
RoundedBits rounded_bits(const Query<Real>& q, Strictness strictness);

}  // namespace axiscert
