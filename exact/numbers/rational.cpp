#include "exact/numbers/rational.h"

#include <fmt/format.h>
#include <mpfr.h>

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>

#include "exact/numbers/binary_fraction.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// MPFR restricted to the exponent range of Real, so that its results convert to that format exactly.
template <class Real>
class FormatRange {
 public:
  FormatRange() : emin_(mpfr_get_emin()), emax_(mpfr_get_emax()) {
    // MPFR's significand is in [1/2, 1): its exponents are one above IEEE's; subnormals reach digits-1 below.
    mpfr_set_emin(std::numeric_limits<Real>::min_exponent - std::numeric_limits<Real>::digits + 1);
    mpfr_set_emax(std::numeric_limits<Real>::max_exponent);
  }
  ~FormatRange() {
    mpfr_set_emin(emin_);
    mpfr_set_emax(emax_);
  }
  FormatRange(const FormatRange&) = delete;
  FormatRange& operator=(const FormatRange&) = delete;

 private:
  mpfr_exp_t emin_, emax_;
};

// Rounds the value that `set` stores (it returns MPFR's ternary value) to Real, in one rounding.
template <class Real, class Set>
Real round_once(Set&& set) {
  const FormatRange<Real> range;
  mpfr_t x;
  mpfr_init2(x, std::numeric_limits<Real>::digits);
  mpfr_subnormalize(x, set(x), MPFR_RNDN);
  const Real result =
      sizeof(Real) == 4 ? static_cast<Real>(mpfr_get_flt(x, MPFR_RNDN)) : static_cast<Real>(mpfr_get_d(x, MPFR_RNDN));
  mpfr_clear(x);
  return result;
}

}  // namespace

Rational exact(double value) { return Rational(value); }

Rational parse_decimal(std::string_view text) {
  const auto fail = [&] { return Error("'" + std::string(text) + "' is not a decimal number such as 12.5 or 1e-3"); };
  const std::size_t e = text.find_first_of("eE");
  int exponent = 0;
  if (e != text.npos) {
    const char* end = text.data() + text.size();
    const char* begin = text.data() + e + 1;
    if (begin + 1 < end && begin[0] == '+' && begin[1] != '-') ++begin;
    const auto [stop, problem] = std::from_chars(begin, end, exponent);
    if (problem != std::errc() || stop != end || exponent < -10000 || exponent > 10000) throw fail();
  }
  std::string_view rest = text.substr(0, e);
  const bool negative = rest.starts_with('-');
  if (negative) rest.remove_prefix(1);
  std::string digits;
  bool after_point = false;
  for (const char c : rest) {
    if (c == '.' && !after_point) after_point = true;
    else if (c < '0' || c > '9') throw fail();
    else {
      digits += c;
      exponent -= after_point;
    }
  }
  if (digits.empty()) throw fail();
  mpz_class power;
  mpz_ui_pow_ui(power.get_mpz_t(), 10, static_cast<unsigned long>(std::abs(exponent)));
  const mpz_class integer((negative ? "-" : "") + digits, 10);
  return exponent < 0 ? Rational(integer) / Rational(power) : Rational(integer * power);
}

template <class Real>
Real nearest(const Rational& q) {
  return round_once<Real>([&](mpfr_ptr x) { return mpfr_set_q(x, q.get_mpq_t(), MPFR_RNDN); });
}
template float nearest<float>(const Rational&);
template double nearest<double>(const Rational&);

template <class Real>
Real nearest_sqrt(const mpz_class& numerator, const mpz_class& denominator) {
  if (numerator == 0) return 0;
  // s = floor(sqrt(numerator 4^k / denominator)) with at least 64 bits. Its last bit is set if anything was cut off
  // (round to odd), so that the one rounding below, to at most 53 bits, gives the rounding of the exact root.
  const long width = static_cast<long>(mpz_sizeinbase(numerator.get_mpz_t(), 2)) -
                     static_cast<long>(mpz_sizeinbase(denominator.get_mpz_t(), 2));
  const long k = width >= 130 ? 0 : (131 - width) / 2;
  mpz_class scaled = numerator << (2 * k), quotient, remainder;
  mpz_fdiv_qr(quotient.get_mpz_t(), remainder.get_mpz_t(), scaled.get_mpz_t(), denominator.get_mpz_t());
  mpz_class root, rest;
  mpz_sqrtrem(root.get_mpz_t(), rest.get_mpz_t(), quotient.get_mpz_t());
  if (rest != 0 || remainder != 0) mpz_setbit(root.get_mpz_t(), 0);
  return round_once<Real>([&](mpfr_ptr x) { return mpfr_set_z_2exp(x, root.get_mpz_t(), -k, MPFR_RNDN); });
}
template float nearest_sqrt<float>(const mpz_class&, const mpz_class&);
template double nearest_sqrt<double>(const mpz_class&, const mpz_class&);

template <class Real>
std::optional<Real> sqrt_rounded_up(const Rational& q) {
  constexpr Real greatest = std::numeric_limits<Real>::max();
  const Real root = nearest_sqrt<Real>(q);
  if (!std::isfinite(root)) return std::nullopt;
  const Rational r = exact(root);
  if (r * r >= q) return root;
  if (root == greatest) return std::nullopt;
  return std::nextafter(root, greatest);
}
template std::optional<float> sqrt_rounded_up<float>(const Rational&);
template std::optional<double> sqrt_rounded_up<double>(const Rational&);

Rational rational(const BinaryNumber& x) {
  return x.as_mpz([](mpz_srcptr whole, long exponent) {
    Rational q{mpz_class(whole)};
    const auto places = static_cast<mp_bitcnt_t>(std::labs(exponent));
    if (exponent < 0) mpq_div_2exp(q.get_mpq_t(), q.get_mpq_t(), places);
    else mpq_mul_2exp(q.get_mpq_t(), q.get_mpq_t(), places);
    return q;
  });
}
Rational rational(const BinaryFraction& x) { return rational(x.over) / rational(x.under); }

namespace {

mpz_class power_of_ten(int n) {
  mpz_class p;
  mpz_ui_pow_ui(p.get_mpz_t(), 10, static_cast<unsigned long>(n));
  return p;
}

}  // namespace

Rational exact(const Decimal6& d) {
  if (d.is_zero()) return 0;
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
