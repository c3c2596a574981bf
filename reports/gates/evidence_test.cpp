// How much was looked at: each exclusion is left out of it, each bound refuses what falls short by one, and each answer
// that does not count stands against every level. Each record is the stored one with a plant.
#include <initializer_list>
#include <random>
#include <tuple>

#include "fuzz/text/json.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

const std::vector<std::string> levels = {"logic", "range", "exact", "conservative", "conservative=1", "depth=1"};

// `<script>`, which shows verdicts alone and may decline, right on 5,000 queries of each family: 2,000 contacts, of
// which 60 touch, and 3,000 separations.
Json right_kernel() {
  Json record = stored_record();
  for (Json* kernels : {&record["kernels"], &record["plan"]["kernels"]}) kernels->erase(0);
  record["witnesses"] = Json::array();
  record["plan"]["require"] = nullptr;
  record["plan"]["families"] = {"lattice", "tangent"};
  for (Json& family : record["kernels"][0]["families"]) {
    family["trials"] = family["base_triangles"] = 5000;
    family["truth"] = {{"separated", 3000}, {"contact", 2000}, {"touching", 60}, {"invalid", 0}};
    family["exact_arithmetic"] = true;
    Json& verdict = family["verdict"];
    for (const char* member : {"false_separation", "false_contact", "undecided", "undecided_contact",
                               "undecided_touching", "invalid", "unanswered", "touching_flips"}) {
      verdict[member] = 0;
    }
    verdict["decided_touching"] = 60;
  }
  return record;
}
Json& kernel_of(Json& record) { return record["kernels"][0]; }
Json& family_of(Json& record, const char* name = "lattice") { return kernel_of(record)["families"][name]; }
Json& verdict_of(Json& record, const char* name = "lattice") { return family_of(record, name)["verdict"]; }

void put_outside(Json& verdict, std::uint64_t contact, std::uint64_t touching, std::uint64_t separated) {
  verdict["outside_limits"] = outside_all(contact, touching, separated);
  verdict["decided_touching"] = 60 - touching;
}
void declare_limits(Json& record) {
  kernel_of(record)["limits"] = {{"least_coordinate", nullptr},
                                 {"greatest_coordinate", nullptr},
                                 {"least_area", nullptr},
                                 {"least_radius", 1.0},
                                 {"greatest_radius", nullptr},
                                 {"margin", nullptr},
                                 {"sides", nullptr}};
  for (const char* family : {"lattice", "tangent"}) put_outside(verdict_of(record, family), 0, 0, 0);
}
void decline(Json& verdict, std::uint64_t contacts, std::uint64_t touching, std::uint64_t separations) {
  verdict["undecided"] = contacts + separations;
  verdict["undecided_contact"] = contacts;
  verdict["undecided_touching"] = touching;
  const Json& outside = verdict["outside_limits"];
  verdict["decided_touching"] = 60 - touching - (outside.is_null() ? 0 : outside["touching"].get<std::uint64_t>());
}

LevelOutcome judged_at(const auto& record, const std::string& level) {
  const auto outcomes = outcomes_at(record, level);
  EXPECT_EQ(outcomes.size(), 1u);
  return outcomes.front();
}
void expect_at_each(const Json& record, LevelState state, const std::string& text) {
  for (const std::string& level : levels) {
    const LevelOutcome found = judged_at(record, level);
    EXPECT_EQ(name(found.state), name(state)) << level << ": " << found.text();
    EXPECT_THAT(found.text(), HasSubstr(text)) << level;
  }
}

TEST(LookedAt, MetSaysOfHowMany) {
  const LevelOutcome exact = judged_at(right_kernel(), "exact");
  EXPECT_EQ(exact.text(), "<script> binary32: exact: 10,000 of 10,000 promised queries looked at: met");
  EXPECT_THAT(exact.covers,
              HasSubstr("the fewest of a family, 5,000 independent queries of lattice, show with 95 % that fewer "
                        "than 0.0599 % are wrong"));
  EXPECT_EQ(judged_at(right_kernel(), "logic").looked_at, 2u * (5000 - 60)) << "touching queries are not clear";
  expect_at_each(right_kernel(), LevelState::met, ": met");
}

