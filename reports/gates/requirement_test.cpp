// Records that each level of --require accepts and refuses.
#include <set>

#include "fuzz/text/json.h"
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

TEST(Requirement, ADepthMayBeALengthInTheQueriesUnit) {
  Json record = stored_record();
  record["kernels"].erase(1);
  Json& verdict = tangent_counts(record)["verdict"];
  verdict["farthest_false_separation"] = 0.0;
  verdict["farthest_false_contact"] = 0.166;
  EXPECT_TRUE(unmet(record, "depth=17cm").empty());
  EXPECT_THAT(texts(record, "depth=16.5cm"),
              testing::ElementsAre(HasSubstr("phantom contacts, the worst by 16.6 cm: 16.5 cm is allowed: 20")));
  record["plan"]["unit"] = "cm";
  EXPECT_TRUE(unmet(record, "depth=2mm").empty());
  EXPECT_EQ(unmet(record, "depth=1mm").size(), 1u);
  EXPECT_EQ(unmet(record, "conservative=1mm").size(), 2u) << "a missed contact of any depth";
  for (const char* wrong : {"depth=1mile", "depth=-1mm", "depth=mm"}) EXPECT_THROW(parse_level(wrong), Error) << wrong;
}

TEST(Requirement, ALevelMayBeAboutSomeFamilies) {
  EXPECT_TRUE(unmet(stored_record(), "exact in mesh/*").empty());
  const std::vector<std::string> on_lattice = texts(stored_record(), "exact in latt*");
  EXPECT_EQ(on_lattice, (std::vector<std::string>{"<script> binary32 on lattice: answers `invalid` to valid queries: 1",
                                                  "<script> binary32 on lattice: missed contacts: 4 (witness w4)",
                                                  "<script> binary32 on lattice: phantom contacts: 1 (witness w5)"}));
  EXPECT_EQ(texts(stored_record(), "exact in tangent, lattice"), texts(stored_record(), "exact"));
  for (const LevelOutcome& outcome : outcomes_at(stored_record(), "exact in lattice")) EXPECT_EQ(outcome.families, 1u);

  Json record = stored_record();
  record["plan"]["require"] = "exact in tangnt";
  try {
    outcomes_of(record);
    ADD_FAILURE() << "a pattern that matches nothing";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("no family of this run matches 'tangnt'; did you mean 'tangent'?"));
  }
  EXPECT_THROW(parse_level("exact in "), Error);
  EXPECT_THROW(parse_level("no-slack=1mm in lattice"), Error) << "it asks no family";
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

TEST(Requirement, UnknownLevelIsAnErrorThatNamesTheNearest) {
  for (const char* text : {"", "exakt", "logic ", "conservative0.1"}) {
    try {
      parse_level(text);
      ADD_FAILURE() << "accepted '" << text << "'";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("the nearest of "));
      EXPECT_THAT(error.what(), HasSubstr("`axiscert run --help` lists them"));
    }
  }
}

TEST(Requirement, DepthHasToBeANumberFromZeroOn) {
  for (const std::string level : {"conservative", "depth"}) {
    for (const char* argument : {"=", "=-1", "=nan", "=0.1x", "= 1"})
      EXPECT_THROW(parse_level(level + argument), Error) << level << argument;
    EXPECT_EQ(depth_argument(parse_level(level + "=1e-3")).most, 0.001);
    EXPECT_EQ(depth_argument(parse_level(level + "=0")).most, 0);
  }
  EXPECT_THROW(parse_level("depth"), Error);
  EXPECT_THROW(parse_level("logic=1"), Error);
  EXPECT_THROW(parse_level("no-worse-than="), Error);
}

TEST(Requirement, DepthAllowsWrongVerdictsUpToItEitherWay) {
  Json record = stored_record();
  record["kernels"].erase(1);
  EXPECT_TRUE(unmet(record, "depth=0.25").empty());
  EXPECT_EQ(texts(record, "depth=0.2"),
            std::vector<std::string>{"published binary32 on tangent: missed contacts, the worst by 0.25 of the scene: "
                                     "0.2 of the scene is allowed: 40 (witness w2)"});
  EXPECT_EQ(unmet(record, "depth=0.1").size(), 2u) << "phantom contacts too";
}

}  // namespace

// A level is met, not met, or not checked; what is not checked does not pass. Each record is the stored one with a
// plant.

