// Manifests that are accepted, and that everything else is refused with what would be right.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "kernel/base/error.h"
#include "kernel/plugin/manifest.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::plugin {
namespace {

const std::string least = R"("format":"axiscert-program/2","name":"a","command":["x","y z"],"precisions":["binary64"])";

std::string manifest_refusal(const std::string& text) {
  try {
    read_manifest(text, "m.json");
  } catch (const Error& error) {
    return error.what();
  }
  return "it was accepted";
}

TEST(ManifestFile, NeedsFourMembersAndTheOthersHaveDefaults) {
  const Manifest manifest = read_manifest("{" + least + "}", "m.json");
  EXPECT_EQ(manifest.name, "a");
  EXPECT_EQ(manifest.command, (std::vector<std::string>{"x", "y z"}));
  EXPECT_EQ(manifest.precisions, std::vector{Precision::binary64});
  EXPECT_EQ(manifest.exposes, Exposure::verdict);
  EXPECT_EQ(manifest.touching, TouchingPolicy::contact);
  EXPECT_FALSE(manifest.limits.any());
}

TEST(ManifestFile, DeclaresWhatAPluginDeclares) {
  const Manifest manifest = read_manifest(
      "{" + least + R"(,"touching":"either","exposes":"comparisons","limits":{"least_radius":0.5},"predicate":"t"})",
      "m.json");
  EXPECT_EQ(manifest.touching, TouchingPolicy::either);
  EXPECT_EQ(manifest.exposes, Exposure::comparisons);
  EXPECT_EQ(manifest.limits.least_radius, 0.5);
  EXPECT_EQ(manifest.predicate, "t");
  EXPECT_EQ(manifest.measures, 0u);
  EXPECT_FALSE(manifest.may_decline);
  EXPECT_TRUE(read_manifest("{" + least + R"(,"may_decline":true})", "m.json").may_decline);
  EXPECT_FALSE(read_manifest("{" + least + R"(,"may_decline":false})", "m.json").may_decline);
  EXPECT_EQ(manifest.motion, MotionPolicy{});
}

TEST(ManifestFile, DeclaresMeasuresAndWhatIsNotPromisedOfMotions) {
  const Manifest manifest = read_manifest(
      "{" + least + R"(,"measures":8,"motion":{"start":"approaching","still":"ignored","sides":"front"}})", "m.json");
  EXPECT_EQ(manifest.measures, 8u);
  EXPECT_EQ(manifest.motion, (MotionPolicy{StartPolicy::approaching, StillPolicy::ignored, SidesPolicy::front}));
}

TEST(ManifestFile, DeclaresAMarginAndTheSidesOfATriangle) {
  const Manifest manifest = read_manifest("{" + least + R"(,"limits":{"margin":0.001},"sides":"front"})", "m.json");
  EXPECT_EQ(manifest.limits, (Limits{.margin = 0.001, .sides = SidesPolicy::front}));
}

TEST(ManifestFile, SaysHowItsEngineIsAskedByHand) {
  const Manifest manifest = read_manifest(
      "{" + least + R"(,"code":["import { v } from 'x';","ask({a}, {cz}, {r}, ${}, {x: 1}, {R});"]})", "m.json");
  std::vector<std::string> numbers;
  for (int k = 1; k <= 13; ++k) numbers.push_back(std::to_string(k));
  EXPECT_EQ(filled_code(manifest.code, sphere_triangle_predicate().entries[0], numbers),
            "import { v } from 'x';\nask(1, 2, 3, 9, 13, ${}, {x: 1}, {R});\n");
}

TEST(ManifestFile, HasPlacesForTheColumnsOfItsPredicate) {
  const std::string moving = R"(,"predicate":"moving-sphere","code":["{d} {dx}"])", still = R"(,"code":["{dx}"])";
  EXPECT_EQ(manifest_refusal("{" + least + moving + "}"), "it was accepted");
  EXPECT_THAT(manifest_refusal("{" + least + still + "}"), testing::HasSubstr("unknown place {dx}; known: {ax}, {ay}"));
}

TEST(ManifestFile, IsRefusedWithWhatWouldBeRight) {
  for (const auto& [text, says] : std::vector<std::pair<std::string, std::string>>{
           {"", "m.json: not a manifest: it is not JSON"},
           {"[1]", "not a manifest: a JSON object with \"format\": \"axiscert-program/2\""},
           {R"({"name":"x"})", "not a manifest"},
           {R"({"format":"axiscert-program/1"})",
            "m.json: format 'axiscert-program/1', but this axiscert reads axiscert-program/2: write the manifest again "
            "as "
            "docs/plugins.md has it, and its program for streams of version 3"},
           {R"({"format":7})", "\"format\" is 7, which is no text"},
           {R"({"format":"axiscert-program/2"})", "no \"name\""},
           {R"({"format":"axiscert-program/2","name":"a"})", "no \"command\""},
           {R"({"format":"axiscert-program/2","name":"a","command":"node x"})",
            "\"command\" is \"node x\", which is no list"},
           {R"({"format":"axiscert-program/2","name":"a","command":["x"]})", "no \"precisions\""},
           {"{" + least + R"(,"comand":1})", "unknown member 'comand'; did you mean 'command'?"},
           {"{" + least + R"(,"touching":"no"})", "\"touching\": 'no'; known: contact, separated, either"},
           {"{" + least + R"(,"exposes":"sides"})", "known: verdict, comparisons"},
           {"{" + least + R"(,"measures":-1})", "\"measures\" is -1; known: 0 to 64"},
           {"{" + least + R"(,"measures":"all"})", "\"measures\" is \"all\""},
           {"{" + least + R"(,"motion":"front"})", "\"motion\" is \"front\", which is no object"},
           {"{" + least + R"(,"motion":{"sides":"back"}})", "\"sides\": 'back'; known: both, front"},
           {"{" + least + R"(,"motion":{"stop":1}})", "unknown member 'stop'"},
           {"{" + least + R"(,"sides":"back"})", "\"sides\": 'back'; known: both, front"},
           {"{" + least + R"(,"limits":{"margin":-1}})", "\"margin\" is -1"},
           {"{" + least + R"(,"may_decline":1})", "\"may_decline\" is 1; known: true, false"},
           {"{" + least + R"(,"may_decline":"yes"})", "\"may_decline\" is \"yes\"; known: true, false"},
           {"{" + least + R"(,"limits":{"least_radius":-1}})", "\"least_radius\" is -1"},
           {"{" + least + R"(,"limits":{"radius":1}})", "unknown limit 'radius'"},
           {"{" + least + R"(,"files":"a.mjs"})", "\"files\" is \"a.mjs\", which is no list"},
           {"{" + least + R"(,"code":"ask"})", "\"code\" is \"ask\", which is no list"},
           {"{" + least + R"(,"code":["a\nb"]})", "\"code\": 'a\\nb' is more than a line"},
           {"{" + least + R"(,"code":["f({ax}, {radius});"]})", "unknown place {radius}; known: {ax}, "},
           {"{" + least + R"(,"summary":{"a":1}})", "\"summary\" is an object, which is no text"}}) {
    EXPECT_THAT(manifest_refusal(text), testing::HasSubstr(says)) << text;
  }
}

}  // namespace
}  // namespace axiscert::plugin
