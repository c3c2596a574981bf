// Comparison of records: a stored one with itself and with changed copies.
#include "fuzz/text/json.h"
#include "reports/comparison/compare.h"
#include "reports/comparison/comparison_report.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

// The stored record as if it had been drawn from another seed.
Json other_seed() {
  Json record = stored_record();
  record["plan"]["seed"] = 2;
  return record;
}

const ComparedCell& cell(const RunComparison& comparison, const std::string& name) {
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.before.kernel == "published" && cell.before.family == "tangent" && cell.before.name() == name) return cell;
  }
  throw std::logic_error(name);
}

std::string markdown(const Json& before, const Json& after) {
  return markdown_of(before, after, compare_records(before, after, {}));
}

TEST(Compare, ARunWithItselfDoesNotDiffer) {
  const Json record = stored_record();
  const RunComparison same = compare_records(record, record, {});
  EXPECT_EQ(same.alarms(), 0u);
  EXPECT_EQ(same.count(Change::unchanged), same.cells.size());
  EXPECT_EQ(answer(same), "no change");
  EXPECT_EQ(same.tested, 0u);
  EXPECT_TRUE(same.not_compared.empty());
  // With another seed, equal counts are not evidence of a change, and maxima never are.
  EXPECT_EQ(answer(compare_records(record, other_seed(), {})), "no change");
}

// Zeros of a kernel that decided nothing are not where it is wrong nowhere.
TEST(Compare, AKernelThatDecidesNothingIsWrongNowhereLookedAt) {
  Json record = stored_record();
  const Json sound = data_of(record, record, compare_records(record, record));
  EXPECT_GT(sound["wrong_nowhere"], 0);
  EXPECT_EQ(sound["not_looked_at"], 0);
  for (Json& kernel : record["kernels"]) {
    for (Json& family : kernel["families"]) {
      for (Json& figure : family["verdict"]) {
        if (figure.is_number()) figure = 0;
      }
      family["verdict"]["undecided"] = family["trials"];
      family["verdict"]["undecided_contact"] = family["truth"]["contact"];
      family["verdict"]["undecided_touching"] = family["truth"]["touching"];
      family["comparisons"] = family["axes"] = nullptr;
    }
  }
  const RunComparison silent = compare_records(record, record);
  const Json data = data_of(record, record, silent);
  EXPECT_EQ(data["wrong_nowhere"], 0);
  EXPECT_GT(data["not_looked_at"], 0);
  EXPECT_THAT(markdown_of(record, record, silent), HasSubstr("not looked at"));
}

// It decides every separation and no contact: it misses none of nothing.
TEST(Compare, AKernelThatDecidesNoContactMissesNoneLookedAt) {
  Json record = stored_record();
  for (Json* kernels : {&record["kernels"], &record["plan"]["kernels"]}) kernels->erase(0);
  for (Json& family : record["kernels"][0]["families"]) {
    Json& verdict = family["verdict"];
    for (Json& figure : verdict) {
      if (figure.is_number()) figure = 0;
    }
    verdict["undecided"] = verdict["undecided_contact"] = family["truth"]["contact"];
    verdict["undecided_touching"] = family["truth"]["touching"];
  }
  const RunComparison found = compare_records(record, record);
  for (const ComparedCell& cell : found.cells) {
    if (!cell.is_zero_in_both()) continue;
    EXPECT_EQ(cell.is_looked_at(), cell.before.member.find("false_separation") == std::string::npos)
        << cell.before.name();
  }
  EXPECT_EQ(data_of(record, record, found)["not_looked_at"], 4) << "a count and a depth of each family";
}

TEST(Compare, RunsOfTwoPredicatesAreRefused) {
  Json other = stored_record();
  other["plan"]["predicate"] = "point-box";
  EXPECT_THAT(
      [&] { compare_records(stored_record(), other, {}); },
      testing::ThrowsMessage<Error>(
          "OLD is of the predicate sphere-triangle, and NEW of point-box; only runs of one predicate can be compared"));
}

TEST(Compare, OnTheSameQueriesOneIsADifference) {
  const Json before = stored_record();
  Json after = before;
  Json& verdict = tangent_counts(after)["verdict"];
  verdict["false_separation"] = 41;
  verdict["false_contact"] = 19;
  verdict["deepest_false_contact"] = 0.5;
  tangent_counts(after)["comparisons"]["vertex_a.radius"]["false_separation"] = 0;
  tangent_counts(after)["comparisons"]["edge_bc.side_a"]["missed_separation"] = 1;
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(cell(found, "verdict.false_separation").change, Change::worse);
  EXPECT_EQ(cell(found, "verdict.false_contact").change, Change::better);
  EXPECT_EQ(cell(found, "verdict.deepest_false_contact").change, Change::worse);
  EXPECT_EQ(cell(found, "vertex_a.radius.false_separation").change, Change::fixed);
  EXPECT_EQ(cell(found, "edge_bc.side_a.missed_separation").change, Change::fresh);
  EXPECT_EQ(found.alarms(), 3u);
  EXPECT_FALSE(cell(found, "verdict.false_separation").witnesses.empty());
  EXPECT_EQ(answer(found), "worse: 1 new, 2 worse, 1 better, 1 fixed");
}

