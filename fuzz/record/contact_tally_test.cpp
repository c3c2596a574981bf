// The errors of times: the greatest of each measure with its query, in a journal, merged, and in words.
#include "fuzz/record/contact_tally.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/campaign/stretch.h"
#include "fuzz/text/json_form.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {
namespace {

ContactJudgement judged(TimeVerdict time, int ulps, double share, double length) {
  ContactJudgement judgement;
  judgement.time = time;
  judgement.ulps = judgement.in_u = round_up(Rational(ulps));
  judgement.share = share;
  judgement.length = length;
  if (time == TimeVerdict::late) judgement.tunnel = Tunnel{};
  return judgement;
}

template <class Rank>
std::uint64_t position_of(const Leaders<Rank>& leaders) {
  return leaders.candidates().at(0).position;
}

TEST(ContactTally, TheGreatestOfEachMeasureHasItsQueryInAnyOrderAndInAJournal) {
  const Predicate& predicate = moving_sphere_predicate();
  Tally first = empty_tally(predicate), second = first;
  count_contact(first.contacts, 3, judged(TimeVerdict::late, 9, 0.25, 0.5));
  count_contact(first.contacts, 4, judged(TimeVerdict::late, 2, 0.125, 8));
  count_contact(first.contacts, 5, judged(TimeVerdict::early, 1, 0.75, 0));
  count_contact(second.contacts, 1, judged(TimeVerdict::late, 1, 0.25, 4));
  Tally forward = decode_tally(encode(first), predicate), backward = decode_tally(encode(second), predicate);
  forward.merge(second);
  backward.merge(first);
  EXPECT_EQ(encode(forward), encode(backward));
  const TimeTally& time = *forward.contacts.time;
  EXPECT_EQ(position_of(time.late_errors.largest_ulps), 3u);
  EXPECT_EQ(time.late_errors.largest_share.best(), 0.25);
  EXPECT_EQ(position_of(time.late_errors.largest_share), 1u) << "of two the earlier";
  EXPECT_EQ(time.late_errors.largest_length.best(), 8);
  EXPECT_EQ(position_of(time.late_errors.largest_length), 4u);
  EXPECT_EQ(position_of(time.early_errors.largest_share), 5u);
  EXPECT_TRUE(time.early_errors.largest_length.candidates().empty()) << "0 is no error";
}

// The error with which a part of a record is refused; empty: it is read.
template <class Part>
std::string refused(const Json& json) {
  try {
    read_as<Part>(json);
  } catch (const JsonFault& fault) {
    return fault.what();
  }
  return {};
}

TEST(ContactTally, WhatWasLookedAtOnNothingIsNullInJson) {
  NormalTally one;
  one.judged = 1;
  Json none = json_of(NormalTally()), some = json_of(one);
  EXPECT_TRUE(none["largest_angle"].is_null());
  EXPECT_EQ(some["largest_angle"], 0.0);
  EXPECT_TRUE(some["largest_length_error"].is_null()) << "of which none was";
  EXPECT_EQ(refused<NormalTally>(none), "");
  EXPECT_EQ(refused<NormalTally>(some), "");
  none["largest_angle"] = 0.5;
  EXPECT_EQ(refused<NormalTally>(none), "/largest_angle: 0.5 is not null, though judged is 0");
  some["largest_angle"] = nullptr;
  EXPECT_EQ(refused<NormalTally>(some), "/largest_angle: null is not of type number");

  EXPECT_TRUE(json_of(TimeTally())["late_errors"].is_null());
  TimeTally in_time;
  in_time.best = 1;
  EXPECT_EQ(json_of(in_time)["late_errors"]["largest_share"], 0.0) << "one was judged, and is not late";
  SeparationTally with_margin;
  with_margin.less_margin.emplace();
  Json less = json_of(with_margin);
  EXPECT_TRUE(less["less_margin"].is_null());
  EXPECT_EQ(refused<SeparationTally>(less), "");
  less["less_margin"] = {{"largest_error", 0.5}, {"largest_length", 0.0}};
  EXPECT_THAT(refused<SeparationTally>(less), testing::EndsWith("is not null, though judged is 0"));
  EXPECT_EQ(json_schema_of<PushTally>()["properties"]["flips"]["anyOf"][0]["type"], "null");
  const Predicate& predicate = moving_sphere_predicate();
  ContactTally tally;
  EXPECT_TRUE(json_of(given_contacts(tally, predicate, 1))["missed"].is_null()) << "no contact was at hand";
  count_contact(tally, 3, judged(TimeVerdict::best, 0, 0, 0));
  const Json found = json_of(given_contacts(tally, predicate, 1));
  EXPECT_EQ(found["missed"]["through"], 0) << "one was, and was found";
  EXPECT_EQ(refused<ContactTally>(found), "");
}

// Nothing was missed of no contact.
TEST(VerdictTally, AKindOfVerdictThatWasNotDecidedIsNullInJson) {
  const Truth contact{Verdict::contact, false}, separated{Verdict::separated, false};
  Tally tally = empty_tally(moving_sphere_predicate());
  const auto count_said = [&](const Truth& truth, Verdict said) {
    const Answer answer{said, std::nullopt};
    count_numbers(tally, truth, 0, answer, judge(moving_sphere_predicate(), truth, std::nullopt, answer), 1);
    return json_of(tally.verdict);
  };
  const auto are_null = [](const Json& json, const char* kind) {
    const std::string name = kind;
    const bool is_null = json[name].is_null();
    EXPECT_EQ(json["deepest_" + name].is_null(), is_null);
    EXPECT_EQ(json["farthest_" + name].is_null(), is_null);
    return is_null;
  };
  Json found = count_said(contact, Verdict::undecided);
  EXPECT_TRUE(are_null(found, "false_separation") && are_null(found, "false_contact") && found["deepest"].is_null());
  EXPECT_EQ(refused<VerdictTally>(found), "");
  EXPECT_TRUE(found["links"].is_null() && found["masked_links"].is_null());
  found["deepest"] = 0.5;
  EXPECT_NE(refused<VerdictTally>(found), "");
  found = count_said(separated, Verdict::separated);
  EXPECT_EQ(found["links"]["unattributed"], 0);
  EXPECT_TRUE(are_null(found, "false_separation")) << "no contact was decided";
  EXPECT_EQ(found["false_contact"], 0);
  EXPECT_EQ(found["deepest"], 0.0);
  EXPECT_EQ(refused<VerdictTally>(found), "");
  found = count_said(contact, Verdict::separated);
  EXPECT_EQ(found["false_separation"], 1);
  EXPECT_EQ(found["decided"], 2);
  EXPECT_TRUE(found["touching_flips"].is_null() && found["touching_links"].is_null());
  const Truth touching{Verdict::contact, true};
  EXPECT_TRUE(count_said(touching, Verdict::undecided)["touching_flips"].is_null()) << "it was declined";
  EXPECT_EQ(count_said(touching, Verdict::contact)["touching_flips"], 0);
  put_unseen(found = json_of(VerdictTally()), VerdictTally());
  EXPECT_EQ(found["false_separation"], 0) << "zeros add up";
  EXPECT_EQ(found["deepest"], 0.0);
}

// Each kind by its own count, and signs by those that were compared.
TEST(VerdictTally, AKernelThatDecidesOneKindHasNoFigureOfTheOther) {
  OutsideTally outside;
  ClearTally clear;
  EngineTally engine;
  outside.trials = clear.queries = engine.queries = 3;
  outside.decided_separations = clear.decided_separations = engine.decided_separations = 1;
  for (const Json& json : {json_of(outside), json_of(clear), json_of(engine)}) {
    EXPECT_TRUE(json["false_separation"].is_null()) << json;
    EXPECT_EQ(json["false_contact"], 0) << json;
  }
  EXPECT_EQ(json_of(clear)["unanswered"], 2);
  ConsistencyTally numbers;
  numbers.judged = numbers.separations = 1;
  EXPECT_TRUE(json_of(numbers)["positive"].is_null());
  EXPECT_EQ(json_of(numbers)["negative"], 0);

  const Predicate& predicate = find_predicate("sphere-triangle");
  Tally tally = empty_tally(predicate);
  const auto signs = [&](Verdict said) {
    const Truth truth{Verdict::contact, false};
    const Answer answer{said, ComparisonBits{0}};
    const Reference reference{{Verdict::contact, ComparisonBits{0}}, std::nullopt, 0};
    count_numbers(tally, truth, 0, answer, judge(predicate, truth, reference, answer), 1);
    ComparisonTally found = tally.comparisons[0];
    found.judged = tally.with_signs;  // as a record has it
    return json_of(found);
  };
  const Json none = signs(Verdict::undecided);
  for (const char* figure : {"false_separation", "missed_separation", "masked", "decisive", "links"})
    EXPECT_TRUE(none[figure].is_null()) << figure;
  EXPECT_EQ(signs(Verdict::contact)["missed_separation"], 0);
}

TEST(ContactTally, AnErrorIsToldInUlpsWhileTheseAreFew) {
  const auto text = [](int ulps, double share, double length) {
    return time_error_text(round_up(Rational(ulps)), share, length);
  };
  EXPECT_EQ(text(3, 0x1p-22, 1e-6), "3 ulps");
  EXPECT_EQ(text(8192, 0x1p-10, 1), "8192 ulps");
  EXPECT_EQ(text(8193, 0.12, 1.4), "12 % of the way, length 1.4");
  EXPECT_EQ(text(1000000, 1, 0), "100 % of the way, length 0");
  EXPECT_EQ(text(1000000, 1e-3, 2e6), "0.1 % of the way, length 2e+06");
  EXPECT_EQ(text(1000000, 1.5e-5, 0.25), "1.5e-05 of the way, length 0.25") << "near the start an ulp is small";
}

}  // namespace
}  // namespace axiscert
