// Query files: reads queries from JSON Lines or CSV, and writes them as JSON Lines.
//
// JSON Lines, one object per line:
//   {"id":"parry-76","precision":"binary32","a":[x,y,z],"b":[x,y,z],"c":[x,y,z],"p":[x,y,z],"r":"0x1.99999ap-3"}
// A number is text for parse_number: a JSON string, or the characters of a JSON number. `id` is optional (default
// "line-N") and need not be unique. Other fields are ignored: a witness is a query too.
// CSV begins with the header [id,]ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r, in this order; cells are not quoted.
// Either format may begin with a UTF-8 byte order mark, end its lines in CRLF and contain blank lines.
#pragma once

#include <cstddef>
#include <iosfwd>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "kernel/query.h"

namespace axiscert {

struct StoredQuery {
  std::string id;
  Precision precision;  // precision of `query`
  std::variant<Query<float>, Query<double>> query;
  std::size_t line = 0;  // in its file, from 1; 0 if it does not come from a file
};

// Parses all queries or throws. The Error begins NAME:LINE: field 'FIELD': as far as these are known. `csv_precision`
// is the precision of a CSV file, which does not state one; a line of JSON does.
std::vector<StoredQuery> parse_queries(std::string_view bytes, std::string_view name, Precision csv_precision);
std::vector<StoredQuery> read_queries(std::istream& in, std::string_view name, Precision csv_precision);
// The path "-" means standard input.
std::vector<StoredQuery> read_query_file(const std::string& path, Precision csv_precision);

// One line of JSON without its end, with all numbers hexadecimal: reading it gives the same bits, except for a NaN's
// payload.
std::string query_line(const StoredQuery& stored);

}  // namespace axiscert
