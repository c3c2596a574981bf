#include "reports/certificate/derived/margin_check.h"

#include <fmt/format.h>

#include <cmath>

#include "exact/numbers/decimal6.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "reports/evidence/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::uint64_t margin_count(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

std::string disagreement(const std::string& what, std::uint64_t stated, std::uint64_t counted, const char* whose) {
  return stated == counted ? ""
                           : fmt::format("{}: {}, and {} say {}", what, thousands(stated), whose, thousands(counted));
}

// The counts of the run's stretches.
std::string fault_beside_counts(const Json& margin, const KernelRecord& entry) {
  const Evidence evidence = evidence_of(entry);
  const auto total = all_families(entry);
  if (!total) return "no query was run in that precision";
  const VerdictTally& verdict = total->verdict;
  const Json& contacts = margin["contacts"]["of_run"];
  const std::pair<const char*, std::pair<std::uint64_t, std::uint64_t>> pairs[] = {
      {"promised queries", {margin_count(margin, "queries"), evidence.promised()}},
      {"phantom contacts", {margin_count(margin, "phantoms"), verdict.false_contact}},
      {"contacts of the run", {margin_count(contacts, "asked"), evidence.contacts}},
      {"missed contacts of the run", {margin_count(contacts, "missed"), verdict.false_separation}},
      {"declined contacts of the run", {margin_count(contacts, "declined"), evidence.declined_contacts}}};
  for (const auto& [what, counts] : pairs) {
    if (std::string fault = disagreement(what, counts.first, counts.second, "its counts"); !fault.empty()) return fault;
  }
  if (margin_count(contacts, "invalid") > evidence.invalid ||
      margin_count(contacts, "unanswered") > evidence.unanswered)
    return "it has more contacts without an answer than its counts have queries";
  return "";
}

std::string fault_of_sums(const Json& margin) {
  const Json& all = margin["all"];
  for (const char* member :
       {"queries", "contacts", "without_verdict", "missed", "hopeless", "tiny", "unmeasured", "phantoms_by_factor",
        "phantoms_by_amount", "still_missed_by_factor", "still_missed_by_amount"}) {
    std::uint64_t sum = 0;
    for (const Json& part : margin["decades"]) sum += margin_count(part, member);
    if (std::string fault = disagreement(member, margin_count(all, member), sum, "its parts"); !fault.empty())
      return fault;
  }
  if ((margin_count(all, "hopeless") == 0) != margin["hopeless"].is_null())
    return "hopeless: it is counted, and none is shown";
  const Json &run = margin["contacts"]["of_run"], &others = margin["contacts"]["of_others"];
  const auto both = [&](const char* member) { return margin_count(run, member) + margin_count(others, member); };
  const std::pair<const char*, std::pair<std::uint64_t, std::uint64_t>> pairs[] = {
      {"queries", {margin_count(all, "queries"), margin_count(margin, "queries")}},
      {"contacts", {margin_count(all, "contacts"), both("asked")}},
      {"missed contacts", {margin_count(all, "missed"), both("missed")}},
      {"contacts without a verdict",
       {margin_count(all, "without_verdict"), both("declined") + both("invalid") + both("unanswered")}}};
  for (const auto& [what, counts] : pairs) {
    if (std::string fault = disagreement(what, counts.first, counts.second, "its contacts"); !fault.empty())
      return fault;
  }
  if (margin_count(others, "asked") > margin_count(margin, "probed") + margin_count(margin, "found"))
    return "more contacts were probed and found than queries";
  for (const Json& part : margin["decades"]) {
    const std::uint64_t missed = margin_count(part, "missed");
    const std::uint64_t unmended = margin_count(part, "hopeless") + margin_count(part, "unmeasured");
    if (unmended > missed || margin_count(part, "tiny") > missed - unmended || missed > margin_count(part, "contacts"))
      return "a part has more contacts that need something than it missed";
    const bool has_factor = missed > unmended + margin_count(part, "tiny");
    if ((missed > unmended) == part["amount"].is_null() || has_factor == part["factor"].is_null())
      return fmt::format("of {} missed contacts in scenes of 1e{} it does not say what they need", thousands(missed),
                         part["decade"].dump());
  }
  return "";
}

Rational radius_of(const Json& text) {
  const double radius = parse_number<double>(text.get<std::string>());
  if (!std::isfinite(radius)) throw Error(fmt::format("the radius {} is not finite", shown(text.dump())));
  return exact(radius);
}

double value_of(const Json& figure) { return std::strtod(figure.get_ref<const std::string&>().c_str(), nullptr); }

// The greatest of the parts, and what it is of.
std::string fault_of_growth(const Json& margin, const char* way) {
  const Json& greatest = margin[way];
  const Json* most = nullptr;
  for (const Json& part : margin["decades"]) {
    if (!part[way].is_null() && (most == nullptr || value_of(part[way]) > value_of(*most))) most = &part[way];
  }
  if (greatest.is_null() != (most == nullptr) || (most != nullptr && greatest["value"] != *most)) {
    return fmt::format("{}: {}, and its parts say {}", way, greatest.is_null() ? "none" : plain_text(greatest["value"]),
                       most == nullptr ? "none" : plain_text(*most));
  }
  if (greatest.is_null()) return "";
  if (greatest["contact_from"].is_null()) return fmt::format("{}: it does not say from which radius on", way);
  try {
    const Rational from = radius_of(greatest["r"]), to = radius_of(greatest["contact_from"]);
    const bool is_factor = std::string_view(way) == "factor";
    if (sgn(from) < 0 || to <= from || (is_factor && sgn(from) == 0))
      return fmt::format("{}: its radii are not in order", way);
    const std::string computed = round_up(is_factor ? Rational(to / from) : Rational(to - from)).text();
    if (greatest["value"] == computed) return "";
    return fmt::format("{}: {}, and its radii say {}", way, plain_text(greatest["value"]), computed);
  } catch (const Error& wrong) {
    return fmt::format("{}: {}", way, wrong.what());
  }
}

}  // namespace

std::string margin_fault(const Json& margin, const KernelRecord& entry) {
  std::string fault = fault_beside_counts(margin, entry);
  if (fault.empty()) fault = fault_of_sums(margin);
  for (const char* way : {"factor", "amount"}) {
    if (fault.empty()) fault = fault_of_growth(margin, way);
  }
  return fault;
}

}  // namespace axiscert
