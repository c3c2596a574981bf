// Clustered and paired tests, against exact integers, published examples and their definitions; effects that are
// planted, and none.
#include "fuzz/record/paired.h"

#include <gmpxx.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace axiscert {
namespace {

ClusterSums sums_of(const std::vector<int>& sums) {
  ClusterSums all;
  for (const int sum : sums) all.add(sum);
  return all;
}

PairedCounts independent(std::uint64_t only_from, std::uint64_t only_to, std::uint64_t trials) {
  PairedCounts counts{{trials, trials}, only_from, only_to, {}};
  for (std::uint64_t i = 0; i < only_from; ++i) counts.sums.add(-1);
  for (std::uint64_t i = 0; i < only_to; ++i) counts.sums.add(1);
  return counts;
}

double exact_binomial(std::uint64_t b, std::uint64_t c) {
  mpz_class tail = 0, ways;
  for (std::uint64_t k = 0; k <= std::min(b, c); ++k) {
    mpz_bin_uiui(ways.get_mpz_t(), b + c, k);
    tail += ways;
  }
  mpq_class p(2 * tail, mpz_class(1) << (b + c));
  p.canonicalize();
  return std::min(1.0, p.get_d());
}

void expect_just_above(double p, double exact) {
  EXPECT_GE(p, exact * (1 - 1e-15));
  EXPECT_LE(p, std::min(1.0, exact * (1 + 2e-7)));
}

TEST(Paired, McNemarsTestIsTheBinomialOne) {
  for (std::uint64_t b = 0; b < 12; ++b) {
    for (std::uint64_t c = 0; c < 40; c += 3) {
      expect_just_above(mcnemar_two_sided(b, c).value, exact_binomial(b, c));
      EXPECT_EQ(mcnemar_two_sided(b, c).value, sign_flip_two_sided(independent(b, c, 1000).sums).value);
    }
  }
  expect_just_above(mcnemar_two_sided(4100, 3900).value, exact_binomial(4100, 3900));
  EXPECT_DOUBLE_EQ(mcnemar_two_sided(0, 6).value, 0.03125 * (1 + 1e-7));
  EXPECT_EQ(mcnemar_two_sided(0, 5000).value, 0x1p-990) << "no probability is 0";
}

// Agresti, Categorical Data Analysis (2002), table 10.1: approval of a prime minister, asked twice; z^2 = 17.36, the
// difference -0.040 with Wald's limits (-0.059, -0.021).
TEST(Paired, ThePrimeMinistersApproval) {
  const PairedCounts counts = independent(150, 86, 1600);
  EXPECT_NEAR(mcnemar_two_sided(150, 86).value, std::erfc(std::sqrt(17.36 / 2)), 2e-5);
  const auto difference = rate_difference(counts);
  EXPECT_DOUBLE_EQ(difference->value, -0.04);
  EXPECT_EQ(difference->design_effect, 1);
  EXPECT_NEAR(difference->limits->low, -0.059, 6e-4);
  EXPECT_NEAR(difference->limits->high, -0.021, 6e-4);
}

// Every assignment of signs, one after the other.
double exact_by_enumeration(const std::vector<int>& sums) {
  int observed = 0;
  for (const int sum : sums) observed += sum;
  std::uint64_t as_far = 0;
  for (std::uint64_t signs = 0; signs < std::uint64_t{1} << sums.size(); ++signs) {
    int total = 0;
    for (std::size_t i = 0; i < sums.size(); ++i) total += signs >> i & 1 ? sums[i] : -sums[i];
    as_far += std::abs(total) >= std::abs(observed);
  }
  return static_cast<double>(as_far) / std::ldexp(1.0, static_cast<int>(sums.size()));
}

TEST(Paired, SignFlipsCountEveryAssignmentOfSigns) {
  std::mt19937_64 random(3);  // seed 3
  for (int i = 0; i < 300; ++i) {
    std::vector<int> sums(1 + random() % 13);
    for (int& sum : sums) sum = static_cast<int>(random() % 13) - 5;
    expect_just_above(sign_flip_two_sided(sums_of(sums)).value, exact_by_enumeration(sums));
  }
}

TEST(Paired, WhatIsTooLongToCountIsBoundedFromAbove) {
  ClusterSums sums;
  for (int i = 0; i < 3000; ++i) {
    for (int size = 1; size <= 9; ++size) sums.add(i % 100 < 52 ? size : -size);
  }
  const Probability bound = sign_flip_two_sided(sums);
  ASSERT_TRUE(bound.is_bound);
  const double z = static_cast<double>(sums.total()) / std::sqrt(sums.total_of_squares());
  EXPECT_GT(bound.value, std::erfc(z / std::sqrt(2.0))) << "the normal approximation";
  EXPECT_LT(bound.value, 1);
}

// Ten queries of each of 40 triangles: ten copies of one answer are one answer.
TEST(Paired, ClustersThatAgreeCountOnce) {
  PairedCounts copies{{400, 40}, 0, 60, {}}, alone = independent(0, 6, 40);
  for (int i = 0; i < 6; ++i) copies.sums.add(10);
  EXPECT_EQ(sign_flip_two_sided(copies.sums).value, sign_flip_two_sided(alone.sums).value);
  EXPECT_LT(mcnemar_two_sided(0, 60).value, 1e-17) << "what counting queries would claim";
  const auto difference = rate_difference(copies), of_alone = rate_difference(alone);
  EXPECT_NEAR(difference->design_effect, 10, 0.5);
  EXPECT_NEAR(difference->value, of_alone->value, 1e-15);
  EXPECT_NEAR(difference->limits->low, of_alone->limits->low, 0.005);
  EXPECT_NEAR(difference->limits->high, of_alone->limits->high, 0.005);
}

// Two triangles asked 4,096 times: no outcome has p below 1/2, and there is no interval to claim. 19 clusters are too
// few too, 20 are not, and as many clusters as trials always have limits.
TEST(Paired, FewClustersHaveNoLimitsAndNoLeastDifference) {
  const auto with = [](std::uint64_t trials, std::uint64_t clusters) {
    PairedCounts counts{{trials, clusters}, 0, 18, {}};
    for (int i = 0; i < 2; ++i) counts.sums.add(9);
    return counts;
  };
  EXPECT_EQ(sign_flip_two_sided(with(4096, 2).sums).value, 0.5 * (1 + 1e-7));
  for (const std::uint64_t clusters : {2, 19}) {
    EXPECT_FALSE(rate_difference(with(4096, clusters))->limits) << clusters;
    EXPECT_FALSE(wilson_limits({4096, clusters}, with(4096, clusters).sums)) << clusters;
    EXPECT_TRUE(wilson_limits({4096, clusters}, {})) << "without a failure " << clusters << " clusters exclude a rate";
  }
  EXPECT_FALSE(least_difference(with(4096, 2), 0.05));
  EXPECT_TRUE(rate_difference(with(4096, 20))->limits);
  EXPECT_TRUE(rate_difference(independent(0, 2, 14))->limits);
}

// At a limit the score is the normal quantile, with the nuisance rate found by a search for the greatest likelihood.
TEST(Paired, TangosLimitsAreWhereTheScoreIsTheQuantile) {
  const auto score_at = [](double b, double c, double n, double d) {
    double low = std::max(0.0, -d), high = (1 - d) / 2;
    const auto likelihood = [&](double q) {
      return (b == 0 ? 0 : b * std::log(q + d)) + (c == 0 ? 0 : c * std::log(q)) + (n - b - c) * std::log1p(-2 * q - d);
    };
    for (int i = 0; i < 200; ++i) {
      const double first = low + (high - low) / 3, second = high - (high - low) / 3;
      (likelihood(first) < likelihood(second) ? low : high) = likelihood(first) < likelihood(second) ? first : second;
    }
    const double q = (low + high) / 2;
    return (b - c - n * d) / std::sqrt(n * (2 * q + d - d * d));
  };
  for (const auto& [c, b, n] : {std::array<std::uint64_t, 3>{2, 12, 50}, {1, 7, 14}, {150, 86, 1600}, {3, 0, 90}}) {
    const RateLimits limits = *rate_difference(independent(c, b, n))->limits;
    const auto x = static_cast<double>(b), y = static_cast<double>(c), all = static_cast<double>(n);
    EXPECT_NEAR(score_at(x, y, all, limits.low), 1.96, 1e-3) << b << " " << c << " " << n;
    EXPECT_NEAR(score_at(x, y, all, limits.high), -1.96, 1e-3) << b << " " << c << " " << n;
  }
  const RateLimits none = *rate_difference(independent(0, 0, 1000))->limits;
  EXPECT_NEAR(none.high, 3.8415 / 1003.8415, 1e-6) << "z^2 / (n + z^2)";
  EXPECT_NEAR(none.low, -none.high, 1e-12);
  EXPECT_FALSE(rate_difference({}));
}

// Newcombe, Stat. Med. 17 (1998), p. 857, method 3.
TEST(Clusters, WilsonsLimitsAreThePublishedOnes) {
  struct {
    std::uint64_t failures, trials;
    double low, high;
  } const published[] = {{81, 263, 0.2553, 0.3662}, {15, 148, 0.0624, 0.1605}, {1, 29, 0.0061, 0.1718}};
  for (const auto& [failures, trials, low, high] : published) {
    const auto limits = wilson_limits({trials, trials}, independent(0, failures, trials).sums);
    EXPECT_NEAR(limits->low, low, 5e-5);
    EXPECT_NEAR(limits->high, high, 5e-5);
  }
  EXPECT_NEAR(wilson_limits({600, 100}, {})->high, 1 - std::pow(0.05, 0.01), 1e-12) << "of 100 clusters";
  EXPECT_FALSE(wilson_limits({}, {}));
}

// Six comparisons of a query that fail together are one failure: the limits are those of 100 trials.
TEST(Clusters, WilsonsLimitsOfClustersThatFailTogether) {
  ClusterSums together;
  for (int i = 0; i < 20; ++i) together.add(6);
  const auto limits = wilson_limits({600, 100}, together);
  const auto alone = wilson_limits({100, 100}, independent(0, 20, 100).sums);
  EXPECT_NEAR(limits->low, alone->low, 2e-3);
  EXPECT_NEAR(limits->high, alone->high, 2e-3);
}

// The exact rate of rejection: the sum over all outcomes of b + c differing trials.
double rejected(std::uint64_t differing, double share_of_to, double level) {
  double sum = 0;
  for (std::uint64_t b = 0; b <= differing; ++b) {
    if (mcnemar_two_sided(differing - b, b).value > level) continue;
    const auto n = static_cast<double>(differing), k = static_cast<double>(b);
    sum += std::exp(std::lgamma(n + 1) - std::lgamma(k + 1) - std::lgamma(n - k + 1) + k * std::log(share_of_to) +
                    (n - k) * std::log1p(-share_of_to));
  }
  return sum;
}

TEST(Paired, NoEffectIsSignificantNoMoreOftenThanTheLevel) {
  for (const std::uint64_t differing : {5u, 17u, 60u, 300u, 1000u}) {
    for (const double level : {0.05, 0.01, 0.001}) EXPECT_LE(rejected(differing, 0.5, level), level) << differing;
  }
}

// With 8 % of 2,000 trials differing at 0, the least difference is found as often as stated, within the approximation.
TEST(Paired, TheLeastDifferenceIsFoundWithTheStatedPower) {
  const std::uint64_t trials = 2000, differing = 160;
  const double least = *least_difference(independent(80, 80, trials), 0.05);
  const auto share = [&](double difference) {
    return (1 + difference * static_cast<double>(trials) / static_cast<double>(differing)) / 2;
  };
  EXPECT_NEAR(rejected(differing, share(least), 0.05), shown_power, 0.05);
  EXPECT_GT(rejected(differing, share(0.05), 0.05), 0.99) << "a planted difference of 5 %";
  EXPECT_LT(least, 0.05);
}

// Without a trial that differs: 6 on one side are the fewest that 5 % allow (2 * 2^-6), and that many come with 80 %.
TEST(Paired, WithoutADifferenceTheLeastOneIsOfTheExactTest) {
  const double least = *least_difference(independent(0, 0, 100), 0.05);
  double fewer = 0;
  for (int k = 0; k < 6; ++k) {
    fewer += std::exp(std::lgamma(101) - std::lgamma(k + 1) - std::lgamma(101 - k)) * std::pow(least, k) *
             std::pow(1 - least, 100 - k);
  }
  EXPECT_NEAR(1 - fewer, 0.8, 1e-9);
  EXPECT_FALSE(least_difference(independent(0, 0, 5), 0.05)) << "5 trials show nothing";
}

// Planted in simulated clusters: one form fails in whole triangles, now as often as the other, now 5 % more often.
TEST(Paired, ClustersOfAPlantedEffect) {
  constexpr std::uint64_t seed = 11;
  std::mt19937_64 random(seed);
  const auto found = [&](double effect) {
    int significant = 0;
    for (int run = 0; run < 200; ++run) {
      PairedCounts counts{{4000, 1000}, 0, 0, {}};
      for (int cluster = 0; cluster < 1000; ++cluster) {
        const double u = static_cast<double>(random() >> 11) * 0x1p-53;
        const int size = 1 + static_cast<int>(random() % 4);
        if (u < 0.04 + effect) counts.sums.add(size);
        else if (u > 0.96) counts.sums.add(-size);
      }
      significant += sign_flip_two_sided(counts.sums).value <= 0.05;
    }
    return significant;
  };
  EXPECT_LE(found(0), 20) << "of 200 at 5 %, seed " << seed;
  EXPECT_GE(found(0.05), 190) << "of 200, seed " << seed;
}

}  // namespace
}  // namespace axiscert
