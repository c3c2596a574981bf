// Fisher's and Holm's tests and the limits of rates, against exact rationals and against their definitions.
#include "fuzz/record/proportions.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace axiscert {
namespace {

mpz_class choose(std::uint64_t n, std::uint64_t k) {
  mpz_class result;
  mpz_bin_uiui(result.get_mpz_t(), n, k);
  return result;
}

// Twice the smaller tail, computed in integers.
double exact_fisher(Proportion x, Proportion y) {
  const std::uint64_t failures = x.failures + y.failures, trials = x.trials + y.trials;
  mpz_class low = 0, high = 0;
  for (std::uint64_t i = 0; i <= std::min(failures, x.trials); ++i) {
    if (failures - i > y.trials) continue;
    const mpz_class ways = choose(x.trials, i) * choose(y.trials, failures - i);
    if (i <= x.failures) low += ways;
    if (i >= x.failures) high += ways;
  }
  mpq_class p(2 * std::min(low, high), choose(trials, failures));
  p.canonicalize();
  return std::min(1.0, p.get_d());
}

void expect_just_above(double p, double exact, Proportion x, Proportion y) {
  EXPECT_GE(p, exact * (1 - 1e-15)) << x.failures << "/" << x.trials << " " << y.failures << "/" << y.trials;
  if (exact < 0.5) {
    EXPECT_LE(p, exact * (1 + 1e-6)) << x.failures << "/" << x.trials << " " << y.failures << "/" << y.trials;
  }
}

TEST(TwoProportions, EverySmallTableIsFishersToSixDigitsAndNeverBelow) {
  for (std::uint64_t n = 1; n <= 5; ++n) {
    for (std::uint64_t m = 1; m <= 6; ++m) {
      for (std::uint64_t i = 0; i <= n; ++i) {
        for (std::uint64_t j = 0; j <= m; ++j) {
          expect_just_above(fisher_two_sided({i, n}, {j, m}), exact_fisher({i, n}, {j, m}), {i, n}, {j, m});
        }
      }
    }
  }
}

TEST(TwoProportions, LargeTablesToo) {
  std::mt19937_64 random(1);  // seed 1
  for (int i = 0; i < 60; ++i) {
    const std::uint64_t n = 1 + random() % 4000, m = 1 + random() % 4000;
    const Proportion x{random() % (std::min<std::uint64_t>(n, 150) + 1), n};
    const Proportion y{random() % (std::min<std::uint64_t>(m, 150) + 1), m};
    expect_just_above(fisher_two_sided(x, y), exact_fisher(x, y), x, y);
  }
}

TEST(TwoProportions, CountsOfAWholeCampaign) {
  // Twice 2^20 trials: three failures fall all on one side with the probability 2 * 2^-3.
  EXPECT_NEAR(fisher_two_sided({0, 1 << 20}, {3, 1 << 20}), 0.25, 1e-5);
  EXPECT_LT(fisher_two_sided({100'000, 1'000'000'000}, {102'000, 1'000'000'000}), 1e-5);
  EXPECT_GT(fisher_two_sided({100'000, 1'000'000'000}, {100'300, 1'000'000'000}), 0.4);
  EXPECT_GT(fisher_two_sided({0, 1'000'000'000}, {1'000'000'000, 1'000'000'000}), 0);
  EXPECT_EQ(fisher_two_sided({0, 10}, {0, 0}), 1);
}

TEST(TwoProportions, HolmMultipliesTheSmallestByAllAndNeverDescends) {
  const std::vector<double> adjusted = holm({0.01, 0.04, 0.03, 0.005, 0.9});
  const std::vector<double> expected = {0.04, 0.09, 0.09, 0.025, 0.9};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(adjusted[i], expected[i], 1e-15) << i;
  EXPECT_EQ(holm({1, 1}), (std::vector<double>{1, 1}));
  EXPECT_TRUE(holm({}).empty());
}

// By definition, at each limit the observed count or a more extreme one has the probability 2.5 %.
TEST(TwoProportions, LimitsAreClopperAndPearsons) {
  const auto at_least = [](std::uint64_t k, std::uint64_t n, double p) {
    double sum = 0;
    for (std::uint64_t i = k; i <= n; ++i) {
      sum += choose(n, i).get_d() * std::pow(p, static_cast<double>(i)) * std::pow(1 - p, static_cast<double>(n - i));
    }
    return sum;
  };
  for (const Proportion x : {Proportion{1, 10}, {3, 40}, {20, 40}, {39, 40}}) {
    const auto [low, high] = rate_limits(x);
    EXPECT_NEAR(at_least(x.failures, x.trials, low), 0.025, 1e-9);
    EXPECT_NEAR(1 - at_least(x.failures + 1, x.trials, high), 0.025, 1e-9);
  }
  EXPECT_EQ(rate_limits({0, 5}).first, 0);
  EXPECT_NEAR(rate_limits({0, 100}).second, 1 - std::pow(0.025, 0.01), 1e-12);
  EXPECT_EQ(rate_limits({5, 5}).second, 1);
  EXPECT_EQ(rate_limits({0, 0}), (std::pair<double, double>{0, 1}));
}

}  // namespace
}  // namespace axiscert
