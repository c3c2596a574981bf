#include "fuzz/confirm/witness_sides.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "exact/sphere_triangle/oracles/formula_oracle.h"
#include "exact/trait/side_error.h"
#include "fuzz/sphere_triangle/confirm.h"
#include "fuzz/text/number_text.h"
#include "kernel/formulae_list.h"

namespace axiscert {
namespace {

long bit_length(const mpz_class& x) { return sgn(x) == 0 ? 0 : static_cast<long>(mpz_sizeinbase(x.get_mpz_t(), 2)); }

// The value lhs / denominator or sqrt(lhs) / denominator, minus `rhs` / denominator, to 17 significant digits. A dyadic
// value without a root is held exactly before it is printed, so it is rounded once. Elsewhere 64 bits are kept beyond
// twice the operands' own: the difference of a root of b bits and a rational is zero or at least 2^-2b of them.
std::string digits_of(const Rational& lhs, bool rooted, const Rational& rhs, const Rational& denominator) {
  const Rational difference = lhs - rhs;
  if (rooted && sgn(rhs) >= 0 && lhs == rhs * rhs) return "0";
  const Rational& widest = rooted ? lhs : difference;
  const long bits = bit_length(widest.get_num()) + bit_length(widest.get_den()) + bit_length(rhs.get_num()) +
                    bit_length(rhs.get_den()) + bit_length(denominator.get_num()) + bit_length(denominator.get_den());
  mpfr_t value;
  mpfr_init2(value, 2 * bits + 64);
  if (rooted) {
    mpfr_set_q(value, lhs.get_mpq_t(), MPFR_RNDN);
    mpfr_sqrt(value, value, MPFR_RNDN);
    mpfr_sub_q(value, value, rhs.get_mpq_t(), MPFR_RNDN);
    mpfr_div_q(value, value, denominator.get_mpq_t(), MPFR_RNDN);
  } else {
    mpfr_set_q(value, Rational(difference / denominator).get_mpq_t(), MPFR_RNDN);
  }
  char* text = nullptr;
  mpfr_asprintf(&text, "%.17Rg", value);
  const std::string digits = text;
  mpfr_free_str(text);
  mpfr_clear(value);
  return digits;
}

// 2^(e - p + 1) for 2^e <= |x| < 2^(e + 1), and never below the least subnormal number.
template <class Real>
Rational unit_in_last_place(const Rational& x) {
  using Limits = std::numeric_limits<Real>;
  long exponent = Limits::min_exponent - 1;
  if (sgn(x) != 0) {
    // 2^(bits - 1) < |x| < 2^(bits + 1): one comparison decides which half.
    const Rational magnitude = abs(x);
    const long bits = bit_length(magnitude.get_num()) - bit_length(magnitude.get_den());
    const Rational power =
        bits < 0 ? Rational(1, mpz_class(1) << static_cast<unsigned long>(-bits)) : Rational(mpz_class(1) << bits);
    exponent = std::max(exponent, magnitude < power ? bits - 1 : bits);
  }
  exponent -= Limits::digits - 1;
  return exponent < 0 ? Rational(1, mpz_class(1) << static_cast<unsigned long>(-exponent))
                      : Rational(mpz_class(1) << exponent);
}

// Below this, binary64 has fewer than six digits: the result is 1e-300, which is still rounded up and negligible beside
// any ulp.
constexpr double least_error = 1e-300;

ErrorNumber error_number(const Decimal6& d) {
  const double value = d.value();
  if (d.is_zero()) return {};
  return std::isfinite(value) ? ErrorNumber{std::max(value, least_error)} : ErrorNumber{value, d.text()};
}

// Empty if the computed side is not finite.
template <class Real>
std::optional<ErrorNumber> error_ulps(double computed, const Rational& exact_side) {
  if (!std::isfinite(computed)) return std::nullopt;
  return error_number(
      round_up(Rational(abs(Rational(exact(computed) - exact_side)) / unit_in_last_place<Real>(exact_side))));
}

template <class Real>
SidesRecord sides_of(const ExactComparison& sides, const std::optional<ShownSides>& computed, std::size_t i) {
  SidesRecord record;
  const Rational lhs = rational(sides.lhs.over), rhs = rational(sides.rhs.over),
                 denominator = rational(sides.rhs.under);
  if (!sides.is_undefined) {
    record.exact = {digits_of(lhs, sides.is_rooted, 0, denominator), digits_of(rhs, false, 0, denominator),
                    digits_of(lhs, sides.is_rooted, rhs, denominator)};
  }
  if (!computed) return record;
  const auto l = static_cast<Real>(computed->lhs[i]), r = static_cast<Real>(computed->rhs[i]);
  record.computed = {format_number(l), format_number(r)};
  if (sides.is_undefined) return record;
  if (!sides.is_rooted) record.lhs_ulps = error_ulps<Real>(computed->lhs[i], lhs / denominator);
  record.rhs_ulps = error_ulps<Real>(computed->rhs[i], rhs / denominator);
  const SideError error(l, r, sides);
  if (error.kind() == SideError::Kind::finite) record.error_u = error_number(error.rounded_up());
  return record;
}

ComparisonBits worth_showing(const Judgement& judgement, ComparisonBits largest_errors) {
  ComparisonBits which = largest_errors;
  for (const Flip& flip : judgement.flips()) {
    if (flip.level == Level::axis) which |= comparisons_of(static_cast<Axis>(flip.index));
    if (flip.level == Level::comparison) which |= comparisons_of(comparisons[flip.index].axis);
  }
  return which == 0 && judgement.verdict_flip ? ComparisonBits{0xFFFF} : which;
}

class SphereTriangleSides final : public WitnessSides {
 public:
  std::optional<NamedValues<SidesRecord>> of(const Numbers<float>& q, const Kernel& kernel, const Examination& found,
                                             ComparisonBits largest_errors) const override {
    return sides<float>(q, kernel, found, largest_errors);
  }
  std::optional<NamedValues<SidesRecord>> of(const Numbers<double>& q, const Kernel& kernel, const Examination& found,
                                             ComparisonBits largest_errors) const override {
    return sides<double>(q, kernel, found, largest_errors);
  }

 private:
  template <class Real>
  static std::optional<NamedValues<SidesRecord>> sides(const Query<Real>& q, const Kernel& kernel,
                                                       const Examination& found, ComparisonBits largest_errors) {
    if (found.truth.verdict == Verdict::invalid || !has_comparisons(formulae_of(kernel))) return std::nullopt;
    const ExactSides exact = exact_sides(formulae_of(kernel), q);
    NamedValues<SidesRecord> all;
    const ComparisonBits which = worth_showing(found.judgement, largest_errors);
    for (std::size_t i = 0; i < comparison_count; ++i) {
      if (has_bit(which, i)) {
        all.put(comparisons[i].name) = sides_of<Real>(exact.comparison(i), found.sides, i);
      }
    }
    return all;
  }
};

}  // namespace

const WitnessSides& sphere_triangle_witness_sides() {
  static const SphereTriangleSides sides;
  return sides;
}

}  // namespace axiscert
