// R-infinity: a kernel's precision, operation order and rounding with an exponent that never ends. What differs from it
// is range.
#pragma once

#include "kernel/sphere_triangle/reference/scalar.h"

namespace axiscert {

// What the scalar reference (R) decides, and the same rounding steps without over- or underflow (R-infinity), for a
// valid query. unbounded() where the reference raised the overflow or underflow flag; where it raised neither, every
// result was in the normal range or exact, so that the two evaluations are the same. In an arithmetic in which the
// flags do not tell it is always unbounded().
struct Rounded {
  Outcome range_free, reference;
};
template <class Real>
Rounded rounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);

// R-infinity itself. By MPFR; but of formulae without divisions and roots, in binary32 and plain operations, on the
// processor (exact/sphere_triangle/unbounded/wide_range_float.h), to the same bits.
template <class Real>
Outcome unbounded(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);
template <class Real>
Outcome unbounded_by_mpfr(Formulae formulae, Arithmetic arithmetic, Strictness strictness, const Query<Real>& q);

}  // namespace axiscert
