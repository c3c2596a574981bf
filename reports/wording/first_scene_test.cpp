// The wrong verdict that a page draws first, and its words.
#include "fuzz/text/json_form.h"
#include "reports/testing/test_run.h"
#include "reports/wording/everyday.h"

namespace axiscert {
namespace {

Json witness(const char* id, const char* family, double depth, double length, const char* shows) {
  Json made = stored_record()["witnesses"][1];
  made["id"] = id;
  made["family"] = family;
  made["depth"] = depth;
  made["length"] = length;
  made["shows"] = {shows};
  return made;
}

Record record_of_witnesses(const std::vector<Json>& witnesses) {
  Json record = stored_record();
  record["witnesses"] = witnesses;
  return read_as<Record>(record);
}

TEST(WorstScene, IsTheFarthestOfTheEverydayOnes) {
  constexpr const char* farthest = "farthest false_separation";
  const Json near = witness("near", "scene-edge", 0.5, 0.25, farthest),
             far = witness("far", "scene-walk", 0.25, 0.5, farthest),
             own = witness("own", "mesh/a.obj", 0.9, 8, farthest), hard = witness("hard", "tangent", 1, 1e30, farthest),
             deepest = witness("deepest", "scene-walk", 1, 9, "deepest false_separation");
  EXPECT_EQ(worst_scene(record_of_witnesses({near, hard, own, deepest, far}))->id, "far");
  EXPECT_EQ(worst_scene(record_of_witnesses({hard, own}))->id, "own");
  EXPECT_EQ(worst_scene(record_of_witnesses({witness("less", "tangent", 0.5, 1, farthest), hard}))->id, "hard");
  EXPECT_EQ(worst_scene(record_of_witnesses({})), nullptr);
  Json right = near;
  right["depth"] = nullptr;
  EXPECT_EQ(worst_scene(record_of_witnesses({right})), nullptr);
}

TEST(WorstScene, HasItsSizeInMetres) {
  const auto words = [](Json made, const char* unit = nullptr) {
    Record record = record_of_witnesses({std::move(made)});
    if (unit != nullptr) record.plan.unit = Name(unit);
    return scene_words(record.witnesses[0], record.plan);
  };
  Json missed = witness("w", "scene-edge", 0.0123, 0.166, "farthest");
  EXPECT_EQ(words(missed), "misses a contact 16.6 cm deep in a scene of 13.5 m: 0.0123 of the scene");
  Json invented = missed;
  invented["computed"] = "contact";
  EXPECT_EQ(words(invented), "invents a contact across a gap of 16.6 cm in a scene of 13.5 m: 0.0123 of the scene");
  missed["family"] = "mesh/a.obj";
  EXPECT_EQ(words(missed), "misses a contact 0.166 units deep in a scene of 13.5 units: 0.0123 of the scene");
  EXPECT_EQ(words(missed, "cm"), "misses a contact 1.66 mm deep in a scene of 13.5 cm: 0.0123 of the scene");
  missed["family"] = "tangent";
  EXPECT_EQ(words(missed), "misses a contact, by 0.0123 of the scene");
  missed["depth"] = missed["length"] = 0.0;
  EXPECT_EQ(words(missed), "misses a contact where the two only touch");
}

}  // namespace
}  // namespace axiscert
