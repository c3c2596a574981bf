#include "cli/running/terminal.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <string_view>

namespace axiscert {

bool output_has_colour() {
  const char *no_colour = std::getenv("NO_COLOR"), *terminal = std::getenv("TERM");
  if (no_colour != nullptr && *no_colour != '\0') return false;
  return isatty(STDOUT_FILENO) != 0 && terminal != nullptr && std::string_view(terminal) != "dumb";
}

std::string coloured(const std::string& text, TextColour colour) {
  if (text.empty() || !output_has_colour()) return text;
  const int code = colour == TextColour::red ? 31 : colour == TextColour::yellow ? 33 : 32;
  const bool has_end = text.back() == '\n';
  return fmt::format("\x1b[{}m{}\x1b[0m{}", code, text.substr(0, text.size() - has_end), has_end ? "\n" : "");
}

}  // namespace axiscert
