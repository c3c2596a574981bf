// Output of `check` and `run` for somebody else's kernel.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <sstream>

#include "cli/commands/check_output.h"
#include "cli/commands/run_output.h"
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/text/json.h"
#include "kernel/base/folders.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

const Query<float> apart{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, 0.5},
    touching{{1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 0, 0}, 1};

void no_fault(const Query<double>&, std::size_t, Verdict&, std::vector<Finding>&) {}
void crash(const Query<double>&, std::size_t i, Verdict& verdict, std::vector<Finding>& findings) {
  verdict = Verdict::unanswered;
  findings.push_back({FindingKind::crash, i, "signal 11"});
}

std::string line_of(const Kernel& kernel, const Query<float>& q) {
  return check_text("q", kernel, checked_of(*kernel.predicate, Examiner(kernel, scalar_target).examine(q)));
}

TEST(CheckOutput, NoAnswerIsSaidWithTheFinding) {
  const Kernel kernel = supervised_kernel("mine", crash);
  EXPECT_EQ(line_of(kernel, apart),
            "q: exact separated, mine gave no answer (a fault: the query is valid); crash: signal 11");
  const CheckLine line =
      check_line("q", kernel, checked_of(*kernel.predicate, Examiner(kernel, scalar_target).examine(apart)));
  EXPECT_EQ(line.computed.verdict, Verdict::unanswered);
  EXPECT_FALSE(line.computed.comparisons.has_value());
  ASSERT_EQ(line.findings.size(), 1u);
  EXPECT_EQ(line.findings[0].kind, FindingKind::crash);
  EXPECT_TRUE(line.flips.empty());
}

// A kernel that crashed is started again for the next query.
TEST(CheckOutput, TheQueryAfterACrashIsAnswered) {
  int begun = 0;
  Kernel kernel = black_box("mine", [](const Query<double>& q, auto, Verdict& verdict, auto&) {
    if (q.r == 1) verdict = Verdict::unanswered;
  });
  kernel.binary32 = [&begun, inner = kernel.binary32](std::string_view target) {
    ++begun;
    return inner(target);
  };
  Examiner examiner(kernel, scalar_target);
  for (const Query<float>& q : {apart, apart, touching, apart, apart}) examiner.examine(q);
  EXPECT_EQ(begun, 2);
}

TEST(CheckOutput, TouchingIsByTheKernelsConvention) {
  Kernel kernel = black_box("mine", no_fault);
  EXPECT_EQ(line_of(kernel, touching), "q: exact contact (touching), mine contact");
  kernel.touching = TouchingPolicy::either;
  EXPECT_EQ(line_of(kernel, touching), "q: exact contact (touching, where mine may say either), mine contact");
  kernel.touching = TouchingPolicy::separated;
  EXPECT_EQ(line_of(kernel, touching),
            "q: exact contact (touching, which mine calls separated), mine contact, wrong by 0 of the scene; verdict "
            "false_contact [unattributed]");
}

TEST(CheckOutput, AQueryWithoutAVerdictSaysWhatThatMeans) {
  const auto saying = [](Verdict said) {
    return black_box("mine", [said](const Query<double>&, auto, Verdict& verdict, auto&) { verdict = said; });
  };
  const auto standing = [](const Kernel& kernel) {
    return check_line("q", kernel, checked_of(*kernel.predicate, Examiner(kernel, scalar_target).examine(apart)))
        .standing;
  };
  Kernel declining = saying(Verdict::undecided);
  EXPECT_EQ(line_of(declining, apart),
            "q: exact separated, mine undecided (a fault: it does not declare that it may decline)");
  EXPECT_EQ(standing(declining), "undeclared_decline");
  declining.may_decline = true;
  EXPECT_EQ(line_of(declining, apart), "q: exact separated, mine undecided (it declines)");
  EXPECT_EQ(standing(declining), "declined");
  EXPECT_EQ(line_of(saying(Verdict::invalid), apart), "q: exact separated, mine invalid (a fault: the query is valid)");
  EXPECT_EQ(standing(saying(Verdict::invalid)), "called_invalid");
  EXPECT_EQ(standing(saying(Verdict::separated)), "decided");
}

TEST(CheckOutput, OutsideTheLimitsIsSaid) {
  Kernel kernel = black_box("mine", no_fault);
  kernel.limits.greatest_coordinate = 1;
  EXPECT_EQ(line_of(kernel, apart), "q: exact separated, mine separated (outside the limits that it declares)");
}