TEST(LookedAt, OneAnswerThatDoesNotCountStandsAgainstEveryLevel) {
  for (const char* member : {"invalid", "unanswered"}) {
    Json record = right_kernel();
    verdict_of(record)[member] = 1;
    expect_at_each(record, LevelState::not_met, ": not met");
    for (const std::string level : {"invariant=order", "decided=0.1", "never-late", "no-tunnel"})
      EXPECT_FALSE(judged_at(record, level).failures.empty()) << level;
  }
  Json declining = right_kernel();
  decline(verdict_of(declining), 0, 0, 1);
  expect_at_each(declining, LevelState::met, ", 1 declined");
  kernel_of(declining)["may_decline"] = false;
  expect_at_each(declining, LevelState::not_met, "1 declined");
  EXPECT_THAT(judged_at(declining, "exact").failures[0].what, HasSubstr("does not declare may_decline"));
}

TEST(LookedAt, WhatIsOutsideLimitsDeclinedOrTouchingWithoutAPromiseIsNotLookedAt) {
  Json record = right_kernel();
  declare_limits(record);
  put_outside(verdict_of(record), 500, 10, 1000);
  EXPECT_THAT(judged_at(record, "exact").text(),
              HasSubstr("exact within its limits: 2 of 2 families; 8,500 of 8,500 promised queries looked at, 1,500 of "
                        "10,000 outside its limits: met"));
  EXPECT_EQ(judged_at(record, "logic").looked_at, 10000u - 1500 - 60 - 50);
  decline(verdict_of(record), 200, 20, 300);
  EXPECT_EQ(judged_at(record, "exact").looked_at, 8000u);
  EXPECT_EQ(judged_at(record, "logic").looked_at, 10000u - 1500 - 500 - 60 - 30);
  kernel_of(record)["touching"] = "either";
  const LevelOutcome either = judged_at(record, "exact");
  EXPECT_EQ(either.evidence.touching, 60u + 50);
  EXPECT_EQ(either.evidence.declined_contacts, 180u) << "of those that touch it promised nothing";
  EXPECT_EQ(either.looked_at, 10000u - 1500 - 110 - 480);
  EXPECT_EQ(either.evidence.promised() + either.evidence.touching + either.evidence.outside,
            either.evidence.population);
}

TEST(LookedAt, FiftyNineOfAFamilyAreEnoughAndOneFewerIsNot) {
  for (const std::uint64_t within : {59u, 58u, 1u}) {
    Json record = right_kernel();
    declare_limits(record);
    put_outside(verdict_of(record), 2000, 60, 3000 - within);
    const LevelOutcome found = judged_at(record, "exact");
    EXPECT_EQ(found.state, within == 59 ? LevelState::met : LevelState::not_checked) << within;
    if (within == 59) continue;
    EXPECT_THAT(found.reason, HasSubstr(std::to_string(within) + " of 5,000 queries of lattice looked at, and 59 are"));
  }
}

TEST(LookedAt, AFileIsLookedAtWholeAndASampleIsNotSmallerThanThat) {
  for (const bool is_file : {true, false}) {
    Json record = right_kernel();
    const std::string family = is_file ? "queries/three.jsonl" : "few";
    kernel_of(record)["families"][family] = family_of(record);
    Json& few = kernel_of(record)["families"][family];
    few["trials"] = few["base_triangles"] = 3;
    few["truth"] = {{"separated", 1}, {"contact", 2}, {"touching", 0}, {"invalid", 0}};
    EXPECT_EQ(judged_at(record, "exact").state, is_file ? LevelState::met : LevelState::not_checked);
    declare_limits(record);
    put_outside(few["verdict"], 1, 0, 0);
    EXPECT_EQ(judged_at(record, "exact").state, LevelState::not_checked) << "one of three is not promised";
  }
}

