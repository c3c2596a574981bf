// The parts of the arithmetics: a number type around a base, which is float, double, or an MPFR value with the same
// precision and an unbounded exponent. Each operation rounds once, in the base, and all of them are visible here.
#pragma once

#include <cmath>

#include "kernel/base/geometry.h"

namespace axiscert::arithmetic {

using portable::Vec3;

inline float fused(float a, float b, float c) { return std::fma(a, b, c); }
inline double fused(double a, double b, double c) { return std::fma(a, b, c); }

// The base's own operations. `Self` derives from this class and replaces the operations in which it differs.
template <class Self, class Base>
struct Number {
  Base value;

  Number() = default;
  explicit Number(const Base& v) : value(v) {}
  explicit operator Base() const { return value; }

  friend Self operator+(const Self& a, const Self& b) { return Self(a.value + b.value); }
  friend Self operator-(const Self& a, const Self& b) { return Self(a.value - b.value); }
  friend Self operator*(const Self& a, const Self& b) { return Self(a.value * b.value); }
  friend Self operator/(const Self& a, const Self& b) { return Self(a.value / b.value); }
  friend Self square_root(const Self& a) {
    using portable::square_root;
    return Self(square_root(a.value));
  }
  friend Self magnitude(const Self& a) {
    using portable::magnitude;
    return Self(magnitude(a.value));
  }
  friend bool operator>(const Self& a, const Self& b) { return a.value > b.value; }
  friend bool operator>=(const Self& a, const Self& b) { return a.value >= b.value; }
};

// A cross product from a function that computes a b - c d.
template <class Self, class Difference>
Vec3<Self> cross_of(const Vec3<Self>& u, const Vec3<Self>& v, Difference&& difference_of_products) {
  return {difference_of_products(u.y, v.z, u.z, v.y), difference_of_products(u.z, v.x, u.x, v.z),
          difference_of_products(u.x, v.y, u.y, v.x)};
}

}  // namespace axiscert::arithmetic
