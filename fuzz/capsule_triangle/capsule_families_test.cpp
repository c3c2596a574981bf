// A capsule has the truth of a moving sphere by its ends, whichever end comes first; and what each kernel gets wrong.
#include <gtest/gtest.h>

#include <algorithm>

#include "exact/judge/oracles.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/queries/family.h"
#include "kernel/capsule_triangle/capsule.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t few = 200;

template <class Visit>
void for_each_query(Visit&& visit) {
  for (const Family* family : families_of(capsule_triangle_predicate())) {
    for (std::uint64_t i = 0; i < few; ++i) {
      SCOPED_TRACE(std::string(family->name) + ", position " + std::to_string(i));
      visit(*family, family->make<float>(1, i));
      visit(*family, family->make<double>(1, i));
    }
  }
}

TEST(Capsule, HasTheTruthOfTheMovingSphereFromEitherEnd) {
  const Oracles& capsules = oracles_of(capsule_triangle_predicate());
  const Oracles& motions = oracles_of(moving_sphere_predicate(), MovingEnds::entry);
  std::array<int, 2> counts = {};
  for_each_query([&](const Family&, auto query) {
    const Truth truth = capsules.truth(query), motion = motions.truth(query);
    EXPECT_EQ(truth.verdict, motion.verdict);
    EXPECT_EQ(truth.touching, motion.touching);
    for (std::size_t k = 9; k < 12; ++k) std::swap(query[k], query[k + 3]);
    const Truth turned = capsules.truth(query);
    EXPECT_EQ(truth.verdict, turned.verdict);
    EXPECT_EQ(truth.touching, turned.touching);
    ++counts[truth.verdict == Verdict::contact];
  });
  EXPECT_GT(*std::min_element(counts.begin(), counts.end()), 1000);
}

TEST(Capsule, WithoutLengthIsTheSphere) {
  const Oracles& capsules = oracles_of(capsule_triangle_predicate());
  const Oracles& spheres = oracles_of(sphere_triangle_predicate());
  for (std::uint64_t i = 0; i < few; ++i) {
    const Numbers<double> q = find_family("capsule-triangle/ball").make<double>(1, i);
    Numbers<double> sphere(13);
    for (std::size_t k = 0; k < 12; ++k) sphere[k] = q[k];
    sphere[12] = q[15];
    EXPECT_EQ(capsules.truth(q).verdict, spheres.truth(sphere).verdict) << i;
  }
}

// A plank's length above a small face, and one that is through it.
TEST(Capsule, KnownOnesAreRight) {
  const Oracles& capsules = oracles_of(capsule_triangle_predicate());
  const auto verdict = [&](const Numbers<double>& q) { return capsules.truth(q).verdict; };
  EXPECT_EQ(verdict({0, 0, 0, 4, 0, 0, 0, 4, 0, -5, 1, 2, 5, 1, 2, 2}), Verdict::contact);
  EXPECT_EQ(verdict({0, 0, 0, 4, 0, 0, 0, 4, 0, -5, 1, 2, 5, 1, 2, 1.875}), Verdict::separated);
  EXPECT_EQ(verdict({0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, -3, 1, 1, 3, 0}), Verdict::contact);
  EXPECT_EQ(verdict({0, 0, 0, 4, 0, 0, 0, 4, 0, 3, 3, -3, 3, 3, 3, 1}), Verdict::separated);
  EXPECT_EQ(verdict({0, 0, 0, 4, 0, 0, 0, 4, 0, 3, 3, -3, 3, 3, 3, -1}), Verdict::invalid);
  EXPECT_TRUE(capsules.truth(Numbers<double>{0, 0, 0, 4, 0, 0, 0, 4, 0, -5, 1, 2, 5, 1, 2, 2}).touching);
}

// Wrong verdicts of a kernel over a family, missed contacts first.
std::array<std::uint64_t, 2> wrong(const char* kernel, const char* family) {
  Plan plan;
  plan.answerers.kernels = {&find_kernel(kernel)};
  plan.running.target = available_targets().front();
  const SourcePtr source = family_source(find_family(family));
  plan.questions.sources = {source};
  const Tally tally =
      run_unit(plan, *source, Precision::binary64, 0, 1000, {standing_of(empty_tally(capsule_triangle_predicate()))})
          .tallies[0];
  return {tally.verdict.false_separation, tally.verdict.false_contact};
}

TEST(Capsule, TheTwentyAxesAreRightOnSmallIntegersAndOtherMethodsAreNot) {
  using Counts = std::array<std::uint64_t, 2>;
  EXPECT_EQ(wrong("capsule-triangle/twenty-nonstrict", "capsule-triangle/lattice"), (Counts{0, 0}));
  const Counts by_reference = wrong("capsule-triangle/reference-point", "capsule-triangle/lattice"),
               in_turns = wrong("capsule-triangle/alternating", "capsule-triangle/lattice");
  EXPECT_GT(by_reference[0], 0u) << "another point of the segment is nearer";
  EXPECT_GT(wrong("capsule-triangle/twenty", "capsule-triangle/line")[1], 0u) << "sides of 0 > 0";
  EXPECT_GT(in_turns[0], 0u) << "more turns are needed";
  EXPECT_EQ(in_turns[1], 0u) << "each turn is a distance";
}

}  // namespace
}  // namespace axiscert