// One line of seven was looked at, which is all of this precision.
TEST(LookedAt, LinesOfAPrecisionInWhichTheKernelDoesNotExistAreLeftOut) {
  Json record = right_kernel();
  const std::string family = "queries/seven.jsonl";
  kernel_of(record)["families"][family] = family_of(record);
  Json& one = kernel_of(record)["families"][family];
  one["trials"] = one["base_triangles"] = 1;
  one["truth"] = {{"separated", 0}, {"contact", 1}, {"touching", 0}, {"invalid", 0}};
  record["plan"]["families"].push_back(family);
  record["plan"]["trials"][family] = {{"binary32", 1}, {"binary64", 6}};
  const std::string lines = "6 of 7 queries of queries/seven.jsonl, which are of binary64: it does not exist in it";
  const LevelOutcome found = judged_at(record, "exact");
  EXPECT_EQ(found.state, LevelState::met);
  EXPECT_THAT(found.leaves_out, HasSubstr(lines));
  EXPECT_THAT(judged_at(record, "exact in lattice").leaves_out, testing::Not(HasSubstr(lines)));
  EXPECT_THAT(unjudged(record), Contains("<script>: NOT JUDGED on " + lines));
  Json wide = kernel_of(record);
  wide["precision"] = "binary64";
  record["kernels"].push_back(wide);
  for (const LevelOutcome& each : outcomes_at(record, "exact"))
    EXPECT_THAT(each.leaves_out, testing::Not(HasSubstr(lines)));
}

TEST(LookedAt, LinesThatPrecisionLeavesOutAreSaidWithMet) {
  Json record = right_kernel();
  EXPECT_THAT(judged_at(record, "exact").text(), testing::Not(HasSubstr("left out")));
  const std::string family = "queries/seven.jsonl";
  kernel_of(record)["families"][family] = family_of(record);
  record["plan"]["families"].push_back(family);
  record["plan"]["trials"][family] = {{"binary32", 5000}};
  record["plan"]["files"].push_back({{"name", "seven.jsonl"},
                                     {"kind", "queries"},
                                     {"sha256", nullptr},
                                     {"queries", 5006},
                                     {"left_out", {{"binary64", 6}}}});
  const LevelOutcome found = judged_at(record, "exact");
  EXPECT_EQ(found.state, LevelState::met) << found.text();
  EXPECT_THAT(found.text(), HasSubstr(", 6 lines of files left out: met"));
  EXPECT_THAT(found.leaves_out, HasSubstr("6 of 5,006 queries of queries/seven.jsonl, which are of binary64: the run "
                                          "was not to ask them"));
  EXPECT_THAT(judged_at(record, "exact in lattice").text(), testing::Not(HasSubstr("left out")));
  EXPECT_THAT(unjudged(record), IsEmpty()) << "they were not asked for";
}

TEST(LookedAt, AMarginIsOfQueriesThatAreNotPromised) {
  Json record = right_kernel();
  declare_limits(record);
  kernel_of(record)["limits"]["least_radius"] = nullptr;
  kernel_of(record)["limits"]["margin"] = 0.005;
  for (const char* family : {"lattice", "tangent"}) {
    put_outside(verdict_of(record, family), 0, 0, 2900);
    verdict_of(record, family)["outside_limits"]["false_contact"] = 2900;
  }
  const LevelOutcome found = judged_at(record, "keeps-margin");
  EXPECT_EQ(found.state, LevelState::met);
  EXPECT_THAT(found.text(), HasSubstr("5,800 of 5,800 queries apart by no more than its margin looked at"));
  EXPECT_THAT(found.leaves_out, testing::Not(HasSubstr("outside its limits")));
  for (const char* family : {"lattice", "tangent"}) put_outside(verdict_of(record, family), 0, 0, family[0] == 'l');
  verdict_of(record, "lattice")["outside_limits"]["false_contact"] = 1;
  EXPECT_EQ(judged_at(record, "keeps-margin").reason,
            "1 generated query is apart by no more than its margin, and 59 are needed");
}

