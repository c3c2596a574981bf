#include "reports/certificate/margin.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "exact/numbers/rational.h"
#include "fuzz/instruments/safe_margin.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::optional<MissedStatement> missed_statement(const std::optional<MissedContact>& missed) {
  if (!missed) return std::nullopt;
  MissedStatement said{
      missed->value.text(), missed->radius, std::nullopt, missed->family, {Json::parse(missed->query)}};
  if (!missed->critical.empty()) said.contact_from = missed->critical;
  return said;
}

MarginPartStatement part_statement(const MarginPart& part) {
  const auto value = [](const std::optional<MissedContact>& greatest) -> std::optional<TextNumber> {
    if (!greatest) return std::nullopt;
    return greatest->value.text();
  };
  return {part.queries,
          part.contacts,
          part.without_verdict,
          part.missed,
          part.hopeless,
          part.tiny,
          part.unmeasured,
          value(part.factor),
          value(part.amount),
          part.phantoms_by_factor,
          part.phantoms_by_amount,
          part.still_missed_by_factor,
          part.still_missed_by_amount};
}

ContactsStatement contacts_statement(const ContactAnswers& answers) {
  return {answers.asked(), answers.missed, answers.looked_at.undecided, answers.looked_at.invalid,
          answers.looked_at.unanswered};
}

}  // namespace

MarginStatement margin_statement(const SafeMargin& margin) {
  MarginStatement said{margin.precision,
                       margin.queries,
                       margin.probed,
                       margin.found,
                       margin.phantoms,
                       {contacts_statement(margin.of_run), contacts_statement(margin.of_others)},
                       missed_statement(margin.factor),
                       missed_statement(margin.amount),
                       missed_statement(margin.hopeless),
                       part_statement(margin.total()),
                       {}};
  for (const auto& [scene, part] : margin.parts)
    said.decades.push_back({part_statement(part), scene.is_degenerate, scene.decade});
  return said;
}

namespace {

std::string text_of(const std::optional<TextNumber>& figure) { return figure ? *figure : "-"; }

// Scales that scenes have in metres, from a millimetre to ten kilometres.
bool is_everyday(const MarginDecadeStatement& part) { return part.decade >= -3 && part.decade <= 3; }

constexpr int least_measured_decade = -307, greatest_measured_decade = 307;

// An amount relative to the least size of its scenes, rounded up: three digits are half a percent off at most. Empty
// where there is none, or where the size is 0 or its power of ten no double: nothing is said by it there.
std::string share_text(double share) { return share > 0 ? axiscert::amount(share * 1.006, 3) : ""; }
double share_of(const MarginDecadeStatement& part) {
  if (!part.amount || part.decade < least_measured_decade || part.decade > greatest_measured_decade) return 0;
  return number_in(*part.amount) / std::pow(10.0, part.decade);
}

// The parts of one kind added up. Amounts of scenes of different sizes are compared as shares of the size: one that
// mends a scene of a kilometre says nothing of one of a metre.
struct Growth {
  std::uint64_t queries = 0, contacts = 0, without_verdict = 0, missed = 0, hopeless = 0, tiny = 0, by_factor = 0,
                by_amount = 0;
  double factor = 0, share = 0;  // the greatest; share: of an amount in the least size of its scenes
  std::string factor_text;

