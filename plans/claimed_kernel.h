// A kernel of which the harness sees nothing but answers, by what its author claims and promises of it.
#pragma once

#include <string>
#include <vector>

#include "fuzz/files/streams.h"
#include "kernel/kernel.h"

namespace axiscert {

struct KernelClaims {
  std::string id = "pipe", touching = "contact";
  std::string sides = "both";
  double margin = 0;
  bool may_decline = false;  // `undecided` is an answer that it may give
  ReplyClaim claim;
};

// Which queries it answers, and what its answers show.
struct ShownAnswers {
  const Predicate* predicate;
  std::size_t entry;
  std::vector<Precision> precisions;
  bool has_bits = false;
  std::size_t measure_count = 0;
};

// The kernel, in no precision yet. Answers with bits are of the usual or the first formulae of their predicate, unless
// a claim says which. Throws Error, in the words of `axiscert judge`, for a claim that such answers do not fit.
Kernel claimed_kernel(const KernelClaims& claims, const ShownAnswers& shown);

}  // namespace axiscert
