// Which files are read: a run's own, and no others.
#include <functional>

#include "fuzz/text/json_form.h"
#include "reports/run_folder/count_checks.h"
#include "reports/run_folder/run_folder.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

// Renders good reports, spoils record.json, renders again: the result is one clear line, with every report as it was.
std::string error_after(const std::string& spoiled) {
  const TestFolder folder(stored_record());
  render_reports(folder.path());
  for (const Format* format : formats()) folder.write(format->file, "before");
  folder.write("record.json", spoiled);
  const std::string error = folder.rendering_error();
  for (const Format* format : formats()) EXPECT_EQ(folder.read(format->file), "before") << format->file;
  EXPECT_THAT(error, HasSubstr((folder.path() / "record.json").string()));
  EXPECT_EQ(error.find('\n'), error.npos) << error;
  return error;
}

std::string error_after_edit(const std::function<void(Json&)>& edit) {
  Json record = stored_record();
  edit(record);
  return error_after(record.dump());
}

TEST(RunFolder, StoredRunIsAccepted) {
  const TestFolder folder(stored_record());
  folder.write("run.json", stored_run_info().dump());
  const axiscert::Run run = read_run(folder.path());
  const auto in_any_order = [](const Json& json) { return nlohmann::json::parse(json.dump()); };
  EXPECT_EQ(in_any_order(json_of(run.record)), in_any_order(stored_record()));
  EXPECT_EQ(in_any_order(json_of(run.info)), in_any_order(stored_run_info()));
}

TEST(RunFolder, RunInfoIsOptional) {
  const TestFolder folder(stored_record());
  EXPECT_FALSE(read_run(folder.path()).info.has_value());
}

TEST(RunFolder, MissingRecordNamesItAndSaysWhatToGive) {
  const TestFolder folder;
  EXPECT_THAT(folder.rendering_error(), HasSubstr((folder.path() / "record.json").string()));
  EXPECT_THAT(folder.rendering_error(), HasSubstr("run --out"));
}

TEST(RunFolder, RecordThatIsAFolderIsAnError) {
  const TestFolder folder;
  std::filesystem::create_directory(folder.path() / "record.json");
  EXPECT_THAT(folder.rendering_error(), HasSubstr("record.json"));
}

TEST(RunFolder, CutOffRecordIsRefusedWithItsLine) {
  const std::string text = stored_record().dump(1);
  EXPECT_THAT(error_after(text.substr(0, text.size() / 2)), HasSubstr("line "));
  EXPECT_THAT(error_after(""), HasSubstr("not JSON"));
  EXPECT_THAT(error_after(text + "}"), HasSubstr("line "));
}

// Every function on such a value would recurse once for each bracket.
TEST(RunFolder, RecordOfBracketsIsRefused) {
  constexpr std::size_t levels = 300000;
  const std::string brackets = std::string(levels, '[') + std::string(levels, ']');
  EXPECT_THAT(error_after(brackets), HasSubstr("deeper than 100 levels"));
  EXPECT_THAT(error_after("{\"schema\":" + brackets + "}"), HasSubstr("deeper than 100 levels"));
  EXPECT_THAT(error_after(std::string(90, '[') + std::string(90, ']')), HasSubstr("has no \"schema\""));
}

TEST(RunFolder, ErrorHasNoControlCharacters) {
  EXPECT_THAT(error_after("{\"a\": \x7f}"), HasSubstr("last read: '\"a\": \\u007f'"));
}

TEST(RunFolder, AnotherSchemaIsRefusedByName) {
  for (const char* other : {"axiscert-record/7", "axiscert-record/9"}) {
    const std::string error = error_after_edit([&](Json& record) { record["schema"] = other; });
    EXPECT_THAT(error, HasSubstr(fmt::format("record.json: its schema is \"{}\"", other)));
    EXPECT_THAT(error, HasSubstr("but this axiscert reads \"axiscert-record/8\"; make the folder again"));
  }
  EXPECT_THAT(error_after("[1]"), HasSubstr("has no \"schema\""));
}

