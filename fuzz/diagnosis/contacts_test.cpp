// What a diagnosis says of the numbers beside a verdict, on kernels with one planted fault each.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <map>
#include <string>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/diagnosis/probes.h"
#include "fuzz/text/json.h"
#include "kernel/planted_contacts_testing.h"

namespace axiscert::diagnosis {
namespace {

// By property, the values that are not to be expected of a right kernel.
std::map<std::string, std::string> said_of(const Kernel& kernel) {
  const DiagnosisOptions options;
  std::map<std::string, std::string> said;
  const auto ask = [&](const char* name, ProbeFinding (*probe)(Subject<float>&)) {
    Subject<float> subject(kernel, options);
    const ProbeFinding found = probe(subject);
    EXPECT_FALSE(found.sentence.empty());
    if (found.value != "right") said[name] = found.value;
    EXPECT_EQ(found.witnesses.empty(), found.value == "right" || found.value == not_asked) << found.sentence;
  };
  ask("separation", separations<float>);
  ask("normal", normals<float>);
  ask("feature", features<float>);
  ask("contact_point", contact_points<float>);
  return said;
}

TEST(ContactProbes, NameEachPlantedFaultAndNoRightChoice) {
  using Said = std::map<std::string, std::string>;
  const std::map<std::string, Said> due = {
      {"right", {}},
      {"other-side-of-a-tie", {}},
      {"nothing-beside-separated", {}},
      {"flipped", {{"normal", "flipped"}}},
      {"tilted", {{"normal", "tilted"}}},
      {"not-normalised", {{"normal", "not_normalised"}}},
      {"face-always", {{"feature", "one_part"}}},
      {"depth-against-the-plane", {{"separation", "against_plane"}}},
      {"on-the-sphere", {{"contact_point", "other_body"}}},
      {"margin-of-5-mm", {{"separation", "margin"}}},
      {"never-positive", {{"separation", "never_positive"}}},
      {"some-points-missing", {{"contact_point", "missing"}}},
      {"some-normals-missing", {{"normal", "missing"}}},
      {"some-features-missing", {{"feature", "missing"}}},
      {"some-without-numbers",
       {{"separation", "missing"}, {"normal", "missing"}, {"feature", "missing"}, {"contact_point", "missing"}}},
      {"no-separation", {{"separation", "not_known"}}}};
  const Kernel& right = find_kernel("minkowski");
  for (const PlantedContact& planted : planted_contacts()) {
    if (planted.name == std::string_view("no-separation")) continue;  // which has no query to show
    const Kernel kernel = with_edit(right, planted.name, planted.change);
    EXPECT_EQ(said_of(kernel), due.at(planted.name)) << planted.name;
  }
}

// Those of kernel/boxes/contact_faults, which box_contacts_test.py diagnoses some of as plug-ins.
TEST(ContactProbes, NameEachPlantedFaultOfTwoBoxes) {
  constexpr std::size_t separation = 0, normal = 1;
  const auto value = [](const char* name, ProbeFinding (*probe)(Subject<float>&),
                        void (*change)(MeasureColumns&, std::size_t)) {
    const Kernel kernel =
        with_edit(find_kernel("box-box/cofactor"), name,
                  [change](MeasureColumns& m, const QueryColumns<float>&, std::size_t i) { change(m, i); });
    const DiagnosisOptions options;
    Subject<float> subject(kernel, options);
    return probe(subject).value;
  };
  const auto flip = [](MeasureColumns& m, std::size_t i) {
    for (std::size_t k = normal; k < normal + 3; ++k) m[k][i] *= -1;
  };
  const auto tilt = [](MeasureColumns& m, std::size_t i) {  // by 1e-3, about an axis that it is far from
    const std::size_t other = std::fabs(m[normal + 2][i]) > 0.9f ? normal + 2 : normal + 1;
    const float x = m[normal][i], y = m[other][i], angle = 1e-3f;
    m[normal][i] = x * std::cos(angle) - y * std::sin(angle);
    m[other][i] = x * std::sin(angle) + y * std::cos(angle);
  };
  const auto lengthen = [](MeasureColumns& m, std::size_t i) {
    for (std::size_t k = normal; k < normal + 3; ++k) m[k][i] *= 1.5f;
  };
  EXPECT_EQ(value("flipped", normals<float>, flip), "flipped");
  EXPECT_EQ(value("tilted", normals<float>, tilt), "tilted");
  EXPECT_EQ(value("not-unit", normals<float>, lengthen), "not_normalised");
  EXPECT_EQ(value("halved", separations<float>, [](MeasureColumns& m, std::size_t i) { m[separation][i] *= 0.5f; }),
            "scaled");
  EXPECT_EQ(value("margin", separations<float>, [](MeasureColumns& m, std::size_t i) { m[separation][i] -= 0.01f; }),
            "margin");
}

// A normal may be far off for rounding now and then: not to the other side, nor in its length.
TEST(ContactProbes, NameANormalThatIsOffNowAndThen) {
  // The normal times `few` on about one query in 37, by a hash of it, and times `most` on the others.
  const auto value = [](const char* name, float few, float most) {
    const auto scale = [few, most](MeasureColumns& m, const QueryColumns<float>& q, std::size_t i) {
      const bool is_one = std::hash<float>()(q.column[0][i] + 3 * q.column[9][i]) % 37 == 0;
      for (std::size_t k = 2; k < 5; ++k) m[k][i] *= is_one ? few : most;
    };
    const Kernel kernel = with_edit(find_kernel("minkowski"), name, scale);
    const DiagnosisOptions options;
    Subject<float> subject(kernel, options);
    return normals(subject).value;
  };
  EXPECT_EQ(value("zero", 0, 0), "not_normalised");
  EXPECT_EQ(value("few-long", 2, 1), "not_normalised");
  EXPECT_EQ(value("few-flips", -1, 1), "wrong");
  EXPECT_EQ(value("few-zero", 0, 1), "not_normalised");
}

// Random triangles are never level: the clear queries by which rules are found show nothing of these.
TEST(ContactProbes, NameAFaultOfLevelTrianglesAlone) {
  const auto on_level = [](const char* name, void (*change)(MeasureColumns&, std::size_t)) {
    return said_of(with_edit(find_kernel("minkowski"), name,
                             [change](MeasureColumns& m, const QueryColumns<float>& q, std::size_t i) {
                               const float height = q.column[2][i];
                               if (q.column[5][i] == height && q.column[8][i] == height) change(m, i);
                             }));
  };
  using Said = std::map<std::string, std::string>;
  EXPECT_EQ(on_level("half", [](MeasureColumns& m, std::size_t i) { m[0][i] *= 0.5f; }),
            (Said{{"separation", "wrong"}}));
  EXPECT_EQ(on_level("other-part", [](MeasureColumns& m, std::size_t i) { m[1][i] = m[1][i] == 0 ? 1.0f : 0.0f; }),
            (Said{{"feature", "wrong"}}));
  EXPECT_EQ(on_level("turned", [](MeasureColumns& m, std::size_t i) { m[4][i] *= -1; }), (Said{{"normal", "wrong"}}));
  EXPECT_EQ(on_level("long",
                     [](MeasureColumns& m, std::size_t i) {
                       for (std::size_t k = 2; k < 5; ++k) m[k][i] *= 2;
                     }),
            (Said{{"normal", "not_normalised"}}));
  EXPECT_EQ(on_level("tilted", [](MeasureColumns& m, std::size_t i) { m[2][i] += 0.5f; }), (Said{{"normal", "wrong"}}));
  EXPECT_EQ(on_level("moved", [](MeasureColumns& m, std::size_t i) { m[7][i] *= 1.5f, m[7][i] += 0.5f; }),
            (Said{{"contact_point", "wrong"}}));
}

// Each of two faults of normals has its figure, and a length of any size hides no flip.
TEST(ContactProbes, TellAFlipFromALength) {
  const auto is_long = [](float a, float p) { return std::hash<float>()(a + 3 * p) % 2 == 0; };
  const Kernel kernel = with_edit(find_kernel("minkowski"), "flips-and-lengths",
                                  [=](MeasureColumns& m, const QueryColumns<float>& q, std::size_t i) {
                                    const float height = q.column[2][i];
                                    if (q.column[5][i] != height || q.column[8][i] != height) return;
                                    for (std::size_t k = 2; k < 5; ++k)
                                      m[k][i] *= is_long(q.column[0][i], q.column[9][i]) ? 11.0f : -1.0f;
                                  });
  const DiagnosisOptions options;
  Subject<float> subject(kernel, options);
  const ProbeFinding found = normals(subject);
  EXPECT_EQ(found.value, "wrong") << found.sentence;
  EXPECT_GT(found.measured["turned"], 0);
  EXPECT_GT(found.measured["wrong"], found.measured["turned"]);
  EXPECT_NEAR(found.measured["largest_length_error"].get<double>(), 10, 1e-5);
  ASSERT_EQ(found.witnesses.size(), 1u);
  EXPECT_EQ(found.witnesses[0].shows, "the normal goes to the other side");
  const Json query = Json::parse(found.witnesses[0].query);
  const auto number = [&](const char* of) { return std::strtof(query[of][0].get<std::string>().c_str(), nullptr); };
  EXPECT_FALSE(is_long(number("a"), number("p"))) << found.witnesses[0].query;
}

// A method that computes in the coordinates of the world errs by roundings of these: in a scene that is small and far
// off they may be more than the depth.
TEST(ContactProbes, AreRightOfAMethodInWorldCoordinates) {
  const Kernel& right = find_kernel("box-box/cofactor");
  const std::vector<PredicateColumn>& columns = right.predicate->entries[right.entry].columns;
  // Its normals go to the other side where the depth is at most so many u of the greatest coordinate or length.
  const auto value = [&](const char* name, float roundings) {
    const auto change = [&columns, roundings](MeasureColumns& m, const QueryColumns<float>& q, std::size_t i) {
      float greatest = 0;
      for (std::size_t k = 0; k < q.count; ++k) {
        if (columns[k].role != Role::direction) greatest = std::max(greatest, std::fabs(q.column[k][i]));
      }
      if (!(std::fabs(m[0][i]) <= roundings * 0x1p-24f * greatest)) return;
      for (std::size_t k = 1; k < 4; ++k) m[k][i] *= -1;
    };
    const Kernel kernel = with_edit(right, name, change);
    const DiagnosisOptions options;
    Subject<float> subject(kernel, options);
    return normals(subject).value;
  };
  EXPECT_EQ(value("in-world", 120), "right");
  EXPECT_EQ(value("further", 1024), "wrong");
}

TEST(ContactProbes, TellTheSizeOfAMargin) {
  const DiagnosisOptions options;
  const Kernel& right = find_kernel("minkowski");
  const Kernel kernel = with_edit(
      right, "margin", [](MeasureColumns& m, const QueryColumns<float>&, std::size_t i) { m[0][i] -= 0.005f; });
  Subject<float> subject(kernel, options);
  const ProbeFinding found = separations(subject);
  EXPECT_NEAR(found.measured["margin"].get<double>(), -0.005, 1e-5) << found.sentence;
}

TEST(ContactProbes, AreNotAskedOfAKernelThatGivesNone) {
  const Kernel& kernel = find_kernel("published");
  for (const auto& [property, value] : said_of(kernel)) EXPECT_EQ(value, not_asked) << property;
  EXPECT_EQ(said_of(kernel).size(), 4u);
}

TEST(ContactProbes, AreRightOfTheTwoMethods) {
  for (const char* id : {"minkowski", "closest-point"}) EXPECT_TRUE(said_of(find_kernel(id)).empty()) << id;
}

}  // namespace
}  // namespace axiscert::diagnosis
