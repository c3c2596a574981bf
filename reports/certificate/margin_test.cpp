// The sentences of a safe margin: what is of use first, and nothing where there is nothing to say.
#include "reports/certificate/margin.h"

#include <fmt/ranges.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "fuzz/instruments/safe_margin.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

MissedContact contact_of(const Rational& value) {
  return {R"({"precision":"binary32"})", "tangent", "0x1p+0", "0x1.8p+0", round_up(value)};
}

// A margin in which each scene missed some contacts; `factor` 0: none, all tiny.
SafeMargin margin_with(const std::map<MarginScene, std::pair<int, int>>& growths) {
  SafeMargin margin{Precision::binary32};
  margin.queries = 1000;
  for (const auto& [scene, growth] : growths) {
    MarginPart& part = margin.parts[scene];
    part.queries = 100;
    part.contacts = 50;
    part.missed = 7;
    if (growth.first != 0) part.factor = contact_of(Rational(growth.first));
    else part.tiny = 7;
    part.amount = contact_of(Rational(growth.second, 1000));
    part.phantoms_by_factor = 2;
    part.phantoms_by_amount = 3;
    margin.factor = part.factor;
    margin.amount = part.amount;
  }
  return margin;
}

TEST(MarginWords, BeginWithEverydayScenesOnTrianglesThatAreNotDegenerate) {
  const auto notes = margin_notes(margin_statement(margin_with(
      {{{false, 0}, {2, 1500}}, {{false, 2}, {3, 20000}}, {{false, 9}, {9, 9000}}, {{true, 0}, {5, 8000}}})));
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_THAT(notes[0],
              HasSubstr("in scenes of 0.001 to 10,000 units: r times 3, or r plus 1.51 of the scene's size, mends"));
  EXPECT_THAT(notes[0], HasSubstr("; in scenes of 1 to 10 r plus 1.5;"));
  EXPECT_THAT(notes[0],
              HasSubstr("of 200 such queries that makes 4 new phantom contacts by each size's own factor, 6"));
  EXPECT_THAT(notes[1], HasSubstr("On degenerate triangles"));
  EXPECT_THAT(notes[1], HasSubstr("r times 5, or r plus 8.05 of the scene's size"));
  EXPECT_THAT(
      notes[2],
      HasSubstr(
          "Over all scales in binary32, degenerate or not: r times 9, or r plus 8.05 of the scene's size, mends"));
  EXPECT_THAT(notes[2], Not(HasSubstr("how small r is")));
}

TEST(MarginWords, ATinyRadiusHasAnAmountAlone) {
  const auto notes = margin_notes(margin_statement(margin_with({{{false, 0}, {0, 250}}})));
  ASSERT_EQ(notes.size(), 2u);
  EXPECT_THAT(notes[0], HasSubstr("10,000 units: r plus 0.252 of the scene's size mends"));
  EXPECT_THAT(notes[0], Not(HasSubstr("r times")));
  EXPECT_THAT(notes[1], HasSubstr("7 with r = 0 or below 2^-12 of the scene's size have an amount and no factor"));
}

TEST(MarginWords, SayWhereNothingIsNeeded) {
  SafeMargin margin{Precision::binary64};
  margin.parts[{false, 0}].contacts = 878;
  EXPECT_THAT(fmt::format("{}", fmt::join(margin_notes(margin_statement(margin)), "|")),
              HasSubstr("binary64: none is needed: it missed none of 878 contacts"));
  margin = margin_with({{{true, 0}, {5, 8000}}});
  margin.parts[{false, 0}].contacts = 9;
  const auto notes = margin_notes(margin_statement(margin));
  ASSERT_EQ(notes.size(), 3u);
  EXPECT_THAT(notes[0], HasSubstr("none is needed on triangles that are not degenerate"));
}

// Nothing is known of contacts that a kernel did not answer.
TEST(MarginWords, SayThatNothingIsKnownOfContactsWithoutAVerdict) {
  SafeMargin margin{Precision::binary32};
  const auto note = [&] { return margin_notes(margin_statement(margin)).front(); };
  EXPECT_THAT(note(), HasSubstr("not known: no contact was asked about."));
  MarginPart& part = margin.parts[{false, 0}];
  part.contacts = part.without_verdict = 878;
  EXPECT_THAT(note(), HasSubstr("not known: it answered none of 878 contacts."));
  part.without_verdict = 800;
  EXPECT_THAT(note(),
              HasSubstr("not known: it gave no verdict to 800 of 878 contacts, and missed none of the others."));
  margin = margin_with({{{true, 0}, {5, 8000}}});
  margin.parts[{false, 0}].contacts = margin.parts[{false, 0}].without_verdict = 4;
  EXPECT_THAT(
      note(),
      HasSubstr("10,000 units: not known: it answered none of 4 contacts on triangles that are not degenerate."));
  EXPECT_THAT(margin_notes(margin_statement(margin)).back(), HasSubstr("to 4 of 54 contacts it gave no verdict"));
}

TEST(MarginWords, TheTableHasEachSizeWhereAContactWasMissed) {
  SafeMargin margin = margin_with({{{false, 1}, {2, 10}}, {{true, -400}, {0, 1}}});
  margin.parts[{false, 3}].queries = 5;
  const InstrumentTable table = margin_table({{}, {margin_statement(margin)}});
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[0], (std::vector<std::string>{"binary32", "others", "1e1", "100", "7", "0", "0", "2", "0.01",
                                                     "0.00101", "2", "3"}));
  EXPECT_EQ(table.rows[1][1], "degenerate");
  EXPECT_EQ(table.rows[1][2], "0");
  EXPECT_EQ(table.rows[1][7], "-");
  EXPECT_EQ(table.rows[1][8], "-");
  EXPECT_EQ(table.rows[1][9], "-");
}

// An amount of 3e113 says nothing to anybody; that it is a third of the scene does.
TEST(MarginWords, AnAmountBeyondEverydaySizesIsShownRelativeToTheSceneAlone) {
  SafeMargin margin = margin_with({{{false, 113}, {2, 10}}});
  const Rational size = [] {
    Rational power = 1;
    for (int i = 0; i < 113; ++i) power *= 10;
    return power;
  }();
  margin.parts[{false, 113}].amount = contact_of(Rational(size * 3 / 10));
  const MarginStatement said = margin_statement(margin);
  const InstrumentTable table = margin_table({{}, {said}});
  EXPECT_EQ(table.rows[0][8], "-");
  EXPECT_EQ(table.rows[0][9], "0.302");
  const std::string notes = fmt::format("{}", fmt::join(margin_notes(said), "|"));
  EXPECT_THAT(notes,
              HasSubstr("Over all scales in binary32, degenerate or not: r times 2, or r plus 0.302 of the scene's"));
  EXPECT_THAT(notes, Not(HasSubstr("e+")));
}

TEST(MarginWords, EverydayScenesEndAtTenKilometresAndTheUnitIsOneOfTrianglesThatAreNotDegenerate) {
  const auto notes =
      margin_notes(margin_statement(margin_with({{{false, 3}, {2, 1}}, {{false, 4}, {7, 1}}, {{true, 0}, {5, 8000}}})));
  EXPECT_THAT(notes[0], HasSubstr("in scenes of 0.001 to 10,000 units: r times 2, or"));
  EXPECT_THAT(notes[0], Not(HasSubstr("in scenes of 1 to 10")));
}

}  // namespace
}  // namespace axiscert
