#include "reports/comparison/shown.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/comparison/cells.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::string_view numbers[] = {"time", "separation", "feature", "normal", "point", "point_a", "point_b"};

void tell_numbers(const ContactTally& contacts, const auto& tell) {
  const auto tell_part = [&](std::string_view name, const auto& part) {
    if (part) tell(name, part->judged);
  };
  if (contacts.time) tell("time", contacts.answers);
  tell_part("separation", contacts.separation);
  tell_part("feature", contacts.feature);
  tell_part("normal", contacts.normal);
  tell_part("point", contacts.point);
  tell_part("point_a", contacts.point_a);
  tell_part("point_b", contacts.point_b);
}

const Shown* find_shown(const std::vector<Shown>& all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Shown::name);
  return found == all.end() ? nullptr : &*found;
}

}  // namespace

std::vector<Shown> shown_in(const FamilyRecord& result) {
  std::vector<Shown> all;
  if (!result.contacts) return all;
  tell_numbers(*result.contacts, [&](std::string_view name, std::uint64_t answers) {
    all.push_back({std::string(name), answers});
  });
  return all;
}

std::vector<Shown> shown_in(const KernelRecord& entry) {
  std::vector<Shown> all;
  for (const Exposure shown : entry.exposes) {
    if (shown != Exposure::verdict) all.push_back({std::string(name(shown))});
  }
  for (const auto& [family, result] : entry.families) {
    for (const Shown& number : shown_in(result)) {
      const auto known = std::ranges::find(all, number.name, &Shown::name);
      if (known == all.end()) all.push_back(number);
      else *known->answers += *number.answers;
    }
  }
  return all;
}

std::vector<std::string> shown_names(const Predicate& predicate) {
  std::vector<std::string> names;
  for (const Exposure shown : enumerators<Exposure>) {
    if (shown != Exposure::verdict) names.emplace_back(name(shown));
  }
  const ContactTally given = given_contacts({}, predicate, predicate.measures.size());
  if (!predicate.measures.empty())
    tell_numbers(given, [&](std::string_view name, std::uint64_t) { names.emplace_back(name); });
  return names;
}

bool is_shown_number(std::string_view name) { return std::ranges::find(numbers, name) != std::end(numbers); }

std::string_view shown_of_place(std::string_view place) {
  if (place == "pushed") return "normal";
  if (place == "points") return "point_a";
  if (place == "consistency") return "separation";
  const bool is_itself = place == "verdict" || place == "finding" || is_place_of_contacts(place);
  return is_itself ? place : "comparisons";
}

std::uint64_t changed_verdicts(const VerdictTally& before, const VerdictTally& now) {
  std::uint64_t changed = 0;
  for (std::uint64_t VerdictTally::*const count :
       {&VerdictTally::false_separation, &VerdictTally::false_contact, &VerdictTally::undecided, &VerdictTally::invalid,
        &VerdictTally::unanswered}) {
    changed += std::max(before.*count, now.*count) - std::min(before.*count, now.*count);
  }
  return changed;
}

std::vector<Hidden> hidden_since(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                 std::uint64_t changed) {
  std::vector<Hidden> hidden;
  for (const Shown& then : before) {
    const Shown* const here = find_shown(now, then.name);
    if (here == nullptr) {
      hidden.push_back({then.name, fmt::format("no {} any more", then.name), true});
    } else if (then.answers && here->answers && *then.answers > *here->answers + changed) {
      hidden.push_back({then.name,
                        fmt::format("{} beside {} answers, {} before", then.name, thousands(*here->answers),
                                    thousands(*then.answers)),
                        false});
    }
  }
  return hidden;
}

}  // namespace axiscert
