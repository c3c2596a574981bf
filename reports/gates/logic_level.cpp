// The findings of `logic`, for the levels that require it too.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"
#include "reports/gates/invariant_level.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
LevelFindings logic_findings(const Subject& subject);

// logic: the formulae are right and the code computes them, so that only rounding or range makes a verdict wrong.

namespace {

using Basis = Subject::Basis;

// Whether a wrong verdict, touching spheres apart, is wrong logic. For a kernel without a reference this is not so in
// families of images, in which its own precision may leave its range: it is held to the clear ones that it has right in
// one unit of length.
bool is_of_exact_arithmetic(const Subject& subject, const FamilyRecord& result) {
  const bool is_judged_by_images = subject.basis() != Basis::reference && units_of(result) != nullptr;
  return result.exact_arithmetic && !is_judged_by_images;
}

// The look at a family of exact arithmetic is at the queries that do not touch.
FamilyLook look_at_exact(const Subject& subject, const FamilyRecord& result) {
  const Evidence evidence = subject.evidence(result);
  return {evidence.population - result.truth.touching, evidence.decided() - result.verdict.decided_touching};
}

// Any other family is looked at by the clear ones that are decided. Fewer than the least are no evidence: then it
// counts as unseen, and is judged all the same.
FamilyLook look_at_clear(const FamilyRecord& result) {
  const ClearTally clear = result.verdict.clear.value_or(ClearTally());
  return {clear.queries, clear.decided(), clear.undecided};
}

// Families that ran, and their queries that count.
struct Seen {
  std::vector<std::string> names;
  std::uint64_t queries = 0;

  void add(const std::string& family, std::uint64_t looked_at) {
    if (looked_at == 0) return;
    names.push_back(family);
    queries += looked_at;
  }
};
std::string names_of(const Seen& seen) { return seen.names.empty() ? "no family" : list_of(seen.names); }

// Queries beside the same in another unit of length.
struct Units {
  std::vector<std::string> names;
  std::uint64_t images = 0;
};
Units units_that_ran(const Subject& subject) {
  Units units;
  for (const auto& [family, result] : subject.families()) {
    const ImageChangesRecord* scale = units_of(result);
    if (scale == nullptr || scale->images == 0) continue;
    units.names.push_back(family);
    units.images += scale->images;
  }
  return units;
}

// The families of exact arithmetic that a run could have had.
std::string families_to_add(const Subject& subject) {
  std::vector<std::string> options;
  for (const Family* family : families_of(predicate_of(subject.record().plan))) {
    if (family->exact_arithmetic && image_group(family->name) == nullptr)
      options.push_back(fmt::format("--family {}", family->name));
  }
  return options.empty() ? "this predicate has no family of exact arithmetic"
                         : "add " + fmt::format("{}", fmt::join(options, " "));
}

// Wrong verdicts on clear queries, by direction, each with the first of them.
void add_wrong_on_clear(const Subject& subject, const std::string& family, const ClearTally& clear,
                        std::vector<Failure>& failures) {
  subject.add_shown(failures, family, clear.false_separation, "missed contacts on clear queries",
                    "first false_separation on a clear query");
  subject.add_shown(failures, family, clear.false_contact, "phantom contacts on clear queries",
                    "first false_contact on a clear query");
}

void find_logic_failures(const Subject& subject, const std::string& family, const FamilyRecord& result,
                         std::vector<Failure>& failures) {
  const VerdictTally& verdict = result.verdict;
  const bool exact_arithmetic = is_of_exact_arithmetic(subject, result);
  // No rounding of a right kernel differs between two units of length. One with a reference has its range told apart.
  if (const ImageChangesRecord* units = units_of(result); units != nullptr && subject.basis() != Basis::reference) {
    const UnitChange change = unit_change(*units);
    subject.add_pair(failures, family, change.count, change.what, change.first);
  }
  if (subject.basis() == Basis::verdicts) {
    // Without formulae to compare with, a wrong verdict in exact arithmetic is wrong logic, and so is one on a clear
    // query. A method of the kernel's own may still round there, and for a touching sphere any rounding shows.
    if (!exact_arithmetic) {
      add_wrong_on_clear(subject, family, verdict.clear.value_or(ClearTally()), failures);
      return;
    }
    const std::uint64_t wrong = verdict.false_separation + verdict.false_contact;
    subject.add(
        failures, family, wrong - verdict.touching_flips,
        "wrong verdicts in exact arithmetic, touching ones not counted", [](const FlipRecord&) { return true; }, false);
    return;
  }
  for (const Link link : {Link::specification, Link::implementation})
    subject.add_link(failures, family, link, verdict.links[link]);
  // Formulae evaluated in an order of operations of the kernel's own: where they round, an unattributed difference
  // may be rounding and is not a fault of logic. In exact arithmetic and on clear queries it is one.
  if (subject.basis() == Basis::formulae && exact_arithmetic) {
    const Link link = Link::unattributed;
    subject.add_link(failures, family, link, verdict.links[link] - verdict.touching_links[link]);
  } else if (subject.basis() == Basis::formulae) {
    add_wrong_on_clear(subject, family, verdict.clear.value_or(ClearTally()), failures);
  }
}

std::string logic_sentence(const AskedLevel&) {
  return "no wrong verdict but by rounding or range: the formulae are right (specification), and so is the code that "
         "computes them (implementation). A kernel that claims no formulae, or has its own way to evaluate them, is "
         "held to clear queries, which no right method gets wrong; to queries on which nothing is rounded, touching "
         "ones not counted; and to other units of length, in which its verdicts have to be the same. "
         "One that gives times gives one in [0, 1] beside each contact";
}

LevelFindings judge_logic(const AskedLevel&, const Subject& subject) { return logic_findings(subject); }

}  // namespace

