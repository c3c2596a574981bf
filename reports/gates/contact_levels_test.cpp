// The levels early, separation, feature, normal, unit, no-flip, left and point: what a record says of the numbers
// beside a contact, and a kernel with one planted fault each.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <algorithm>
#include <deque>

#include "fuzz/instruments/black_box.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/json.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/planted_contacts_testing.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::Contains, testing::HasSubstr, testing::Not;

// The contacts of `contacts` with all measures, of which so many are wrong or missing.
Json numbers(double earliest_u, std::uint64_t wrong, double region, double angle, double length, double point,
             std::uint64_t none = 0) {
  Json found = contacts(0, 0, 0);
  found["time"]["early_errors"]["largest_in_u"] = earliest_u;
  found["time"]["early_errors"]["largest_share"] = std::ldexp(earliest_u, -24);
  found["time"]["early_errors"]["largest_length"] = std::ldexp(earliest_u, -5);
  found["feature"] = {
      {"judged", 900 - none},   {"none", none}, {"wrong", wrong}, {"unnamed", 0}, {"given", given_beside(900 - none)},
      {"largest_error", region}};
  found["normal"] = {{"judged", 900 - none},   {"lengths", 900 - none},
                     {"none", none},           {"given", given_beside(900 - none)},
                     {"largest_angle", angle}, {"largest_length_error", length}};
  found["point"] = {
      {"judged", 900 - none}, {"none", none}, {"given", given_beside(900 - none)}, {"largest_error", point}};
  return found;
}
Json with_numbers(const Json& on_tangent) {
  Json record = motions(on_tangent);
  record["kernels"][0]["families"]["lattice"]["contacts"] = numbers(0, 0, 0, 0, 0, 0);
  return record;
}
std::string first_failure(const Json& on_tangent, const char* level) {
  const auto failures = unmet(with_numbers(on_tangent), level);
  return failures.empty() ? "" : failures[0].what;
}

TEST(ContactLevels, EachHasABoundInTheUnitOfTheRecord) {
  const Json found = numbers(16, 3, 0.25, 0.5, 0.125, 0.0625);
  EXPECT_EQ(first_failure(found, "early=16"), "");
  EXPECT_EQ(
      first_failure(found, "early=15"),
      "times before the best one, the earliest by 16 u of the displacement, 9.54e-07 of the way, length 0.5: 15 u "
      "is allowed");
  EXPECT_EQ(first_failure(found, "early=50cm"), "");
  EXPECT_EQ(first_failure(found, "early=49.9cm"),
            "times before the best one, the earliest by 50 cm of the way: 49.9 cm is allowed");
  EXPECT_EQ(first_failure(found, "feature"), "wrong features");
  EXPECT_EQ(first_failure(found, "feature=0.25"), "");
  EXPECT_EQ(first_failure(found, "feature=0.2"), "wrong features, the farthest by 0.25 of the scene: 0.2 is allowed");
  EXPECT_EQ(first_failure(found, "normal=28.7"), "");
  EXPECT_EQ(first_failure(found, "normal=28.6"), "the worst normal is off by 28.65 degrees: 28.6 is allowed");
  EXPECT_EQ(first_failure(found, "unit=0.125"), "");
  EXPECT_EQ(first_failure(found, "unit=0.1"), "the worst length of a normal is off by 0.125 of 1: 0.1 is allowed");
  EXPECT_EQ(first_failure(found, "point=0.0625"), "");
  EXPECT_EQ(first_failure(found, "point=0.05"), "the worst point is off by 0.0625 of the scene: 0.05 is allowed");
}

TEST(ContactLevels, ALengthIsInTheUnitOfTheQueriesAndItsWitnessIsTheOneOfTheLength) {
  Json record = with_numbers(numbers(16, 0, 0, 0, 0, 0));
  record["plan"]["unit"] = "mm";
  record["witnesses"].back()["shows"] = {"earliest time: 16 u of the displacement", "earliest time: 0.5 in length"};
  EXPECT_TRUE(unmet(record, "early=0.5mm").empty());
  const auto failures = unmet(record, "early=499um");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].text(),
            "<script> binary32 on tangent: times before the best one, the earliest by 500 um of the way: 499 um is "
            "allowed: 1 (witness late)");
}

TEST(ContactLevels, AFeatureThatThereIsNotFailsWhateverIsAllowed) {
  Json found = numbers(0, 2, 0, 0, 0, 0);
  found["feature"]["unnamed"] = 2;
  EXPECT_EQ(first_failure(found, "feature=1"), "features that there are not");
}

