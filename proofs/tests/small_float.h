// A binary floating-point number of a few bits, with gradual underflow: every operation is rounded to nearest, ties to
// even. Its exponents have no upper limit.
#pragma once

#include <algorithm>
#include <cmath>

namespace axiscert::proofs {

// `Digits` is the number of significant bits, the leading one included; `LeastExponent` is the exponent of the least
// number's last place. binary32 has 24 and -149. The number is kept in a double, in which a sum or a product of two
// such numbers is exact before it is rounded: products have 2 Digits bits; sums have at most 53, because exponents are
// not farther apart here.
template <int Digits, int LeastExponent>
class SmallFloat {
 public:
  SmallFloat() = default;
  explicit SmallFloat(double exact) : value_(rounded(exact)) {}
  double value() const { return value_; }

  friend SmallFloat operator+(const SmallFloat& a, const SmallFloat& b) { return SmallFloat(a.value_ + b.value_); }
  friend SmallFloat operator-(const SmallFloat& a, const SmallFloat& b) { return SmallFloat(a.value_ - b.value_); }
  friend SmallFloat operator*(const SmallFloat& a, const SmallFloat& b) { return SmallFloat(a.value_ * b.value_); }

 private:
  static double rounded(double x) {
    if (x == 0) return x;
    const int last_place = std::max(std::ilogb(x) - (Digits - 1), LeastExponent);
    return std::ldexp(std::nearbyint(std::ldexp(x, -last_place)), last_place);
  }
  double value_ = 0;
};

}  // namespace axiscert::proofs
