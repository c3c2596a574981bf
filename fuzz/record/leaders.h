// The queries worth keeping: the best few by a rank.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace axiscert {

// A query worth keeping, by its position in the source: the record makes it again. The greater rank wins, then the
// earlier position, so that no order of merging changes what is kept.
template <class Rank>
struct Candidate {
  Rank rank;
  std::uint64_t position;
};

// The best `capacity` candidates, best first.
template <class Rank>
class Leaders {
 public:
  explicit Leaders(std::size_t capacity = 1) : capacity_(capacity) {}
  void offer(Candidate<Rank> candidate) {
    if (kept_.size() == capacity_ && !before(candidate, kept_.back())) return;
    kept_.insert(std::upper_bound(kept_.begin(), kept_.end(), candidate, before), candidate);
    if (kept_.size() > capacity_) kept_.pop_back();
  }
  void merge(const Leaders& other) {
    for (const Candidate<Rank>& candidate : other.kept_) offer(candidate);
  }
  const std::vector<Candidate<Rank>>& candidates() const { return kept_; }
  Rank best() const { return kept_.empty() ? Rank() : kept_.front().rank; }
  void put(auto& encoder) const {
    encoder.put(kept_.size());
    for (const auto& [rank, position] : kept_) {
      encoder.put(rank);
      encoder.put(position);
    }
  }
  void get(auto& decoder) {
    for (std::size_t count = decoder.next_size(capacity_); count > 0; --count) {
      const Rank rank = decoder.template next_of<Rank>();
      offer({rank, decoder.template next_of<std::uint64_t>()});
    }
  }
  // JSON has the best rank, 0 where there is none; its query is a witness.
  using Written = Rank;
  Rank written() const { return best(); }
  void take(const Rank& best) {
    if (best != Rank{}) offer({best, 0});
  }
  // Whether a candidate of at most this rank could still be kept.
  bool could_keep(const Candidate<Rank>& at_most) const {
    return kept_.size() < capacity_ || before(at_most, kept_.back());
  }

 private:
  static bool before(const Candidate<Rank>& a, const Candidate<Rank>& b) {
    return a.rank != b.rank ? a.rank > b.rank : a.position < b.position;
  }

  std::size_t capacity_;
  std::vector<Candidate<Rank>> kept_;
};

}  // namespace axiscert