TEST(ContactLevels, SayOfHowManyContacts) {
  for (const char* level : {"early=1", "early=1um", "feature", "normal=0.1", "unit=0.1", "point=0.1"}) {
    const LevelOutcome met = outcomes_at(with_numbers(numbers(0, 0, 0, 0, 0, 0)), level)[0];
    EXPECT_EQ(met.state, LevelState::met) << level << met.reason;
    EXPECT_THAT(met.covers, HasSubstr("of 1,800 contacts of")) << level;
    EXPECT_EQ(met.looked_at, 1800u) << level;
  }
}

TEST(ContactLevels, AKernelThatGivesNoneOrSeldomIsNotChecked) {
  Json untimed = motions(contacts(0, 0, 0));
  for (const char* family : {"tangent", "lattice"})
    untimed["kernels"][0]["families"][family]["contacts"]["time"] = nullptr;
  for (const char* level : {"early=64", "early=1mm"}) {
    EXPECT_EQ(outcomes_at(untimed, level)[0].reason, "the kernel gives no time of contact") << level;
    EXPECT_THAT(outcomes_at(stored_record(), level)[0].reason, HasSubstr("sphere-triangle has no time")) << level;
  }
  for (const auto& [level, what] :
       {std::pair{"feature=0.1", "feature"}, {"normal=1", "normal"}, {"unit=1", "normal"}, {"point=1", "point"}}) {
    const LevelOutcome none = outcomes_at(motions(contacts(0, 0, 0)), level)[0];
    EXPECT_EQ(none.state, LevelState::not_checked) << level;
    EXPECT_EQ(none.reason, fmt::format("the kernel gives no {} of contact", what));
    const LevelOutcome seldom = outcomes_at(with_numbers(numbers(0, 0, 0, 0, 0, 0, 500)), level)[0];
    EXPECT_EQ(seldom.state, LevelState::not_checked) << level;
    EXPECT_THAT(seldom.reason, HasSubstr("beside 507 of 907 contacts, and has to beside half of them"));
    EXPECT_EQ(outcomes_at(stored_record(), level)[0].reason, none.reason) << level;
  }
}

// At the distance 0 a normal has a length, and no exact one to be compared with.
TEST(ContactLevels, ALengthIsJudgedWhereTheAngleIsNot) {
  Json found = numbers(0, 0, 0, 0, 0, 0);
  found["normal"]["judged"] = 0;
  EXPECT_EQ(outcomes_at(with_numbers(found), "unit=0.1")[0].state, LevelState::met);
  EXPECT_EQ(outcomes_at(with_numbers(found), "normal=1")[0].state, LevelState::not_checked);
  found["normal"]["lengths"] = 0;
  EXPECT_EQ(outcomes_at(with_numbers(found), "unit=0.1")[0].state, LevelState::not_checked);
}

TEST(ContactLevels, ABoundIsANumberInItsRange) {
  for (const char* level : {"early=0", "early=x", "early=0mm", "early=1 furlong", "normal=181", "normal=-1", "unit=2",
                            "point=2", "point=nan", "feature=", "feature=1.5"}) {
    try {
      unmet(with_numbers(numbers(0, 0, 0, 0, 0, 0)), level);
      ADD_FAILURE() << level;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr(level)) << level;
    }
  }
}

TEST(ContactLevels, AContactWithoutATimeFailsLogicAndWhatIncludesIt) {
  Json without = contacts(0, 0, 0);
  without["time"]["none"] = 3;
  for (const char* level : {"logic", "range", "exact", "early=64", "early=1km"}) {
    const auto failures = unmet(motions(without), level);
    const auto is_it = [](const Failure& failure) { return failure.what == "contacts without a time"; };
    const auto found = std::ranges::find_if(failures, is_it);
    ASSERT_NE(found, failures.end()) << level;
    EXPECT_EQ(found->count, 3u);
  }
}