TEST(LookedAt, AFamilyWhollyOutsideIsNamedInTheFirstSentence) {
  Json record = right_kernel();
  declare_limits(record);
  put_outside(verdict_of(record), 2000, 60, 3000);
  const LevelOutcome found = judged_at(record, "exact");
  EXPECT_EQ(found.state, LevelState::met);
  EXPECT_THAT(found.text(), HasSubstr("exact within its limits: 1 of 2 families; 5,000 of 5,000"));
  EXPECT_EQ(found.outside, std::vector<std::string>{"lattice"});
  EXPECT_THAT(found.leaves_out, HasSubstr("outside its limits: lattice"));
  put_outside(verdict_of(record, "tangent"), 2000, 60, 3000);
  for (const std::string& level : levels) EXPECT_EQ(judged_at(record, level).state, LevelState::not_checked) << level;
  EXPECT_THAT(unjudged(record), Contains(HasSubstr("NOT JUDGED: every valid query is outside the limits")));
}

TEST(LookedAt, LimitsThatLeaveOneKindOfAnswerAreNoEvidence) {
  Json record = right_kernel();
  declare_limits(record);
  for (const char* family : {"lattice", "tangent"}) put_outside(verdict_of(record, family), 2000, 60, 1000);
  expect_at_each(record, LevelState::not_checked, "0 of 4,000 exact contacts were decided, and 29 are needed");
  for (const char* family : {"lattice", "tangent"}) put_outside(verdict_of(record, family), 2000, 60, 1000);
  put_outside(verdict_of(record), 1971, 60, 1000);
  EXPECT_EQ(judged_at(record, "exact").state, LevelState::met) << "29 contacts";
  put_outside(verdict_of(record), 1972, 60, 1000);
  EXPECT_EQ(judged_at(record, "exact").state, LevelState::not_checked) << "28 contacts";
  for (const char* family : {"lattice", "tangent"}) put_outside(verdict_of(record, family), 1000, 60, 3000);
  expect_at_each(record, LevelState::not_checked, "0 of 6,000 exact separations were decided");
}

TEST(LookedAt, ConservativeLooksAtContactsAndIsNotCheckedWithoutAny) {
  EXPECT_EQ(judged_at(right_kernel(), "conservative").text(),
            "<script> binary32: conservative: 4,000 of 4,000 promised contacts looked at: met");
  EXPECT_THAT(judged_at(right_kernel(), "conservative").covers, HasSubstr("4,000 contacts of "));
  Json record = right_kernel();
  for (const char* family : {"lattice", "tangent"})
    family_of(record, family)["truth"] = {{"separated", 5000}, {"contact", 0}, {"touching", 0}, {"invalid", 0}};
  EXPECT_EQ(judged_at(record, "exact").state, LevelState::met);
  for (const std::string level : {"conservative", "conservative=1"}) {
    EXPECT_EQ(judged_at(record, level).state, LevelState::not_checked);
    EXPECT_THAT(judged_at(record, level).reason, HasSubstr("no query is a contact that it could miss"));
  }
  family_of(record)["truth"] = {{"separated", 4000}, {"contact", 1000}, {"touching", 1000}, {"invalid", 0}};
  const LevelOutcome found = judged_at(record, "conservative");
  EXPECT_EQ(found.state, LevelState::met);
  EXPECT_EQ(found.looked_at, 1000u);
  EXPECT_EQ(found.unseen, std::vector<std::string>{"tangent"});
  for (const char* touching : {"separated", "either"}) {
    kernel_of(record)["touching"] = touching;
    EXPECT_EQ(judged_at(record, "conservative").state, LevelState::not_checked) << touching;
    EXPECT_EQ(judged_at(record, "exact").state, LevelState::met) << touching;
  }
}

