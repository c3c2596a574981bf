// The row of a kernel's first contacts: numbers as a record has them, and dashes for what the kernel does not give.
#include "fuzz/text/json_form.h"
#include "reports/wording/depths.h"
#include "reports/wording/evidence.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace axiscert {
namespace {

using testing::ElementsAre;

TunnelTally tunnels(double deepest) {
  return read_as<TunnelTally>({{"through", deepest == 1 ? 2 : 0}, {"deepest_tunnel", deepest}});
}
TimeErrors time_errors(const Json& ulps, double share, double length) {
  return read_as<TimeErrors>({{"largest_ulps", ulps},
                              {"largest_in_u", 1},
                              {"largest_share", share},
                              {"largest_length", length},
                              {"by_power", Json::object()}});
}

FamilyRecord family_of(std::optional<TimeTally> time, double missed) {
  NormalTally normal;
  normal.judged = 7;
  normal.largest_angle.offer({0.25, 0});
  FamilyRecord family;
  family.contacts = {.answers = 1200,
                     .decided = 1202,
                     .missed = tunnels(missed),
                     .time = std::move(time),
                     .feature = std::nullopt,
                     .normal = normal,
                     .point = std::nullopt};
  return family;
}

TEST(MotionWords, ARowHasACellForEachColumn) {
  TimeTally time;
  time.none = 1;
  time.invalid = 2;
  time.early = 30;
  time.best = 1100;
  time.late = 67;
  time.late_errors = time_errors("1.5e+320", 0.125, 2.5);
  time.late_tunnels = tunnels(0.5);
  time.early_errors = time_errors(3.5, 1e-8, 1e-7);
  const auto cells = contact_cells(family_of(time, 1));
  EXPECT_EQ(cells.size(), contact_columns(true).size());
  EXPECT_THAT(cells, ElementsAre("1,200", "67 (1,197)", "12.5 % of the way, length 2.5 (1,197)", "0.5 (1,197)",
                                 "30 (1,197)", "3.5 ulps (1,197)", "3", "-", "0.25 (7)", "-", "2", "1"));
  time.early = time.best = time.late = 0;
  time.none = 1200;
  EXPECT_THAT(contact_cells(family_of(time, 1)),
              ElementsAre("1,200", "-", "-", "-", "-", "-", "1,202", "-", "0.25 (7)", "-", "2", "1"));
}

TEST(MotionWords, AKernelWithoutTimesHasARowWhereItMisses) {
  EXPECT_TRUE(contact_cells(family_of(std::nullopt, 0)).empty());
  EXPECT_THAT(contact_cells(family_of(std::nullopt, 0.75)),
              ElementsAre("1,200", "-", "-", "-", "-", "-", "-", "-", "0.25 (7)", "-", "0", "0.75"));
  EXPECT_TRUE(contact_cells(FamilyRecord()).empty()) << "a predicate without measures";
}

// 600 contacts and 400 separations, all of them engine-like.
FamilyRecord sides() {
  FamilyRecord family;
  family.trials = family.base_triangles = 1000;
  family.truth = {400, 600, 0, 0};
  family.verdict.engine = EngineTally{{600, 400}, 1000, {}};
  return family;
}

TEST(SideWords, NothingIsSaidOfASideThatGotNoVerdict) {
  KernelRecord kernel;
  FamilyRecord family = sides();
  family.verdict.false_contact = 20;
  EXPECT_EQ(bias_text(kernel, family), "phantom contacts alone");
  EXPECT_EQ(engine_text(family), "0 missed and 0 phantom contacts on 1,000 engine-like queries");
  EXPECT_EQ(with_rate(FlipKind::false_separation, kernel, family), "0 (< 4,980 per million, 95 %)")
      << "600 contacts, not 1,000 queries";
  family.verdict.undecided = family.verdict.undecided_contact = 600;
  EXPECT_EQ(bias_text(kernel, family), "phantom contacts alone, with 0 of 600 contacts decided");
  family.verdict.engine->decided_contacts = 0;
  EXPECT_EQ(engine_text(family),
            "no contact decided and 0 phantom contacts on 1,000 engine-like queries, of which it decided 400");
  EXPECT_EQ(with_rate(FlipKind::false_separation, kernel, family), "not checked");
  EXPECT_EQ(with_rate(FlipKind::false_contact, kernel, family), "20 (20,000 per million)");
  family.verdict.undecided = 1000;
  family.verdict.engine->decided_separations = 0;
  EXPECT_EQ(engine_text(family), "none of 1,000 engine-like queries decided");
}

TEST(BodyWords, WhatWasJudgedOnNoAnswerHasNoFigure) {
  FamilyRecord family;
  ContactTally& bodies = family.contacts.emplace();
  bodies.missed.reset();
  bodies.answers = 900;
  EXPECT_EQ(contact_cells(family).size(), contact_columns(false).size());
  EXPECT_THAT(contact_cells(family), ElementsAre("900", "-", "-", "-", "-", "-", "-", "-", "-", "-", "-"));
  bodies.normal->lengths = 3;
  bodies.separation->judged = 900;
  EXPECT_THAT(contact_cells(family), ElementsAre("900", "0", "0", "0", "-", "-", "-", "-", "0 (3)", "-", "-"));
}

}  // namespace
}  // namespace axiscert
