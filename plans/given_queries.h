// The queries that a command is given: of addresses and of files, and the parts of these, each of one predicate and
// entry.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/files/query_file.h"
#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

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

// Query files with queries of several predicates: each part, of one predicate and entry, is judged by itself.

struct QueryPart {
  const Predicate* predicate;
  std::size_t entry;
  std::vector<std::string> kernels;  // of those that were given, these ids are of the part

  // "box-box", "box-box-quaternion": as a folder has it.
  std::string folder() const;
};

// The parts of query files, in the order in which they first occur; of one predicate where that is named. Where there
// are several, it is said on standard error how many queries each file has of which. Throws Error, which says what the
// files have, for a kernel of no part, and for a part without one where kernels are given.
std::vector<QueryPart> query_parts(const std::vector<std::string>& files, Precision csv_precision,
                                   const std::string& predicate, const std::vector<std::string>& kernels);

// For a command that prints what one kernel says of each query: throws Error for two of one predicate and entry.
void require_one_of_each(std::span<const Kernel* const> given);
// The kernel that judges a query of this predicate and entry: the one that is given for it; where none are given the
// default. Throws Error where none of those given is. `what` is asked: "mine.jsonl: query 'q'".
const Kernel& kernel_for_query(std::span<const Kernel* const> given, const Predicate& predicate, std::size_t entry,
                               std::string_view what);

}  // namespace axiscert
