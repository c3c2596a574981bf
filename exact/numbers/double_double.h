// A number in twice the precision of T: an unevaluated sum of two floats. Straight-line code without branches, over any
// binary floating-point T, double or a vector of them, whose operations round to nearest.
//
// Error bounds are absolute, where Joldes, Muller and Popescu ("Tight and rigorous error bounds for basic building
// blocks of double-word arithmetic", 2017) have relative ones: a sum then needs no more than their "sloppy" eleven
// operations and three for a sum that is normalized whatever cancellation occurs. u is the unit roundoff of T; |low| <=
// u |high| in every result.
#pragma once

#include <cmath>
#include <type_traits>

#include "kernel/base/error_free.h"

namespace axiscert {

// a b and the error of its rounding, exactly, unless an intermediate result underflows: then the two are off by less
// than the underflow term in the error bound of DoubleDouble's product. Dekker's splitting overflows beyond 2^996.
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
  // in all, adds u times that. The last step is exact. Sums do not underflow.
  AXISCERT_INLINE friend DoubleDouble operator+(const DoubleDouble& a, const DoubleDouble& b) {
    const auto sum = arithmetic::two_sum(a.high, b.high);
    const auto result = arithmetic::two_sum(sum.value, T(sum.error + (a.low + b.low)));
    return {result.value, result.error};
  }
  AXISCERT_INLINE friend DoubleDouble operator-(const DoubleDouble& a, const DoubleDouble& b) { return a + -b; }

  // Error: at most 8 u^2 (1 + 10u) |result.high| + 2^-890, for binary64 and |a|, |b| <= 2^996. With P = |a.high
  // b.high|, the two mixed products err by u (u P) each, their sum by u (2 u P), its sum with the product's error by u
  // (3 u P), all but for factors 1 + 3u, and the omitted term, a.low b.low, is at most u^2 P; |result.high| >= P (1 -
  // 5u). The last step is exact, since its second term is at most 4 u P.
  //
  // Underflow: a mixed product errs by another 2^-1075. Where P >= 2^-900, no part of exact_product underflows: each is
  // zero or a multiple of u^2 P / 4. If P is less, everything but the leading product is below 2^-945 by more than the
  // factor that any sequence of these few roundings could make of it. Both are far below 2^-890.
  AXISCERT_INLINE friend DoubleDouble operator*(const DoubleDouble& a, const DoubleDouble& b) {
    const auto product = lossy_product(a, b);
    const T high = product.value + product.error;
    return {high, product.error - (high - product.value)};
  }

  // Overloads that kernel/base/geometry.h uses for the products of vectors: the leading parts are summed exactly, the
  // remainders in ordinary arithmetic. Error: at most 24 u^2 (1 + 10u) S + 2^-888, with S the sum of |a.high b.high|
  // over the products. Each product errs by 8 u^2 of its own magnitude, as above, and has a remainder of 3u of it; each
  // exact sum leaves u S at most. The sums of these remainders are, in order, at most 3u S, 4u S, 4u S and 5u S, with u
  // of each as their roundings; a difference of two products has the first two. The last step is exact.
  AXISCERT_INLINE static DoubleDouble dot(const portable::Vec3<DoubleDouble>& u,
                                          const portable::Vec3<DoubleDouble>& v) {
    const auto x = lossy_product(u.x, v.x), y = lossy_product(u.y, v.y), z = lossy_product(u.z, v.z);
    const auto xy = arithmetic::two_sum(x.value, y.value), xyz = arithmetic::two_sum(xy.value, z.value);
    const T rest = ((x.error + y.error) + xy.error) + (z.error + xyz.error);
    const auto result = arithmetic::two_sum(xyz.value, rest);
    return {result.value, result.error};
  }
  AXISCERT_INLINE static portable::Vec3<DoubleDouble> cross(const portable::Vec3<DoubleDouble>& u,
                                                            const portable::Vec3<DoubleDouble>& v) {
    return {difference(u.y, v.z, u.z, v.y), difference(u.z, v.x, u.x, v.z), difference(u.x, v.y, u.y, v.x)};
  }

 private:
  // a b before its last step: the rounded product of the high parts, and the remainder, which may be as great as 3u of
  // it.
  AXISCERT_INLINE static arithmetic::WithError<T> lossy_product(const DoubleDouble& a, const DoubleDouble& b) {
    const auto product = exact_product(a.high, b.high);
    return {product.value, product.error + (a.high * b.low + a.low * b.high)};
  }
  // a b - c d.
  AXISCERT_INLINE static DoubleDouble difference(const DoubleDouble& a, const DoubleDouble& b, const DoubleDouble& c,
                                                 const DoubleDouble& d) {
    const auto ab = lossy_product(a, b), cd = lossy_product(c, d);
    const auto sum = arithmetic::two_sum(ab.value, T(-cd.value));
    const auto result = arithmetic::two_sum(sum.value, T((ab.error - cd.error) + sum.error));
    return {result.value, result.error};
  }
};

}  // namespace axiscert
