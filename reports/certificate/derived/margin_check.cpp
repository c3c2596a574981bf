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

std::string disagreement(const std::string& what, std::uint64_t stated, std::uint64_t counted, const char* whose) {
  return stated == counted ? ""
                           : fmt::format("{}: {}, and {} say {}", what, thousands(stated), whose, thousands(counted));
}

// The counts of the run's stretches.
std::string fault_beside_counts(const MarginStatement& margin, const KernelRecord& entry) {
  const Evidence evidence = evidence_of(entry);
  const auto total = all_families(entry);
  if (!total) return "no query was run in that precision";
  const VerdictTally& verdict = total->verdict;
  const ContactsStatement& contacts = margin.contacts.of_run;
  const std::pair<const char*, std::pair<std::uint64_t, std::uint64_t>> pairs[] = {
      {"promised queries", {margin.queries, evidence.promised()}},
      {"phantom contacts", {margin.phantoms, verdict.false_contact}},
      {"contacts of the run", {contacts.asked, evidence.contacts}},
      {"missed contacts of the run", {contacts.missed, verdict.false_separation}},
      {"declined contacts of the run", {contacts.declined, evidence.declined_contacts}}};
  for (const auto& [what, counts] : pairs) {
    if (std::string fault = disagreement(what, counts.first, counts.second, "its counts"); !fault.empty()) return fault;
  }
  if (contacts.invalid > evidence.invalid || contacts.unanswered > evidence.unanswered)
    return "it has more contacts without an answer than its counts have queries";
  return "";
}

std::string fault_of_sums(const MarginStatement& margin) {
  const MarginPartStatement& all = margin.all;
  std::string fault;
  for_each_field<MarginPartStatement>([&](const auto& field) {
    if constexpr (std::is_same_v<std::remove_cvref_t<decltype(value_of(all, field))>, std::uint64_t>) {
      std::uint64_t sum = 0;
      for (const MarginPartStatement& part : margin.decades) sum += value_of(part, field);
      if (fault.empty()) fault = disagreement(std::string(field.name), value_of(all, field), sum, "its parts");
    }
  });
  if (!fault.empty()) return fault;
  if ((all.hopeless == 0) != !margin.hopeless) return "hopeless: it is counted, and none is shown";
  const auto& [run, others] = margin.contacts;
  const std::pair<const char*, std::pair<std::uint64_t, std::uint64_t>> pairs[] = {
      {"queries", {all.queries, margin.queries}},
      {"contacts", {all.contacts, run.asked + others.asked}},
      {"missed contacts", {all.missed, run.missed + others.missed}},
      {"contacts without a verdict",
       {all.without_verdict,
        run.declined + others.declined + run.invalid + others.invalid + run.unanswered + others.unanswered}}};
  for (const auto& [what, counts] : pairs) {
    if (std::string fault = disagreement(what, counts.first, counts.second, "its contacts"); !fault.empty())
      return fault;
  }
  if (others.asked > margin.probed + margin.found) return "more contacts were probed and found than queries";
  for (const MarginDecadeStatement& part : margin.decades) {
    const std::uint64_t missed = part.missed;
    const std::uint64_t unmended = part.hopeless + part.unmeasured;
    if (unmended > missed || part.tiny > missed - unmended || missed > part.contacts)
      return "a part has more contacts that need something than it missed";
    const bool has_factor = missed > unmended + part.tiny;
    if ((missed > unmended) != part.amount.has_value() || has_factor != part.factor.has_value())
      return fmt::format("of {} missed contacts in scenes of 1e{} it does not say what they need", thousands(missed),
                         part.decade);
  }
  return "";
}

Rational radius_of(const std::string& text) {
  const double radius = parse_number<double>(text);
  if (!std::isfinite(radius)) throw Error(fmt::format("the radius {} is not finite", shown(Json(text).dump())));
  return exact(radius);
}

// The greatest of the parts, and what it is of.
std::string fault_of_growth(const MarginStatement& margin, std::string_view way,
                            std::optional<MissedStatement> MarginStatement::*whole,
                            std::optional<TextNumber> MarginPartStatement::*of_part) {
  const std::optional<MissedStatement>& greatest = margin.*whole;
  const TextNumber* most = nullptr;
  for (const MarginDecadeStatement& part : margin.decades) {
    const std::optional<TextNumber>& here = part.*of_part;
    if (here && (most == nullptr || number_in(*here) > number_in(*most))) most = &*here;
  }
  if (greatest.has_value() != (most != nullptr) || (most != nullptr && greatest->value != *most)) {
    return fmt::format("{}: {}, and its parts say {}", way, greatest ? std::string(greatest->value) : "none",
                       most == nullptr ? "none" : std::string(*most));
  }
  if (!greatest) return "";
  if (!greatest->contact_from) return fmt::format("{}: it does not say from which radius on", way);
  try {
    const Rational from = radius_of(greatest->r), to = radius_of(*greatest->contact_from);
    const bool is_factor = way == "factor";
    if (sgn(from) < 0 || to <= from || (is_factor && sgn(from) == 0))
      return fmt::format("{}: its radii are not in order", way);
    const std::string computed = round_up(is_factor ? Rational(to / from) : Rational(to - from)).text();
    if (greatest->value == computed) return "";
    return fmt::format("{}: {}, and its radii say {}", way, greatest->value, computed);
  } catch (const Error& wrong) {
    return fmt::format("{}: {}", way, wrong.what());
  }
}

}  // namespace

std::string margin_fault(const MarginStatement& margin, const KernelRecord& entry) {
  std::string fault = fault_beside_counts(margin, entry);
  if (fault.empty()) fault = fault_of_sums(margin);
  if (fault.empty()) fault = fault_of_growth(margin, "factor", &MarginStatement::factor, &MarginPartStatement::factor);
  if (fault.empty()) fault = fault_of_growth(margin, "amount", &MarginStatement::amount, &MarginPartStatement::amount);
  return fault;
}

}  // namespace axiscert
