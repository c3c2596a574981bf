// The errors of comparisons over many queries: their maximum, exact, and their quantiles.
#pragma once

#include <bit>
#include <map>
#include <optional>

#include "exact/trait/side_error.h"

namespace axiscert {

// Errors of Kind::finite, in u. The result of merging does not depend on the order.
//
// A quantile is a lower order statistic of the estimates upper(), which lie within 2^-39 of the errors: those are
// counted in buckets [x, x (1 + 2^-10)] at most, and the result is the middle of the bucket that contains the
// statistic, within 2^-11 of it. So the memory does not grow with the number of queries.
class ErrorSpread {
 public:
  void add(const SideError& error) {
    double estimate = error.upper();
    if (estimate > 0 && estimate >= worst_.value()) {
      const Decimal6 exact = error.rounded_up();
      worst_ = std::max(worst_, exact);
      if (!std::isfinite(estimate)) estimate = exact.value();
    } else if (!std::isfinite(estimate)) {
      estimate = error.rounded_up().value();
    }
    ++buckets_[std::bit_cast<std::uint64_t>(estimate) >> dropped_bits];
    ++count_;
  }
  void merge(const ErrorSpread& other) {
    for (const auto& [bucket, count] : other.buckets_) buckets_[bucket] += count;
    count_ += other.count_;
    worst_ = std::max(worst_, other.worst_);
  }

  std::uint64_t count() const { return count_; }
  Decimal6 worst() const { return worst_; }  // rounded up
  // The lower order statistic at `percent`; empty without errors; infinite beyond binary64's range.
  std::optional<double> quantile(unsigned percent) const {
    if (count_ == 0) return std::nullopt;
    // (count - 1) percent / 100, rounded down, without leaving 64 bits.
    const std::uint64_t last = count_ - 1, rank = last / 100 * percent + last % 100 * percent / 100;
    std::uint64_t below = 0;
    for (const auto& [bucket, count] : buckets_) {
      below += count;
      if (below > rank) return middle(bucket);
    }
    return std::nullopt;
  }
  bool operator==(const ErrorSpread&) const = default;

 private:
  static constexpr unsigned dropped_bits = 52 - 10;  // dropped from a non-negative binary64 number
  static double middle(std::uint64_t bucket) {
    const double least = std::bit_cast<double>(bucket << dropped_bits);
    if (least == 0 || !std::isfinite(least)) return least;
    return std::bit_cast<double>((bucket << dropped_bits) | (std::uint64_t{1} << (dropped_bits - 1)));
  }

  std::map<std::uint64_t, std::uint64_t> buckets_;
  std::uint64_t count_ = 0;
  Decimal6 worst_;
};

}  // namespace axiscert
