#include "reports/certificate/findings/margin_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "fuzz/certify/safe_margin.h"
#include "fuzz/queries/address.h"
#include "reports/wording/summary.h"

namespace axiscert {
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
  const std::string where = fmt::format("Safe margin in {}, in scenes of 0.001 to 10,000: ", name(margin.precision));
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

}  // namespace axiscert
