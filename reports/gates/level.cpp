#include "reports/gates/level.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <fnmatch.h>

#include <algorithm>
#include <charconv>

#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
std::string Failure::text() const {
  const std::string shown_by = witness.empty() ? "" : fmt::format(" (witness {})", witness);
  if (family.empty()) return fmt::format("{}: {}", kernel, what);
  return fmt::format("{} {} on {}: {}: {}{}", kernel, precision, family, what, count, shown_by);
}

std::string list_of(const std::vector<std::string>& families) {
  return families.size() > 4 ? fmt::format("{} families", families.size())
                             : fmt::format("{}", fmt::join(families, ", "));
}

Subject::Basis Subject::basis() const {
  if (!kernel_.reference) return Basis::verdicts;
  return *kernel_.reference ? Basis::reference : Basis::formulae;
}

FamilyLook Subject::whole_look(const FamilyRecord& result) const {
  const Evidence found = evidence(result);
  return {found.population, found.decided()};
}

Failure Subject::failure(const std::string& family, std::uint64_t count, const std::string& what) const {
  return {kernel_.id, std::string(name(kernel_.precision)), family, count, what, ""};
}

bool Subject::is_of(const WitnessRecord& witness, const std::string& family) const {
  return witness.family == family && witness.kernel == kernel_.id && witness.precision == kernel_.precision;
}

void Subject::add(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                  const std::string& what, const Shows& shows, bool touching_counts) const {
  if (count == 0) return;
  const WitnessRecord* deepest = nullptr;
  for (const WitnessRecord& witness : record_.witnesses) {
    if (!is_of(witness, family) || !witness.depth || (witness.touching && !touching_counts)) continue;
    const bool is_shown = std::ranges::any_of(
        witness.flips, [&](const FlipRecord& flip) { return flip.level == Level::verdict && shows(flip); });
    if (is_shown && (deepest == nullptr || *witness.depth > *deepest->depth)) deepest = &witness;
  }
  failures.push_back(failure(family, count, what));
  if (deepest != nullptr) failures.back().witness = deepest->id;
}

void Subject::add_shown(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                        const std::string& what, std::string_view reason) const {
  if (count == 0) return;
  failures.push_back(failure(family, count, what));
  const auto shows = [&](const WitnessRecord& witness) {
    return is_of(witness, family) &&
           std::ranges::any_of(witness.shows, [&](const std::string& text) { return text.starts_with(reason); });
  };
  if (const auto found = std::ranges::find_if(record_.witnesses, shows); found != record_.witnesses.end())
    failures.back().witness = found->id;
}

void Subject::add_untimed(std::vector<Failure>& failures) const {
  for (const auto& [family, result] : families()) {
    if (!result.contacts || !result.contacts->time) continue;
    const TimeTally& time = *result.contacts->time;
    add_shown(failures, family, time.none, "contacts without a time", "a contact without a time");
    add_shown(failures, family, time.invalid, "contacts with a time outside [0, 1]", "a time outside [0, 1]");
  }
}

void Subject::add_pair(std::vector<Failure>& failures, const std::string& family, std::uint64_t count,
                       const std::string& what, const std::optional<AddressPair>& pair) const {
  if (count == 0) return;
  Failure failed = failure(family, count, what);
  if (pair) {
    failed.what += "; first on " + pair->image + " beside " + pair->base;
    for (const WitnessRecord& witness : record_.witnesses) {
      if (witness.address == pair->image && witness.kernel == kernel_.id) failed.witness = witness.id;
    }
  }
  failures.push_back(std::move(failed));
}

void Subject::add_link(std::vector<Failure>& failures, const std::string& family, Link link,
                       std::uint64_t count) const {
  const bool in_exact_arithmetic = link == Link::unattributed;
  add(
      failures, family, count,
      in_exact_arithmetic
          ? "wrong verdicts in exact arithmetic that its formulae do not give, touching ones not counted"
          : fmt::format("wrong verdicts with a broken {} link", name(link)),
      [link](const FlipRecord& flip) { return std::ranges::find(flip.links, link) != flip.links.end(); },
      !in_exact_arithmetic);
}

