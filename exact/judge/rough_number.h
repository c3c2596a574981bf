// A number type of the formulae (kernel/formulae_kernel.h) that carries a running bound of what a computation in the
// precision Real may be wrong by: the a priori bound of every operation, times a factor.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "kernel/base/geometry.h"

namespace axiscert {

// K of exact/judge/clear.h: the times by which a margin has to exceed the bound of one rounding an
// operation, so that methods with other operations are in the right too.
inline constexpr double clear_factor = 16;

// K u of a precision, and K times its least normal number, by which a product that underflows may be wrong.
template <class Real>
inline constexpr double rough_unit = clear_factor * std::numeric_limits<Real>::epsilon() / 2;
template <class Real>
inline constexpr double rough_least = std::numeric_limits<Real>::min() * (sizeof(Real) == 4 ? clear_factor : 1);

// The exact value is within `error` of `value`. Where a result leaves the range, or divides by what may be 0, the error
// is infinite or not a number, and no comparison is certain. The double arithmetic that carries both is within K u
// itself, K being more than 1.
template <class Real>
class RoughNumber {
 public:
  RoughNumber() = default;
  explicit RoughNumber(double exact) : value_(exact) {}
  static RoughNumber within(double value, double error) {
    RoughNumber made(value);
    made.error_ = error;
    return made;
  }

  double value() const { return value_; }
  double error() const { return error_; }

  friend RoughNumber operator+(const RoughNumber& a, const RoughNumber& b) {
    return rounded(a.value_ + b.value_, a.error_ + b.error_);
  }
  friend RoughNumber operator-(const RoughNumber& a, const RoughNumber& b) {
    return rounded(a.value_ - b.value_, a.error_ + b.error_);
  }
  friend RoughNumber operator*(const RoughNumber& a, const RoughNumber& b) {
    // A product with an exact zero is exact.
    if ((a.value_ == 0 && a.error_ == 0) || (b.value_ == 0 && b.error_ == 0)) return RoughNumber(0);
    return rounded(a.value_ * b.value_, std::fabs(a.value_) * b.error_ + std::fabs(b.value_) * a.error_ +
                                            a.error_ * b.error_ + rough_least<Real>);
  }
  friend RoughNumber operator/(const RoughNumber& a, const RoughNumber& b) {
    const double least = std::fabs(b.value_) - b.error_, value = a.value_ / b.value_;
    if (!(least > 0)) return unknown();
    return rounded(value, (a.error_ + std::fabs(value) * b.error_) / least + rough_least<Real>);
  }
  friend RoughNumber magnitude(const RoughNumber& a) { return within(std::fabs(a.value_), a.error_); }
  // sqrt(v) - sqrt(v - e) <= e / sqrt(v), and sqrt(v + e) - sqrt(v) is less.
  friend RoughNumber square_root(const RoughNumber& a) {
    if (a.value_ == 0 && a.error_ == 0) return RoughNumber(0);
    if (!(a.value_ > a.error_)) return unknown();
    const double root = std::sqrt(a.value_);
    return rounded(root, a.error_ / root);
  }

  // By the values; see certain_sign() for whether it is certain.
  friend bool operator>(const RoughNumber& a, const RoughNumber& b) { return a.value_ > b.value_; }
  friend bool operator>=(const RoughNumber& a, const RoughNumber& b) { return a.value_ >= b.value_; }

  // Whether `a` - `b` certainly has the sign that the values have.
  friend bool is_certain(const RoughNumber& a, const RoughNumber& b) {
    const double error = a.error_ + b.error_;
    return error == 0 || std::fabs(a.value_ - b.value_) > error;
  }

 private:
  static RoughNumber unknown() { return within(0, std::numeric_limits<double>::infinity()); }
  static RoughNumber rounded(double value, double error) {
    constexpr double greatest = std::numeric_limits<Real>::max() / clear_factor;
    const double size = std::fabs(value);
    return size + error < greatest ? within(value, error + rough_unit<Real> * size) : unknown();
  }

  double value_ = 0, error_ = 0;
};

}  // namespace axiscert
