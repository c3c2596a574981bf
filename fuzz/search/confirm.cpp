#include "fuzz/search/confirm.h"

#include <limits>

#include "exact/judge/side_error.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/search/numbers.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

// |a - sqrt(s)| for s >= 0 as |a^2 - s| / (a + sqrt(s)) if a is positive: no cancellation follows a rounding.
Rational distance_to_root(const Rational& a, const Rational& s) {
  constexpr mp_bitcnt_t bits = 256;
  const mpf_class root = sqrt(mpf_class(s, bits)), at(a, bits);
  if (sgn(a) <= 0) return Rational(mpf_class(root - at, bits));
  return Rational(mpf_class(mpf_class(abs(Rational(a * a - s)), bits) / (at + root), bits));
}

// |(l^ - r^) - (l - r)| / u, rounded up; if l is a root, from 256 bits of it.
template <class Real>
Decimal6 absolute_error(Real computed_lhs, Real computed_rhs, const ExactComparison& sides) {
  Rational difference = exact(computed_lhs) - exact(computed_rhs);
  if (sides.is_rooted) {
    const Rational under = rational(sides.rhs.under);
    difference = distance_to_root(difference * under + rational(sides.rhs.over), rational(sides.lhs.over)) / under;
  } else {
    difference -= rational(sides.lhs) - rational(sides.rhs);
  }
  return round_up(Rational(abs(difference) * (mpz_class(1) << std::numeric_limits<Real>::digits)));
}

}  // namespace

template <class Real>
std::optional<SideErrors> side_errors(const Kernel& kernel, const Implementation<Real>& implementation,
                                      const Numbers<Real>& q) {
  const Oracles& oracles = oracles_of(kernel);
  if (kernel.exposes != Exposure::sides || !oracles.is_valid(q)) return std::nullopt;
  const Reply<Real> reply = ask(implementation, q);
  if (!reply.has_bits || reply.verdicts[0] == Verdict::unanswered) return std::nullopt;
  const std::unique_ptr<AskedQuery> about = oracles.about(q);
  about->expect(kernel);
  if (about->truth().verdict == Verdict::invalid) return std::nullopt;  // every oracle agrees about the query
  const ExactSides* const own = about->sides(kernel);
  if (own == nullptr) return std::nullopt;
  SideErrors all(own->lhs.size());
  for (std::size_t k = 0; k < own->lhs.size(); ++k) {
    const Real lhs = reply.answers.lhs[k][0], rhs = reply.answers.rhs[k][0];
    const ExactComparison sides = own->comparison(k);
    const SideError relative(lhs, rhs, sides);
    if (sides.is_undefined || sides.is_times_root || relative.kind() == SideError::Kind::range_event) continue;
    all.absolute[k] = absolute_error(lhs, rhs, sides);
    if (relative.kind() == SideError::Kind::finite) all.relative[k] = relative.rounded_up();
  }
  return all;
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::value(const Aim& aim, const Numbers<Real>& q) {
  if (aim.goal == Goal::missed_contact) return depth(FlipKind::false_separation, q);
  if (aim.goal == Goal::phantom_contact) return depth(FlipKind::false_contact, q);
  if (aim.goal == Goal::number) {
    const Reply<Real> reply = ask(implementation_, q);
    const auto error = number_seen(aim, kernel_, q, reply.verdicts[0], reply.measures(0)).error;
    return error ? std::optional(error->rounded) : std::nullopt;
  }
  const AimValues* const values = capabilities_of(*kernel_.predicate).aim_values;
  return values == nullptr ? std::nullopt : values->value(aim, kernel_, implementation_, q);
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::depth(FlipKind wrong, const Numbers<Real>& q) {
  const Examination found = examine(q);
  if (found.judgement.verdict_flip != wrong || !found.depth) return std::nullopt;
  if (!oracles_of(kernel_).is_within(kernel_.limits, q)) return std::nullopt;
  return round_up(exact(*found.depth));
}

template std::optional<SideErrors> side_errors(const Kernel&, const Implementation<float>&, const Numbers<float>&);
template std::optional<SideErrors> side_errors(const Kernel&, const Implementation<double>&, const Numbers<double>&);
template class Confirmer<float>;
template class Confirmer<double>;

}  // namespace axiscert
