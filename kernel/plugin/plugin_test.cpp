// Plug-ins that misbehave, each in one way: what the supervisor tells of them, and that all else is answered rightly.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>

#include "kernel/ask.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"
#include "kernel/plugin/plugin_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using namespace plugin_testing;
using testing::HasSubstr;

std::string misbehaving_path(const std::string& name) { return fmt::format(BUILD_FOLDER "/misbehaving/{}.so", name); }
std::string misdeclared_path(const std::string& name) { return fmt::format(BUILD_FOLDER "/declarations/{}.so", name); }

SeenAnswers supervise(const std::string& name) {
  const Kernel& kernel = find_kernel("plugin:" + misbehaving_path(name));
  if (!kernel.has(Precision::binary32)) throw Error(kernel.id + ": not built");
  EXPECT_TRUE(kernel.findings.empty()) << kernel.findings.front().detail;
  return supervised(kernel);
}

TEST(Plugin, ACrashCostsItsQueryAlone) {
  const SeenAnswers seen = supervise("crash");
  const Finding finding = only_finding(seen);
  EXPECT_EQ(finding.kind, FindingKind::crash);
  EXPECT_EQ(finding.index, wrong_query);
  EXPECT_THAT(finding.detail, HasSubstr("SIGSEGV"));
  expect_right_but(seen, {wrong_query});
}

TEST(Plugin, AHangCostsItsQueryAlone) {
  const SeenAnswers seen = supervise("hang");
  const Finding finding = only_finding(seen);
  EXPECT_EQ(finding.kind, FindingKind::hang);
  EXPECT_EQ(finding.index, wrong_query);
  expect_right_but(seen, {wrong_query});
}

TEST(Plugin, LeavingTheProcessIsACrash) {
  const SeenAnswers seen = supervise("exits");
  ASSERT_FALSE(seen.findings.empty());
  EXPECT_EQ(seen.findings.front().kind, FindingKind::crash);
  EXPECT_THAT(seen.findings.front().detail, HasSubstr("exit code 0"));
}

TEST(Plugin, ASignalWithoutANameIsACrash) {
  const Finding finding = only_finding(supervise("real_time_signal"));
  EXPECT_EQ(finding.kind, FindingKind::crash);
  EXPECT_THAT(finding.detail, HasSubstr("signal "));
}

TEST(Plugin, AProcessThatItLeavesBehindHidesNoCrash) {
  const SeenAnswers seen = supervise("forks");
  const Finding finding = only_finding(seen);
  EXPECT_EQ(finding.kind, FindingKind::crash);
  EXPECT_THAT(finding.detail, HasSubstr("SIGABRT"));
  expect_right_but(seen, {wrong_query});
}

TEST(Plugin, ANameIsShownAsPrintableText) {
  EXPECT_EQ(find_kernel("plugin:" + misdeclared_path("strange_name")).summary, "caf\\xe9\\n");
}

TEST(Plugin, AFullStackIsSaid) {
  const SeenAnswers seen = supervise("stack_overflow");
  ASSERT_FALSE(seen.findings.empty());
  EXPECT_EQ(seen.findings.front().kind, FindingKind::crash);
  EXPECT_THAT(seen.findings.front().detail, HasSubstr("out of stack"));
}

TEST(Plugin, AWriteBeyondItsOutputIsFoundAndItsAnswersCount) {
  for (const char* name : {"out_of_bounds", "underrun"}) {
    SCOPED_TRACE(name);
    const SeenAnswers seen = supervise(name);
    const Finding finding = only_finding(seen);
    EXPECT_EQ(finding.kind, FindingKind::out_of_bounds);
    EXPECT_THAT(finding.detail, HasSubstr("verdict"));
    expect_right_but(seen, {});
  }
}

TEST(Plugin, AWriteFarAstrayReachesNoOtherArray) {
  const SeenAnswers seen = supervise("stray_write");
  ASSERT_FALSE(seen.findings.empty());
  EXPECT_EQ(seen.findings.front().kind, FindingKind::out_of_bounds);
  EXPECT_THAT(seen.findings.front().detail, HasSubstr("wrote verdict[101"));
}

TEST(Plugin, AWriteToAnInputIsFound) {
  const SeenAnswers seen = supervise("writes_input");
  ASSERT_FALSE(seen.findings.empty());
  EXPECT_EQ(seen.findings.front().kind, FindingKind::out_of_bounds);
  EXPECT_THAT(seen.findings.front().detail, HasSubstr("read-only"));
}

