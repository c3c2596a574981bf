// Descriptions of predicates: that of sphere-triangle says what its names say, and one of any size up to the limits is
// taken.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <deque>
#include <string>

#include "kernel/base/error.h"
#include "kernel/predicate.h"
#include "kernel/sphere_triangle/names.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::ThrowsMessage;

std::string_view numbered(const char* word, std::size_t i) {
  static std::deque<std::string> kept;
  return kept.emplace_back(word + std::to_string(i));
}

// A predicate with comparisons in clauses of three, the last of as many as are left.
Predicate toy(std::size_t columns, std::size_t comparisons) {
  Predicate predicate{.id = "toy",
                      .asks = "nothing",
                      .touching = "never",
                      .wrong_answers = {},
                      .entries = {{"numbers", "any", {}}, {"other", "any", {}}},
                      .comparisons = {},
                      .clauses = {},
                      .measures = {{"time", "of the motion", "in ulps"}}};
  for (std::size_t i = 0; i < columns; ++i) {
    predicate.entries[0].columns.push_back({numbered("column", i), Role::coordinate, "all"});
  }
  for (std::size_t i = 0; i < comparisons; ++i) {
    if (i % 3 == 0) predicate.clauses.push_back({numbered("clause", i / 3), 0});
    predicate.clauses.back().comparisons |= one_bit<ComparisonBits>(i);
    predicate.comparisons.push_back({numbered("comparison", i), i / 3});
  }
  return predicate;
}

TEST(Description, ThirtyThreeComparisonsAndFortyColumns) {
  const Predicate predicate = checked(toy(40, 33));
  EXPECT_EQ(predicate.entries[0].columns[39].name, "column39");
  const std::uint64_t last = std::uint64_t{0b111} << 30;
  EXPECT_EQ(clauses_of(predicate, last), one_bit<ClauseBits>(10));
  EXPECT_EQ(verdict_of(predicate, last), Verdict::separated);
  for (std::size_t i = 0; i < 33; ++i) {
    const auto alone = one_bit<ComparisonBits>(i), all = (std::uint64_t{1} << 33) - 1;
    EXPECT_EQ(verdict_of(predicate, alone), Verdict::contact) << i;
    EXPECT_EQ(clauses_of(predicate, all & ~alone), ((1u << 11) - 1) & ~one_bit<ClauseBits>(i / 3)) << i;
  }
}

TEST(Description, SixtyFourOfEachAndNoMore) {
  EXPECT_EQ(clauses_of(checked(toy(64, 64)), ~std::uint64_t{0}), (std::uint64_t{1} << 22) - 1);
  const auto columns = [] { return checked(toy(65, 1)); };
  EXPECT_THAT(columns, ThrowsMessage<HarnessFault>(HasSubstr("65 columns of entry 'numbers'; at most 64")));
  Predicate predicate = toy(1, 64);
  predicate.comparisons.push_back({"comparison64", 0});
  EXPECT_THAT([&] { return checked(predicate); }, ThrowsMessage<HarnessFault>(HasSubstr("65 comparisons; at most 64")));
}

TEST(Description, WhatContradictsItselfIsRefused) {
  const auto refused = [](const char* says, auto change) {
    Predicate predicate = toy(2, 4);
    change(predicate);
    EXPECT_THAT([&] { return checked(predicate); }, ThrowsMessage<HarnessFault>(HasSubstr(says)));
  };
  refused("no entry", [](Predicate& predicate) { predicate.entries.clear(); });
  refused("'column0' twice", [](Predicate& predicate) { predicate.entries[0].columns[1].name = "column0"; });
  refused("'a' twice among its groups of entry 'numbers'", [](Predicate& predicate) {
    predicate.entries[0].columns = {
        {"x", Role::length, "a"}, {"y", Role::length, "b"}, {"z", Role::length, "a"}};  // not neighbours
  });
  refused("'comparison1' twice", [](Predicate& predicate) { predicate.comparisons[0].name = "comparison1"; });
  refused("no name", [](Predicate& predicate) { predicate.measures[0].name = ""; });
  refused("which it does not have", [](Predicate& predicate) { predicate.comparisons[3].clause = 2; });
  refused("which does not need it", [](Predicate& predicate) { predicate.comparisons[3].clause = 0; });
}

TEST(Description, GroupsAreNeighbouringColumns) {
  const auto groups = groups_of(sphere_triangle_predicate().entries[0]);
  ASSERT_EQ(groups.size(), 5u);
  EXPECT_EQ(groups[3].name, "p");
  EXPECT_EQ(groups[3].first, 9u);
  EXPECT_EQ(groups[3].size, 3u);
  EXPECT_EQ(groups[4].name, "r");
  EXPECT_EQ(groups[4].size, 1u);
}

TEST(Description, ARuleOfItsOwnDecides) {
  Predicate predicate = toy(1, 6);
  predicate.rule = {"separated where the first comparison holds", [](std::uint64_t bits) { return (bits & 1) != 0; }};
  EXPECT_EQ(verdict_of(predicate, 0b000001), Verdict::separated);
  EXPECT_EQ(verdict_of(predicate, 0b111000), Verdict::contact);
}