namespace {

using testing::AllOf;
using testing::HasSubstr;

// `published` alone, or `<script>`, which shows verdicts alone, without its wrong verdicts on `lattice`.
Json of_reference() {
  Json record = stored_record();
  record["kernels"].erase(1);
  record["plan"]["kernels"] = {"published"};
  return record;
}
Json of_verdicts() {
  Json record = stored_record();
  record["kernels"].erase(0);
  record["plan"]["kernels"] = {"<script>"};
  Json& verdict = record["kernels"][0]["families"]["lattice"]["verdict"];
  for (const char* member : {"false_separation", "false_contact", "touching_flips", "invalid"}) verdict[member] = 0;
  return record;
}
Json& families_in(Json& record) { return record["kernels"][0]["families"]; }

LevelOutcome outcome(const Json& record, const std::string& level) {
  const std::vector<LevelOutcome> outcomes = outcomes_at(record, level);
  EXPECT_EQ(outcomes.size(), 1u);
  return outcomes.front();
}
void expect_unchecked(const Json& record, const std::string& level, const std::string& reason) {
  const LevelOutcome found = outcome(record, level);
  EXPECT_EQ(name(found.state), "NOT CHECKED") << level;
  EXPECT_THAT(found.reason, HasSubstr(reason)) << level;
  EXPECT_FALSE(found.passes());
  EXPECT_TRUE(found.covers.empty()) << "nothing is claimed";
}

TEST(LevelOutcome, MetSaysWhatItCoversAndWhatNot) {
  Json record = of_reference();
  for (Json& family : families_in(record)) {
    for (Json& count : family["verdict"]["links"]) count = 0;
  }
  const LevelOutcome reference = outcome(record, "logic");
  EXPECT_EQ(reference.state, LevelState::met);
  EXPECT_THAT(reference.covers, AllOf(HasSubstr("4,495 queries"), HasSubstr("its reference computes them")));
  EXPECT_THAT(reference.leaves_out, HasSubstr("rounding and range"));

  const LevelOutcome verdicts = outcome(of_verdicts(), "logic");
  EXPECT_EQ(verdicts.state, LevelState::met);
  EXPECT_THAT(verdicts.covers, HasSubstr("of lattice that do not touch"));
  EXPECT_THAT(verdicts.leaves_out, HasSubstr("7 wrong verdicts of this run have no known cause"));
  EXPECT_EQ(verdicts.unseen, std::vector<std::string>{"tangent"});
}

TEST(LevelOutcome, RangeOfVerdictsAloneIsNotChecked) {
  Json record = of_verdicts();
  expect_unchecked(record, "range", "shows verdicts alone: a wrong verdict (7 of them) cannot be told to be of range");
  families_in(record)["tangent"]["verdict"]["false_separation"] = 0;
  EXPECT_EQ(outcome(record, "range").state, LevelState::met) << "no verdict is wrong, so none is by range";
}

TEST(LevelOutcome, RangeOfFormulaeInAnOrderOfTheirOwnIsNotChecked) {
  Json record = of_reference();
  record["kernels"][0]["reference"] = false;
  for (Json& family : families_in(record)) {
    for (Json& count : family["verdict"]["links"]) count = 0;
  }
  expect_unchecked(record, "range", "evaluates its formulae in its own way: a wrong verdict (60 of them)");
}

TEST(LevelOutcome, LogicWithoutExactArithmeticIsNotChecked) {
  for (Json record : {of_verdicts(), of_reference()}) {
    record["kernels"][0]["reference"] = record["kernels"][0]["reference"].is_null() ? Json() : Json(false);
    for (Json& family : families_in(record)) {
      for (Json& count : family["verdict"]["links"]) count = 0;
    }
    families_in(record)["lattice"]["exact_arithmetic"] = false;
    expect_unchecked(record, "logic", "add --family lattice");
    expect_unchecked(record, "range", "add --family lattice");
  }
  Json touching = of_verdicts();
  Json& lattice = families_in(touching)["lattice"];
  lattice["truth"]["touching"] = lattice["verdict"]["decided_touching"] = lattice["trials"];
  expect_unchecked(touching, "logic", "no clear query was decided, and none of a family of exact arithmetic");
}

TEST(LevelOutcome, WithoutADecidedQueryNothingIsChecked) {
  const std::vector<std::string> levels = {"logic", "range", "exact", "conservative", "conservative=1", "depth=1"};
  Json undecided = of_verdicts(), none = undecided;
  for (Json& family : families_in(undecided)) {
    for (const char* member : {"false_separation", "false_contact"}) family["verdict"][member] = 0;
    family["verdict"]["undecided"] = family["trials"];
    family["verdict"]["undecided_contact"] = family["truth"]["contact"];
  }
  none["kernels"][0]["families"] = Json::object();
  for (const std::string& level : levels) {
    expect_unchecked(undecided, level, "called no valid query within its limits separated or contact");
    expect_unchecked(none, level, "no query of it was run in binary32");
  }
}

TEST(LevelOutcome, AFamilyOfThePlanWithoutQueriesIsNotChecked) {
  Json record = of_verdicts();
  record["plan"]["trials"]["queries/empty.jsonl"] = {{"binary32", 0}, {"binary64", 0}};
  EXPECT_THAT(outcome(record, "logic").reason, HasSubstr("no query was run of queries/empty.jsonl"));
  record["plan"]["trials"]["queries/empty.jsonl"]["binary64"] = 1;
  EXPECT_EQ(outcome(record, "logic").state, LevelState::met) << "a file has the queries that it has";
  record["plan"]["trials"]["general"] = {{"binary32", 0}, {"binary64", 100}};
  EXPECT_THAT(outcome(record, "logic").reason, HasSubstr("no query was run of general")) << "a run out of time";
}

TEST(LevelOutcome, AFamilyWithoutAValidQueryIsNotChecked) {
  Json record = of_verdicts();
  families_in(record)["tangent"]["verdict"]["false_separation"] = 0;
  EXPECT_EQ(outcome(record, "depth=1").state, LevelState::met);
  Json& family = families_in(record)["nothing"] = families_in(record)["lattice"];
  family["truth"] = {{"separated", 0}, {"contact", 0}, {"touching", 0}, {"invalid", family["trials"]}};
  EXPECT_THAT(outcome(record, "depth=1").reason, HasSubstr("no valid query of nothing was asked"));
  EXPECT_EQ(outcome(record, "depth=1 in tangent,lattice").state, LevelState::met);
}

TEST(LevelOutcome, AFileThatATimeLimitLeftInPartIsNotChecked) {
  Json record = of_verdicts();
  record["plan"]["trials"]["queries/long.jsonl"] = {{"binary32", 65536}};
  record["plan"]["planned"] = {{"queries/long.jsonl", {{"binary32", 100000}}}};
  record["plan"]["units_done"] = {{"queries/long.jsonl", {{"binary32", 1}}}};
  EXPECT_THAT(outcome(record, "depth=1").reason,
              HasSubstr("the time limit left 34,464 of the 100,000 queries of queries/long.jsonl unasked"));
}

TEST(LevelOutcome, AFailureIsNotHiddenByWhatIsNotChecked) {
  Json record = of_verdicts();
  families_in(record)["tangent"]["verdict"]["unanswered"] = 1;
  EXPECT_EQ(outcome(record, "range").state, LevelState::not_met);
}

TEST(LevelOutcome, MayBeLeftUncheckedByName) {
  Json record = of_verdicts();
  record["plan"]["require"] = {"logic", "range"};
  EXPECT_FALSE(pass(outcomes_of(record)));
  record["plan"]["allow_unchecked"] = {"range"};
  const auto outcomes = outcomes_of(record);
  EXPECT_TRUE(pass(outcomes));
  EXPECT_EQ(state_text(worst_of(outcomes, edited(record).kernels[0])), "NOT CHECKED, which is allowed");
  EXPECT_EQ(outcomes[1].state, LevelState::not_checked) << "it is not called met";
  record["plan"]["allow_unchecked"] = {"exact"};
  EXPECT_THROW(outcomes_of(record), Error) << "exact is not required";
  record["plan"]["allow_unchecked"] = {"logic"};
  EXPECT_FALSE(pass(outcomes_of(record)));
}

TEST(LevelOutcome, AKernelThatCouldNotBeLoadedMeetsNothingWhateverIsAllowed) {
  Json record = stored_record();
  record["kernels"] = Json::array();
  record["plan"]["kernels"] = {"plugin:gone.so"};
  record["plan"]["allow_unchecked"] = {"logic"};
  record["findings"] = Json::array({load_fault_of("plugin:gone.so", "no such file")});
  const auto outcomes = outcomes_of(record);
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].state, LevelState::not_met);
  EXPECT_FALSE(pass(outcomes));
}

