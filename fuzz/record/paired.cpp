#include "fuzz/record/paired.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <boost/math/distributions/normal.hpp>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "fuzz/record/log_factorials.h"

namespace axiscert {
namespace {

double binomial_half(std::uint64_t n, std::uint64_t k) {
  static thread_local LogFactorials log;
  log.start();
  log.add(n, 1);
  log.add(k, -1);
  log.add(n - k, -1);
  log.halve(n);
  return log.exp();
}

// The probabilities of 0 to `last` heads of n fair coins, each from its neighbour nearer to the middle, with three
// roundings.
std::vector<double> heads(std::uint64_t n, std::uint64_t last) {
  std::vector<double> p(last + 1);
  const std::uint64_t start = std::min(last, n / 2);
  p[start] = binomial_half(n, start);
  for (std::uint64_t k = start; k-- > 0;) {
    p[k] = p[k + 1] * (static_cast<double>(k + 1) / static_cast<double>(n - k));
  }
  for (std::uint64_t k = start + 1; k <= last; ++k) {
    p[k] = p[k - 1] * (static_cast<double>(n - k + 1) / static_cast<double>(k));
  }
  return p;
}

struct SumsOfOneSize {
  std::uint64_t size, clusters;
};

// Clusters by the size of their sums, whatever its sign; the smallest first.
std::vector<SumsOfOneSize> by_size(const ClusterSums& sums) {
  std::map<std::uint64_t, std::uint64_t> sizes;
  for (const auto& [sum, clusters] : sums.clusters()) sizes[static_cast<std::uint64_t>(std::abs(sum))] += clusters;
  std::vector<SumsOfOneSize> all;
  for (const auto& [size, clusters] : sizes) all.push_back({size, clusters});
  return all;
}

constexpr double most_steps = 1 << 27;

double steps_of(const std::vector<SumsOfOneSize>& groups, std::uint64_t lower) {
  double steps = 0;
  for (const auto& [size, clusters] : groups) {
    const double heads = static_cast<double>(std::min(clusters, lower / size)) + 1;
    steps += &size == &groups.front().size ? heads : heads * (static_cast<double>(lower) + 1);
  }
  return steps;
}

// P(the positive ones of sums of random signs add up to at most `lower`). All terms are positive, so their relative
// errors do not grow in sums: three roundings a step of heads(), and two a term, below 2^30 * 2^-53 together.
double lower_tail_of_signs(const std::vector<SumsOfOneSize>& groups, std::uint64_t lower) {
  std::vector<double> total(lower + 1, 0.0);
  bool is_first = true;
  for (const auto& [size, clusters] : groups) {
    const std::vector<double> p = heads(clusters, std::min(clusters, lower / size));
    if (std::exchange(is_first, false)) {
      for (std::size_t k = 0; k < p.size(); ++k) total[k * size] = p[k];
      continue;
    }
    for (std::uint64_t at = lower + 1; at-- > 0;) {
      double sum = 0;
      for (std::uint64_t k = 0; k < p.size() && k * size <= at; ++k) sum += p[k] * total[at - k * size];
      total[at] = sum;
    }
  }
  double sum = 0;
  for (const double p : total) sum += p;
  return sum;
}

}  // namespace

Probability sign_flip_two_sided(const ClusterSums& sums) {
  const std::vector<SumsOfOneSize> groups = by_size(sums);
  const auto total = static_cast<std::uint64_t>(std::abs(sums.total()));
  if (total == 0) return {};
  std::uint64_t all = 0;
  for (const auto& [size, clusters] : groups) all += size * clusters;
  // The total is 2 (the sum of the positive ones) - all, and as likely as its opposite.
  const std::uint64_t lower = (all - total) / 2;
  if (steps_of(groups, lower) > most_steps) {
    const auto t = static_cast<double>(total);
    return {std::min(1.0, 2 * std::exp(-t * t / (2 * sums.total_of_squares())) * (1 + 1e-12)), true};
  }
  const double p = 2 * lower_tail_of_signs(groups, lower) * (1 + 1e-7);
  return {std::clamp(p, 0x1p-990, 1.0), false};
}

Probability mcnemar_two_sided(std::uint64_t only_from, std::uint64_t only_to) {
  if (only_from == only_to) return {};
  const std::uint64_t lower = std::min(only_from, only_to);
  const double p = 2 * lower_tail_of_signs({{1, only_from + only_to}}, lower) * (1 + 1e-7);
  return {std::clamp(p, 0x1p-990, 1.0), false};
}

namespace {

// Tango's statistic at a difference d, of b trials that fail in `to` alone, c in `from` alone, n in all.
double score(double b, double c, double n, double d) {
  const double linear = -b - c + (2 * n - b + c) * d, constant = -c * d * (1 - d);
  // The most likely rate of `from` alone, given the difference: the root of 2 n q^2 + linear q + constant.
  const double q = (std::sqrt(std::max(0.0, linear * linear - 8 * n * constant)) - linear) / (4 * n);
  return (b - c - n * d) / std::sqrt(std::max(n * (2 * q + d * (1 - d)), 1e-300));
}

// Where the score, which falls with d, is `target`.
double difference_at_score(double b, double c, double n, double target) {
  double low = -1, high = 1;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (score(b, c, n, middle) > target ? low : high) = middle;
  }
  return (low + high) / 2;
}

double effect_of_design(const PairedCounts& counts) {
  const auto n = static_cast<double>(counts.of.trials);
  const double differing = static_cast<double>(counts.only_from + counts.only_to);
  const double mean = static_cast<double>(counts.sums.total()) / n;
  return design_effect(counts.of, counts.sums, differing / n - mean * mean);
}

}  // namespace

std::optional<RateDifference> rate_difference(const PairedCounts& counts) {
  if (counts.of.trials == 0) return std::nullopt;
  const double effect = effect_of_design(counts);
  const double b = static_cast<double>(counts.only_to) / effect, c = static_cast<double>(counts.only_from) / effect,
               n = static_cast<double>(counts.of.trials) / effect;
  RateDifference difference{(b - c) / n, effect, std::nullopt};
  if (counts.of.has_limits()) {
    difference.limits = {difference_at_score(b, c, n, z_of_limits), difference_at_score(b, c, n, -z_of_limits)};
  }
  return difference;
}

std::optional<double> least_difference(const PairedCounts& counts, double level) {
  if (counts.of.trials == 0) return std::nullopt;
  const auto n = static_cast<double>(counts.of.trials);
  const boost::math::normal normal;
  const double z = quantile(complement(normal, level / 2)) + quantile(normal, shown_power);
  const double by_error = z * std::sqrt(counts.sums.total_of_squares()) / n;
  // So many trials that differ, all on one side, are the fewest with 2 * 2^-fewest <= level.
  const double fewest = std::ceil(1 - std::log2(level) - 1e-12), independent = n / effect_of_design(counts);
  if (!(fewest <= independent && fewest <= static_cast<double>(counts.of.clusters))) return std::nullopt;
  const double one_sided = quantile(boost::math::beta_distribution<>(fewest, independent - fewest + 1), shown_power);
  return std::max(by_error, one_sided);
}

}  // namespace axiscert
