#include "fuzz/sphere_triangle/decider.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

#include <cfenv>

#include "exact/sphere_triangle/filters/cascade.h"

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
  std::uint64_t in_lanes = 0;
  for (std::size_t i = 0; i < size; ++i) {
    const DecidedSigns& found = decided[i];
    if (found.step == Step::lanes) ++in_lanes;
    else count_step(found);
    if (found.step == Step::exact) continue;
    const std::uint64_t stride = found.step == Step::integers ? integer_check_stride : second_opinion_stride;
    const bool is_checked = (made.position + i) % stride == 0 || found.is_close;
    steps_.checked += is_checked;
    screening_[i] = is_checked ? Screening::cross_checked : Screening::screened;
  }
  steps_.queries[Step::lanes] += in_lanes;
  for (auto& signs : steps_.signs) signs[Step::lanes] += in_lanes;
  return {made, decided, screening_};
}

template <class Real>
void Decider<Real>::count_step(const DecidedSigns& found) {
  ++steps_.queries[found.step];
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const bool in_lanes = has_bit(found.certain_in_lanes, k);
    ++steps_.signs[k][in_lanes ? Step::lanes : found.step];
  }
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

template class Decider<float>;
template class Decider<double>;

}  // namespace axiscert
