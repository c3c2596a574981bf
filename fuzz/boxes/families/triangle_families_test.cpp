// The families of a box and a triangle: the oracles agree on them, and nothing is rounded where they say so.
#include <gtest/gtest.h>

#include <cfenv>

#include "exact/trait/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {
namespace {

template <class Real>
class TriangleFamilies : public testing::Test {};
template <class Real>
class TriangleFamiliesLong : public testing::Test {};
using TrianglePrecisions = testing::Types<float, double>;
TYPED_TEST_SUITE(TriangleFamilies, TrianglePrecisions);
TYPED_TEST_SUITE(TriangleFamiliesLong, TrianglePrecisions);

template <class Real>
void expect_triangle_agreement(std::uint64_t queries) {
  for (const Family* family : families_of(box_triangle_predicate())) {
    const Oracles& oracles = oracles_of(box_triangle_predicate(), family->entry);
    std::uint64_t contacts = 0, touching = 0;
    for (std::uint64_t position = 0; position < queries; ++position) {
      Truth truth{};
      ASSERT_NO_THROW(truth = oracles.truth(family->make<Real>(1, position))) << family->name << " at " << position;
      ASSERT_NE(truth.verdict, Verdict::invalid) << family->name << " at " << position;
      contacts += truth.verdict == Verdict::contact;
      touching += truth.touching;
    }
    EXPECT_TRUE(contacts > 0 && contacts < queries) << family->name << ": " << contacts;
    if (family->exact_arithmetic) {
      EXPECT_GT(touching, 0u) << family->name;
    }
  }
}
TYPED_TEST(TriangleFamilies, AreAgreedUponByTheOracles) { expect_triangle_agreement<TypeParam>(60); }
TYPED_TEST(TriangleFamiliesLong, AreAgreedUponByTheOracles) {
  expect_triangle_agreement<TypeParam>(4000 / TRIAL_DIVISOR);
}

template <class F, class Entry, class Real>
void expect_exact_triangles(const char* name) {
  const Family& family = find_family(name);
  ASSERT_TRUE(family.exact_arithmetic && family.entry == Entry::entry) << name;
  for (std::uint64_t position = 0; position < 1000; ++position) {
    const Numbers<Real> numbers = family.make<Real>(1, position);
    std::feclearexcept(FE_INEXACT);
    bits_of<F, Real>(Entry::template problem<Real>([&](std::size_t k) { return numbers[k]; }),
                     [](std::size_t, Real, Real) {});
    ASSERT_EQ(std::fetestexcept(FE_INEXACT), 0) << name << " at " << position << ", " << F::name;
  }
}
TYPED_TEST(TriangleFamilies, RoundNothingWhereTheySaySo) {
  expect_exact_triangles<Thirteen, CentreEntry, TypeParam>("box-triangle/lattice");
  expect_exact_triangles<TextbookThirteen, CentreEntry, TypeParam>("box-triangle/degenerate");
  expect_exact_triangles<TextbookThirteen, MinmaxEntry, TypeParam>("box-triangle/lattice_minmax");
  expect_exact_triangles<FramedThirteen, OrientedEntry, TypeParam>("box-triangle/lattice_oriented");
}

// Over the reals the axis-aligned textbook is right: what is wrong is rounding; and on small integers nothing is.
TEST(TriangleKernelsOnFamilies, TheTextbookIsWrongByRoundingAlone) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel("box-triangle/textbook-minmax")};
  for (const char* family : {"touching_minmax", "voxel", "lattice_minmax"}) {
    plan.questions.sources.push_back(family_source(find_family("box-triangle/" + std::string(family))));
  }
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [](const Source&, Precision) { return std::uint64_t{300}; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  const CampaignResult result = run_campaign(plan, never, [](const Progress&) {});
  ASSERT_EQ(result.cells.size(), 3u);
  for (const auto& cell : result.cells) {
    const auto& verdict = cell.tallies.at(0).verdict;
    EXPECT_EQ(verdict.links[Link::specification], 0u);
  }
  EXPECT_GT(result.cells[0].tallies.at(0).verdict.links[Link::rounding], 10u);
  const auto& lattice = result.cells[2].tallies.at(0).verdict;
  EXPECT_EQ(lattice.false_separation + lattice.false_contact, 0u);
}

}  // namespace
}  // namespace axiscert::boxes
