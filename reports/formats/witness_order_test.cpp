// The order of the witnesses of a page: causes first, ordinary queries before others.
#include "fuzz/text/json_form.h"
#include "reports/formats/witness_order.h"

#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

// A witness like the stored one, with ordinary numbers: `links` says why it is wrong.
Json wrong(const char* id, double depth, Json links, const char* radius = "0x1p-1") {
  Json witness = stored_record()["witnesses"][0];
  witness["id"] = id;
  witness["depth"] = depth;
  witness["b"] = {"0x1p+1", "0x0p+0", "0x0p+0"};
  witness["r"] = radius;
  witness["flips"] = Json::array({{{"level", "verdict"},
                                   {"name", "verdict"},
                                   {"kind", "false_contact"},
                                   {"decisive", true},
                                   {"links", std::move(links)}}});
  return witness;
}

std::vector<std::string> ids_of(const std::vector<Json>& witnesses, std::size_t limit = 100) {
  Json stored = stored_record();
  stored["witnesses"] = witnesses;
  const Record record = read_as<Record>(stored);
  std::vector<std::string> ids;
  for (const WitnessRecord* witness : shown_witnesses(record, limit)) ids.push_back(witness->id);
  return ids;
}

using Ids = std::vector<std::string>;

TEST(WitnessOrder, BeginsWithOneOfEachCause) {
  const Json rounding = Json::array({"rounding"}), specification = Json::array({"specification"});
  EXPECT_EQ(ids_of({wrong("r1", 0.9, rounding), wrong("r2", 0.8, rounding), wrong("s1", 0.1, specification),
                    wrong("s2", 0.05, specification)}),
            (Ids{"r1", "s1", "r2", "s2"}));
}

TEST(WitnessOrder, BeginsWithTheShortestOfEachCause) {
  const Json rounding = Json::array({"rounding"});
  EXPECT_EQ(ids_of({wrong("deep", 0.9, rounding, "0x1.23456p-1"), wrong("short", 0.1, rounding)}),
            (Ids{"short", "deep"}));
}

TEST(WitnessOrder, BeginsWithOneOfEachClassOfInput) {
  const Json unknown = Json::array({"unattributed"});
  Json sliver = wrong("sliver", 0.1, unknown), deep = wrong("deep", 0.9, unknown),
       second = wrong("second", 0.8, unknown);
  sliver["class"] = "sliver";
  deep["class"] = second["class"] = "scale";
  EXPECT_EQ(ids_of({deep, second, sliver}), (Ids{"deep", "sliver", "second"}));
}

TEST(WitnessOrder, PutsOrdinaryQueriesBeforeDeeperExoticOnes) {
  const Json range = Json::array({"range"}), rounding = Json::array({"rounding"});
  // The ordinary witness of a cause is shown first; a cause that has exotic ones only comes after those that have
  // others.
  EXPECT_EQ(
      ids_of({wrong("huge", 1, range, "0x1p+60"), wrong("plain", 0.1, range), wrong("tiny", 1, rounding, "0x1p-60")}),
      (Ids{"plain", "tiny", "huge"}));
}

TEST(WitnessOrder, KeepsTheCausesWhereThereIsRoomForFew) {
  const Json rounding = Json::array({"rounding"}), range = Json::array({"range"});
  EXPECT_EQ(ids_of({wrong("r1", 0.9, rounding), wrong("r2", 0.8, rounding), wrong("r3", 0.7, rounding),
                    wrong("g", 0.1, range)},
                   2),
            (Ids{"r1", "g"}));
  EXPECT_TRUE(ids_of({wrong("r1", 0.9, rounding)}, 0).empty());
}

TEST(WitnessOrder, HasTheOnesThatAreNamed) {
  const Json rounding = Json::array({"rounding"});
  Json stored = stored_record();
  stored["witnesses"] = {wrong("r1", 0.9, rounding), wrong("r2", 0.8, rounding), wrong("r3", 0.7, rounding)};
  const Record record = read_as<Record>(stored);
  const auto shown = shown_witnesses(record, 2, {"r3"});
  ASSERT_EQ(shown.size(), 2u);
  EXPECT_EQ(shown[1]->id, "r3");
}

TEST(WitnessOrder, OrdinaryIsOfTheSizesOfAScene) {
  const PlanRecord plan = read_as<PlanRecord>(stored_record()["plan"]);
  const auto with_radius = [](const char* radius) {
    return read_as<WitnessRecord>(wrong("w", 1, Json::array({"range"}), radius));
  };
  EXPECT_TRUE(is_ordinary(with_radius("0x0p+0"), plan));
  EXPECT_TRUE(is_ordinary(with_radius("0x1p+20"), plan));
  for (const char* radius : {"0x1.8p+20", "0x1p-21", "0x1p-149", "nan", "inf"})
    EXPECT_FALSE(is_ordinary(with_radius(radius), plan)) << radius;
  WitnessRecord subnormal = with_radius("0x1p-1");
  subnormal.numbers.at("a").numbers[0] = "0x1p-149";
  EXPECT_FALSE(is_ordinary(subnormal, plan));
}

}  // namespace
}  // namespace axiscert