FamilyLook Subject::pairs_look(const FamilyRecord& result, std::uint64_t compared, std::uint64_t declined) const {
  return {compared + declined + evidence(result).outside, compared, declined};
}

std::uint64_t Subject::wrong_verdicts() const {
  std::uint64_t wrong = 0;
  for (const auto& [family, result] : families())
    wrong += result.verdict.false_separation + result.verdict.false_contact;
  return wrong;
}

std::uint64_t Subject::decided() const { return evidence_of(kernel_).decided(); }

std::string Subject::list_of_families() const {
  std::vector<std::string> names;
  for (const auto& [family, result] : families()) names.push_back(family);
  return list_of(names);
}

}  // namespace axiscert

// The levels that exist, one line each: X(NAME) is `NAME_level`, which a file of its own defines.
#define AXISCERT_GATE_LEVELS(X) \
  X(logic)                      \
  X(range)                      \
  X(exact)                      \
  X(conservative)               \
  X(depth)                      \
  X(decided)                    \
  X(no_worse_than)              \
  X(invariant)                  \
  X(never_late)                 \
  X(no_tunnel)                  \
  X(early)                      \
  X(separation)                 \
  X(feature)                    \
  X(normal)                     \
  X(unit)                       \
  X(no_flip)                    \
  X(left)                       \
  X(point)                      \
  X(follows)                    \
  X(keeps_margin)               \
  X(no_slack)

namespace axiscert {

#define AXISCERT_DECLARE_LEVEL(name) extern const GateLevel name##_level;
AXISCERT_GATE_LEVELS(AXISCERT_DECLARE_LEVEL)
#undef AXISCERT_DECLARE_LEVEL

std::span<const GateLevel* const> gate_levels() {
#define AXISCERT_POINT_LEVEL(name) &name##_level,
  static const GateLevel* const all[] = {AXISCERT_GATE_LEVELS(AXISCERT_POINT_LEVEL)};
#undef AXISCERT_POINT_LEVEL
  return all;
}

std::vector<const GateLevel*> badge_levels() {
  std::vector<const GateLevel*> levels(gate_levels().begin(), gate_levels().end());
  std::erase_if(levels, [](const GateLevel* level) { return !level->badge; });
  std::ranges::sort(levels, {}, [](const GateLevel* level) { return level->badge->rank; });
  return levels;
}

std::string_view GateLevel::name() const {
  const std::string_view text = usage;
  return text.substr(0, text.find_first_of("[="));
}

bool AskedLevel::is_about(const std::string& family) const {
  return families.empty() || std::ranges::any_of(families, [&](const std::string& pattern) {
           return fnmatch(pattern.c_str(), family.c_str(), 0) == 0;
         });
}

std::string SizeLimit::text(std::string_view unit) const {
  return is_length ? metric_text(most) : fmt::format("{} {}", most, unit);
}

double number_argument(const AskedLevel& asked, const NumberBound& bound) {
  double number = 0;
  const char* const end = asked.argument.data() + asked.argument.size();
  const auto [stop, problem] = std::from_chars(asked.argument.data(), end, number);
  const bool is_too_fine = bound.has_six_digits && fmt::format("{:.6g}", number) != fmt::format("{}", number);
  if (problem == std::errc() && stop == end && number >= bound.least && number <= bound.most && !is_too_fine)
    return number;
  throw Error(fmt::format("requirement '{}': {} is {}, as in {}={}", asked.text, bound.letter, bound.what, asked.name,
                          bound.example));
}

SizeLimit size_limit(const AskedLevel& asked, const NumberBound& bound) {
  if (const auto length = length_in_metres(asked.argument)) return {*length, true};
  return {number_argument(asked, bound)};
}

SizeLimit depth_argument(const AskedLevel& asked) {
  static const std::string what = fmt::format(
      "a depth, a share of the scene from 0 on such as 0.001, or a length in {}", fmt::join(length_unit_names(), ", "));
  return size_limit(asked, {"D", what.c_str(), "1mm", 0, any_depth});
}

}  // namespace axiscert
