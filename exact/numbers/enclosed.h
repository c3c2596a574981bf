// A number with a bound of its error, carried through sums and products: every conclusion drawn from it is certain, or
// is not drawn.
#pragma once

#include <cmath>
#include <type_traits>

#include "exact/numbers/double_double.h"
#include "kernel/base/geometry.h"

namespace axiscert {

// The leading double of a number type, and bounds of the rounding errors of its sum and product. The bounds are
// computed, so they may themselves lie a few roundings below the quantities they bound.
AXISCERT_INLINE double leading(double x) { return x; }
AXISCERT_INLINE double leading(const DoubleDouble<double>& x) { return x.high; }

// u |result|, u = 2^-53: half an ulp. A sum does not underflow; a product that underflows is off by another 2^-1075,
// and the greater bound used here keeps subnormal numbers, which are slow, out of the processor. The bound of a sum may
// itself underflow: if the terms are products, their bounds are so much greater that `more` makes up for it; all other
// sums are of numbers as given.
AXISCERT_INLINE double sum_error(double, double, double sum) { return 0x1p-53 * std::fabs(sum); }
AXISCERT_INLINE double product_error(double product) { return 0x1p-53 * std::fabs(product) + 0x1p-1000; }
// The bounds of exact/numbers/double_double.h, their small factors rounded up.
AXISCERT_INLINE double sum_error(const DoubleDouble<double>& a, const DoubleDouble<double>& b,
                                 const DoubleDouble<double>&) {
  return 0x1.9p-105 * (std::fabs(a.high) + std::fabs(b.high));  // 3.125 u^2
}
AXISCERT_INLINE double product_error(const DoubleDouble<double>& product) {
  return 0x1.08p-103 * std::fabs(product.high) + 0x1p-890;  // 8.25 u^2
}

// Bounds are sums and products of non-negative numbers, each rounded to nearest: a bound made by k roundings, counted
// through all factors of its terms, is at least (1 - u)^k of its exact value. The same holds for |a.high| in place of
// |a|, which is at least (1 - u) of it. Nothing here makes k as great as 4,000, so this factor makes up for all of it.
inline constexpr double more = 1 + 0x1p-40, less = 1 - 0x1p-40;

template <class T>
struct EnclosedNumber {
  T value;
  double error;  // |exact - value| <= error more

  AXISCERT_INLINE friend EnclosedNumber operator+(const EnclosedNumber& a, const EnclosedNumber& b) {
    const T sum = a.value + b.value;
    return {sum, (a.error + b.error) + sum_error(a.value, b.value, sum)};
  }
  AXISCERT_INLINE friend EnclosedNumber operator-(const EnclosedNumber& a, const EnclosedNumber& b) {
    const T sum = a.value - b.value;
    return {sum, (a.error + b.error) + sum_error(a.value, b.value, sum)};
  }
  AXISCERT_INLINE friend EnclosedNumber operator*(const EnclosedNumber& a, const EnclosedNumber& b) {
    const T product = a.value * b.value;
    const double size_a = std::fabs(leading(a.value)), size_b = std::fabs(leading(b.value));
    return {product, (size_a * b.error + a.error * (size_b + b.error)) + product_error(product)};
  }

  // Certain bounds; NaN if the number or its bound is not finite, so a condition must be one that is false for NaN. An
  // exact zero has the bounds zero.
  AXISCERT_INLINE double low() const { return leading(value) - slack(); }
  AXISCERT_INLINE double high() const { return leading(value) + slack(); }

 private:
  // Covers error more, the low part of the value, u |value|, and the rounding of low() or high(), u (|value| +
  // slack()).
  AXISCERT_INLINE double slack() const { return error * (1 + 0x1p-39) + 0x1p-50 * std::fabs(leading(value)); }
};

// A vector with one error bound for all of its components.
template <class T>
struct EnclosedVector {
  portable::Vec3<T> value;
  double size;   // the sum of the magnitudes of the components' leading doubles
  double error;  // |exact - value| <= error more in each component
};
template <class T>
AXISCERT_INLINE portable::Vec3<double> leading(const portable::Vec3<T>& v) {
  return {leading(v.x), leading(v.y), leading(v.z)};
}
template <class T>
AXISCERT_INLINE EnclosedVector<T> enclosed(const portable::Vec3<T>& v, double error) {
  return {v, (std::fabs(leading(v.x)) + std::fabs(leading(v.y))) + std::fabs(leading(v.z)), error};
}

// A bound, rounded up, of the rounding error of a dot product, or of a component of a cross product, of vectors of
// sizes s and t. For doubles: u for a product, u for a sum of two and 2u for a sum of three, 3 u s t in all. For
// double-doubles: 8 u^2, 3 u^2 and 6 u^2, 14 u^2 s t in all. The sum of the products' magnitudes is at most s t.
template <class T>
AXISCERT_INLINE double products_error(double sizes) {
  if constexpr (std::is_same_v<T, double>) return 0x1.9p-52 * sizes + 0x1p-998;
  else return 0x1.ap-102 * sizes + 0x1p-888;
}

// The error that the components' own errors e and f cause: |u_i| f + |v_i| e + e f for each product, of which there are
// two or three.
template <class T>
AXISCERT_INLINE double carried_error(const EnclosedVector<T>& u, const EnclosedVector<T>& v) {
  return u.size * v.error + u.error * (v.size + 3 * v.error);
}
template <class T>
AXISCERT_INLINE EnclosedNumber<T> dot(const EnclosedVector<T>& u, const EnclosedVector<T>& v) {
  return {portable::dot(u.value, v.value), carried_error(u, v) + products_error<T>(u.size * v.size)};
}
template <class T>
AXISCERT_INLINE EnclosedVector<T> cross(const EnclosedVector<T>& u, const EnclosedVector<T>& v) {
  return enclosed(portable::cross(u.value, v.value), carried_error(u, v) + products_error<T>(u.size * v.size));
}

// The same number with a double as its value.
AXISCERT_INLINE EnclosedNumber<double> as_double(const EnclosedNumber<double>& x) { return x; }
AXISCERT_INLINE EnclosedNumber<double> as_double(const EnclosedNumber<DoubleDouble<double>>& x) {
  return {x.value.high, x.error + 0x1p-53 * std::fabs(x.value.high)};
}
AXISCERT_INLINE EnclosedVector<double> as_doubles(const EnclosedVector<double>& v) { return v; }
AXISCERT_INLINE EnclosedVector<double> as_doubles(const EnclosedVector<DoubleDouble<double>>& v) {
  return {leading(v.value), v.size, v.error + 0x1p-53 * v.size};
}

}  // namespace axiscert
