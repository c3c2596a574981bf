#include "reports/comparison/shown.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/comparison/cells.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::string_view numbers[] = {"time", "separation", "feature", "normal", "point", "point_a", "point_b"};
constexpr std::string_view said[] = {"contacts", "answers `separated`"};

void tell_numbers(const ContactTally& contacts, const auto& tell) {
  const auto tell_part = [&](std::string_view name, const auto& part) {
    if (part) tell(name, part->given);
  };
  tell_part("time", contacts.time);
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

// Whether answers that had a number have it no more, as far as it can be told.
bool is_hidden(const GivenBeside& then, const GivenBeside& now, bool are_same_queries) {
  if (then.given == 0 || now.is_all()) return false;
  if (are_same_queries) return then.which != now.which;
  const bool are_many = std::min(then.answers, now.answers) >= least_looked_at;
  return are_many && then.is_all() && 2 * now.given < now.answers;
}

}  // namespace

std::vector<Shown> shown_in(const FamilyRecord& result) {
  std::vector<Shown> all;
  if (!result.contacts) return all;
  const std::uint64_t separations = result.contacts->separations, contacts = result.contacts->answers - separations;
  tell_numbers(*result.contacts, [&](std::string_view name, const GivenTally& given) {
    const auto mark = [](const AnswerSet& set) { return fmt::format("{:x}", set.mark); };
    all.push_back(
        {std::string(name),
         {{GivenBeside{contacts, given.contacts, given.contacts == 0 ? "" : mark(given.which_contacts)},
           GivenBeside{separations, given.separations, given.separations == 0 ? "" : mark(given.which_separations)}}}});
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
      auto known = std::ranges::find(all, number.name, &Shown::name);
      if (known == all.end()) known = all.insert(all.end(), {number.name, {{}}});
      for (std::size_t side = 0; side < std::size(said); ++side) {
        const GivenBeside& here = (*number.beside)[side];
        GivenBeside& sum = (*known->beside)[side];
        sum.answers += here.answers;
        sum.given += here.given;
        if (here.given != 0) sum.which += fmt::format("{}:{};", family, here.which);
      }
    }
  }
  for (Shown& number : all) {
    if (!number.beside) continue;
    for (GivenBeside& side : *number.beside) side.which = side.given == 0 ? "" : short_sha256(side.which);
  }
  return all;
}

std::vector<std::string> shown_names(const Predicate& predicate) {
  std::vector<std::string> names;
  for (const Exposure shown : enumerators<Exposure>) {
    if (shown != Exposure::verdict) names.emplace_back(name(shown));
  }
  if (predicate.measures.empty()) return names;
  tell_numbers(given_contacts({}, predicate, predicate.measures.size()),
               [&](std::string_view name, const GivenTally&) { names.emplace_back(name); });
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

std::vector<Hidden> hidden_since(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                 bool are_same_queries) {
  std::vector<Hidden> hidden;
  for (const Shown& then : before) {
    const Shown* const here = find_shown(now, then.name);
    if (here == nullptr || then.beside.has_value() != here->beside.has_value()) {
      hidden.push_back({then.name, fmt::format("no {} any more", then.name), true});
      continue;
    }
    for (std::size_t side = 0; then.beside && side < std::size(said); ++side) {
      const GivenBeside &old = (*then.beside)[side], &fresh = (*here->beside)[side];
      if (!is_hidden(old, fresh, are_same_queries)) continue;
      const std::string were = !are_same_queries          ? "all before"
                               : old.given == fresh.given ? "and other ones before"
                                                          : thousands(old.given) + " before";
      hidden.push_back({then.name, fmt::format("{} beside {} of {} {}, {}", then.name, thousands(fresh.given),
                                               thousands(fresh.answers), said[side], were)});
    }
  }
  return hidden;
}

}  // namespace axiscert
