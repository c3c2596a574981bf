#include "fuzz/campaign/stages/kernel_run.h"

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
      implementation_(kernel.on<Real>(target)) {}

template <class Real>
void KernelRun<Real>::ask_about(const MadeBatch<Real>& batch) {
  position_ = batch.position;
  if (replies_) return;
  ask(implementation_, batch.queries.columns(), reply_);
  for (const Finding& finding : reply_.findings) {
    count_finding(tally_, finding.kind, position_ + finding.index, finding.detail);
  }
}

template <class Real>
Answer KernelRun<Real>::answer(std::size_t i) const {
  return replies_ ? replies_->at(source_, precision_of<Real>, position_ + i) : reply_.outcome(i);
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
  // Those of a kernel without limits are counted in bulk.
  if (kernel_.limits.any() && std::isfinite(look.depth().engine_threshold())) ++tally_.verdict.engine->queries;
  count(tally_, position(i), look.truth(), found.chain ? found.chain->ties : ComparisonBits{0}, said, found.judgement,
        look.depth(), standing_);
  if (!kernel_.predicate->measures.empty()) {
    const std::vector<double> measures =
        replies_ ? replies_->measures(source_, precision_of<Real>, position(i)) : reply_.measures(i);
    look.count_motion(kernel_, position(i), said.verdict, measures, tally_.motion);
  }
  return found;
}

template class KernelRun<float>;
template class KernelRun<double>;

}  // namespace axiscert
