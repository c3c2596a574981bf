// JSON in the form in which reports read and write it, whole.
#pragma once

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cstdint>
#include <limits>
#include <utility>

#include "fuzz/text/json_fwd.h"
#include "kernel/base/error.h"

namespace axiscert {

// A whole number from JSON or CBOR that another program may have written.

// The number, which has to fit Whole; throws Error for anything else. The library's own get() truncates fractions,
// wraps, and converts a float that does not fit Whole, which is undefined in C++.
template <class Whole>
Whole whole_number(const nlohmann::json& json) {
  using Limits = std::numeric_limits<Whole>;
  if (json.is_number_unsigned()) {
    if (const auto number = json.get<std::uint64_t>(); std::in_range<Whole>(number)) return static_cast<Whole>(number);
  } else if (json.is_number_integer()) {
    if (const auto number = json.get<std::int64_t>(); std::in_range<Whole>(number)) return static_cast<Whole>(number);
  }
  throw Error(fmt::format("{} is not a whole number from {} to {}",
                          json.is_number() ? json.dump() : std::string("a ") + json.type_name(), Limits::min(),
                          Limits::max()));
}

}  // namespace axiscert
