#include "fuzz/statistics/clusters.h"

#include <algorithm>
#include <cmath>

namespace axiscert {

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
