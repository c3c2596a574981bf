// Lines of CSV (RFC 4180), whose columns follow from the fields of what is written.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "fuzz/fields/json_form.h"

namespace axiscert {

// Names of columns in their order: a member of a row, or with dots the path to one.
using DataColumns = std::vector<std::string>;

// Adds the columns of a JSON Schema that are not there yet. A cell is a number or text, or a list of these; members of
// a member are cells of their own. Maps, lists of others and queries are left out.
void add_columns(DataColumns& columns, const Json& schema, const std::string& path);
// `first`, and the cells of a row that is a T.
template <class T>
DataColumns with_columns_of(DataColumns first) {
  add_columns(first, json_schema_of<T>(), "");
  return first;
}

// The line of names.
std::string csv_head(const DataColumns& columns);
// A row: null, or a member that it lacks, is an empty cell, an array its elements with spaces between them.
std::string csv_line(const DataColumns& columns, const Json& row);

}  // namespace axiscert
