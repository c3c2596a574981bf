// Comparisons combined, and choices by them, without a branch: over one number here, over the lanes of a vector in
// kernel/lanes-inl.h. Formulae that are to run in lanes too are written in these words.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_MOVING_SPHERE_CHOICE_H)
#define AXISCERT_KERNEL_MOVING_SPHERE_CHOICE_H

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

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
