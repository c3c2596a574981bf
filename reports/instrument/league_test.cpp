// The words by which the league says whether a contender can be trusted, and the code for its worst query.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/queries/source.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"
#include "reports/instrument/league_report.h"
#include "reports/testing/test_run.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Half of the queries are contacts, one more where their number is odd.
Tally tally_of(std::uint64_t trials, std::uint64_t missed, std::uint64_t invented) {
  Tally tally = empty_tally(sphere_triangle_predicate());
  tally.trials = trials;
  tally.truth.separated = trials / 2;
  tally.truth.contact = trials - tally.truth.separated;
  tally.verdict.false_separation = missed;
  tally.verdict.false_contact = invented;
  return tally;
}

Kernel made_kernel(bool may_decline) {
  Kernel kernel = find_kernel("published");
  kernel.may_decline = may_decline;
  return kernel;
}

std::string trust_text(const Tally& tally, bool may_decline = false) {
  return trust_in(made_kernel(may_decline), tally).text();
}

TEST(LeagueTrust, IsYesWhereNothingIsWrongAndEnoughWasDecided) {
  EXPECT_EQ(trust_text(tally_of(32768, 0, 0)), "yes: 0 of 32,768 wrong");
  EXPECT_EQ(trust_text(tally_of(59, 0, 0)), "yes: 0 of 59 wrong");
  EXPECT_EQ(trust_text(tally_of(58, 0, 0)), "too few: 58 of 58 decided");
  EXPECT_EQ(trust_text(tally_of(0, 0, 0)), "not looked at: 0 of 0 decided");
}

TEST(LeagueTrust, IsNotGivenToAKernelThatDeclinesMoreThanHalfOfEitherAnswer) {
  Tally tally = tally_of(4096, 0, 0);
  tally.verdict.undecided = tally.verdict.undecided_contact = 1024;
  EXPECT_EQ(trust_text(tally, true), "yes: 0 of 3,072 wrong; declines 1,024") << "half of the contacts is enough";
  tally.verdict.undecided = tally.verdict.undecided_contact = 1025;
  EXPECT_EQ(trust_text(tally, true), "too few: 1,023 of 2,048 contacts decided; declines 1,025");
  tally.verdict.undecided_contact = 0;
  EXPECT_EQ(trust_text(tally, true), "too few: 1,023 of 2,048 separations decided; declines 1,025");
  tally.verdict.undecided = 4096;
  tally.verdict.undecided_contact = 2048;
  EXPECT_EQ(trust_text(tally, true), "not looked at: 0 of 4,096 decided; declines 4,096");
  tally.verdict.undecided = 4084;
  tally.verdict.undecided_contact = 2036;
  EXPECT_EQ(trust_text(tally, true), "too few: 12 of 4,096 decided; declines 4,084");
}

TEST(LeagueTrust, IsNotGivenAfterOneAnswerThatNoKernelMayGive) {
  Tally tally = tally_of(4096, 0, 0);
  tally.verdict.undecided = 1;
  EXPECT_EQ(trust_text(tally), "no: 0 of 4,095 wrong; declines 1 and does not declare that it may");
  EXPECT_EQ(trust_text(tally, true), "yes: 0 of 4,095 wrong; declines 1");
  tally.verdict.undecided = 0;
  tally.verdict.invalid = 1;
  EXPECT_EQ(trust_text(tally, true), "no: 0 of 4,095 wrong; calls 1 invalid");
  tally.verdict.invalid = 0;
  tally.verdict.unanswered = 4096;
  EXPECT_EQ(trust_text(tally, true), "no: 0 of 0 wrong; no answer to 4,096");
}

TEST(LeagueTrust, IsNotGivenToAKernelThatLimitsItselfToNothing) {
  Tally tally = tally_of(4096, 0, 0);
  OutsideTally& outside = *tally.verdict.outside_limits;
  outside.trials = 4096;
  outside.contact = 2048;
  EXPECT_EQ(trust_text(tally), "not looked at: 0 of 4,096 decided; 4,096 outside its limits");
  outside.trials = 4095;
  EXPECT_EQ(trust_text(tally), "too few: 1 of 4,096 decided; 4,095 outside its limits");
}

TEST(LeagueTrust, IsRarelyWhereLessThanOneInAThousandIsWrong) {
  EXPECT_EQ(trust_text(tally_of(1000, 0, 1)), "no: 1 of 1,000 invented");
  EXPECT_EQ(trust_text(tally_of(1001, 0, 1)), "rarely: 1 of 1,001 invented");
  EXPECT_EQ(trust_text(tally_of(2001, 1, 1)), "rarely: 1 of 2,001 missed, 1 invented");
  EXPECT_EQ(trust_text(tally_of(2000, 1, 1)), "no: 1 of 2,000 missed, 1 invented");
  EXPECT_EQ(trust_text(tally_of(16384, 812, 0)), "no: 812 of 16,384 missed");
}

