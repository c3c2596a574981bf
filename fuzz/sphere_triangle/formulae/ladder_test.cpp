// The ladder: a row contains the results of one kernel only; windows equal the known ones; the number of threads has no
// influence.
#include "exact/judge/side_error.h"
#include "fuzz/sphere_triangle/formulae/ladder.h"

#include <gtest/gtest.h>

#include "exact/sphere_triangle/unbounded.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"

namespace axiscert {
namespace {

LadderPlan ladder_plan(std::vector<const Kernel*> kernels, std::vector<std::string> families, std::uint64_t trials,
                       Precision precision = Precision::binary32) {
  LadderPlan plan;
  plan.kernels = std::move(kernels);
  for (const std::string& family : families) plan.sources.push_back(family_source(find_family(family)));
  plan.precision = precision;
  plan.trials = trials;
  plan.speed = false;
  return plan;
}

std::vector<LadderEntry> entries_of(const LadderPlan& plan) { return measure_ladder(plan).entries; }

void expect_same(const LadderEntry& a, const LadderEntry& b) {
  EXPECT_TRUE(a.all == b.all);
  EXPECT_TRUE(a.by_source == b.by_source);
  EXPECT_EQ(a.windows, b.windows);
}

TEST(Ladder, TheLastRungIsThePublishedTest) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const auto entries = entries_of(ladder_plan({&find_kernel("published"), &find_kernel("ladder-9")},
                                                {"tangent", "sliver", "scale"}, 600, precision));
    EXPECT_GT(entries[0].all.verdict_flips(), 0u);
    EXPECT_FALSE(entries[0].all.radius_errors_ulps.empty());
    expect_same(entries[0], entries[1]);
  }
}

// Planted: the left side of the radius comparison of edge BC has a relative error of 2^-10.
template <class Real>
Implementation<Real> off_on_one_edge() {
  auto published = scalar_implementation<Formulae::published, Strictness::strict, Real>();
  const auto explain = published.explain;
  published.explain = [explain](const QueryColumns<Real>& batch, Answers<Real>& out) {
    explain(batch, out);
    constexpr std::size_t k = index_of(Comparison::edge_bc_radius);
    for (std::size_t i = 0; i < batch.size; ++i) {
      out.lhs[k][i] *= Real(1 + 0x1p-10);
      out.bits[i] &= ~one_bit<ComparisonBits>(k);
      if (out.lhs[k][i] > out.rhs[k][i]) out.bits[i] |= one_bit<ComparisonBits>(k);
    }
  };
  return published;
}

TEST(Ladder, APlantedErrorShowsOnItsAxisAndNowhereElse) {
  Kernel planted = find_kernel("published");
  planted.id = "planted";
  planted.binary32 = [](std::string_view) { return off_on_one_edge<float>(); };
  const auto entries = entries_of(ladder_plan({&find_kernel("published"), &planted}, {"general", "tangent"}, 2000));
  for (std::size_t i = 0; i < axis_count; ++i) {
    const ComparisonAccuracy sound = entries[0].all.of(axis_comparisons[i]),
                             off = entries[1].all.of(axis_comparisons[i]);
    if (static_cast<Axis>(i) != Axis::edge_bc) {
      EXPECT_TRUE(sound == off) << axis_names[i];
      continue;
    }
    EXPECT_GT(off.sign_errors(), sound.sign_errors());
    EXPECT_GT(off.errors.quantile(50), sound.errors.quantile(50));
  }
  // 2^-10 of the left side is 2^14 u of it: between a half and all of that, relative to the sum of both sides.
  const ComparisonAccuracy radius = entries[1].all.of(one_bit<ComparisonBits>(Comparison::edge_bc_radius));
  EXPECT_GT(radius.errors.worst().value(), 0x1p13);
  EXPECT_LT(radius.errors.worst().value(), 0x1p15);
}

TEST(Ladder, SignErrorsAreToldApartByRange) {
  const auto entries = entries_of(ladder_plan({&find_kernel("published")}, {"tangent", "scale"}, 1000));
  const ComparisonAccuracy tangent = entries[0].by_source[0].of(0xffff), scale = entries[0].by_source[1].of(0xffff);
  EXPECT_GT(tangent.rounding_sign_errors(), 0u);
  EXPECT_EQ(tangent.by_range, 0u);
  EXPECT_GT(scale.by_range, 10 * scale.rounding_sign_errors());
}

TEST(Ladder, ThreadsChangeNothing) {
  LadderPlan plan = ladder_plan({&find_kernel("ladder-0"), &find_kernel("reduced-shared")}, {"general", "far"}, 6000);
  plan.threads = 1;
  const LadderResult one = measure_ladder(plan);
  plan.threads = 3;
  const LadderResult three = measure_ladder(plan);
  for (std::size_t k = 0; k < one.entries.size(); ++k) expect_same(one.entries[k], three.entries[k]);
  EXPECT_TRUE(one.by_source == three.by_source);
}

