// A plug-in is known by the name that it declares: compare, the ratchet and code scanning take a file that was renamed,
// moved or built anew for the same kernel, and another name for another kernel. What was not judged or not compared is
// never a pass.
#include "fuzz/text/json.h"
#include "reports/run_folder/identity.h"

#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/testing/edited_record.h"
#include "reports/gates/ratchet.h"
#include "reports/gates/requirement.h"

namespace axiscert {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string one_digest(64, '1'), other_digest(64, '2');

// Kernel number `index` of a record, made a plug-in: everywhere.
void make_plugin(Json& record, std::size_t index, const std::string& id, const std::string& name,
                 const std::string& sha256) {
  const std::string old = record["kernels"][index]["id"];
  for (Json& entry : record["kernels"]) {
    if (entry["id"] == old) {
      entry["id"] = id;
      entry["name"] = name;
      entry["digest"] = Json::array({{{"kind", "plugin"}, {"sha256", sha256}}});
    }
  }
  for (Json& planned : record["plan"]["kernels"]) {
    if (planned == old) planned = id;
  }
  for (Json& witness : record["witnesses"]) {
    if (witness["kernel"] == old) witness["kernel"] = id;
  }
}

Json with_plugin(const std::string& id, const std::string& name = "mine", const std::string& sha256 = one_digest) {
  Json record = stored_record();
  make_plugin(record, 0, id, name, sha256);
  read_record(record, "record.json");
  return record;
}

// Both of the stored record's kernels are plug-ins.
Json with_two(const std::string& name, const std::string& other) {
  Json record = with_plugin("plugin:a.so", name);
  make_plugin(record, 1, "plugin:b.so", other, other_digest);
  return record;
}

std::vector<std::string> failing(const RunComparison& comparison) {
  std::vector<std::string> all;
  for (const NotCompared& absent : comparison.not_compared) {
    if (absent.absence == Absence::fails) all.push_back(absent.what + ": " + absent.why);
  }
  return all;
}

std::vector<std::string> failure_texts(const std::vector<RatchetFailure>& failures) {
  std::vector<std::string> all;
  for (const RatchetFailure& failure : failures) all.push_back(failure.text);
  return all;
}

Ratchet ratchet_of(const Json& record) {
  std::string text = ratchet_text(record);
  const std::string open = "EXPIRY OWNER REASON";
  text.replace(text.find(open), open.size(), "never mk why");
  return parse_ratchet(text, "r.txt");
}

TEST(Identity, IsTheNameOfAPlugInAndTheIdOfAnyOther) {
  EXPECT_THAT(identities_of(edited(with_plugin("plugin:k.so"))),
              ElementsAre(testing::Pair("<script>", "<script>"), testing::Pair("plugin:k.so", "plugin/mine")));
}

TEST(Identity, APlugInThatSharesItsNameIsKnownByItsId) {
  EXPECT_THAT(identities_of(edited(with_two("mine", "mine"))),
              ElementsAre(testing::Pair("plugin:a.so", "plugin:a.so"), testing::Pair("plugin:b.so", "plugin:b.so")));
  // In one of the records that are compared is enough.
  const Json one = with_plugin("plugin:a.so");
  const RunComparison found = compare_records(with_two("mine", "mine"), one, {});
  EXPECT_THAT(failing(found), ElementsAre("plugin:b.so: is only in OLD; several kernels of one run declare the name "
                                          "'mine', so each is known by its id"));
  EXPECT_GT(found.compared(), 0u);
}

TEST(Identity, AnotherPathOfTheSameNameIsTheSameKernel) {
  const Json before = with_plugin("plugin:k.so"), after = with_plugin("plugin:./moved/renamed.so");
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(answer(found), "no change");
  EXPECT_TRUE(found.passes());
  EXPECT_THAT(found.not_compared, IsEmpty());
  EXPECT_EQ(found.kernels[0].digest_change, "");
  EXPECT_THAT(markdown_of(before, after, found),
              HasSubstr("| plugin/mine | plugin:k.so | plugin:./moved/renamed.so | the same |"));
  const RatchetOutcome outcome = hold_against(ratchet_of(before), after, "2026-06-15");
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.changed, IsEmpty());
}

TEST(Identity, OtherBytesOfTheSameNameAreAChange) {
  const Json before = with_plugin("plugin:k.so"), after = with_plugin("plugin:k.so", "mine", other_digest);
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(found.kernels[0].digest_change, "its plugin was SHA-256 111111111111..., and is 222222222222...");
  EXPECT_TRUE(found.passes()) << "a change is told, it is no fault";
  EXPECT_EQ(data_of(before, after, found)["kernels"][0]["changed"], true);
  const RatchetOutcome outcome = hold_against(ratchet_of(before), after, "2026-06-15");
  EXPECT_THAT(outcome.failures, IsEmpty());
  EXPECT_THAT(outcome.changed,
              ElementsAre("plugin/mine: its plugin was SHA-256 111111111111..., and is 222222222222..."));
  EXPECT_THAT(outcome.accepted, HasSubstr("kernel: plugin/mine plugin:" + other_digest + "\n"));
}