TEST(ContactLevels, EachPlantedFaultIsSeenByItsLevelAlone) {
  using Measures = MeasureColumns;
  const Kernel& right = find_kernel("moving-sphere/rounded");
  constexpr std::size_t time = moving_sphere::time_measure, feature = moving_sphere::feature_measure,
                        normal = moving_sphere::normal_measure, point = moving_sphere::point_measure;
  struct Planted {
    const char *name, *level;
    MeasureEdit change;
  };
  const auto scale_normal = [](Measures& m, std::size_t i, float by) {
    for (std::size_t k = 0; k < 3; ++k) m[normal + k][i] *= by;
  };
  const Planted all[] = {
      {"right", "", [](Measures&, const QueryColumns<float>&, std::size_t) {}},
      {"too-early", "early=4096",
       [](Measures& m, const QueryColumns<float>&, std::size_t i) { m[time][i] = std::max(0.0f, m[time][i] - 1e-3f); }},
      {"too-early-by-10-cm", "early=4096",  // of a way of any length
       [](Measures& m, const QueryColumns<float>& batch, std::size_t i) {
         const auto along = [&](std::size_t k) { return batch.column[12 + k][i] * batch.column[12 + k][i]; };
         m[time][i] = std::max(0.0f, m[time][i] - 0.1f / std::sqrt(along(0) + along(1) + along(2)));
       }},
      {"flipped", "normal=0.03",
       [=](Measures& m, const QueryColumns<float>&, std::size_t i) { scale_normal(m, i, -1); }},
      {"not-normalised", "unit=0.0005",
       [=](Measures& m, const QueryColumns<float>&, std::size_t i) { scale_normal(m, i, 1.001f); }},
      {"tilted", "normal=0.03",
       [](Measures& m, const QueryColumns<float>&, std::size_t i) {
         const float x = m[normal][i], y = m[normal + 1][i], angle = 1e-3f;
         m[normal][i] = x * std::cos(angle) - y * std::sin(angle);
         m[normal + 1][i] = x * std::sin(angle) + y * std::cos(angle);
       }},
      {"on-the-sphere", "point=0.0005",  // the sphere's point, opposite to the triangle's
       [](Measures& m, const QueryColumns<float>& batch, std::size_t i) {
         for (std::size_t k = 0; k < 3; ++k) m[point + k][i] += 2 * batch.column[15][i] * m[normal + k][i];
       }},
      {"face-always", "feature=0.001",
       [](Measures& m, const QueryColumns<float>&, std::size_t i) { m[feature][i] = 6; }},
      {"no-time", "logic", [](Measures& m, const QueryColumns<float>&, std::size_t i) { m[time][i] = std::nanf(""); }},
      {"negative", "logic", [](Measures& m, const QueryColumns<float>&, std::size_t i) { m[time][i] = -0.5f; }},
  };
  std::deque<Kernel> kernels;
  std::vector<const Kernel*> asked;
  for (const Planted& planted : all)
    asked.push_back(&kernels.emplace_back(with_edit(right, planted.name, planted.change)));
  MutationPlan plan;
  plan.families = {&find_family("moving-sphere/one_axis")};
  plan.seed = 3;
  const Record record = record_of_kernels(plan, Precision::binary32, 600, asked);
  const auto refused_at = [&](const char* level) {
    std::vector<std::string> ids;
    for (const Failure& failure : unmet(record, level)) {
      if (!failure.what.starts_with("contacts with")) ids.push_back(failure.kernel);
    }
    return ids;
  };
  EXPECT_THAT(refused_at("early=101mm"), Not(Contains(HasSubstr("10-cm"))));
  EXPECT_THAT(refused_at("early=99mm"), Contains(HasSubstr("10-cm")));
  EXPECT_THAT(refused_at("early=1mm"), Not(Contains(HasSubstr("~right"))));
  for (const char* level : {"early=4096", "feature=0.001", "normal=0.03", "unit=0.0005", "point=0.0005", "logic"}) {
    std::map<std::string, std::string> refused;
    for (const Failure& failure : unmet(record, level)) refused[failure.kernel] = failure.text();
    for (std::size_t k = 0; k < std::size(all); ++k) {
      const bool is_untimed = std::string_view(all[k].level) == "logic",
                 is_early = level == std::string_view("early=4096");
      const bool is_due = all[k].level == std::string_view(level) || (is_untimed && is_early);
      EXPECT_EQ(refused.contains(kernels[k].id), is_due)
          << all[k].name << " at " << level << ": " << refused[kernels[k].id];
    }
  }
}