TEST(BriefOutput, LevelsOfOneOutcomeAreOneLineAndNameTheirPrecisionsWhereTheseDiffer) {
  const auto outcome = [](const char* level, const char* precision, LevelState state, const char* reason = "") {
    LevelOutcome one;
    one.asked = parse_level(level);
    one.kernel = "mine";
    one.precision = precision;
    one.state = state;
    one.reason = reason;
    return one;
  };
  using enum LevelState;
  std::vector<LevelOutcome> all = {outcome("depth=1mm", "binary32", not_met),
                                   outcome("depth=1mm", "binary64", met),
                                   outcome("logic", "binary32", not_met),
                                   outcome("logic", "binary64", not_met),
                                   outcome("early=1mm", "binary32", not_checked, "no times"),
                                   outcome("early=1mm", "binary64", not_checked, "no times")};
  all[4].is_allowed = all[5].is_allowed = true;
  all[0].failures = {{"mine", "binary32", "scene-walk", 3, "missed contacts, the deepest 2 mm", ""},
                     {"mine", "binary32", "scene-edge", 1027, "missed contacts, the deepest 1.1 mm", ""}};
  const BriefOutcomes brief = brief_outcomes(all);
  EXPECT_THAT(brief.failing, testing::ElementsAre("mine: not met: depth=1mm in binary32, logic; most on scene-edge: "
                                                  "1,027 missed contacts"));
  EXPECT_THAT(brief.passing, testing::ElementsAre("mine: met: depth=1mm in binary64",
                                                  "mine: NOT CHECKED, which is allowed: early=1mm: no times"));
}

TEST(RunOutput, FindingsStandFirstThenWhatWasJudged) {
  const Kernel bad = supervised_kernel("plugin:x.so", crash),
               gone = unloadable_kernel("plugin:gone.so", "no such file");
  Kernel limited = black_box("plugin:box.so", no_fault);
  limited.limits.greatest_coordinate = 0.5;
  Plan plan;
  plan.answerers.kernels = {&bad, &gone, &limited};
  plan.questions.sources = {family_source(find_family("general"))};
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [](const Source&, Precision) { return std::uint64_t{3}; };
  plan.running.target = std::string(scalar_target);
  const std::atomic<bool> never = false;
  const std::string text = summary_text(record_of(plan, run_campaign(plan, never, [](const Progress&) {}), {}), 1);
  EXPECT_EQ(text.find("plugin:x.so binary32: crash on family general, 3 times, first at 1:general:2:binary32:0:0: "
                      "signal 11\n  axiscert query '1:general:2:binary32:0:0' > witness.jsonl && axiscert check "
                      "witness.jsonl --kernel plugin:x.so\n"
                      "plugin:x.so binary32: 3 other queries (random, touching, degenerate, huge, tiny): no verdict\n"
                      "  kernel         precision  queries  missed contacts"),
            0u)
      << text;
  const auto row = [&](const std::string& kernel) {
    std::istringstream words(text.substr(text.find("\n  " + kernel)));
    return std::vector<std::string>(std::istream_iterator<std::string>(words), {});
  };
  // Columns: without an answer, outside its limits, and wrong there.
  EXPECT_EQ(row("plugin:x.so").at(9), "3");
  EXPECT_EQ(row("plugin:box.so").at(10), "3");
  EXPECT_EQ(row("plugin:box.so").at(11), "0");
}

TEST(RunOutput, ADisagreementIsSavedAsAQueryOfItsPredicate) {
  const TemporaryFolder temporary;
  const OutputFolder folder((temporary.path() / "run").string());
  const auto saved = [&](const OracleDisagreement& disagreement) {
    std::ifstream file(folder.save(disagreement));
    std::string line;
    std::getline(file, line);
    return Json::parse(line);
  };
  const Predicate interval =
      checked({.id = "point-interval",
               .asks = "",
               .touching = "",
               .wrong_answers = {},
               .entries = {{"ends", "any", {{"low", Role::coordinate, "i"}, {"high", Role::coordinate, "i"}}}},
               .comparisons = {{"low", 0}},
               .clauses = {{"x", 1}},
               .measures = {}});
  const Json other = saved({"two", Numbers<float>{1, 2}, interval});
  EXPECT_EQ(other["predicate"], "point-interval");
  EXPECT_EQ(other["precision"], "binary32");
  EXPECT_EQ(other["i"], (Json{"0x1p+0", "0x1p+1"}));
  const Json first = saved({"two", Numbers<float>(apart), sphere_triangle_predicate()});
  EXPECT_FALSE(first.contains("predicate")) << "the predicate that files imply is not named";
  EXPECT_EQ(first["r"], "0x1p-1");
}

}  // namespace
}  // namespace axiscert
