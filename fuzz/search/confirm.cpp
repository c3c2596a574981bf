#include "fuzz/search/confirm.h"

#include "fuzz/queries/capabilities.h"

namespace axiscert {

template <class Real>
std::optional<Decimal6> Confirmer<Real>::value(const Aim& aim, const Numbers<Real>& q) {
  if (aim.goal == Goal::missed_contact) return depth(FlipKind::false_separation, q);
  if (aim.goal == Goal::phantom_contact) return depth(FlipKind::false_contact, q);
  const AimValues* const values = capabilities_of(*kernel_.test).aim_values;
  return values == nullptr ? std::nullopt : values->value(aim, kernel_, implementation_, q);
}

template <class Real>
std::optional<SideErrors> Confirmer<Real>::errors(const Numbers<Real>& q) {
  const AimValues* const values = capabilities_of(*kernel_.test).aim_values;
  return values == nullptr ? std::nullopt : values->errors(kernel_, implementation_, q);
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
