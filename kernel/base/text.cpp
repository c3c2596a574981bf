#include "kernel/base/text.h"

#include <fmt/format.h>

#include <cstddef>
#include <cstdint>

#include "kernel/base/error.h"

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

}  // namespace axiscert
