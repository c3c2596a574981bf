// Arithmetic that keeps some of its rounding errors, by error-free transformations (Ogita, Rump and Oishi, "Accurate
// sum and dot product", 2005).
#pragma once

#include "kernel/base/number.h"

namespace axiscert::arithmetic {

template <class Base>
struct WithError {
  Base value, error;  // the exact result is value + error, unless an exponent limit was met
};

template <class Base>
WithError<Base> two_sum(const Base& a, const Base& b) {
  const Base sum = a + b, of_b = sum - a;
  return {sum, (a - (sum - of_b)) + (b - of_b)};
}

template <class Base>
WithError<Base> two_product(const Base& a, const Base& b) {
  const Base product = a * b;
  return {product, fused(a, b, -product)};
}

// Dot and cross products as if in twice the precision, then rounded (algorithm Dot2).
template <class Base>
struct CompensatedNumber : Number<CompensatedNumber<Base>, Base> {
  using Number<CompensatedNumber, Base>::Number;
  static CompensatedNumber dot(const Vec3<CompensatedNumber>& u, const Vec3<CompensatedNumber>& v) {
    const auto x = two_product(u.x.value, v.x.value), y = two_product(u.y.value, v.y.value),
               z = two_product(u.z.value, v.z.value);
    const auto xy = two_sum(x.value, y.value), xyz = two_sum(xy.value, z.value);
    return CompensatedNumber(xyz.value + ((((x.error + y.error) + xy.error) + z.error) + xyz.error));
  }
  static Vec3<CompensatedNumber> cross(const Vec3<CompensatedNumber>& u, const Vec3<CompensatedNumber>& v) {
    return cross_of(u, v,
                    [](const CompensatedNumber& a, const CompensatedNumber& b, const CompensatedNumber& c,
                       const CompensatedNumber& d) {
                      const auto ab = two_product(a.value, b.value), cd = two_product(-c.value, d.value);
                      const auto sum = two_sum(ab.value, cd.value);
                      return CompensatedNumber(sum.value + ((ab.error + cd.error) + sum.error));
                    });
  }
};

// Keeps the rounding error of the translation to the sphere's centre and carries it to first order through the
// operations that follow, which are rounded as usual. The difference from plain arithmetic shows the cost of the
// translation alone.
template <class Base>
struct ExactTranslation {
  Base value, lost;

  ExactTranslation() = default;
  explicit ExactTranslation(const Base& v) : value(v), lost(Base(0)) {}
  ExactTranslation(const Base& v, const Base& l) : value(v), lost(l) {}
  explicit operator Base() const { return value + lost; }

  static ExactTranslation translated(const ExactTranslation& x, const ExactTranslation& p) {
    const auto difference = two_sum(x.value, Base(-p.value));
    return {difference.value, difference.error};
  }
  friend ExactTranslation operator+(const ExactTranslation& a, const ExactTranslation& b) {
    return {a.value + b.value, a.lost + b.lost};
  }
  friend ExactTranslation operator-(const ExactTranslation& a, const ExactTranslation& b) {
    return {a.value - b.value, a.lost - b.lost};
  }
  friend ExactTranslation operator*(const ExactTranslation& a, const ExactTranslation& b) {
    return {a.value * b.value, a.value * b.lost + a.lost * b.value};
  }
  friend ExactTranslation operator/(const ExactTranslation& a, const ExactTranslation& b) {
    const Base quotient = a.value / b.value;
    return {quotient, (a.lost - quotient * b.lost) / b.value};
  }
  friend ExactTranslation square_root(const ExactTranslation& a) {
    using portable::square_root;
    const Base root = square_root(a.value), twice = root + root;
    return {root, twice > twice - twice ? Base(a.lost / twice) : twice};
  }
  friend ExactTranslation magnitude(const ExactTranslation& a) {
    const Base zero = a.value - a.value;
    return zero > a.value ? ExactTranslation{-a.value, -a.lost} : a;
  }
  friend bool operator>(const ExactTranslation& a, const ExactTranslation& b) { return Base(a) > Base(b); }
  friend bool operator>=(const ExactTranslation& a, const ExactTranslation& b) { return Base(a) >= Base(b); }
};

}  // namespace axiscert::arithmetic
