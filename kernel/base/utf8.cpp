#include "kernel/base/utf8.h"

#include <fmt/format.h>

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

}  // namespace

bool is_utf8(std::string_view bytes) {
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = character_size(bytes.substr(at));
    if (size == 0) return false;
    at += size;
  }
  return true;
}

std::string as_utf8(std::string_view bytes) {
  std::string text;
  for (std::size_t at = 0; at < bytes.size();) {
    const std::size_t size = character_size(bytes.substr(at));
    if (size == 0) text += fmt::format("\\x{:02x}", static_cast<unsigned char>(bytes[at]));
    else text += bytes.substr(at, size);
    at += size == 0 ? 1 : size;
  }
  return text;
}

void require_utf8(std::string_view name, std::string_view what) {
  if (is_utf8(name)) return;
  throw Error(fmt::format("{} '{}': its name is not UTF-8, which a record, being JSON, has to be; rename it", what,
                          as_utf8(name)));
}

}  // namespace axiscert
