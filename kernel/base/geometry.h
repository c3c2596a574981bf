// Vectors, their products and the problem that every formula starts from, over any number type with + - *.
//
// The order of operations, part of the contract of every kernel that does not say otherwise:
//   dot = (x x' + y y') + z z',   cross.x = y z' - z y' (cyclic),   rr e e = (rr e) e.
// A number type may replace these by static members `dot`, `cross`, `times_square` and `translated`; that is how an
// arithmetic (fused, compensated, another order) is put under an unchanged formula.
//
// This file is included once by ordinary code, and again by each simd_*.cpp, which defines AXISCERT_PER_TARGET, for
// each of Highway's instruction sets: the functions must carry that set's target attribute to be inlined. Hence it has
// no include guard in that case, and a namespace for each target.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_GEOMETRY_H)
#define AXISCERT_KERNEL_GEOMETRY_H

#include <cmath>

#include "kernel/base/per_target.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

template <class T>
struct Vec3 {
  T x, y, z;
  AXISCERT_INLINE friend Vec3 operator+(const Vec3& u, const Vec3& v) { return {u.x + v.x, u.y + v.y, u.z + v.z}; }
  AXISCERT_INLINE friend Vec3 operator-(const Vec3& u, const Vec3& v) { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  AXISCERT_INLINE friend Vec3 operator*(const Vec3& u, const T& s) { return {u.x * s, u.y * s, u.z * s}; }
  AXISCERT_INLINE friend Vec3 operator/(const Vec3& u, const T& s) { return {u.x / s, u.y / s, u.z / s}; }
};

template <class T>
AXISCERT_INLINE T dot(const Vec3<T>& u, const Vec3<T>& v) {
  if constexpr (requires { T::dot(u, v); }) return T::dot(u, v);
  else return (u.x * v.x + u.y * v.y) + u.z * v.z;
}

template <class T>
AXISCERT_INLINE Vec3<T> cross(const Vec3<T>& u, const Vec3<T>& v) {
  if constexpr (requires { T::cross(u, v); }) return T::cross(u, v);
  else return {u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
}

// rr e^2, as (rr e) e.
template <class T>
AXISCERT_INLINE T times_square(const T& rr, const T& e) {
  if constexpr (requires { T::times_square(rr, e); }) return T::times_square(rr, e);
  else return (rr * e) * e;
}

// v - p: a vertex with the sphere's centre moved to the origin.
template <class T>
AXISCERT_INLINE Vec3<T> translated(const Vec3<T>& v, const Vec3<T>& p) {
  if constexpr (requires { T::translated(v.x, p.x); }) {
    return {T::translated(v.x, p.x), T::translated(v.y, p.y), T::translated(v.z, p.z)};
  } else {
    return v - p;
  }
}

// A query in the number type of the formulae, and that type's zero.
template <class T>
struct Problem {
  Vec3<T> a, b, c, p;
  T r, zero;
};

// The problem with the sphere's centre at the origin; rr is the squared radius.
template <class T>
struct CentredProblem {
  Vec3<T> a, b, c;
  T rr;
};

template <class T>
AXISCERT_INLINE CentredProblem<T> centred(const Problem<T>& q) {
  return {translated(q.a, q.p), translated(q.b, q.p), translated(q.c, q.p), q.r * q.r};
}

#ifndef AXISCERT_PER_TARGET
// Square root and absolute value by name, for the forms of the derivation that still need them. Other number types
// define their own, which are found by argument-dependent lookup.
AXISCERT_INLINE float square_root(float x) { return std::sqrt(x); }
AXISCERT_INLINE double square_root(double x) { return std::sqrt(x); }
AXISCERT_INLINE float magnitude(float x) { return std::fabs(x); }
AXISCERT_INLINE double magnitude(double x) { return std::fabs(x); }
#endif

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
