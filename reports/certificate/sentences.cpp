#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/diagnosis/diagnosis.h"
#include "fuzz/queries/capabilities.h"
#include "reports/certificate/page.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t shown_of_key = 16;  // digits

}  // namespace

std::string made_sentence(const CertificatePredicate& predicate) {
  const AskedStatement& asked = predicate.asked;
  const std::string how =
      asked.effort == "replies" ? "from a program's replies" : fmt::format("with effort {}", asked.effort);
  return fmt::format("made by axiscert {} {}, seed {}", predicate.materials.axiscert.version, how, asked.seed.value);
}

std::string signer_sentence(const CertificatePredicate& predicate) {
  if (!predicate.signed_by) return "not signed";
  return fmt::format("signed by the key {}", predicate.signed_by->substr(0, shown_of_key));
}

std::string asked_sentence(const CertificatePredicate& predicate) {
  std::vector<std::string_view> precisions;
  for (const Precision precision : predicate.kernel.precisions) precisions.push_back(name(precision));
  return fmt::format("{} queries of {} families and files, in {}", thousands(predicate.asked.queries),
                     predicate.asked.families.size(), fmt::join(precisions, " and "));
}

std::string looked_sentence(const CertificatePredicate& predicate) {
  const LeftOutStatement& out = predicate.asked.left_out;
  std::vector<std::string> parts;
  add_count(parts, out.outside_limits, "outside its limits");
  add_count(parts, out.touching, "touching, of which it promises nothing");
  const auto without_verdict = no_verdict_words({out.declined, out.invalid, out.unanswered});
  parts.insert(parts.end(), without_verdict.begin(), without_verdict.end());
  std::string text = fmt::format("{} looked at; left out: {}", thousands(predicate.asked.looked_at),
                                 parts.empty() ? "nothing" : fmt::format("{}", fmt::join(parts, ", ")));
  if (out.no_query != 0) text += fmt::format("; {} are no query", thousands(out.no_query));
  return text;
}

std::string no_answers_sentence(const CertificatePredicate& predicate) {
  std::vector<std::string_view> precisions;
  for (const ComparisonStatement& row : predicate.comparison) {
    if (row.kernel == predicate.kernel.id && row.looked_at == 0) precisions.push_back(name(row.precision));
  }
  if (precisions.empty() && predicate.asked.looked_at != 0) return "";
  if (precisions.empty()) return "it gave no answer that counts";
  return fmt::format("it gave no answer that counts in {}", fmt::join(precisions, " and "));
}

LevelState state_of_level(const CertificatePredicate& predicate, const std::string& level) {
  LevelState state = LevelState::not_checked;
  bool is_first = true;
  for (const LevelStatement& entry : predicate.levels) {
    if (entry.level != level) continue;
    if (entry.state == LevelState::not_met) return entry.state;
    if (is_first || entry.state == LevelState::not_checked) state = entry.state;
    is_first = false;
  }
  return state;
}

std::string claim_of_level(const CertificatePredicate& predicate, const std::string& level) {
  // Each of two precisions that cover different families is named.
  std::vector<std::pair<std::string, std::string>> claims;  // and their precisions
  for (const LevelStatement& entry : predicate.levels) {
    if (entry.level != level) continue;
    if (claims.empty() || claims.front().first != entry.claim)
      claims.emplace_back(entry.claim, entry.precision ? name(*entry.precision) : "-");
  }
  if (claims.empty()) return level;
  if (claims.size() == 1) return claims.front().first;
  std::string text;
  for (const auto& [claim, precision] : claims)
    text += fmt::format("{}{} in {}", text.empty() ? "" : ", ", claim, precision);
  return text;
}

std::string decided_text(const CertificatePredicate& predicate) {
  const LeftOutStatement& out = predicate.asked.left_out;
  const std::uint64_t decided = predicate.asked.looked_at, declined = out.declined;
  std::string text;
  if (declined != 0) text = fmt::format(" of the {} that it decides", share_rounded_down(decided, decided + declined));
  if (out.touching != 0) text += " but for touching";
  return text;
}

std::vector<const LevelStatement*> first_of_levels(const CertificatePredicate& predicate) {
  std::vector<const LevelStatement*> first;
  for (const LevelStatement& entry : predicate.levels) {
    if (std::ranges::none_of(first, [&](const LevelStatement* known) { return known->level == entry.level; }))
      first.push_back(&entry);
  }
  return first;
}

