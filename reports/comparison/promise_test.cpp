// Who promises less is worse by that alone, and figures over other promised queries are not compared, whatever they
// are.
#include "fuzz/text/json.h"
#include "reports/comparison/promise.h"
#include "reports/comparison/shown.h"

#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

Promise narrowed() {
  return {TouchingPolicy::either,
          {.least_radius = 1e30},
          MotionPolicy{StartPolicy::ignored, StillPolicy::ignored, SidesPolicy::front},
          true};
}

TEST(Promise, EachPartThatLeavesOutMoreIsNamed) {
  const Promise whole{.motion = MotionPolicy{}};
  EXPECT_THAT(
      change_of(whole, narrowed()).less,
      ElementsAre("touching either, was contact", "radius from 1e+30, was none", "start ignored, was reported",
                  "still ignored, was reported", "sides front, was both", "it may decline, and might not before"));
  EXPECT_THAT(change_of(whole, narrowed()).other, IsEmpty());
  EXPECT_EQ(change_of(narrowed(), whole).other.size(), 6u) << "more is no less";
  EXPECT_THAT(change_of(narrowed(), whole).less, IsEmpty());
  EXPECT_TRUE(change_of(narrowed(), narrowed()).is_none());
}

// A normal beside contacts, and beside answers that say separated.
std::vector<Shown> normals(const GivenBeside& contacts, const GivenBeside& separations) {
  return {{"normal", {{contacts, separations}}}};
}
std::vector<std::string> hidden_texts(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                      bool are_same_queries = true) {
  std::vector<std::string> texts;
  for (const Hidden& hidden : hidden_since(before, now, are_same_queries)) texts.push_back(hidden.text);
  return texts;
}

TEST(Shown, WhatIsShownNoMoreIsNamed) {
  const std::vector<Shown> none, both{{"comparisons"}, {"normal", {{GivenBeside{9, 9, 1}, GivenBeside{}}}}};
  EXPECT_THAT(hidden_texts(both, none), ElementsAre("no comparisons any more", "no normal any more"));
  EXPECT_THAT(hidden_texts(none, both), IsEmpty());
}

TEST(Shown, ANumberHasToStandBesideTheSameAnswers) {
  const auto then = normals({600, 430, 1}, {400, 0});
  EXPECT_THAT(hidden_texts(then, then), IsEmpty());
  EXPECT_THAT(hidden_texts(then, normals({600, 215, 2}, {400, 0})),
              ElementsAre("normal beside 215 of 600 contacts, 430 before"));
  EXPECT_THAT(
      hidden_texts(then, normals({600, 431, 2}, {400, 400, 4})),
      ElementsAre("normal beside 431 of 600 contacts, 430 before, and it cannot be told whether these are among "
                  "them"));
  EXPECT_THAT(hidden_texts(normals({600, 600, 1}, {400, 300, 2}), normals({600, 600, 1}, {400, 0})),
              ElementsAre("normal beside 0 of 400 answers `separated`, 300 before"));
  EXPECT_THAT(hidden_texts(normals({600, 600, 5}, {400, 400, 2}), normals({500, 500, 4}, {500, 500, 3})), IsEmpty())
      << "the same answers, with other verdicts";
}

TEST(Shown, ItIsNoFaultThatVerdictsTakeTheirNumbersAlong) {
  const auto hidden = hidden_since(normals({600, 430, 1}, {400, 0}), normals({300, 300, 2}, {700, 0}));
  ASSERT_EQ(hidden.size(), 1u);
  EXPECT_EQ(hidden[0].text, "normal beside 300 of 300 contacts, 430 before");
  EXPECT_EQ(hidden[0].kind, Hiding::verdicts);
}

TEST(Shown, OverOtherQueriesNotEvenHalfOfWhatWereAllIsLess) {
  const auto then = normals({600, 600, 1}, {40, 40, 2});
  EXPECT_THAT(hidden_texts(then, normals({500, 250, 4}, {50, 0}), false), IsEmpty()) << "40 are too few";
  EXPECT_THAT(hidden_texts(then, normals({500, 249, 4}, {50, 50, 8}), false),
              ElementsAre("normal beside 249 of 500 contacts, all before"));
  EXPECT_THAT(hidden_texts(normals({600, 599, 1}, {}), normals({600, 0}, {}), false), IsEmpty());
}

TEST(Shown, ComesBackFromItsWords) {
  const std::vector<Shown> shown{{"comparisons"}, {"normal", {{GivenBeside{0, 9, 0x1f}, GivenBeside{}}}}};
  const std::vector<std::string> words = words_of_shown(shown);
  EXPECT_THAT(words, ElementsAre("shows=comparisons", "normal=9@1f,0"));
  std::vector<Shown> read;
  for (const std::string& word : words) EXPECT_TRUE(add_shown_word(word, nullptr, read));
  EXPECT_EQ(words_of_shown(read), words);
  EXPECT_FALSE(add_shown_word("radius>=1", nullptr, read));
}