TEST(Compare, OnOtherQueriesOnlyWhatChanceDoesNotExplain) {
  const Json before = stored_record();
  Json after = other_seed();
  Json& verdict = tangent_counts(after)["verdict"];
  verdict["false_separation"] = 55;            // among 995, where OLD has 40: explained by chance
  verdict["deepest_false_separation"] = 0.99;  // a maximum
  tangent_counts(after)["comparisons"]["plane.radius"]["max_error_u"] = 1e9;
  EXPECT_EQ(compare_records(before, after, {}).alarms(), 0u);
  verdict["false_separation"] = 140;
  const RunComparison found = compare_records(before, after, {});
  EXPECT_EQ(cell(found, "verdict.false_separation").change, Change::worse);
  EXPECT_EQ(found.alarms(), 1u);
  EXPECT_LT(*cell(found, "verdict.false_separation").p_corrected, family_wise_error);
  EXPECT_GT(found.tested, 50u);
}

// 3000 queries on a mesh of 12 triangles are 12 independent draws: a third of them wrong is not a certain change.
TEST(Compare, QueriesThatShareATriangleAreOne) {
  const Json before = stored_record();
  Json after = other_seed();
  Json& mesh = after["kernels"][0]["families"]["mesh/a|b.obj"];
  mesh["verdict"]["false_separation"] = 1000;
  EXPECT_EQ(compare_records(before, after, {}).alarms(), 0u);
  mesh["base_triangles"] = 3000;
  Json with_bases = before;
  with_bases["kernels"][0]["families"]["mesh/a|b.obj"]["base_triangles"] = 3000;
  EXPECT_EQ(compare_records(with_bases, after, {}).alarms(), 1u);
}

TEST(Compare, WhatOnlyOneHasIsNotCompared) {
  const Json before = stored_record();
  Json after = before;
  after["kernels"].erase(1);
  after["kernels"][0]["families"].erase("lattice");
  tangent_counts(after)["comparisons"] = nullptr;
  after["plan"]["tolerance"]["plane.radius"] = "3";
  const RunComparison found = compare_records(before, after, {});
  std::vector<std::string> whats;
  for (const NotCompared& absent : found.not_compared) whats.push_back(absent.what);
  EXPECT_THAT(whats, testing::Contains("published binary32 on lattice"));
  EXPECT_THAT(whats, testing::Contains("published binary32 on tangent: comparisons"));
  EXPECT_THAT(whats, testing::Contains("published binary32 on mesh/a|b.obj: plane.radius.tolerance_failures"));
  EXPECT_FALSE(found.passes());
  EXPECT_THAT(markdown(before, after), HasSubstr("# axiscert compare: NOT COMPARED: "));
}

TEST(Compare, AFindingIsNewWhateverTheSeed) {
  const Json before = stored_record();
  Json after = other_seed();
  after["findings"].push_back(crash_on("tangent"));
  EXPECT_EQ(answer(compare_records(before, after, {})), "worse: 1 new");
  EXPECT_EQ(answer(compare_records(after, before, {})), "better: 1 fixed");
}

TEST(Compare, ARunThatTimeCutIsOfOtherQueries) {
  const Json before = stored_record();
  Json after = before;
  after["plan"]["units_done"] = Json::object();
  EXPECT_FALSE(cell(compare_records(before, after, {}), "verdict.false_separation").same_queries);
  EXPECT_TRUE(cell(compare_records(before, before, {}), "verdict.false_separation").same_queries);
}

TEST(Compare, AKnownWitnessThatIsWrongNowIsAnAlarm) {
  const Json record = stored_record();
  const RunComparison found = compare_records(
      record, record, {{"w1", "published", "binary32", "tangent", ReplayOutcome::wrong_now, "verdict false_contact"}});
  EXPECT_EQ(found.alarms(), 1u);
  EXPECT_EQ(answer(found), "worse: 1 known witnesses wrong now");
}

