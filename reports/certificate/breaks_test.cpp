// The cause that breaks first, by the classes of the input and by links, and the witnesses that a certificate shows.
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cctype>
#include <regex>
#include <set>
#include <sstream>

#include "fuzz/queries/capabilities.h"
#include "fuzz/queries/family.h"
#include "fuzz/text/file_bytes.h"
#include "fuzz/text/json.h"
#include "kernel/sphere_triangle/query.h"
#include "reports/certificate/breaks.h"
#include "reports/certificate/page.h"
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

// Situations of other predicates: every family is in one, the sections are there, and the most everyday fault is named
// first.

namespace {

using testing::HasSubstr;
using testing::Not;

// The headings of a page, as links name them.
std::set<std::string> anchors_of(const std::string& page) {
  std::set<std::string> anchors;
  std::istringstream lines(read_bytes(fmt::format("{}/{}", SOURCE_FOLDER, page)));
  for (std::string line; std::getline(lines, line);) {
    if (!line.starts_with("#")) continue;
    std::string anchor;
    for (const char c : line.substr(line.find(' ') + 1)) {
      if (c == ' ' || c == '-') anchor += '-';
      else if (std::isalnum(static_cast<unsigned char>(c)) || c == '_')
        anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    }
    anchors.insert(anchor);
  }
  return anchors;
}

bool is_there(std::string_view section) {
  const std::size_t at = section.find('#');
  return at != section.npos &&
         anchors_of(std::string(section.substr(0, at))).contains(std::string(section.substr(at + 1)));
}

// Those of families first.
std::vector<const Situation*> situations_of(const Predicate& predicate) {
  const Situations* situations = capabilities_of(predicate).situations;
  if (situations == nullptr) return {};
  return {situations->of_families.begin(), situations->of_families.end()};
}

TEST(Situations, HaveEveryFamilyOfOtherPredicates) {
  for (const Predicate* predicate : predicates()) {
    const std::vector<const Situation*> situations = situations_of(*predicate);
    EXPECT_EQ(situations.empty(), predicate == &sphere_triangle_predicate()) << predicate->id;
    std::set<const Situation*> named;
    for (const Family* family : families_of(*predicate)) {
      EXPECT_EQ(std::ranges::count(situations, family->situation), situations.empty() ? 0 : 1) << family->name;
      if (family->situation != nullptr) named.insert(family->situation);
    }
    EXPECT_EQ(named.size(), situations.size()) << predicate->id;
  }
}

TEST(Situations, AndCausesPointToSectionsThatAreThere) {
  EXPECT_FALSE(is_there("docs/moving.md#nowhere"));
  for (const Predicate* predicate : predicates()) {
    for (const Situation* situation : situations_of(*predicate))
      EXPECT_TRUE(is_there(situation->section)) << situation->section;
    const Situations* const all = capabilities_of(*predicate).situations;
    EXPECT_TRUE(all == nullptr || is_there(all->own.section)) << predicate->id;
  }
  EXPECT_TRUE(is_there(of_corpus.section));
  for (const std::string_view section : advised_sections()) EXPECT_TRUE(is_there(section)) << section;
}

struct Wrong {
  int missed, phantom;
  double deepest_missed, deepest_phantom;
};

// The record of a kernel of moving-sphere, wrong on these families.
Record record_of(const std::map<std::string, Wrong>& families) {
  Record record;
  record.plan.predicate = "moving-sphere";
  KernelRecord& kernel = record.kernels.emplace_back();
  kernel.id = "k";
  for (const auto& [family, wrong] : families) {
    VerdictTally& verdict = kernel.families.put(family == "corpus" ? family : "moving-sphere/" + family).verdict;
    verdict.false_separation = static_cast<std::uint64_t>(wrong.missed);
    verdict.false_contact = static_cast<std::uint64_t>(wrong.phantom);
    verdict.deepest_false_separation.offer({wrong.deepest_missed, 0});
    verdict.deepest_false_contact.offer({wrong.deepest_phantom, 0});
  }
  return record;
}

// And whether by its missed contacts; empty: none.
std::pair<std::string, bool> first_of(const std::map<std::string, Wrong>& families) {
  bool missed = true;
  const std::vector<WrongVerdicts> situations = wrong_situations(record_of(families), "k");
  const WrongVerdicts* first = first_situation(situations, missed);
  if (first == nullptr) return {};
  return {std::string(first->situation->name), missed};
}

std::pair<std::string, bool> situation_named(const std::string& situation, bool missed) { return {situation, missed}; }

TEST(Situations, TheMostEverydayOneWithAVisibleDepthBreaksFirst) {
  EXPECT_EQ(first_of({{"graze", {9, 9, 0.9, 0.9}}, {"general", {1, 0, 0.01, 0}}}), situation_named("everyday", true));
  // Roundings near touching in an everyday scene are no reason not to use it.
  EXPECT_EQ(first_of({{"line_sweep", {9, 0, 0.5, 0}}, {"general", {1, 0, 1e-7, 0}}}),
            situation_named("zero_area", true));
  // Missed contacts before phantoms, and visible ones before others.
  EXPECT_EQ(first_of({{"general", {0, 5, 0, 0.5}}, {"approach", {1, 0, 0.5, 0}}}), situation_named("far", true));
  EXPECT_EQ(first_of({{"point", {0, 5, 0, 0.5}}, {"graze", {1, 0, 1e-7, 0}}}), situation_named("point", false));
  EXPECT_EQ(first_of({{"graze", {1, 0, 2e-7, 0}}, {"general", {1, 0, 1e-7, 0}}}), situation_named("touching", true));
  EXPECT_EQ(first_of({{"graze", {0, 1, 0, 2e-7}}}), situation_named("touching", false));
  EXPECT_EQ(first_of({{"mesh-abc", {1, 0, 0.5, 0}}}), situation_named("own", true));
  EXPECT_EQ(first_of({{"graze", {0, 0, 0, 0}}}).first, "");
  EXPECT_EQ(first_of({{"graze", {1, 0, 0.5, 0}}, {"corpus", {1, 0, 0.9, 0}}}), situation_named("touching", true));
}

TEST(Situations, AreSaidWithTheirFamiliesTheDepthAndWhatToDo) {
  const Record record = record_of({{"lattice", {3, 0, 0.25, 0}}, {"general", {0, 2, 0, 1e-8}}});
  CertificatePredicate predicate;
  predicate.kernel.id = "k";
  predicate.kernel.question = "moving-sphere";
  predicate.breaks_first = what_breaks_first(record, "k");
  predicate.situations = where_it_is_wrong(record, "k");
  EXPECT_EQ(predicate.breaks_first->cause, "small_integers");
  const std::string note = breaks_note(predicate);
  EXPECT_THAT(note, HasSubstr("in binary32: motions in small integers"));
  EXPECT_THAT(note, HasSubstr("missed contacts in the family moving-sphere/lattice, up to 0.25 of the scene deep"));
  EXPECT_THAT(note, HasSubstr("See docs/moving.md#"));
  FindStatement& find = predicate.search.precisions.put("binary32").finds.put("missed_contact").emplace();
  find.depth = "0.2";
  EXPECT_EQ(breaks_note(predicate), note);
  find.depth = "0.5";
  EXPECT_THAT(breaks_note(predicate), HasSubstr("deep. A search found one of depth 0.5. "));
  const InstrumentTable table = situations_table(predicate);
  ASSERT_EQ(table.rows.size(), 2u);
  EXPECT_EQ(table.rows[1][2], "3");
  EXPECT_EQ(table.rows[1][3], "0.25");
  EXPECT_EQ(table.rows[1][6], "lattice");
}

TEST(Situations, AddUpTheirFamiliesTheDeepestFirst) {
  const auto found = wrong_situations(
      record_of({{"general", {1, 2, 0.1, 0.3}}, {"scene_fall", {4, 0, 0.5, 0}}, {"scene_walk", {8, 1, 0.2, 0.01}}}),
      "k");
  ASSERT_EQ(found.size(), 1u);
  EXPECT_THAT(found[0].families,
              testing::ElementsAre("moving-sphere/scene_fall", "moving-sphere/general", "moving-sphere/scene_walk"));
  EXPECT_EQ(found[0].missed, 13u);
  EXPECT_EQ(found[0].phantom, 3u);
  EXPECT_EQ(found[0].deepest_missed, 0.5);
  EXPECT_EQ(found[0].deepest_phantom, 0.3);
}

TEST(Peculiarities, AreThoseThatAUserHasToKnow) {
  const auto property = [](const char* name, const char* value) { return PropertyStatement{name, value, "s", 1}; };
  CertificatePredicate predicate;
  predicate.kernel.id = "peer/x";
  predicate.kernel.question = "moving-sphere";
  std::vector<PropertyStatement>& properties = predicate.diagnosis.precisions.emplace_back().properties;
  properties = {property("sides", "front_only"), property("repeated", "same"),
                property("absolute_threshold", "present")};
  // What matters most first: a number of its own before a convention. It limits the range too, and is said once.
  properties.push_back(property("range_window", "limited"));
  EXPECT_EQ(peculiarities_note(predicate),
            "What it is like: in binary32, compares with an absolute number, so it depends on the unit of length; "
            "one-sided: only from the front.");
  properties = {property("range_window", "limited"), property("absolute_threshold", "quaternions")};
  EXPECT_THAT(peculiarities_note(predicate),
              HasSubstr("compares the length of a quaternion with an absolute number; right only within a range"));
  properties = {property("nearest_form", "moving-sphere/physx5")};
  EXPECT_THAT(peculiarities_note(predicate), HasSubstr("answers as moving-sphere/physx5 does, see docs/moving.md#"));
  properties.insert(properties.begin(), property("degenerate_triangles", "skipped"));
  EXPECT_THAT(peculiarities_note(predicate),
              HasSubstr("are never hit; otherwise answers as moving-sphere/physx5 does"));
  properties.erase(properties.begin());
  predicate.kernel.id = "moving-sphere/physx5";
  EXPECT_EQ(peculiarities_note(predicate), "");
  properties = {property("repeated", "same"), property("sides", "not_known")};
  EXPECT_EQ(peculiarities_note(predicate), "");
}

}  // namespace

}  // namespace axiscert