TEST(LookedAt, HalfOfTheContactsAndOfTheSeparationsOfEachFamilyHaveToBeDecided) {
  const auto with = [](std::uint64_t contacts, std::uint64_t separations) {
    Json record = right_kernel();
    decline(verdict_of(record), contacts, 0, separations);
    return record;
  };
  expect_at_each(with(1000, 1500), LevelState::met, "2,500 declined");
  expect_at_each(with(1001, 0), LevelState::not_checked, "it declines 1,001 of 2,000 contacts of lattice");
  expect_at_each(with(0, 1501), LevelState::not_checked, "it declines 1,501 of 3,000 separations of lattice");

  // Another share, by name.
  const auto states = [&](Json record, const char* share) {
    record["plan"]["require"] = {"exact", share};
    std::vector<LevelState> states;
    for (const LevelOutcome& found : outcomes_of(record)) states.push_back(found.state);
    return states;
  };
  using States = std::vector<LevelState>;
  EXPECT_EQ(states(with(1500, 0), "decided=0.25"), (States{LevelState::met, LevelState::met}));
  EXPECT_EQ(states(with(1501, 0), "decided=0.25"), (States{LevelState::not_checked, LevelState::not_met}));
  EXPECT_EQ(states(with(201, 0), "decided=0.9"), (States{LevelState::not_checked, LevelState::not_met}));
  for (const char* wrong : {"decided=0", "decided=1.1", "decided", "decided=nan", "decided=-1"})
    EXPECT_THROW(parse_level(wrong), Error) << wrong;
}

TEST(LookedAt, AnInterruptedRunMeetsNothing) {
  Json record = right_kernel();
  record["complete"] = false;
  expect_at_each(record, LevelState::not_checked, "interrupted after 4,500 queries");
  record["plan"]["planned"] = {{"general", {{"binary32", 5000}}}, {"lattice", {{"binary32", 7345}}}};
  expect_at_each(record, LevelState::not_checked, "interrupted after 4,500 of 12,345 queries");
}

TEST(LookedAt, ImagesThatWereDeclinedAreNotLookedAt) {
  Json record = right_kernel();
  Json& order = family_of(record)["invariance"]["order"];
  order = {{"images", 1000}, {"changed", 0}, {"undecided", 1000}, {"by_size", Json::object()}, {"first", nullptr}};
  EXPECT_EQ(judged_at(record, "invariant=order").state, LevelState::met);
  EXPECT_EQ(judged_at(record, "invariant=order").looked_at, 1000u);
  family_of(record)["invariance"]["order"]["undecided"] = 1001;
  EXPECT_THAT(judged_at(record, "invariant=order").reason, HasSubstr("1,001 of 2,001 pairs of a query and its image"));
  family_of(record)["invariance"]["order"]["undecided"] = 0;
  family_of(record)["invariance"]["order"]["images"] = 58;
  EXPECT_EQ(judged_at(record, "invariant=order").state, LevelState::met) << "all that there are";
}

