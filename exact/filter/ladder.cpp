#include "exact/filter/ladder.h"

#include "exact/grid.h"
#include "exact/grid_signs.h"
#include "exact/stopwatch.h"
#include "exact/wide_margins.h"

namespace axiscert {

namespace {

// Too far for integers of a few words: what takes many is tried in doubles first.
template <class Real>
bool lies_far_apart(const Query<Real>& q) {
  Magnitude<Real> greatest = 0, least = ~Magnitude<Real>{0};  // least: of those that are not zero, less 1
  for (const Real x : coordinates(q)) {
    greatest = std::max(greatest, magnitude(x));
    least = std::min<Magnitude<Real>>(least, magnitude(x) - 1u);
  }
  return greatest != 0 && unit_exponent<Real>(greatest) - unit_exponent<Real>(least + 1u) > 64;
}

}  // namespace

template <class Real>
const std::vector<DecidedSigns>& Ladder<Real>::decide(const QueryBatch<Real>& batch) {
  Stopwatch watch;
  filtered_.resize(batch.size());
  decided_.resize(batch.size());
  filter_.signs(batch.columns(), filtered_.data());
  bool any_left = false;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const FilteredSigns& found = filtered_[i];
    const bool is_decided = found.is_decided();
    decided_[i] = {found.signs, is_decided ? Step::lanes : Step::exact, is_decided && found.is_close,
                   found.is_valid ? found.certain : ComparisonBits{0}};
    any_left |= !is_decided;
  }
  nanoseconds_[static_cast<std::size_t>(Step::lanes)] += watch.lap();
  if (!any_left) return decided_;
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (decided_[i].step == Step::lanes || !filtered_[i].is_valid) continue;
    const Query<Real> q = batch[i];
    if (!lies_far_apart(q)) continue;
    if (const auto signs = WideMargins(widened(q)).signs()) {
      decided_[i].signs = *signs;
      decided_[i].step = Step::wide;
    }
  }
  nanoseconds_[static_cast<std::size_t>(Step::wide)] += watch.lap();
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (decided_[i].step != Step::exact || !filtered_[i].is_valid) continue;
    decided_[i].signs = grid_signs(batch[i]);
    decided_[i].step = Step::grid;
  }
  nanoseconds_[static_cast<std::size_t>(Step::grid)] += watch.lap();
  return decided_;
}
template class Ladder<float>;
template class Ladder<double>;

}  // namespace axiscert
