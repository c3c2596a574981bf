// Text of foreign origin in a form that a message may quote.
#pragma once

#include <string>
#include <string_view>

namespace axiscert {

// The text with each control character, which a terminal would obey, replaced by a question mark. The result is one
// line.
inline std::string printable_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

}  // namespace axiscert