// `published` as the kernel under test, and a copy of it as the yardstick.
Json with_yardstick(std::uint64_t missed) {
  Json record = of_reference();
  record["kernels"].push_back(record["kernels"][0]);
  record["kernels"][1]["id"] = "yardstick";
  record["plan"]["kernels"] = {"published", "yardstick"};
  record["plan"]["require"] = "no-worse-than=yardstick";
  families_in(record)["tangent"]["verdict"]["false_separation"] = missed;
  return record;
}

TEST(NoWorseThan, ComparesCountsUpToChance) {
  for (const std::uint64_t missed : {0, 39, 40, 41, 50}) {
    const auto outcomes = outcomes_of(with_yardstick(missed));
    ASSERT_EQ(outcomes.size(), 1u) << "the yardstick has to meet nothing";
    EXPECT_EQ(outcomes[0].state, LevelState::met) << missed;
    EXPECT_THAT(outcomes[0].covers, HasSubstr("Holm's correction over 6 counts"));
  }
  const auto outcomes = outcomes_of(with_yardstick(120));
  ASSERT_EQ(outcomes[0].failures.size(), 1u);
  EXPECT_THAT(outcomes[0].failures[0].text(),
              AllOf(HasSubstr("published binary32 on tangent: missed contacts, 120 of 995, more than yardstick with 40 "
                              "of 995 (p = "),
                    HasSubstr("witness w2")));
}

