#include "fuzz/campaign/unit.h"

#include <algorithm>
#include <cmath>

namespace axiscert {

template <class Real>
KernelRun<Real>::KernelRun(const Kernel& kernel, const std::string& target, const StoredReplies* replies,
                           const Source& source, const StandingLeaders& standing, Tally& tally)
    : kernel_(kernel),
      source_(source),
      replies_(replies),
      standing_(standing),
      tally_(tally),
      implementation_(kernel.on<Real>(target)),
      has_contacts_(says_contacts(kernel)) {}

template <class Real>
void KernelRun<Real>::ask_about(const MadeBatch<Real>& batch) {
  position_ = batch.position;
  if (replies_) return;
  ask(implementation_, batch.queries.columns(), reply_);
  for (const Finding& finding : reply_.watched.findings) {
    count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
  }
  tally_.asked_again += reply_.watched.asked_again;
}

template <class Real>
std::vector<double> KernelRun<Real>::measures(std::size_t i) const {
  return replies_ ? replies_->measures(source_, precision_of<Real>, position(i)) : reply_.measures(i);
}

template <class Real>
typename KernelRun<Real>::JudgedAnswer KernelRun<Real>::judge(std::size_t i, CloseLook<Real>& look) {
  const Answer said = answer(i);
  JudgedAnswer found{true, look.chain(kernel_)};
  found.judgement = axiscert::judge(*kernel_.predicate, look.truth(), found.chain, said, kernel_.touching);
  if (!look.is_promised_by(kernel_)) {
    count_outside(tally_, look.truth(), said, found.judgement, look.depth());
    found.is_counted = false;
    return found;
  }
  count(tally_, position(i), look.truth(), found.chain ? found.chain->ties : ComparisonBits{0}, said, found.judgement,
        look.depth(), standing_);
  return found;
}

template <class Real>
void KernelRun<Real>::finish() {
  if (!is_in_another_process() && !has_replies()) return;
  const VerdictTally& verdict = tally_.verdict;
  const OutsideTally& outside = *verdict.outside_limits;
  const std::uint64_t touching = tally_.truth.touching - outside.touching;
  const std::uint64_t apart = tally_.truth.separated - (outside.trials - outside.contact);
  const std::uint64_t overlapping = tally_.truth.contact - outside.contact - touching;
  // Any convention may be right where bodies touch.
  const WrongBothWays wrong{apart, std::min(verdict.false_contact, apart), overlapping,
                            std::min(verdict.false_separation, overlapping)};
  if (!wrong.are_exchanged()) return;
  FirstQuery first;
  for (const FirstQuery& of_link : verdict.first_by_link) first.merge(of_link);
  count_finding(tally_, FindingKind::exchanged, first.position.value_or(position_), wrong.text(kernel_));
}

template class KernelRun<float>;
template class KernelRun<double>;

namespace {

void count_answer(ClearTally& tally, std::uint64_t position, Verdict said, Verdict right) {
  ++tally.queries;
  tally.undecided += said == Verdict::undecided;
  if (said != Verdict::separated && said != Verdict::contact) return;
  ++tally.decided_as(right);
  if (said == right) return;
  ++(said == Verdict::separated ? tally.false_separation : tally.false_contact);
  (said == Verdict::separated ? tally.first_missed : tally.first_phantom).offer({true, position});
}

}  // namespace

template <class Real>
void look_at_clear(const Oracles& oracles, const MadeBatch<Real>& batch, KernelRuns<Real>& runs) {
  std::vector<KernelRun<Real>*> looked_at;
  for (KernelRun<Real>& run : runs) {
    if (!has_reference(run.kernel())) looked_at.push_back(&run);
  }
  if (looked_at.empty()) return;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const Numbers<Real> numbers = batch.queries[i];
    const std::optional<Verdict> right = oracles.clear_verdict(numbers);
    if (!right) continue;
    for (KernelRun<Real>* run : looked_at) {
      const Kernel& kernel = run->kernel();
      if (is_promised(oracles, kernel.limits, kernel.motion, numbers))
        count_answer(*run->tally().verdict.clear, run->position(i), run->answer(i).verdict, *right);
    }
  }
}
template void look_at_clear(const Oracles&, const MadeBatch<float>&, KernelRuns<float>&);
template void look_at_clear(const Oracles&, const MadeBatch<double>&, KernelRuns<double>&);

}  // namespace axiscert