TEST(Description, OfSphereTriangleSaysWhatItsNamesSay) {
  const Predicate& predicate = sphere_triangle_predicate();
  ASSERT_EQ(predicate.comparisons.size(), comparison_count);
  ASSERT_EQ(predicate.clauses.size(), axis_count);
  ASSERT_EQ(predicate.entries.size(), 1u);
  ASSERT_EQ(predicate.entries[0].columns.size(), coordinate_count);
  EXPECT_EQ(predicate.entries[0].columns[11].name, "pz");
  EXPECT_EQ(predicate.entries[0].columns[11].group, predicate.entries[0].columns[9].group);
  EXPECT_EQ(predicate.entries[0].columns[11].role, Role::coordinate);
  EXPECT_EQ(predicate.entries[0].columns[12].role, Role::length);
  for (std::uint32_t bits = 0; bits < 1u << comparison_count; ++bits) {
    const auto narrow = static_cast<ComparisonBits>(bits);
    ASSERT_EQ(clauses_of(predicate, bits), axes_of(narrow)) << bits;
    ASSERT_EQ(verdict_of(predicate, bits), verdict_of(axes_of(narrow))) << bits;
  }
}

TEST(Description, APredicateIsFoundByItsId) {
  EXPECT_EQ(&find_predicate("sphere-triangle"), &sphere_triangle_predicate());
  EXPECT_EQ(predicates().front(), &sphere_triangle_predicate());
  EXPECT_THAT([] { find_predicate("sphere-cone"); },
              ThrowsMessage<Error>("unknown predicate 'sphere-cone'; predicates: sphere-triangle, box-box, "
                                   "box-triangle, moving-sphere, capsule-triangle"));
  const Predicate other = toy(1, 1);
  const Predicate* const known[] = {&sphere_triangle_predicate(), &other};
  EXPECT_EQ(&find_predicate("toy", known), &other);
  EXPECT_EQ(find_entry(sphere_triangle_predicate(), ""), 0u);
  EXPECT_EQ(find_entry(toy(1, 1), "other"), 1u);
  EXPECT_THAT(
      [] { find_entry(toy(1, 1), "othr"); },
      ThrowsMessage<Error>("predicate 'toy': unknown entry 'othr'; did you mean 'other'? entries: other, numbers"));
}

TEST(Alike, TheNearestNameIsFirst) {
  EXPECT_THAT(most_alike_first("box-bx", {"sphere-triangle", "box-triangle", "box-box"}),
              ElementsAre("box-box", "box-triangle", "sphere-triangle"));
  EXPECT_THAT(most_alike_first("", {"b", "a"}), ElementsAre("b", "a"));
}

TEST(Alike, ANameIsMeantWhereFewLettersDiffer) {
  const std::vector<std::string_view> names = {"run", "report", "edge_ab.radius", "r", "id", "predicate"};
  for (const auto& [given, name] :
       std::initializer_list<std::pair<const char*, const char*>>{{"rum", "run"},
                                                                  {"runn", "run"},
                                                                  {"RUN", "run"},
                                                                  {"Id", "id"},
                                                                  {"repotr", "report"},
                                                                  {"edge_ab", "edge_ab.radius"},
                                                                  {"q", ""},
                                                                  {"ix", ""},
                                                                  {"", ""},
                                                                  {"frobnicate", ""}}) {
    EXPECT_EQ(meant(given, names), name) << given;
  }
  EXPECT_EQ(meant(std::string(1 << 20, 'r'), names), "");
}

TEST(Alike, AMessageNamesTheNearestFirst) {
  EXPECT_EQ(unknown_name("family", "families", "tangnet", {"general", "tangent"}),
            "unknown family 'tangnet'; did you mean 'tangent'? families: tangent, general");
  EXPECT_EQ(unknown_name("family", "families", "cube", {"general", "tangent"}),
            "unknown family 'cube'; families: general, tangent");
  EXPECT_EQ(unknown_name("family", "families", "tangent,general", {"general", "tangent"})
                .find("unknown family 'tangent,general'; one name is given at a time, without commas; families: "),
            0u);
}

TEST(Alike, OfMoreThanEightNamesTheNearestAreToldAndTheCommandThatListsAll) {
  const std::vector<std::string_view> eight = {"a", "b", "c", "d", "e", "f", "g", "tangent"};
  EXPECT_EQ(names_alike("families", "tangnet", eight, "axiscert families"), "families: tangent, a, e, g, b, c, d, f");
  std::vector<std::string_view> nine = eight;
  nine.push_back("h");
  EXPECT_EQ(unknown_name("family", "families", "tangnet", nine, "axiscert families"),
            "unknown family 'tangnet'; did you mean 'tangent'? the nearest of 9 families: tangent, a, e, g, b, c, d, "
            "f; `axiscert families` lists them");
}

}  // namespace
}  // namespace axiscert
