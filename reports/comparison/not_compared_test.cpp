// A part that two runs did not compare is said first and is no pass, unless it is allowed by name.
#include "fuzz/text/json.h"
#include "reports/comparison/not_compared.h"

#include <fmt/format.h>

#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/testing/edited_record.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;
using testing::ThrowsMessage;

// The record without some of its families: neither asked nor judged on them.
Json without(Json record, const std::vector<std::string>& families) {
  for (const std::string& family : families) {
    Json& planned = record["plan"]["families"];
    planned.erase(std::find(planned.begin(), planned.end(), family));
    record["plan"]["trials"].erase(family);
    record["plan"]["generators"].erase(family);
    for (Json& kernel : record["kernels"]) kernel["families"].erase(family);
  }
  return record;
}

TEST(NotCompared, FamiliesThatWereLostAreNoPass) {
  const Json before = stored_record(), after = without(before, {"tangent", "lattice"});
  const RunComparison found = compare_records(before, after, {});
  EXPECT_FALSE(found.passes());
  EXPECT_EQ(
      answer(found),
      "NOT COMPARED: 2 of 3 families (tangent, ...): is only in OLD; <script> binary32: has no family with promised "
      "queries in both runs; the rest: no change");
  const RunComparison gained = compare_records(after, before, {});
  EXPECT_TRUE(gained.has(Absence::only_new));
  EXPECT_THAT(answer(compare_records(without(before, {"lattice"}), before, {})), "no change; only in NEW: lattice");
  EXPECT_TRUE(compare_records(without(before, {"lattice"}), before, {}).passes());
}

TEST(NotCompared, IsAllowedByFamilyKernelOrItsText) {
  const Json before = stored_record(), after = without(before, {"lattice"});
  EXPECT_FALSE(compare_records(before, after, {}).passes());
  const RunComparison allowed = compare_records(before, after, {}, {"lattice"});
  EXPECT_TRUE(allowed.passes());
  EXPECT_EQ(answer(allowed), "no change; NOT COMPARED, as allowed: lattice: is only in OLD");
  Json lost = before;
  lost["kernels"][0]["families"].erase("lattice");
  for (const char* name : {"published", "lattice", "published binary32 on lattice"})
    EXPECT_TRUE(compare_records(before, lost, {}, {name}).passes()) << name;
}

TEST(NotCompared, ANameThatNamesNothingIsRefusedWithWhatThereIs) {
  const Json before = stored_record(), after = without(before, {"lattice"});
  const auto refused = [&](const Json& now, const char* name, const auto& says) {
    EXPECT_THAT([&] { compare_records(before, now, {}, {name}); }, ThrowsMessage<Error>(says)) << name;
  };
  refused(after, "tangent", StartsWith("--allow-not-compared 'tangent': not compared is: lattice"));
  refused(after, "nosuch", HasSubstr("lattice"));
  refused(before, "lattice", HasSubstr("everything was compared"));
}

TEST(NotCompared, LinesThatNeitherRunWasToAskAreSaid) {
  Json record = stored_record();
  record["plan"]["files"].push_back({{"name", "seven.jsonl"},
                                     {"kind", "queries"},
                                     {"sha256", nullptr},
                                     {"queries", 7},
                                     {"left_out", {{"binary64", 6}}}});
  const RunComparison found = compare_records(record, record);
  EXPECT_TRUE(found.passes());
  EXPECT_THAT(markdown_of(record, record, found),
              HasSubstr("| queries/seven.jsonl in binary64 | neither run was to ask its 6 queries | no fault |"));
  EXPECT_FALSE(compare_records(stored_record(), record).has(Absence::empty)) << "OLD may have asked them";
  Json another = record;
  another["plan"]["files"].back()["sha256"] = std::string(64, '7');
  EXPECT_FALSE(compare_records(record, another).has(Absence::empty)) << "the lines of another file";
}