TEST(LeagueTrust, CountsOfVerdictsAndNamesEverythingElse) {
  Tally tally = tally_of(1010, 1, 0);
  tally.truth.invalid = 2;
  tally.truth.contact -= 2;
  tally.verdict.undecided = 3;
  tally.verdict.invalid = 1;
  tally.verdict.unanswered = 4;
  EXPECT_EQ(trust_text(tally, true), "no: 1 of 1,000 missed; declines 3; calls 1 invalid; no answer to 4");
}

TEST(LeagueTrust, HasNoDeepestMissWhereNothingWasDecided) {
  EXPECT_EQ(depth_text(0, 0, 0), "not measured");
  EXPECT_EQ(depth_text(0, 4096, 0), "none of 4,096");
  EXPECT_EQ(depth_text(3, 4096, 0.25), "0.25");
}

TEST(LeagueTrust, CountsForEachSideWhatCouldBeWrongThere) {
  constexpr FlipKind missed = FlipKind::false_separation, invented = FlipKind::false_contact;
  Tally tally = tally_of(100, 0, 0);
  tally.truth.touching = 10;
  tally.verdict.undecided = 43;
  tally.verdict.undecided_contact = 40;
  tally.verdict.undecided_touching = 4;
  Kernel kernel = made_kernel(true);
  EXPECT_EQ(decided_for(missed, kernel, tally), 10u);
  EXPECT_EQ(decided_for(invented, kernel, tally), 47u);
  kernel.touching = TouchingPolicy::separated;
  EXPECT_EQ(decided_for(missed, kernel, tally), 4u) << "six touching ones have to be separated";
  EXPECT_EQ(decided_for(invented, kernel, tally), 53u);
  kernel.touching = TouchingPolicy::either;
  EXPECT_EQ(decided_for(missed, kernel, tally), 4u);
  EXPECT_EQ(decided_for(invented, kernel, tally), 47u);
  tally.verdict.unanswered = 47;
  EXPECT_EQ(decided_for(invented, kernel, tally), 0u) << "these may have been the separations";
  tally.verdict.false_contact = tally.verdict.decided_separations = 1;
  EXPECT_EQ(decided_for(invented, kernel, tally), 1u);
}

TEST(LeagueTrust, HasAFamilyOfEveryGroup) {
  std::vector<SourcePtr> sources;
  for (const Family* family : families()) sources.push_back(family_source(*family));
  EXPECT_EQ(groups_asked(sources).size(), enum_count<TrustGroup>);
  EXPECT_EQ(find_family("scene-walk").trust_group, TrustGroup::scene);
  EXPECT_EQ(find_family("scale").trust_group, TrustGroup::small);
  EXPECT_TRUE(groups_asked({family_source(find_family("general"))}).empty());
}

// One kernel, with a miss at position 5 of `sliver`, and a deeper phantom.
struct WorstRun {
  League league;
  CampaignResult result;

  explicit WorstRun(const Kernel& kernel) {
    league.kernels = {&kernel};
    league.questions.sources = {family_source(find_family("general")), family_source(find_family("sliver"))};
    league.questions.precisions = {Precision::binary32};
    league.contenders = 1;
    for (std::size_t source = 0; source < 2; ++source) {
      CellResult& cell = result.cells.emplace_back();
      cell.source = source;
      cell.precision = Precision::binary32;
      cell.tallies.push_back(tally_of(64, 0, 0));
    }
    VerdictTally& sliver = result.cells[1].tallies[0].verdict;
    sliver.false_separation = 2;
    sliver.deepest_false_separation.offer({0.25, 5});
    sliver.deepest_false_separation.offer({0.125, 4});
    sliver.false_contact = 1;
    sliver.deepest_false_contact.offer({0.5, 3});
  }
};

