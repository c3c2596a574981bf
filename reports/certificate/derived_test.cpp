// The counts of a certificate lead to the same as the run's record, and every contradiction is named.
#include "fuzz/text/json_form.h"
#include "reports/certificate/derived.h"

#include "fuzz/campaign/gathered.h"
#include "fuzz/confirm/record.h"
#include "kernel/base/version.h"
#include "reports/certificate/materials.h"
#include "reports/certificate/margin.h"
#include "reports/certificate/breaks.h"
#include "reports/certificate/levels.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/statement.h"
#include "reports/testing/test_run.h"
#include "reports/wording/summary.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t trials = 256;  // as effort smoke asks

// A run of one kernel and its yardsticks, and the predicate that is made of it.
struct CertifiedRecord {
  Record record;
  CertificatePredicate predicate;
};

CertifiedRecord certified(const std::vector<std::string>& ids, const std::vector<std::string>& families) {
  Plan plan;
  for (const std::string& id : ids) plan.answerers.kernels.push_back(&find_kernel(id));
  for (const std::string& family : families) plan.questions.sources.push_back(family_source(find_family(family)));
  plan.questions.precisions = {Precision::binary32, Precision::binary64};
  plan.questions.trials = [&](const Source&, Precision) {
    return &plan.questions.predicate() == &sphere_triangle_predicate() ? trials : 64;
  };
  plan.running.target = resolve_target("auto");
  const Stretches stretches(plan.questions, Stretches::default_units_each(plan.questions));
  GatheredStretches gathered(plan.questions, ids.size(), stretches);
  CertifiedRecord made;
  CertificatePredicate& p = made.predicate;
  for (std::uint64_t i = 0; i < stretches.count(); ++i) {
    const Entry entry = run_stretch(plan, stretches, i);
    p.materials.tallies.push_back(tally_of_stretch(plan.answerers.kernels, stretches, entry));
    gathered.add(entry);
  }
  made.record = record_of(plan, std::move(gathered).take(), {});
  p.digest = std::string(64, '0');
  p.kernel.id = ids.front();
  p.kernel.question = plan.questions.predicate().id;
  p.kernel.entry = plan.questions.predicate().entries[0].name;
  p.asked.effort = "smoke";
  p.materials.axiscert = {axiscert_version, source_digests().sources};
  p.materials.proofs = source_digests().proofs;
  const Json portable = portable_plan(json_of(plan_record(plan)));
  p.materials.plan = {digest_of_json(portable), {stretches.units_each()}, {portable}};
  p.materials.kernels = kernels_of_record(made.record);
  p.materials.findings = findings_of_record(made.record);
  p.search.reason = "a search is not what is tested";
  p.safe_margin.reason = std::string(margin_answered_otherwise) + "a margin is not what is tested";
  p.harness.reason = "planted faults are not what is tested";
  const Record reduced = reduced_record(p, "it");
  p = derived_predicate(std::move(p), reduced);
  p.breaks_first = what_breaks_first(made.record, ids.front());
  return made;
}

const CertifiedRecord& of_published() {
  static const CertifiedRecord made = certified({"published", "certified"}, {"tangent", "lattice", "units", "orders"});
  return made;
}

std::string refusal_of(const Json& predicate) {
  try {
    require_derived(read_as<CertificatePredicate>(Json::parse(canonical_json(predicate))), "it");
    return "holds";
  } catch (const NotValid& wrong) {
    return wrong.what();
  }
}

// Members in any order.
std::string text_of_json(const Json& json) { return canonical_json(without_fractions(json)); }

TEST(ReducedRecord, HasTheCountsOfTheRecordThatLevelsRead) {
  const Json reduced = json_of(reduced_record(of_published().predicate, "it"));
  const Json record = json_of(of_published().record);
  ASSERT_EQ(reduced["kernels"].size(), record["kernels"].size());
  for (std::size_t i = 0; i < reduced["kernels"].size(); ++i) {
    const Json &entry = reduced["kernels"][i], &whole = record["kernels"][i];
    for (const char* member : {"id", "precision", "limits", "touching", "may_decline", "critical_radius", "reference"})
      EXPECT_EQ(text_of_json({entry[member]}), text_of_json({whole[member]})) << member;
    ASSERT_EQ(entry["families"].size(), whole["families"].size());
    for (const auto& [family, result] : whole["families"].items()) {
      for (const char* member : {"trials", "truth", "base_triangles", "exact_arithmetic"})
        EXPECT_EQ(text_of_json({entry["families"][family][member]}), text_of_json({result[member]}))
            << family << member;
      for (const auto& [member, value] : entry["families"][family]["verdict"].items()) {
        // Which are in no certificate.
        if (member == "masked_links" || member == "first_by_link" || member == "depths" || member == "engine_like")
          continue;
        EXPECT_EQ(text_of_json({value}), text_of_json({result["verdict"][member]})) << family << " " << member;
      }
      EXPECT_EQ(result.contains("invariance"), entry["families"][family].contains("invariance"));
      if (result.contains("invariance")) {
        EXPECT_EQ(text_of_json(result["invariance"]), text_of_json(entry["families"][family]["invariance"]));
      }
    }
  }
}

