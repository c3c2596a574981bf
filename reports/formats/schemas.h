// The formats of the files that axiscert writes, as JSON Schemas and as CSV.
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "fuzz/text/json_fwd.h"

namespace axiscert {

// A format: its schema follows from the fields of what is written.
struct SchemaEntry {
  std::string_view name;  // "ladder", of the schema axiscert-ladder/4
  Json (*schema)();
};
std::span<const SchemaEntry> schemas();
// That of a name; throws Error that lists the names.
Json schema_named(std::string_view name);

// The CSV of a command's JSON (RFC 4180, with a line of names): its rows, one observation a line. Null is an empty
// cell, an array of texts or numbers its elements with spaces between them. Throws std::logic_error for a schema that
// has no table.
std::string csv_of(const Json& data);

}  // namespace axiscert
