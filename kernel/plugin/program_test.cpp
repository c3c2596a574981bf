// Programs as kernels: those that answer, and those that misbehave, each in one way; what is told of them, that all
// else is answered rightly, and that no process is left.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "kernel/ask.h"
#include "kernel/base/error.h"
#include "kernel/base/folders.h"
#include "kernel/plugin/load.h"
#include "kernel/plugin/plugin_testing.h"
#include "kernel/plugin/supervisor.h"

namespace axiscert {
namespace {

using namespace plugin_testing;
using testing::HasSubstr;

// A folder with the program of the tests, so that its processes can be told from those of other tests.
class Program : public testing::Test {
 protected:
  Program() { std::filesystem::copy(BUILD_FOLDER "/programs/program", folder_.path() / "program"); }
  ~Program() override {
    EXPECT_THAT(left_processes(), testing::IsEmpty());
    plugin::batch_seconds = seconds_before_;
  }

  std::string wrote(const std::string& name, const std::string& text) const {
    return "program:" + folder_.write(name, text);
  }
  // `command`: JSON; `more`: members, each with a comma before it.
  const Kernel& manifest(const std::string& command, const std::string& more = "") const {
    static int number = 0;
    return find_kernel(wrote(fmt::format("m{}.json", ++number),
                             fmt::format(R"({{"format":"axiscert-program/2","name":"tested","precisions":["binary32"],)"
                                         R"("command":{}{}}})",
                                         command, more)));
  }
  const Kernel& kernel(const std::string& how, const std::string& more = "") const {
    return manifest(fmt::format(R"(["./program","{}"])", how), more);
  }
  SeenAnswers seen(const std::string& how, const std::string& more = "") const { return supervised(kernel(how, more)); }
  // The one finding of a program that misbehaves on one query, all others of which are answered rightly.
  Finding at_wrong_query(const std::string& how) const {
    const SeenAnswers all = seen(how);
    const Finding finding = only_finding(all);
    EXPECT_EQ(finding.index, wrong_query);
    expect_right_but(all, {wrong_query});
    EXPECT_THAT(left_processes(), testing::IsEmpty()) << how;
    return finding;
  }

  std::vector<std::string> left_processes() const {
    std::vector<std::string> left;
    for (const auto& entry : std::filesystem::directory_iterator("/proc")) {
      std::error_code gone;
      const auto runs = std::filesystem::read_symlink(entry.path() / "exe", gone);
      if (!gone && runs.string().starts_with(folder_.path().string() + "/")) left.push_back(entry.path().filename());
    }
    return left;
  }
  std::string text_of(const std::string& name) const {
    std::ostringstream text;
    text << std::ifstream(folder_.path() / name).rdbuf();
    return text.str();
  }

