#include "reports/wording/evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "fuzz/record/tally.h"
#include "fuzz/record/proportions.h"
#include "fuzz/text/merge.h"

namespace axiscert {
namespace {

// A record is checked when it is read; one that is made in a predicate may be off.
std::uint64_t without(std::uint64_t all, std::uint64_t part) { return all - std::min(all, part); }

}  // namespace

std::uint64_t Evidence::decided() const { return without(promised(), declined() + invalid + unanswered); }
std::uint64_t Evidence::decided_for(FlipKind kind) const {
  const bool is_contacts = kind == FlipKind::false_separation;
  const std::uint64_t most = without(promised_for(kind), is_contacts ? declined_contacts : declined_separations);
  // Answers that are invalid or missing may be of either kind: the counts of the decided tell.
  return invalid + unanswered == 0 ? most : std::min(most, is_contacts ? decided_contacts : decided_separations);
}
void Evidence::add(const Evidence& other) { merge_fields(*this, other); }

namespace {

Evidence evidence_in(TouchingPolicy touching, std::uint64_t trials, const TruthCounts& truth,
                     const VerdictTally& verdict) {
  const OutsideTally beyond = verdict.outside_limits.value_or(OutsideTally());
  Evidence evidence;
  evidence.population = without(trials, truth.invalid);
  evidence.outside = beyond.trials;
  const std::uint64_t touch = without(truth.touching, beyond.touching);
  const bool touch_is_contact = touching == TouchingPolicy::contact;
  evidence.touching = touching == TouchingPolicy::either ? touch : 0;
  evidence.contacts = without(without(truth.contact, beyond.contact), touch_is_contact ? 0 : touch);
  evidence.separations =
      without(without(without(evidence.population, evidence.outside), evidence.touching), evidence.contacts);
  evidence.declined_contacts = without(verdict.undecided_contact, touch_is_contact ? 0 : verdict.undecided_touching);
  evidence.declined_separations = without(verdict.undecided, verdict.undecided_contact) +
                                  (touching == TouchingPolicy::separated ? verdict.undecided_touching : 0);
  evidence.decided_contacts = verdict.decided_contacts;
  evidence.decided_separations = verdict.decided_separations;
  evidence.invalid = verdict.invalid;
  evidence.unanswered = verdict.unanswered;
  return evidence;
}

}  // namespace

std::uint64_t contacts_of(TouchingPolicy touching, const TruthCounts& truth) {
  return touching == TouchingPolicy::contact ? truth.contact : truth.contact - truth.touching;
}

Evidence evidence_of(TouchingPolicy touching, const Tally& tally) {
  return evidence_in(touching, tally.trials, tally.truth, tally.verdict);
}

Evidence evidence_of(TouchingPolicy touching, const FamilyCounts& counts) {
  return evidence_in(touching, counts.trials, counts.truth, counts.verdict);
}

Evidence evidence_of(const KernelRecord& kernel, const FamilyRecord& result) {
  return evidence_of(kernel.touching, result);
}

Evidence evidence_of(const KernelRecord& kernel) {
  Evidence all;
  for (const auto& [family, result] : kernel.families) all.add(evidence_of(kernel, result));
  return all;
}

bool declines_too_many(std::uint64_t declined, std::uint64_t of, double share) {
  return static_cast<double>(without(of, declined)) < share * static_cast<double>(of);
}

std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at) {
  return evidence_text(evidence, looked_at, evidence.promised(), "queries");
}

std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at, std::uint64_t of, std::string_view part) {
  std::vector<std::string> parts = no_verdict_words(
      evidence.no_verdict(), "declined: it decides " + share_rounded_down(evidence.decided(), evidence.promised()));
  parts.insert(parts.begin(), fmt::format("{} of {} promised {} looked at", thousands(looked_at), thousands(of), part));
  if (evidence.outside != 0)
    parts.push_back(
        fmt::format("{} of {} outside its limits", thousands(evidence.outside), thousands(evidence.population)));
  add_count(parts, evidence.touching, "touching, of which it promises nothing");
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string decided_text(const Evidence& evidence, FlipKind kind) {
  return fmt::format("{} of {} {} decided", thousands(evidence.decided_for(kind)),
                     thousands(evidence.promised_for(kind)),
                     kind == FlipKind::false_separation ? "contacts" : "separations");
}

double upper_bound_percent(std::uint64_t n) { return 100 * excluded_rate(n); }

namespace {

double zero_limit_of(const FamilyRecord& family, std::uint64_t decided) {
  const std::uint64_t n = std::min(family.base_triangles, decided);
  return n == 0 ? -1 : 1e6 * excluded_rate(n);
}

}  // namespace

double zero_limit_per_million(const KernelRecord& kernel, const FamilyRecord& family) {
  return zero_limit_of(family, evidence_of(kernel, family).decided());
}

double zero_limit_per_million(const KernelRecord& kernel, const FamilyRecord& family, FlipKind kind) {
  return zero_limit_of(family, evidence_of(kernel, family).decided_for(kind));
}

std::string with_rate(FlipKind kind, const KernelRecord& kernel, const FamilyRecord& family) {
  const std::uint64_t count = family.verdict.wrong(kind);
  if (count > 0) return fmt::format("{} ({} per million)", thousands(count), amount(per_million(count, family), 3));
  const double limit = zero_limit_per_million(kernel, family, kind);
  return limit < 0 ? "not checked" : fmt::format("0 (< {} per million, 95 %)", amount(limit, 3));
}

}  // namespace axiscert