TEST(Ladder, AKernelThatKeepsItsSidesToItselfHasSignsAndNoErrors) {
  const auto entries = entries_of(ladder_plan({&find_kernel("published+in-double")}, {"tangent"}, 1000));
  EXPECT_EQ(entries[0].all.of(0xffff).errors.count(), 0u);
  EXPECT_EQ(entries[0].all.of(0xffff).sign_errors(), 0u) << "binary64 decides binary32 queries";
}

std::optional<ExponentWindow> window_of(const char* kernel, AxisKind kind) {
  return common_window(exponent_windows<float>(find_kernel(kernel)), axes_of_kind(kind));
}

TEST(ExponentWindow, EdgesLeaveBinary32FirstAndTheReducedOnesLater) {
  const auto edge = window_of("published", AxisKind::edge), vertex = window_of("published", AxisKind::vertex);
  ASSERT_TRUE(edge && vertex);
  EXPECT_NEAR(edge->high, 20, 2);
  EXPECT_NEAR(edge->low, -24, 4);
  EXPECT_LE(vertex->low, -30);
  EXPECT_GE(vertex->high, 30);
  const auto reduced = window_of("reduced", AxisKind::edge);
  EXPECT_LT(reduced->low, edge->low);
  EXPECT_GT(reduced->high, edge->high);
  EXPECT_EQ(window_of("reduced", AxisKind::vertex), vertex);
}

// The bits of the unbounded evaluation hold at every scale: they are evaluated again there.
TEST(ExponentWindow, TheUnboundedBitsDoNotDependOnTheScale) {
  const auto queries = window_queries<float>();
  ASSERT_EQ(queries.size(), 256u);
  for (const Formulae formulae : {Formulae::ladder_0, Formulae::ladder_6, Formulae::published, Formulae::reduced}) {
    for (const int m : {scanned_exponents(Precision::binary32).low, -40, 40, 127}) {
      for (std::size_t i = 0; i < queries.size(); i += 16) {
        auto v = coordinates(queries[i]);
        for (float& x : v) {
          const float scaled = std::ldexp(x, m);
          ASSERT_EQ(std::ldexp(scaled, -m), x) << "inexact at 2^" << m;
          x = scaled;
        }
        EXPECT_EQ(unbounded(formulae, Arithmetic::plain, Strictness::strict, from_coordinates(v)),
                  unbounded(formulae, Arithmetic::plain, Strictness::strict, queries[i]))
            << name(formulae) << " 2^" << m << " reference query " << i;
      }
    }
  }
}

TEST(ErrorSpread, QuantilesAreLowerOrderStatisticsOfTheErrors) {
  ErrorSpread low, high;
  for (int i = 1; i <= 101; ++i) {
    const BinaryFraction one(1.0), zero(0.0);
    const SideError error(1 + static_cast<float>(i) * 0x1p-23f, 0.0f, {one, zero});
    (i % 2 ? low : high).add(error);  // 2 i u
  }
  low.merge(high);
  EXPECT_EQ(low.count(), 101u);
  EXPECT_NEAR(*low.quantile(50), 102, 102 * 0x1p-11);
  EXPECT_NEAR(*low.quantile(99), 200, 200 * 0x1p-11);
  EXPECT_EQ(low.worst().text(), "202");
  EXPECT_FALSE(ErrorSpread().quantile(50));
}

TEST(LadderSteps, ARungFollowsTheOneBeforeAndTheReducedFormsTheLast) {
  std::vector<const Kernel*> kernels;
  for (const char* id : {"ladder-7", "ladder-8", "ladder-9", "reduced", "reduced-shared", "reduced+fma", "segments"}) {
    kernels.push_back(&find_kernel(id));
  }
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const LadderStep& step : ladder_steps(kernels)) found.emplace_back(step.from, step.to);
  EXPECT_EQ(found, (decltype(found){{0, 1}, {1, 2}, {2, 3}, {2, 4}, {3, 5}}));
}

TEST(LadderSteps, TheFrontHoldsWhatNothingBeats) {
  std::vector<LadderEntry> entries(4);
  const double ns[] = {10, 20, 30, 15};
  const std::uint64_t flips[] = {500, 100, 100, 600};
  for (std::size_t i = 0; i < 4; ++i) {
    entries[i].speed = KernelSpeed{ns[i], ns[i], std::nullopt};
    entries[i].all.false_contact = flips[i];
  }
  EXPECT_EQ(accuracy_speed_front(entries), (std::vector<std::size_t>{0, 1}));
}

}  // namespace
}  // namespace axiscert
