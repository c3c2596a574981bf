#include "fuzz/sphere_triangle/screen.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <algorithm>

#include "exact/sphere_triangle/measures/input_class.h"
#include "fuzz/record/margins.h"

namespace axiscert {
namespace {

void require_ieee_modes() {
#if defined(__x86_64__)
  // The vector unit's own register: rounding in bits 13 and 14, flush to zero 15, denormals are zero 6.
  const bool is_ieee = (_mm_getcsr() & 0xe040u) == 0;
#else
  const bool is_ieee = true;
#endif
  if (is_ieee && std::fegetround() == FE_TONEAREST) return;
  throw HarnessFault(
      "the rounding mode is not to nearest, or subnormals are flushed: something left it so, and no filter "
      "is certain");
}

}  // namespace

template <class Real>
DecidedBatch<Real> Decider<Real>::decide(const MadeBatch<Real>& made) {
  const std::size_t size = made.size();
  screening_.assign(size, Screening::skipped);
  if (exact_only_) {
    steps_.queries[Step::exact] += size;
    undecided_.resize(size);
    return {made, undecided_, screening_};
  }
  require_ieee_modes();
  const std::vector<DecidedSigns>& decided = cascade_.decide(made.queries);
  EnumArray<Step, std::uint64_t> queries{};
  EnumArray<Step, std::array<std::uint32_t, comparison_count>> in_lanes{};  // signs of queries that the lanes left
  for (std::size_t i = 0; i < size; ++i) {
    const DecidedSigns& found = decided[i];
    ++queries[found.step];
    if (found.step != Step::lanes) {
      for (std::size_t k = 0; k < comparison_count; ++k) in_lanes[found.step][k] += found.certain_in_lanes >> k & 1u;
    }
    if (found.step == Step::exact) continue;
    const std::uint64_t stride = found.step == Step::integers ? integer_check_stride : second_opinion_stride;
    const bool is_checked = (made.position + i) % stride == 0 || found.is_close;
    steps_.checked += is_checked;
    screening_[i] = is_checked ? Screening::cross_checked : Screening::screened;
  }
  for (std::size_t s = 0; s < enum_count<Step>; ++s) {
    const auto step = static_cast<Step>(s);
    steps_.queries[step] += queries[step];
    for (std::size_t k = 0; k < comparison_count; ++k) {
      steps_.signs[k][step] += queries[step] - in_lanes[step][k];
      steps_.signs[k][Step::lanes] += in_lanes[step][k];
    }
  }
  return {made, decided, screening_};
}

template <class Real>
Opinion Decider<Real>::opinion_on(std::uint64_t position) const {
  if (exact_only_) return Opinion::exact_only;
  return position % second_opinion_stride == 0 ? Opinion::second : Opinion::first;
}

template <class Real>
void Decider<Real>::check(const DecidedBatch<Real>& batch, std::size_t index, const Query<Real>& q,
                          const ExactTruth& truth) {
  if (!truth.sides) return;
  second_opinions_ += opinion_on(batch.position + index) != Opinion::first;
  ++steps_.by_cgal;
  if (batch.is_filtered(index)) require_same(batch.signs[index], truth, q);
}

template <class Real>
void Decider<Real>::count_times() const {
  for (const Step step : {Step::lanes, Step::grid, Step::wide, Step::integers}) {
    steps_.steps[step] = cascade_.nanoseconds(step);
  }
}

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
const std::vector<std::size_t>& SphereTriangleScreen<Real>::count_in_bulk() {
  if (std::ranges::any_of(kernels_, &KernelScreen<Real>::judges_by_signs))
    find_engine_like(batch_->queries.columns(), engine_like_);
  for (KernelScreen<Real>& kernel : kernels_) kernel.count_in_bulk(*batch_, engine_like_);
  open_.clear();
  for (std::size_t i = 0; i < batch_->size(); ++i) {
    const auto is_left = [&](const KernelScreen<Real>& kernel) { return !kernel.has_counted(i); };
    if (std::any_of(kernels_.begin(), kernels_.end(), is_left)) open_.push_back(i);
  }
  return open_;
}

template <class Real>
void SphereTriangleScreen<Real>::look_at_errors() {
  for (KernelScreen<Real>& kernel : kernels_) kernel.look_at_errors(*batch_);
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
  kernel.judge_by_signs(i, batch_->signs[i].signs, look(i));
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