TEST(RunFolder, EditedRecordIsRefusedWithThePlace) {
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r).erase("truth"); }),
              HasSubstr("/kernels/0/families/tangent: an object without \"truth\""));
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["trials"] = "many"; }),
              HasSubstr("/kernels/0/families/tangent/trials"));
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["trials"] = -1; }),
              HasSubstr("/kernels/0/families/tangent/trials"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["note"] = 1; }), HasSubstr("/note"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["witnesses"][0]["a"][1] = "0.1"; }), HasSubstr("/witnesses/0/a/1"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["kernels"][0]["precision"] = "binary16"; }),
              HasSubstr("/kernels/0/precision"));
}

// Calls visit(path, edited record) with a record spoiled at one place, for every place of the record.
using Visit = std::function<void(const std::string& path, const Json& spoiled)>;
void spoil_each(Json& whole, Json& value, const std::string& path, const Visit& visit) {
  const Json kept = value;
  if (!path.empty()) {
    value = kept.is_object() ? Json::array({Json::array()}) : Json::object({{"nonsense", 0}});
    visit(path, whole);
    value = kept;
  }
  if (kept.is_object()) {
    value["nonsense"] = Json::array({nullptr});
    visit(path + "/nonsense", whole);
    value = kept;
  }
  for (const auto& [member, inner] : kept.items()) {
    if (kept.is_object()) {
      value.erase(member);
      visit(path, whole);
      value = kept;
      spoil_each(whole, value[member], path + "/" + member, visit);
    } else if (kept.is_array()) {
      spoil_each(whole, value[std::stoul(member)], path + "/" + member, visit);
    }
  }
}

// Nothing is invented for what is not there, and nothing is passed over.
TEST(RunFolder, ARecordSpoiledAnywhereIsRefusedWithThePlaceOrReadAsItIs) {
  for (Json record : {stored_record(), motions(contacts(5, 0.25, 0))}) {
    std::size_t refused = 0, read = 0;
    spoil_each(record, record, "", [&](const std::string& path, const Json& spoiled) {
      try {
        const Json again = json_of(read_as<Record>(spoiled));
        ++read;
        EXPECT_EQ(nlohmann::json::parse(again.dump()), nlohmann::json::parse(spoiled.dump())) << path;
      } catch (const JsonFault& fault) {
        ++refused;
        EXPECT_THAT(fault.what(), testing::StartsWith(path.empty() ? "/" : path));
      }
    });
    EXPECT_GT(refused, 500u);
    EXPECT_GT(refused, 10 * read);
  }
}

TEST(RunFolder, CountsThatContradictEachOtherAreRefused) {
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["trials"] = 1001; }), HasSubstr("do not add up"));
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["verdict"]["false_separation"] = 596; }),
              HasSubstr("false_separation"));
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["verdict"]["touching_flips"] = 61; }),
              HasSubstr("touching_flips"));
  EXPECT_THAT(error_after_edit([](Json& r) { tangent_counts(r)["comparisons"]["plane.radius"]["masked"] = 6; }),
              HasSubstr("plane.radius"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["kernels"].push_back(r["kernels"][0]); }), HasSubstr("twice"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["witnesses"][1]["id"] = "w1"; }), HasSubstr("twice"));
}

