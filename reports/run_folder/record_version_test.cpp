// Records of version 1 are read as those of version 2; the names in a record are those of its test.
#include "reports/run_folder/record_version.h"

#include <functional>

#include "reports/comparison/compare.h"
#include "reports/comparison/show.h"
#include "reports/gates/ratchet_text.h"
#include "reports/testing/test_run.h"
#include "reports/run_folder/record_names.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

const std::string testdata = SOURCE_FOLDER "/reports/testdata/";

Json first_version() { return Json::parse(text_of(testdata + "record_1.json")); }

Json read(const Json& record) { return read_run(TestFolder(record).path()).record; }

// The message with which a record is refused: one line that names the file.
std::string refusal(const Json& record) {
  const std::string error = TestFolder(record).rendering_error();
  EXPECT_THAT(error, HasSubstr("record.json: "));
  EXPECT_EQ(error.find('\n'), error.npos) << error;
  return error;
}

std::string refusal(const std::function<void(Json&)>& edit) {
  Json record = stored_record();
  edit(record);
  return refusal(record);
}

// The stored record with what a record of the first version can have: it counts no classes of the input.
Json without_classes() {
  Json record = stored_record();
  for (Json& kernel : record["kernels"]) {
    kernel.erase("nearest");
    for (Json& family : kernel["families"]) family.erase("classes");
  }
  for (Json& witness : record["witnesses"]) witness.erase("class");
  return record;
}

TEST(RecordVersion, TheFirstIsReadAsThePresentOne) {
  const Json old = first_version();
  EXPECT_EQ(old["schema"], "axiscert-record/1");
  EXPECT_FALSE(old["plan"].contains("test"));
  EXPECT_EQ(read(old), without_classes()) << "the same bytes, in the same order";
  EXPECT_EQ(read(stored_record()), stored_record());
}

TEST(RecordVersion, ReportsOfBothAreTheSame) {
  const TestFolder old(first_version()), present(without_classes());
  ASSERT_EQ(old.rendering_error(), "");
  ASSERT_EQ(present.rendering_error(), "");
  for (const char* file : {"report.md", "witnesses.jsonl", "ratchet.txt"}) {
    EXPECT_EQ(old.read(file), present.read(file)) << file;
  }
}

TEST(RecordVersion, AComparisonOfBothFindsNoChange) {
  const Json old = read(first_version()), present = stored_record();
  for (const auto& [before, after] : {std::pair(old, present), std::pair(present, old)}) {
    const RunComparison found = compare_records(before, after, {});
    EXPECT_EQ(answer(found), "no change");
    EXPECT_EQ(found.count(Change::unchanged), found.cells.size());
    EXPECT_TRUE(found.not_compared.empty());
    EXPECT_EQ(found.tested, 0u) << "the queries are the same";
  }
}

TEST(RecordVersion, ARatchetOfTheFirstHoldsThePresentOne) {
  const Ratchet ratchet = read_ratchet(testdata + "ratchet_1.txt");
  EXPECT_EQ(ratchet.test, "sphere-triangle");
  const RatchetOutcome outcome = hold_against(ratchet, stored_record(), "2026-06-15");
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.better, IsEmpty());
  const Ratchet again = parse_ratchet(outcome.accepted, "again");
  EXPECT_THAT(outcome.accepted, testing::StartsWith("axiscert-ratchet/2 " + ratchet.plan + "\n"));
  ASSERT_EQ(again.entries.size(), ratchet.entries.size());
  for (const auto& [fingerprint, entry] : ratchet.entries) {
    const RatchetEntry& now = again.entries.at(fingerprint);
    EXPECT_EQ(std::tie(now.key, now.figure), std::tie(entry.key, entry.figure));
    EXPECT_EQ(now.waiver, entry.waiver);
  }
}

TEST(RecordVersion, OthersAreRefusedAndThoseThatAreReadAreNamed) {
  const auto names_both = AllOf(HasSubstr("\"axiscert-record/1\""), HasSubstr("\"axiscert-record/2\""));
  for (const Json& schema : {Json("axiscert-record/3"), Json("axiscert-record"), Json("axiscert-run/1"), Json(2)}) {
    const std::string error = refusal([&](Json& record) { record["schema"] = schema; });
    EXPECT_THAT(error, AllOf(HasSubstr("its schema is " + schema.dump()), names_both));
  }
}

