#include "fuzz/search/confirm.h"

#include <algorithm>
#include <cmath>

#include "exact/sphere_triangle/measures/error_measure.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/measures/critical_radius.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/unbounded/unbounded.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/search/moves/moves.h"
#include "fuzz/search/range.h"
#include "kernel/ask.h"
#include "kernel/sphere_triangle/shown_sides.h"

namespace axiscert {
namespace {

// |a - sqrt(s)| for s >= 0 as |a^2 - s| / (a + sqrt(s)) if a is positive: no cancellation follows a rounding.
Rational distance_to_root(const Rational& a, const Rational& s) {
  constexpr mp_bitcnt_t bits = 256;
  const mpf_class root = sqrt(mpf_class(s, bits)), at(a, bits);
  if (sgn(a) <= 0) return Rational(mpf_class(root - at, bits));
  return Rational(mpf_class(mpf_class(abs(Rational(a * a - s)), bits) / (at + root), bits));
}

FlipKind wrong_in(Goal goal) {
  return goal == Goal::missed_contact ? FlipKind::false_separation : FlipKind::false_contact;
}

}  // namespace

template <class Real>
Decimal6 absolute_error(Real computed_lhs, Real computed_rhs, const ExactComparison& exact_sides) {
  const Rational computed = exact(computed_lhs) - exact(computed_rhs), den = rational(exact_sides.denominator);
  const Rational l = rational(exact_sides.lhs), r = rational(exact_sides.rhs);
  const Rational difference =
      exact_sides.rooted ? distance_to_root(computed * den + r, l) : Rational(abs(computed * den - (l - r)));
  return round_up(Rational(difference / den * Rational(mpz_class(1) << std::numeric_limits<Real>::digits)));
}
template Decimal6 absolute_error(float, float, const ExactComparison&);
template Decimal6 absolute_error(double, double, const ExactComparison&);

template <class Real>
std::optional<Decimal6> Confirmer<Real>::value(const Aim& aim, const Numbers<Real>& numbers) {
  if (kernel_.test != &first_test()) return depth_by_oracles(aim.goal, numbers);
  const Query<Real> q = numbers;
  if (!is_valid(q)) return std::nullopt;
  switch (aim.goal) {
    case Goal::error:
    case Goal::relative_error: {
      if (aim.goal == Goal::error && !is_in_box(q)) return std::nullopt;
      const auto all = errors(q);
      if (!all) return std::nullopt;
      return (aim.goal == Goal::error ? all->absolute : all->relative)[aim.which];
    }
    case Goal::overflow:
    case Goal::underflow:
      return range(aim, q);
    case Goal::missed_contact:
    case Goal::phantom_contact:
      return depth(aim.goal, q);
    case Goal::critical_radius:
      return critical_error(q);
  }
  return std::nullopt;
}

template <class Real>
std::optional<SideErrors> Confirmer<Real>::errors(const Query<Real>& q) {
  if (kernel_.exposes != Exposure::sides || !has_comparisons(kernel_.formulae) || !is_valid(q)) return std::nullopt;
  const Reply<Real> reply = ask(implementation_, q);
  if (!reply.has_bits || reply.verdicts[0] == Verdict::unanswered) return std::nullopt;
  // Every oracle agrees about the query; the kernel's own formulae follow.
  const ExactTruth truth = exact_truth(q, true);
  Claims<Real> claims(q, *truth.formula);
  const FormulaTruth& own = *claims.sides(kernel_.formulae);
  const Sides<Real> sides = sides_at(reply.answers, 0);
  SideErrors all;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const ExactComparison exact = own.comparison(k);
    const ComparisonError relative(sides.lhs[k], sides.rhs[k], exact);
    if (exact.undefined || relative.kind() == ComparisonError::Kind::range_event) continue;
    all.absolute[k] = absolute_error(sides.lhs[k], sides.rhs[k], exact);
    if (relative.kind() == ComparisonError::Kind::finite) all.relative[k] = relative.rounded_up();
  }
  return all;
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::range(const Aim& aim, const Query<Real>& q) {
  QueryBatch<Real> one(1, coordinate_count);
  one.push_back(q);
  const auto m = range_left(implementation_, aim, one).front();
  if (!m) return std::nullopt;
  const Query<Real> there = times_power(q, *m);
  const Reply<Real> reply = ask(implementation_, there);
  const std::size_t k = index_of(aim.which);
  const bool finite = std::isfinite(reply.answers.lhs[k][0]) && std::isfinite(reply.answers.rhs[k][0]);
  const ComparisonBits expected = *unbounded(kernel_.formulae, kernel_.arithmetic, kernel_.strictness, there).bits;
  if (finite && !has_bit(reply.answers.bits[0] ^ expected, k)) return std::nullopt;
  return round_up(exact(range_score(aim.goal, precision_of<Real>, *m)));
}

template <class Real>
LinkSet Confirmer<Real>::verdict_links(const Numbers<Real>& q) {
  return kernel_.test == &first_test() ? examine(query_from(q)).judgement.verdict_links
                                       : oracle_examiner_.examine(q).judgement.verdict_links;
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::depth_by_oracles(Goal goal, const Numbers<Real>& q) {
  const OracleExamination found = oracle_examiner_.examine(q);
  if (found.judgement.verdict_flip != wrong_in(goal) || !found.depth) return std::nullopt;
  return round_up(exact(*found.depth));
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::depth(Goal goal, const Query<Real>& q) {
  const Examination found = examine(q);
  if (found.judgement.verdict_flip != wrong_in(goal) || !found.within_limits) return std::nullopt;
  return round_up(exact(*found.depth));
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::critical_error(const Query<Real>& q) {
  const Rational squared = squared_distance(q);
  const auto range = radii_within<Real>(kernel_.limits);
  const auto distance = distance_within(squared, range);
  if (!distance) return std::nullopt;
  const auto critical = critical_radius(implementation_, q, range);
  if (!critical.answered || critical.not_decided || !critical.radius) return std::nullopt;
  return radius_error_ulps(*critical.radius, *distance, squared);
}

template class Confirmer<float>;
template class Confirmer<double>;

}  // namespace axiscert