std::vector<std::string> levels_with(const CertificatePredicate& predicate, LevelState state) {
  std::vector<std::string> claims;
  for (const LevelStatement* entry : first_of_levels(predicate)) {
    if (state_of_level(predicate, entry->level) == state)
      claims.push_back(state == LevelState::met ? claim_of_level(predicate, entry->level) : std::string(entry->level));
  }
  return claims;
}

namespace {

// Values of properties that somebody who uses the kernel has to know, and what to say of them in a word or two. A value
// that is not here is what one expects, is said by the levels, or is not known.
struct Peculiarity {
  std::string_view property, value, says;
};
constexpr Peculiarity peculiarities[] = {
    {"touching", "open", "what only touches is no contact"},
    {"touching", "neither", "what only touches is a contact or not, as it falls"},
    {"sides", "front_only", "one-sided: only from the front"},
    {"sides", "back_only", "one-sided: only from behind"},
    {"overlap_at_start", "moving", "misses an overlap where nothing moves: ask the static predicate there"},
    {"overlap_at_start", "approaching",
     "misses an overlap before the motion unless it approaches: ask the static predicate first"},
    {"overlap_at_start", "ignored", "misses every overlap before the motion: ask the static predicate first"},
    {"degenerate_triangles", "skipped", "triangles without area are never hit"},
    {"degenerate_triangles", "always_hit", "triangles without area are always hit"},
    {"degenerate_triangles", "refused", "triangles without area are refused"},
    {"degenerate_triangles", "wrong_on_some", "wrong on some triangles without area"},
    {"absolute_threshold", "present", "compares with an absolute number, so it depends on the unit of length"},
    {"absolute_threshold", "quaternions", "compares the length of a quaternion with an absolute number"},
    {"slack", "early", "answers as if shapes were larger than they are"},
    {"slack", "late", "answers as if shapes were smaller than they are"},
    {"range_window", "limited", "right only within a range of sizes"},
    {"subnormal_numbers", "flushed", "takes subnormal numbers for zero"},
    {"operation_order", "contracted", "fuses operations"},
    {"inner_precision", "narrower", "computes in floats"},
    {"repeated", "differs", "not deterministic"},
    {"position_in_batch", "depends", "depends on the position in the batch"},
    {"batch_length", "depends", "depends on the length of the batch"},
    {"neighbours", "depends", "depends on the other queries of the batch"},
};

// A property of a kernel in words, where others were said before or not; empty where there is nothing to say.
std::string said_of(const PropertyStatement& property, const KernelStatement& kernel, bool has_others) {
  const std::string& value = property.value;
  if (property.name == "nearest_form" && value != not_known && value != not_asked && kernel.id != value)
    return fmt::format("{}answers as {} does, see {}", has_others ? "otherwise " : "", value,
                       capabilities_of(find_predicate(kernel.question)).section_of_forms);
  for (const Peculiarity& known : peculiarities) {
    if (property.name != known.property || value != known.value) continue;
    // The sentence has the size, without which nobody can tell whether a slack matters.
    if (property.name != "slack") return std::string(known.says);
    std::string sentence = property.sentence;
    if (sentence.ends_with('.')) sentence.pop_back();
    if (sentence.starts_with("It has ")) sentence.erase(0, std::string_view("It has ").size());
    return fmt::format("{}: {}", known.says, sentence);
  }
  return "";
}

// In the order in which they matter. A number of the kernel's own is named once: it limits the range too.
std::vector<const PropertyStatement*> most_important_first(const DiagnosedStatement& part) {
  std::vector<const PropertyStatement*> properties;
  bool has_threshold = false;
  for (const PropertyStatement& property : part.properties) {
    properties.push_back(&property);
    has_threshold |= property.name == "absolute_threshold" && property.value == "present";
  }
  if (has_threshold) std::erase_if(properties, [](const auto* property) { return property->name == "range_window"; });
  const auto rank = [](const PropertyStatement* property) {
    return importance_of(property->name, property->value).value_or(property_kinds().size());
  };
  std::ranges::stable_sort(properties, {}, rank);
  return properties;
}

// Says on how much nothing broke, and what a search found all the same: it asks other queries than the run.
std::string nothing_broke(const CertificatePredicate& predicate) {
  const AskedStatement& asked = predicate.asked;
  const LeftOutStatement& out = asked.left_out;
  std::string text = fmt::format("Nothing was looked at: none of {} queries was decided.", thousands(asked.queries));
  if (asked.looked_at != 0) {
    // No verdict is wrong; a level of numbers may still not be met.
    const std::vector<std::string> failed = levels_with(predicate, LevelState::not_met);
    text = fmt::format("{} on {} decided queries", failed.empty() ? "Nothing broke" : "No verdict is wrong",
                       thousands(asked.looked_at));
    if (!failed.empty())
      text += failed.size() > 3 ? fmt::format("; {} levels are not met", failed.size())
                                : fmt::format("; not met: {}", fmt::join(failed, ", "));
    if (asked.contacts <= out.declined_contacts) text += "; no contact was decided";
    if (asked.separations <= out.declined - out.declined_contacts) text += "; no separation was decided";
    text += ".";
  }
  std::vector<std::string> finds;
  for (const auto& [precision, search] : predicate.search.precisions) {
    for (const auto& [goal, what] : {std::pair("missed_contact", "missed"), {"phantom_contact", "phantom"}}) {
      if (const FindStatement* find = search.find(goal); find && find->depth)
        finds.push_back(fmt::format("a {} contact of depth {} in {}", what, *find->depth, precision));
    }
  }
  if (!finds.empty()) text += fmt::format(" But a search found {}.", fmt::join(finds, ", "));
  return text;
}

}  // namespace

