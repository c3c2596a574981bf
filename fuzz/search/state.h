// What a search keeps between runs, as text: a line of JSON about the plan and how far it came, then its queries as
// lines of a query file, whose ids say in which pool each is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/search/search.h"

namespace axiscert {

// What is known for one aim: the lineage that islands start from, what the islands of the epoch under way have found
// since, and the best of all lineages; for how many epochs the lineage has not got better, and how many there were
// before.
struct StoredPools {
  std::vector<StoredQuery> lineage, fresh, best;
  std::uint64_t stalled = 0, restarts = 0;
};

struct SearchState {
  std::uint64_t islands = 0, evaluations = 0;  // done
  std::vector<StoredPools> pools;              // by aim
};

std::string state_text(const SearchPlan& plan, const std::vector<Aim>& aims, const SearchState& state);
// Throws Error where it is no state, or one of another plan: which member differs, and from what.
SearchState parse_state(std::string_view text, const SearchPlan& plan, const std::vector<Aim>& aims);

}  // namespace axiscert