// 75 valid queries within the limits, of which six touch.
FamilyCounts counts_of(TouchingPolicy policy) {
  FamilyCounts counts;
  counts.trials = 100;
  counts.truth = {50, 45, 10, 5};
  VerdictTally& verdict = counts.verdict;
  verdict.outside_limits->trials = 20;
  verdict.outside_limits->contact = 10;
  verdict.outside_limits->touching = 4;
  verdict.outside_limits->decided_contacts = 6;
  verdict.decided_contacts = policy == TouchingPolicy::contact ? 30 : 26;
  verdict.decided_separations = policy == TouchingPolicy::separated ? 41 : 37;
  verdict.decided_touching = policy == TouchingPolicy::either ? 0 : 4;
  verdict.undecided = 6;
  verdict.undecided_contact = 4;
  verdict.undecided_touching = 2;
  verdict.invalid = verdict.unanswered = 1;
  verdict.false_separation = verdict.false_contact = 3;
  verdict.touching_flips = policy == TouchingPolicy::either ? 0 : 1;
  ClearTally& clear = *verdict.clear;
  clear.queries = 20;
  clear.decided_contacts = clear.decided_separations = 8;
  clear.undecided = 3;
  clear.false_separation = 1;
  return counts;
}

TEST(RunFolder, VerdictsFitTheTruthAndThePromiseOfTouch) {
  for (const TouchingPolicy policy : {TouchingPolicy::contact, TouchingPolicy::separated, TouchingPolicy::either}) {
    EXPECT_EQ(fault_of_verdicts(policy, counts_of(policy)).value_or(""), "");
    const auto expect_fault = [&](const char* says, const std::function<void(FamilyCounts&)>& edit) {
      FamilyCounts counts = counts_of(policy);
      edit(counts);
      EXPECT_THAT(fault_of_verdicts(policy, counts).value_or("none"), HasSubstr(says));
    };
    constexpr std::uint64_t half = std::uint64_t{1} << 63;  // two of them are 0
    expect_fault("truths", [](FamilyCounts& c) { c.truth.separated += half, c.truth.contact += half; });
    expect_fault("outside the limits", [](FamilyCounts& c) {
      c.verdict.outside_limits->decided_contacts = c.verdict.outside_limits->decided_separations = half;
    });
    expect_fault("outside the limits", [](FamilyCounts& c) { c.verdict.outside_limits->touching = 11; });
    expect_fault("than contacts", [](FamilyCounts& c) { c.verdict.decided_contacts += 2; });
    expect_fault("than decided queries", [](FamilyCounts& c) { c.verdict.false_contact = 43; });
    expect_fault("undecided_touching", [](FamilyCounts& c) { c.verdict.undecided_touching = 5; });
    expect_fault("fewer", [](FamilyCounts& c) { --c.verdict.unanswered; });
    expect_fault("decided_touching", [](FamilyCounts& c) { c.verdict.decided_touching = 5; });
    if (policy != TouchingPolicy::either)  // two others may have no verdict
      expect_fault("decided_touching", [](FamilyCounts& c) { c.verdict.decided_touching = 1; });
    expect_fault("touching_flips", [](FamilyCounts& c) { c.verdict.touching_flips = 4; });
    expect_fault("clear", [](FamilyCounts& c) { c.verdict.clear->false_separation = 9; });
    expect_fault("clear", [](FamilyCounts& c) { c.verdict.clear->decided_contacts = half; });
    expect_fault("to all",
                 [](FamilyCounts& c) { c.verdict.clear->queries += 23, c.verdict.clear->decided_contacts += 23; });
    expect_fault("to all", [](FamilyCounts& c) { c.verdict.clear->queries += 4, c.verdict.clear->undecided += 4; });
    expect_fault("to all", [](FamilyCounts& c) { c.verdict.clear->false_contact = 4; });
  }
}

TEST(RunFolder, WhatAPlanOrKernelListsTwiceIsRefused) {
  EXPECT_THAT(error_after_edit([](Json& r) { r["plan"]["families"].push_back("tangent"); }),
              HasSubstr("/plan/families/3: \"tangent\" appears twice"));
  EXPECT_THAT(error_after_edit([](Json& r) { r["plan"]["kernels"] = Json::array(); }), HasSubstr("/plan/kernels"));
  EXPECT_THAT(error_after_edit([](Json& r) {
                r["kernels"][0]["exposes"] = {"verdict", "verdict"};
              }),
              HasSubstr("appears twice"));
}

