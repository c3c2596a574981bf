#include "exact/sphere_triangle/oracles/cascade.h"

#include <fmt/format.h>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/oracles/grid_signs.h"
#include "exact/sphere_triangle/oracles/wide_margins.h"
#include "kernel/base/stopwatch.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
template <class Real>
template <class SignsOf>
void Cascade<Real>::try_left(const QueryBatch<Real>& batch, Step step, SignsOf&& signs_of) {
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (decided_[i].step != Step::exact || !filtered_[i].is_valid) continue;
    if (const auto signs = signs_of(batch[i])) {
      decided_[i].signs = *signs;
      decided_[i].step = step;
    }
  }
}

template <class Real>
const std::vector<DecidedSigns>& Cascade<Real>::decide(const QueryBatch<Real>& batch) {
  Stopwatch watch;
  filtered_.resize(batch.size());
  decided_.resize(batch.size());
  filter_.signs(batch.columns(), filtered_.data());
  bool any_left = false;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const FilteredSigns& found = filtered_[i];
    const bool is_decided = found.is_decided();
    decided_[i] = {found.signs, is_decided ? Step::lanes : Step::exact, is_decided && found.is_close,
                   found.is_valid ? found.certain : SignBits{0}};
    any_left |= !is_decided;
  }
  nanoseconds_[Step::lanes] += watch.lap();
  if (!any_left) return decided_;
  try_left(batch, Step::grid, [](const Query<Real>& q) { return grid_signs(q); });
  nanoseconds_[Step::grid] += watch.lap();
  try_left(batch, Step::wide, [](const Query<Real>& q) { return WideMargins(widened(q)).signs(); });
  nanoseconds_[Step::wide] += watch.lap();
  try_left(batch, Step::integers, [](const Query<Real>& q) { return std::optional(integer_signs(q)); });
  nanoseconds_[Step::integers] += watch.lap();
  return decided_;
}
template class Cascade<float>;
template class Cascade<double>;

template <class Real>
void require_same(const DecidedSigns& decided, const ExactTruth& truth, const Query<Real>& q) {
  const Signs exact = signs_of(*truth.sides);
  if (decided.signs == exact && verdict_of(exact) == truth.verdict && is_touching(exact, q.r == 0) == truth.touching) {
    return;
  }
  throw OracleDisagreement(
      fmt::format("the step `{}` of the filter has the signs {:016b} ties {:016b} (bit 0 is the first comparison); "
                  "exact arithmetic {:016b} ties {:016b}, {}{}",
                  name(decided.step), decided.signs.strict, decided.signs.ties, exact.strict, exact.ties,
                  name(truth.verdict), truth.touching ? ", touching" : ""),
      Numbers<Real>(q), sphere_triangle_predicate());
}
template void require_same(const DecidedSigns&, const ExactTruth&, const Query<float>&);
template void require_same(const DecidedSigns&, const ExactTruth&, const Query<double>&);

}  // namespace axiscert
