#include "exact/sphere_triangle/measures/error_measure.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace axiscert {
namespace {

Ring magnitude(const Ring& x) { return x.sign() == CGAL::NEGATIVE ? -x : x; }

}  // namespace

template <class Real>
ComparisonError::ComparisonError(Real computed_lhs, Real computed_rhs, const ExactComparison& exact)
    : digits_(std::numeric_limits<Real>::digits) {
  if (exact.undefined) {
    kind_ = Kind::without_scale;
    return;
  }
  if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
    kind_ = Kind::range_event;
    return;
  }
  const Ring computed =
      (Ring(static_cast<double>(computed_lhs)) - Ring(static_cast<double>(computed_rhs))) * exact.denominator;
  rooted_ = exact.rooted;
  double numerator, denominator;
  if (rooted_) {
    offset_ = computed + exact.rhs;
    square_ = exact.lhs;
    rhs_ = magnitude(exact.rhs);
    // |offset - sqrt(s)| = |offset^2 - s| / (offset + sqrt(s)) if offset is positive: no cancellation remains.
    const double root = std::sqrt(square_.to_double()), offset = offset_.to_double();
    difference_ = magnitude(offset_ * offset_ - square_);
    if (offset_.sign() == CGAL::NEGATIVE) numerator = root - offset;
    else if (difference_.is_zero()) return;
    else numerator = difference_.to_double() / (offset + root);
    if (square_.is_zero() && rhs_.is_zero()) {
      kind_ = Kind::without_scale;
      return;
    }
    denominator = root + rhs_.to_double();
  } else {
    difference_ = magnitude(computed - (exact.lhs - exact.rhs));
    if (difference_.is_zero()) return;
    scale_ = magnitude(exact.lhs) + magnitude(exact.rhs);
    if (scale_.is_zero()) {
      kind_ = Kind::without_scale;
      return;
    }
    numerator = difference_.to_double();
    denominator = scale_.to_double();
  }
  // Squares of the sides enter a rooted comparison: a narrower window keeps them within binary64's range.
  const double least = rooted_ ? 1e-140 : 1e-290, greatest = rooted_ ? 1e140 : 1e290;
  if (!(numerator > least && denominator > least && numerator < greatest && denominator < greatest)) {
    // to_double may have left the range: only exact arithmetic decides
    upper_ = std::numeric_limits<double>::infinity();
    return;
  }
  // to_double keeps at least 53 leading bits: relative error below 2^-51; the few roots, sums of one sign and quotients
  // after it add 2^-53 each. A relative margin of 2^-40 covers them all many times over.
  const double estimate = std::ldexp(numerator / denominator, digits_);
  lower_ = estimate * (1 - 0x1p-40);
  upper_ = estimate * (1 + 0x1p-40);
}
template ComparisonError::ComparisonError(float, float, const ExactComparison&);
template ComparisonError::ComparisonError(double, double, const ExactComparison&);

Fraction ComparisonError::exact() const {
  if (difference_.is_zero()) return {0, 1};
  // Both are dyadic: the denominators only shift.
  const Rational difference = rational(difference_), scale = rational(scale_);
  return {(difference.get_num() * scale.get_den()) << digits_, difference.get_den() * scale.get_num()};
}

// |a - sqrt(s)| > t (sqrt(s) + r), with t = tolerance u >= 0:
//   a >= sqrt(s):  a - t r > (1 + t) sqrt(s);      a < sqrt(s):  (1 - t) sqrt(s) > a + t r;
// each the sign of x - y sqrt(s), by squares.
bool ComparisonError::exactly_exceeds(const Rational& tolerance) const {
  if (!rooted_) {
    const Fraction error = exact();
    return error.numerator * tolerance.get_den() > tolerance.get_num() * error.denominator;
  }
  const Rational t = tolerance / Rational(mpz_class(1) << digits_), a = rational(offset_), s = rational(square_),
                 r = rational(rhs_);
  const auto order_with_root = [&](const Rational& x, const Rational& y) {  // the sign of x - y sqrt(s)
    const int sign_x = sgn(x), sign_y = sgn(s) == 0 ? 0 : sgn(y);
    if (sign_x != sign_y || sign_x == 0) return (sign_x > sign_y) - (sign_x < sign_y);
    return sign_x * cmp(Rational(x * x), Rational(y * y * s));
  };
  if (order_with_root(a, 1) >= 0) return order_with_root(a - t * r, 1 + t) > 0;
  return order_with_root(a + t * r, 1 - t) < 0;
}

bool ComparisonError::exceeds(const Rational& tolerance) const {
  const double near = tolerance.get_d();  // truncated: at most one ulp below
  if (upper_ < near) return false;
  if (lower_ > near * (1 + 0x1p-50) && near > 1e-290) return true;
  return exactly_exceeds(tolerance);
}

Decimal6 ComparisonError::rounded_up() const {
  if (!rooted_) return round_up(exact());
  if (difference_.is_zero() && offset_.sign() != CGAL::NEGATIVE) return {};
  // An algebraic number: starting from an estimate, the least decimal that it does not exceed. As in the constructor,
  // the estimate is free of cancellation: 256 bits are enough.
  constexpr mp_bitcnt_t bits = 256;
  const mpf_class root = sqrt(mpf_class(rational(square_), bits)), offset(rational(offset_), bits);
  const mpf_class scale = root + mpf_class(rational(rhs_), bits);
  mpf_class error(0, bits);
  if (offset_.sign() == CGAL::NEGATIVE) error = (root - offset) / scale;
  else error = mpf_class(rational(difference_), bits) / ((root + offset) * scale);
  mpf_mul_2exp(error.get_mpf_t(), error.get_mpf_t(), static_cast<mp_bitcnt_t>(digits_));
  Decimal6 least = round_up(Rational(error));
  while (exactly_exceeds(axiscert::exact(least))) least = next(least);
  for (;;) {
    const Decimal6 below = previous(least);
    if (exactly_exceeds(axiscert::exact(below))) return least;
    least = below;
  }
}

}  // namespace axiscert
