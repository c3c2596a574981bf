// The options of `axiscert search`, and the plan that they lead to.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "fuzz/search/search.h"

namespace axiscert {

struct SearchOptions {
  std::string predicate, kernel, precision = "binary32", target = "auto", format = "text", out;
  std::vector<std::string> comparisons, families, what;
  std::optional<std::uint64_t> evaluations;
  std::optional<double> seconds;
  std::uint64_t seed = 1;
  int threads = 0;
  bool resume = false;
  std::uint64_t first_queries = 0;  // of each family in the run from which it begins; 0: as the predicate has it
};

// Throws Error for what does not exist, or not in this precision or predicate.
SearchPlan search_plan_of(const SearchOptions& options);

}  // namespace axiscert
