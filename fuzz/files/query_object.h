// A line of a query file as a struct, and the details of a query as query lines have them.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "exact/judge/oracles.h"
#include "fuzz/files/query_file.h"
#include "fuzz/text/json.h"
#include "fuzz/text/json_form.h"

namespace axiscert {
// A line of a query file, on which lines with more members are based.
struct StoredLine {
  std::string id;
  Precision precision = Precision::binary32;
  std::optional<Name> predicate, entry;
  NamedValues<Json> numbers;  // by group of columns; those whose names have dots are nested

  static constexpr std::string_view about =
      "A line of a query file (docs/queries.md). The numbers have the names of the groups of columns of its predicate.";
  AXISCERT_FIELDS(StoredLine, AXISCERT_FIELD(id, "Its name."), AXISCERT_FIELD(precision, "Of its numbers."),
                  AXISCERT_OPTIONAL_FIELD(predicate, "Its predicate; absent for the implied one."),
                  AXISCERT_OPTIONAL_FIELD(entry, "The form of its numbers; absent for the first."), rest(&Of::numbers))
};
inline StoredLine stored_line(const StoredQuery& stored) {
  return read_as<StoredLine>(Json::parse(query_line(stored)));
}

// The details that a predicate's oracles know of a query beside its verdict (exact/judge/oracles.h), as query lines
// have them.

// A number as query lines have it, a name, an array of names; null where the query has none.
Json detail_json(const Detail& detail);

}  // namespace axiscert
