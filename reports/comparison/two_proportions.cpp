#include "reports/comparison/two_proportions.h"

#include <mpfr.h>

#include <algorithm>
#include <boost/math/distributions/beta.hpp>
#include <cmath>
#include <numeric>

namespace axiscert {
namespace {

// log(n!) to 192 bits. For n < 2^64 it is below 2^70, so the nine logarithms of a hypergeometric probability and their
// sum together have an error below 10 * 2^(70 - 192) < 2^-118 in the logarithm.
class LogFactorials {
 public:
  LogFactorials() { mpfr_inits2(192, sum_, term_, nullptr); }
  LogFactorials(const LogFactorials&) = delete;
  ~LogFactorials() { mpfr_clears(sum_, term_, nullptr); }

  void start() { mpfr_set_zero(sum_, 1); }
  void add(std::uint64_t n, int sign) {
    mpfr_set_uj(term_, n, MPFR_RNDN);
    mpfr_add_ui(term_, term_, 1, MPFR_RNDN);
    mpfr_lngamma(term_, term_, MPFR_RNDN);
    if (sign > 0) mpfr_add(sum_, sum_, term_, MPFR_RNDN);
    else mpfr_sub(sum_, sum_, term_, MPFR_RNDN);
  }
  // exp of the sum, rounded up; at least 2^-1000, so that smaller terms, each wrong by up to 2^-1075 by underflow, are
  // together below 2^-53 of it.
  double exp() {
    mpfr_exp(term_, sum_, MPFR_RNDU);
    return std::max(mpfr_get_d(term_, MPFR_RNDU), 0x1p-1000);
  }

 private:
  mpfr_t sum_, term_;
};

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

}  // namespace axiscert