  void add(const MarginDecadeStatement& part) {
    queries += part.queries;
    contacts += part.contacts;
    without_verdict += part.without_verdict;
    missed += part.missed;
    hopeless += part.hopeless;
    tiny += part.tiny;
    by_factor += part.phantoms_by_factor;
    by_amount += part.phantoms_by_amount;
    if (part.factor && number_in(*part.factor) > factor) {
      factor = number_in(*part.factor);
      factor_text = *part.factor;
    }
    share = std::max(share, share_of(part));
  }
  bool mends() const { return !factor_text.empty() || share > 0; }
  // "r times 1.5, or r plus 0.3 of the scene's size, mends"; each may be absent.
  std::string text() const {
    std::string ways;
    const auto add_way = [&](const std::string& way) { ways += (ways.empty() ? "" : ", or ") + way; };
    if (!factor_text.empty()) add_way("r times " + factor_text);
    if (share > 0) add_way(fmt::format("r plus {} of the scene's size", share_text(share)));
    return ways + (ways.find(", ") == ways.npos ? " mends" : ", mends");
  }
};

template <class IsOf>
Growth growth_of(const MarginStatement& margin, IsOf is_of) {
  Growth growth;
  for (const MarginDecadeStatement& part : margin.decades)
    if (is_of(part)) growth.add(part);
  return growth;
}

std::string phantoms_text(const Growth& growth) {
  return fmt::format(
      "; of {} such queries that makes {} new phantom contacts by each size's own factor, {} by its own "
      "amount",
      thousands(growth.queries), thousands(growth.by_factor), thousands(growth.by_amount));
}

// The amount for scenes of about 1, as those in metres are.
std::string at_unit_text(const MarginStatement& margin) {
  for (const MarginDecadeStatement& part : margin.decades) {
    if (part.decade == 0 && !part.degenerate && part.amount) return "; in scenes of 1 to 10 r plus " + *part.amount;
  }
  return "";
}

// Whether a margin can be said to be known: the kernel gave a verdict to every contact, and there were some.
bool is_known(const Growth& here) { return here.contacts != 0 && here.without_verdict == 0; }

// Why no margin is known where no contact was missed.
std::string unknown_text(const Growth& here, const std::string& among) {
  if (here.contacts == 0) return fmt::format("not known: no contact was asked about{}.", among);
  if (here.without_verdict == here.contacts)
    return fmt::format("not known: it answered none of {} contacts{}.", thousands(here.contacts), among);
  return fmt::format("not known: it gave no verdict to {} of {} contacts{}, and missed none of the others.",
                     thousands(here.without_verdict), thousands(here.contacts), among);
}

std::string everyday_note(const MarginStatement& margin) {
  const Growth here = growth_of(margin, [](const auto& part) { return is_everyday(part) && !part.degenerate; });
  const std::string where =
      fmt::format("Safe margin in {}, in scenes of 0.001 to 10,000 units: ", name(margin.precision));
  if (here.missed == 0) {
    const std::string among = " on triangles that are not degenerate";
    if (!is_known(here)) return where + unknown_text(here, among);
    return fmt::format("{}none is needed{}: it missed none of {} contacts.", where, among, thousands(here.contacts));
  }
  if (!here.mends())
    return fmt::format("{}no growth of r mends the {} contacts that were missed.", where, thousands(here.missed));
  const std::string beyond = here.hopeless == 0 ? ""
                                                : fmt::format(", but for {} of {} that no radius mends",
                                                              thousands(here.hopeless), thousands(here.missed));
  return fmt::format("{}{} every contact that was missed on a triangle that is not degenerate{}{}{}.", where,
                     here.text(), beyond, at_unit_text(margin), phantoms_text(here));
}

std::string degenerate_note(const MarginStatement& margin) {
  const Growth here = growth_of(margin, [](const auto& part) { return is_everyday(part) && part.degenerate; });
  if (here.missed == 0 || !here.mends()) return "";
  const std::uint64_t mended = here.missed - here.hopeless;
  return fmt::format(
      "On degenerate triangles there (without area, or a height below 1/1024 of the longest edge, or lengths beyond "
      "those of degree 6) {} {}{}: such triangles are better mended when the mesh is read.",
      here.text(), mended == 1 ? "1 missed contact" : thousands(mended) + " missed contacts", phantoms_text(here));
}

std::string counts_note(const MarginStatement& margin) {
  const MarginPartStatement& all = margin.all;
  std::string text = fmt::format("Over all scales in {}, degenerate or not: ", name(margin.precision));
  const Growth everything = growth_of(margin, [](const auto&) { return true; });
  text += everything.mends() ? fmt::format("{} every missed contact that a radius mends", everything.text())
                             : "no growth of r mends a missed contact";
  text += fmt::format("; {} contacts were missed, and {} phantom on {} queries", thousands(all.missed),
                      thousands(margin.phantoms), thousands(margin.queries));
  if (all.without_verdict != 0)
    text += fmt::format("; to {} of {} contacts it gave no verdict, and what they need is not known",
                        thousands(all.without_verdict), thousands(all.contacts));
  if (all.hopeless != 0)
    text += fmt::format("; {} are missed even by a sphere that holds the whole triangle, and no margin mends that",
                        thousands(all.hopeless));
  if (all.tiny != 0) {
    const int exponent = tiny_radius_exponent[margin.precision];
    text += fmt::format(
        "; {} with r = 0 or below 2^-{} of the scene's size have an amount and no factor, which would only say how "
        "small r is",
        thousands(all.tiny), exponent);
  }
  if (all.unmeasured != 0)
    text += fmt::format("; of {} the kernel gave no radius that it answers at", thousands(all.unmeasured));
  return text + ".";
}

}  // namespace

std::vector<std::string> margin_notes(const MarginStatement& margin) {
  if (margin.all.missed == 0) {
    const Growth all = growth_of(margin, [](const auto&) { return true; });
    const std::string where = fmt::format("Safe margin in {}: ", name(margin.precision));
    if (!is_known(all)) return {where + unknown_text(all, "")};
    return {fmt::format(
        "{}none is needed: it missed none of {} contacts, of {} queries, {} probes at the least radius and {} "
        "finds of a search.",
        where, thousands(all.contacts), thousands(margin.queries), thousands(margin.probed), thousands(margin.found))};
  }
  std::vector<std::string> notes = {everyday_note(margin)};
  if (std::string note = degenerate_note(margin); !note.empty()) notes.push_back(std::move(note));
  notes.push_back(counts_note(margin));
  return notes;
}

InstrumentTable margin_table(const SafeMarginStatement& safe_margin) {
  InstrumentTable table{
      "Safe margin by the size of the scene: what r has to be multiplied by, or grow by, and new phantom contacts",
      {"precision", "triangles", "size from", "queries", "missed", "past mending", "tiny r", "factor", "amount",
       "amount by size", "phantoms by the factor", "phantoms by the amount"},
      {}};
  for (const MarginStatement& margin : safe_margin.precisions) {
    for (const MarginDecadeStatement& part : margin.decades) {
      if (part.missed == 0) continue;
      table.rows.push_back({std::string(name(margin.precision)), part.degenerate ? "degenerate" : "others",
                            part.decade < -399 ? "0" : fmt::format("1e{}", part.decade), thousands(part.queries),
                            thousands(part.missed), thousands(part.hopeless), thousands(part.tiny),
                            text_of(part.factor), is_everyday(part) ? text_of(part.amount) : "-",
                            share_of(part) > 0 ? share_text(share_of(part)) : "-", thousands(part.phantoms_by_factor),
                            thousands(part.phantoms_by_amount)});
    }
  }
  return table;
}

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