TEST(Promise, EachBoundIsNarrowerInItsOwnDirection) {
  const auto less = [](Limits before, Limits now) {
    return !change_of({.limits = before}, {.limits = now}).less.empty();
  };
  EXPECT_TRUE(less({.greatest_radius = 1e6}, {.greatest_radius = 1e5}));
  EXPECT_FALSE(less({.greatest_radius = 1e5}, {.greatest_radius = 1e6}));
  EXPECT_TRUE(less({}, {.margin = 0.001}));
  EXPECT_TRUE(less({.margin = 0.001}, {.margin = 0.01}));
  EXPECT_FALSE(less({.margin = 0.01}, {.margin = 0.001}));
  EXPECT_TRUE(less({}, {.sides = SidesPolicy::front}));
  EXPECT_FALSE(less({.sides = SidesPolicy::front}, {}));
  EXPECT_TRUE(less({.least_area = 1}, {.least_area = 2}));
  EXPECT_FALSE(less({.least_area = 2}, {.least_area = 1}));
  EXPECT_TRUE(less({}, {.least_coordinate = 1e-9}));
  EXPECT_TRUE(less({}, {.greatest_coordinate = 1e9}));
  EXPECT_FALSE(less({.greatest_coordinate = 1e9}, {}));
}

TEST(Promise, ComesBackFromItsWords) {
  const std::vector<std::string> words = words_of_promise(narrowed());
  EXPECT_THAT(words, ElementsAre("touching=either", "radius>=1e+30", "start=ignored", "still=ignored", "sides=front",
                                 "may_decline"));
  EXPECT_EQ(promise_of_words(words), narrowed());
  const Promise limits{.limits = {0.1, 3, 1e-300, 0.25, 5}};
  EXPECT_EQ(promise_of_words(words_of_promise(limits)), limits);
}

TEST(Promise, AWordThatIsNoPartOfItIsRefused) {
  const auto refused = [](std::vector<std::string> words, const char* says) {
    EXPECT_THAT([&] { promise_of_words(words); }, testing::ThrowsMessage<Error>(HasSubstr(says)));
  };
  refused({}, "without touching=");
  refused({"touching=maybe"}, "'touching=maybe' is none of: contact, separated, either");
  refused({"touching=contact", "touching=either"}, "a second word for the same part");
  refused({"touching=contact", "radius>=0"}, "without a number > 0");
  refused({"touching=contact", "radius>1"}, "no part of a promise");
  refused({"touching=contact", "area<=1"}, "no part of a promise");
  refused({"touching=contact", "start=reported"}, "has start=, still= and sides=");
  refused({"touching=contact", "declines"}, "no part of a promise");
}

std::string markdown_of_promises(const Json& before, const Json& after) {
  return markdown_of(before, after, compare_records(before, after, {}));
}

// A kernel that limits itself to what it is right about was "better: 14 fixed".
TEST(ComparePromises, ALimitIsWorseAndItsFiguresAreNotCompared) {
  const Json before = stored_record(), after = without_errors(with_least_radius(1e30, 450));
  const RunComparison found = compare_records(before, after, {});
  EXPECT_FALSE(found.passes());
  EXPECT_EQ(found.count(Change::fixed), 0u);
  EXPECT_EQ(found.count(Change::better), 0u);
  EXPECT_EQ(answer(found),
            "worse: published binary32 promises less: radius from 1e+30, was none; NOT COMPARED: published binary32: "
            "counts over other promised queries: 4,495 of OLD, 3,145 of NEW");
  EXPECT_THAT(markdown_of_promises(before, after),
              HasSubstr("| published | binary32 | less | radius from 1e+30, was none |"));
  // A promise of less is no fault that could be allowed.
  EXPECT_FALSE(compare_records(before, after, {}, {"published"}).passes());
}

TEST(ComparePromises, ALimitThatGoesIsNotComparedAndCanBeAllowed) {
  const Json before = with_least_radius(1e30, 450), after = stored_record();
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(found.alarms(), 0u);
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(answer(found),
              StartsWith("NOT COMPARED: published binary32: counts over other promised queries: 3,145 of "
                         "OLD, 4,495 of NEW (radius none, was from 1e+30); the rest: no change"));
  for (const char* name : {"published", "published binary32"}) {
    const RunComparison allowed = compare_records(before, after, {}, {name});
    EXPECT_TRUE(allowed.passes()) << name;
    EXPECT_THAT(answer(allowed), StartsWith("no change; NOT COMPARED, as allowed: published binary32: counts")) << name;
  }
}

