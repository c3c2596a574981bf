#include "fuzz/campaign/stages/kernel_runs.h"

#include <algorithm>

#include "exact/sphere_triangle/oracles/formula_oracle.h"
#include "fuzz/campaign/counts/margins.h"

namespace axiscert {

template <class Real>
KernelRuns<Real>::KernelRuns(const Plan& plan, const Source& source, Decider<Real>& decider,
                             const std::vector<Standing>& standing, std::uint64_t first_position,
                             std::vector<Tally>& tallies)
    : plan_(plan), decider_(decider) {
  static const Standing nothing = standing_of(Tally());
  for (std::size_t k = 0; k < plan.kernels.size(); ++k) {
    if (!plan.kernels[k]->has(precision_of<Real>)) continue;
    runs_.emplace_back(*plan.kernels[k], plan, source, decider.filter(), standing.empty() ? nothing : standing[k],
                       first_position, tallies[k]);
  }
}

template <class Real>
bool KernelRuns<Real>::any_in_another_process() const {
  return std::any_of(runs_.begin(), runs_.end(), [](const auto& run) { return run.is_in_another_process(); });
}

template <class Real>
AnsweredBatch<Real> KernelRuns<Real>::ask(const MadeBatch<Real>& batch) {
  for (KernelRun<Real>& run : runs_) run.ask_about(batch);
  return AnsweredBatch<Real>(*this);
}

template <class Real>
WatchedBatch<Real> AnsweredBatch<Real>::look_at_errors(const DecidedBatch<Real>& batch) && {
  for (KernelRun<Real>& run : runs_.runs_) run.look_at_errors(batch);
  return {runs_, batch};
}

template <class Real>
void KernelRuns<Real>::count_plain(const DecidedBatch<Real>& batch) {
  open_.assign(batch.size(), false);
  const std::uint64_t engine_like = engine_like_queries(batch.queries.columns());
  for (KernelRun<Real>& run : runs_) {
    run.count_engine_like(engine_like);
    run.count_plain(batch);
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] |= static_cast<char>(!run.has_counted(i));
  }
}

template <class Real>
void WatchedBatch<Real>::judge() && {
  runs_.count_plain(batch_);
  runs_.judge(batch_);
  if (!runs_.plan_.replies) runs_.sample_critical_radii(batch_);
  if (has_margins(batch_.position)) runs_.measure_margins(batch_);
}

template <class Real>
void KernelRuns<Real>::judge(const DecidedBatch<Real>& batch) {
  CloseLooks<Real> looks(decider_, batch);
  const Real* radii = batch.queries.columns().column[coordinate_count - 1];
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!open_[i]) continue;
    for (KernelRun<Real>& run : runs_) {
      if (!run.has_counted(i)) run.judge(batch, i, radii[i] == 0, looks);
    }
  }
}

template <class Real>
void KernelRuns<Real>::sample_critical_radii(const DecidedBatch<Real>& batch) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!has_critical_radius(batch.position + i)) continue;
    const Query<Real> q = batch.queries[i];
    if (!is_valid(q)) continue;
    LazyDistance<Real> distance(q, plan_.exact_only);
    for (KernelRun<Real>& run : runs_) run.sample(q, i, distance);
  }
}

template <class Real>
void KernelRuns<Real>::measure_margins(const DecidedBatch<Real>& batch) {
  if (std::none_of(runs_.begin(), runs_.end(), [](const auto& run) { return run.shows_comparisons(); })) return;
  for (std::size_t i = 0; i < batch.size() && has_margins(batch.position + i); ++i) {
    const Query<Real> q = batch.queries[i];
    if (!is_valid(q)) continue;
    const FormulaTruth published = formula_truth(q);
    Claims<Real> claims(q, published);
    for (KernelRun<Real>& run : runs_) run.measure_margins(q, i, claims);
  }
}

template <class Real>
void KernelRuns<Real>::finish() {
  for (KernelRun<Real>& run : runs_) run.finish();
}

template class KernelRuns<float>;
template class KernelRuns<double>;
template class AnsweredBatch<float>;
template class AnsweredBatch<double>;
template class WatchedBatch<float>;
template class WatchedBatch<double>;

}  // namespace axiscert