// The same of bodies as they are: a sphere and a triangle. A level refuses what it is about, and no right choice.
TEST(ContactLevels, EachPlantedFaultOfASphereAndATriangleIsSeenByItsLevels) {
  using Levels = std::vector<std::string_view>;
  constexpr std::string_view by_length = "separation=1e-6", by_angle = "normal=0.03", by_unit = "unit=0.0005",
                             by_flip = "no-flip", by_left = "left=0.001", by_point = "point=0.0005",
                             by_feature = "feature=0.001";
  const std::map<std::string_view, Levels> due = {
      {"right", {}},
      {"other-side-of-a-tie", {}},
      {"nothing-beside-separated", {}},
      {"flipped", {by_angle, by_flip, by_left}},
      {"tilted", {by_angle}},
      {"not-normalised", {by_unit}},
      {"face-always", {by_feature}},
      {"depth-against-the-plane", {by_length}},
      {"on-the-sphere", {by_point}},
      {"margin-of-5-mm", {by_length}},
      {"never-positive", {by_length}},
      {"some-points-missing", {by_point}},
      {"some-normals-missing", {by_angle, by_unit, by_flip, by_left}},
      {"some-features-missing", {by_feature}},
      {"some-without-numbers", {by_length, by_angle, by_unit, by_flip, by_left, by_point, by_feature}},
      {"no-separation", {}}};  // which is NOT CHECKED
  const Kernel& right = find_kernel("minkowski");
  const std::vector<PlantedContact> all = planted_contacts();
  std::deque<Kernel> kernels;
  std::vector<const Kernel*> asked;
  for (const PlantedContact& planted : all)
    asked.push_back(&kernels.emplace_back(with_edit(right, planted.name, planted.change)));
  MutationPlan plan;
  plan.families = {&find_family("lattice")};
  plan.seed = 3;
  const Record record = record_of_kernels(plan, Precision::binary32, 600, asked);
  for (const std::string_view level : {by_length, by_angle, by_unit, by_flip, by_left, by_point, by_feature}) {
    std::map<std::string, std::string> refused;
    for (const Failure& failure : unmet(record, std::string(level))) refused[failure.kernel] = failure.text();
    for (std::size_t k = 0; k < all.size(); ++k) {
      EXPECT_EQ(refused.contains(kernels[k].id), std::ranges::count(due.at(all[k].name), level) == 1)
          << all[k].name << " at " << level << ": " << refused[kernels[k].id];
    }
  }
}

// A normal of length 0 has no side: it leaves the whole depth, and is no evidence against flips.
TEST(ContactLevels, NormalsOfLengthZeroFailLeftAndAreNotCheckedForFlips) {
  const Kernel kernel =
      with_edit(find_kernel("minkowski"), "nowhere", [](MeasureColumns& m, const auto&, std::size_t i) {
        for (std::size_t k = 2; k < 5; ++k) m[k][i] = 0;
      });
  MutationPlan plan;
  plan.families = {&find_family("lattice")};
  plan.seed = 3;
  const Record record = record_of_kernels(plan, Precision::binary32, 600, {&kernel});
  EXPECT_FALSE(unmet(record, "left=0.001").empty());
  EXPECT_EQ(outcomes_at(record, "no-flip")[0].state, LevelState::not_checked);
}

// Beside separations alone, which push nothing, normals say nothing of those that do.
TEST(ContactLevels, NormalsBesideSeparationsAloneAreNotChecked) {
  const Kernel kernel = with_edit(find_kernel("minkowski"), "apart", [](MeasureColumns& m, const auto&, std::size_t i) {
    for (std::size_t k = 2; m[0][i] < 0 && k < 5; ++k) m[k][i] = std::nanf("");
  });
  MutationPlan plan;
  plan.families = {&find_family("general")};
  plan.seed = 3;
  const Record record = record_of_kernels(plan, Precision::binary32, 600, {&kernel});
  for (const char* level : {"normal=1", "unit=0.001", "left=0.001", "no-flip"})
    EXPECT_EQ(outcomes_at(record, level)[0].state, LevelState::not_checked) << level;
}

// Points of two bodies that are seldom given.
TEST(ContactLevels, SeldomPointsOfTwoBodiesAreNotChecked) {
  const Kernel kernel =
      with_edit(find_kernel("box-box/cofactor"), "seldom", [](MeasureColumns& m, const auto&, std::size_t i) {
        for (std::size_t k = 4; i % 8 != 0 && k < 10; ++k) m[k][i] = std::nanf("");
      });
  MutationPlan plan;
  plan.families = {&find_family("box-box/general")};
  plan.seed = 3;
  const Record record = record_of_kernels(plan, Precision::binary32, 600, {&kernel});
  const LevelOutcome outcome = outcomes_at(record, "point=1")[0];
  EXPECT_EQ(outcome.state, LevelState::not_checked);
  EXPECT_THAT(outcome.reason, HasSubstr("it gives no point beside"));
}

}  // namespace
}  // namespace axiscert
