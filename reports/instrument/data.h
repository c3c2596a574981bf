// The data that instruments and lists print for other programs: JSON with a head, and CSV of its rows. docs/data.md
// describes both.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/text/json.h"

namespace axiscert {

// {"schema": SCHEMA, "axiscert": the version, "revision": its commit, MEMBERS...}. The schema is
// reports/schemas/NAME.schema.json, where SCHEMA is axiscert-NAME/VERSION.
Json headed(std::string_view schema, const Json& members);

// The CSV of such JSON (RFC 4180, with a line of names): its rows, one observation a line. Null is an empty cell, an
// array of texts or numbers its elements with spaces between them. Throws std::logic_error for a schema that has no
// table.
std::string csv_of(const Json& data);

struct DataTable {
  std::vector<std::string> columns;  // a name is a member of a row, or with dots the path to one
  std::vector<Json> rows;            // a member that a row lacks is an empty cell
};
DataTable table_of(const Json& data);
std::string csv_text(const DataTable& table);

}  // namespace axiscert
