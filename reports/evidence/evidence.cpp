#include "reports/evidence/evidence.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "kernel/names.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::uint64_t queries_in(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

// A record is checked when it is read; one that is made in a test may be off.
std::uint64_t without(std::uint64_t all, std::uint64_t part) { return all - std::min(all, part); }

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

Evidence evidence_of(const Json& kernel, const Json& result) {
  const Json &truth = result["truth"], &verdict = result["verdict"], &beyond = verdict["outside_limits"];
  const bool has_limits = !beyond.is_null(), promises_touch = kernel["touching"] != name(Touching::either);
  Evidence evidence;
  evidence.population = without(queries_in(result, "trials"), queries_in(truth, "invalid"));
  evidence.outside = has_limits ? queries_in(beyond, "trials") : 0;
  const std::uint64_t within = without(evidence.population, evidence.outside);
  const std::uint64_t touching =
      without(queries_in(truth, "touching"), has_limits ? queries_in(beyond, "touching") : 0);
  evidence.touching = promises_touch ? 0 : touching;
  evidence.contacts =
      without(without(queries_in(truth, "contact"), has_limits ? queries_in(beyond, "contact") : 0), evidence.touching);
  evidence.separations = without(without(within, evidence.touching), evidence.contacts);
  evidence.declined_contacts =
      without(queries_in(verdict, "undecided_contact"), promises_touch ? 0 : queries_in(verdict, "undecided_touching"));
  evidence.declined_separations = without(queries_in(verdict, "undecided"), queries_in(verdict, "undecided_contact"));
  evidence.invalid = queries_in(verdict, "invalid");
  evidence.unanswered = queries_in(verdict, "unanswered");
  return evidence;
}

Evidence evidence_of(const Json& kernel) {
  Evidence all;
  for (const Json& result : kernel["families"]) all.add(evidence_of(kernel, result));
  return all;
}

bool declines_too_many(std::uint64_t declined, std::uint64_t of, double share) {
  return static_cast<double>(without(of, declined)) < share * static_cast<double>(of);
}

std::string decided_text(const Evidence& evidence) {
  const auto tenths =
      static_cast<std::uint64_t>(1000 * static_cast<long double>(evidence.decided()) /
                                 static_cast<long double>(std::max<std::uint64_t>(evidence.promised(), 1)));
  if (tenths == 0) return evidence.decided() == 0 ? "none" : "under 0.1 %";
  return tenths % 10 == 0 ? fmt::format("{} %", tenths / 10) : fmt::format("{}.{} %", tenths / 10, tenths % 10);
}

std::string evidence_text(const Evidence& evidence, std::uint64_t looked_at) {
  std::string text =
      fmt::format("{} of {} promised queries looked at", thousands(looked_at), thousands(evidence.promised()));
  const auto add = [&](std::uint64_t count, const char* what) {
    if (count != 0) text += fmt::format(", {} {}", thousands(count), what);
  };
  if (evidence.declined() != 0)
    text += fmt::format(", {} declined: it decides {}", thousands(evidence.declined()), decided_text(evidence));
  add(evidence.invalid, "called invalid");
  add(evidence.unanswered, "without an answer");
  if (evidence.outside != 0)
    text += fmt::format(", {} of {} outside its limits", thousands(evidence.outside), thousands(evidence.population));
  add(evidence.touching, "touching, of which it promises nothing");
  return text;
}

double upper_bound_percent(std::uint64_t n) {
  return n == 0 ? 100 : -100 * std::expm1(std::log(0.05) / static_cast<double>(n));
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