// 70 answers of a kernel with every number: 40 contacts, three of them phantom, with a flip; a feature that is wrong.
FamilyCounts counts_with_contacts() {
  FamilyCounts counts;
  counts.trials = 100;
  counts.truth = {60, 40, 5, 0};
  counts.verdict.decided_contacts = 38;
  counts.verdict.decided_separations = 57;
  counts.verdict.false_separation = 1;
  counts.verdict.false_contact = 3;
  ContactTally& all = counts.contacts.emplace();
  all.decided.reset();
  all.missed.reset();
  all.time.reset();
  all.answers = 70;
  all.separations = 30;
  for_each_number(all, [](MeasureKind, auto& part) {
    if (!part) return;
    part->given.contacts = 39;
    part->given.separations = 29;
    part->given.which_contacts.mark = part->given.which_separations.mark = 7;
    if constexpr (requires { part->judged = 1; }) part->judged = 68;
    part->none = 1;
  });
  ConsistencyTally& consistency = *all.consistency;
  consistency.judged = 69;
  consistency.contacts = 39;
  consistency.separations = 29;
  consistency.positive = consistency.negative = consistency.missing = 1;
  all.separation->by_decade[3] = 68;
  all.separation->largest_error.offer({5e-19, 1});
  all.separation->largest_ulps.offer({round_up(1), 1});
  all.feature->wrong = 2;
  all.feature->unnamed = 1;
  all.feature->largest_error.offer({0.5, 1});
  all.normal->lengths = 68;
  all.pushed->judged = 35;
  all.pushed->nowhere = all.pushed->flips = 1;
  all.pushed->largest_left.offer({round_up(2), 1});
  all.points->judged = 68;
  return counts;
}

TEST(RunFolder, NumbersBesideVerdictsFitTheAnswersAndEachOther) {
  const auto fault_after = [](const std::function<void(FamilyCounts&, ContactTally&)>& edit) {
    FamilyCounts counts = counts_with_contacts();
    edit(counts, *counts.contacts);
    return fault_of_contacts(TouchingPolicy::contact, counts).value_or(fault_of_sizes(*counts.contacts).value_or(""));
  };
  EXPECT_EQ(fault_after([](FamilyCounts&, ContactTally&) {}), "");
  struct Edit {
    const char* path;
    void (*edit)(ContactTally&);
  };
  const Edit edits[] = {
      {"contacts: ", [](ContactTally& c) { c.separations = 71; }},
      {"contacts: ", [](ContactTally& c) { c.answers = 1000000; }},
      {"contacts: ", [](ContactTally& c) { c.separations = 56; }},
      {"contacts: ", [](ContactTally& c) { c.decided = 70; }},
      {"contacts/separation/given: ", [](ContactTally& c) { c.separation->given.contacts = 41; }},
      {"contacts/normal/given: ", [](ContactTally& c) { c.normal->given.separations = 31; }},
      {"contacts/point/given: ", [](ContactTally& c) { c.point->given.which_contacts = {}; }},
      {"contacts/separation: ", [](ContactTally& c) { c.separation->judged = 69; }},
      {"contacts/feature: ", [](ContactTally& c) { c.feature->none = 3; }},
      {"contacts/normal: ", [](ContactTally& c) { c.normal->lengths = 69; }},
      {"contacts/normal: ", [](ContactTally& c) { c.normal->lengths = 67; }},
      {"contacts/normal: ",
       [](ContactTally& c) {
         c.normal->largest_angle.offer({3.2, 1});
       }},
      {"contacts/consistency: ", [](ContactTally& c) { c.consistency->contacts = 38; }},
      {"contacts/consistency: ", [](ContactTally& c) { c.consistency->judged = 67; }},
      {"contacts/consistency: ", [](ContactTally& c) { c.consistency->positive = 40; }},
      {"contacts/consistency: ", [](ContactTally& c) { c.consistency->missing = 68; }},
      {"contacts/feature: ", [](ContactTally& c) { c.feature->wrong = 69; }},
      {"contacts/feature: ", [](ContactTally& c) { c.feature->unnamed = 3; }},
      {"contacts/feature: ", [](ContactTally& c) { c.feature->unnamed = 2; }},
      {"contacts/pushed: ", [](ContactTally& c) { c.pushed->judged = 69; }},
      {"contacts/pushed: ", [](ContactTally& c) { c.pushed->none = 2; }},
      {"contacts/pushed: ", [](ContactTally& c) { c.pushed->nowhere = 36; }},
      {"contacts/pushed: ", [](ContactTally& c) { c.pushed->flips = 1000000; }},
      {"contacts/pushed/largest_left: ", [](ContactTally& c) { c.pushed->largest_left = Leaders<Decimal6>(); }},
      {"contacts/pushed/largest_left: ",
       [](ContactTally& c) {
         c.pushed->largest_left.offer({round_up(3), 1});
       }},
      {"contacts/points: ", [](ContactTally& c) { c.points->judged = 69; }},
      {"contacts/points: ", [](ContactTally& c) { c.point_b->judged = 67; }},
      {"contacts/separation: ", [](ContactTally& c) { c.separation->by_decade[3] = 67; }},
      {"contacts/separation: ",
       [](ContactTally& c) {
         c.separation->largest_error.offer({1, 1});
       }},
  };
  for (const Edit& one : edits) {
    const std::string fault = fault_after([&](FamilyCounts&, ContactTally& contacts) { one.edit(contacts); });
    EXPECT_THAT(fault, testing::StartsWith(one.path)) << &one - edits;
  }
  EXPECT_THAT(fault_after([](FamilyCounts& c, ContactTally&) { c.verdict.false_contact = 0; }),
              HasSubstr("contacts: "));
}

