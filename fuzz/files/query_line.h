// One line of a query file to one query: the two formats behind query_file.h.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/files/query_file.h"

namespace axiscert {

inline constexpr std::string_view csv_columns = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r";

// Where a line is, for messages.
struct Place {
  std::string_view file;
  std::size_t line;

  std::string default_id() const;
  // Throws Error; `field` may be empty where none is to blame.
  [[noreturn]] void fail(std::string_view field, std::string_view what) const;
};

// One of the thirteen numbers of a query as text, with what a message about it says first.
struct NumberText {
  std::string field, element, text;
};
StoredQuery stored_query(std::string id, Precision precision, const std::array<NumberText, coordinate_count>& numbers,
                         const Place& place);

StoredQuery query_of_json(std::string_view line, const Place& place);

struct CsvHeader {
  bool has_id;
};
// None where the line does not begin like a CSV header; Error where it does and then goes wrong.
std::optional<CsvHeader> csv_header(std::string_view line, const Place& place);
StoredQuery query_of_csv(std::string_view line, const CsvHeader& header, Precision precision, const Place& place);

}  // namespace axiscert
