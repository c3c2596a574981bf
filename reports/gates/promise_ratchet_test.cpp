// A ratchet holds what each kernel promises: who promises less is worse, and who promises other things is not compared.
#include "fuzz/text/json_form.h"
#include "reports/comparison/compare.h"
#include "reports/gates/ratchet.h"
#include "reports/testing/edited_record.h"
#include "reports/testing/test_run.h"

namespace axiscert {
namespace {

using testing::AllOf;
using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

constexpr const char* the_day = "2026-06-15";

std::string accepted_file(const Json& record) {
  std::string text = ratchet_text(record);
  const std::string open = "EXPIRY OWNER REASON";
  for (std::size_t at = text.find(open); at != text.npos; at = text.find(open))
    text.replace(at, open.size(), "never mk why");
  return text;
}

RatchetOutcome held_to(const Json& then, const Json& now) {
  return hold_against(parse_ratchet(accepted_file(then), "r.txt"), now, the_day);
}

std::vector<std::string> failures_of_promises(const RatchetOutcome& outcome) {
  std::vector<std::string> all;
  for (const RatchetFailure& failure : outcome.failures) all.push_back(failure.text);
  return all;
}

std::string promise_error(const std::string& text) {
  try {
    parse_ratchet(text, "r.txt");
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(RatchetOfPromises, HasALineForEachKernelAndPrecision) {
  EXPECT_THAT(ratchet_text(with_least_radius(1e30, 450)),
              HasSubstr("\nkernel: published\npromise: binary32 queries=3145 touching=contact radius>=1e+30 "
                        "shows=comparisons,sides\n"
                        "kernel: <script>\npromise: binary32 queries=1495 touching=contact may_decline\naccept: "));
  EXPECT_THAT(ratchet_text(without_errors(stored_record())), HasSubstr("kernel: published\npromise: binary32"))
      << "whether or not it is wrong anywhere";
}

// A kernel that limits itself to what it is right about was passed in silence.
TEST(RatchetOfPromises, ALimitIsWorseThanAnyFigure) {
  const RatchetOutcome outcome = held_to(stored_record(), without_errors(with_least_radius(1e30, 450)));
  EXPECT_THAT(failures_of_promises(outcome),
              ElementsAre("published binary32 promises less than the ratchet: radius from 1e+30, was "
                          "none: 4,495 of its queries then, 3,145 now (r.txt:4)"));
  EXPECT_THAT(outcome.better, IsEmpty()) << "over other queries";
  EXPECT_EQ(outcome.failures[0].fingerprint, fingerprint(Json::array({"published", "binary32", "*", "*"})));
}

TEST(RatchetOfPromises, ComparisonsThatAreShownNoMoreAreLess) {
  Json now = without_errors(stored_record());
  now["kernels"][0]["exposes"] = {"verdict"};
  EXPECT_THAT(
      failures_of_promises(held_to(without_errors(stored_record()), now)),
      ElementsAre(
          "published binary32 shows less than the ratchet: no comparisons any more; no sides any more (r.txt:4)"));
}

// The figures of sides go with them: a ratchet of the comparisons alone would ask for it in vain.
TEST(RatchetOfPromises, SidesThatAreShownNoMoreTakeTheirFiguresAlong) {
  Json then = stored_record(), now = then;
  now["kernels"][0]["exposes"] = {"verdict", "comparisons"};
  for (Json& family : now["kernels"][0]["families"]) {
    for (const char* level : {"comparisons", "axes"}) {
      for (Json& tally : family[level]) {
        for (const char* member : {"tolerance_failures", "max_error_u", "smallest_passing_tolerance", "range_events",
                                   "error_without_scale"}) {
          if (tally.contains(member)) tally[member] = nullptr;
        }
      }
    }
  }
  const RatchetOutcome outcome = held_to(then, now);
  EXPECT_THAT(failures_of_promises(outcome), ElementsAre(HasSubstr("shows less than the ratchet: no sides any more")));
  EXPECT_THAT(outcome.accepted, Not(HasSubstr("range_events")));
  EXPECT_THAT(failures_of_promises(hold_against(parse_ratchet(outcome.accepted, "r.txt"), now, the_day)), IsEmpty());
}

// The greatest error is less, since the numbers with the greater ones are not given any more.
TEST(RatchetOfPromises, ANumberBesideFewerAnswersIsNoBetter) {
  const auto giving = [](std::uint64_t answers, double error, std::uint64_t said = 900) {
    Json record = without_errors(stored_record());
    Json& contacts = tangent_counts(record)["contacts"];
    contacts = json_of(ContactTally());
    contacts["answers"] = said;
    for (auto& [name, part] : contacts.items()) {
      if (name != "answers" && name != "separations" && name != "separation") part = nullptr;
    }
    SeparationTally with_figures;
    with_figures.judged = 1;
    Json& separation = contacts["separation"] = json_of(with_figures);
    separation["judged"] = separation["given"]["contacts"] = answers;
    separation["given"]["which_contacts"] = fmt::format("{:x}", answers);
    separation["largest_error"] = error;
    record["kernels"][0]["measures"] = {"separation"};
    return record;
  };
  const RatchetOutcome fewer = held_to(giving(900, 0.5), giving(400, 0.25));
  EXPECT_THAT(failures_of_promises(fewer),
              ElementsAre("published binary32 shows less than the ratchet: separation beside 400 of 900 contacts, 900 "
                          "before (r.txt:4)"));
  EXPECT_THAT(fewer.better, IsEmpty());
  EXPECT_THAT(fewer.accepted, HasSubstr("accept: EXPIRY OWNER REASON\n")) << "over other answers";
  EXPECT_THAT(held_to(giving(900, 0.5), giving(400, 0)).better, IsEmpty());
  const RatchetOutcome mended = held_to(giving(900, 0.5), giving(400, 0.25, 400));
  EXPECT_THAT(failures_of_promises(mended), IsEmpty()) << "it stands beside all that are contacts now";
  EXPECT_THAT(mended.better, IsEmpty());
  EXPECT_THAT(mended.changed, ElementsAre("published binary32: separation beside 400 of 400 contacts, 900 before, as "
                                          "verdicts changed"));

  const RunComparison found = compare_records(giving(900, 0.5), giving(400, 0.25), {});
  EXPECT_FALSE(found.passes());
  EXPECT_EQ(found.count(Change::better), 0u);
  ASSERT_EQ(found.not_compared.size(), 1u);
  EXPECT_EQ(found.not_compared[0].what + ": " + found.not_compared[0].why,
            "published binary32 on tangent: separation: separation beside 400 of 900 contacts, 900 before");
  const RunComparison with_verdicts = compare_records(giving(900, 0.5), giving(400, 0.25, 400), {});
  EXPECT_TRUE(with_verdicts.passes());
  EXPECT_EQ(with_verdicts.count(Change::better), 0u);
  EXPECT_TRUE(with_verdicts.has(Absence::verdicts));
}

TEST(RatchetOfPromises, AnotherPromiseIsNotComparedAndTheNewFileAcceptsIt) {
  const Json then = with_least_radius(1e30, 450), now = stored_record();
  const RatchetOutcome outcome = held_to(then, now);
  EXPECT_THAT(failures_of_promises(outcome),
              ElementsAre("NOT COMPARED: published binary32 promises other things than the ratchet: radius "
                          "none, was from 1e+30: 3,145 of its queries then, 4,495 now (r.txt:4)"));
  EXPECT_THAT(outcome.better, IsEmpty());
  EXPECT_THAT(outcome.accepted,
              AllOf(HasSubstr("promise: binary32 queries=4495 touching=contact shows=comparisons,sides\n"),
                    HasSubstr("accept: EXPIRY OWNER REASON\nkernel: published\n")))
      << "its figures are over other queries than those that were reviewed";
  std::string filled = outcome.accepted;
  filled.replace(filled.find("EXPIRY OWNER REASON"), 19, "never mk wider");
  EXPECT_THAT(failures_of_promises(hold_against(parse_ratchet(filled, "r.txt"), now, the_day)), IsEmpty());
}

TEST(RatchetOfPromises, OtherPopulationsOfOnePromiseAreNotCompared) {
  const RatchetOutcome outcome = held_to(with_least_radius(1, 100), without_errors(with_least_radius(1, 101)));
  EXPECT_THAT(failures_of_promises(outcome), ElementsAre(HasSubstr("4,195 of its queries then, 4,192 now")));
  EXPECT_THAT(outcome.better, IsEmpty());
}

TEST(RatchetOfPromises, AKernelWithoutErrorsThatVanishesIsNotChecked) {
  Json now = without_errors(stored_record());
  now["kernels"].erase(0);
  now["plan"]["kernels"].erase(0);
  EXPECT_THAT(failures_of_promises(held_to(without_errors(stored_record()), now)),
              ElementsAre("NOT CHECKED: this run did not judge published binary32 (r.txt:4); the kernels of this run: "
                          "<script>"));
}

TEST(RatchetOfPromises, APrecisionThatVanishesIsLess) {
  Json then = stored_record();
  then["plan"]["precisions"] = {"binary32", "binary64"};
  Json now = then, wide = then["kernels"][0];
  wide["precision"] = "binary64";
  then["kernels"].push_back(wide);
  const RatchetOutcome outcome = held_to(then, now);
  EXPECT_THAT(failures_of_promises(outcome),
              ElementsAre(StartsWith("published binary64 promises less than the ratchet: it does not exist "
                                     "in binary64 any more (r.txt:")));
  EXPECT_THAT(outcome.accepted, HasSubstr("\npromise: binary64 ")) << "as it was";
}

TEST(RatchetOfPromises, AKernelThatDecidesNothingIsNotHeld) {
  Json record = without_errors(stored_record());
  Json& kernel = record["kernels"][0];
  kernel["may_decline"] = true;
  for (Json& family : kernel["families"]) {
    const std::uint64_t contact = family["truth"]["contact"], separated = family["truth"]["separated"];
    family["verdict"]["undecided"] = contact + separated;
    family["verdict"]["undecided_contact"] = contact;
  }
  EXPECT_THAT(
      failures_of_promises(held_to(record, record)),
      ElementsAre("NOT CHECKED: published binary32 decided none of its 4,495 promised queries: no figure of it says "
                  "anything"));
}

TEST(RatchetOfPromises, FindingsAreHeldWhateverIsPromised) {
  Json now = with_least_radius(1e30, 450);
  now["findings"].push_back(crash_on("tangent"));
  EXPECT_THAT(failures_of_promises(held_to(stored_record(), now)),
              Contains(HasSubstr("finding.crash: 1, accepted is 0")));
}

// A case whose figures were not compared is no passed case.
TEST(RatchetOfPromises, JUnitFailsAndLeavesTheCasesSkipped) {
  const Ratchet ratchet = parse_ratchet(accepted_file(stored_record()), "r.txt");
  const auto junit = [&](Json record) {
    record["plan"]["require"] = nullptr;
    const TestFolder folder(record);
    folder.write("ratchet.json", json_of(hold_against(ratchet, record, the_day)).dump());
    EXPECT_EQ(folder.rendering_error(), "");
    return folder.read("junit.xml");
  };
  const std::string passed = "name=\"lattice edge_ab.side_c\" time=\"0\"/>";
  EXPECT_THAT(junit(stored_record()), HasSubstr(passed));
  EXPECT_THAT(junit(with_least_radius(1e30, 450)),
              AllOf(Not(HasSubstr(passed)), HasSubstr("<testsuite name=\"ratchet\""), HasSubstr("promises less than")));
}

TEST(RatchetOfPromises, BadLinesAreNamed) {
  const std::string good = accepted_file(stored_record());
  EXPECT_EQ(promise_error(good), "");
  const auto with = [&](const std::string& old, const std::string& now) {
    std::string text = good;
    return promise_error(text.replace(text.find(old), old.size(), now));
  };
  const std::string line = "promise: binary32 queries=4495 touching=contact shows=comparisons,sides\n";
  EXPECT_THAT(with(line, ""), HasSubstr("a figure of published binary32 without a promise: of it"));
  EXPECT_THAT(with(line, line + line), HasSubstr("r.txt:5: published binary32 has two promises, the first in line 4"));
  EXPECT_THAT(with("queries=4495", "queries=-1"), HasSubstr("'queries=-1' is not queries=NUMBER"));
  EXPECT_THAT(with("queries=4495 ", ""), HasSubstr("PRECISION queries=NUMBER touching=ANSWER"));
  EXPECT_THAT(with("binary32 queries", "binary16 queries"), HasSubstr("PRECISION 'binary16'"));
  EXPECT_THAT(with("=comparisons,sides", "=comparisons,sides,comparisons"), HasSubstr("shows 'comparisons' again"));
  EXPECT_THAT(with("=comparisons,", "=separation,"),
              HasSubstr("names 'separation', which is neither comparisons nor sides"));
  EXPECT_THAT(with("=comparisons,", "=,"), HasSubstr("names '', which is neither comparisons nor sides"));
  EXPECT_THAT(with(" shows=comparisons,sides", ""), HasSubstr("its promise: in line 4 does not show comparisons"));
  for (const char* word : {"separation=", "separation=4", "separation=4,0", "separation=0@a,0", "separation=-1@a,0",
                           "separation=4@,0", "separation=4@xyz,0", "separation=x,0"}) {
    EXPECT_THAT(with("shows=comparisons,sides", std::string("shows=comparisons,sides ") + word),
                HasSubstr(fmt::format("'{}' is not MEASURE=COUNT@MARK,COUNT@MARK", word)));
  }
  EXPECT_EQ(with("shows=comparisons,sides", "separation=4@a,0 shows=comparisons,sides"), "");
  EXPECT_THAT(with("touching=contact", "touch=contact"), HasSubstr("r.txt:4: 'touch=contact' is no part of a promise"));
  EXPECT_THAT(promise_error("axiscert-ratchet/5 p\n"), HasSubstr("without a promise: line it holds no kernel"));
}

}  // namespace
}  // namespace axiscert
