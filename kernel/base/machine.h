// Number types of other machines: the article's own, and the mixed precision of large worlds.
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "kernel/base/number.h"

namespace axiscert::arithmetic {

// Single precision of the Cell's synergistic processor. Results are chopped; a result that would be subnormal is zero;
// exponent 255 is an ordinary exponent; results beyond the greatest number, (2 - 2^-23) 2^128, saturate to it; there is
// no infinity, no NaN and no negative zero. Source: Synergistic Processor Unit Instruction Set Architecture, "Single
// precision (extended-range mode)". On that machine division and square root are estimates refined in software; here
// they are the exact results, chopped. x/0 is the greatest number with the sign of x, and 0/0 is 0, as 0 times the
// greatest number is.
// The value is kept in a double: 24 significant bits, exponents from -126 to 128.
class Spu {
 public:
  Spu() = default;
  explicit Spu(float x) : value_(decoded(x)) {}
  // A value beyond binary32's greatest number becomes infinity, because binary32 cannot represent it.
  explicit operator float() const { return static_cast<float>(value_); }

  friend Spu operator+(const Spu& a, const Spu& b) {
    const double sum = a.value_ + b.value_, of_b = sum - a.value_;
    return chopped(sum, (a.value_ - (sum - of_b)) + (b.value_ - of_b));
  }
  friend Spu operator-(const Spu& a, const Spu& b) { return a + chopped(-b.value_, 0); }
  friend Spu operator*(const Spu& a, const Spu& b) {
    return chopped(a.value_ * b.value_, 0);
  }  // 48 bits: the product is exact
  friend Spu operator/(const Spu& a, const Spu& b) {
    if (b.value_ == 0) return chopped(a.value_ == 0 ? 0 : std::copysign(greatest, a.value_), 0);
    const double quotient = a.value_ / b.value_;
    return chopped(quotient, std::fma(-quotient, b.value_, a.value_) * (b.value_ < 0 ? -1 : 1));
  }
  friend Spu square_root(const Spu& a) {
    const double root = std::sqrt(std::fabs(a.value_));
    return chopped(root, std::fma(-root, root, std::fabs(a.value_)));
  }
  friend Spu magnitude(const Spu& a) { return chopped(std::fabs(a.value_), 0); }
  friend bool operator>(const Spu& a, const Spu& b) { return a.value_ > b.value_; }
  friend bool operator>=(const Spu& a, const Spu& b) { return a.value_ >= b.value_; }

 private:
  static constexpr double greatest = 0x1.fffffep+128, least = 0x1p-126;

  // The exact value near + rest, rounded toward zero; only the sign of `rest` is read.
  static Spu chopped(double near, double rest) {
    constexpr std::uint64_t below_binary32 = (std::uint64_t{1} << 29) - 1;
    auto bits = std::bit_cast<std::uint64_t>(near);
    // Rounding to double went away from zero and reached a binary32 number: the exact value is nearer to zero, and
    // chopping it gives a smaller number.
    if ((bits & below_binary32) == 0 && near != 0 && (near > 0) != (rest > 0) && rest != 0) --bits;
    double value = std::bit_cast<double>(bits & ~below_binary32);
    if (std::fabs(value) < least) value = 0;
    if (std::fabs(value) > greatest) value = std::copysign(greatest, value);
    Spu result;
    result.value_ = value;
    return result;
  }
  static double decoded(float x) {
    const auto bits = std::bit_cast<std::uint32_t>(x);
    const int exponent = static_cast<int>((bits >> 23) & 0xff);
    if (exponent == 0) return 0;
    const double size = std::ldexp(1.0 + (bits & 0x7fffff) * 0x1p-23, exponent - 127);
    return (bits >> 31) != 0 ? -size : size;
  }

  double value_ = 0;
};

// The practice in large worlds: vertices and centre are in the wide type, their difference is taken there and rounded,
// and the predicate runs in the narrow type. The radius is rounded too.
template <class Wide, class Narrow>
struct LargeWorld {
  Wide value;

  LargeWorld() = default;
  explicit LargeWorld(const Wide& v) : value(v) {}
  explicit operator Wide() const { return value; }

  static LargeWorld translated(const LargeWorld& x, const LargeWorld& p) {
    return LargeWorld(Wide(Narrow(Wide(x.value - p.value))));
  }
  friend LargeWorld operator+(const LargeWorld& a, const LargeWorld& b) { return wide(a.narrow() + b.narrow()); }
  friend LargeWorld operator-(const LargeWorld& a, const LargeWorld& b) { return wide(a.narrow() - b.narrow()); }
  friend LargeWorld operator*(const LargeWorld& a, const LargeWorld& b) { return wide(a.narrow() * b.narrow()); }
  friend LargeWorld operator/(const LargeWorld& a, const LargeWorld& b) { return wide(a.narrow() / b.narrow()); }
  friend LargeWorld square_root(const LargeWorld& a) {
    using portable::square_root;
    return wide(square_root(a.narrow()));
  }
  friend LargeWorld magnitude(const LargeWorld& a) {
    using portable::magnitude;
    return wide(magnitude(a.narrow()));
  }
  friend bool operator>(const LargeWorld& a, const LargeWorld& b) { return a.narrow() > b.narrow(); }
  friend bool operator>=(const LargeWorld& a, const LargeWorld& b) { return a.narrow() >= b.narrow(); }

 private:
  Narrow narrow() const { return Narrow(value); }
  static LargeWorld wide(const Narrow& x) { return LargeWorld(Wide(x)); }
};

}  // namespace axiscert::arithmetic
