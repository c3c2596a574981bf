// Query files: reads queries from JSON Lines or CSV, and writes them as JSON Lines.
//
// JSON Lines, one object per line:
//   {"id":"parry-76","precision":"binary32","a":[x,y,z],"b":[x,y,z],"c":[x,y,z],"p":[x,y,z],"r":"0x1.99999ap-3"}
// `predicate` is the id of the query's predicate (default: the first), and `entry` the entry in which its numbers are
// given (default: that which reads the most of the members given). The numbers' members are the groups of the entry's
// columns: an array, or a number where the group has one column. A name with dots is nested (kernel/predicate.h): in
//   {"predicate":"box-box","precision":"binary64","a":BOX,"b":BOX} with BOX {"m":[..],"s":[..],"q":[w,x,y,z]}
// `q` is "a.q" and "b.q", and this as a name is read too. A number is text for parse_number: a JSON string, or the
// characters of a JSON number. `id` is optional (default "line-N") and need not be unique. Fields that are not read,
// since a witness is a query too, and that axiscert does not itself write beside a query are told (set_query_notes);
// inside an object of the query, as a box is, they are refused.
// CSV begins with a header of column names, [id,]ax,ay,az,bx,by,bz,cx,cy,cz,px,py,pz,r for the predicate that files
// imply, in this order; which names they are tells predicate and entry. Cells are not quoted. Either format may begin
// with a UTF-8 byte order mark, end its lines in CRLF and contain blank lines.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <iosfwd>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "fuzz/queries/source.h"
#include "kernel/predicate.h"
#include "kernel/query.h"

namespace axiscert {

using AnyNumbers = std::variant<Numbers<float>, Numbers<double>>;

struct StoredQuery {
  std::string id;
  Precision precision;  // precision of `numbers`
  AnyNumbers numbers;
  const Predicate* predicate;
  std::size_t entry = 0;     // of the predicate: that in which the numbers are given
  std::size_t line = 0;      // in its file, from 1; 0 if it does not come from a file
  std::string address = {};  // that a line of JSON states, as a witness does; not written again

  const PredicateEntry& columns() const { return predicate->entries[entry]; }
};

// Is told of each field of a query file that is not read and may be a slip, once a file and name:
// "mine.jsonl:1: field 'Id' is not read; did you mean 'id'?". The command prints it; without one nobody is told.
using QueryNotes = std::function<void(const std::string& note)>;
void set_query_notes(QueryNotes notes);

// Parses all queries or throws. The Error begins NAME:LINE: field 'FIELD': as far as these are known. `csv_precision`
// is the precision of a CSV file, which does not state one; a line of JSON does. `known` are the predicates of which
// queries are understood.
std::vector<StoredQuery> parse_queries(std::string_view bytes, std::string_view name, Precision csv_precision,
                                       std::span<const Predicate* const> known = predicates());
std::vector<StoredQuery> read_queries(std::istream& in, std::string_view name, Precision csv_precision);
// The path "-" means standard input.
std::vector<StoredQuery> read_query_file(const std::string& path, Precision csv_precision);

// One line of JSON without its end, with all numbers hexadecimal: reading it gives the same bits, except for a NaN's
// payload.
std::string query_line(const StoredQuery& stored);

// The parts of a query file: its queries of one predicate and entry each.

// A source for each predicate and entry of which a file has queries, in the order in which they first occur; `path` and
// the others as of query_file_source() (fuzz/queries/source.h), which refuses a file with several.
std::vector<SourcePtr> query_file_sources(const std::string& path, Precision csv_precision,
                                          std::span<const Predicate* const> known = predicates());
// How many queries there are of a predicate and entry.
struct PartCount {
  const Predicate* predicate;
  std::size_t entry;
  std::uint64_t queries;
};
std::vector<PartCount> counts_of(const std::vector<SourcePtr>& parts);
std::vector<PartCount> counts_of(const std::vector<StoredQuery>& queries);
// "5 queries of sphere-triangle, 3 of box-box, entry quaternion".
std::string parts_text(const std::vector<PartCount>& parts);
// "box-box, entry quaternion".
std::string part_text(const Predicate& predicate, std::size_t entry);
// All of it, which is read once.
const std::string& standard_input();

}  // namespace axiscert
