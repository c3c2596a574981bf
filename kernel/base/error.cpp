#include "kernel/base/error.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace axiscert {
namespace {

// Number of bytes in the character at the beginning of the text, which must not be empty; 0 if the text does not begin
// with a well-formed character.
std::size_t character_size(std::string_view text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(0);
  if (first < 0x80) return 1;
  const std::size_t size = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
  // 0xc0 and 0xc1 could only begin an overlong form, 0xf5 and above only a code point beyond U+10FFFF.
  if (first < 0xc2 || first > 0xf4 || text.size() < size) return 0;
  for (std::size_t i = 1; i < size; ++i) {
    if ((byte(i) & 0xc0) != 0x80) return 0;
  }
  const unsigned char second = byte(1);
  const bool is_overlong = (first == 0xe0 && second < 0xa0) || (first == 0xf0 && second < 0x90);
  const bool is_surrogate = first == 0xed && second >= 0xa0, is_beyond = first == 0xf4 && second >= 0x90;
  return is_overlong || is_surrogate || is_beyond ? 0 : size;
}

std::uint32_t code_point(std::string_view character) {
  const auto first = static_cast<unsigned char>(character[0]);
  std::uint32_t point = character.size() == 1 ? first : first & (0xffU >> (character.size() + 1));
  for (const char c : character.substr(1)) point = (point << 6) | (static_cast<unsigned char>(c) & 0x3f);
  return point;
}

// Control characters, those that turn the direction of text, separators of lines, and the mark of byte order.
bool is_obeyed(std::uint32_t point) {
  const auto is_from = [&](std::uint32_t first, std::uint32_t last) { return first <= point && point <= last; };
  return point < 0x20 || is_from(0x7f, 0x9f) || point == 0x61c || is_from(0x200e, 0x200f) || is_from(0x2028, 0x202e) ||
         is_from(0x2066, 0x2069) || point == 0xfeff;
}

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = character_size(bytes.substr(at));
    if (size == 0) return false;
    at += size;
  }
  return true;
}

std::string printable_line(std::string_view text) {
  std::string line;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t size = character_size(text.substr(at));
    const std::string_view character = text.substr(at, size == 0 ? 1 : size);
    at += character.size();
    if (size == 0) line += fmt::format("\\x{:02x}", static_cast<unsigned char>(character[0]));
    else if (const std::uint32_t point = code_point(character); !is_obeyed(point)) line += character;
    else
      line += point == '\n' ? "\\n" : point == '\t' ? "\\t" : point == '\r' ? "\\r" : fmt::format("\\u{:04x}", point);
  }
  return line;
}

void require_utf8(std::string_view name, std::string_view what) {
  if (is_utf8(name)) return;
  throw Error(
      fmt::format("{} '{}': its name is not UTF-8, which a record, being JSON, has to be; rename it", what, name));
}

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
