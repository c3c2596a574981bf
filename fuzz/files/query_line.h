// One line of a query file as one query: the two formats behind query_file.h.
#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>

#include "fuzz/files/query_file.h"

namespace axiscert {

inline constexpr std::string_view csv_columns = "ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r";

// The position of a line, for messages.
struct Place {
  std::string_view file;
  std::size_t line;

  std::string default_id() const;
  // Throws Error; `field` is empty if no field is at fault.
  [[noreturn]] void fail(std::string_view field, std::string_view what) const;
};

// One of the thirteen numbers of a query as text, with the beginning of a message about it.
struct NumberText {
  std::string field, element, text;
};
StoredQuery stored_query(std::string id, Precision precision, const std::array<NumberText, coordinate_count>& numbers,
                         const Place& place);

StoredQuery query_of_json(std::string_view line, const Place& place);

struct CsvHeader {
  bool has_id;
};
// Empty if the line does not begin like a CSV header; throws Error if it does but is not a valid header.
std::optional<CsvHeader> csv_header(std::string_view line, const Place& place);
StoredQuery query_of_csv(std::string_view line, const CsvHeader& header, Precision precision, const Place& place);

}  // namespace axiscert
