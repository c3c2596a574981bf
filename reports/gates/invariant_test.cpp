// Verdicts that change with an exact image: what `logic` and `invariant=KIND` refuse, and how they say it.
#include "fuzz/text/json.h"
#include "reports/gates/requirement.h"
#include "reports/testing/edited_record.h"
#include "reports/gates/invariant_level.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

Json changes(std::uint64_t changed, const Json& by_size) {
  const Json pair = {{"base", "u:1"}, {"image", "u:3"}};
  return {{"images", 1000},
          {"changed", changed},
          {"undecided", 0},
          {"by_size", by_size},
          {"first", changed ? pair : Json(nullptr)}};
}
Json nothing_found() { return {{"bases", 0}, {"compared", Json::array()}}; }
// Images times powers of two: `changed` have another verdict, of which `wrong` are clear and wrong.
Json scale(std::uint64_t changed, std::uint64_t wrong) {
  Json json = changes(changed, changed ? Json{{"-9", 2}, {"-7", 1}} : Json::object());
  json["range"] = {{"least", -20}, {"greatest", 17}};
  json["wrong"] = {{"count", wrong},
                   {"by_size", wrong ? Json{{"-9", 2}} : Json::object()},
                   {"first", wrong ? json["first"] : Json(nullptr)},
                   {"where_small", nothing_found()},
                   {"where_large", nothing_found()}};
  if (wrong) {
    json["wrong"]["where_small"] = {
        {"bases", 5},
        {"compared", {{{"quantity", "r"}, {"degree", 1}, {"least", 0.008}, {"greatest", 0.0125}, {"explains", 5}}}}};
  }
  return json;
}

// `<script>`, which shows verdicts alone, on a lattice without a fault, with this instead of its other family.
Json black_box(const std::string& family, bool exact_arithmetic, const Json& invariance) {
  Json record = stored_record();
  for (Json* kernels : {&record["kernels"], &record["plan"]["kernels"]}) kernels->erase(0);
  Json& families = record["kernels"][0]["families"];
  families["lattice"]["verdict"]["touching_flips"] = 5;
  families["lattice"]["verdict"]["invalid"] = 0;
  families[family] = families["tangent"];
  families.erase("tangent");
  families[family]["exact_arithmetic"] = exact_arithmetic;
  families[family]["invariance"] = invariance;
  record["witnesses"] = Json::array();
  return record;
}
Json with_scale(const Json& changes) { return black_box("units", true, {{"scale", changes}}); }

TEST(Invariant, LogicOfAKernelOfVerdictsRefusesWhatIsClearlyWrongInAnotherUnitOfLength) {
  const auto failures = unmet(with_scale(scale(3, 2)), "logic");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].count, 2u);
  EXPECT_EQ(
      failures[0].what,
      "wrong verdicts in another unit of length alone (times powers of two from 2^-9 down), on queries that are no "
      "close "
      "calls; where numbers are small, as if an absolute number near 0.01 (squared 0.0001) were compared with r; first "
      "on u:3 beside u:1");
}

// A form of degree 8 leaves its range at three quarters of the powers at which one of degree 6 does.
TEST(Invariant, SaysThatAFormOfAHigherDegreeMayHaveLeftItsRange) {
  const auto said = [](int power) {
    Json json = scale(3, 2);
    json["wrong"]["by_size"] = {{std::to_string(power), 2}};
    return unmet(with_scale(json), "logic").at(0).what;
  };
  EXPECT_THAT(said(-15), HasSubstr("were compared with r, or a form of a degree above 6 left its range; first on"));
  EXPECT_THAT(said(13), HasSubstr("a degree above 6"));
  EXPECT_THAT(said(-9), Not(HasSubstr("degree")));
}

TEST(Invariant, LogicRefusesAChangeThatIsNotClearToo) {
  const auto failures = unmet(with_scale(scale(3, 0)), "logic");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].count, 3u);
  EXPECT_THAT(failures[0].what, HasSubstr("from 2^-7 down"));
}