TEST(ReducedRecord, LeadsToTheSameLevelsAsTheRecord) {
  for (const auto& [ids, families] : {std::pair<std::vector<std::string>, std::vector<std::string>>{
                                          {"published", "certified"}, {"tangent", "lattice", "units", "orders"}},
                                      {{"certified", "published"}, {"general", "nonfinite"}},
                                      {{"box-box/projected"}, {"box-box/general", "box-box/tangent"}},
                                      {{"moving-sphere/advance"}, {"moving-sphere/general"}}}) {
    const CertifiedRecord made = certified(ids, families);
    EXPECT_EQ(text_of_json(json_of(levels_of(made.record, ids.front(), {}))),
              text_of_json(json_of(made.predicate.levels)))
        << ids.front();
    EXPECT_EQ(refusal_of(json_of(made.predicate)), "holds") << ids.front();
  }
}

TEST(Derived, OfContactsThatWereDeclinedNoneIsSaidToBeMissed) {
  CertifiedRecord made = of_published();
  for (KernelRecord& kernel : made.record.kernels) {
    for (auto& [family, result] : kernel.families) {
      result.verdict.undecided = result.verdict.undecided_contact = result.truth.contact;
      result.verdict.undecided_touching = result.truth.touching;
    }
  }
  for (const ComparisonStatement& row : derived_predicate(made.predicate, made.record).comparison) {
    EXPECT_FALSE(row.missed || row.deepest_missed) << row.kernel;
    EXPECT_TRUE(row.phantom && row.deepest_phantom) << row.kernel;
  }
}

TEST(Derived, PlantedFaultsThatNothingWasAskedOfAreNotSaidToBeNoticed) {
  CertifiedRecord made = of_published();
  made.predicate.harness.score.put("binary32") = {300, 0, 0, 0, 0};
  made.predicate.harness.score.put("binary64") = {300, 290, 280, 10, 10};
  const std::string limits = json_of(derived_predicate(made.predicate, made.record).limits).dump();
  EXPECT_THAT(limits, HasSubstr("Of 300 faults planted in a right kernel that shows as much, none was asked a valid"));
  EXPECT_THAT(limits, HasSubstr("10 were not noticed in binary64"));
  EXPECT_THAT(limits, Not(HasSubstr("not noticed in binary32")));
}

// More answers are lacking than there are contacts: of which kind they were the counts tell, and nothing else.
TEST(Derived, MissedContactsAreSaidBesideManyAnswersThatLack) {
  CertifiedRecord made = of_published();
  for (KernelRecord& kernel : made.record.kernels) {
    for (auto& [family, result] : kernel.families) {
      VerdictTally& verdict = result.verdict;
      verdict.decided_contacts = verdict.false_separation = std::min<std::uint64_t>(3, verdict.decided_contacts);
      verdict.decided_separations = verdict.false_contact = 0;
      verdict.unanswered = result.truth.contact + result.truth.separated - verdict.decided_contacts;
    }
  }
  for (const ComparisonStatement& row : derived_predicate(made.predicate, made.record).comparison) {
    EXPECT_TRUE(row.missed && row.deepest_missed) << row.kernel;
    EXPECT_FALSE(row.phantom || row.deepest_phantom) << row.kernel;
  }
}

