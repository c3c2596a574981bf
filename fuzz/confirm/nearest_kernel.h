// The built-in kernel that fails on most of the queries on which another kernel fails.
#pragma once

#include <optional>
#include <vector>

#include "fuzz/record/tally.h"
#include "fuzz/queries/source.h"

namespace axiscert {

// Compared on the first nearest_queries of each source and on the deepest wrong verdicts that a run kept.
struct NearestKernel {
  const Kernel* kernel;
  std::uint64_t queries;  // compared
  std::uint64_t wrong;    // on which the given kernel is wrong
  std::uint64_t both;     // on which both are
  std::uint64_t either;   // on which one of them or both are
};

// One source of a run in one precision, and the tally of the kernel on it.
struct TalliedSource {
  SeededSource asked;
  std::uint64_t queries;  // that were run
  const Tally* tally;
};

// `sources`: in one precision. The kernel of kernels() with the greatest share `both` / `either`, the first of those
// with the same share. Empty if the given kernel has no classes (fuzz/record/wrong_verdicts.h), is never wrong
// here, or no other one is wrong where it is. A touching query is right as contact for the built-in kernels, and by its
// own convention for the given one.
std::optional<NearestKernel> nearest_kernel(const Kernel& kernel, const std::vector<TalliedSource>& sources,
                                            const std::string& target);

}  // namespace axiscert
