// A certificate calls proved only what the theory states.
#include "reports/certificate/findings/levels.h"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <regex>

#include "fuzz/text/file_bytes.h"

namespace axiscert {
namespace {

TEST(ProvedLevels, NameTheoremsOfTheTheoryAndSectionsOfTheDocument) {
  const std::string theory = read_bytes(SOURCE_FOLDER "/proofs/coq/Assumptions.expected") +
                             read_bytes(SOURCE_FOLDER "/proofs/coq/Statements.expected");
  const std::string document = read_bytes(SOURCE_FOLDER "/docs/proofs.md");
  for (const std::string kernel : {"certified", "conservative"}) {
    const std::string text = proved_at(kernel, "conservative");
    const std::regex theorem("[a-z0-9]+(_[a-z0-9]+)+");
    std::size_t theorems = 0;
    for (std::sregex_iterator at(text.begin(), text.end(), theorem); at != std::sregex_iterator(); ++at, ++theorems) {
      EXPECT_NE(theory.find(fmt::format("== \"{}\"", at->str())), theory.npos) << at->str();
      EXPECT_NE(document.find(at->str()), document.npos) << at->str();
    }
    EXPECT_GE(theorems, 2u) << text;
    // A proof has a range, and the rest is said to be argued.
    EXPECT_THAT(text, testing::StartsWith("where "));
    EXPECT_THAT(text, testing::HasSubstr("on paper"));
  }
}

TEST(ProvedLevels, NothingElseIsProved) {
  for (const std::string level : {"invariant=order", "no-worse-than=published", "never-late", "exactly"})
    EXPECT_EQ(proved_at("certified", level), "") << level;
  for (const std::string level : {"exact", "depth=0.001", "conservative=0.001", "logic"})
    EXPECT_EQ(proved_at("conservative", level), "") << level;
  EXPECT_EQ(proved_at("published", "conservative"), "");
}

}  // namespace
}  // namespace axiscert
