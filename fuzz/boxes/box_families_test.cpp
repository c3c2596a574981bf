// The families of two boxes make what they claim, the oracles agree on them, and the rungs are wrong where
// docs/boxes.md says: over the reals the textbook, by its own formulae.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cfenv>
#include <cmath>

#include "exact/judge/oracles.h"
#include "fuzz/boxes/parts.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "kernel/ask.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/relative.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {
namespace {

template <class Real>
class BoxFamilies : public testing::Test {};
template <class Real>
class BoxFamiliesLong : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(BoxFamilies, Precisions);
TYPED_TEST_SUITE(BoxFamiliesLong, Precisions);

struct Counts {
  std::uint64_t contacts = 0, touching = 0, invalid = 0;
  double deepest = 0;
};

// The truths of the first queries. The oracles throw where two of them disagree.
template <class Real>
Counts counted(const Family& family, std::uint64_t queries, bool with_depths = false) {
  const Oracles& oracles = oracles_of(box_box_predicate(), family.entry);
  Counts found;
  for (std::uint64_t position = 0; position < queries; ++position) {
    const Numbers<Real> q = family.make<Real>(1, position);
    const Truth truth = oracles.truth(q);
    found.contacts += truth.verdict == Verdict::contact;
    found.touching += truth.touching;
    found.invalid += truth.verdict == Verdict::invalid;
    if (with_depths) found.deepest = std::max(found.deepest, *oracles.depth(q));
  }
  return found;
}

template <class Real>
void expect_agreement(std::uint64_t queries) {
  for (const Family* family : all_families_of(box_box_predicate())) {
    Counts found;
    ASSERT_NO_THROW(found = counted<Real>(*family, queries)) << family->name << ", seed 1";
    EXPECT_EQ(found.invalid, 0u) << family->name;
    EXPECT_GT(found.contacts, queries / 50) << family->name;
    const auto is_of = [&](const char* part) { return family->name.find(part) != family->name.npos; };
    if (!is_of("resting") && !is_of("level") && !is_of("parallel") && !is_of("flat") && !is_of("coincident")) {
      EXPECT_LT(found.contacts, queries) << family->name << " always meets";
    }
  }
}

TYPED_TEST(BoxFamilies, AreAgreedUponByTheOracles) { expect_agreement<TypeParam>(48); }
TYPED_TEST(BoxFamiliesLong, AreAgreedUponByTheOracles) { expect_agreement<TypeParam>(4000 / TRIAL_DIVISOR); }

TYPED_TEST(BoxFamilies, OfTouchingAreWithinRoundingsOfIt) {
  const double most = std::ldexp(1.0, sizeof(TypeParam) == 4 ? -18 : -46);
  for (const char* name : {"tangent", "stacked", "edge_edge", "vertex_face", "thin"}) {
    const Family& family = find_family(fmt::format("box-box/{}", name));
    EXPECT_LT(counted<TypeParam>(family, 60, true).deepest, most) << name;
  }
}

// Integers stay touching exactly, in either entry.
TYPED_TEST(BoxFamilies, OfTheLatticeTouchOften) {
  for (const char* name : {"box-box/lattice", "box-box/lattice_turned", "box-box/lattice_minmax"}) {
    EXPECT_GT(counted<TypeParam>(find_family(name), 120).touching, 5u) << name;
  }
}

// Contacts of 2^-14 and deeper, in lengths of one.
TYPED_TEST(BoxFamilies, OfRestingBoxesAreInContact) {
  for (const char* name : {"box-box/resting", "box-box/level"}) {
    const Counts found = counted<TypeParam>(find_family(name), 100);
    EXPECT_EQ(found.contacts, 100u) << name;
    EXPECT_EQ(found.touching, 0u) << name;
  }
}

// Both third axes are the world's, exactly, and every other pair of queries has A along all three.
TYPED_TEST(BoxFamilies, OfALevelFloorAreUpright) {
  for (std::uint64_t position = 0; position < 100; ++position) {
    const Numbers<TypeParam> q = find_family("box-box/level").make<TypeParam>(1, position);
    const auto axis = [&](std::size_t box, std::size_t k) {
      const std::size_t at = 15 * box + 6 + 3 * k;
      return std::array{q[at], q[at + 1], q[at + 2]};
    };
    using Axis = std::array<TypeParam, 3>;
    EXPECT_EQ(axis(0, 2), (Axis{0, 0, 1})) << position;
    EXPECT_EQ(axis(1, 2), (Axis{0, 0, 1})) << position;
    EXPECT_EQ(axis(0, 0) == (Axis{1, 0, 0}), position / 2 % 2 == 0) << position;
    EXPECT_NE(axis(0, 0), axis(1, 0)) << position << ": B is yawed";
  }
}

template <class F, class Test, class Real>
void expect_nothing_rounded(const Family& family) {
  for (std::uint64_t position = 0; position < 2000; ++position) {
    const Numbers<Real> numbers = family.make<Real>(1, position);
    std::feclearexcept(FE_INEXACT);
    bits_of<F, Real>(Test::template problem<Real>([&](std::size_t k) { return numbers[k]; }),
                     [](std::size_t, Real, Real) {});
    ASSERT_EQ(std::fetestexcept(FE_INEXACT), 0) << family.name << " at " << position << ", " << F::name;
  }
}

TYPED_TEST(BoxFamilies, RoundNothingWhereTheySaySo) {
  const Family& matrix = find_family("box-box/lattice");
  EXPECT_TRUE(matrix.exact_arithmetic);
  expect_nothing_rounded<ProjectedFifteen, MatrixBoxes, TypeParam>(matrix);
  expect_nothing_rounded<Textbook, MatrixBoxes, TypeParam>(matrix);
  expect_nothing_rounded<Cofactor, MatrixBoxes, TypeParam>(matrix);
  const Family& turned = find_family("box-box/lattice_turned");
  EXPECT_TRUE(turned.exact_arithmetic);
  expect_nothing_rounded<ByMatrices<Textbook>, QuaternionBoxes, TypeParam>(turned);
  expect_nothing_rounded<Homogeneous, QuaternionBoxes, TypeParam>(turned);
  const Family& corners = find_family("box-box/lattice_minmax");
  EXPECT_TRUE(corners.exact_arithmetic);
  expect_nothing_rounded<ByMatrices<Textbook>, MinmaxBoxes, TypeParam>(corners);
  expect_nothing_rounded<ByMatrices<Textbook>, MixedBoxes, TypeParam>(find_family("box-box/lattice_mixed"));
}

// Every box A of the families has a half extent of 0.
TYPED_TEST(BoxFamilies, FlatBoxesHaveAnExtentOfZero) {
  for (const char* name : {"box-box/flat", "box-box/rectangles"}) {
    const Family& family = find_family(name);
    for (std::uint64_t position = 0; position < 60; ++position) {
      const Numbers<TypeParam> q = family.make<TypeParam>(1, position);
      EXPECT_TRUE(q[3] == 0 || q[4] == 0 || q[5] == 0) << name << ' ' << position;
    }
  }
}

Tally tally_of(const char* kernel, const char* family, std::uint64_t queries) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel(kernel)};
  plan.questions.sources = {family_source(find_family(family))};
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [=](const Source&, Precision) { return queries; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 2;
  const std::atomic<bool> never = false;
  return run_campaign(plan, never, [](const Progress&) {}).cells.at(0).tallies.at(0);
}