TEST(Derived, EachContradictionIsNamed) {
  struct Case {
    const char* says;
    std::function<void(Json&)> change;
  };
  const Case cases[] = {
      {"it has 3 of the plan's 8 stretches",
       [](Json& p) {
         p["materials"]["tallies"].erase(p["materials"]["tallies"].begin() + 3, p["materials"]["tallies"].end());
       }},
      {"is there again", [](Json& p) { p["materials"]["tallies"][1]["stretch"] = 0; }},
      {"its stretch 0 is said to be", [](Json& p) { p["materials"]["tallies"][0]["of"] = "tangent"; }},
      {"effort deep asks 16,777,216 queries of `", [](Json& p) { p["asked"]["effort"] = "deep"; }},
      {"255 queries, and its plan has 256", [](Json& p) { p["materials"]["tallies"][0]["counts"][0]["trials"] = 255; }},
      {"a count there is from 0 to", [](Json& p) { p["materials"]["tallies"][0]["counts"][0]["trials"] = -1; }},
      {"a count there is from 0 to", [](Json& p) { p["materials"]["tallies"][0]["counts"][0]["trials"] = 1ULL << 63; }},
      {"which no count is called", [](Json& p) { p["materials"]["tallies"][0]["counts"][0]["queries"] = 3; }},
      {"met, and its counts say: not met: ",
       [](Json& p) {
         for (Json& l : p["levels"]) l["state"] = "met";
       }},
      {"its kernel and its plan are of different predicates", [](Json& p) { p["kernel"]["question"] = "box-box"; }},
      {"its plan was not done to its end",
       [](Json& p) { p["materials"]["plan"]["plan"]["units_done"] = Json::object(); }},
      {"its plan does not say how many queries",
       [](Json& p) { p["materials"]["plan"]["plan"]["trials"]["tangent"].erase("binary32"); }},
      {"its kernel kernel binary32 is there twice",
       [](Json& p) {
         for (Json& k : p["materials"]["kernels"]) k["id"] = "kernel";
       }},
      {"it has no counts of the kernel certified",
       [](Json& p) {
         Json kept = Json::array();
         for (const Json& k : p["materials"]["kernels"]) {
           if (k["id"] == "kernel") kept.push_back(k);
         }
         p["materials"]["kernels"] = kept;
       }},
      {"/by_size/much: 1 under a name that is not in the schema",
       [](Json& p) {
         for (Json& kernel : p["materials"]["kernels"])
           for (Json& family : kernel["families"])
             if (family.contains("invariance"))
               for (Json& changes : family["invariance"]) changes["by_size"]["much"] = 1;
       }},
      {"it does not say what its images came to",
       [](Json& p) {
         for (Json& family : p["materials"]["kernels"][0]["families"]) family.erase("invariance");
       }},
      {"which it does not name", [](Json& p) { p["materials"]["tallies"][0]["counts"][0]["findings"]["crash"] = 1; }},
      {"it states `may_decline`", [](Json& p) { p["kernel"]["may_decline"] = true; }},
      {"its comparison states missed", [](Json& p) { p["comparison"][0]["missed"] = 0; }},
      {"what it states to break first", [](Json& p) { p["breaks_first"]["count"] = 1; }},
  };
  for (const Case& one : cases) {
    Json predicate = json_of(of_published().predicate);
    one.change(predicate);
    EXPECT_THAT(refusal_of(predicate), HasSubstr(one.says));
  }
}

// A promise that was narrowed after the run leaves its counts without what they are outside of.
TEST(Derived, APromiseThatIsEditedContradictsItsCounts) {
  Json predicate = json_of(of_published().predicate);
  for (Json& entry : predicate["materials"]["kernels"]) entry["touching"] = "either";
  EXPECT_THAT(refusal_of(predicate), HasSubstr("decided")) << "what touches is in no count of these";
  predicate = json_of(of_published().predicate);
  predicate["materials"]["kernels"][0]["limits"] = {{"least_coordinate", nullptr},
                                                    {"greatest_coordinate", nullptr},
                                                    {"least_area", nullptr},
                                                    {"least_radius", "much"},
                                                    {"greatest_radius", nullptr},
                                                    {"margin", nullptr},
                                                    {"sides", nullptr}};
  EXPECT_THAT(refusal_of(predicate), HasSubstr("which is no number"));
}

TEST(SparseCounts, AreWholeAgain) {
  const Json none = {{"trials", 0u},
                     {"verdict", {{"deepest", 0.0}, {"links", {{"range", 0u}}}, {"largest_in_u", 0.0}}}};
  Json counts = none;
  EXPECT_EQ(canonical_json(sparse_counts(counts)), "{}");
  counts["trials"] = 7u;
  counts["verdict"]["deepest"] = 0.1;
  counts["verdict"]["largest_in_u"] = "1.5e+620";
  const Json sparse = sparse_counts(counts);
  EXPECT_EQ(canonical_json(sparse), R"({"trials":7,"verdict":{"deepest":"0.1","largest_in_u":"1.5e+620"}})");
  EXPECT_EQ(whole_counts(none, sparse, 7, "it"), counts);
  EXPECT_THROW(whole_counts(none, sparse, 6, "it"), NotValid);
  for (const char* text : {"1.5e+620x", "e+620", "-1", "inf", "nan", ""})
    EXPECT_THROW(whole_counts(none, {{"verdict", {{"deepest", text}}}}, 7, "it"), NotValid) << text;
}

}  // namespace
}  // namespace axiscert
