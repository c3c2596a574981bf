#include "fuzz/search/numbers.h"

#include "exact/judge/oracles.h"
#include "fuzz/search/moves.h"

namespace axiscert {

std::vector<Aim> number_aims(const Kernel& kernel) {
  std::vector<Aim> aims;
  if (is_of_motions(*kernel.predicate)) return aims;
  for (const MeasureFault which : enumerators<MeasureFault>) {
    // A flip is one of what is left.
    const bool has_size = which != MeasureFault::inconsistent && which != MeasureFault::flip;
    if (has_size && can_have(*kernel.predicate, kernel.measure_count, which))
      aims.push_back({Goal::number, static_cast<std::size_t>(which)});
  }
  return aims;
}

template <class Real>
NumberSeen number_seen(const Aim& aim, const Kernel& kernel, const Numbers<Real>& q, Verdict said,
                       std::span<const double> measures) {
  const Oracles& oracles = oracles_of(kernel);
  if (!oracles.is_valid(q) || !is_promised(kernel, q)) return {};
  if (!has_judged_contact(kernel, said, [&] { return oracles.truth(q); })) return {};
  const std::unique_ptr<ContactJudge> judge = oracles.contact_judge(q);
  if (judge == nullptr) return {};
  judge->declare_margin(kernel.limits.margin);
  const ContactJudgement judgement = judge->judge(said, measures);
  return {is_judged(judgement, fault_of(aim)), measure_error(judgement, fault_of(aim))};
}
template NumberSeen number_seen(const Aim&, const Kernel&, const Numbers<float>&, Verdict, std::span<const double>);
template NumberSeen number_seen(const Aim&, const Kernel&, const Numbers<double>&, Verdict, std::span<const double>);

template <class Real>
NumberGuide<Real>::NumberGuide(const Kernel& kernel, std::string_view target)
    : Guide<Real>(shape_of(kernel.predicate->entries[kernel.entry])),
      kernel_(kernel),
      implementation_(kernel.on<Real>(target)) {}

template <class Real>
void NumberGuide<Real>::settle(Numbers<Real>& q) const {
  axiscert::settle(this->shape(), q);
}

template <class Real>
void NumberGuide<Real>::evaluate(const Aim& aim, QueryBatch<Real>& batch, std::vector<double>& scores,
                                 std::vector<Verdict>& said) {
  Reply<Real> reply;
  ask(implementation_, batch.columns(), reply);
  scores.assign(batch.size(), 0);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const NumberSeen seen = number_seen(aim, kernel_, batch[i], reply.verdicts[i], reply.measures(i));
    judged_ += seen.is_judged;
    if (seen.error) scores[i] = seen.error->size;
  }
  said = reply.verdicts;
}

template class NumberGuide<float>;
template class NumberGuide<double>;

}  // namespace axiscert
