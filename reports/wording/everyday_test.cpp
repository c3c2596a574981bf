// What is said first of a kernel: scenes with lengths, then what nothing rounds, then all others, then units.
#include "reports/wording/everyday.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiscert {
namespace {

using testing::ElementsAre;

// 600 contacts and 400 separations.
FamilyRecord family_of(std::uint64_t missed, double farthest_missed, std::uint64_t invented, double farthest_invented) {
  FamilyRecord family;
  family.trials = 1000;
  family.truth = {400, 600, 0, 0};
  family.verdict.outside_limits.reset();
  family.verdict.false_separation = missed;
  family.verdict.false_contact = invented;
  if (missed != 0) {
    family.verdict.farthest_false_separation.offer({farthest_missed, 0});
    family.verdict.deepest_false_separation.offer({0.25, 0});
  }
  if (invented != 0) {
    family.verdict.farthest_false_contact.offer({farthest_invented, 0});
    family.verdict.deepest_false_contact.offer({0.125, 0});
  }
  return family;
}

KernelRecord kernel_of(std::initializer_list<std::pair<const char*, FamilyRecord>> families) {
  KernelRecord kernel;
  for (const auto& [name, family] : families) kernel.families.put(name) = family;
  return kernel;
}

TEST(Everyday, ComesFirstInMetres) {
  const KernelRecord kernel = kernel_of({{"tangent", family_of(5, 1e30, 0, 0)},
                                         {"lattice", family_of(0, 0, 0, 0)},
                                         {"scene-walk", family_of(0, 0, 20, 0.166)},
                                         {"scene-edge", family_of(0, 0, 7, 0.01)},
                                         {"mesh/a.obj", family_of(1, 0.5, 0, 0)}});
  PlanRecord plan;
  EXPECT_THAT(
      first_sentences(kernel, plan),
      ElementsAre(
          "2,000 everyday scenes: 27 contacts invented, worst 16.6 cm, 0.125 of the scene (scene-walk); "
          "none missed",
          "1,000 of your own queries: 1 contact missed, worst 0.5 units, 0.25 of the scene (mesh/a.obj); "
          "none invented",
          "1,000 queries that nothing rounds: no wrong verdict",
          "1,000 other queries (random, touching, degenerate, huge, tiny): 5 contacts missed, worst 0.25 of the "
          "scene (tangent); none invented"));
  plan.unit = Name("cm");
  EXPECT_THAT(first_sentences(kernel, plan)[1], testing::HasSubstr("worst 5 mm"));
}

TEST(Everyday, SaysWhichKindGotTooFewVerdicts) {
  FamilyRecord family = family_of(0, 0, 20, 0.166);
  VerdictTally& verdict = family.verdict;
  const auto said = [&] { return first_sentences(kernel_of({{"scene-walk", family}}), PlanRecord()).front(); };
  const std::string invented =
      "1,000 everyday scenes: 20 contacts invented, worst 16.6 cm, 0.125 of the scene "
      "(scene-walk); ";
  verdict.undecided = verdict.undecided_contact = 300;
  EXPECT_EQ(said(), invented + "none missed; 300 without a verdict");
  verdict.undecided = verdict.undecided_contact = 600;
  EXPECT_EQ(said(), invented + "missed: not checked; 600 without a verdict; 0 of 600 contacts decided");
  family = family_of(0, 0, 0, 0);
  verdict.undecided = 966;
  verdict.undecided_contact = 600;
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; 966 without a verdict; 0 of 600 contacts decided; 34 of "
            "400 separations decided");
  verdict.undecided = verdict.undecided_contact = 0;
  verdict.unanswered = 900;
  verdict.decided_contacts = 100;
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; 900 without a verdict; 100 of 600 contacts decided; 0 of 400 "
            "separations decided");
}

TEST(Everyday, SaysThatNoTimeIsOffWhereTheKernelGivesThem) {
  FamilyRecord family = family_of(0, 0, 0, 0);
  family.contacts.emplace().time->best = 11;
  const auto said = [&] { return first_sentences(kernel_of({{"scene-walk", family}}), PlanRecord()).front(); };
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict; no time late or early");
  family.contacts->time->none = 458;
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; no time late or early; no time beside 458 of 469 contacts");
  family.contacts->time->best = 0;
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict; no time beside 458 of 458 contacts");
  family.contacts->time.reset();
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict");
}

