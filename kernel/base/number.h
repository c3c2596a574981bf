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

// Dot and cross products with fused multiply-add.

// dot = fma(z, z', fma(y, y', x x')), cross.x = fma(y, z', -(z y')): three roundings in a dot product instead of five,
// two in each component of a cross product instead of three. A cross product of a vector with itself need not vanish:
// one of its two products is rounded and the other is not.
template <class Base>
struct FusedNumber : Number<FusedNumber<Base>, Base> {
  using Number<FusedNumber, Base>::Number;
  static FusedNumber dot(const Vec3<FusedNumber>& u, const Vec3<FusedNumber>& v) {
    return FusedNumber(fused(u.z.value, v.z.value, fused(u.y.value, v.y.value, u.x.value * v.x.value)));
  }
  static Vec3<FusedNumber> cross(const Vec3<FusedNumber>& u, const Vec3<FusedNumber>& v) {
    return cross_of(u, v, [](const FusedNumber& a, const FusedNumber& b, const FusedNumber& c, const FusedNumber& d) {
      return FusedNumber(fused(a.value, b.value, -(c.value * d.value)));
    });
  }
};

// a b + c d with an error of at most 1.5 ulp: W. Kahan's algorithm (analysed by Jeannerod, Louvet and Muller, Math.
// Comp. 2013).
template <class Base>
Base kahan_sum(const Base& a, const Base& b, const Base& c, const Base& d) {
  const Base product = c * d;
  const Base lost = fused(c, d, -product);
  return fused(a, b, product) + lost;
}

// The cross product by Kahan's difference of two products; the dot product as Kahan's sum of the first two products,
// then one fma.
template <class Base>
struct Kahan : Number<Kahan<Base>, Base> {
  using Number<Kahan, Base>::Number;
  static Kahan dot(const Vec3<Kahan>& u, const Vec3<Kahan>& v) {
    return Kahan(fused(u.z.value, v.z.value, kahan_sum(u.x.value, v.x.value, u.y.value, v.y.value)));
  }
  static Vec3<Kahan> cross(const Vec3<Kahan>& u, const Vec3<Kahan>& v) {
    return cross_of(u, v, [](const Kahan& a, const Kahan& b, const Kahan& c, const Kahan& d) {
      return Kahan(kahan_sum(a.value, b.value, -c.value, d.value));
    });
  }
};

// The same operations in another order of association.

// The two products of a dot product that are added first; the published order is x + y. Addition commutes, so these
// three are all the orders.
enum class FirstPair { y_and_z, x_and_z };

template <class Base, FirstPair first>
struct DotOrder : Number<DotOrder<Base, first>, Base> {
  using Number<DotOrder, Base>::Number;
  static DotOrder dot(const Vec3<DotOrder>& u, const Vec3<DotOrder>& v) {
    const DotOrder x = u.x * v.x, y = u.y * v.y, z = u.z * v.z;
    return first == FirstPair::y_and_z ? x + (y + z) : (x + z) + y;
  }
};

// rr (e e) in place of (rr e) e.
template <class Base>
struct SquareFirst : Number<SquareFirst<Base>, Base> {
  using Number<SquareFirst, Base>::Number;
  static SquareFirst times_square(const SquareFirst& rr, const SquareFirst& e) { return rr * (e * e); }
};

}  // namespace axiscert::arithmetic
