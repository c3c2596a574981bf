// Text from somewhere else as a message may quote it.
#pragma once

#include <string>
#include <string_view>

namespace axiscert {

// One line without control characters, which a terminal would obey: a question mark stands for each.
inline std::string plain_line(std::string_view text) {
  std::string line(text);
  for (char& c : line) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return line;
}

}  // namespace axiscert
