// Generates the query of an address.
#pragma once

#include <string>

#include "fuzz/queries/source.h"
#include "fuzz/files/query_file.h"

namespace axiscert {

// Present paths of the files in which addresses can be.
struct AddressFiles {
  std::string mesh, queries, corpus;
};

// The queries of files (- for standard input) and of addresses, one after the other; `csv_precision` as in
// query_file.h.
std::vector<StoredQuery> queries_given(const std::vector<std::string>& given, const std::string& csv_precision,
                                       const AddressFiles& files);

// Whether a text is meant as an address, a range of them or a witness's id: it has a colon, or is as w12, and there is
// no such file.
bool is_address(const std::string& text);

// Queries of one unit, by the address of the first.
struct QueryRange {
  Address first;
  std::uint64_t size;
  SourcePtr source;
};
// The queries of SEED:NAME:VERSION:PRECISION:UNIT:FIRST-LAST, or the one of an address. Throws Error as query_at()
// does, and for an end before the beginning, or beyond the unit or the file.
QueryRange query_range(const std::string& text, const AddressFiles& files);

// Generates the query again, with its address as its id. Throws Error where the source is not available here, or
// differs in its version or its SHA-256.
StoredQuery query_at(const Address& address, const AddressFiles& files);

}  // namespace axiscert
