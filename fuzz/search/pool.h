// The best known queries for one aim.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include "exact/numbers/decimal6.h"
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

}  // namespace axiscert
