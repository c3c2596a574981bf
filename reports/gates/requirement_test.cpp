// Records that each level of --require accepts and refuses.
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

std::vector<std::string> texts(const Json& record, const std::string& level) {
  std::vector<std::string> lines;
  for (const Failure& failure : unmet(record, level)) lines.push_back(failure.text());
  return lines;
}

Json with_links(const std::string& link, std::uint64_t count) {
  Json record = stored_record();
  record["kernels"].erase(1);
  Json& links = tangent_counts(record)["verdict"]["links"];
  for (Json& n : links) n = 0;
  links[link] = count;
  return record;
}

TEST(Requirement, LogicAsksForNoSpecificationOrImplementationLink) {
  EXPECT_EQ(unmet(with_links("specification", 5), "logic").size(), 1u);
  EXPECT_EQ(unmet(with_links("implementation", 5), "logic").size(), 1u);
  EXPECT_TRUE(unmet(with_links("rounding", 5), "logic").empty());
  EXPECT_TRUE(unmet(with_links("range", 5), "logic").empty());
}

TEST(Requirement, RangeAsksForNoRangeLinkEither) {
  EXPECT_EQ(unmet(with_links("specification", 5), "range").size(), 1u);
  EXPECT_EQ(unmet(with_links("range", 5), "range").size(), 1u);
  EXPECT_TRUE(unmet(with_links("rounding", 5), "range").empty());
}

TEST(Requirement, LogicJudgesAKernelOfVerdictsByExactArithmeticTouchingApart) {
  Json record = stored_record();
  record["kernels"].erase(0);
  // 4 + 1 wrong verdicts on `lattice`, 3 of them touching; `tangent` rounds and does not count. The witness is the
  // deeper of those that do not touch.
  EXPECT_EQ(texts(record, "logic"),
            (std::vector<std::string>{"<script> binary32 on lattice: answers `invalid` to valid queries: 1",
                                      "<script> binary32 on lattice: wrong verdicts in exact "
                                      "arithmetic, touching ones not counted: 2 (witness w5)"}));
  record["kernels"][0]["families"]["lattice"]["verdict"]["touching_flips"] = 5;
  record["kernels"][0]["families"]["lattice"]["verdict"]["invalid"] = 0;
  EXPECT_TRUE(unmet(record, "logic").empty());
}

TEST(Requirement, FailureSaysWhoWhereHowOftenAndShowsOne) {
  EXPECT_EQ(texts(stored_record(), "logic").front(),
            "published binary32 on tangent: wrong verdicts with a broken implementation link: 2 (witness w2)");
}

TEST(Requirement, ExactAsksForNoWrongVerdict) {
  EXPECT_EQ(texts(stored_record(), "exact"),
            (std::vector<std::string>{"published binary32 on tangent: missed contacts: 40 (witness w2)",
                                      "published binary32 on tangent: phantom contacts: 20 (witness w1)",
                                      "<script> binary32 on lattice: answers `invalid` to valid queries: 1",
                                      "<script> binary32 on tangent: missed contacts: 7",
                                      "<script> binary32 on lattice: missed contacts: 4 (witness w4)",
                                      "<script> binary32 on lattice: phantom contacts: 1 (witness w5)"}));
}

TEST(Requirement, ConservativeAllowsPhantomContactsUpToItsDepth) {
  Json record = stored_record();
  record["kernels"].erase(1);
  tangent_counts(record)["verdict"]["false_separation"] = 0;
  EXPECT_TRUE(unmet(record, "conservative").empty());
  EXPECT_TRUE(unmet(record, "conservative=0.125").empty());
  const auto failures = unmet(record, "conservative=0.1");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].count, 20u);
  EXPECT_EQ(failures[0].witness, "w1");
  EXPECT_THAT(failures[0].what, HasSubstr("0.125"));
}

TEST(Requirement, ConservativeAllowsNoMissedContact) {
  const auto failures = unmet(stored_record(), "conservative");
  ASSERT_EQ(failures.size(), 4u);  // and the kernel that answers `invalid` to a valid query
  EXPECT_EQ(failures[0].count, 40u);
}

TEST(Requirement, UnknownLevelIsAnErrorThatListsTheLevels) {
  for (const char* text : {"", "exakt", "logic ", "conservative0.1"}) {
    try {
      parse_level(text);
      ADD_FAILURE() << "accepted '" << text << "'";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("logic, range, exact, conservative[=D], depth=D, decided=SHARE"));
    }
  }
}

TEST(Requirement, DepthHasToBeANumberFromZeroOn) {
  for (const std::string level : {"conservative", "depth"}) {
    for (const char* argument : {"=", "=-1", "=nan", "=0.1x", "= 1"})
      EXPECT_THROW(parse_level(level + argument), Error) << level << argument;
    EXPECT_EQ(depth_argument(parse_level(level + "=1e-3")), 0.001);
    EXPECT_EQ(depth_argument(parse_level(level + "=0")), 0);
  }
  EXPECT_THROW(parse_level("depth"), Error);
  EXPECT_THROW(parse_level("logic=1"), Error);
  EXPECT_THROW(parse_level("no-worse-than="), Error);
}

TEST(Requirement, DepthAllowsWrongVerdictsUpToItEitherWay) {
  Json record = stored_record();
  record["kernels"].erase(1);
  EXPECT_TRUE(unmet(record, "depth=0.25").empty());
  EXPECT_EQ(
      texts(record, "depth=0.2"),
      std::vector<std::string>{"published binary32 on tangent: missed contacts, the deepest by 0.25 of the scene: "
                               "0.2 is allowed: 40 (witness w2)"});
  EXPECT_EQ(unmet(record, "depth=0.1").size(), 2u) << "phantom contacts too";
}

}  // namespace
}  // namespace axiscert
