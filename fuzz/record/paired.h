// Two forms on the same trials: whether one fails more often than the other, and the least difference that so many
// trials can show.
#pragma once

#include <cstdint>
#include <optional>

#include "fuzz/record/proportions.h"

namespace axiscert {

// What `to` changes of `from`. Each cluster's sum is how many trials of it fail in `to` alone, less those that fail in
// `from` alone.
struct PairedCounts {
  ClusteredTrials of;
  std::uint64_t only_from = 0, only_to = 0;  // trials that fail in one form and not in the other
  ClusterSums sums;
};

// A probability, or a bound of one that is above it.
struct Probability {
  double value = 1;
  bool is_bound = false;
};

// The exact sign-flip test: if both forms fail alike, each cluster's sum has either sign with the probability 1/2, and
// so much is the probability of a total as far from 0 as here or farther. Clusters of one trial make it McNemar's exact
// test, the two-sided binomial one. Never below the exact probability; above it by less than one part in 10^7 where it
// is above 2^-990. Where exactness would take more than 2^27 steps it is Hoeffding's bound 2 exp(-t^2 / 2 sum a^2)
// (J. Am. Stat. Assoc. 58, 1963, theorem 2), and says so.
Probability sign_flip_two_sided(const ClusterSums& sums);
// McNemar's exact test, of independent trials.
Probability mcnemar_two_sided(std::uint64_t only_from, std::uint64_t only_to);

// The rate of failures of `to` less that of `from`, with Tango's score limits, 95 % (Stat. Med. 17, 1998), of counts
// divided by their design effect. Empty without trials.
struct RateDifference {
  double value, design_effect;
  std::optional<RateLimits> limits;  // empty of too few clusters
};
std::optional<RateDifference> rate_difference(const PairedCounts& counts);

inline constexpr double shown_power = 0.8;
// The least true difference of the rates that a test at this level, two-sided, would find with a probability of 80 %:
// the greater of two. The first is (z(1 - level/2) + z(0.8)) times the standard error under equal rates, with as many
// trials that differ as here (Connor, Biometrics 43, 1987). The second has all differing trials on one side: as many
// as the exact test needs at least have to be among the independent trials, and so many clusters. Empty where no
// outcome would be enough.
std::optional<double> least_difference(const PairedCounts& counts, double level);

}  // namespace axiscert
