// A number in twice the precision of T: an unevaluated sum of two floats. Straight-line code without branches, over any
// binary floating-point T, double or a vector of them, whose operations round to nearest.
//
// Error bounds are absolute, where Joldes, Muller and Popescu ("Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic", 2017) have relative ones: a sum then needs no more than their "sloppy" eleven
// operations and three for a sum that is normalized whatever cancels. u is the unit roundoff of T; |low| <= u |high| in
// every result.
#pragma once

#include <cmath>
#include <type_traits>

#include "kernel/arithmetic/error_free.h"

namespace axiscert {

// a b and the error of its rounding, exactly, unless something in it underflows: then the two are off by less than the
// bound that DoubleDouble's product has for that. Dekker's splitting overflows beyond 2^996.
template <class T>
AXISCERT_INLINE arithmetic::WithError<T> exact_product(const T& a, const T& b) {
#ifdef __FP_FAST_FMA
  if constexpr (std::is_same_v<T, double>) {
    const double product = a * b;
    return {product, std::fma(a, b, -product)};
  }
#endif
  constexpr double splitter = 0x1p27 + 1;  // 53 bits into 26 and 26, and a sign
  const T a_scaled = a * T(splitter), b_scaled = b * T(splitter);
  const T a_high = a_scaled - (a_scaled - a), a_low = a - a_high;
  const T b_high = b_scaled - (b_scaled - b), b_low = b - b_high;
  const T product = a * b;
  return {product, ((a_high * b_high - product) + a_high * b_low + a_low * b_high) + a_low * b_low};
}

template <class T>
struct DoubleDouble {
  T high, low;

  AXISCERT_INLINE DoubleDouble operator-() const { return {-high, -low}; }

  // Error: at most 3 u^2 (1 + 4u) (|a.high| + |b.high|). With S = |a.high| + |b.high|: the low parts sum with an error
  // of u (u S) at most; the error of the sum of the high parts is at most u S, and adding it to theirs, 2 u S (1 + u)
  // in all, errs by u times that. The last step is exact. Sums do not underflow.
  AXISCERT_INLINE friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto sum = arithmetic::two_sum(a.high, b.high);
    const auto result = arithmetic::two_sum(sum.value, T(sum.error + (a.low + b.low)));
    return {result.value, result.error};
  }
  AXISCERT_INLINE friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

  // Error: at most 8 u^2 (1 + 10u) |result.high| + 2^-890, for binary64 and |a|, |b| <= 2^996. With P = |a.high
  // b.high|, the two mixed products err by u (u P) each, their sum by u (2 u P), its sum with the product's error by u
  // (3 u P), all but for factors 1 + 3u, and what is left out, a.low b.low, is at most u^2 P; |result.high| >= P (1 -
  // 5u). The last step is exact, since its second term is at most 4 u P.
  //
  // Underflow: a mixed product errs by another 2^-1075. Where P >= 2^-900, no part of exact_product underflows: each is
  // zero or a multiple of u^2 P / 4. Where P is less, everything but the leading product is below 2^-945 by more than
  // the factor that any sequence of these few roundings could make of it. Both are far below 2^-890.
  AXISCERT_INLINE friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto product = exact_product(a.high, b.high);
    const T rest = product.error + (a.high * b.low + a.low * b.high);
    const T high = product.value + rest;
    return {high, rest - (high - product.value)};
  }
};

}  // namespace axiscert
