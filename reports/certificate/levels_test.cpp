// A certificate calls proved only what the theory states, and a level met only where the search found nothing against
// it.
#include "fuzz/text/json.h"
#include "reports/certificate/levels.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>

#include "fuzz/text/file_bytes.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"

namespace axiscert {
namespace {

TEST(ProvedLevels, NameTheoremsOfTheTheoryAndSectionsOfTheDocument) {
  const std::string theory = read_bytes(SOURCE_FOLDER "/proofs/theorems.txt");
  const std::string document = read_bytes(SOURCE_FOLDER "/docs/proofs.md");
  for (const std::string kernel : {"certified", "conservative"}) {
    const std::string text = proved_at(kernel, parse_level("conservative"));
    const std::regex theorem("[a-z0-9]+(_[a-z0-9]+)+");
    std::size_t theorems = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), theorem); at != std::sregex_iterator(); ++at, ++theorems) {
      EXPECT_NE(theory.find(fmt::format("\n{} ", at->str())), theory.npos) << at->str();
      EXPECT_NE(document.find(at->str()), document.npos) << at->str();
    }
    EXPECT_GE(theorems, 2u) << text;
    // A proof has a range, and the rest is said to be argued.
    EXPECT_THAT(text, testing::StartsWith("where "));
    EXPECT_THAT(text, testing::HasSubstr("argued"));
  }
}

TEST(ProvedLevels, NothingElseIsProved) {
  for (const std::string level : {"invariant=order", "no-worse-than=published", "never-late", "decided=0.9"})
    EXPECT_EQ(proved_at("certified", parse_level(level)), "") << level;
  for (const std::string level : {"exact", "depth=0.001", "conservative=0.001", "logic"})
    EXPECT_EQ(proved_at("conservative", parse_level(level)), "") << level;
  EXPECT_EQ(proved_at("published", parse_level("conservative")), "");
}

// The levels of `published` in binary32 that are about verdicts, on a run that saw no wrong one, beside a search's
// finds.
std::map<std::string, LevelStatement> levels_beside(const std::string& goal = "", const std::string& depth = "",
                                                    std::uint64_t phantoms_looked_for = 1000) {
  Json record = stored_record();
  record["kernels"][0]["families"].erase("tangent");
  NamedValues<SearchedStatement> searches;
  SearchedStatement& search = searches.put("binary32");
  search.evaluations = 12345;
  search.looked_at.put("missed_contact") = 1000;
  search.looked_at.put("phantom_contact") = phantoms_looked_for;
  if (!goal.empty()) search.finds.put(goal).emplace().depth = depth;
  std::map<std::string, LevelStatement> levels;
  for (const LevelStatement& level : levels_of(edited(record), "published", searches)) {
    if (level.precision == Precision::binary32) levels[level.level] = level;
  }
  return levels;
}
// A page does not say that a level of units is met, and that the kernel depends on the unit.
TEST(LevelsBesideADiagnosis, AreNotMetWhereItFoundANumberOfTheKernelsOwn) {
  const auto state_beside = [](const char* value) {
    DiagnosedStatement like;
    like.properties.push_back({"absolute_threshold", value, "the distance d near 0.01", 1});
    std::vector<LevelStatement> found;
    for (const LevelStatement& level : levels_of(edited(stored_record()), "published", {}, std::span(&like, 1))) {
      if (level.level == "invariant=scale" && level.precision == Precision::binary32) found.push_back(level);
    }
    return found.at(0);
  };
  EXPECT_EQ(state_beside("none_found").failure_count, 0u);
  const LevelStatement level = state_beside("present");
  EXPECT_EQ(level.state, LevelState::not_met);
  EXPECT_EQ(level.failure_count, 1u);
  EXPECT_THAT(level.failures.at(0), testing::HasSubstr("the diagnosis found otherwise: the distance d near 0.01"));
}

std::vector<std::string> not_met_beside(const std::string& goal, const std::string& depth) {
  std::vector<std::string> not_met;
  for (const auto& [name, level] : levels_beside(goal, depth)) {
    if (level.state == LevelState::not_met) not_met.push_back(name);
  }
  return not_met;
}

TEST(LevelsBesideASearch, AreMetWhereItFoundNothing) {
  const auto levels = levels_beside();
  for (const char* name : {"exact", "conservative", "conservative=0.001", "depth=0.001"}) {
    const LevelStatement& level = levels.at(name);
    EXPECT_EQ(level.state, LevelState::met) << name;
    EXPECT_EQ(level.failure_count, 0u) << name;
    ASSERT_EQ(level.rests_on.size(), 2u) << name;
    EXPECT_EQ(level.rests_on[0].kind, Ground::observed);
    EXPECT_THAT(level.rests_on[1].text, testing::HasSubstr("12,345 evaluations"));
  }
}

TEST(LevelsBesideASearch, RestOnNoneThatDecidedNothing) {
  const auto levels = levels_beside("", "", 0);
  EXPECT_EQ(levels.at("exact").state, LevelState::met);
  EXPECT_EQ(levels.at("exact").rests_on.size(), 1u);
  EXPECT_EQ(levels.at("conservative").rests_on.size(), 2u) << "which allows phantoms";
}

// `conservative=D` allows no missed contact at all, and phantoms up to D deep; `depth=D` both up to D.
TEST(LevelsBesideASearch, AreNotMetWhereItFoundAWrongVerdictThatIsTooDeep) {
  using testing::ElementsAre;
  EXPECT_THAT(not_met_beside("missed_contact", "0.01"),
              ElementsAre("conservative", "conservative=0.001", "depth=0.001", "exact"));
  EXPECT_THAT(not_met_beside("missed_contact", "0.0001"), ElementsAre("conservative", "conservative=0.001", "exact"));
  EXPECT_THAT(not_met_beside("phantom_contact", "0.01"), ElementsAre("conservative=0.001", "depth=0.001", "exact"));
  EXPECT_THAT(not_met_beside("phantom_contact", "0.0001"), ElementsAre("exact"));
  const LevelStatement level = levels_beside("missed_contact", "0.01").at("exact");
  EXPECT_EQ(level.failure_count, 1u);
  EXPECT_THAT(level.failures, ElementsAre("the search found a missed contact of depth 0.01 of the scene"));
  EXPECT_TRUE(level.rests_on.empty());
}

}  // namespace
}  // namespace axiscert
