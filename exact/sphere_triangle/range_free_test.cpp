// R-infinity by SIMD compared with MPFR, for any exponents, on every instruction set.
#include "exact/sphere_triangle/reference_batch.h"

#include <gtest/gtest.h>

#include <random>

#include "exact/sphere_triangle/unbounded.h"
#include "kernel/random_testing.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert {
namespace {

using testing_support::random_query;

// Queries of arbitrary bits, and queries scaled by any power of two, where everything below the least subnormal is
// lost; the latter include numbers of few bits and repeated vertices, so that sums end halfway between two numbers, or
// at zero.
template <class Real>
Query<Real> query_of_any_size(std::mt19937_64& random, int kind) {
  if (kind % 2 == 0) {
    Query<Real> q = random_query<Real>(random, true);
    while (!is_valid(q)) q = random_query<Real>(random, true);
    return q;
  }
  using Limits = std::numeric_limits<Real>;
  constexpr int least = Limits::min_exponent - Limits::digits, sizes = Limits::max_exponent - least;
  const int size = least + static_cast<int>(random() % sizes);
  auto v = coordinates(random_query<Real>(random, false));
  for (Real& x : v) {
    if (kind % 4 == 1) x = static_cast<Real>(static_cast<int>(random() % 15) - 7);
    x = std::ldexp(x, size);
  }
  v[12] = std::abs(v[12]);
  Query<Real> q = from_coordinates(v);
  if (kind % 8 == 5) q.b = q.a;
  return is_valid(q) ? q : query_of_any_size<Real>(random, kind);
}

template <class Real>
void expect_as_mpfr(int count) {
  constexpr int seed = 20261122;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(static_cast<std::size_t>(count), coordinate_count);
  for (int i = 0; i < count; ++i) batch.push_back(query_of_any_size<Real>(random, i));
  std::vector<ComparisonBits> found(batch.size());
  int out_of_range = 0;
  for (const Formulae formulae : {Formulae::published, Formulae::reduced}) {
    for (const Strictness strictness : {Strictness::strict, Strictness::nonstrict}) {
      std::vector<ComparisonBits> expected;
      for (std::size_t i = 0; i < batch.size(); ++i) {
        expected.push_back(*unbounded_by_mpfr(formulae, Arithmetic::plain, strictness, query_from(batch[i])).bits);
        out_of_range += expected[i] != *reference(formulae, Arithmetic::plain, strictness, query_from(batch[i])).bits;
      }
      for (const std::string& target : simd_targets()) {
        range_free_on<Real>(target, formulae, strictness)(batch.columns(), found.data());
        for (std::size_t i = 0; i < batch.size(); ++i) {
          ASSERT_EQ(found[i], expected[i]) << target << " " << name(formulae) << " query " << i;
        }
      }
    }
  }
  EXPECT_GT(out_of_range, count) << "of four times as many, these tell R-infinity from R";
}

TEST(RangeFree, IsMpfrInBinary32) { expect_as_mpfr<float>(2003); }
TEST(RangeFree, IsMpfrInBinary64) { expect_as_mpfr<double>(2003); }
TEST(RangeFreeLong, IsMpfr) {
  expect_as_mpfr<float>(60001);
  expect_as_mpfr<double>(60001);
}

TEST(RangeFree, HasNoFormOfOtherFormulae) {
  const std::string& target = simd_targets().front();
  EXPECT_EQ(range_free_on<float>(target, Formulae::ladder_0, Strictness::strict), nullptr);
  EXPECT_EQ(range_free_on<double>(target, Formulae::published, Strictness::not_less), nullptr);
}

}  // namespace
}  // namespace axiscert
