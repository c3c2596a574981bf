// Comparisons combined, and choices by them, without a branch: over one number here, over the lanes of a vector in
// kernel/lanes-inl.h. Formulae that are to run in lanes too are written in these words, as is the triangle's nearest
// point here.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_MOVING_SPHERE_BRANCHLESS_H)
#define AXISCERT_KERNEL_MOVING_SPHERE_BRANCHLESS_H

#include "kernel/base/geometry.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

#ifndef AXISCERT_PER_TARGET
AXISCERT_INLINE bool both(bool a, bool b) { return a & b; }
AXISCERT_INLINE bool either(bool a, bool b) { return a | b; }
AXISCERT_INLINE bool opposite(bool a) { return !a; }
AXISCERT_INLINE float chosen(bool where, float yes, float no) { return where ? yes : no; }
AXISCERT_INLINE double chosen(bool where, double yes, double no) { return where ? yes : no; }
#endif

// The result of a comparison of two numbers.
template <class T>
using ComparisonResult = decltype(T() > T());

template <class T>
AXISCERT_INLINE Vec3<T> chosen(const ComparisonResult<T>& where, const Vec3<T>& yes, const Vec3<T>& no) {
  return {chosen(where, yes.x, no.x), chosen(where, yes.y, no.y), chosen(where, yes.z, no.z)};
}

// The point of a triangle that is nearest to the origin.
// methods::ClosestPoint::closest, bit for bit (a test compares them): the points of all seven regions, of which the
// first whose signs hold is chosen. A = B gives NaN.
// Source: C. Ericson, Real-Time Collision Detection (2005), section 5.1.5.
template <class T>
AXISCERT_INLINE Vec3<T> nearest_point(const Vec3<T>& a, const Vec3<T>& b, const Vec3<T>& c) {
  const T zero(0.0);
  const Vec3<T> ab = b - a, ac = c - a;
  const T one_a = zero - dot(ab, a), two_a = zero - dot(ac, a);
  const T one_b = zero - dot(ab, b), two_b = zero - dot(ac, b);
  const T one_c = zero - dot(ab, c), two_c = zero - dot(ac, c);
  const T weight_c = one_a * two_b - one_b * two_a, weight_b = one_c * two_a - one_a * two_c;
  const T weight_a = one_b * two_c - one_c * two_b;
  const T past_b = two_b - one_b, past_c = one_c - two_c;
  const T all = (weight_a + weight_b) + weight_c;

  Vec3<T> point = (a + ab * (weight_b / all)) + ac * (weight_c / all);
  point = chosen(both(zero >= weight_a, both(past_b >= zero, past_c >= zero)),
                 b + (c - b) * (past_b / (past_b + past_c)), point);
  point = chosen(both(zero >= weight_b, both(two_a >= zero, zero >= two_c)), a + ac * (two_a / (two_a - two_c)), point);
  point = chosen(both(two_c >= zero, two_c >= one_c), c, point);
  point = chosen(both(zero >= weight_c, both(one_a >= zero, zero >= one_b)), a + ab * (one_a / (one_a - one_b)), point);
  point = chosen(both(one_b >= zero, one_b >= two_b), b, point);
  return chosen(both(opposite(one_a > zero), opposite(two_a > zero)), a, point);
}

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
