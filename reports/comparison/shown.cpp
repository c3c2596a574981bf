#include "reports/comparison/shown.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <utility>

#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "reports/comparison/cells.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr std::string_view said[] = {"contacts", "answers `separated`"};
constexpr std::string_view exposures_word = "shows=";

void tell_numbers(const ContactTally& contacts, const auto& tell) {
  for_each_number(contacts, [&](MeasureKind kind, const auto& part) {
    if (part) tell(name(kind), part->given);
  });
}

const Shown* find_shown(const std::vector<Shown>& all, std::string_view name) {
  const auto found = std::ranges::find(all, name, &Shown::name);
  return found == all.end() ? nullptr : &*found;
}

std::uint64_t mark_of_both(const std::array<GivenBeside, 2>& beside) { return beside[0].mark ^ beside[1].mark; }

// Tells what became of a number beside the answers of one verdict.
std::optional<Hiding> hiding_of(const GivenBeside& then, const GivenBeside& now, bool are_same_queries) {
  if (then.given == 0) return std::nullopt;
  if (!are_same_queries) {
    const bool are_many = std::min(then.answers, now.answers) >= least_looked_at;
    return are_many && then.is_all() && 2 * now.given < now.answers ? std::optional(Hiding::others) : std::nullopt;
  }
  if (then.mark == now.mark) return std::nullopt;
  return now.is_all() ? Hiding::verdicts : Hiding::others;
}

// The mark of some answers of a family, so that those of families add up.
std::uint64_t mark_in(const std::string& family, std::uint64_t mark) {
  return std::rotl(mark, static_cast<int>(std::stoul(short_sha256(family).substr(0, 2), nullptr, 16) % 64));
}

}  // namespace

