// The cause that breaks first, by the classes of the input and by links, and the witnesses that a certificate shows.
#include "reports/certificate/findings/breaks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reports/testing/edited_record.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

Json class_counts(int missed, int phantom, double deepest) {
  return {{"false_separation", missed},
          {"false_contact", phantom},
          {"deepest", deepest},
          {"witness", "1:tangent:1:binary32:0:5"}};
}
// The stored record with wrong verdicts of `published` on `tangent` counted by classes of the input.
Json record_with(const Json& classes) {
  Json record = stored_record();
  tangent_counts(record)["classes"] = classes;
  return record;
}

TEST(WhatBreaksFirst, IsTheClassOfTheDeepestMissedContact) {
  const auto first = what_breaks_first(edited(record_with({{"tie", class_counts(3, 0, 0.1)},
                                                           {"scale", class_counts(2, 0, 0.5)},
                                                           {"far", class_counts(0, 9, 0.9)},
                                                           {"sliver", class_counts(4, 0, 0.2)}})),
                                       "published");
  EXPECT_EQ(first->cause, "scale");
  EXPECT_EQ(first->what, "missed contact");
  EXPECT_EQ(first->precision, Precision::binary32);
  EXPECT_EQ(first->count, 2u);
  EXPECT_EQ(first->deepest, "0.5");
  EXPECT_EQ(first->section, "docs/error_model.md#units-of-length");
}

TEST(WhatBreaksFirst, IsAPhantomWhereNoContactIsMissed) {
  Json record = record_with({{"far", class_counts(0, 9, 0.9)}, {"tie", class_counts(0, 3, 0.1)}});
  // Nor by the links of a witness.
  for (auto& [name, family] : record["kernels"][0]["families"].items()) family["verdict"]["false_separation"] = 0;
  const auto first = what_breaks_first(edited(record), "published");
  EXPECT_EQ(first->cause, "far");
  EXPECT_EQ(first->what, "phantom contact");
}

TEST(WhatBreaksFirst, IsTheLinkOfTheDeepestWitnessWithoutClasses) {
  const auto first = what_breaks_first(edited(stored_record()), "published");
  EXPECT_EQ(first->cause, "rounding");
  EXPECT_EQ(first->what, "missed contact");
  EXPECT_EQ(first->deepest, "0.25");
}

TEST(WhatBreaksFirst, IsAFindingOfTheKernelBeforeAnyVerdict) {
  Json record = record_with({{"tie", class_counts(3, 0, 0.1)}});
  record["findings"] = Json::array({{{"kernel", "<script>"},
                                     {"precision", "binary32"},
                                     {"kind", "crash"},
                                     {"family", "tangent"},
                                     {"count", 2},
                                     {"address", "1:tangent:1:binary32:0:5"},
                                     {"detail", "it died"}}});
  EXPECT_EQ(what_breaks_first(edited(record), "published")->cause, "tie");
  record["findings"][0]["kernel"] = "published";
  const auto first = what_breaks_first(edited(record), "published");
  EXPECT_EQ(first->cause, "finding");
  EXPECT_EQ(first->count, 2u);
}

TEST(WitnessesOfACertificate, AreTheKernelsOwnEachOnceAndOfAsManyFamiliesAsThereAre) {
  const auto worst = worst_of_certificate(edited(stored_record()), "published");
  ASSERT_EQ(worst.size(), 3u);
  EXPECT_EQ(worst[0].address, "1:tangent:1:binary32:0:34");
  EXPECT_THAT(worst[1].address, testing::StartsWith("1:mesh-"));
  EXPECT_EQ(worst[2].address, "1:tangent:1:binary32:0:17");
  EXPECT_THAT(worst[0].sentence, HasSubstr("The truth is contact, the kernel says separated, 0.25 of the scene deep."));
  EXPECT_FALSE(worst[0].query.json.contains("predicate"));
  EXPECT_EQ(worst[0].query.json["r"], "0x1.8p-1");
}

TEST(WitnessesOfACertificate, OfAnotherPredicateNameItAndHaveAllItsNumbers) {
  Json record = stored_record();
  record["plan"]["predicate"] = "moving-sphere";
  for (Json& witness : record["witnesses"]) witness["d"] = {"0x1p+0", "0x0p+0", "0x0p+0"};
  const auto worst = worst_of_certificate(edited(record), "published");
  ASSERT_FALSE(worst.empty());
  EXPECT_EQ(worst[0].query.json.value("predicate", std::string()), "moving-sphere");
  EXPECT_EQ(worst[0].query.json.value("d", Json()), record["witnesses"][0]["d"]);
}

}  // namespace
}  // namespace axiscert