TEST(Everyday, SaysHowFarTimesAreOffInLengthAndOfTheWay) {
  FamilyRecord family = family_of(0, 0, 0, 0);
  TimeTally& time = *family.contacts.emplace().time;
  time.late = 266;
  time.late_errors.largest_length.offer({0.124, 0});
  time.late_errors.largest_share.offer({0.957, 0});
  time.early = 1;
  time.early_errors.largest_length.offer({2e-6, 0});
  time.early_errors.largest_share.offer({1e-7, 0});
  EXPECT_THAT(first_sentences(kernel_of({{"moving-sphere/scene_walk", family}, {"tangent", family}}), PlanRecord()),
              ElementsAre("1,000 everyday scenes: no wrong verdict; 266 times late, by 12.4 cm at most, 0.957 of the "
                          "way; 1 time early, by 2 um at most, 1e-07 of the way",
                          "1,000 other queries (random, touching, degenerate, huge, tiny): no wrong verdict"));
}

TEST(Everyday, SaysWhatElseOfContactsAPersonWouldSee) {
  FamilyRecord family = family_of(0, 0, 0, 0);
  ContactTally& motion = family.contacts.emplace();
  motion.time.reset();
  const auto said = [&] {
    return first_sentences(kernel_of({{"moving-sphere/scene_walk", family}}), PlanRecord()).front();
  };
  motion.normal->largest_angle.offer({0.017, 0});
  motion.point->largest_error.offer({9e-4, 0});
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict") << "below a degree and a thousandth";
  motion.feature->wrong = 259;
  motion.normal->largest_angle.offer({2.43, 1});
  motion.point->largest_error.offer({0.2, 1});
  EXPECT_EQ(
      said(),
      "1,000 everyday scenes: no wrong verdict; 259 features wrong; normals up to 139 degrees off; points up to 0.2 of "
      "the scene off");
  motion.feature->wrong = 0;
  motion.normal->largest_angle = Leaders<double>();
  motion.point->none = 12;
  motion.point->judged = 988;
  motion.points->largest_error.offer({0.5, 2});
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; no point beside 12 of 1,000 answers; points up to 0.5 of the "
            "scene off")
      << "of two bodies, a push by the way between the points counts too";
}

TEST(Everyday, SaysTheWorstSeparationInMetresAndFlips) {
  FamilyRecord family = family_of(0, 0, 0, 0);
  ContactTally& numbers = family.contacts.emplace();
  numbers.time.reset();
  const auto said = [&] { return first_sentences(kernel_of({{"scene-walk", family}}), PlanRecord()).front(); };
  numbers.answers = 1000;
  numbers.separation->judged = numbers.pushed->judged = 12;
  numbers.pushed->none = 360;
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; separations, given beside 12 of 1,000 answers, off by 0 m at "
            "most; no flip; no normal beside 360 of 372 overlaps");
  numbers.pushed->none = 0;
  numbers.separation->judged = numbers.pushed->judged = 1000;
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict; separations off by 0 m at most; no flip");
  numbers.pushed->nowhere = 1000;
  EXPECT_EQ(said(), "1,000 everyday scenes: no wrong verdict; separations off by 0 m at most") << "none has a side";
  numbers.pushed->nowhere = 0;
  numbers.separation->largest_length.offer({0.0032, 0});
  numbers.separation->largest_error.offer({0.01, 0});
  numbers.consistency->positive = 2;
  numbers.pushed->flips = 4;
  EXPECT_EQ(said(),
            "1,000 everyday scenes: no wrong verdict; separations off by 3.2 mm at most; 2 separations of the "
            "wrong sign; 4 flips");
  numbers.separation->less_margin.emplace().largest_length.offer({0.001, 0});
  numbers.separation->less_margin->largest_error.offer({0.003, 0});
  EXPECT_THAT(said(), testing::HasSubstr("; separations off by 1 mm at most;"));
}

TEST(Everyday, SaysNothingOfAGroupThatWasNotAsked) {
  EXPECT_TRUE(first_sentences(KernelRecord(), PlanRecord()).empty());
  FamilyRecord none = family_of(0, 0, 0, 0);
  none.truth = {0, 0, 0, 1000};
  EXPECT_TRUE(first_sentences(kernel_of({{"scene-walk", none}}), PlanRecord()).empty());
}

TEST(Everyday, SaysTheUnitsInWhichItAnswersAlike) {
  KernelRecord kernel;
  kernel.window = WindowRecord{-24, 20, -140, 125, 100};
  EXPECT_THAT(
      first_sentences(kernel, PlanRecord()),
      ElementsAre("in other units: as in this one only from 2^-24 to 2^20 times it (2^-140 to 2^125 were asked)"));
  kernel.window = WindowRecord{0, 0, -140, 125, 100};
  EXPECT_THAT(
      first_sentences(kernel, PlanRecord()),
      ElementsAre("in other units: other answers at half the unit and at twice it (2^-140 to 2^125 were asked)"));
  kernel.window = WindowRecord{-140, 125, -140, 125, 100};
  EXPECT_THAT(first_sentences(kernel, PlanRecord()),
              ElementsAre("in other units: as in this one, times 2^-140 to 2^125"));
}

}  // namespace
}  // namespace axiscert
