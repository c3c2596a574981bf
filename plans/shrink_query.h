// A query that is made smaller, by what is asked for: what `axiscert shrink` does with each.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fuzz/campaign/progress.h"
#include "fuzz/files/query_file.h"
#include "fuzz/record/record.h"
#include "fuzz/shrink/pair.h"
#include "fuzz/shrink/shrink.h"
#include "kernel/base/error.h"
#include "plans/given_queries.h"
#include "reports/instrument/query_data.h"

namespace axiscert {

// A query made small, as a line of a query file that states what it keeps.

// The smaller query as a stored one, named "shrunk-" and the name of the given one.
StoredQuery smaller_query(const StoredQuery& stored, AnyNumbers numbers);
// The image of a stored query as one, with "-image" after its name.
StoredQuery image_of(const StoredQuery& stored, AnyNumbers image);

// The smaller query, named "shrunk-" and the name of the given one, together with the symptom that it keeps and the
// given query.
template <class Real>
ShrunkQuery shrunk_query(const StoredQuery& stored, const Symptom& kept, const ShrinkResult<Real>& found,
                         const Kernel& kernel);

// The same for a pair: the line has the smaller query's image as its member `image`, and the given one's in `before`.
template <class Real>
ShrunkQuery shrunk_pair(const StoredQuery& stored, const Pair<Real>& pair, const ShrunkPair<Real>& found,
                        const Kernel& kernel);

// One line for every witness of a record on which its kernel is wrong: the first symptom that it shows (verdict before
// axes before comparisons before measures), made smaller with at most this many evaluations; and for every other
// witness of an asymmetry, the pair.
std::string shrunk_witnesses(const Record& record, const std::string& target, std::uint64_t evaluations,
                             const ShowProgress& report);

struct ShrinkOptions {
  std::vector<std::string> queries;
  std::vector<std::string> kernels;
  std::string target = "auto", precision = "binary32", what, format = "text";
  std::uint64_t evaluations = 1000000;
  bool any_class = false;
  AddressFiles files;
};

// "COMPARISON:error" keeps the error, whether or not the sign is wrong; "asymmetry" the difference between the answers
// to a query and to an image of it.
inline constexpr std::string_view error_suffix = ":error", asymmetry_name = "asymmetry";

// Thrown for a query that shows nothing to keep.
struct NothingToKeep : Error {
  using Error::Error;
};

// Refuses what is no name of a symptom.
void require_known_symptom(const Kernel& kernel, std::string_view what);

// The kernel that a query is asked of, which has to take it. Of several given the one of its predicate and entry.
const Kernel& kernel_to_shrink(const StoredQuery& stored, const std::vector<const Kernel*>& given);

// What came of one query.
struct Shrunk {
  // The query that was made smaller: the given one, or, where the kernel is right on that and wrong on another of the
  // same images, which no map leads to, that one, by its address.
  StoredQuery asked;
  bool is_relative = false;
  StoredQuery smaller;
  std::optional<StoredQuery> image = {};  // of a pair
  std::string kept, input_class = {};     // the symptom in words; the class that is kept besides, where one is
  QuerySize size_before, size_after;
  std::string severity_before, severity_after;
  std::size_t steps;
  std::uint64_t evaluations;
  bool complete;
  ShrunkQuery line;  // all of it, as data
};
// Throws Error, and NothingToKeep.
Shrunk shrunk(const StoredQuery& stored, const ShrinkOptions& options, const Kernel& kernel, std::string_view target,
              const CountEvaluations& evaluated);

}  // namespace axiscert
