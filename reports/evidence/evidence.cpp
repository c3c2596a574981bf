#include "reports/evidence/evidence.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fuzz/campaign/counts/tally.h"

namespace axiscert {
namespace {

std::uint64_t queries_in(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

// A record is checked when it is read; one that is made in a test may be off.
std::uint64_t without(std::uint64_t all, std::uint64_t part) { return all - std::min(all, part); }

// 1 - 0.05^(1/n): the rate of failures that n right answers exclude, with 95 % confidence.
double excluded_rate(std::uint64_t n) { return n == 0 ? 1 : -std::expm1(std::log(0.05) / static_cast<double>(n)); }

}  // namespace

std::uint64_t Evidence::decided() const { return without(promised(), declined() + invalid + unanswered); }

void Evidence::add(const Evidence& other) {
  population += other.population;
  outside += other.outside;
  touching += other.touching;
  contacts += other.contacts;
  separations += other.separations;
  declined_contacts += other.declined_contacts;
  declined_separations += other.declined_separations;
  invalid += other.invalid;
  unanswered += other.unanswered;
}

Evidence evidence_of(Touching touching, const Tally& tally) {
  const VerdictTally& verdict = tally.verdict;
  const OutsideTally beyond = verdict.outside_limits.value_or(OutsideTally());
  const bool promises_touch = touching != Touching::either;
  Evidence evidence;
  evidence.population = without(tally.trials, tally.truth.invalid);
  evidence.outside = beyond.trials;
  evidence.touching = promises_touch ? 0 : without(tally.truth.touching, beyond.touching);
  evidence.contacts = without(without(tally.truth.contact, beyond.contact), evidence.touching);
  evidence.separations =
      without(without(without(evidence.population, evidence.outside), evidence.touching), evidence.contacts);
  evidence.declined_contacts = without(verdict.undecided_contact, promises_touch ? 0 : verdict.undecided_touching);
  evidence.declined_separations = without(verdict.undecided, verdict.undecided_contact);
  evidence.invalid = verdict.invalid;
  evidence.unanswered = verdict.unanswered;
  return evidence;
}

Evidence evidence_of(const Json& kernel, const Json& result) {
  const Json &truth = result["truth"], &said = result["verdict"], &beyond = said["outside_limits"];
  static const TestDescription any;  // only counts of queries are read, which every test has
  Tally tally(any);
  tally.trials = queries_in(result, "trials");
  tally.invalid = queries_in(truth, "invalid");
  tally.truth.contact = queries_in(truth, "contact");
  tally.truth.touching = queries_in(truth, "touching");
  VerdictTally& verdict = tally.verdict;
  if (!beyond.is_null()) {
    verdict.outside_limits.trials = queries_in(beyond, "trials");
    verdict.outside_limits.contact = queries_in(beyond, "contact");
    verdict.outside_limits.touching = queries_in(beyond, "touching");
  }
  verdict.undecided = queries_in(said, "undecided");
  verdict.undecided_contact = queries_in(said, "undecided_contact");
  verdict.undecided_touching = queries_in(said, "undecided_touching");
  verdict.invalid = queries_in(said, "invalid");
  verdict.unanswered = queries_in(said, "unanswered");
  return evidence_of(kernel["touching"] == name(Touching::either) ? Touching::either : Touching::contact, tally);
}

Evidence evidence_of(const Json& kernel) {
  Evidence all;
  for (const Json& result : kernel["families"]) all.add(evidence_of(kernel, result));
  return all;
}

bool declines_too_many(std::uint64_t declined, std::uint64_t of, double share) {
  return static_cast<double>(without(of, declined)) < share * static_cast<double>(of);
}

std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at) {
  std::vector<std::string> parts = no_verdict_words(
      evidence.no_verdict(), "declined: it decides " + share_rounded_down(evidence.decided(), evidence.promised()));
  parts.insert(parts.begin(), fmt::format("{} of {} promised queries looked at", thousands(looked_at),
                                          thousands(evidence.promised())));
  if (evidence.outside != 0)
    parts.push_back(
        fmt::format("{} of {} outside its limits", thousands(evidence.outside), thousands(evidence.population)));
  if (evidence.touching != 0)
    parts.push_back(fmt::format("{} touching, of which it promises nothing", thousands(evidence.touching)));
  return fmt::format("{}", fmt::join(parts, ", "));
}

double upper_bound_percent(std::uint64_t n) { return 100 * excluded_rate(n); }

double zero_limit_per_million(const Json& kernel, const Json& family) {
  const std::uint64_t n = std::min(queries_in(family, "base_triangles"), evidence_of(kernel, family).decided());
  return n == 0 ? -1 : 1e6 * excluded_rate(n);
}

std::string with_rate(std::uint64_t count, const Json& kernel, const Json& family) {
  if (count > 0) return fmt::format("{} ({} per million)", thousands(count), amount(per_million(count, family), 3));
  const double limit = zero_limit_per_million(kernel, family);
  return limit < 0 ? "not checked" : fmt::format("0 (< {} per million, 95 %)", amount(limit, 3));
}

Json evidence_json(const Evidence& evidence) {
  return {{"population", evidence.population},
          {"outside_limits", evidence.outside},
          {"touching_not_promised", evidence.touching},
          {"promised", evidence.promised()},
          {"declined", evidence.declined()},
          {"invalid", evidence.invalid},
          {"unanswered", evidence.unanswered},
          {"decided", evidence.decided()}};
}

Json promise_of(const Json& kernel) {
  Json promise = {
      {"limits", kernel["limits"]}, {"touching", kernel["touching"]}, {"may_decline", kernel["may_decline"]}};
  if (const auto motion = kernel.find("motion"); motion != kernel.end()) promise["motion"] = *motion;
  return promise;
}

}  // namespace axiscert
