#include <fmt/format.h>

#include <sstream>

#include "fuzz/mutation/mutation.h"
#include "kernel/base/error.h"

namespace axiscert {

Equivalents parse_equivalent_mutants(const std::string& text, const std::string& file) {
  Equivalents all;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line); ++number) {
    if (line.empty() || line.front() == '#') continue;
    const auto fault = [&](const std::string& what) {
      return Error(fmt::format("{}:{}: {}; a line is NAME: REASON, as in 'nonstrict~sign:3: squared at once'", file,
                               number, what));
    };
    // A name contains a colon, but no colon followed by a space.
    const std::size_t end = line.find(": ");
    if (end == line.npos || end + 2 == line.size()) throw fault("no reason");
    const std::string name = line.substr(0, end);
    try {
      mutants::find_mutant(name);
    } catch (const Error& unknown) {
      throw fault(unknown.what());
    }
    if (!all.emplace(name, line.substr(end + 2)).second) throw fault(fmt::format("'{}' appears twice", name));
  }
  return all;
}

}  // namespace axiscert
