// What comes of asking a kernel: the decision on one query, which is a verdict and the comparison bits that it follows
// from, and faults found on the way.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/enums.h"
#include "kernel/names.h"

namespace axiscert {
// The decision of a set of formulae on one query; no bits from a method that has only a verdict.
struct Outcome {
  Verdict verdict;
  std::optional<ComparisonBits> bits;
  bool operator==(const Outcome&) const = default;
};

// Faults of a kernel other than a wrong answer, found while it ran.

enum class FindingKind : std::uint8_t {
  load,              // cannot be loaded, or makes a statement about itself that cannot be true
  abi,               // made for a version of the interface that axiscert does not know
  crash,             // a signal, or the process ended
  hang,              // no answer within the time limit
  out_of_bounds,     // touched memory beside an array, or wrote to an input
  nondeterministic,  // a different answer to the same batch
  batch_dependent,   // a different answer to the same query in another lane, batch length or alignment
  order_dependent,   // a different answer to the same query in another order of the batch, or alone
  environment,       // left the floating-point environment changed
  inconsistent,      // a value that is not a verdict, or a verdict that its own comparisons contradict
  exchanged,         // contact for what is apart, and separated for what is in contact, nearly everywhere
};
template <>
inline constexpr std::size_t enum_count<FindingKind> = 11;
inline constexpr std::size_t finding_kind_count = enum_count<FindingKind>;
inline constexpr EnumArray<FindingKind, std::string_view> finding_kind_names = {"load",
                                                                                "abi",
                                                                                "crash",
                                                                                "hang",
                                                                                "out_of_bounds",
                                                                                "nondeterministic",
                                                                                "batch_dependent",
                                                                                "order_dependent",
                                                                                "environment",
                                                                                "inconsistent",
                                                                                "exchanged"};
constexpr std::string_view name(FindingKind kind) { return finding_kind_names[kind]; }

struct Finding {
  FindingKind kind;
  std::size_t index;   // position of the query in its batch; 0 if no query is concerned
  std::string detail;  // one line, the same on every run
};

// What watching a kernel shows besides its answers.
struct Watched {
  std::vector<Finding> findings;
  std::uint64_t asked_again = 0;  // queries asked again in another order of their batch
};

}  // namespace axiscert