TEST(RecordVersion, AMemberOfThePresentOneIsNotInTheFirst) {
  Json record = first_version();
  record["plan"]["test"] = "sphere-triangle";
  EXPECT_THAT(refusal(record), AllOf(HasSubstr("axiscert-record/1"), HasSubstr("/plan/test")));
  EXPECT_THAT(refusal([](Json& r) { r["plan"].erase("test"); }), HasSubstr("without \"test\""));
  record = first_version();
  record["plan"] = 7;
  EXPECT_THAT(refusal(record), HasSubstr("/plan"));
  record.erase("plan");
  EXPECT_THAT(refusal(record), HasSubstr("without \"plan\""));
}

TEST(RecordVersion, ADamagedFileIsToldByTheVersionThatItClaims) {
  Json first = first_version(), present = stored_record();
  for (Json* record : {&first, &present}) tangent_counts(*record).erase("truth");
  EXPECT_THAT(refusal(first), AllOf(HasSubstr("does not conform to axiscert-record/1: /kernels/0"),
                                    Not(HasSubstr("axiscert-record/2"))));
  EXPECT_THAT(refusal(present), HasSubstr("does not conform to axiscert-record/2: /kernels/0"));
}

TEST(RecordNames, AnUnknownTestIsToldWithThoseThatThereAre) {
  EXPECT_THAT(
      refusal([](Json& r) { r["plan"]["test"] = "sphere-triangel"; }),
      HasSubstr("/plan/test: unknown test 'sphere-triangel'; did you mean 'sphere-triangle'? tests: sphere-triangle"));
}

TEST(RecordNames, EveryComparisonAndAxisOfTheTestIsThereAndNoOther) {
  const std::string where = "kernel \"published\" in binary32, family \"tangent\": ";
  EXPECT_THAT(refusal([](Json& r) { tangent_counts(r)["comparisons"].erase("edge_ab.side_c"); }),
              HasSubstr(where + "without comparison edge_ab.side_c of the test sphere-triangle"));
  EXPECT_THAT(refusal([](Json& r) { tangent_counts(r)["axes"].erase("vertex_c"); }),
              HasSubstr(where + "without axis vertex_c of the test sphere-triangle"));
  EXPECT_THAT(refusal([](Json& r) {
                Json& all = tangent_counts(r)["comparisons"];
                all["plane.radios"] = all["plane.radius"];
              }),
              HasSubstr(where + "the test sphere-triangle has no comparison \"plane.radios\"; it has: plane.radius, "));
  EXPECT_THAT(refusal([](Json& r) { r["plan"]["tolerance"]["gap.x"] = "2"; }),
              HasSubstr("tolerance: the test sphere-triangle has no comparison \"gap.x\""));
}

TEST(RecordNames, NumbersAndBitsAreThoseOfTheTest) {
  EXPECT_THAT(refusal([](Json& r) { r["witnesses"][0].erase("c"); }),
              HasSubstr("witness \"w1\": without the numbers of a query of sphere-triangle: a, b, c, p, r"));
  EXPECT_THAT(refusal([](Json& r) { r["witnesses"][0]["d"] = "0x1p+0"; }),
              HasSubstr("witness \"w1\": \"d\" is not a member, nor a name of numbers of the test sphere-triangle"));
  EXPECT_THAT(refusal([](Json& r) { r["witnesses"][0]["exact_comparisons"] = "101"; }),
              HasSubstr("exact_comparisons is \"101\", but the test sphere-triangle has 16 comparisons"));
}

// Entries with the same names of groups differ in how many numbers a group has.
TEST(RecordNames, TheEntryOfAQueryIsTheOneWhoseNumbersItHas) {
  const TestDescription test =
      checked({.id = "point-box",
               .asks = "",
               .touching = "",
               .wrong_answers = {},
               .entries = {{"flat", "any", {{"px", Role::coordinate, "p"}}},
                           {"full", "any", {{"px", Role::coordinate, "p"}, {"py", Role::coordinate, "p"}}}},
               .comparisons = {{"x.low", 0}},
               .clauses = {{"x", 1}},
               .measures = {}});
  const Json number = "0x1p+0";
  EXPECT_EQ(entry_of(test, {{"id", "w1"}, {"p", number}}), &test.entries[0]);
  EXPECT_EQ(entry_of(test, {{"id", "w1"}, {"p", {number, number}}}), &test.entries[1]);
  EXPECT_EQ(entry_of(test, {{"id", "w1"}, {"p", {number, number, number}}}), nullptr);
  EXPECT_EQ(entry_of(test, {{"id", "w1"}}), nullptr);
}

}  // namespace
}  // namespace axiscert
