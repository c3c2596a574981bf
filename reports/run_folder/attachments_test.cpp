// Files next to a record: shown where they have the form that is read, one clear error where they do not.
#include "fuzz/text/json.h"
#include "reports/run_folder/attachments.h"

#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Attachments, AreNullWhereTheFolderHasNone) {
  const TestFolder folder(stored_record());
  for (const Json& kind : attachments(folder.path(), 0)) EXPECT_TRUE(kind.is_null());
  render_reports(folder.path());
  std::vector<std::string> expected = {"record.json"}, shown;
  for (const Format* format : formats()) {
    if (std::string_view(format->file) != "report.html") expected.emplace_back(format->file);
  }
  const Json page = page_data(folder.read("report.html"));
  for (const Json& file : page["files"]) {
    shown.push_back(file["name"]);
    EXPECT_FALSE(file["meaning"].get<std::string>().empty()) << shown.back();
  }
  EXPECT_EQ(shown, expected) << "a format that the page is to list has a meaning: reports/formats/format.h";
}

TEST(Attachments, ProofsAreReadByTheNamesOfTheirMembers) {
  const TestFolder folder(stored_record());
  folder.write("proofs.json", R"({"checkers": {"gappa": "1.4"}, "bounds":
    [{"comparison": "plane.radius", "kernel": "published", "bound_u": 640, "status": "proved", "more": 1}]})");
  const Json proofs = attachments(folder.path(), 0)["proofs"];
  EXPECT_EQ(proofs["comparisons"][0]["name"], "plane.radius");
  EXPECT_EQ(proofs["comparisons"][0]["formulae"], "published");
  EXPECT_EQ(proofs["comparisons"][0]["proved_u"], 640);
  EXPECT_TRUE(proofs["comparisons"][0]["attained_u"].is_null());
}

// An index of one map with these pictures, and no legend.
Json map_index(const std::vector<std::pair<std::string, std::string>>& pictures) {
  Json map = {{"name", "m"}, {"pictures", Json::array()}};
  for (const auto& [level, file] : pictures)
    map["pictures"].push_back({{"level", level}, {"name", level}, {"file", file}});
  return {{"legend", Json::array()}, {"maps", {map}}};
}

TEST(Attachments, PicturesGoInWhileThereIsRoomVerdictsBeforeComparisons) {
  const TestFolder folder(stored_record());
  std::filesystem::create_directory(folder.path() / "maps");
  folder.write("maps/index.json", map_index({{"comparison", "one.png"}, {"verdict", "two.png"}}).dump());
  folder.write("maps/one.png", "12345");
  folder.write("maps/two.png", "12345");
  const Json pictures = attachments(folder.path(), 9)["maps"]["maps"][0]["pictures"];
  EXPECT_TRUE(pictures[0]["image"].is_null());
  EXPECT_EQ(pictures[0]["file"], "maps/one.png");
  EXPECT_EQ(pictures[1]["image"], "data:image/png;base64,MTIzNDU=");
}

TEST(Attachments, APictureOutsideItsFolderIsRefused) {
  const TestFolder folder(stored_record());
  std::filesystem::create_directory(folder.path() / "maps");
  for (const char* file : {"../record.json", "/etc/hostname", "a\\b", ".hidden", ""}) {
    folder.write("maps/index.json", map_index({{"verdict", file}}).dump());
    EXPECT_THAT(folder.rendering_error(), AllOf(HasSubstr("index.json"), HasSubstr("not the name of a file in maps/")))
        << file;
  }
  folder.write("maps/index.json", map_index({{"verdict", "missing.png"}}).dump());
  EXPECT_THAT(folder.rendering_error(), HasSubstr("missing.png: cannot be read"));
}

TEST(Attachments, AMutantWithoutAValidQueryWasNotJudged) {
  const TestFolder folder(stored_record());
  folder.write("mutation.json", R"({"complete": true,
    "score": {"binary32": {"not_judged": 0}, "binary64": {"not_judged": 1}}, "mutants": [
    {"id": "m", "precision": "binary32", "caught": null}, {"id": "m", "precision": "binary64", "caught": null},
    {"id": "n", "precision": "binary64", "caught": {"family": "lattice", "queries": 7}}, {"id": "o", "caught": null}]})");
  const Json mutants = attachments(folder.path(), 0)["mutation"]["mutants"];
  EXPECT_EQ(mutants[0]["caught"], false);
  EXPECT_TRUE(mutants[1]["caught"].is_null());
  EXPECT_EQ(mutants[2]["caught"], true);
  EXPECT_EQ(mutants[3]["caught"], false);
}

TEST(Attachments, AKindOfVerdictThatNoFamilyDecidedIsNullInALeague) {
  const TestFolder folder(stored_record());
  Json family = {{"caught_after", nullptr}};
  for (const char* count : {"trials", "decided", "undecided", "invalid", "unanswered", "outside_limits"})
    family[count] = 10;
  Json other = family;
  family.update({{"false_separation", nullptr},
                 {"false_contact", 2},
                 {"deepest_false_separation", nullptr},
                 {"deepest_false_contact", 0.5}});
  other.update({{"false_separation", nullptr},
                {"false_contact", nullptr},
                {"deepest_false_separation", nullptr},
                {"deepest_false_contact", nullptr}});
  Json league, one = {{"id", "k"}};
  one["families"]["one"] = family;
  one["families"]["two"] = other;
  league["kernels"] = Json::array({one});
  folder.write("league.json", league.dump());
  const Json kernel = attachments(folder.path(), 0)["league"]["kernels"][0];
  EXPECT_TRUE(kernel["false_separation"].is_null() && kernel["deepest_false_separation"].is_null());
  EXPECT_EQ(kernel["false_contact"], 2);
  EXPECT_EQ(kernel["deepest_false_contact"], 0.5);
}

TEST(Attachments, AFileOfAnotherFormIsOneErrorAndNothingIsWritten) {
  for (const char* file :
       {"proofs.json", "search.json", "mutation.json", "ladder.json", "precision.json", "league.json"}) {
    for (
        const char* text :
        {"{", "7", "{}", R"({"comparisons": 1, "mutants": {}, "kernels": "x", "all": []})",
         R"({"comparisons": [1], "mutants": [2], "kernels": [{}, 3], "all": {"kernels": {"x": {"precisions": [{}]}}}})"}) {
      const TestFolder folder(stored_record());
      folder.write(file, text);
      EXPECT_THAT(folder.rendering_error(), HasSubstr(file)) << text;
      EXPECT_FALSE(std::filesystem::exists(folder.path() / "report.html")) << file << " " << text;
    }
  }
}

}  // namespace
}  // namespace axiscert
