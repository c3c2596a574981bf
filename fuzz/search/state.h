// The state of a search between runs, as text: a line of JSON about the plan and the progress, followed by the queries
// as lines of a query file, whose ids say in which pool each is.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "fuzz/search/search.h"

namespace axiscert {

// The queries known for one aim: the lineage from which islands start, the results of the current epoch's islands so
// far, and the best of all lineages; the number of epochs for which the lineage has not improved, and the number of
// earlier lineages.
struct StoredPools {
  std::vector<StoredQuery> lineage, fresh, best;
  std::uint64_t stalled = 0, restarts = 0;
};

struct SearchState {
  std::uint64_t islands = 0, evaluations = 0;  // finished
  std::vector<StoredPools> pools;              // one per aim
  std::vector<LookedAt> looked_at;             // one per aim
  LookedAt begun;
};

std::string state_text(const SearchPlan& plan, const std::vector<Aim>& aims, const SearchState& state);
// Throws Error if the text is not a state, or is one of another plan: the message says which member differs, and how.
SearchState parse_state(std::string_view text, const SearchPlan& plan, const std::vector<Aim>& aims);

}  // namespace axiscert
