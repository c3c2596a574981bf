// The filter compared with exact arithmetic: whatever it calls certain is true, on every instruction set; and it
// decides enough.
#include "exact/sphere_triangle/oracles/lane_filter.h"

#include <gtest/gtest.h>

#include <limits>
#include <random>

#include "exact/judge/side_error.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "kernel/sphere_triangle/forms/simd.h"
#include "kernel/random_testing.h"

namespace axiscert {
namespace {

using testing_support::coarse_query;
using testing_support::random_query;

template <class Real>
QueryBatch<Real> mixed_batch(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(count, coordinate_count);
  for (std::size_t i = 0; i < count; ++i) {
    const int exponent = static_cast<int>(random() % 41) - 20;
    batch.push_back(i % 3 == 0 ? coarse_query<Real>(random, exponent) : random_query<Real>(random, i % 3 == 1));
  }
  return batch;
}

// A batch without unusual queries, so that whole vectors take the first pass; with sizes up to both ends of binary64's
// range.
template <class Real>
QueryBatch<Real> ordinary_batch(std::uint64_t seed, std::size_t count) {
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(count, coordinate_count);
  for (std::size_t i = 0; i < count; ++i) {
    auto v = coordinates(random_query<Real>(random, false));
    v[12] = std::abs(v[12]);
    const int exponent = i / 64 % 3 == 0 ? 0 : static_cast<int>(i / 64 % 240) - 120;
    for (Real& x : v) x = std::ldexp(x, exponent);
    batch.push_back(from_coordinates(v));
  }
  return batch;
}

template <class Real>
class FilterTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(FilterTest, Reals);

// Compares signs on every target and checks the share of valid queries that are decided and the number with ties.
template <class Real>
void expect_exact(const QueryBatch<Real>& batch, double least_decided, std::size_t least_ties) {
  std::vector<Signs> exact(batch.size());
  for (std::size_t i = 0; i < batch.size(); ++i) {
    if (!is_valid(query_from(batch[i]))) continue;
    exact[i] = signs_of(exact_sides(query_from(batch[i])));
  }
  for (const std::string& target : simd_targets()) {
    std::vector<FilteredSigns> found(batch.size());
    filter_on<Real>(target).signs(batch.columns(), found.data());
    std::size_t decided = 0, ties = 0, valid = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_EQ(found[i].is_valid, is_valid(query_from(batch[i]))) << target << " query " << i;
      if (!found[i].is_valid) continue;
      ++valid;
      decided += found[i].is_decided();
      ties += found[i].is_decided() && found[i].signs.ties != 0;
      ASSERT_EQ(found[i].signs.strict, exact[i].strict & found[i].certain) << target << " query " << i;
      ASSERT_EQ(found[i].signs.ties, exact[i].ties & found[i].certain) << target << " query " << i;
    }
    EXPECT_GT(static_cast<double>(decided), static_cast<double>(valid) * least_decided) << target;
    EXPECT_GE(ties, least_ties) << target;
  }
}

TYPED_TEST(FilterTest, WhatItCallsCertainIsExact) {
  constexpr std::uint64_t seed = 20261121;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  expect_exact(mixed_batch<TypeParam>(seed, 6001), 0.25, 100);
}

TYPED_TEST(FilterTest, WhatTheFirstPassCallsCertainIsExact) {
  constexpr std::uint64_t seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  expect_exact(ordinary_batch<TypeParam>(seed, 240 * 64 + 5), 0.8, 0);
}

// Errors of the published sides as computed, compared with exact ones: no query that passes the screen exceeds the
// threshold, and the intervals of the others contain the exact error.
TYPED_TEST(FilterTest, ErrorsArePassedOverRightly) {
  constexpr std::uint64_t seed = 7;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  const auto batch = mixed_batch<TypeParam>(seed, 2003);
  for (const char* id : {"published", "reduced"}) {
    const Kernel& kernel = find_kernel(id);
    Answers<TypeParam> computed;
    computed.resize(batch.size(), comparison_count);
    kernel.on<TypeParam>(simd_targets().front()).explain(batch.columns(), computed);
    for (const std::string& target : simd_targets()) {
      std::vector<SuspectError> suspects;
      ErrorThresholds thresholds;
      thresholds.fill(4);
      filter_on<TypeParam>(target).errors(batch.columns(), computed, id == std::string_view("reduced"), thresholds,
                                          suspects);
      std::vector<std::array<const SuspectError*, comparison_count>> by_query(batch.size());
      for (const SuspectError& suspect : suspects) by_query[suspect.query][suspect.comparison] = &suspect;
      std::size_t passed = 0;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        if (!is_valid(query_from(batch[i]))) continue;
        const ExactSides truth = exact_sides(formulae_of(kernel), query_from(batch[i]));
        for (std::size_t k = 0; k < comparison_count; ++k) {
          const SideError error(computed.lhs[k][i], computed.rhs[k][i], truth.comparison(k));
          const SuspectError* suspect = by_query[i][k];
          passed += suspect == nullptr;
          const auto where = testing::Message() << id << " " << target << " query " << i << " " << comparisons[k].name;
          if (error.kind() != SideError::Kind::finite) {
            ASSERT_TRUE(suspect && suspect->upper == std::numeric_limits<double>::infinity()) << where;
            continue;
          }
          if (!suspect) {
            ASSERT_FALSE(error.exceeds(Rational(4))) << where;
            continue;
          }
          const Decimal6 exact = error.rounded_up();
          ASSERT_GE(suspect->upper * (1 + 2e-5), exact.value()) << where;
          ASSERT_LE(suspect->lower, exact.value() * (1 + 1e-14)) << where;
        }
      }
      EXPECT_GT(passed, batch.size() * 4);
    }
  }
}

}  // namespace
}  // namespace axiscert
