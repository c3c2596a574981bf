#include "kernel/base/names.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace axiscert {
namespace {

char lower(char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; }

// Edit distance: the number of letters that are inserted, removed or changed.
std::size_t letters_apart(std::string_view from, std::string_view to) {
  std::vector<std::size_t> row(to.size() + 1);  // distances from the part of `from` read so far to each prefix of `to`
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 0; i < from.size(); ++i) {
    std::size_t diagonal = row[0];
    row[0] = i + 1;
    for (std::size_t k = 0; k < to.size(); ++k) {
      const std::size_t changed = diagonal + (lower(from[i]) == lower(to[k]) ? 0 : 1);
      diagonal = row[k + 1];
      row[k + 1] = std::min({changed, diagonal + 1, row[k] + 1});
    }
  }
  return row.back();
}

// A whole page of text resembles no name, and its distances would take long.
std::string_view word_of(std::string_view given) { return given.substr(0, 64); }

// One letter in three may be another, so that no name is near a word of one or two.
bool is_near(std::string_view word, std::string_view name) {
  const std::size_t apart = letters_apart(word, name);
  const bool begins_it = word.size() >= 3 && name.size() > word.size() && apart == name.size() - word.size() &&
                         letters_apart(word, name.substr(0, word.size())) == 0;
  return begins_it || (!word.empty() && 3 * apart <= std::max(word.size(), name.size()));
}

}  // namespace

std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names) {
  const std::string_view word = word_of(given);
  std::stable_sort(names.begin(), names.end(), [&](std::string_view a, std::string_view b) {
    return letters_apart(word, a) < letters_apart(word, b);
  });
  return names;
}

std::string_view meant(std::string_view given, const std::vector<std::string_view>& names) {
  if (given.size() != word_of(given).size()) return {};
  const auto sorted = most_alike_first(given, names);
  const auto near =
      std::find_if(sorted.begin(), sorted.end(), [&](std::string_view name) { return is_near(given, name); });
  return near == sorted.end() ? std::string_view() : *near;
}

std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& names) {
  const std::string_view name = meant(given, names);
  return name.empty() ? ";" : fmt::format("; did you mean '{}'?", name);
}

std::string names_alike(std::string_view kinds, std::string_view given, const std::vector<std::string_view>& names,
                        std::string_view command) {
  constexpr std::size_t most = 8;
  std::vector<std::string_view> nearest = most_alike_first(given, names);
  if (names.size() <= most) return fmt::format("{}: {}", kinds, fmt::join(nearest, ", "));
  nearest.resize(most);
  return fmt::format("the nearest of {} {}: {}; `{}` lists them", names.size(), kinds, fmt::join(nearest, ", "),
                     command);
}

namespace {

std::string unknown_among(std::string_view kind, std::string_view given, const std::vector<std::string_view>& names,
                          const std::string& list) {
  const bool has_commas = given.find(',') != given.npos;
  return fmt::format("unknown {} '{}'{} {}", kind, given,
                     has_commas ? "; one name is given at a time, without commas;" : did_you_mean(given, names), list);
}

}  // namespace

std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names, std::string_view command) {
  return unknown_among(kind, given, names, names_alike(kinds, given, names, command));
}

std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names) {
  return unknown_among(kind, given, names,
                       fmt::format("{}: {}", kinds, fmt::join(most_alike_first(given, names), ", ")));
}

}  // namespace axiscert
