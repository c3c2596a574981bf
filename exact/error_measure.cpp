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
  return is_zero() ? 0.0 : std::strtod(fmt::format("{}e{}", mantissa, exponent).c_str(), nullptr);
}

Decimal6 round_up(const Rational& q) {
  if (sgn(q) == 0) return {};
  // A first exponent from the bit lengths, one step off at most, then mended by looking.
  const long bits = static_cast<long>(mpz_sizeinbase(q.get_num_mpz_t(), 2)) -
                    static_cast<long>(mpz_sizeinbase(q.get_den_mpz_t(), 2));
  int exponent = static_cast<int>(std::floor(static_cast<double>(bits) * 0.30102999566398120)) - 6;
  for (;; ++exponent) {
    mpz_class numerator = q.get_num(), denominator = q.get_den(), mantissa;
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

Rational ComparisonError::exact() const {
  if (difference_.is_zero()) return 0;
  Rational q = rational(difference_) / rational(scale_);
  mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), static_cast<mp_bitcnt_t>(digits_));
  return q;
}

bool ComparisonError::exceeds(const Rational& tolerance) const {
  const double near = tolerance.get_d();  // truncated: at most one ulp below
  if (upper_ < near) return false;
  if (lower_ > near * (1 + 0x1p-50) && near > 1e-290) return true;
  return exact() > tolerance;
}

}  // namespace axiscert
