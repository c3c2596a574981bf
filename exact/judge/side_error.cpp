#include "exact/judge/side_error.h"

namespace axiscert {

SideError::SideError(double computed_lhs, double computed_rhs, const ExactComparison& exact, int digits)
    : digits_(digits), is_rooted_(exact.is_rooted) {
  if (exact.is_undefined || exact.is_times_root) {
    kind_ = Kind::without_scale;
    return;
  }
  if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
    kind_ = Kind::range_event;
    return;
  }
  const BinaryNumber computed = BinaryNumber(computed_lhs) - BinaryNumber(computed_rhs);
  double numerator, denominator;
  if (is_rooted_) {
    offset_ = computed * exact.rhs.under + exact.rhs.over;
    square_ = exact.lhs.over;
    rhs_ = magnitude(exact.rhs.over);
    // |offset - sqrt(s)| = |offset^2 - s| / (offset + sqrt(s)) if offset is positive: no cancellation remains.
    const double root = std::sqrt(square_.to_double()), offset = offset_.to_double();
    difference_ = magnitude(offset_ * offset_ - square_);
    if (offset_.sign() < 0) numerator = root - offset;
    else if (difference_.is_zero()) return;
    else numerator = difference_.to_double() / (offset + root);
    if (square_.is_zero() && rhs_.is_zero()) {
      kind_ = Kind::without_scale;
      return;
    }
    denominator = root + rhs_.to_double();
  } else {
    // All in one unit, which the error does not depend on.
    const auto take = [&](const BinaryNumber& off, const BinaryNumber& left, const BinaryNumber& right) {
      difference_ = magnitude(off - (left - right));
      if (!difference_.is_zero()) scale_ = magnitude(left) + magnitude(right);
    };
    const BinaryFraction &lhs = exact.lhs, &rhs = exact.rhs;
    if (lhs.under == rhs.under) take(computed * lhs.under, lhs.over, rhs.over);
    else take(computed * (lhs.under * rhs.under), lhs.over * rhs.under, rhs.over * lhs.under);
    if (difference_.is_zero()) return;
    if (scale_.is_zero()) {
      kind_ = Kind::without_scale;
      return;
    }
    numerator = difference_.to_double();
    denominator = scale_.to_double();
  }
  // Squares of the sides enter a rooted comparison: a narrower window keeps them within binary64's range.
  const double least = is_rooted_ ? 1e-140 : 1e-290, greatest = is_rooted_ ? 1e140 : 1e290;
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

Fraction SideError::exact() const {
  if (difference_.is_zero()) return {0, 1};
  const Rational difference = rational(difference_), scale = rational(scale_);
  return {(difference.get_num() * scale.get_den()) << digits_, difference.get_den() * scale.get_num()};
}

// |a - sqrt(s)| > t (sqrt(s) + r), with t = tolerance u >= 0:
//   a >= sqrt(s):  a - t r > (1 + t) sqrt(s);      a < sqrt(s):  (1 - t) sqrt(s) > a + t r;
// each the sign of x - y sqrt(s), by squares.
bool SideError::exactly_exceeds(const Rational& tolerance) const {
  if (!is_rooted_) {
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

bool SideError::exceeds(const Rational& tolerance) const {
  const double near = tolerance.get_d();  // truncated: at most one ulp below
  if (upper_ < near) return false;
  if (lower_ > near * (1 + 0x1p-50) && near > 1e-290) return true;
  return exactly_exceeds(tolerance);
}

Decimal6 SideError::rounded_up() const {
  if (!is_rooted_) return round_up(exact());
  if (difference_.is_zero() && offset_.sign() >= 0) return {};
  // An algebraic number: starting from an estimate, the least decimal that it does not exceed. As in the constructor,
  // the estimate is free of cancellation: 256 bits are enough.
  constexpr mp_bitcnt_t bits = 256;
  const mpf_class root = sqrt(mpf_class(rational(square_), bits)), offset(rational(offset_), bits);
  const mpf_class scale = root + mpf_class(rational(rhs_), bits);
  mpf_class error(0, bits);
  if (offset_.sign() < 0) error = (root - offset) / scale;
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
