// Planted kernels of the moving sphere, which know the truth and tell another time: each is counted as what it is, in
// the tally, in the record and by the witnesses.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "exact/moving_sphere/first_contact.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/merge.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert {
namespace {

using moving_sphere::FirstContact;

constexpr std::uint64_t motion_queries = 100;

// A time and a feature told beside a contact, made of the right ones.
struct ToldContact {
  double time, feature;
};
template <class Real>
using Tell = ToldContact (*)(Real best, std::size_t feature);

template <class Real>
Implementation<Real> knowing(Tell<Real> tell, bool misses) {
  const auto contact_of = [](const QueryColumns<Real>& batch, std::size_t i) {
    const auto load = [&](std::size_t k) { return static_cast<double>(batch.column[k][i]); };
    return moving_sphere::first_contact(MovingSphere::problem<double>(load));
  };
  Implementation<Real> kernel;
  kernel.verdicts = [=](const QueryColumns<Real>& batch, Verdict* out) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      out[i] = contact_of(batch, i) && !misses ? Verdict::contact : Verdict::separated;
    }
  };
  kernel.measure = [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
    for (std::size_t i = 0; i < batch.size; ++i) {
      const std::optional<FirstContact> contact = contact_of(batch, i);
      if (!contact) continue;
      const ToldContact told =
          tell(moving_sphere::rounded_down<Real>(contact->time), index_of(*contact->features.begin()));
      out.measures[0][i] = static_cast<Real>(told.time);
      out.measures[1][i] = static_cast<Real>(told.feature);
    }
  };
  return kernel;
}

template <ToldContact (*tell32)(float, std::size_t), ToldContact (*tell64)(double, std::size_t)>
Kernel planted_motion(bool misses = false) {
  Kernel kernel;
  kernel.id = "planted";
  kernel.predicate = &moving_sphere_predicate();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  kernel.measure_count = 2;
  kernel.binary32 = [=](std::string_view) { return knowing<float>(tell32, misses); };
  kernel.binary64 = [=](std::string_view) { return knowing<double>(tell64, misses); };
  return kernel;
}
#define PLANTED(name) planted_motion<name<float>, name<double>>()

template <class Real>
ToldContact right_told(Real best, std::size_t feature) {
  return {static_cast<double>(best), static_cast<double>(feature)};
}
template <class Real>
ToldContact late_by_one(Real best, std::size_t feature) {
  return {static_cast<double>(std::nextafter(best, Real(2))), static_cast<double>(feature)};
}
template <class Real>
ToldContact early_by_one(Real best, std::size_t feature) {
  return {static_cast<double>(best == 0 ? best : std::nextafter(best, Real(-1))), static_cast<double>(feature)};
}
template <class Real>
ToldContact of_the_end(Real, std::size_t feature) {
  return {1, static_cast<double>(feature)};
}
template <class Real>
ToldContact negative(Real best, std::size_t feature) {
  return {static_cast<double>(-best) - 1, static_cast<double>(feature)};
}
template <class Real>
ToldContact beyond(Real best, std::size_t feature) {
  return {static_cast<double>(best) + 1.5, static_cast<double>(feature)};
}
template <class Real>
ToldContact not_told(Real, std::size_t feature) {
  return {std::numeric_limits<double>::quiet_NaN(), static_cast<double>(feature)};
}
template <class Real>
ToldContact other_feature(Real best, std::size_t) {
  return {static_cast<double>(best), 7};
}

Plan plan_of_motions(const Kernel& kernel) {
  Plan plan;
  plan.answerers.kernels = {&kernel};
  for (const char* name : {"moving-sphere/general", "moving-sphere/graze", "moving-sphere/point"}) {
    plan.questions.sources.push_back(family_source(find_family(name)));
  }
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.questions.trials = [](const Source&, Precision) { return motion_queries; };
  plan.running.target = resolve_target("auto");
  plan.running.threads = 1;
  return plan;
}

CampaignResult run_motions(const Plan& plan) {
  static const std::atomic<bool> never = false;
  return run_campaign(plan, never, [](const Progress&) {});
}

// The kernel's tallies added up.
ContactTally tallied(const Kernel& kernel) {
  ContactTally sum;
  for (const CellResult& cell : run_motions(plan_of_motions(kernel)).cells) merge_fields(sum, cell.tallies[0].contacts);
  EXPECT_GT(sum.answers + sum.missed->through, motion_queries / 2) << "of " << 6 * motion_queries;
  return sum;
}

TEST(Motion, TheBestTimesAreTheBest) {
  const ContactTally found = tallied(PLANTED(right_told));
  EXPECT_EQ(found.time->best, found.answers);
  EXPECT_EQ(found.feature->judged, found.answers);
  EXPECT_EQ(found.feature->wrong, 0u);
  EXPECT_EQ(found.time->late_tunnels.through + found.missed->through, 0u);
}

TEST(Motion, OneUlpTooLateIsLate) {
  const ContactTally found = tallied(PLANTED(late_by_one));
  // Past the end of the motion it is no time.
  EXPECT_EQ(found.time->late + found.time->invalid, found.answers);
  EXPECT_LT(found.time->invalid, found.answers / 2);
  EXPECT_EQ(found.time->late_errors.by_power[0], found.time->late) << "by at most one ulp";
  EXPECT_GT(found.time->late_errors.largest_ulps.best().value(), 0.9);
  EXPECT_LE(found.time->late_errors.largest_ulps.best().value(), 1);
  EXPECT_LE(found.time->late_errors.largest_share.best(), 0x1p-24) << "an ulp below 1, of the way";
  EXPECT_GT(found.time->late_tunnels.through, 0u) << "of points";
}