TEST(RunFolder, TimesFitTheContactsThatAreFound) {
  const auto error_after = [](const std::function<void(Json&)>& edit) {
    Json record = grown(motions(contacts(5, 0.25, 0)));
    edit(record["kernels"][0]["families"]["tangent"]["contacts"]);
    return TestFolder(record).rendering_error();
  };
  EXPECT_EQ(error_after([](Json&) {}), "");
  EXPECT_THAT(error_after([](Json& c) { c["answers"] = 901; }), HasSubstr("tangent\": contacts: answers"));
  EXPECT_THAT(error_after([](Json& c) { c["decided"] = 908; }), HasSubstr("contacts: answers and decided"));
  EXPECT_THAT(error_after([](Json& c) { c["missed"]["through"] = 1; }), HasSubstr("contacts/missed: "));
  EXPECT_THAT(error_after([](Json& c) { c["time"]["given"]["contacts"] = 899; }),
              HasSubstr("contacts/time: more judged"));
  EXPECT_THAT(error_after([](Json& c) { c["time"]["early"] = 99, c["time"]["judged"] = 899; }),
              HasSubstr("contacts/time: none"));
  EXPECT_THAT(error_after([](Json& c) { c["time"]["late_tunnels"]["through"] = 6; }),
              HasSubstr("contacts/time: more through"));
  EXPECT_THAT(error_after([](Json& c) { c["time"]["late_errors"]["by_power"]["2"] = 4; }),
              HasSubstr("contacts/time/late_errors: "));
  EXPECT_THAT(error_after([](Json& c) { c["time"]["late_errors"]["largest_ulps"] = 250; }),
              HasSubstr("contacts/time/late_errors: "));
  EXPECT_THAT(error_after([](Json& c) { c["missed"] = nullptr, c["decided"] = nullptr; }),
              HasSubstr("contacts/decided: is null"));
}

