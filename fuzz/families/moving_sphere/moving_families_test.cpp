// The families of the moving sphere: oracles that agree on every query, and families that make what they claim.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "exact/trait/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "kernel/ask.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert {
namespace {

template <class Real>
class MovingFamilies : public testing::Test {};
template <class Real>
class MovingFamiliesLong : public testing::Test {};
using MovingReals = testing::Types<float, double>;
TYPED_TEST_SUITE(MovingFamilies, MovingReals);
TYPED_TEST_SUITE(MovingFamiliesLong, MovingReals);

struct MovingCounts {
  std::uint64_t queries = 0, contacts = 0, touching = 0, invalid = 0;
};

// The truth of the first queries at seed 1, which throws where oracles disagree.
template <class Real>
MovingCounts counted(std::string_view name, std::uint64_t queries) {
  const Family& family = find_family(name);
  const Oracles& oracles = oracles_of(moving_sphere_test());
  MovingCounts found;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<Real> numbers = family.make<Real>(1, position);
    const Truth truth = oracles.truth(numbers);
    ++found.queries;
    found.contacts += truth.verdict == Verdict::contact;
    found.touching += truth.touching;
    found.invalid += truth.verdict == Verdict::invalid;
  }
  return found;
}

template <class Real>
void expect_agreement(std::uint64_t queries) {
  for (const Family* family : families_of(moving_sphere_test())) {
    MovingCounts found;
    ASSERT_NO_THROW(found = counted<Real>(family->name, queries)) << family->name << ", seed 1";
    EXPECT_EQ(found.invalid, 0u) << family->name;
    EXPECT_GT(found.contacts, queries / 50) << family->name;
    EXPECT_LT(found.contacts, queries) << family->name << " never misses";
  }
}

TYPED_TEST(MovingFamilies, AreAgreedUponByTheOracles) { expect_agreement<TypeParam>(600); }
TYPED_TEST(MovingFamiliesLong, AreAgreedUponByTheOraclesOnAMillionQueriesOfEach) {
  expect_agreement<TypeParam>(1000000 / TRIAL_DIVISOR);
}

// Every other time they touch exactly, and the other times are within ulps of it.
TYPED_TEST(MovingFamilies, OfTouchingTouchExactly) {
  for (const char* name : {"graze", "touch_end", "touch_start", "along_edge"}) {
    const MovingCounts found = counted<TypeParam>(fmt::format("moving-sphere/{}", name), 240);
    EXPECT_GE(found.touching, found.queries / 2) << name;
    EXPECT_LT(found.touching, found.queries) << name;
  }
}

TYPED_TEST(MovingFamilies, OfNoMotionAreTheStaticQuery) {
  const Family& family = find_family("moving-sphere/zero_d");
  for (std::uint64_t position = 0; position < 100; ++position) {
    const Numbers<TypeParam> q = family.make<TypeParam>(1, position);
    EXPECT_TRUE(q[12] == 0 && q[13] == 0 && q[14] == 0) << position;
  }
}

TYPED_TEST(MovingFamilies, RoundNothingWhereTheySaySo) {
  for (const Family* family : families_of(moving_sphere_test())) {
    if (!family->exact_arithmetic) continue;
    for (std::uint64_t position = 0; position < 2000; ++position) {
      const Numbers<TypeParam> numbers = family->make<TypeParam>(1, position);
      std::feclearexcept(FE_INEXACT);
      bits_of<moving_sphere::Twenty, TypeParam>(
          MovingSphere::problem<TypeParam>([&](std::size_t k) { return numbers[k]; }),
          [](std::size_t, TypeParam, TypeParam) {});
      ASSERT_EQ(std::fetestexcept(FE_INEXACT), 0) << family->name << " at " << position;
    }
  }
}

// The verdicts of the kernels on the lattice, where nothing is rounded: only the theorem is left.
TEST(MovingSphereKernels, WhereNothingIsRoundedTheNonstrictAreRightAndTheStrictInventContacts) {
  Plan plan;
  plan.test = &moving_sphere_test();
  plan.kernels = {&find_kernel("moving-sphere/twenty"), &find_kernel("moving-sphere/twenty-nonstrict")};
  plan.sources = {family_source(find_family("moving-sphere/lattice"))};
  plan.precisions = {Precision::binary64};
  plan.trials = [](const Source&, Precision) { return std::uint64_t{3000}; };
  plan.target = resolve_target("auto");
  plan.threads = 2;
  const std::atomic<bool> never = false;
  const CampaignResult result = run_campaign(plan, never, [](const Progress&) {});
  ASSERT_EQ(result.cells.size(), 1u);
  EXPECT_EQ(result.cells[0].queries, 3000u);
  const std::vector<Tally>& tallies = result.cells[0].tallies;
  for (const Tally& tally : tallies) {
    EXPECT_EQ(tally.verdict.false_separation, 0u) << "over the reals none of the axes separates wrongly";
  }
  EXPECT_GT(tallies[0].verdict.false_contact, 10u);
  EXPECT_EQ(tallies[1].verdict.false_contact, 0u);
}

// Planted by its method: a zero area gives the plane's normal as 0/0, and D = 0 each time.
TEST(MovingSphereKernels, TheRoundedFormMissesContactsOfZeroArea) {
  const Implementation<double> rounded = find_kernel("moving-sphere/rounded").on<double>(scalar_target);
  const Implementation<double> twenty = find_kernel("moving-sphere/twenty-nonstrict").on<double>(scalar_target);
  const Numbers<double> inside_a_segment =
      MovingQuery<double>{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}, {2, 0, 0}, {0, 1, 0}, 1};
  EXPECT_EQ(oracles_of(moving_sphere_test()).truth(inside_a_segment).verdict, Verdict::contact);
  EXPECT_EQ(ask(twenty, inside_a_segment).verdicts[0], Verdict::contact);
  EXPECT_EQ(ask(rounded, inside_a_segment).verdicts[0], Verdict::separated);
  const Numbers<double> ahead = MovingQuery<double>{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {0, 0, -3}, 1};
  EXPECT_EQ(ask(rounded, ahead).verdicts[0], Verdict::contact);
}

// Wrong answers of a kernel to contacts and to separations, of as many queries of a family.
std::pair<int, int> missed_and_invented(const char* kernel, const char* family, std::uint64_t queries) {
  const Implementation<double> implementation = find_kernel(kernel).on<double>(scalar_target);
  int missed = 0, invented = 0;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<double> q = find_family(family).make<double>(1, position);
    const Verdict truth = oracles_of(moving_sphere_test()).truth(q).verdict, said = ask(implementation, q).verdicts[0];
    missed += said == Verdict::separated && truth == Verdict::contact;
    invented += said == Verdict::contact && truth == Verdict::separated;
  }
  return {missed, invented};
}

TEST(MovingSphereKernels, OtherFormsAreRightOnOrdinaryMotionsAndAdvancingByLengthComesTooLate) {
  const std::pair<int, int> none{0, 0};
  for (const char* kernel : {"moving-sphere/rounded", "moving-sphere/segment", "moving-sphere/advance"}) {
    EXPECT_EQ(missed_and_invented(kernel, "moving-sphere/general", 1500), none) << kernel;
  }
  const auto [missed, invented] = missed_and_invented("moving-sphere/advance-by-length", "moving-sphere/general", 1500);
  EXPECT_GT(missed, 10);
  EXPECT_EQ(invented, 0);
}

}  // namespace
}  // namespace axiscert
