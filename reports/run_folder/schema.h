// Checks a JSON value against the JSON Schemas of reports/schemas.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "fuzz/fields/json_form.h"

namespace axiscert {

// Finds the first fault, with its place as a JSON pointer: "/kernels/0/id: 7 is not a string". Debian packages no C++
// validator; the tests compare this one with python3-jsonschema on the same files. Knows the keywords that the schemas
// here use, and throws std::logic_error for any other: a schema never requires more than is checked.
std::optional<std::string> schema_fault(const Json& schema, const Json& value);

// Throw Error for a file of another format, and for one that does not conform to its own. The text names the file, says
// what would be right, and ends with `advice`: what to do about a damaged file.
void require_format(const Json& value, std::string_view format, const std::string& name, const std::string& advice);
[[noreturn]] void refuse_file(std::string_view format, const std::string& fault, const std::string& name,
                              const std::string& advice);

// A file as its struct, whose fields it has to have.
template <Fielded File>
File read_file(const Json& value, const std::string& name, const std::string& advice) {
  require_format(value, File::format, name, advice);
  try {
    return read_as<File>(value);
  } catch (const JsonFault& fault) {
    refuse_file(File::format, fault.what(), name, advice);
  }
}

}  // namespace axiscert