TEST(Plugin, RandomAnswersAreNondeterministic) {
  EXPECT_EQ(only_finding(supervise("random")).kind, FindingKind::nondeterministic);
}

TEST(Plugin, AnAnswerThatDependsOnWhatElseIsAskedIsFoundAndItsCauseNamed) {
  for (const auto& [name, says] : {std::tuple{"cached_axis", "it keeps state from call to call, as where an axis"},
                                   std::tuple{"state", "it keeps state from call to call, such as a counter"},
                                   std::tuple{"lane_leak", "its answer depends on its neighbour"}}) {
    const SeenAnswers seen = supervise(name);
    ASSERT_FALSE(seen.findings.empty()) << name;
    EXPECT_THAT(seen.findings.front().detail, HasSubstr(says)) << name;
  }
}

// The batch has no two triangles that begin alike but those that are put beside each other.
TEST(Plugin, AnAnswerOfTheNeighbourIsFoundWithTheBatchReversed) {
  const Kernel& kernel = find_kernel("plugin:" + misbehaving_path("neighbour"));
  QueryBatch<float> batch(64, coordinate_count);
  for (std::size_t i = 0; i < 64; ++i) {
    Numbers<float> numbers = queries()[i];
    numbers[0] = static_cast<float>(i / 2);
    numbers[12] = i % 2 == 0 ? 0.0f : 100.0f;  // one that touches nothing, and one that touches it
    batch.push_back(numbers);
  }
  Reply<float> reply;
  ask(kernel.on<float>(scalar_target), batch.columns(), reply);
  ASSERT_EQ(reply.watched.findings.size(), 1u);
  EXPECT_EQ(reply.watched.findings.front().kind, FindingKind::batch_dependent);
  EXPECT_THAT(reply.watched.findings.front().detail, HasSubstr("its answer depends on its neighbour"));
}

TEST(Plugin, AWrongLastLaneIsFoundThoughItsBatchIsOnlySometimesRagged) {
  const Finding finding = only_finding(supervise("last_lane"));
  EXPECT_EQ(finding.kind, FindingKind::batch_dependent);
  EXPECT_THAT(finding.detail, HasSubstr("as query"));
}

TEST(Plugin, AnswersThatDependOnAlignmentAreFound) {
  EXPECT_EQ(only_finding(supervise("alignment")).kind, FindingKind::batch_dependent);
}

TEST(Plugin, FlushToZeroLeftOnIsFound) {
  const SeenAnswers seen = supervise("flush_to_zero");
  const Finding finding = only_finding(seen);
  EXPECT_EQ(finding.kind, FindingKind::environment);
  EXPECT_THAT(finding.detail, HasSubstr("flushing"));
  expect_right_but(seen, {});
  EXPECT_EQ(seen.asked_again, queries().size());
}

TEST(Plugin, FlushToZeroTurnedOnByLoadingIsFound) {
  const Kernel& kernel = find_kernel("plugin:" + misbehaving_path("flush_at_load"));
  EXPECT_TRUE(kernel.has(Precision::binary32));
  ASSERT_EQ(kernel.findings.size(), 1u);
  EXPECT_EQ(kernel.findings[0].kind, FindingKind::environment);
  EXPECT_THAT(kernel.findings[0].detail, HasSubstr("flushing"));
}

TEST(Plugin, WhatIsNoVerdictIsNoAnswer) {
  const SeenAnswers seen = supervise("not_a_verdict");
  EXPECT_EQ(only_finding(seen).kind, FindingKind::inconsistent);
  EXPECT_GT(unanswered(seen), 0u);
}

TEST(Plugin, ComparisonsThatContradictTheVerdictAreFound) {
  EXPECT_EQ(only_finding(supervise("inconsistent")).kind, FindingKind::inconsistent);
}

TEST(Plugin, WhatCannotBeLoadedIsAKernelWithAFinding) {
  for (const auto& [name, kind, says] : {std::tuple{"wrong_abi", FindingKind::abi, "version"},
                                         std::tuple{"no_symbol", FindingKind::load, "axiscert_plugin"},
                                         std::tuple{"conforms_elsewhere", FindingKind::load, "binary32"}}) {
    const Kernel& kernel = find_kernel("plugin:" + misdeclared_path(name));
    EXPECT_FALSE(kernel.has(Precision::binary32) || kernel.has(Precision::binary64));
    ASSERT_EQ(kernel.findings.size(), 1u);
    EXPECT_EQ(kernel.findings[0].kind, kind);
    EXPECT_THAT(kernel.findings[0].detail, HasSubstr(says));
  }
}

