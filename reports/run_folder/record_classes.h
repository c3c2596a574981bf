// Conditions on a record's classes of input that its schema cannot express.
#pragma once

#include <optional>
#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// Says what contradicts the family's other counts; empty if nothing does, or the family has no classes.
std::optional<std::string> fault_of_classes(const Json& kernel, const Json& family);

}  // namespace axiscert
