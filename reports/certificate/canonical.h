// JSON of which equal values have equal bytes, and the strict reader of what others wrote.
#pragma once

#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

#include "fuzz/text/json_fwd.h"

namespace axiscert {

// A certificate that was read, and does not hold: exit 1. The message is one printable line.
struct NotValid : std::runtime_error {
  explicit NotValid(const std::string& message);
};

// Members sorted by their bytes, no blank, no line end. Throws HarnessFault for a fraction, or text that is not UTF-8:
// a figure that is no whole number is written as decimal text.
std::string canonical_json(const Json& value);

// Throws Error, which begins with `name`, for more than `most` bytes, what is not JSON or ends too early, a member that
// occurs twice, a number that is not whole or has more than 64 bits, and more than 32 levels.
Json strict_json(std::string_view bytes, const std::string& name, std::size_t most);

}  // namespace axiscert
