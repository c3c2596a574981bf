// Query files: JSON Lines or CSV to queries, and queries to JSON Lines.
//
// JSON Lines, one object a line:
//   {"id":"parry-76","precision":"binary32","a":[x,y,z],"b":[x,y,z],"c":[x,y,z],"p":[x,y,z],"r":"0x1.99999ap-3"}
// A number is text for parse_number: a JSON string, or a JSON number, of which the characters are taken. `id` may be
// left out ("line-N") and need not be unique. Other fields are ignored: a witness is a query too.
// CSV begins with the header [id,]ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r, in this order; cells are not quoted.
// Either may begin with a UTF-8 byte order mark, end its lines in CRLF and hold blank lines.
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
  Precision precision;  // of `query`
  std::variant<Query<float>, Query<double>> query;
  std::size_t line = 0;  // in its file, from 1; 0 where it comes from none
};

// All or nothing. Throws Error that begins NAME:LINE: field 'FIELD': as far as these are known. `csv_precision` is that
// of a CSV file, which does not say; a line of JSON does.
std::vector<StoredQuery> parse_queries(std::string_view bytes, std::string_view name, Precision csv_precision);
std::vector<StoredQuery> read_queries(std::istream& in, std::string_view name, Precision csv_precision);
// "-" is standard input.
std::vector<StoredQuery> read_query_file(const std::string& path, Precision csv_precision);

// One line of JSON, without its end, all numbers hexadecimal: reading it gives the same bits, but for a NaN's payload.
std::string query_line(const StoredQuery& stored);

}  // namespace axiscert
