#include "reports/gates/enough.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/queries/source.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// A sentence about the first of some families, and how many more there are.
class Shortfall {
 public:
  void add(std::string what) {
    if (count_++ == 0) first_ = std::move(what);
  }
  bool any() const { return count_ != 0; }
  std::string text() const {
    return count_ < 2 ? first_
                      : fmt::format("{}, and so {} more", first_,
                                    count_ == 2 ? "one family" : fmt::format("{} families", count_ - 1));
  }

 private:
  std::string first_;
  std::size_t count_ = 0;
};

}  // namespace

std::string gap_of(const Record& record, const Subject& subject, const AskedLevel& asked) {
  const Precision precision = subject.kernel().precision;
  if (!record.complete) return interrupted_text(record);
  if (subject.families().empty()) return fmt::format("no query of it was run in {}", name(precision));
  if (const Evidence all = evidence_of(subject.kernel()); all.decided() == 0) {
    if (all.population == 0) return fmt::format("none of its queries is valid in {}", name(precision));
    return all.promised() == 0 && all.outside != 0 ? "every valid query is outside the limits that it declares"
                                                   : "it called no valid query within its limits separated or contact";
  }
  std::vector<std::string> empty;
  for (const auto& [family, by_precision] : record.plan.trials) {
    if (!asked.is_about(family)) continue;
    const auto* const planned = record.plan.planned ? record.plan.planned->find(family) : nullptr;
    if (planned != nullptr && planned->contains(precision)) {
      return fmt::format("the time limit left {} of the {} queries of {} unasked",
                         thousands(planned->at(precision) - by_precision.at(precision)),
                         thousands(planned->at(precision)), family);
    }
    std::uint64_t queries = 0;
    for (const auto& [each, count] : by_precision) queries += count;
    const auto here = by_precision.find(precision);
    const bool is_reached = is_query_list(family) || here == by_precision.end() || here->second != 0;
    if (queries == 0 || !is_reached) empty.push_back(family);
  }
  return empty.empty() ? "" : fmt::format("no query was run of {}", fmt::join(empty, ", "));
}

std::string weigh(const Subject& subject, const LevelFindings& found, double share, LevelOutcome& outcome) {
  Shortfall unasked, few, declining;
  for (const auto& [family, look] : found.families) {
    const Evidence evidence = subject.evidence(subject.families().at(family));
    if (evidence.population == 0) {
      unasked.add(fmt::format("no valid query of {} was asked", family));
      continue;
    }
    outcome.evidence.add(evidence);
    outcome.looked_at += look.looked_at;
    outcome.concerned += look.concerned;
    ++outcome.families;
    if (evidence.promised() == 0) {
      outcome.outside.push_back(family);
      continue;
    }
    // A list has the queries that it has; any other family is asked as many as the plan says.
    const bool is_sample_too_small = !is_query_list(family) && evidence.population < least_looked_at;
    if (is_sample_too_small || look.looked_at < std::min(least_looked_at, look.concerned)) {
      few.add(fmt::format("{} of {} {} of {} looked at, and {} are needed, to show that fewer than 5 % {}",
                          thousands(look.looked_at), thousands(look.concerned),
                          look.concerned == 1 ? "query" : "queries", family, least_looked_at,
                          level_of(outcome.asked).breaking));
    }
    if (!subject.kernel().may_decline) continue;
    const auto check = [&](std::uint64_t declined, std::uint64_t of, const char* what) {
      if (declines_too_many(declined, of, share)) {
        declining.add(fmt::format("it declines {} of {} {} of {}, and has to decide {} of them", thousands(declined),
                                  thousands(of), what, family, share));
      }
    };
    check(evidence.declined_contacts, evidence.contacts, "contacts");
    check(evidence.declined_separations, evidence.separations, "separations");
    check(look.declined, look.concerned, "pairs of a query and its image");
  }
  outcome.has_limits = has_limits(subject.kernel()) || !outcome.outside.empty();
  if (outcome.families != 0 && outcome.outside.size() == outcome.families)
    return "every valid query is outside the limits that it declares";
  if (unasked.any()) return unasked.text();
  if (declining.any()) return declining.text();
  if (few.any()) return few.text();
  const Evidence& all = outcome.evidence;
  const auto of_kind = [](std::uint64_t promised, std::uint64_t declined, std::uint64_t population,
                          const char* what) -> std::string {
    const std::uint64_t decided = promised - declined;
    const std::uint64_t needed = std::min(least_of_each_kind, population);
    if (decided >= needed) return "";
    return fmt::format("{} of {} exact {} were decided, and {} are needed", thousands(decided), thousands(population),
                       what, needed);
  };
  std::uint64_t contacts = 0, separations = 0;
  for (const auto& [family, look] : found.families) {
    const TruthCounts& truth = subject.families().at(family).truth;
    const TouchingPolicy touching = subject.kernel().touching;
    contacts += contacts_of(touching, truth);
    separations += truth.separated + (touching == TouchingPolicy::separated ? truth.touching : 0);
  }
  const std::string missing = of_kind(all.contacts, all.declined_contacts, contacts, "contacts");
  return missing.empty() ? of_kind(all.separations, all.declined_separations, separations, "separations") : missing;
}

std::string fewest_text(const Subject& subject, const LevelFindings& found, const AskedLevel& asked) {
  const GateLevel& level = level_of(asked);
  if (level.yardstick != nullptr) return "";
  std::string family;
  std::uint64_t fewest = 0;
  for (const auto& [name, look] : found.families) {
    const std::uint64_t independent = std::min(look.looked_at, subject.families().at(name).base_triangles);
    if (look.looked_at == 0 || (!family.empty() && independent >= fewest)) continue;
    family = name;
    fewest = independent;
  }
  if (family.empty()) return "";
  return fmt::format(
      "; the fewest of a family, {} independent queries of {}, show with 95 % that fewer than {:.3g} % {}",
      thousands(fewest), family, upper_bound_percent(fewest), level.breaking);
}

std::string UntakenLines::text() const {
  return fmt::format("{} of {} queries of {}, which are of {}: {}", thousands(count), thousands(all), family,
                     name(precision), why);
}

std::vector<UntakenLines> lines_left_out(const Record& record) {
  std::vector<UntakenLines> lines;
  for (const FileRecord& file : record.plan.files) {
    if (!file.left_out) continue;
    for (const auto& [precision, count] : *file.left_out)
      lines.push_back(
          {file.family_name(), precision, count, file.queries.value_or(count), "the run was not to ask them"});
  }
  return lines;
}

std::vector<UntakenLines> lines_it_cannot_take(const Record& record, const std::string& id) {
  std::vector<UntakenLines> lines;
  for (const auto& [family, by_precision] : record.plan.trials) {
    if (!is_query_file(family)) continue;  // a preset brings the corpus
    std::uint64_t all = 0;
    for (const auto& [precision, count] : by_precision) all += count;
    for (const auto& [precision, count] : by_precision) {
      const bool is_taken = std::ranges::any_of(record.kernels, [&, precision = precision](const KernelRecord& kernel) {
        return kernel.id == id && kernel.precision == precision;
      });
      if (count != 0 && !is_taken) lines.push_back({family, precision, count, all, "it does not exist in it"});
    }
  }
  return lines;
}

}  // namespace axiscert