TEST(ComparePromises, EveryOtherPartCountsToo) {
  const auto with = [](const char* member, const Json& value) {
    Json record = stored_record();
    record["kernels"][0][member] = value;
    return record;
  };
  const Json before = stored_record();
  EXPECT_THAT(
      answer(compare_records(before, with("may_decline", true), {})),
      StartsWith("worse: published binary32 promises less: it may decline, and might not before; NOT COMPARED"));
  EXPECT_THAT(answer(compare_records(before, with("touching", "either"), {})),
              StartsWith("worse: published binary32 promises less: touching either, was contact; NOT COMPARED"));
  const RunComparison other = compare_records(before, with("touching", "separated"), {});
  EXPECT_EQ(other.alarms(), 0u) << "other, not less";
  EXPECT_FALSE(other.passes());
  EXPECT_THAT(answer(other), HasSubstr("(touching separated, was contact)"));
}

// Motion policies declared anew were "61 fixed".
TEST(ComparePromises, APolicyThatLeavesOutMoreIsWorse) {
  const auto with = [](const char* start, std::uint64_t late) {
    Json record = motions(contacts(late, 0.25, 0));
    record["kernels"][0]["motion"] = {{"start", start}, {"still", "reported"}, {"sides", "both"}};
    return record;
  };
  const RunComparison found = compare_records(with("reported", 9), with("approaching", 0), {});
  EXPECT_EQ(found.count(Change::fixed) + found.count(Change::better), 0u);
  EXPECT_THAT(answer(found),
              StartsWith("worse: <script> binary32 promises less: start approaching, was reported; NOT COMPARED: "));
  EXPECT_EQ(compare_records(with("approaching", 9), with("reported", 0), {}).alarms(), 0u);
  EXPECT_FALSE(compare_records(with("approaching", 9), with("reported", 0), {}).passes());
}

TEST(ComparePromises, APrecisionThatIsGoneIsLessWhereNewWasRunInIt) {
  Json before = stored_record();
  before["plan"]["precisions"] = {"binary32", "binary64"};
  Json wide = before["kernels"][0];
  wide["precision"] = "binary64";
  before["kernels"].push_back(wide);
  Json gone = before;
  gone["kernels"].erase(2);
  const RunComparison less = compare_records(before, gone, {});
  EXPECT_THAT(answer(less),
              StartsWith("worse: published binary64 promises less: it does not exist in binary64 any more; "
                         "NOT COMPARED: published binary64: is only in OLD"));
  gone["plan"]["precisions"] = {"binary32"};
  const RunComparison not_run = compare_records(before, gone, {});
  EXPECT_EQ(not_run.alarms(), 0u);
  EXPECT_FALSE(not_run.passes());
  EXPECT_THAT(answer(not_run), HasSubstr("published binary64: is only in OLD: NEW was not run in binary64"));
}

// The same promise and the same queries, and yet another number of them.
TEST(ComparePromises, OtherPopulationsOfOnePromiseAreNotCompared) {
  const Json before = with_least_radius(1, 100), after = without_errors(with_least_radius(1, 101));
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(found.count(Change::fixed), 0u);
  EXPECT_FALSE(found.passes());
  std::vector<std::string> whats;
  for (const NotCompared& absent : found.not_compared) whats.push_back(absent.what + ": " + absent.why);
  EXPECT_THAT(whats,
              Contains("published binary32 on lattice: counts over other promised queries: 400 of OLD, 399 of NEW"));
}

TEST(ComparePromises, FindingsAreComparedWhateverIsPromised) {
  Json after = with_least_radius(1e30, 450);
  after["findings"].push_back(crash_on("tangent"));
  EXPECT_EQ(compare_records(stored_record(), after, {}).count(Change::fresh), 1u);
}

// One answer that breaks the promise is a fault, whatever chance explains.
TEST(ComparePromises, OneUndeclaredDeclineIsNewOnAnyQueries) {
  const Json before = stored_record();
  for (const char* member : {"undecided", "invalid", "unanswered"}) {
    Json after = before;
    after["plan"]["seed"] = 2;
    tangent_counts(after)["verdict"][member] = 1;
    EXPECT_THAT(answer(compare_records(before, after, {})), StartsWith("worse: 1 new")) << member;
    after["plan"]["seed"] = before["plan"]["seed"];
    EXPECT_THAT(answer(compare_records(before, after, {})), StartsWith("worse: 1 new")) << member;
  }
  Json declared = before;
  declared["kernels"][0]["may_decline"] = true;
  Json after = declared;
  after["plan"]["seed"] = 2;
  tangent_counts(after)["verdict"]["undecided"] = 1;
  EXPECT_EQ(answer(compare_records(declared, after, {})), "no change") << "explained by chance";
}

TEST(ComparePromises, JsonHasThem) {
  const Json before = stored_record(), after = with_least_radius(1e30, 450);
  const Json json = data_of(before, after, compare_records(before, after, {}));
  EXPECT_EQ(json["promises"], Json::parse(R"([{"kernel": "published", "precision": "binary32",
                                               "less": ["radius from 1e+30, was none"], "other": []}])"));
  EXPECT_EQ(json["passes"], false);
  EXPECT_EQ(json["not_compared"][0]["state"], "fails");
}

}  // namespace
}  // namespace axiscert
