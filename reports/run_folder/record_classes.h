// Conditions on a record's classes of input, and on its decades of depth, that its schema cannot express.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// Says what contradicts the family's other counts; empty if nothing does, or the family has no classes.
std::optional<std::string> fault_of_classes(const Json& kernel, const Json& family);
// The same of a family's "verdict", of `valid` queries: its depths, and those on engine-like queries.
std::optional<std::string> fault_of_depths(const Json& verdict, std::uint64_t valid);

}  // namespace axiscert