TEST(LookedAt, AKernelThatAnsweredNothingIsNotJudged) {
  Json record = right_kernel();
  EXPECT_THAT(unjudged(record), IsEmpty());
  for (const char* family : {"lattice", "tangent"}) decline(verdict_of(record, family), 2000, 60, 2990);
  for (const char* family : {"lattice", "tangent"}) verdict_of(record, family)["invalid"] = 10;
  EXPECT_EQ(unjudged(record), std::vector<std::string>{
                                  "<script> binary32: NOT JUDGED: of 10,000 valid queries that it promises it decided "
                                  "none, 9,980 declined, 20 called invalid"});
  verdict_of(record)["invalid"] = 9;
  EXPECT_THAT(unjudged(record), IsEmpty()) << "it decided one";
  // In one precision alone: the other has queries that count.
  Json both = right_kernel();
  both["kernels"].push_back(both["kernels"][0]);
  both["kernels"][1]["precision"] = "binary64";
  both["plan"]["precisions"] = {"binary32", "binary64"};
  both["kernels"][1]["families"]["lattice"]["truth"] = {
      {"separated", 0}, {"contact", 0}, {"touching", 0}, {"invalid", 5000}};
  EXPECT_EQ(unjudged(both),
            std::vector<std::string>{"<script> binary64: NOT JUDGED on lattice: none of its queries is valid"});
}

// A level of depths said this before it asked how much was looked at: wrong verdicts, missing answers and, but at
// `depth`, `invalid` ones refuse it, and one decided query was enough.
LevelState by_failures_alone(Json record, double missed, double phantom, bool allows_invalid) {
  std::uint64_t failures = 0, decided = 0;
  for (const Json& family : kernel_of(record)["families"]) {
    const auto number = [&](const char* member) { return family["verdict"][member].get<std::uint64_t>(); };
    failures += number("unanswered") + (allows_invalid ? 0 : number("invalid"));
    failures += number("false_separation") * (family["verdict"]["deepest_false_separation"].get<double>() > missed);
    failures += number("false_contact") * (family["verdict"]["deepest_false_contact"].get<double>() > phantom);
    decided += family["trials"].get<std::uint64_t>() - number("undecided") - number("invalid") - number("unanswered");
  }
  return failures != 0 ? LevelState::not_met : decided == 0 ? LevelState::not_checked : LevelState::met;
}

TEST(LookedAt, NoVerdictOfALevelBecameMilder) {
  constexpr unsigned seed = 43;
  std::mt19937 random(seed);
  const auto one_of = [&](std::initializer_list<std::uint64_t> all) { return *(all.begin() + random() % all.size()); };
  std::size_t met = 0;
  for (int i = 0; i < 3000; ++i) {
    Json record = right_kernel();
    kernel_of(record)["may_decline"] = random() % 2 == 0;
    for (const char* family : {"lattice", "tangent"}) {
      Json& verdict = verdict_of(record, family);
      verdict["false_separation"] = one_of({0, 0, 0, 0, 0, 3});
      verdict["false_contact"] = one_of({0, 0, 0, 0, 0, 2});
      verdict["deepest_false_separation"] = verdict["false_separation"] == 0 ? 0.0 : random() % 2 == 0 ? 1e-3 : 0.5;
      verdict["deepest_false_contact"] = verdict["false_contact"] == 0 ? 0.0 : random() % 2 == 0 ? 1e-3 : 0.5;
      verdict["invalid"] = one_of({0, 0, 0, 0, 1});
      verdict["unanswered"] = one_of({0, 0, 0, 0, 1});
      decline(verdict, one_of({0, 0, 500, 1990}), 0, one_of({0, 0, 500, 2990}));
    }
    constexpr double any = 2, none = -1;
    const std::tuple<const char*, double, double, bool> asked[] = {
        {"exact", none, none, false}, {"conservative", none, any, false}, {"depth=0.01", 0.01, 0.01, true}};
    const Record judged = edited(record);
    for (const auto& [level, missed, phantom, allows_invalid] : asked) {
      const LevelState before = by_failures_alone(record, missed, phantom, allows_invalid);
      const LevelState now = judged_at(judged, level).state;
      met += now == LevelState::met;
      EXPECT_TRUE(now == before || now == LevelState::not_met || before == LevelState::met)
          << level << ", seed " << seed << ", record " << i << ": " << name(before) << " became " << name(now);
    }
  }
  EXPECT_GT(met, 100u) << "seed " << seed;
}

}  // namespace
}  // namespace axiscert
