// Query files with queries of several predicates: each part, of one predicate and entry, is judged by itself.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/queries/source.h"
#include "kernel/kernel.h"

namespace axiscert {

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
