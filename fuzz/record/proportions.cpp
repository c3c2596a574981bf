#include "fuzz/record/proportions.h"

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <numeric>

#include "fuzz/record/log_factorials.h"

namespace axiscert {
namespace {

// The probability that, with `failures` failures among `trials` trials, exactly x of them fall among n of the trials.
double hypergeometric(std::uint64_t x, std::uint64_t n, std::uint64_t failures, std::uint64_t trials) {
  static thread_local LogFactorials log;
  log.start();
  for (const std::uint64_t above : {failures, trials - failures, n, trials - n}) log.add(above, 1);
  for (const std::uint64_t below : {trials, x, n - x, failures - x, trials - failures - (n - x)}) log.add(below, -1);
  return log.exp();
}

// P(at most x of the failures fall among n), for x below the mode, where each term is smaller than the one above it by
// a growing factor. The sum stops when the remainder, at most term * ratio / (1 - ratio), is no more than 2^-60 of the
// sum, or after 2^22 terms; the remainder is then added, so the result is an upper bound wherever the sum stops. A term
// is a product of up to 2^22 ratios with four roundings each (all integers here are below 2^53), and the sum has as
// many additions: together their error is below 5 * 2^22 * 2^-53 < 2.4e-9 of the sum. The factor at the end is larger
// than that.
double lower_tail(std::uint64_t x, std::uint64_t n, std::uint64_t failures, std::uint64_t trials) {
  const std::uint64_t others = trials - failures;
  double term = hypergeometric(x, n, failures, trials), sum = term;
  // The least number of failures that can fall there: all successes fall there first.
  const std::uint64_t least = n > others ? n - others : 0;
  for (std::uint64_t steps = 0; x > least; --x) {
    const double ratio = static_cast<double>(x) * static_cast<double>(others - n + x) /
                         (static_cast<double>(failures - x + 1) * static_cast<double>(n - x + 1));
    if (ratio >= 1) return 1;  // not below the mode
    term *= ratio;
    const double rest = term / (1 - ratio);  // this one and all below it
    if (rest < sum * 0x1p-60 || ++steps == (std::uint64_t{1} << 22)) {
      sum += rest;
      break;
    }
    sum += term;
  }
  return sum * (1 + 1e-8);
}

}  // namespace

double fisher_two_sided(Proportion x, Proportion y) {
  const std::uint64_t failures = x.failures + y.failures, trials = x.trials + y.trials;
  if (failures == 0 || failures == trials || x.trials == 0 || y.trials == 0) return 1;
  // The side with the smaller rate has the small tail; the comparison is by products that 128 bits hold.
  const auto cross = [](const Proportion& u, const Proportion& v) {
    return static_cast<unsigned __int128>(u.failures) * v.trials;
  };
  if (cross(x, y) > cross(y, x)) std::swap(x, y);
  return std::min(1.0, 2 * lower_tail(x.failures, x.trials, failures, trials));
}

std::vector<double> holm(const std::vector<double>& p) {
  std::vector<std::size_t> order(p.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) { return p[i] < p[j]; });
  std::vector<double> adjusted(p.size());
  double least = 0;
  for (std::size_t rank = 0; rank < order.size(); ++rank) {
    least = std::max(least, std::min(1.0, p[order[rank]] * static_cast<double>(p.size() - rank)));
    adjusted[order[rank]] = least;
  }
  return adjusted;
}

std::pair<double, double> rate_limits(Proportion x) {
  using boost::math::beta_distribution;
  const auto k = static_cast<double>(x.failures), n = static_cast<double>(x.trials);
  if (x.trials == 0) return {0, 1};
  const double low = x.failures == 0 ? 0 : quantile(beta_distribution<>(k, n - k + 1), 0.025);
  const double high = x.failures == x.trials ? 1 : quantile(beta_distribution<>(k + 1, n - k), 0.975);
  return {low, high};
}

double excluded_rate(std::uint64_t n) { return n == 0 ? 1 : -std::expm1(std::log(0.05) / static_cast<double>(n)); }

std::int64_t ClusterSums::total() const {
  std::int64_t total = 0;
  for (const auto& [sum, count] : clusters_) total += sum * static_cast<std::int64_t>(count);
  return total;
}

double ClusterSums::total_of_squares() const {
  double total = 0;
  for (const auto& [sum, count] : clusters_) {
    total += static_cast<double>(sum) * static_cast<double>(sum) * static_cast<double>(count);
  }
  return total;
}

// The variance of the total is clusters / (clusters - 1) times the sum of (cluster's sum - mean)^2, as of the total of
// clusters drawn at random.
double design_effect(const ClusteredTrials& of, const ClusterSums& sums, double variance) {
  if (of.clusters == of.trials) return 1;
  if (of.clusters < 2 || !(variance > 0)) return std::max(1.0, of.mean_size());
  const auto clusters = static_cast<double>(of.clusters), total = static_cast<double>(sums.total());
  const double squares = sums.total_of_squares() - total * total / clusters;
  return std::max(1.0, squares * clusters / (clusters - 1) / (variance * static_cast<double>(of.trials)));
}

std::optional<RateLimits> wilson_limits(const ClusteredTrials& of, const ClusterSums& failures) {
  if (of.trials == 0) return std::nullopt;
  const auto trials = static_cast<double>(of.trials);
  const double rate = static_cast<double>(failures.total()) / trials;
  if (rate == 0) return RateLimits{0, excluded_rate(of.clusters)};
  if (!of.has_limits()) return std::nullopt;
  const double n = trials / design_effect(of, failures, rate * (1 - rate));
  constexpr double z = z_of_limits;
  const double middle = rate + z * z / (2 * n);
  const double half = z * std::sqrt(rate * (1 - rate) / n + z * z / (4 * n * n));
  const double scale = 1 + z * z / n;
  return RateLimits{std::max(0.0, (middle - half) / scale), std::min(1.0, (middle + half) / scale)};
}

}  // namespace axiscert