TEST(RunFolder, AnswersToImagesFitTheirNumber) {
  const AddressPair pair{Name("a"), Name("b")};
  AsymmetryRecord whole;
  whole.images = 50;
  whole.verdicts = whole.images_with_comparisons = whole.comparisons.emplace() = 1;
  whole.first_verdict = whole.first_comparison = pair;
  whole.numbers = {.images = 49,
                   .compared = 48,
                   .separations = 48,
                   .angles = 40,
                   .points = 0,
                   .compared_features = 48,
                   .lost = 1,
                   .features = 1,
                   .largest_separation = 0.5,
                   .largest_angle = 0,
                   .largest_point = {},
                   .worst_separation = pair,
                   .worst_angle = {},
                   .worst_point = {},
                   .first_feature = pair,
                   .first_lost = pair};
  EXPECT_EQ(fault_of_asymmetry(whole).value_or(""), "");
  void (*const edits[])(AsymmetryRecord&) = {[](AsymmetryRecord& a) { a.verdicts = 51; },
                                             [](AsymmetryRecord& a) { a.verdicts = 0; },
                                             [](AsymmetryRecord& a) { a.comparisons = 2; },
                                             [](AsymmetryRecord& a) { a.images_with_comparisons = 51; },
                                             [](AsymmetryRecord& a) { a.first_comparison.reset(); },
                                             [](AsymmetryRecord& a) { a.numbers->images = 50; },
                                             [](AsymmetryRecord& a) { a.numbers->compared = 50; },
                                             [](AsymmetryRecord& a) { a.numbers->separations = 49; },
                                             [](AsymmetryRecord& a) { a.numbers->lost = 49; },
                                             [](AsymmetryRecord& a) { a.numbers->features = 49; },
                                             [](AsymmetryRecord& a) { a.numbers->largest_angle = 4; },
                                             [](AsymmetryRecord& a) { a.numbers->largest_angle.reset(); },
                                             [](AsymmetryRecord& a) { a.numbers->largest_point = 0.5; },
                                             [](AsymmetryRecord& a) { a.numbers->worst_separation.reset(); },
                                             [](AsymmetryRecord& a) { a.numbers->worst_point = a.first_verdict; },
                                             [](AsymmetryRecord& a) { a.numbers->first_feature.reset(); },
                                             [](AsymmetryRecord& a) { a.numbers->lost = 0; }};
  for (const auto& edit : edits) {
    AsymmetryRecord spoiled = whole;
    edit(spoiled);
    EXPECT_THAT(fault_of_asymmetry(spoiled).value_or("none"), testing::StartsWith("asymmetry")) << &edit - edits;
  }
}

TEST(RunFolder, WitnessBeyondItsPrecisionIsRefused) {
  EXPECT_THAT(error_after_edit([](Json& r) { r["witnesses"][0]["r"] = "0x1.000000001p+0"; }), HasSubstr("\"w1\", r"));
}

TEST(RunFolder, BadRunInfoIsRefusedByName) {
  const TestFolder folder(stored_record());
  folder.write("run.json", "{");
  EXPECT_THAT(folder.rendering_error(), HasSubstr("run.json"));
  folder.write("run.json", R"({"schema": "axiscert-run/1"})");
  EXPECT_THAT(folder.rendering_error(), HasSubstr("run.json: its schema is \"axiscert-run/1\""));
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html"));
}

TEST(RunFolder, UnwritableReportIsAnErrorThatNamesIt) {
  const TestFolder folder(stored_record());
  std::filesystem::create_directory(folder.path() / "witnesses.jsonl");
  folder.write("witnesses.jsonl/x", "");
  EXPECT_THAT(folder.rendering_error(), HasSubstr("witnesses.jsonl"));
  for (const auto& entry : std::filesystem::directory_iterator(folder.path())) {
    EXPECT_NE(entry.path().extension(), ".part") << entry.path();
  }
}

}  // namespace
}  // namespace axiscert