LevelFindings logic_findings(const Subject& subject) {
  LevelFindings found;
  for (const auto& [family, result] : subject.families()) find_logic_failures(subject, family, result, found.failures);
  subject.add_untimed(found.failures);
  const std::string queries = thousands(subject.decided());
  if (subject.basis() == Basis::reference) {
    for (const auto& [family, result] : subject.families()) found.families[family] = subject.whole_look(result);
    found.covers = fmt::format(
        "every wrong verdict on {} queries of {}, each compared with the kernel's own formulae, exact and as its "
        "reference computes them",
        queries, subject.list_of_families());
    found.leaves_out = "rounding and range, and queries that these families do not make";
    return found;
  }
  const bool has_formulae = subject.basis() == Basis::formulae;
  Seen exact, clear;
  for (const auto& [family, result] : subject.families()) {
    const ImageChangesRecord* units = units_of(result);
    const bool is_exact = is_of_exact_arithmetic(subject, result);
    const FamilyLook look = is_exact ? look_at_exact(subject, result) : look_at_clear(result);
    if (is_exact || look.concerned >= least_looked_at) (is_exact ? exact : clear).add(family, look.looked_at);
    if (const Evidence evidence = subject.evidence(result); evidence.promised() == 0 && evidence.population != 0)
      found.families[family] = {};  // outside its limits
    else if (!is_exact && units != nullptr)
      found.families[family] = subject.pairs_look(result, units->images, units->undecided);
    else if (is_exact || look.concerned >= least_looked_at) found.families[family] = look;
    else found.unseen.push_back(family);
  }
  const std::string cause = has_formulae ? "a difference from the formulae that it claims" : "a wrong verdict";
  if (exact.queries + clear.queries == 0) {
    found.not_checked = fmt::format(
        "no clear query was decided, and none of a family of exact arithmetic; elsewhere {} may be of rounding; {}",
        cause, families_to_add(subject));
    return found;
  }
  found.covers = fmt::format(
      "verdicts on {} clear queries of {}, which no right method gets wrong, and on {} queries of {} that do not "
      "touch, "
      "where there is nothing to round",
      thousands(clear.queries), names_of(clear), thousands(exact.queries), names_of(exact));
  if (has_formulae)
    found.covers += fmt::format("; its formulae, exact, on {} queries of {}", queries, subject.list_of_families());
  const Units units = units_that_ran(subject);
  if (units.images != 0) {
    found.covers += fmt::format("; {} queries of {}, each the same as another in another unit of length",
                                thousands(units.images), fmt::join(units.names, ", "));
  }
  found.leaves_out =
      fmt::format("{}{} on any other query: {} wrong verdicts of this run have no known cause",
                  units.images == 0 ? "other units of length, and " : "", cause, thousands(subject.wrong_verdicts()));
  return found;
}

extern const GateLevel logic_level = {
    .usage = "logic",
    .meaning = "no wrong verdict but by rounding or range: the method is right, and so is the code",
    .sentence = logic_sentence,
    .judge = judge_logic,
    .is_about_causes = true,
    .badge = Badge{3, "#b8860b"},
    .advice = "asks that only rounding and range make a verdict wrong"};

// range: nor by range.

namespace {

std::string range_sentence(const AskedLevel&) {
  return "no wrong verdict but by rounding: the formulae are right (specification), so is the code that computes them "
         "(implementation), and nothing over- or underflows into a wrong verdict (range). A kernel that claims no "
         "formulae, or has its own way to evaluate them, has no wrong verdict, since none can be told to be of "
         "rounding";
}

LevelFindings judge_range(const AskedLevel&, const Subject& subject) {
  LevelFindings found = logic_findings(subject);
  if (subject.basis() == Subject::Basis::reference) {
    for (const auto& [family, result] : subject.families()) {
      subject.add_link(found.failures, family, Link::range, result.verdict.links[Link::range]);
    }
    found.leaves_out = "rounding, and queries that these families do not make";
    return found;
  }
  if (!found.not_checked.empty()) return found;
  const std::string wrong = thousands(subject.wrong_verdicts());
  if (subject.wrong_verdicts() == 0) {
    found.unseen.clear();
    for (const auto& [family, result] : subject.families()) found.families[family] = subject.whole_look(result);
    found.covers = fmt::format("{} queries of {}: no verdict is wrong, so none is by range",
                               thousands(subject.decided()), subject.list_of_families());
    found.leaves_out = "queries that these families do not make";
  } else if (subject.basis() == Subject::Basis::verdicts) {
    found.not_checked = fmt::format(
        "the kernel shows verdicts alone: a wrong verdict ({} of them) cannot be told to be of range or of rounding",
        wrong);
  } else {
    found.not_checked = fmt::format(
        "the kernel evaluates its formulae in its own way: a wrong verdict ({} of them) cannot be told to be of range "
        "or of rounding",
        wrong);
  }
  return found;
}

}  // namespace

extern const GateLevel range_level = {.usage = "range",
                                      .meaning = "no wrong verdict but by rounding",
                                      .sentence = range_sentence,
                                      .judge = judge_range,
                                      .is_about_causes = true};

}  // namespace axiscert
