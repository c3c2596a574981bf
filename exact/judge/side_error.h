// The error of a computed comparison.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

#include "exact/judge/exact_sides.h"
#include "exact/numbers/rational.h"

namespace axiscert {

// The error of one comparison, in units of u: |(l^ - r^) - (l - r)| / (u (|l| + |r|)), where l^, r^ are the computed
// sides, subtracted exactly, l, r the exact ones, and u = 2^-24 or 2^-53. 0/0 counts as 0.
class SideError {
 public:
  enum class Kind : std::uint8_t {
    finite,
    without_scale,  // a non-zero difference over |l| + |r| = 0, or sides of which exact arithmetic has no sizes
    range_event,    // a computed side is not finite
  };

  // `Real` is the precision in which lhs and rhs were computed; it determines u.
  template <class Real>
  SideError(Real computed_lhs, Real computed_rhs, const ExactComparison& exact)
      : SideError(static_cast<double>(computed_lhs), static_cast<double>(computed_rhs), exact,
                  std::numeric_limits<Real>::digits) {}

  Kind kind() const { return kind_; }
  // Certain bounds, lower <= error <= upper, for selecting candidates only.
  double lower() const { return lower_; }
  double upper() const { return upper_; }
  // The error itself, rounded up. Only valid for Kind::finite.
  Decimal6 rounded_up() const;
  // The error before rounding. Only valid for Kind::finite if no side is a root.
  Fraction exact() const;
  bool exceeds(const Rational& tolerance) const;

 private:
  SideError(double computed_lhs, double computed_rhs, const ExactComparison& exact, int digits);
  bool exactly_exceeds(const Rational& tolerance) const;

  Kind kind_ = Kind::finite;
  int digits_;
  // Without a root: |(l^ - r^) - (l - r)| and |l| + |r|, times the sides' denominator. With a root, l = sqrt(s): the
  // difference is |offset - sqrt(s)| and the scale sqrt(s) + |r|, times the same denominator.
  bool is_rooted_ = false;
  BinaryNumber difference_, scale_;
  BinaryNumber offset_, square_, rhs_;
  double lower_ = 0, upper_ = 0;
};

// No less than the error, from the leading words alone: infinite where these do not tell, as where it is of another
// kind than `finite`.
template <class Real>
double side_error_at_most(Real computed_lhs, Real computed_rhs, const ExactComparison& exact) {
  using Long = long double;
  constexpr double unknown = std::numeric_limits<double>::infinity();
  if (exact.is_rooted || exact.is_undefined || exact.is_times_root || !exact.lhs.is_whole() || !exact.rhs.is_whole())
    return unknown;
  // All that is rounded, and what the leading words leave out, is less than this part of the four numbers: a few
  // roundings, and 2^-62 of an exact side.
  constexpr Long lost = std::max(16 * std::numeric_limits<Long>::epsilon(), Long(0x1p-59));
  const Long left = exact.lhs.over.approximately(), right = exact.rhs.over.approximately();
  const Long scale = std::fabs(left) + std::fabs(right);
  const Long computed = static_cast<Long>(computed_lhs) - static_cast<Long>(computed_rhs);
  const Long sizes = std::fabs(static_cast<Long>(computed_lhs)) + std::fabs(static_cast<Long>(computed_rhs)) + scale;
  const Long error = (std::fabs(computed - (left - right)) + lost * sizes) / scale;
  const bool is_known = scale > std::numeric_limits<Long>::min() / lost && error < std::numeric_limits<float>::max();
  constexpr Long one_u = Long(1) * (std::uint64_t{1} << std::numeric_limits<Real>::digits);
  return is_known ? static_cast<double>(error * one_u * (1 + 0x1p-40L)) : unknown;
}

}  // namespace axiscert
