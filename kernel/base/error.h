// The two kinds of error that are thrown; each is caught once, in main.
#pragma once

#include <stdexcept>
#include <string>

#include "kernel/base/text.h"

namespace axiscert {

// Bad usage or input: exit 2. The message says what was given, where, and what would be right. It is made a printable
// line, because it may quote text of any origin.
struct Error : std::runtime_error {
  explicit Error(const std::string& message) : std::runtime_error(printable_line(message)) {}
};

// The harness found a fault of its own (oracles that differ, a contracted build): exit 3.
struct HarnessFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace axiscert