  const TemporaryFolder folder_;
  const double seconds_before_ = plugin::batch_seconds;
};

TEST_F(Program, AnswersAsTheKernelThatItImitatesInOneProcessOrInOneForEachBatch) {
  for (const char* how : {"right", "once", "stays"}) {
    const Kernel& own = kernel(how, R"(,"exposes":"comparisons","conforms_to":"published")");
    const SeenAnswers all = supervised(own);
    EXPECT_TRUE(all.findings.empty()) << how << ": " << all.findings.front().detail;
    Reply<float> reply, published;
    ask(own.on<float>(scalar_target), queries().columns(), reply);
    ask(find_kernel("published").on<float>(scalar_target), queries().columns(), published);
    EXPECT_EQ(reply.verdicts, published.verdicts);
    EXPECT_EQ(reply.answers.bits, published.answers.bits);
  }
}

TEST_F(Program, SaysOfItselfWhatItsManifestDeclares) {
  const Kernel& own = kernel("right", R"(,"summary":"a mesh","package":"engine","version":"1.2","touching":"either")");
  EXPECT_EQ(own.declared_name, "tested");
  EXPECT_EQ(own.summary, "tested: a mesh (engine 1.2)");
  EXPECT_EQ(own.touching, TouchingPolicy::either);
  EXPECT_EQ(own.exposes, Exposure::verdict);
  EXPECT_FALSE(own.may_decline);
  EXPECT_TRUE(kernel("right", R"(,"may_decline":true)").may_decline);
  EXPECT_TRUE(own.has(Precision::binary32));
  EXPECT_FALSE(own.has(Precision::binary64));
}

TEST_F(Program, IsNotStartedBeforeItIsAsked) {
  const Kernel& own = manifest(R"(["/bin/sh","-c","touch started; exec ./program right"])");
  EXPECT_FALSE(std::filesystem::exists(folder_.path() / "started"));
  EXPECT_TRUE(supervised(own).findings.empty());
  EXPECT_TRUE(std::filesystem::exists(folder_.path() / "started"));
}

TEST_F(Program, HasNoDescriptorButItsThreePipes) {
  EXPECT_TRUE(
      supervised(manifest(R"(["/bin/sh","-c","echo /proc/$$/fd/* > fds; exec ./program right"])")).findings.empty());
  const std::string fds = text_of("fds");
  // The fourth is the shell's own, for the folder that it lists.
  EXPECT_EQ(std::count(fds.begin(), fds.end(), '/'), 4 * 4) << fds;
}

TEST_F(Program, ACrashCostsItsQueryAloneWhetherRepliesAreKeptBackOrNot) {
  for (const char* how : {"crash", "kept-crash"}) {
    const Finding finding = at_wrong_query(how);
    EXPECT_EQ(finding.kind, FindingKind::crash);
    EXPECT_EQ(finding.detail, "SIGSEGV (Segmentation fault)");
  }
}

TEST_F(Program, AnExitBeforeTheEndIsACrashThatSaysWhatStandardErrorSays) {
  EXPECT_EQ(at_wrong_query("exits").detail, "it ended with exit code 0");
  EXPECT_EQ(at_wrong_query("exits-3").detail, "it ended with exit code 3; on standard error: Error: no such shape");
}

TEST_F(Program, ACrashOnItsThousandthQueryIsFoundAndTheRunGoesOn) {
  const SeenAnswers all = seen("crash-1000");
  ASSERT_FALSE(all.findings.empty());
  for (const Finding& finding : all.findings) EXPECT_EQ(finding.kind, FindingKind::crash);
  EXPECT_THAT(all.findings.front().detail, HasSubstr("SIGSEGV"));
  expect_right_but(all, {});
}

TEST_F(Program, AHangIsMeasuredByTheProcessorTimeOfAllItsProcesses) {
  plugin::batch_seconds = 0.5;
  EXPECT_EQ(at_wrong_query("spin").detail, "no answer within 0.05 s");
  EXPECT_EQ(at_wrong_query("spinning-child").kind, FindingKind::hang);
}

TEST_F(Program, OneThatSleepsAndIgnoresSignalsIsKilledWithWhatItStarted) {
  plugin::batch_seconds = 0.2;
  EXPECT_EQ(at_wrong_query("deaf").kind, FindingKind::hang);
}

TEST_F(Program, AProcessThatItLeavesBehindHidesNoCrashAndIsKilled) {
  const Finding finding = at_wrong_query("forks");
  EXPECT_EQ(finding.kind, FindingKind::crash);
  EXPECT_THAT(finding.detail, HasSubstr("SIGABRT"));
}

TEST_F(Program, MuchOnStandardErrorIsReadAndOnlyItsEndKept) {
  const Finding finding = at_wrong_query("chatter-1000000");
  EXPECT_EQ(finding.detail, "it ended with exit code 1; on standard error: the last word");
}

TEST_F(Program, TooFewRepliesAreAnExitBeforeTheEnd) {
  const SeenAnswers all = seen("too-little");
  ASSERT_FALSE(all.findings.empty());
  EXPECT_LE(all.findings.size(), 16u);
  EXPECT_EQ(all.findings.front().kind, FindingKind::crash);
  EXPECT_EQ(all.findings.front().index, queries().size() - 1);
}

TEST_F(Program, WhatIsNoReplyIsFoundAndQuoted) {
  for (const auto& [how, says] :
       {std::tuple{"too-much", "after its last reply it wrote more"},
        std::tuple{"text", R"(but with "engine 1.0 loaded")"}, std::tuple{"garbage", "its reply has flags 0xee"},
        std::tuple{"wrong-header", "it changed the header of its queries, at byte 40"},
        std::tuple{"no-verdict", "7, which is no verdict"}}) {
    const SeenAnswers all = seen(how);
    ASSERT_FALSE(all.findings.empty()) << how;
    EXPECT_EQ(all.findings.front().kind, FindingKind::inconsistent) << how;
    EXPECT_THAT(all.findings.front().detail, HasSubstr(says));
  }
  EXPECT_THAT(seen("no-bits", R"(,"exposes":"comparisons")").findings.front().detail, HasSubstr("no comparison bits"));
}

TEST_F(Program, OneThatWritesNothingIsACrash) {
  const SeenAnswers all = seen("nothing");
  ASSERT_FALSE(all.findings.empty());
  EXPECT_EQ(all.findings.front().kind, FindingKind::crash);
  EXPECT_EQ(unanswered(all), queries().size());
}

TEST_F(Program, AnEndThatIsNoSuccessAfterAllRepliesIsFound) {
  const SeenAnswers all = seen("once-badly");
  ASSERT_FALSE(all.findings.empty());
  EXPECT_THAT(all.findings.front().detail, HasSubstr("exit code 4"));
}

TEST_F(Program, AnswersThatChangeAreFound) {
  EXPECT_EQ(only_finding(seen("changes")).kind, FindingKind::nondeterministic);
  EXPECT_EQ(only_finding(seen("first-differs")).kind, FindingKind::batch_dependent);
}

std::string refusal(const std::function<void()>& refused) {
  try {
    refused();
  } catch (const Error& error) {
    return error.what();
  }
  return "it was accepted";
}

TEST_F(Program, WhatFailsAtOnceIsRefusedInOneLine) {
  EXPECT_THAT(refusal([&] { seen("fails"); }),
              HasSubstr("exit code 1; on standard error: Error: Cannot find package 'engine'"));
  EXPECT_THAT(refusal([&] { manifest(R"(["./nosuch"])"); }), HasSubstr("\"command\": ./nosuch is not there"));
  EXPECT_THAT(refusal([&] { manifest(R"(["program"])"); }),
              HasSubstr("is not installed; a file beside the manifest is ./program"));
  EXPECT_THAT(refusal([&] { find_kernel("program:/nosuch.json"); }), HasSubstr("there is no such file"));
  EXPECT_THAT(refusal([&] { find_kernel(wrote("other.json", "{}")); }), HasSubstr("not a manifest"));
  EXPECT_THAT(refusal([&] { kernel("right", R"(,"predicate":"sphere-cube")"); }),
              HasSubstr("unknown predicate 'sphere-cube'"));
}

TEST_F(Program, ComparisonsOfAnotherPredicateNameABuiltInKernelOfIt) {
  EXPECT_THAT(
      refusal([&] { kernel("right", R"(,"predicate":"box-box","exposes":"comparisons")"); }),
      testing::EndsWith(": it exposes comparisons of box-box: give `formulae` or `conforms_to` a built-in kernel "
                        "of it that has comparisons"));
}

}  // namespace
}  // namespace axiscert
