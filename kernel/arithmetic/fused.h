// Dot and cross products with fused multiply-add.
#pragma once

#include "kernel/arithmetic/number.h"

namespace axiscert::arithmetic {

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

}  // namespace axiscert::arithmetic