TEST(BoxKernelsOnFamilies, TheTextbookMissesRestingBoxesByItsSpecificationAndCofactorsNone) {
  const Tally textbook = tally_of("box-box/textbook", "box-box/resting", 300);
  EXPECT_GT(textbook.verdict.false_separation, 10u);
  EXPECT_EQ(textbook.verdict.false_contact, 0u);
  EXPECT_GT(textbook.verdict.links[Link::specification], 10u);
  EXPECT_EQ(tally_of("box-box/cofactor", "box-box/resting", 150).verdict.false_separation, 0u);
}

// docs/boxes.md: what the textbook misses, it misses of boxes that are tilted.
TEST(BoxKernelsOnFamilies, TheTextbookMissesNothingOnALevelFloor) {
  const Tally textbook = tally_of("box-box/textbook", "box-box/level", 1000);
  EXPECT_EQ(textbook.verdict.false_separation, 0u);
  EXPECT_EQ(textbook.verdict.false_contact, 0u);
}

TEST(BoxKernelsOnFamiliesLong, TheTextbookMissesNoneOf200000OnALevelFloor) {
  const std::uint64_t queries = 200000 / TRIAL_DIVISOR;
  EXPECT_EQ(tally_of("box-box/textbook", "box-box/level", queries).verdict.false_separation, 0u);
  EXPECT_GT(tally_of("box-box/textbook", "box-box/resting", 1000).verdict.false_separation, 100u);
}

TEST(BoxKernelsOnFamilies, AnEpsilonInventsContactsOfCrossedEdges) {
  EXPECT_GT(tally_of("box-box/gottschalk", "box-box/crossed", 150).verdict.false_contact, 10u);
  EXPECT_EQ(tally_of("box-box/cofactor", "box-box/crossed", 150).verdict.false_contact, 0u);
}

// In the other entry it is the kernel that rounds the rotation.
TEST(BoxKernelsOnFamilies, OfQuaternionsTheSameMissIsOneOfRounding) {
  const Tally textbook = tally_of("box-box/textbook-turned", "box-box/resting_turned", 150);
  EXPECT_GT(textbook.verdict.links[Link::rounding], 10u);
  EXPECT_EQ(textbook.verdict.links[Link::specification], 0u);
}

TEST(BoxKernelsOnFamilies, NothingIsWrongOfTheLattice) {
  for (const char* kernel : {"box-box/projected", "box-box/textbook", "box-box/cofactor"}) {
    const Tally tally = tally_of(kernel, "box-box/lattice", 150);
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.false_contact, 0u) << kernel;
  }
}

}  // namespace

// The families of a box and a triangle: the oracles agree on them, and nothing is rounded where they say so.

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
  expect_exact_triangles<TurnedThirteen, TurnedEntry, TypeParam>("box-triangle/lattice_turned");
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
