// Checks a JSON value against the JSON Schemas of this folder.
#pragma once

#include <optional>
#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// No C++ validator is packaged for Debian; the tests hold this one and python3-jsonschema to the same files.
// The first fault, with the place as a JSON pointer: "/kernels/0/id: 7 is not a string". Knows the keywords that the
// schemas here use, and throws std::logic_error for any other: a schema never asks for more than is checked.
std::optional<std::string> schema_fault(const Json& schema, const Json& value);

// Throws Error where the value is not of the one "schema" that `schema` describes, or not as it has it. The text names
// the file, says what would be right, and ends with `advice`: what to do about a file that is damaged.
void check_schema(const Json& schema, const Json& value, const std::string& name, const std::string& advice);

}  // namespace axiscert