TEST(Compare, NamesAreTextInMarkdownAndOnThePage) {
  std::string text = stored_record().dump();
  for (std::size_t at; (at = text.find("a|b.obj")) != text.npos;) text.replace(at, 7, "</script><script>alert(1)");
  const Json before = Json::parse(text);
  Json after = before;
  for (Json& family : after["kernels"][1]["families"]) family["verdict"]["false_separation"] = 900;
  after["kernels"][0]["families"].erase("mesh/</script><script>alert(1)");
  EXPECT_THAT(markdown(before, after), HasSubstr("mesh/&lt;/script>"));
  const Record then = edited(before), now = edited(after);
  const std::string page =
      instrument_page(comparison_report({then, now, "old", "<b>new</b>"}, compare_records(then, now, {})));
  EXPECT_THAT(page, HasSubstr("&lt;/<wbr>script&gt;&lt;script&gt;alert(1)"));
  EXPECT_THAT(page, Not(HasSubstr("<script>alert")));
  EXPECT_THAT(page, Not(HasSubstr("<b>new")));
}

TEST(Compare, MarkdownStaysUnderAMebibyte) {
  Json before = stored_record();
  for (int i = 0; i < 300; ++i) {
    const std::string name = "family-" + std::string(300, 'x') + std::to_string(i);
    before["kernels"][0]["families"][name] = tangent_counts(before);
    before["plan"]["families"].push_back(name);
  }
  Json after = before;
  for (Json& family : after["kernels"][0]["families"]) family["verdict"]["false_separation"] = 300;
  const std::string text = markdown(before, after);
  EXPECT_LT(text.size(), std::size_t{1} << 20);
  EXPECT_THAT(text, HasSubstr("left out here"));
}

}  // namespace

// The first contacts of two runs of a predicate of motions against each other.

namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

RunComparison compared(const Json& before, const Json& after) {
  return compare_records(motions(before), motions(after), {});
}

// Those that are not unchanged, as "time.late worse".
std::vector<std::string> changed_cells(const RunComparison& comparison) {
  std::vector<std::string> all;
  for (const ComparedCell& cell : comparison.cells) {
    if (cell.change != Change::unchanged) all.push_back(cell.before.name() + " " + std::string(name(cell.change)));
  }
  return all;
}

TEST(CompareContacts, OneLateTimeMoreIsWorseAndOneLessIsBetter) {
  const Json five = contacts(5, 0.25, 0), nine = contacts(9, 0.25, 0);
  EXPECT_EQ(answer(compared(five, five)), "no change");
  const RunComparison worse = compared(five, nine);
  EXPECT_THAT(changed_cells(worse), ElementsAre("time.late worse"));
  EXPECT_EQ(worse.alarms(), 1u);
  EXPECT_FALSE(worse.passes());
  const RunComparison better = compared(nine, five);
  EXPECT_THAT(changed_cells(better), ElementsAre("time.late better"));
  EXPECT_TRUE(better.passes());
  const std::string text = markdown_of(motions(five), motions(nine), worse);
  EXPECT_THAT(text, HasSubstr("5 of 900"));
  EXPECT_THAT(text, HasSubstr("9 of 900"));
  const Json json = data_of(motions(five), motions(nine), worse);
  for (const Json& cell : json["cells"]) {
    if (cell["place"] != "time" || cell["figure"] != "late") continue;
    EXPECT_EQ(cell["old"], 5);
    EXPECT_EQ(cell["new"], 9);
    EXPECT_EQ(cell["new_queries"], 900);
    EXPECT_EQ(cell["witnesses"], Json::array({"late"}));
  }
}

TEST(CompareContacts, ATunnelADepthOfItAndATimeThatIsNotGivenAreCells) {
  EXPECT_THAT(changed_cells(compared(contacts(5, 0.25, 0), contacts(5, 0.5, 0))),
              ElementsAre("time.deepest_tunnel worse"));
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 0), contacts(5, 0, 0.5))),
              ElementsAre("missed.deepest_tunnel new"));
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 1), contacts(5, 0, 0))),
              ElementsAre("missed.through fixed", "missed.deepest_tunnel fixed"));
  Json none = contacts(5, 0, 0);
  none["time"]["none"] = 2;
  none["time"]["best"] = 793;
  EXPECT_THAT(changed_cells(compared(contacts(5, 0, 0), none)), ElementsAre("time.none new"));
}