std::vector<Shown> shown_in(const FamilyRecord& result) {
  std::vector<Shown> all;
  if (!result.contacts) return all;
  const std::uint64_t separations = result.contacts->separations, contacts = result.contacts->answers - separations;
  tell_numbers(*result.contacts, [&](std::string_view name, const GivenTally& given) {
    all.push_back({std::string(name),
                   {{GivenBeside{contacts, given.contacts, given.which_contacts.mark},
                     GivenBeside{separations, given.separations, given.which_separations.mark}}}});
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
        sum.mark ^= mark_in(family, here.mark);
      }
    }
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

std::vector<std::string_view> shown_of(const std::string& place, std::string_view member) {
  if (place == "pushed") return {"normal"};
  if (place == "point_a" || place == "point_b") return {"point_a", "point_b"};  // judged where both are given
  if (place == "points") return {"point_a", "point_b", "separation"};
  if (place == "consistency") return {"separation"};
  for (const MeasureKind kind : enumerators<MeasureKind>) {
    if (kind != MeasureKind::other && place == name(kind)) return {name(kind)};
  }
  if (place == "verdict" || place == "finding" || is_place_of_contacts(place)) return {};
  const bool is_of_sides = member != "false_separation" && member != "missed_separation";
  return {name(is_of_sides ? Exposure::sides : Exposure::comparisons)};
}

std::vector<Hidden> hidden_since(const std::vector<Shown>& before, const std::vector<Shown>& now,
                                 bool are_same_queries) {
  std::vector<Hidden> hidden;
  for (const Shown& then : before) {
    const Shown* const here = find_shown(now, then.name);
    if (here == nullptr || then.beside.has_value() != here->beside.has_value()) {
      hidden.push_back({then.name, fmt::format("no {} any more", then.name), Hiding::gone});
      continue;
    }
    if (!then.beside || (are_same_queries && mark_of_both(*then.beside) == mark_of_both(*here->beside))) continue;
    for (std::size_t side = 0; side < std::size(said); ++side) {
      const GivenBeside &old = (*then.beside)[side], &fresh = (*here->beside)[side];
      const std::optional<Hiding> hiding = hiding_of(old, fresh, are_same_queries);
      if (!hiding) continue;
      const std::string were = are_same_queries ? thousands(old.given) : "all";
      const bool is_unclear = *hiding == Hiding::others && are_same_queries && old.given <= fresh.given;
      hidden.push_back({then.name,
                        fmt::format("{} beside {} of {} {}, {} before{}", then.name, thousands(fresh.given),
                                    thousands(fresh.answers), said[side], were,
                                    is_unclear ? ", and it cannot be told whether these are among them" : ""),
                        *hiding});
    }
  }
  std::ranges::stable_sort(hidden, {}, &Hidden::kind);  // what is no fault comes last
  return hidden;
}

namespace {

[[noreturn]] void fail_number(const std::string& word) {
  throw Error(
      fmt::format("'{}' is not MEASURE=COUNT@MARK,COUNT@MARK: beside how many contacts, and answers that say "
                  "separated, it stands, and a mark of which; 0 for none",
                  word));
}

// "600@1f3c9a2b4d5e6f70", or "0".
GivenBeside side_of(const std::string& text, const std::string& word) {
  const std::size_t at = std::min(text.find('@'), text.size());
  const Json given = Json::parse(text.substr(0, at), nullptr, false);
  if (!given.is_number_unsigned()) fail_number(word);
  GivenBeside side{0, given.get<std::uint64_t>()};
  if ((side.given == 0) != (at == text.size())) fail_number(word);
  if (side.given == 0) return side;
  const char* const end = text.data() + text.size();
  const auto [read, error] = std::from_chars(text.data() + at + 1, end, side.mark, 16);
  if (error != std::errc() || read != end) fail_number(word);
  return side;
}

}  // namespace

std::vector<std::string> words_of_shown(const std::vector<Shown>& shown) {
  std::vector<std::string> exposures, words;
  const auto side = [](const GivenBeside& of) {
    return of.given == 0 ? "0" : fmt::format("{}@{:x}", of.given, of.mark);
  };
  for (const auto& [name, beside] : shown) {
    if (!beside) exposures.push_back(name);
    else words.push_back(fmt::format("{}={},{}", name, side((*beside)[0]), side((*beside)[1])));
  }
  if (!exposures.empty()) words.insert(words.begin(), fmt::format("{}{}", exposures_word, fmt::join(exposures, ",")));
  return words;
}

bool add_shown_word(const std::string& word, const Predicate* predicate, std::vector<Shown>& shown) {
  const std::string name = word.substr(0, word.find('='));
  std::vector<Shown> added;
  if (word.starts_with(exposures_word)) {
    for (std::size_t at = exposures_word.size(); at <= word.size();) {
      const std::size_t end = std::min(word.find(',', at), word.size());
      added.push_back({word.substr(at, end - at)});
      if (enumerator_named<Exposure>(added.back().name).value_or(Exposure::verdict) == Exposure::verdict)
        throw Error(fmt::format("'{}' names '{}', which is neither comparisons nor sides", word, added.back().name));
      at = end + 1;
    }
  } else if (enumerator_named<MeasureKind>(name).value_or(MeasureKind::other) != MeasureKind::other) {
    const std::size_t equals = std::min(word.find('='), word.size() - 1), comma = word.find(',');
    if (comma == word.npos || equals > comma) fail_number(word);
    added.push_back(
        {name, {{side_of(word.substr(equals + 1, comma - equals - 1), word), side_of(word.substr(comma + 1), word)}}});
  } else {
    return false;
  }
  for (Shown& one : added) {
    if (predicate != nullptr && !std::ranges::count(shown_names(*predicate), one.name))
      throw Error(fmt::format("'{}' shows '{}', which is none of: {}", word, one.name,
                              fmt::join(shown_names(*predicate), ", ")));
    if (find_shown(shown, one.name) != nullptr) throw Error(fmt::format("'{}' shows '{}' again", word, one.name));
    shown.push_back(std::move(one));
  }
  return true;
}

}  // namespace axiscert
