// The parts of a query file: its queries of one predicate and entry each.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"

namespace axiscert {

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
