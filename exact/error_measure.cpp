#include "exact/error_measure.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>
#include <limits>

namespace axiscert {
namespace {

Ring magnitude(const Ring& x) { return x.sign() == CGAL::NEGATIVE ? -x : x; }

mpz_class power_of_ten(int n) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), 10, static_cast<unsigned long>(n));
  return p;
}

}  // namespace

double Decimal6::value() const {
  if (is_zero()) return 0;
  // Powers of ten up to 10^22 are doubles: one exactly rounded operation gives the nearest.
  static constexpr double powers[] = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                      1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22};
  if (exponent <= 0 && exponent >= -22) return mantissa / powers[-exponent];
  if (exponent > 0 && exponent <= 22) return mantissa * powers[exponent];
  return std::strtod(fmt::format("{}e{}", mantissa, exponent).c_str(), nullptr);
}

std::string Decimal6::text() const {
  const double near = value();
  if (std::isfinite(near)) return fmt::format("{}", near);
  std::string digits = fmt::format("{}", mantissa);
  digits.erase(digits.find_last_not_of('0') + 1);
  return fmt::format("{}{}{}e+{}", digits[0], digits.size() > 1 ? "." : "", digits.substr(1), exponent + 5);
}

Decimal6 round_up(const Fraction& q) {
  if (q.numerator == 0) return {};
  // A first exponent from the bit lengths, two steps low at most, then mended by looking.
  const long bits = static_cast<long>(mpz_sizeinbase(q.numerator.get_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(q.denominator.get_mpz_t(), 2));
  int exponent = static_cast<int>(std::floor(static_cast<double>(bits - 1) * 0.30102999566398120)) - 5;
  for (;; ++exponent) {
    mpz_class numerator = q.numerator, denominator = q.denominator, mantissa;
    (exponent < 0 ? numerator : denominator) *= power_of_ten(std::abs(exponent));
    mpz_cdiv_q(mantissa.get_mpz_t(), numerator.get_mpz_t(), denominator.get_mpz_t());
    if (mantissa < 1000000) return {exponent, static_cast<std::uint32_t>(mantissa.get_ui())};
  }
}

template <class Real>
ComparisonError::ComparisonError(Real computed_lhs, Real computed_rhs, const Ring& exact_lhs, const Ring& exact_rhs)
    : digits_(std::numeric_limits<Real>::digits) {
  if (!std::isfinite(computed_lhs) || !std::isfinite(computed_rhs)) {
    kind_ = Kind::range_event;
    return;
  }
  difference_ = magnitude((Ring(static_cast<double>(computed_lhs)) - Ring(static_cast<double>(computed_rhs))) -
                          (exact_lhs - exact_rhs));
  if (difference_.is_zero()) return;
  scale_ = magnitude(exact_lhs) + magnitude(exact_rhs);
  if (scale_.is_zero()) {
    kind_ = Kind::without_scale;
    return;
  }
  const double numerator = difference_.to_double(), denominator = scale_.to_double();
  constexpr double least = 1e-290, greatest = 1e290;
  if (numerator < least || denominator < least || numerator > greatest || denominator > greatest) {
    upper_ = std::numeric_limits<double>::infinity();  // to_double may have left the range: only exact() tells
    return;
  }
  // to_double keeps at least 53 leading bits: relative error below 2^-51 each, and the quotient adds 2^-53. A relative
  // margin of 2^-40 covers the three, and the two roundings below, many times over.
  const double estimate = std::ldexp(numerator / denominator, digits_);
  lower_ = estimate * (1 - 0x1p-40);
  upper_ = estimate * (1 + 0x1p-40);
}
template ComparisonError::ComparisonError(float, float, const Ring&, const Ring&);
template ComparisonError::ComparisonError(double, double, const Ring&, const Ring&);

Fraction ComparisonError::exact() const {
  if (difference_.is_zero()) return {0, 1};
  // Both are dyadic: the denominators only shift.
  const Rational difference = rational(difference_), scale = rational(scale_);
  return {(difference.get_num() * scale.get_den()) << digits_, difference.get_den() * scale.get_num()};
}

bool ComparisonError::exceeds(const Rational& tolerance) const {
  const double near = tolerance.get_d();  // truncated: at most one ulp below
  if (upper_ < near) return false;
  if (lower_ > near * (1 + 0x1p-50) && near > 1e-290) return true;
  const Fraction error = exact();
  return error.numerator * tolerance.get_den() > tolerance.get_num() * error.denominator;
}

}  // namespace axiscert
