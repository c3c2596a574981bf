// Rates of failures, and tests of whether two of independent trials are the same, valid at any count, however small.
// `clusters.h` has trials that are not independent, `paired.h` the same trials of two kernels.
#pragma once

#include <cstdint>
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

}  // namespace axiscert
