// Forms against each other: which pairs there are, what is counted of them, and by which clusters.
#include "fuzz/sphere_triangle/formulae/contrasts.h"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>

#include "fuzz/queries/family.h"
#include "fuzz/sphere_triangle/formulae/ladder.h"
#include "kernel/sphere_triangle/forms/scalar.h"

namespace axiscert {
namespace {

std::vector<const Kernel*> cells() {
  std::vector<const Kernel*> all;
  for (const FactorialCell& cell : factorial_cells()) all.push_back(&find_kernel(std::string(name(cell.formulae))));
  return all;
}

TEST(Factorial, EachCellIsTheFormOfItsChoices) {
  using Kinds = EnumArray<AxisKind, bool>;
  ASSERT_EQ(factorial_cells().size(), 20u);
  const auto all = cells();
  for (std::size_t i = 0; i < all.size(); ++i) {
    EXPECT_EQ(factorial_cell(*all[i]), &factorial_cells()[i]);
    for (std::size_t j = 0; j < all.size(); ++j) {
      const bool of_edges = i < edge_cell_count && j < edge_cell_count, of_plane = i >= 16 && j >= 16;
      if (!of_edges && !of_plane) continue;
      EXPECT_EQ(rewritten_kinds(*all[i], *all[j]), (Kinds{of_plane && i != j, false, of_edges && i != j}))
          << all[i]->id << " " << all[j]->id;
    }
  }
  EXPECT_EQ(rewritten_kinds(find_kernel("ladder-9"), find_kernel("published")), (Kinds{false, false, false}));
  EXPECT_EQ(rewritten_kinds(find_kernel("ladder-3"), find_kernel("ladder-4")), (Kinds{false, true, false}));
  EXPECT_EQ(rewritten_kinds(find_kernel("reduced"), find_kernel("reduced+fma")), (Kinds{true, true, true}));
  EXPECT_EQ(factorial_cell(find_kernel("reduced-nonstrict")), nullptr);
}

TEST(Factorial, EachFactorHasEightPairsAndOneEffect) {
  EnumArray<Factor, int> pairs{}, effects{};
  for (const Contrast& contrast : contrasts_of(cells())) {
    if (contrast.kind == ContrastKind::step) continue;
    ++(contrast.kind == ContrastKind::pair ? pairs : effects)[*contrast.factor];
    EXPECT_EQ(contrast.counts[Figure::plane_signs], is_of_plane(*contrast.factor));
    EXPECT_EQ(contrast.counts[Figure::edge_signs], !is_of_plane(*contrast.factor));
    EXPECT_FALSE(contrast.counts[Figure::vertex_signs]);
  }
  EXPECT_EQ(pairs, (EnumArray<Factor, int>{8, 8, 8, 8, 2, 2}));
  EXPECT_EQ(effects, (EnumArray<Factor, int>{1, 1, 1, 1, 1, 1}));
  const auto few = contrasts_of({&find_kernel("ladder-4"), &find_kernel("ladder-5"), &find_kernel("ladder-7")});
  EXPECT_EQ(std::ranges::count(few, ContrastKind::effect, &Contrast::kind), 0) << "an effect has all pairs";
}

LadderPlan ladder_plan_of(std::vector<const Kernel*> kernels, const char* family, std::uint64_t trials) {
  LadderPlan plan;
  plan.kernels = std::move(kernels);
  plan.sources = {family_source(find_family(family))};
  plan.trials = trials;
  plan.speed = false;
  return plan;
}

// Counted again query by query, from the answers themselves.
TEST(Contrasts, ArePairsOfAnswersToTheSameQueries) {
  const LadderPlan plan = ladder_plan_of({&find_kernel("ladder-7"), &find_kernel("ladder-8")}, "far", 3000);
  const LadderResult result = measure_ladder(plan);
  ASSERT_EQ(result.contrasts.size(), 2u) << "a step, and a pair that differs in the frame";
  const auto signs = result.by_source[0].paired(0, 1, Figure::edge_signs);
  EXPECT_EQ(signs.of.trials, 18000u);
  EXPECT_EQ(signs.of.clusters, 3000u) << "a query is a cluster of six comparisons";
  std::uint64_t errors[2] = {};
  for (int k = 0; k < 2; ++k)
    errors[k] = result.entries[k].by_source[0].of(comparisons_of_kind(AxisKind::edge)).sign_errors();
  EXPECT_EQ(static_cast<std::int64_t>(errors[1] - errors[0]), signs.sums.total());
  EXPECT_EQ(signs.only_to + errors[0], signs.only_from + errors[1]);
  EXPECT_EQ(static_cast<std::uint64_t>(result.by_source[0].form(1, Figure::edge_signs).total()), errors[1]);
  const auto missed = result.by_source[0].paired(0, 1, Figure::missed);
  EXPECT_EQ(missed.sums.total(), static_cast<std::int64_t>(result.entries[1].by_source[0].false_separation -
                                                           result.entries[0].by_source[0].false_separation));
  EXPECT_GT(missed.only_from, missed.only_to) << "centring misses fewer contacts";
}

TEST(Contrasts, ImagesOfOneBaseAreOneCluster) {
  LadderPlan plan = ladder_plan_of({&find_kernel("ladder-5"), &find_kernel("ladder-7")}, "orders", 6 * 400);
  plan.sources.push_back(family_source(find_family("axes")));
  const LadderResult result = measure_ladder(plan);
  EXPECT_EQ(result.by_source[0].clusters(), 400u);
  EXPECT_EQ(result.by_source[1].clusters(), 50u);
  const auto paired = result.by_source[0].paired(0, 1, Figure::edge_signs);
  std::int64_t greatest = 0;
  for (const auto& [sum, count] : paired.sums.clusters()) greatest = std::max(greatest, std::abs(sum));
  EXPECT_GT(greatest, 6) << "more than one query has";
  EXPECT_GT(rate_difference(paired)->design_effect, 1.2);
}

// A form against itself is no difference, whatever it gets wrong.
TEST(Contrasts, AFormDoesNotDifferFromItself) {
  const LadderPlan plan = ladder_plan_of({&find_kernel("ladder-9"), &find_kernel("published")}, "tangent", 2000);
  EXPECT_TRUE(measure_ladder(plan).contrasts.empty());
  LadderPlan planted = ladder_plan_of({&find_kernel("ladder-8"), &find_kernel("ladder-9")}, "tangent", 2000);
  Kernel same = find_kernel("ladder-8");
  same.formulae = "ladder-9";  // claims to be the next rung, and is not
  planted.kernels[1] = &same;
  const auto result = measure_ladder(planted);
  const auto signs = result.by_source[0].paired(0, 1, Figure::edge_signs);
  EXPECT_EQ(signs.only_from + signs.only_to, 0u);
  EXPECT_EQ(sign_flip_two_sided(signs.sums).value, 1);
}

// Planted: a kernel that answers contact to one query of twenty that is separated.
template <class Real>
Implementation<Real> phantom_in_twenty() {
  auto made = find_kernel("ladder-9").on<Real>(scalar_target);
  const auto verdicts = made.verdicts;
  made.verdicts = [verdicts](const QueryColumns<Real>& batch, Verdict* out) {
    verdicts(batch, out);
    for (std::size_t i = 0; i < batch.size; i += 20) out[i] = Verdict::contact;
  };
  const auto explain = made.explain;
  made.explain = [explain](const QueryColumns<Real>& batch, Answers<Real>& out) {
    explain(batch, out);
    for (std::size_t i = 0; i < batch.size; i += 20) out.bits[i] = 0;
  };
  return made;
}

TEST(Contrasts, APlantedEffectIsSignificantAndOfItsSize) {
  Kernel planted = find_kernel("ladder-9");
  planted.id = "planted";
  planted.binary32 = [](std::string_view) { return phantom_in_twenty<float>(); };
  const LadderPlan plan = ladder_plan_of({&find_kernel("ladder-8"), &planted}, "general", 4000);
  const LadderResult result = measure_ladder(plan);
  const auto phantom = result.by_source[0].paired(0, 1, Figure::phantom);
  const auto difference = rate_difference(phantom);
  EXPECT_LT(sign_flip_two_sided(phantom.sums).value, 1e-9);
  EXPECT_GT(difference->limits->low, 0.005);
  EXPECT_LT(difference->limits->high, 0.05);
  const auto missed = result.by_source[0].paired(0, 1, Figure::missed);
  EXPECT_EQ(sign_flip_two_sided(missed.sums).value, 1) << "and of nothing else";
}

}  // namespace
}  // namespace axiscert
