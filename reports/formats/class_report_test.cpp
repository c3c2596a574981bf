// Why a kernel is wrong whose links do not say it, from the campaign to the reports: classes, witnesses, the nearest
// kernel.
#include "fuzz/campaign/supervised_testing.h"
#include "fuzz/confirm/nearest_kernel.h"
#include "fuzz/confirm/record.h"
#include "fuzz/text/json_form.h"
#include "reports/run_folder/run_folder.h"
#include "reports/testing/test_run.h"
#include "reports/wording/causes.h"

namespace axiscert {
namespace {

using testing::HasSubstr;
using testing::Not;

void as_it_is(const Query<double>&, std::size_t, Verdict&, std::vector<Finding>&) {}

Record class_record(const Kernel& kernel, const std::vector<std::string>& families, std::uint64_t trials) {
  Plan plan;
  plan.answerers.kernels = {&kernel};
  for (const std::string& name : families) plan.questions.sources.push_back(family_source(find_family(name)));
  plan.questions.precisions = {Precision::binary32};
  plan.questions.trials = [trials](const Source&, Precision) { return trials; };
  plan.running.target = std::string(scalar_target);
  const std::atomic<bool> never = false;
  return read_record(json_of(record_of(plan, run_campaign(plan, never, [](const Progress&) {}), RunRequirements())),
                     "record.json");
}

// `published` as a black box: the nearest kernel has to be found to be itself.
const Record& published_record() {
  static const Record record =
      class_record(black_box("plugin:mine.so", as_it_is, "published"), {"repeated", "sliver", "tie", "scale"}, 1500);
  return record;
}

const FamilyRecord& published_on(const char* family) { return published_record().kernels[0].families.at(family); }

TEST(ClassRecord, HasTheWrongVerdictsOfEachClassAndItsDeepestWitness) {
  const auto& repeated = published_on("repeated").classes.value();
  EXPECT_GT(repeated.at(InputClass::repeated).false_contact, 100u);
  EXPECT_FALSE(repeated.contains(InputClass::ordinary));
  EXPECT_GT(published_on("tie").classes->at(InputClass::tie).false_separation, 100u);
  EXPECT_GT(published_on("scale").classes->at(InputClass::scale).false_contact, 100u);
  std::map<std::string, InputClass> class_of_address;
  for (const WitnessRecord& witness : published_record().witnesses) {
    EXPECT_EQ(witness.input_class.has_value(), !witness.flips.empty());
    if (witness.input_class) class_of_address[witness.address] = *witness.input_class;
  }
  for (const auto& [family, result] : published_record().kernels[0].families) {
    for (const auto& [which, of] : *result.classes) EXPECT_EQ(class_of_address.at(of.witness), which);
  }
}

TEST(ClassRecord, TheNearestKernelIsTheOneThatItIs) {
  const NearestRecord& nearest = published_record().kernels[0].nearest.value().value();
  EXPECT_EQ(nearest.both, nearest.either);
  EXPECT_EQ(nearest.both, nearest.wrong);
  EXPECT_GT(nearest.wrong, 1000u);
  EXPECT_EQ(find_kernel(nearest.kernel).formulae, "published");
  EXPECT_THAT(nearest_sentence(published_record().kernels[0]),
              AllOf(HasSubstr("Nearest of the built-in kernels: published, wrong on 100 % of"),
                    HasSubstr("the first 1,024 of each family and the deepest)")));
}

TEST(ClassRecord, AKernelLikeNoOtherIsSaidToBe) {
  const auto epsilon = [](const Query<double>& q, std::size_t, Verdict& verdict, std::vector<Finding>&) {
    if (q.r < 0.25) verdict = Verdict::contact;
  };
  const Record record =
      class_record(black_box("plugin:epsilon.so", epsilon, "certified"), {"general", "repeated"}, 1500);
  const KernelRecord& kernel = record.kernels[0];
  EXPECT_GT(kernel.families.at("general").classes->at(InputClass::ordinary).false_contact, 100u);
  EXPECT_THAT(nearest_sentence(kernel), testing::StartsWith("No built-in kernel fails alike; the nearest is "));
}

TEST(ClassRecord, AKernelThatIsNeverWrongHasNoNearest) {
  const Record record = class_record(black_box("plugin:right.so", as_it_is, "certified"), {"repeated"}, 1500);
  const KernelRecord& kernel = record.kernels[0];
  EXPECT_TRUE(kernel.nearest && !*kernel.nearest);
  EXPECT_TRUE(kernel.families.at("repeated").classes.value().empty());
  EXPECT_EQ(nearest_sentence(kernel), "");
}

TEST(ClassRecord, AKernelWithAReferenceHasNeither) {
  const Record record = class_record(find_kernel("published"), {"repeated"}, 300);
  EXPECT_FALSE(record.kernels[0].nearest);
  EXPECT_FALSE(record.kernels[0].families.at("repeated").classes);
  for (const WitnessRecord& witness : record.witnesses) EXPECT_FALSE(witness.input_class);
}

TEST(ClassReports, TheShortReportAndThePageHaveThem) {
  const TestFolder folder(json_of(published_record()));
  render_reports(folder.path());
  const std::string markdown = folder.read("report.md");
  EXPECT_THAT(markdown, HasSubstr("## Why, by the class of the input"));
  EXPECT_THAT(markdown, HasSubstr("| plugin:mine.so | binary32 | repeated | two vertices of the triangle are equal |"));
  EXPECT_THAT(markdown, HasSubstr("plugin:mine.so binary32: Nearest of the built-in kernels: published"));
  const Json data = page_data(folder.read("report.html"));
  const Json& classes = data["kernels"][0]["classes"];
  EXPECT_EQ(classes["rows"].size(), class_rows(published_record().kernels[0]).size());
  EXPECT_THAT(classes["nearest"].get<std::string>(), HasSubstr("published"));
  EXPECT_FALSE(data["kernels"][0]["all"].contains("classes"));
}

TEST(ClassReports, RowsAddUpTheFamilies) {
  const Record stored = read_as<Record>(stored_record());
  EXPECT_FALSE(has_classes(stored.kernels[0]));
  EXPECT_TRUE(classes_data(stored.kernels[0]).is_null());
  const std::vector<ClassRow> rows = class_rows(stored.kernels[1]);
  ASSERT_EQ(rows.size(), 4u);
  EXPECT_EQ(rows[0].which, InputClass::tie);
  EXPECT_EQ(rows[3].which, InputClass::ordinary);
  EXPECT_EQ(rows[3].deepest, 0.0625);
  EXPECT_EQ(rows[3].family, "lattice");
}

TEST(ClassFolder, ClassesThatContradictTheRecordAreRefused) {
  const auto error_after = [&](const std::function<void(Json&)>& edit) {
    Json edited = json_of(published_record());
    edit(edited);
    const TestFolder folder(edited);
    return folder.rendering_error();
  };
  const auto classes = [](Json& r) -> Json& { return r["kernels"][0]["families"]["repeated"]["classes"]; };
  const auto more = [](Json& count) { count = count.get<std::uint64_t>() + 1; };
  EXPECT_EQ(error_after([](Json&) {}), "");
  EXPECT_THAT(error_after([&](Json& r) { more(classes(r)["repeated"]["false_contact"]); }), HasSubstr("false_contact"));
  EXPECT_THAT(error_after([&](Json& r) { classes(r)["repeated"]["deepest"] = 7; }), HasSubstr("deeper"));
  EXPECT_THAT(error_after([&](Json& r) { classes(r)["odd"] = classes(r)["repeated"]; }), HasSubstr("odd"));
  EXPECT_THAT(error_after([&](Json& r) { r["kernels"][0]["reference"] = true; }), Not(testing::IsEmpty()));
  EXPECT_THAT(error_after([&](Json& r) {
                Json& of = r["kernels"][0]["families"]["tie"]["classes"];
                of["ordinary"] = of["tie"];
                of.erase("tie");
              }),
              HasSubstr("touching_flips"));
  EXPECT_THAT(error_after([](Json& r) { r["witnesses"][0]["class"] = "odd"; }), HasSubstr("/witnesses/0/class"));
}

}  // namespace
}  // namespace axiscert