TEST(Motion, OneUlpTooEarlyIsEarly) {
  const ContactTally found = tallied(PLANTED(early_by_one));
  EXPECT_EQ(found.time->early + found.time->best, found.answers);
  EXPECT_GT(found.time->early, found.answers / 2);
  EXPECT_LE(found.time->early_errors.largest_ulps.best().value(), 2);
  EXPECT_GE(found.time->largest_gap.best(), 0);
}

TEST(Motion, TheEndOfTheMotionTunnels) {
  const ContactTally found = tallied(PLANTED(of_the_end));
  EXPECT_EQ(found.time->late + found.time->best, found.answers);
  EXPECT_GT(found.time->late_tunnels.deepest.best().value(), 0.1);
  EXPECT_GT(found.time->late_errors.largest_share.best(), 0.1);
  EXPECT_GT(found.time->late_errors.largest_length.best(), 0);
  EXPECT_EQ(found.time->early_errors.largest_share.best(), 0);
}

TEST(Motion, WhatIsNoTimeIsCountedApart) {
  for (const Kernel& kernel : {PLANTED(negative), PLANTED(beyond)}) {
    const ContactTally found = tallied(kernel);
    EXPECT_EQ(found.time->invalid, found.answers);
    EXPECT_EQ(found.feature->judged, found.answers) << "nothing is lost";
  }
  const ContactTally without = tallied(PLANTED(not_told));
  EXPECT_EQ(without.time->none, without.answers);
}

TEST(Motion, AnotherFeatureIsWrong) {
  const ContactTally found = tallied(PLANTED(other_feature));
  EXPECT_EQ(found.feature->wrong, found.answers);
  EXPECT_EQ(found.time->best, found.answers);
}

TEST(Motion, AMissTunnels) {
  const ContactTally found = tallied(planted_motion<right_told<float>, right_told<double>>(true));
  EXPECT_EQ(found.answers, 0u);
  EXPECT_GT(found.missed->through, motion_queries / 2) << "each contact of a point";
}

// A kernel that never reports a contact is wrong on every one of its promise, and on no other.
TEST(Motion, WhatIsBeyondAPolicyIsCountedApart) {
  Kernel kernel = planted_motion<right_told<float>, right_told<double>>(true);
  const auto outside = [&](MotionPolicy policy, const char* family) {
    kernel.motion = policy;
    Plan plan = plan_of_motions(kernel);
    plan.questions.sources = {family_source(find_family(family))};
    const CampaignResult result = run_motions(plan);
    const Tally& tally = result.cells[0].tallies[0];
    EXPECT_EQ(tally.verdict.false_separation + tally.verdict.outside_limits->false_separation, tally.truth.contact);
    const Json record = json_of(record_of(plan, result, {}));
    EXPECT_EQ(record["kernels"][0]["families"][family]["verdict"]["outside_limits"].is_null(),
              policy == MotionPolicy{});
    return tally.verdict.outside_limits->trials;
  };
  EXPECT_EQ(outside({}, "moving-sphere/zero_d"), 0u);
  EXPECT_EQ(outside({.still = StillPolicy::ignored}, "moving-sphere/zero_d"), motion_queries);
  EXPECT_EQ(outside({.still = StillPolicy::ignored}, "moving-sphere/general"), 0u);
  const std::uint64_t behind = outside({.sides = SidesPolicy::front}, "moving-sphere/general");
  EXPECT_TRUE(behind > motion_queries / 4 && behind < 3 * motion_queries / 4) << behind;
  const std::uint64_t begun = outside({.start = StartPolicy::ignored}, "moving-sphere/overlap_ulp");
  const std::uint64_t leaving = outside({.start = StartPolicy::approaching}, "moving-sphere/overlap_ulp");
  EXPECT_TRUE(0 < leaving && leaving < begun && begun < motion_queries) << leaving << " of " << begun;
}

TEST(Motion, TheRecordHasTheWorstAndItsWitness) {
  const Kernel kernel = PLANTED(late_by_one);
  const Plan plan = plan_of_motions(kernel);
  const Json record = json_of(record_of(plan, run_motions(plan), {}));
  const Json& entry = record["kernels"][0];
  EXPECT_EQ(entry["measures"], Json({"time", "feature"}));
  const Json& motion = entry["families"]["moving-sphere/general"]["contacts"];
  EXPECT_EQ(motion["time"]["late"], motion["time"]["late_errors"]["by_power"]["0"]);
  EXPECT_TRUE(motion["normal"].is_null());
  bool is_shown = false, is_length_shown = false;
  const auto motion_of = [&](const Json& witness) {
    return entry["families"][witness["family"].get<std::string>()]["contacts"]["time"];
  };
  for (const Json& witness : record["witnesses"]) {
    const Json& measures = witness["measures"];
    ASSERT_TRUE(measures["given"].contains("time")) << witness.dump();
    const Json& exact = witness["exact_contact"];
    const bool has_contact = witness["truth"].get<std::string>() == "contact";
    EXPECT_EQ(exact["time"].is_null(), !has_contact) << witness.dump();
    EXPECT_EQ(exact.contains("point_from_a"), has_contact) << witness.dump();
    for (const Json& reason : witness["shows"]) {
      if (!reason.get<std::string>().starts_with("latest time")) continue;
      is_shown = true;
      EXPECT_EQ(measures["time"], "late");
      EXPECT_FALSE(measures["ulps"].is_null());
      EXPECT_FALSE(measures["share"].is_null());
      if (reason.get<std::string>().ends_with(" in length")) {
        is_length_shown |= measures["length"] == motion_of(witness)["late_errors"]["largest_length"];
      }
      EXPECT_FALSE(measures["tunnel"].is_null());
    }
  }
  EXPECT_TRUE(is_shown && is_length_shown);
}

}  // namespace
}  // namespace axiscert
