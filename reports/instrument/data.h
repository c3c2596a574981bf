// What instruments and lists print for other programs: the head of their JSON (docs/data.md), and lines of CSV.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "fuzz/text/values.h"
#include "kernel/base/version.h"
#include "kernel/outcome.h"

namespace axiscert {
// {"schema": axiscert-NAME/VERSION, "axiscert": the version, "revision": its commit}: the first base of the struct
// `File`, which says its `format`.
template <class File>
struct DataHead {
  FormatName<File> schema;
  Name axiscert = std::string(axiscert_version), revision = std::string(axiscert_revision);

  AXISCERT_FIELDS(
      DataHead, AXISCERT_FIELD(schema, "The format of this file."),
      AXISCERT_FIELD(axiscert, "The version that wrote it."),
      AXISCERT_FIELD(
          revision,
          "The commit that it was built from, with -dirty where the tree differed; unknown without a repository."))
};
template <class File>
struct CommandData : DataHead<File> {
  Name command;

  AXISCERT_FIELDS(CommandData, base<CommandData, DataHead<File>>(),
                  AXISCERT_FIELD(command, "The command that makes the same file again."))
};

// A fault of a kernel as lists and lines have it.
struct FindingRow {
  FindingKind kind = FindingKind::load;
  std::string detail;

  AXISCERT_FIELDS(FindingRow, AXISCERT_FIELD(kind, "The kind of fault."), AXISCERT_FIELD(detail, "What happened."))
};
inline std::vector<FindingRow> finding_rows(const std::vector<Finding>& findings) {
  std::vector<FindingRow> rows;
  for (const Finding& finding : findings) rows.push_back({finding.kind, finding.detail});
  return rows;
}

// Lines of CSV (RFC 4180), whose columns follow from the fields of what is written.

// Names of columns in their order: a member of a row, or with dots the path to one.
using DataColumns = std::vector<std::string>;

// Adds the columns of a JSON Schema that are not there yet. A cell is a number or text, or a list of these; members of
// a member are cells of their own. Maps, lists of others and queries are left out.
void add_columns(DataColumns& columns, const Json& schema, const std::string& path);
// `first`, and the cells of a row that is a T.
template <class T>
DataColumns with_columns_of(DataColumns first) {
  add_columns(first, JsonForm<T>::schema(), "");
  return first;
}

// The line of names.
std::string csv_head(const DataColumns& columns);
// A row: null, or a member that it lacks, is an empty cell, an array its elements with spaces between them.
std::string csv_line(const DataColumns& columns, const Json& row);

}  // namespace axiscert