TEST(Identity, AnotherNameAtTheSamePathIsAnotherKernel) {
  const Json before = with_plugin("plugin:k.so"), after = with_plugin("plugin:k.so", "yours");
  const RunComparison found = compare_records(before, after, {});
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(failing(found),
              ElementsAre("plugin:k.so: is only in OLD; in NEW it declares another name, 'yours' and not 'mine'"));
  EXPECT_THAT(answer(found), testing::StartsWith("NOT COMPARED: plugin:k.so: is only in OLD"));
  EXPECT_THAT(failure_texts(hold_against(ratchet_of(before), after, "2026-06-15").failures),
              Contains(HasSubstr("NOT CHECKED: this run did not judge plugin/mine binary32")));
}

TEST(Unchecked, TwoRunsWithNothingInCommonAreNoPass) {
  Json before = with_plugin("plugin:a.so"), after = with_plugin("plugin:b.so", "yours");
  for (Json* record : {&before, &after}) {
    (*record)["kernels"].erase(1);
    (*record)["plan"]["kernels"].erase(1);
  }
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(found.alarms(), 0u);
  EXPECT_EQ(found.compared(), 0u);
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(answer(found), testing::StartsWith("NOT COMPARED: nothing was compared"));
  EXPECT_THAT(markdown_of(before, after, found),
              testing::AllOf(HasSubstr("| plugin:a.so | is only in OLD | 1 |"),
                             HasSubstr("| plugin:b.so | is only in NEW | no fault |")));
  const Json json = data_of(before, after, found);
  EXPECT_EQ(json["compared"], 0);
  EXPECT_EQ(json["passes"], false);
}

TEST(Unchecked, AKernelThatOnlyNewHasIsListedAndPasses) {
  Json before = stored_record();
  before["kernels"].erase(1);
  before["plan"]["kernels"].erase(1);
  const RunComparison found = compare_records(before, stored_record(), {});
  EXPECT_TRUE(found.passes());
  ASSERT_EQ(found.not_compared.size(), 1u);
  EXPECT_EQ(found.not_compared[0].what + " " + found.not_compared[0].why, "<script> is only in NEW");
  EXPECT_EQ(answer(found), "no change; only in NEW: <script>");
}

TEST(Unchecked, NoValidQueryIsNoComparison) {
  Json record = stored_record();
  record["kernels"].erase(1);
  record["plan"]["kernels"].erase(1);
  for (Json& family : record["kernels"][0]["families"]) {
    for (const char* member : {"false_separation", "false_contact"}) family["verdict"][member] = 0;
    for (Json& comparison : family["comparisons"]) {
      for (const char* member : {"false_separation", "missed_separation", "tolerance_failures"}) comparison[member] = 0;
    }
    family["truth"] = {{"separated", 0}, {"contact", 0}, {"touching", 0}, {"invalid", family["trials"]}};
  }
  EXPECT_EQ(compare_records(record, record, {}).compared(), 0u);
  EXPECT_FALSE(compare_records(record, record, {}).passes());
  EXPECT_THAT(unjudged(record),
              ElementsAre("published: NOT JUDGED on tangent, lattice, mesh/a|b.obj: no valid query in a "
                          "precision in which it exists"));
}

TEST(Unjudged, IsAKernelThatDidNotLoadAndAFamilyWithoutQueries) {
  EXPECT_THAT(unjudged(stored_record()),
              ElementsAre(HasSubstr("<script>: NOT JUDGED on mesh/a|b.obj: no valid query")));
  Json record = stored_record();
  record["plan"]["kernels"].push_back("plugin:text.so");
  record["findings"].push_back(load_fault_of("plugin:text.so", "file too short"));
  EXPECT_THAT(unjudged(record), Contains("plugin:text.so: NOT JUDGED: it could not be loaded: file too short"));
  record = stored_record();
  for (Json& family : record["kernels"][0]["families"]) {
    const Json& truth = family["truth"];
    family["verdict"]["outside_limits"] = outside_all(truth["contact"], truth["touching"], truth["separated"]);
  }
  EXPECT_THAT(unjudged(record),
              Contains("published binary32: NOT JUDGED: every valid query is outside the limits that it declares"));
}

}  // namespace
}  // namespace axiscert
