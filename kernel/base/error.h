// The two errors a tool throws, caught once in main.
#pragma once

#include <stdexcept>
#include <string>

#include "kernel/base/plain_line.h"

namespace axiscert {

// Bad usage or input: exit 2. The message says what was given, where, and what would be right; as a plain line, for it
// quotes what may come from anywhere.
struct Error : std::runtime_error {
  explicit Error(const std::string& message) : std::runtime_error(plain_line(message)) {}
};

// The harness caught itself wrong (oracles that differ, a contracted build): exit 3.
struct HarnessFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

}  // namespace axiscert
