#include "exact/sphere_triangle/measures/condition_number.h"

#include "exact/numbers/binary_fraction.h"
#include "exact/numbers/rational.h"
#include "exact/numbers/surd.h"

#include <mpfr.h>

#include <limits>
#include <optional>

#include "exact/sphere_triangle/measures/dual.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"

// Nothing here rounds before the decision. For ring formulae the margin and its partials are polynomials, and
// BinaryNumber is exact over all of them at any exponent. The early forms divide and take one root, and Surd is closed
// under these operations; it is closed under their derivatives as well, since (sqrt s)' = s' sqrt(s) / (2 s) has the
// root of s itself, and (a / b)' = (a' - (a / b) b') / b meets that root only together with itself. Hence margin and
// sum are c sqrt(k) + d with one k and rational c, d, and the sign of such a number is decided by squares.

namespace axiscert {
namespace {

Decimal6 scaled_quotient(const Rational& sum, const Rational& margin, int digits) {
  return round_up(Fraction{sum.get_num() * margin.get_den(), (sum.get_den() * margin.get_num())
                                                                 << static_cast<mp_bitcnt_t>(digits)});
}

using ExactCoordinates = std::array<BinaryNumber, coordinate_count>;

Condition condition_of(const Dual<BinaryNumber>& lhs, const Dual<BinaryNumber>& rhs, const ExactCoordinates& x,
                       int digits) {
  const BinaryNumber margin = magnitude(lhs.value - rhs.value);
  if (margin.is_zero()) return {Condition::Kind::infinite, true, {}};
  BinaryNumber sum;
  for (std::size_t i = 0; i < coordinate_count; ++i) {
    sum = sum + magnitude(x[i] * (lhs.partials[i] - rhs.partials[i]));
  }
  const Rational exact_sum = rational(sum), exact_margin = rational(margin);
  const Rational kappa_u = exact_sum / (exact_margin << static_cast<mp_bitcnt_t>(digits));
  return {Condition::Kind::finite, kappa_u >= 1, scaled_quotient(exact_sum, exact_margin, digits)};
}

// of_root sqrt(k) + rest, for a k >= 0 that is stored elsewhere.
struct RootSum {
  Rational of_root, rest;
};

RootSum operator+(const RootSum& a, const RootSum& b) { return {a.of_root + b.of_root, a.rest + b.rest}; }
RootSum operator-(const RootSum& a, const RootSum& b) { return {a.of_root - b.of_root, a.rest - b.rest}; }
RootSum operator*(const RootSum& a, const Rational& s) { return {a.of_root * s, a.rest * s}; }

// Compares signs first, then squares.
int sign(const RootSum& x, const Rational& k) {
  const int root_sign = sgn(k) == 0 ? 0 : sgn(x.of_root), rest_sign = sgn(x.rest);
  if (root_sign == 0 || rest_sign == 0 || root_sign == rest_sign) return root_sign != 0 ? root_sign : rest_sign;
  return root_sign * cmp(x.of_root * x.of_root * k, x.rest * x.rest);
}
RootSum absolute(const RootSum& x, const Rational& k) { return sign(x, k) < 0 ? x * Rational(-1) : x; }

// |x| with a relative error below 2^-120: where the terms have opposite signs, |c^2 k - d^2| / (|c| sqrt(k) + |d|),
// in which nothing cancels after the exact numerator.
Rational approximately(const RootSum& x, const Rational& k) {
  const Rational root_square = x.of_root * x.of_root * k;
  const bool opposite = sgn(root_square) != 0 && sgn(x.of_root) * sgn(x.rest) < 0;
  mpfr_t root, rest;
  mpfr_inits2(128, root, rest, nullptr);
  mpfr_set_q(root, root_square.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(root, root, MPFR_RNDN);
  mpfr_set_q(rest, Rational(abs(x.rest)).get_mpq_t(), MPFR_RNDN);
  mpfr_add(root, root, rest, MPFR_RNDN);
  Rational result;
  mpfr_get_q(result.get_mpq_t(), root);
  mpfr_clears(root, rest, nullptr);
  return opposite ? Rational(abs(root_square - x.rest * x.rest) / result) : result;
}

// Surds as RootSums over one radicand, which the first irrational Surd determines.
class CommonRoot {
 public:
  // Empty if the number is undefined, or has a root other than the previous ones.
  std::optional<RootSum> operator()(const Surd& x) {
    if (x.is_undefined()) return std::nullopt;
    Rational value = rational(x.numerator()) / rational(x.denominator());
    if (x.is_rational() || x.numerator().is_zero()) return RootSum{0, std::move(value)};
    if (!radicand_) radicand_ = x.radicand();
    else if (*radicand_ != x.radicand()) return std::nullopt;
    return RootSum{std::move(value), 0};
  }
  Rational radicand() const { return radicand_ ? rational(*radicand_) : Rational(0); }

 private:
  std::optional<BinaryNumber> radicand_;
};

Condition condition_of(const Dual<Surd>& lhs, const Dual<Surd>& rhs, const ExactCoordinates& x, int digits) {
  using Kind = Condition::Kind;
  CommonRoot common;
  const auto l = common(lhs.value), r = common(rhs.value);
  if (!l || !r)
    return {lhs.value.is_undefined() || rhs.value.is_undefined() ? Kind::undefined : Kind::not_decided, false, {}};
  const RootSum signed_margin = *l - *r;
  if (sign(signed_margin, common.radicand()) == 0) return {Kind::infinite, true, {}};
  RootSum sum;
  for (std::size_t i = 0; i < coordinate_count; ++i) {
    if (x[i].is_zero()) continue;  // no relative change affects it
    const auto of_l = common(lhs.partials[i]), of_r = common(rhs.partials[i]);
    if (!of_l || !of_r) return {Kind::not_decided, false, {}};
    sum = sum + absolute((*of_l - *of_r) * rational(x[i]), common.radicand());
  }
  const Rational k = common.radicand();
  const RootSum margin = absolute(signed_margin, k);
  const Rational one_over_u(mpz_class(1) << static_cast<mp_bitcnt_t>(digits));
  return {Kind::finite, sign(sum - margin * one_over_u, k) >= 0,
          scaled_quotient(approximately(sum, k), approximately(margin, k), digits)};
}

template <class F, class Real>
EnumArray<Comparison, Condition> conditions_of(const Query<Real>& q, ComparisonBits wanted) {
  using Base = std::conditional_t<F::is_ring, BinaryNumber, Surd>;
  const auto sides =
      sides_of<F>(dual_problem<Base>(q, [](Real x) { return Base(BinaryNumber(static_cast<double>(x))); }));
  ExactCoordinates x;
  const auto given = coordinates(q);
  for (std::size_t i = 0; i < coordinate_count; ++i) x[i] = BinaryNumber(static_cast<double>(given[i]));
  EnumArray<Comparison, Condition> found;
  for (std::size_t i = 0; i < comparison_count; ++i) {
    if (!has_bit(wanted, i)) continue;
    found[i] = condition_of(sides.lhs[i], sides.rhs[i], x, std::numeric_limits<Real>::digits);
  }
  return found;
}

template <class Real>
using ConditionFunction = EnumArray<Comparison, Condition> (*)(const Query<Real>&, ComparisonBits);

template <class F, class Real>
constexpr ConditionFunction<Real> condition_function() {
  if constexpr (requires(portable::Problem<Real> p) { F::separated(p); }) return nullptr;
  else return conditions_of<F, Real>;
}

}  // namespace

template <class Real>
EnumArray<Comparison, Condition> conditions(Formulae formulae, const Query<Real>& q, ComparisonBits wanted) {
  static constexpr EnumArray<Formulae, ConditionFunction<Real>> functions = {
#define AXISCERT_FUNCTION(name, type, kind) condition_function<type, Real>(),
      AXISCERT_FORMULAE(AXISCERT_FUNCTION)
#undef AXISCERT_FUNCTION
  };
  return functions[formulae](q, wanted);
}
template EnumArray<Comparison, Condition> conditions<float>(Formulae, const Query<float>&, ComparisonBits);
template EnumArray<Comparison, Condition> conditions<double>(Formulae, const Query<double>&, ComparisonBits);

}  // namespace axiscert
