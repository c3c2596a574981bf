// The steps compiled for every instruction set, each by itself.
#include "proofs/tests/certified_steps.h"

#include <limits>
#include <type_traits>

#include "kernel/sphere_triangle/certified/exact_step.h"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/thresholds.h"
#include "kernel/sphere_triangle/names.h"

#define HWY_COMPILE_ALL_ATTAINABLE
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "proofs/tests/certified_steps.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/certified/coarse_step-inl.h"
#include "kernel/sphere_triangle/certified/conservative_step-inl.h"
#include "kernel/sphere_triangle/certified/margins-inl.h"
#include "kernel/sphere_triangle/certified/fine_step-inl.h"
#include "kernel/sphere_triangle/certified/pairs-inl.h"
#include "kernel/sphere_triangle/certified/wrapped-inl.h"
#include "kernel/sphere_triangle/certified/deep_step-inl.h"
#include "kernel/sphere_triangle/certified/leftovers-inl.h"
#include "kernel/sphere_triangle/certified/pair_step-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {
using proofs::StepAnswers, proofs::StepForms;

// The flags of the first lanes, bit by bit of the answers.
template <class D>
void add_flag(D d, hn::Mask<D> mask, int bit, std::size_t count, StepAnswers* out) {
  const std::uint64_t lanes = bits_of(d, mask);
  for (std::size_t j = 0; j < count; ++j) out[j].bits |= ((lanes >> j) & 1u) << bit;
}
template <class D>
void store_words(D, hn::Vec<hn::RebindToUnsigned<D>> words, std::size_t count, StepAnswers* out,
                 std::uint64_t StepAnswers::*to) {
  const hn::RebindToUnsigned<D> unsigned_lanes;
  hn::TFromD<hn::RebindToUnsigned<D>> stored[hn::MaxLanes(unsigned_lanes)];
  hn::StoreU(words, unsigned_lanes, stored);
  for (std::size_t j = 0; j < count; ++j) out[j].*to = stored[j];
}

template <DeepComparison what, class D>
void deep(D d, const Problem<Lanes<D>>& q, std::size_t count, StepAnswers* out) {
  for (const bool open : {false, true}) {
    const auto found = DeepStep<D>(d, q, open).template answer<what>();
    add_flag(d, found.holds, 2 * open, count, out);
    add_flag(d, found.fails, 2 * open + 1, count, out);
  }
}

// The first `count` lanes of a vector of queries.
template <class D>
void answer(std::string_view step, D d, const Block<hn::TFromD<D>>& block, std::size_t count, StepAnswers* out) {
  const Problem<Lanes<D>> q = load(d, block, 0);
  if (step == "coarse") {
    const auto m = coarse_margins(q);
    const CoarseLimits<D, true> limits(m.S, m.E);
    const DecidedLanes<D> decided = coarse_step(m, limits);
    add_flag(d, decided.separated, 0, count, out);
    add_flag(d, decided.contact, 1, count, out);
    if constexpr (sizeof(hn::TFromD<D>) == 8) add_flag(d, limits.in_deep_range(m.S, m.r), 2, count, out);
    store_words(d, coarsely_known(d, m, limits), count, out, &StepAnswers::known);
  } else if (step == "conservative" || step == "conservative_scaled") {
    const auto unfused = load<false>(d, block, 0);
    const auto found =
        step == "conservative" ? Conservative<D>::answer(unfused) : Conservative<D>::answer_scaled(unfused);
    add_flag(d, found.separated, 0, count, out);
    add_flag(d, found.unknown, 1, count, out);
  }
  if constexpr (sizeof(hn::TFromD<D>) == 8) {
    if (step == "fine") {
      const FineStep<D> closed(d, q, false), open(d, q, true);
      const auto found = closed.answer(), found_open = open.answer();
      add_flag(d, closed.is_valid(), 0, count, out);
      add_flag(d, closed.is_sound(), 1, count, out);
      add_flag(d, found.decided.separated, 2, count, out);
      add_flag(d, found.decided.contact, 3, count, out);
      add_flag(d, found_open.decided.separated, 4, count, out);
      add_flag(d, found_open.decided.contact, 5, count, out);
      store_words(d, found.known, count, out, &StepAnswers::known);
      store_words(d, found_open.known, count, out, &StepAnswers::known_open);
    } else if (step == "deep_vertex_radius") deep<DeepComparison::vertex_radius>(d, q, count, out);
    else if (step == "deep_vertex_sides") deep<DeepComparison::vertex_sides>(d, q, count, out);
    else if (step == "deep_edge_radius") deep<DeepComparison::edge_radius>(d, q, count, out);
    else if (step == "deep_edge_side") deep<DeepComparison::edge_side>(d, q, count, out);
    else if (step == "deep_plane_radius") deep<DeepComparison::plane_radius>(d, q, count, out);
  }
}

template <class Real>
void answer_all(std::string_view step, const Real* const* columns, std::size_t size, StepAnswers* out) {
  const hn::ScalableTag<Real> d;
  constexpr std::size_t lanes = hn::MaxLanes(d);
  for (std::size_t i = 0; i < size; ++i) out[i] = {};
  using Four = std::conditional_t<lanes >= 4, hn::CappedTag<Real, 4>, void>;
  if (step == "pair") {
    if constexpr (!std::is_void_v<Four>) {
      for (std::size_t i = 0; i < size; ++i) {
        Real q[13];
        for (std::size_t k = 0; k < 13; ++k) q[k] = columns[k][i];
        const PairStep<Four> found(q, q + 9);
        out[i].bits = std::uint64_t{found.separated()} | std::uint64_t{found.contact()} << 1;
      }
    }
    return;
  }
  for (std::size_t i = 0; i < size; i += lanes) {
    const std::size_t count = size - i < lanes ? size - i : lanes;
    Real padded[13][lanes];
    Block<Real> block{{}, lanes, false};
    for (std::size_t k = 0; k < 13; ++k) {
      for (std::size_t j = 0; j < lanes; ++j) padded[k][j] = columns[k][j < count ? i + j : i];
      block.column[k] = padded[k];
    }
    answer(step, d, block, count, out + i);
  }
}

StepForms step_forms() {
  return {HWY_NATIVE_FMA != 0, hn::MaxLanes(hn::ScalableTag<double>()), answer_all<float>, answer_all<double>};
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert::certified {
HWY_EXPORT(step_forms);
proofs::StepForms step_forms_of_the_chosen_target() { return HWY_DYNAMIC_DISPATCH(step_forms)(); }
}  // namespace axiscert::certified

namespace axiscert::proofs {
StepForms chosen_step_forms() { return axiscert::certified::step_forms_of_the_chosen_target(); }
}  // namespace axiscert::proofs
#endif
