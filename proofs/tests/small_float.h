// A binary floating-point number of a few bits, gradual underflow included: every operation rounded to nearest, ties to
// even. Its exponents have no upper end.
#pragma once

#include <algorithm>
#include <cmath>

namespace axiscert::proofs {

// `Digits` significant bits, the leading one included; `LeastExponent` that of the last place of the least number. As
// binary32: 24, -149. Held in a double, where a sum or a product of two such numbers is exact before it is rounded:
// products have 2 Digits bits; sums have at most 53, by which exponents may be apart here.
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