// The family has wrong verdicts; but they are the same in each unit, and may be of rounding at a touching sphere.
TEST(Invariant, LogicHoldsAKernelOfVerdictsToImagesAlone) {
  EXPECT_TRUE(unmet(with_scale(scale(0, 0)), "logic").empty());
  const auto outcomes = outcomes_at(with_scale(scale(0, 0)), "logic");
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].state, LevelState::met);
  EXPECT_THAT(outcomes[0].covers,
              HasSubstr("1,000 queries of units, each the same as another in another unit of length"));
  EXPECT_THAT(outcomes[0].leaves_out, Not(HasSubstr("other units of length")));
}

TEST(Invariant, LogicOfAKernelWithAReferenceGoesByItsLinks) {
  Json record = stored_record();
  record["kernels"].erase(1);
  for (Json& n : tangent_counts(record)["verdict"]["links"]) n = 0;
  tangent_counts(record)["invariance"] = {{"scale", scale(3, 2)}};
  EXPECT_TRUE(unmet(record, "logic").empty());
  EXPECT_EQ(unmet(record, "invariant=scale").size(), 1u);
}

TEST(Invariant, LogicSaysWhereNoOtherUnitOfLengthWasAsked) {
  Json record = with_scale(scale(0, 0));
  record["kernels"][0]["families"].erase("units");
  EXPECT_THAT(outcomes_at(record, "logic")[0].leaves_out, HasSubstr("other units of length"));
}

TEST(Invariant, KindsAreAskedByName) {
  const Json record =
      black_box("spans", false, {{"scale", scale(0, 0)}, {"translation", changes(4, {{"5", 1}, {"21", 3}})}});
  EXPECT_TRUE(unmet(record, "logic").empty());
  EXPECT_TRUE(unmet(record, "invariant=scale").empty());
  const auto failures = unmet(record, "invariant=translation");
  ASSERT_EQ(failures.size(), 1u);
  EXPECT_EQ(failures[0].what, "another verdict on the same query moved by 2^5 or more; first on u:3 beside u:1");
}

TEST(Invariant, AKindThatNoFamilyMakesIsNotChecked) {
  const auto outcomes = outcomes_at(with_scale(scale(0, 0)), "invariant=order");
  ASSERT_EQ(outcomes.size(), 1u);
  EXPECT_EQ(outcomes[0].state, LevelState::not_checked);
  EXPECT_THAT(outcomes[0].reason, HasSubstr("--family orders"));
  // It was asked, and none of its queries is an image.
  const auto asked = outcomes_at(black_box("orders", false, Json::object()), "invariant=order");
  ASSERT_EQ(asked.size(), 1u);
  EXPECT_THAT(asked[0].reason, HasSubstr("too few queries of orders were asked to have one"));
}

// Near tangency nothing is known of the range of every base: such images are reported, and no level goes by them.
TEST(Invariant, PowersOfTwoBeyondTheRangeAreNoEvidence) {
  Json near = changes(3, {{"31", 3}});
  near["range"] = nullptr;
  const Json record = black_box("scaled", false, {{"scale", near}});
  EXPECT_TRUE(unmet(record, "logic").empty());
  EXPECT_EQ(outcomes_at(record, "invariant=scale")[0].state, LevelState::not_checked);
}

TEST(Invariant, AnUnknownKindIsToldTheKinds) {
  for (const char* level : {"invariant=", "invariant", "invariant=size"}) {
    try {
      parse_level(level);
      ADD_FAILURE() << "accepted '" << level << "'";
    } catch (const Error& error) {
      EXPECT_THAT(error.what(), HasSubstr("invariant"));
    }
  }
}

TEST(Invariant, PowersAreToldFromTheOneNearestToOne) {
  EXPECT_EQ(powers_text({{-20, 1}, {-3, 1}}), "from 2^-3 down");
  EXPECT_EQ(powers_text({{7, 1}, {17, 1}, {-12, 4}}), "from 2^-12 down and from 2^7 up");
}

}  // namespace
}  // namespace axiscert
