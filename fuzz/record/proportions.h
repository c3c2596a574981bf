// Rates of failures, and tests of whether two of independent trials are the same, valid at any count, however small;
// and limits of a rate over clusters of trials that are not independent. `paired.h` has the same trials of two kernels.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <utility>
#include <vector>

namespace axiscert {

// `failures` among `trials` independent trials.
struct Proportion {
  std::uint64_t failures = 0, trials = 0;  // failures <= trials
};

// Fisher's exact test: given the total number of failures, and assuming that both rates are equal, the probability that
// the failures fall as unevenly as here or more so; two-sided, as twice the smaller tail. Never below the exact
// probability, so that no alarm rests on a rounding; above it by less than one part in 10^6 where it is below 1/2 and
// above 2^-990. Requires fewer than 2^40 trials in all.
double fisher_two_sided(Proportion x, Proportion y);

// Holm's correction of the probabilities `p`, in their order: rejecting those at most `level` rejects a true hypothesis
// among them with a probability of at most `level`, however they depend on each other.
std::vector<double> holm(const std::vector<double>& p);

// Clopper and Pearson's limits of the rate: the rate lies outside them with a probability of at most 5 %.
std::pair<double, double> rate_limits(Proportion x);

// 1 - 0.05^(1/n): the rate of failures that n right answers exclude, with 95 % confidence.
double excluded_rate(std::uint64_t n);

// Rates of failures among trials that come in clusters: queries that share a triangle or are images of one base, and
// the comparisons of one query, are not independent of each other; clusters are.

// Sums of the clusters of which the sum is not 0: how many clusters have each. Merging does not depend on the order.
class ClusterSums {
 public:
  void add(std::int64_t sum) {
    if (sum != 0) ++clusters_[sum];
  }
  void merge(const ClusterSums& other) {
    for (const auto& [sum, count] : other.clusters_) clusters_[sum] += count;
  }
  const std::map<std::int64_t, std::uint64_t>& clusters() const { return clusters_; }
  std::int64_t total() const;
  double total_of_squares() const;
  bool operator==(const ClusterSums&) const = default;

 private:
  std::map<std::int64_t, std::uint64_t> clusters_;
};

// With fewer clusters of several trials a design effect is too uncertain for limits: their coverage falls below 93 %.
inline constexpr std::uint64_t fewest_clusters = 20;

struct ClusteredTrials {
  std::uint64_t trials = 0, clusters = 0;  // clusters <= trials, of about the same number of trials each
  double mean_size() const { return static_cast<double>(trials) / static_cast<double>(clusters); }
  bool has_limits() const { return trials != 0 && (clusters == trials || clusters >= fewest_clusters); }
};

struct RateLimits {
  double low, high;
};

// By how many times the variance of a total over clusters is that of as many independent trials, at least 1 (Rao and
// Scott, Biometrics 48, 1992: dividing counts by it makes them those of independent trials). `variance` is that of one
// trial if all were independent. Where it is 0 the data tell nothing, and the trials of a cluster count as one.
double design_effect(const ClusteredTrials& of, const ClusterSums& sums, double variance);

inline constexpr double z_of_limits = 1.959963984540054;  // of 97.5 % of a normal distribution

// Wilson's score limits of a rate, 95 %, of failures and trials divided by their design effect; without a failure
// {0, excluded_rate(clusters)}. Empty without trials, and of too few clusters.
std::optional<RateLimits> wilson_limits(const ClusteredTrials& of, const ClusterSums& failures);

}  // namespace axiscert