TEST(CompareContacts, NormalsPointsEarlyTimesAndFeaturesThatAreWorseAreCells) {
  Json then = contacts(5, 0.25, 0);
  then["feature"] = {{"judged", 900},        {"none", 0}, {"wrong", 2}, {"unnamed", 0}, {"given", given_beside(900)},
                     {"largest_error", 0.25}};
  then["normal"] = {{"judged", 900},
                    {"lengths", 900},
                    {"none", 0},
                    {"given", given_beside(900)},
                    {"largest_angle", 0.5},
                    {"largest_length_error", 0.0}};
  then["point"] = {{"judged", 900}, {"none", 0}, {"given", given_beside(900)}, {"largest_error", 0.125}};
  const auto cells_with = [&](const char* place, const char* member, const Json& value) {
    Json now = then;
    now[place][member] = value;
    return changed_cells(compared(then, now));
  };
  EXPECT_THAT(cells_with("time", "early", 101), ElementsAre("time.early worse"));
  EXPECT_THAT(cells_with("feature", "wrong", 3), ElementsAre("feature.wrong worse"));
  EXPECT_THAT(cells_with("feature", "none", 1), ElementsAre("feature.none new"));
  EXPECT_THAT(cells_with("feature", "largest_error", 0.5), ElementsAre("feature.largest_error worse"));
  EXPECT_THAT(cells_with("normal", "largest_angle", 0.75), ElementsAre("normal.largest_angle worse"));
  EXPECT_THAT(cells_with("normal", "largest_length_error", 0.5), ElementsAre("normal.largest_length_error new"));
  EXPECT_THAT(cells_with("point", "largest_error", 0.0625), ElementsAre("point.largest_error better"));
}

TEST(CompareContacts, OnOtherQueriesOnlyWhatChanceDoesNotExplain) {
  const auto with_other_seed = [](std::uint64_t late, double tunnel) {
    Json record = motions(contacts(late, tunnel, 0));
    record["plan"]["seed"] = 2;
    return compare_records(motions(contacts(5, 0.25, 0)), record, {});
  };
  EXPECT_THAT(changed_cells(with_other_seed(9, 0.75)), IsEmpty());
  const RunComparison worse = with_other_seed(90, 0.75);
  EXPECT_THAT(changed_cells(worse), ElementsAre("time.late worse"));
  EXPECT_THAT(markdown_of(motions(contacts(5, 0.25, 0)), motions(contacts(90, 0.75, 0)), worse),
              Not(HasSubstr("deepest_tunnel")));
}

TEST(CompareContacts, MeasuresThatOnlyOneRunGivesAreSaid) {
  Json with = motions(contacts(5, 0.25, 0)), without = with;
  without["kernels"][0]["measures"] = Json::array();
  for (Json& family : without["kernels"][0]["families"]) family["contacts"]["time"] = nullptr;
  const RunComparison lost = compare_records(with, without, {}), gained = compare_records(without, with, {});
  EXPECT_FALSE(lost.passes());
  EXPECT_THAT(answer(lost), testing::StartsWith("NOT COMPARED: <script> binary32: 'time' of contacts: it gives "
                                                "that in OLD and not in NEW; "));
  EXPECT_TRUE(gained.passes());
  EXPECT_THAT(answer(gained), testing::StartsWith("no change; only in NEW: <script> binary32: 'time' of contacts; "));
  EXPECT_THAT(markdown_of(with, without, lost), HasSubstr("tangent: contacts"));
}

TEST(CompareContacts, ZerosOfNoTimeAreNotLookedAt) {
  Json untimed = contacts(0, 0, 0);
  untimed["time"]["none"] = 900;
  untimed["time"]["early"] = untimed["time"]["best"] = 0;
  untimed["time"]["given"] = given_beside(0);
  for (const char* figure : {"late_errors", "late_tunnels", "early_errors", "largest_gap"})
    untimed["time"][figure] = nullptr;
  const Json record = motions(untimed);
  for (const ComparedCell& cell : compare_records(record, record).cells) {
    if (cell.before.family != "tangent" || cell.before.place != "time" || !cell.is_zero_in_both()) continue;
    EXPECT_EQ(cell.is_looked_at(), cell.before.member == "invalid") << cell.before.name();
  }
  // Nor are they what later errors are held to.
  const Json timed = motions(contacts(5, 0.25, 0));
  for (const ComparedCell& cell : compare_records(record, timed).cells) {
    if (cell.before.family != "tangent" || cell.before.place != "time") continue;
    EXPECT_NE(cell.before.kind, Cell::Kind::maximum) << cell.before.name();
  }
  EXPECT_THAT(markdown_of(record, timed, compare_records(record, timed)), HasSubstr("looked at on no answer in OLD"));
}

TEST(CompareContacts, AnotherPredicateHasNone) {
  for (const Cell& cell : cells_of(edited(stored_record()))) EXPECT_FALSE(cell.is_of_contacts()) << cell.name();
}

}  // namespace

}  // namespace axiscert
