// The best known queries for one aim.
#pragma once

#include <algorithm>
#include <atomic>
#include <bit>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "exact/numbers/rational.h"
#include "fuzz/search/search.h"
#include "kernel/query.h"

namespace axiscert {
// The queries with the greatest few distinct exact values, greatest first; only one of several queries with the same
// value, which are mostly mirror images. The content depends on the queries that were inserted, not on their order.
template <class Real>
class Pool {
 public:
  struct Entry {
    Decimal6 value;
    Numbers<Real> query;
  };
  static constexpr std::size_t capacity = 8;

  void put(const Entry& entry) {
    const auto at = std::lower_bound(entries_.begin(), entries_.end(), entry,
                                     [](const Entry& x, const Entry& y) { return x.value > y.value; });
    if (at != entries_.end() && at->value == entry.value) {
      if (bits(entry.query) < bits(at->query)) at->query = entry.query;
      return;
    }
    entries_.insert(at, entry);
    if (entries_.size() > capacity) entries_.pop_back();
  }
  void put(const Pool& other) {
    for (const Entry& entry : other.entries_) put(entry);
  }
  const std::vector<Entry>& entries() const { return entries_; }
  bool empty() const { return entries_.empty(); }
  const Entry& best() const { return entries_.front(); }

 private:
  static auto bits(const Numbers<Real>& q) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    std::vector<Bits> all;
    for (const Real x : q) all.push_back(std::bit_cast<Bits>(x));
    return all;
  }
  std::vector<Entry> entries_;
};

// The finds of a short run of a search's kernel: a search begins from it and reports no less.

template <class Real>
struct Beginning {
  std::vector<std::vector<Numbers<Real>>> found;  // by aim
  LookedAt looked_at;                             // without the first fault, which a run has in its record
  std::vector<std::uint64_t> judged;              // by aim: those with the number that it is about; of others 0
};

// For each aim the queries that showed most of it, in the order of aims, by a run of plan.first_queries queries of each
// of plan.first_sources: the deepest wrong verdicts and, for a comparison, its largest errors; for the critical radius,
// the deepest wrong verdicts too. At most Pool::capacity each, the most severe first; none for a goal of range, which a
// run does not measure. They are as the sources made them, and not confirmed. Depends on the plan alone, unless
// `interrupted`, which is polled.
template <class Real>
Beginning<Real> first_found(const SearchPlan& plan, const std::vector<Aim>& aims, const std::atomic<bool>& interrupted);

// The state of a search between runs, as text: a line of JSON about the plan and the progress, followed by the queries
// as lines of a query file, whose ids say in which pool each is.

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
  std::vector<std::uint64_t> judged;           // one per aim
  LookedAt begun;
};

std::string state_text(const SearchPlan& plan, const std::vector<Aim>& aims, const SearchState& state);
// Throws Error that begins with `name` if the text is not a state, or is one of another version of the format.
void require_state_format(std::string_view text, const std::string& name);
// Throws Error if the text is not a state, or is one of another plan: the message says which member differs, and how.
SearchState parse_state(std::string_view text, const SearchPlan& plan, const std::vector<Aim>& aims);

}  // namespace axiscert