std::string breaks_note(const CertificatePredicate& predicate) {
  if (!predicate.breaks_first) return nothing_broke(predicate);
  const BreakStatement& first = *predicate.breaks_first;
  std::string meaning = first.meaning;
  if (meaning.ends_with('.')) meaning.pop_back();
  if (first.cause == "finding")
    return fmt::format("What breaks first: {}. {} See {}.", meaning, first.advice, first.section);
  // A find of the search, where that is deeper: the run's families do not have it.
  std::string found;
  const std::string in(first.precision ? name(*first.precision) : "-");
  if (const SearchedStatement* search = predicate.search.precisions.find(in)) {
    const FindStatement* find = search->find(first.what == "missed contact" ? "missed_contact" : "phantom_contact");
    if (find && find->depth && number_in(*find->depth) > number_in(first.deepest))
      found = fmt::format(" A search found one of depth {}.", *find->depth);
  }
  // A situation's meaning says what happens there; a cause's does not.
  const bool is_situation =
      std::ranges::any_of(predicate.situations, [&](const auto& s) { return s.situation == first.cause; });
  if (is_situation)
    return fmt::format("What breaks first, in {}: {}.{} {} See {}.", in, meaning, found, first.advice, first.section);
  return fmt::format("What breaks first: {}, {}{}: {}.{} {} See {}.", first.what, first.precision ? in + ", " : "",
                     first.cause, meaning, found, first.advice, first.section);
}

std::string peculiarities_note(const CertificatePredicate& predicate) {
  std::vector<std::string> parts;
  for (const DiagnosedStatement& part : predicate.diagnosis.precisions) {
    std::vector<std::string> said;
    for (const PropertyStatement* property : most_important_first(part)) {
      if (const std::string text = said_of(*property, predicate.kernel, !said.empty()); !text.empty())
        said.push_back(text);
    }
    if (!said.empty()) parts.push_back(fmt::format("in {}, {}", name(part.precision), fmt::join(said, "; ")));
  }
  return parts.empty() ? "" : fmt::format("What it is like: {}.", fmt::join(parts, ". And "));
}

InstrumentTable situations_table(const CertificatePredicate& predicate) {
  InstrumentTable table{"Where it is wrong, and what to do",
                        {"queries", "precision", "missed", "deepest", "phantom", "deepest ",
                         "families, the deepest first", "what to do", "see"},
                        {}};
  // A family of the kernel's predicate without the predicate's name, which is in the heading.
  const std::string prefix = predicate.kernel.question + "/";
  for (const SituationStatement& s : predicate.situations) {
    std::vector<std::string> families(s.families.begin(), s.families.end());
    for (std::string& family : families) {
      if (family.starts_with(prefix)) family.erase(0, prefix.size());
    }
    table.rows.push_back({s.meaning, std::string(name(s.precision)), thousands(s.missed), s.deepest_missed,
                          thousands(s.phantom), s.deepest_phantom, fmt::format("{}", fmt::join(families, ", ")),
                          s.advice, s.section});
  }
  return table;
}

}  // namespace axiscert