TEST(Plugin, AFileThatIsNoneIsRefused) {
  EXPECT_THROW(find_kernel("plugin:/nosuch.so"), Error);
  const TemporaryFolder folder;
  const Kernel& kernel = find_kernel("plugin:" + folder.write("text.so", "not a shared object\n"));
  ASSERT_EQ(kernel.findings.size(), 1u);
  EXPECT_EQ(kernel.findings[0].kind, FindingKind::load);
}

// The process that answers unwatched questions is another one, and comes again after every stop.
TEST(Plugin, UnwatchedQuestionsAreAnsweredTooAndACrashIsNoAnswer) {
  const Implementation<float> crash = find_kernel("plugin:" + misbehaving_path("crash")).on<float>(scalar_target);
  std::vector<Verdict> verdicts(queries().size());
  for (int repetition = 0; repetition < 2; ++repetition) {
    crash.verdicts(queries().columns(), verdicts.data());
    expect_right_but({verdicts, {}}, {wrong_query});
  }
}

// What each plug-in of promises/ says of itself and answers, so that a test of a gate asks what it means to ask.
TEST(Plugin, ThoseWithPromisesKeepOrBreakThemAsTheyAreNamed) {
  constexpr auto contact = Verdict::contact, separated = Verdict::separated, undecided = Verdict::undecided,
                 invalid = Verdict::invalid, unanswered = Verdict::unanswered;
  // The answers that are not those of a right kernel, and how many of these there may be among the 1,021.
  struct Kind {
    std::string_view name;
    bool may_decline;
    std::vector<std::pair<Verdict, Verdict>> instead;  // right, answered
    std::size_t least, most;
  };
  const std::vector<std::pair<Verdict, Verdict>> declined = {{contact, undecided}, {separated, undecided}};
  const Kind kinds[] = {
      {"keeps_its_promise", false, {}, 0, 0},
      {"declines", false, declined, 30, 100},
      {"declines_declared", true, declined, 30, 100},
      {"declines_contacts", true, {{contact, undecided}}, 20, 100},
      {"declines_separations", true, {{separated, undecided}}, 900, 1001},
      {"one_size", true, declined, 1, 900},
      {"answers_invalid", false, {{contact, invalid}, {separated, invalid}}, 30, 100},
      {"answers_77", false, {{contact, unanswered}, {separated, unanswered}}, 1021, 1021},
      {"always_contact", false, {{separated, contact}}, 900, 1001},
      {"limited_to_nothing", false, {{contact, separated}}, 20, 100},
      {"limited_to_far", false, {}, 0, 0},
      {"front_alone", false, {{contact, separated}}, 5, 100},
      {"with_margin", false, {{separated, contact}}, 1, 100},
  };
  const std::vector<Verdict> right = right_verdicts();
  for (const Kind& kind : kinds) {
    SCOPED_TRACE(kind.name);
    const Kernel& kernel = find_kernel(fmt::format("plugin:" BUILD_FOLDER "/promises/{}.so", kind.name));
    EXPECT_TRUE(kernel.findings.empty());
    EXPECT_EQ(kernel.may_decline, kind.may_decline);
    EXPECT_EQ(kernel.limits.sides == SidesPolicy::front, kind.name == "front_alone");
    EXPECT_EQ(kernel.limits.margin, kind.name == "with_margin" ? 0.0625 : 0);
    EXPECT_EQ(kernel.limits.least_radius != 0, kind.name.starts_with("limited_"));
    const std::vector<Verdict> answers = supervised(kernel).verdicts;
    std::size_t others = 0;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      if (answers[i] == right[i]) continue;
      ++others;
      EXPECT_THAT(kind.instead, testing::Contains(std::pair(right[i], answers[i]))) << i;
    }
    EXPECT_GE(others, kind.least);
    EXPECT_LE(others, kind.most);
  }
  const Kernel& wide = find_kernel("plugin:" BUILD_FOLDER "/promises/binary64_alone.so");
  EXPECT_TRUE(wide.has(Precision::binary64) && !wide.has(Precision::binary32));
}

// Nothing else is asked of a plug-in that stops again and again, and what was not asked is not answered.
TEST(Plugin, AfterManyStopsNothingIsAsked) {
  const SeenAnswers seen = supervise("exits");
  EXPECT_LE(seen.findings.size(), 16u);
}

}  // namespace
}  // namespace axiscert
