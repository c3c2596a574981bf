#include "reports/certificate/findings/margin_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "fuzz/certify/safe_margin.h"
#include "fuzz/queries/address.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

std::string count_of(const Json& part, const char* member) { return thousands(part[member].get<std::uint64_t>()); }
std::string figure_text(const Json& figure) { return figure.is_null() ? "-" : figure.get<std::string>(); }
double figure_value(const Json& figure) { return std::strtod(figure.get_ref<const std::string&>().c_str(), nullptr); }

// Scales that scenes have in metres, from a millimetre to ten kilometres.
bool is_everyday(const Json& part) { return part["decade"] >= -3 && part["decade"] <= 3; }

constexpr int least_measured_decade = -307, greatest_measured_decade = 307;

// An amount relative to the least size of its scenes, rounded up: three digits are half a percent off at most. Empty
// where there is none, or where the size is 0 or its power of ten no double: nothing is said by it there.
std::string share_text(double share) { return share > 0 ? axiscert::amount(share * 1.006, 3) : ""; }
double share_of(const Json& part) {
  const int decade = part["decade"];
  if (part["amount"].is_null() || decade < least_measured_decade || decade > greatest_measured_decade) return 0;
  return figure_value(part["amount"]) / std::pow(10.0, decade);
}

// The parts of one kind added up. Amounts of scenes of different sizes are compared as shares of the size: one that
// mends a scene of a kilometre says nothing of one of a metre.
struct Growth {
  std::uint64_t queries = 0, contacts = 0, without_verdict = 0, missed = 0, hopeless = 0, tiny = 0, by_factor = 0,
                by_amount = 0;
  double factor = 0, share = 0;  // the greatest; share: of an amount in the least size of its scenes
  std::string factor_text;

  void add(const Json& part) {
    const auto plus = [&](std::uint64_t& sum, const char* member) { sum += part[member].get<std::uint64_t>(); };
    plus(queries, "queries");
    plus(contacts, "contacts");
    plus(without_verdict, "without_verdict");
    plus(missed, "missed");
    plus(hopeless, "hopeless");
    plus(tiny, "tiny");
    plus(by_factor, "phantoms_by_factor");
    plus(by_amount, "phantoms_by_amount");
    if (!part["factor"].is_null() && figure_value(part["factor"]) > factor) {
      factor = figure_value(part["factor"]);
      factor_text = part["factor"];
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
Growth growth_of(const Json& margin, IsOf is_of) {
  Growth growth;
  for (const Json& part : margin["decades"])
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
std::string at_unit_text(const Json& margin) {
  for (const Json& part : margin["decades"]) {
    if (part["decade"] == 0 && !part["degenerate"].get<bool>() && !part["amount"].is_null())
      return "; in scenes of 1 to 10 r plus " + part["amount"].get<std::string>();
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

std::string everyday_note(const Json& margin) {
  const Growth here =
      growth_of(margin, [](const Json& part) { return is_everyday(part) && !part["degenerate"].get<bool>(); });
  const std::string where =
      fmt::format("Safe margin in {}, in scenes of 0.001 to 10,000: ", margin["precision"].get<std::string>());
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

std::string degenerate_note(const Json& margin) {
  const Growth here =
      growth_of(margin, [](const Json& part) { return is_everyday(part) && part["degenerate"].get<bool>(); });
  if (here.missed == 0 || !here.mends()) return "";
  const std::uint64_t mended = here.missed - here.hopeless;
  return fmt::format(
      "On degenerate triangles there (without area, or a height below 1/1024 of the longest edge, or lengths beyond "
      "those of degree 6) {} {}{}: such triangles are better mended when the mesh is read.",
      here.text(), mended == 1 ? "1 missed contact" : thousands(mended) + " missed contacts", phantoms_text(here));
}

std::string counts_note(const Json& margin) {
  const Json& all = margin["all"];
  std::string text = fmt::format("Over all scales in {}, degenerate or not: ", margin["precision"].get<std::string>());
  const Growth everything = growth_of(margin, [](const Json&) { return true; });
  text += everything.mends() ? fmt::format("{} every missed contact that a radius mends", everything.text())
                             : "no growth of r mends a missed contact";
  text += fmt::format("; {} contacts were missed, and {} phantom on {} queries", count_of(all, "missed"),
                      thousands(margin["phantoms"].get<std::uint64_t>()),
                      thousands(margin["queries"].get<std::uint64_t>()));
  if (all["without_verdict"] != 0)
    text += fmt::format("; to {} of {} contacts it gave no verdict, and what they need is not known",
                        count_of(all, "without_verdict"), count_of(all, "contacts"));
  if (all["hopeless"] != 0)
    text += fmt::format("; {} are missed even by a sphere that holds the whole triangle, and no margin mends that",
                        count_of(all, "hopeless"));
  if (all["tiny"] != 0) {
    const int exponent = tiny_radius_exponent[parse_precision(margin["precision"].get<std::string>())];
    text += fmt::format(
        "; {} with r = 0 or below 2^-{} of the scene's size have an amount and no factor, which would only say how "
        "small r is",
        count_of(all, "tiny"), exponent);
  }
  if (all["unmeasured"] != 0)
    text += fmt::format("; of {} the kernel gave no radius that it answers at", count_of(all, "unmeasured"));
  return text + ".";
}

}  // namespace

std::vector<std::string> margin_notes(const Json& margin) {
  if (margin["all"]["missed"] == 0) {
    const Growth all = growth_of(margin, [](const Json&) { return true; });
    const std::string where = fmt::format("Safe margin in {}: ", margin["precision"].get<std::string>());
    if (!is_known(all)) return {where + unknown_text(all, "")};
    return {fmt::format(
        "{}none is needed: it missed none of {} contacts, of {} queries, {} probes at the least radius and {} "
        "finds of a search.",
        where, thousands(all.contacts), count_of(margin, "queries"), count_of(margin, "probed"),
        count_of(margin, "found"))};
  }
  std::vector<std::string> notes = {everyday_note(margin)};
  if (std::string note = degenerate_note(margin); !note.empty()) notes.push_back(std::move(note));
  notes.push_back(counts_note(margin));
  return notes;
}

InstrumentTable margin_table(const Json& safe_margin) {
  InstrumentTable table{
      "Safe margin by the size of the scene: what r has to be multiplied by, or grow by, and new phantom contacts",
      {"precision", "triangles", "size from", "queries", "missed", "past mending", "tiny r", "factor", "amount",
       "amount by size", "phantoms by the factor", "phantoms by the amount"},
      {}};
  for (const Json& margin : safe_margin["precisions"]) {
    for (const Json& part : margin["decades"]) {
      if (part["missed"] == 0) continue;
      const int decade = part["decade"];
      table.rows.push_back(
          {margin["precision"].get<std::string>(), part["degenerate"].get<bool>() ? "degenerate" : "others",
           decade < -399 ? "0" : fmt::format("1e{}", decade), count_of(part, "queries"), count_of(part, "missed"),
           count_of(part, "hopeless"), count_of(part, "tiny"), figure_text(part["factor"]),
           is_everyday(part) ? figure_text(part["amount"]) : "-", share_of(part) > 0 ? share_text(share_of(part)) : "-",
           count_of(part, "phantoms_by_factor"), count_of(part, "phantoms_by_amount")});
    }
  }
  return table;
}

}  // namespace axiscert
