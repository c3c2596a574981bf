// Checks a JSON value against the JSON Schemas of reports/schemas.
#pragma once

#include <optional>
#include <string>

#include "fuzz/text/json.h"

namespace axiscert {

// Finds the first fault, with its place as a JSON pointer: "/kernels/0/id: 7 is not a string". Debian packages no C++
// validator; the tests compare this one with python3-jsonschema on the same files. Knows the keywords that the schemas
// here use, and throws std::logic_error for any other: a schema never requires more than is checked.
std::optional<std::string> schema_fault(const Json& schema, const Json& value);

// Throws Error where the value's "schema" is not the one that `schema` describes, or where the value does not conform
// to it. The text names the file, says what would be right, and ends with `advice`: what to do about a damaged file.
void check_schema(const Json& schema, const Json& value, const std::string& name, const std::string& advice);

}  // namespace axiscert