TEST(NotCompared, AFileThatIsCalledCorpusIsNotTheCorpus) {
  Json record = stored_record();
  for (const char* kind : {"queries", "corpus"})
    record["plan"]["files"].push_back(
        {{"name", "corpus"}, {"kind", kind}, {"sha256", nullptr}, {"queries", 7}, {"left_out", {{"binary64", 6}}}});
  const std::string text = markdown_of(record, record, compare_records(record, record));
  EXPECT_THAT(text, HasSubstr("| queries/corpus in binary64 | neither run"));
  EXPECT_THAT(text, HasSubstr("| corpus in binary64 | neither run"));
}

TEST(NotCompared, AnInterruptedRunIsNoPassWhicheverItIs) {
  Json cut = stored_record();
  cut["complete"] = false;
  cut["plan"]["units_done"] = Json::object();
  for (const auto& [before, after, which] : {std::tuple(stored_record(), cut, "NEW"), {cut, stored_record(), "OLD"}}) {
    const RunComparison found = compare_records(before, after, {});
    EXPECT_FALSE(found.passes()) << which;
    EXPECT_EQ(answer(found), fmt::format("NOT COMPARED: {}: is INTERRUPTED: what it lacks cannot be told from what is "
                                         "right; the rest: no change",
                                         which));
    EXPECT_TRUE(compare_records(before, after, {}, {which}).passes());
  }
}

// A finding that an interrupted run, or one without the family, does not have is not mended.
TEST(NotCompared, AFindingOnWhatWasNotAskedIsNotFixed) {
  Json before = stored_record();
  before["findings"].push_back(crash_on("lattice"));
  Json asked = stored_record(), cut = stored_record();
  cut["complete"] = false;
  EXPECT_EQ(compare_records(before, asked, {}).count(Change::fixed), 1u);
  EXPECT_EQ(compare_records(before, cut, {}).count(Change::fixed), 0u);
  EXPECT_EQ(compare_records(before, without(asked, {"lattice"}), {}).count(Change::fixed), 0u);
}

TEST(NotCompared, NothingComparedIsNeverAllowed) {
  Json before = stored_record(), after = before;
  for (Json* record : {&before, &after}) {
    (*record)["kernels"].erase(1);
    (*record)["plan"]["kernels"].erase(1);
  }
  after["kernels"][0]["id"] = "other";
  after["plan"]["kernels"] = {"other"};
  const RunComparison found = compare_records(before, after, {}, {"published"});
  EXPECT_FALSE(found.has(Absence::fails));
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(answer(found), StartsWith("NOT COMPARED: nothing was compared"));
}

TEST(NotCompared, ErrorsThatAreNotMeasuredAnyMoreAreLost) {
  Json before = stored_record(), after = before;
  for (Json& comparison : tangent_counts(after)["comparisons"]) comparison["max_error_u"] = nullptr;
  const RunComparison found = compare_records(before, after, {}), gained = compare_records(after, before, {});
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(answer(found), HasSubstr("published binary32 on tangent: errors in u: is only in OLD"));
  EXPECT_TRUE(gained.passes());
}

// Ten queries are never significantly worse than a thousand.
TEST(NotCompared, TooFewQueriesOfAFamilyAreNoComparison) {
  Json before = stored_record(), after = before;
  for (Json& kernel : after["kernels"]) {
    Json& lattice = kernel["families"]["lattice"];
    lattice["trials"] = 58;
    lattice["truth"] = {{"separated", 20}, {"contact", 38}, {"touching", 9}, {"invalid", 0}};
  }
  after["plan"]["trials"]["lattice"]["binary32"] = 58;
  const RunComparison found = compare_records(before, after, {});
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(answer(found),
              HasSubstr("published binary32 on lattice, ...): 58 promised queries in NEW, 500 in OLD: too few"));
  EXPECT_TRUE(compare_records(after, before, {}).passes()) << "more are more";
}

TEST(NotCompared, ManyReasonsAreCounted) {
  std::vector<NotCompared> all;
  for (const char* what : {"a", "b", "c", "d", "e"}) all.push_back({what, std::string("why ") + what});
  EXPECT_EQ(absences_text(all, Absence::fails, 9), "a: why a; b: why b; c: why c; 2 more");
  EXPECT_EQ(absences_text(all, Absence::allowed, 9), "");
}

}  // namespace
}  // namespace axiscert