TEST(LeagueWorst, IsTheDeepestMissBeforeAnyInventedContact) {
  WorstRun run(find_kernel("published"));
  const InstrumentTable table = worst_table(run.league, run.result);
  const std::string address = text(address_of(*run.league.questions.sources[1], 1, Precision::binary32, 5));
  EXPECT_EQ(table.rows,
            (std::vector<std::vector<std::string>>{{"published", "binary32", "missed", "sliver", "0.25", address}}));
  ASSERT_EQ(table.scenes.size(), 1u);
  EXPECT_THAT(table.scenes[0].sentence, testing::HasSubstr("misses a contact "));
  EXPECT_THAT(table.scenes[0].command, testing::HasSubstr("axiscert query " + address + " > worst.jsonl\n"));
  EXPECT_TRUE(table.scenes[0].query.contains("r"));

  run.result.cells[1].tallies[0].verdict.deepest_false_separation = Leaders<double>(3);
  EXPECT_EQ(worst_table(run.league, run.result).rows[0][2], "invented");
  run.result.cells[1].tallies[0].verdict.deepest_false_contact = Leaders<double>(3);
  for (CellResult& cell : run.result.cells)
    cell.tallies[0].verdict.false_separation = cell.tallies[0].verdict.false_contact = 0;
  const auto said = [&] { return worst_table(run.league, run.result).rows[0][2]; };
  EXPECT_EQ(said(), "none of 64 contacts and 64 separations") << "it says among how many";
  const auto decline = [&](std::uint64_t contacts, std::uint64_t separations) {
    for (CellResult& cell : run.result.cells) {
      cell.tallies[0].verdict.undecided = contacts + separations;
      cell.tallies[0].verdict.undecided_contact = contacts;
    }
  };
  decline(32, 0);
  EXPECT_EQ(said(), "none of 64 separations, and no contact decided");
  EXPECT_EQ(trust_table(run.league, run.result, Precision::binary32).rows[0].back(), "not measured");
  decline(0, 32);
  EXPECT_EQ(said(), "none of 64 contacts, and no separation decided");
  decline(32, 32);
  EXPECT_EQ(worst_table(run.league, run.result).rows[0][2], "not looked at");
  EXPECT_EQ(undecided_contenders(run.league, run.result).size(), 1u);
}

// A scene in metres comes before any depth.
TEST(LeagueFirst, IsTheFarthestSceneAndWhoIsRight) {
  WorstRun run(find_kernel("published"));
  run.league.questions.sources[0] = family_source(find_family("scene-walk"));
  EXPECT_EQ(worst_scene_of(run.league, run.result)->position, 5u) << "no scene is wrong: the deepest";
  const InstrumentFirst right = league_first(run.league, run.result);
  EXPECT_EQ(
      right.table.rows,
      (std::vector<std::vector<std::string>>{{"published", "yes: 0 of 64 wrong", "no: 2 of 128 missed, 1 invented"}}));
  EXPECT_EQ(right.sentences, (std::vector<std::string>{"Everyday scenes, binary32: right throughout: published.",
                                                       "All families, binary32: nobody is right throughout."}));
  VerdictTally& scenes = run.result.cells[0].tallies[0].verdict;
  scenes.false_contact = 1;
  scenes.farthest_false_contact.offer({0.166, 7});
  const auto worst = worst_scene_of(run.league, run.result);
  EXPECT_EQ(worst->position, 7u);
  EXPECT_FALSE(worst->is_missed);
  EXPECT_GT(worst->depth, 0);
  const InstrumentFirst wrong = league_first(run.league, run.result);
  EXPECT_EQ(wrong.table.rows[0][1], "no: 1 of 64 invented; worst 16.6 cm");
  EXPECT_THAT(wrong.worst->title, testing::StartsWith("The worst everyday scene: published"));
  EXPECT_THAT(wrong.worst->sentence, testing::HasSubstr("invents a contact across a gap of 16.6 cm, where r is "));
}

// As a program's: its time is not taken.
TEST(League, OfAContenderWithoutATimeTheTableSaysNotMeasured) {
  WorstRun run(find_kernel("published"));
  run.league.nanoseconds[{Precision::binary32, 1}] = 2.5;
  const std::string text = instrument_text(league_report(run.league, run.result, "axiscert league"));
  EXPECT_THAT(text, testing::ContainsRegex("ns a query\n  published .* 0  not measured\n"));
}

TEST(LeagueWorst, HasTheCodeOfAProgramsManifestWithNumbersThatReadBackExactly) {
  TestFolder folder;
  folder.write("m.json", R"({"format":"axiscert-program/2","name":"m","command":["sh"],"precisions":["binary32"],)"
                         R"("package":"three","version":"1.2","code":["ask({r});","{ax}"]})");
  const Kernel kernel = plugin::load_program("program:m.json", (folder.path() / "m.json").string());
  const WorstRun run(kernel);
  const InstrumentScene scene = worst_table(run.league, run.result).scenes.at(0);
  EXPECT_EQ(scene.needs, "three 1.2");
  const auto q = run.league.questions.sources[1]->make<float>(1, 5);
  float r = 0;
  double ax = 0;
  ASSERT_EQ(std::sscanf(scene.code.c_str(), "ask(%f);\n%lf\n", &r, &ax), 2) << scene.code;
  EXPECT_EQ(r, q[12]);
  EXPECT_EQ(ax, static_cast<double>(q[0])) << "a double, too, has all of a float's bits";
}

}  // namespace
}  // namespace axiscert
