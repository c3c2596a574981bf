#include "exact/numbers/decimal6.h"

#include <fmt/format.h>

#include <cmath>
#include <cstdlib>

namespace axiscert {
namespace {

mpz_class power_of_ten(int n) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), 10, static_cast<unsigned long>(n));
  return p;
}

}  // namespace

Rational exact(const Decimal6& d) {
  Rational value(d.mantissa);
  const Rational power(power_of_ten(std::abs(d.exponent)));
  return d.exponent < 0 ? Rational(value / power) : Rational(value * power);
}
Decimal6 next(Decimal6 d) {
  return d.mantissa == 999999 ? Decimal6{d.exponent + 1, 100000} : Decimal6{d.exponent, d.mantissa + 1};
}
Decimal6 previous(Decimal6 d) {
  return d.mantissa == 100000 ? Decimal6{d.exponent - 1, 999999} : Decimal6{d.exponent, d.mantissa - 1};
}

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
  // A first exponent from the bit lengths, at most two too low, then corrected by comparison.
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

}  // namespace axiscert