TEST(NoWorseThan, WithoutTheOtherKernelOnAFamilyIsNotChecked) {
  Json record = with_yardstick(40);
  record["kernels"][1]["families"].erase("lattice");
  EXPECT_THAT(outcomes_of(record)[0].reason, HasSubstr("yardstick was not run on lattice in binary32"));
  record["kernels"][1]["precision"] = "binary64";
  EXPECT_EQ(outcomes_of(record)[0].state, LevelState::not_checked);
}

TEST(NoWorseThan, AYardstickThatDecidesNothingIsNone) {
  Json record = with_yardstick(40);
  Json& verdict = record["kernels"][1]["families"]["lattice"]["verdict"];
  verdict["undecided"] = verdict["undecided_contact"] = 300;
  verdict["undecided_touching"] = 60;
  verdict["decided_contacts"] = verdict["decided_touching"] = 0;
  const LevelOutcome found = outcomes_of(record)[0];
  EXPECT_EQ(found.state, LevelState::not_checked);
  EXPECT_THAT(found.reason, HasSubstr("yardstick decided none of the contacts of lattice, so there is no rate"));

  // Where it promises none either, that is why.
  verdict["outside_limits"] = outside_all(300, 60, 200);
  EXPECT_THAT(outcomes_of(record)[0].reason, HasSubstr("on lattice it promises 500 queries, and yardstick 0"));
}

TEST(NoWorseThan, InAPatternJudgesItsFamiliesAlone) {
  Json record = with_yardstick(120);
  const auto at = [&](const char* level) {
    record["plan"]["require"] = level;
    return outcomes_of(record)[0];
  };
  EXPECT_EQ(at("no-worse-than=yardstick in tangent").state, LevelState::not_met);
  EXPECT_EQ(at("no-worse-than=yardstick in lattice").state, LevelState::met);
}

TEST(NoWorseThan, AYardstickAloneIsNotChecked) {
  Json record = of_reference();
  record["plan"]["require"] = "no-worse-than=published";
  const auto outcomes = outcomes_of(record);
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].state, LevelState::not_checked);
  EXPECT_FALSE(pass(outcomes));
}

TEST(LevelOutcome, ThatLooksAtNoFamilySaysWhichLinesAreLeftOut) {
  LevelOutcome met{{"slack=1", "slack"}, "published", "binary32"};
  met.lines_left_out = 6;
  EXPECT_EQ(met.text(), "published binary32: slack=1: 6 lines of files left out: met");
}

TEST(GateLevels, HaveNamesAndSentencesOfTheirOwn) {
  std::set<std::string> sentences;
  for (const GateLevel* level : gate_levels()) {
    const std::string usage = level->usage, name(level->name());
    std::string argument;
    for (const auto& [kind, example] : {std::pair("=KERNEL", "=published"),
                                        {"=KIND", "=scale"},
                                        {"=D", "=0.5"},
                                        {"=U", "=4"},
                                        {"=A", "=0.001"},
                                        {"=E", "=0.5"},
                                        {"=F", "=0.5"},
                                        {"=DEG", "=0.5"},
                                        {"=SHARE", "=0.5"},
                                        {"=SIZE", "=1mm"}}) {
      if (usage.find(kind) != usage.npos) argument = example;
    }
    const AskedLevel asked = parse_level(name + argument);
    EXPECT_EQ(asked.name, name);
    EXPECT_TRUE(sentences.insert(sentence_of(asked)).second) << usage;
    EXPECT_NE(*level->meaning, '\0') << usage;
  }
}

// A sentence that does not read its argument would let anything pass for one.
TEST(GateLevels, RefuseAnArgumentThatIsNone) {
  for (const GateLevel* level : gate_levels()) {
    const std::string name(level->name());
    EXPECT_THROW(parse_level(name + "="), Error) << level->usage;
    if (name == "no-worse-than") continue;  // whose argument is any text
    EXPECT_THROW(parse_level(name + "=-1 of them"), Error) << level->usage;
  }
}

}  // namespace

}  // namespace axiscert
