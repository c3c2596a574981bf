// Faults planted in each of the fifteen axes of a kernel are caught by the families: by its comparisons, and by its
// verdicts alone, as wrong answers a thousandth of the scene deep.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <atomic>
#include <deque>

#include "fuzz/campaign/campaign.h"
#include "fuzz/boxes/parts.h"
#include "kernel/boxes/projected.h"

namespace axiscert::boxes {
namespace {

// An axis that never separates; one whose radius lacks a term of B that is not 0 on it; one that is asked for its
// neighbour.
enum class AxisFault { dropped, shortened, wrong_axis };

template <class Real>
ComparisonBits planted_bits(AxisFault fault, std::size_t axis, const BoxPair<Real>& q) {
  ComparisonBits bits = 0;
  const auto sink = [&](std::size_t i, Real lhs, Real rhs) {
    if (i == axis && fault == AxisFault::dropped) lhs = 0;
    const std::size_t k = i < 3 ? 2 : i < 6 ? i - 3 : next((i - 6) % 3);
    if (i == axis && fault == AxisFault::shortened) {
      rhs = rhs - q.b.half[k] * magnitude(dot(direction(q, i), q.b.axis[k]));
    }
    if (lhs > rhs) bits |= one_bit<ComparisonBits>(i);
  };
  ProjectedFifteen::comparisons<Real>(q, sink);
  if (fault == AxisFault::wrong_axis) {
    const bool neighbour = has_bit(bits, (axis + 1) % axis_count);
    bits &= ~one_bit<ComparisonBits>(axis);
    if (neighbour) bits |= one_bit<ComparisonBits>(axis);
  }
  return bits;
}

template <class Real>
Implementation<Real> planted_implementation(AxisFault fault, std::size_t axis) {
  const auto bits_at = [=](const QueryColumns<Real>& batch, std::size_t i) {
    return planted_bits<Real>(fault, axis,
                              MatrixBoxes::problem<Real>([&](std::size_t k) { return batch.column[k][i]; }));
  };
  return {[=](const QueryColumns<Real>& batch, Verdict* out) {
            for (std::size_t i = 0; i < batch.size; ++i) out[i] = verdict_of(box_box_predicate(), bits_at(batch, i));
          },
          [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
            for (std::size_t i = 0; i < batch.size; ++i) out.bits[i] = bits_at(batch, i);
          }};
}

// A kernel shows its comparisons and the formulae that it should have, or its verdict alone.
Kernel planted_kernel(AxisFault fault, std::size_t axis, bool shows_comparisons) {
  Kernel kernel = bare_kernel<MatrixBoxes, ProjectedFifteen>(
      fmt::format("box-box/planted-{}-{}-{}", static_cast<int>(fault), axis_names[axis], shows_comparisons), "");
  if (shows_comparisons) kernel.formulae = ProjectedFifteen::name;
  kernel.exposes = shows_comparisons ? Exposure::comparisons : Exposure::verdict;
  kernel.is_reference = shows_comparisons;
  kernel.binary32 = [=](std::string_view) { return planted_implementation<float>(fault, axis); };
  kernel.binary64 = [=](std::string_view) { return planted_implementation<double>(fault, axis); };
  return kernel;
}

double deepest(const Tally& tally) {
  return std::max(tally.verdict.deepest_false_separation.best(), tally.verdict.deepest_false_contact.best());
}

std::vector<Tally> tallies_of(const std::deque<Kernel>& kernels, std::uint64_t queries) {
  Plan plan;
  for (const Kernel& kernel : kernels) plan.answerers.kernels.push_back(&kernel);
  plan.answerers.kernels.push_back(&find_kernel("box-box/projected"));
  plan.questions.sources = {family_source(find_family("box-box/pile")), family_source(find_family("box-box/general"))};
  plan.questions.precisions = {Precision::binary32};
  plan.questions.seed = 7;
  plan.questions.trials = [=](const Source&, Precision) { return queries; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  std::vector<Tally> all(plan.answerers.kernels.size(), empty_tally(box_box_predicate()));
  for (const CellResult& cell : run_campaign(plan, never, [](const Progress&) {}).cells) {
    for (std::size_t k = 0; k < all.size(); ++k) all[k].merge(cell.tallies[k]);
  }
  return all;
}

void expect_caught(AxisFault fault, std::uint64_t queries) {
  std::deque<Kernel> kernels;
  for (const bool shows_comparisons : {true, false}) {
    for (std::size_t axis = 0; axis < axis_count; ++axis) {
      kernels.push_back(planted_kernel(fault, axis, shows_comparisons));
    }
  }
  const std::vector<Tally> tallies = tallies_of(kernels, queries);
  for (std::size_t k = 0; k < kernels.size(); ++k) {
    if (k < axis_count) {
      EXPECT_GT(tallies[k].comparisons[k].links.implementation, 0u) << kernels[k].id;
    } else {
      EXPECT_GT(deepest(tallies[k]), 1e-3) << kernels[k].id << ", seed 7";
    }
  }
  EXPECT_LT(deepest(tallies.back()), 1e-6) << "the kernel without a fault";
}

TEST(PlantedAxes, ThatNeverSeparateAreCaught) { expect_caught(AxisFault::dropped, 1500); }
TEST(PlantedAxesLong, ThatAreShortOrAskedForAnotherAreCaught) {
  expect_caught(AxisFault::shortened, 4000);
  expect_caught(AxisFault::wrong_axis, 4000);
}

}  // namespace
}  // namespace axiscert::boxes
