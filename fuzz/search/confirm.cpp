#include "fuzz/search/confirm.h"

#include <limits>

#include "exact/trait/side_error.h"
#include "fuzz/queries/capabilities.h"
#include "kernel/ask.h"

namespace axiscert {
namespace {

template <class Real>
SideErrors errors_of(const Answers<Real>& answers, const ExactSides& own) {
  SideErrors all;
  for (std::size_t k = 0; k < own.lhs.size(); ++k) {
    const Real lhs = answers.lhs[k][0], rhs = answers.rhs[k][0];
    const ExactComparison sides = own.comparison(k);
    const SideError relative(lhs, rhs, sides);
    all.absolute.emplace_back();
    all.relative.emplace_back();
    if (relative.kind() == SideError::Kind::range_event || sides.is_undefined) continue;
    if (!sides.is_rooted) {  // a root has no rational difference
      const Rational difference = exact(lhs) - exact(rhs) - (rational(sides.lhs) - rational(sides.rhs));
      all.absolute.back() = round_up(Rational(abs(difference) * (mpz_class(1) << std::numeric_limits<Real>::digits)));
    }
    if (relative.kind() == SideError::Kind::finite) all.relative.back() = relative.rounded_up();
  }
  return all;
}

}  // namespace

template <class Real>
std::optional<Decimal6> Confirmer<Real>::value(const Aim& aim, const Numbers<Real>& q) {
  if (aim.goal == Goal::missed_contact) return depth(FlipKind::false_separation, q);
  if (aim.goal == Goal::phantom_contact) return depth(FlipKind::false_contact, q);
  const AimValues* const values = capabilities_of(*kernel_.test).aim_values;
  return values == nullptr ? std::nullopt : values->value(aim, kernel_, implementation_, q);
}

template <class Real>
std::optional<SideErrors> Confirmer<Real>::errors(const Numbers<Real>& q) {
  if (const AimValues* const values = capabilities_of(*kernel_.test).aim_values)
    return values->errors(kernel_, implementation_, q);
  const Oracles& oracles = oracles_of(kernel_);
  if (kernel_.exposes != Exposure::sides || !oracles.is_valid(q)) return std::nullopt;
  const Reply<Real> reply = ask(implementation_, q);
  if (!reply.has_bits || reply.verdicts[0] == Verdict::unanswered) return std::nullopt;
  const std::unique_ptr<AskedQuery> about = oracles.about(q);
  about->expect(kernel_);
  const ExactSides* const own = about->truth().verdict == Verdict::invalid ? nullptr : about->sides(kernel_);
  return own == nullptr ? std::nullopt : std::optional(errors_of(reply.answers, *own));
}

template <class Real>
std::optional<Decimal6> Confirmer<Real>::depth(FlipKind wrong, const Numbers<Real>& q) {
  const Examination found = examine(q);
  if (found.judgement.verdict_flip != wrong || !found.depth) return std::nullopt;
  if (!oracles_of(kernel_).is_within(kernel_.limits, q)) return std::nullopt;
  return round_up(exact(*found.depth));
}

template class Confirmer<float>;
template class Confirmer<double>;

}  // namespace axiscert
