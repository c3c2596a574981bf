#include "fuzz/sphere_triangle/screen.h"

#include <algorithm>

#include "exact/sphere_triangle/measures/input_class.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "fuzz/record/margins.h"

namespace axiscert {

template <class Real>
SphereTriangleScreen<Real>::SphereTriangleScreen(const ScreenedRuns<Real>& of)
    : has_replies_(of.runs.front().has_replies()),
      exact_only_(of.judging.exact_only),
      mode_(of.judging.planted == FilterFault::rounding_mode),
      decider_(of.judging, of.target, of.steps, of.second_opinions) {
  for (KernelRun<Real>& run : of.runs) kernels_.emplace_back(run, of.judging, decider_.filter(), of.first_position);
}

template <class Real>
void SphereTriangleScreen<Real>::decide(const MadeBatch<Real>& made) {
  look_.reset();
  batch_.emplace(decider_.decide(made));
}

template <class Real>
void SphereTriangleScreen<Real>::look_at_errors() {
  for (KernelScreen<Real>& kernel : kernels_) kernel.look_at_errors(*batch_);
}

template <class Real>
void SphereTriangleScreen<Real>::count_in_bulk() {
  open_.assign(batch_->size(), false);
  const std::uint64_t engine_like = engine_like_queries(batch_->queries.columns());
  for (KernelScreen<Real>& kernel : kernels_) {
    kernel.count_engine_like(engine_like);
    kernel.count_in_bulk(*batch_);
    for (std::size_t i = 0; i < open_.size(); ++i) open_[i] |= static_cast<char>(!kernel.has_counted(i));
  }
}

template <class Real>
CheckedQuery<Real>& SphereTriangleScreen<Real>::look(std::size_t i) {
  if (!look_ || look_->index() != i) look_.emplace(decider_, *batch_, i);
  return *look_;
}

template <class Real>
bool SphereTriangleScreen<Real>::try_judge(std::size_t k, std::size_t i) {
  KernelScreen<Real>& kernel = kernels_[k];
  if (kernel.has_counted(i)) return true;
  if (batch_->is_exact(i) || !kernel.judges_by_signs()) return false;
  const bool radius_is_zero = batch_->queries.columns().column[coordinate_count - 1][i] == 0;
  const Signs& signs = batch_->signs[i].signs;
  if (!kernel.count_if_clean(i, signs, radius_is_zero)) kernel.judge_by_signs(i, signs, look(i));
  return true;
}

template <class Real>
void SphereTriangleScreen<Real>::look_at_answer(std::size_t k, std::size_t i,
                                                const typename KernelRun<Real>::JudgedAnswer& found) {
  if (!found.is_counted) return;
  const bool is_filtered = batch_->is_filtered(i) && batch_->is_exact(i);
  kernels_[k].look_at_judged(i, found, is_filtered, look(i));
}

template <class Real>
void SphereTriangleScreen<Real>::sample() {
  if (!has_replies_) sample_critical_radii();
  if (has_margins(batch_->position)) measure_margins();
}

template <class Real>
void SphereTriangleScreen<Real>::sample_critical_radii() {
  for (std::size_t i = 0; i < batch_->size(); ++i) {
    if (!has_critical_radius(batch_->position + i)) continue;
    const Query<Real> q = query_from(batch_->queries[i]);
    if (!is_valid(q)) continue;
    LazyDistance<Real> distance(q, exact_only_);
    for (KernelScreen<Real>& kernel : kernels_) kernel.sample(q, i, distance);
  }
}

template <class Real>
void SphereTriangleScreen<Real>::measure_margins() {
  if (std::none_of(kernels_.begin(), kernels_.end(), [](const auto& one) { return one.shows_comparisons(); })) return;
  for (std::size_t i = 0; i < batch_->size() && has_margins(batch_->position + i); ++i) {
    const Query<Real> q = query_from(batch_->queries[i]);
    if (!is_valid(q)) continue;
    AskedSphereTriangle<Real> asked(q, Opinion::first);
    for (KernelScreen<Real>& kernel : kernels_) kernel.measure_margins(i, asked);
  }
}

template <class Real>
void SphereTriangleScreen<Real>::finish() {
  for (KernelScreen<Real>& kernel : kernels_) kernel.finish();
  decider_.count_times();
}

template class SphereTriangleScreen<float>;
template class SphereTriangleScreen<double>;

namespace {

class SphereTriangleScreens final : public Screens {
 public:
  std::unique_ptr<Screen<float>> screen(const ScreenedRuns<float>& of) const override {
    return std::make_unique<SphereTriangleScreen<float>>(of);
  }
  std::unique_ptr<Screen<double>> screen(const ScreenedRuns<double>& of) const override {
    return std::make_unique<SphereTriangleScreen<double>>(of);
  }
};

}  // namespace

const Screens& sphere_triangle_screens() {
  static const SphereTriangleScreens screens;
  return screens;
}

}  // namespace axiscert
