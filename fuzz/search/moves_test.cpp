// The moves of a search: settled queries are in the box, exactly, and steps are those of the floats.
#include "fuzz/search/moves.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/numbers/rational.h"
#include "fuzz/queries/family.h"
#include "fuzz/sphere_triangle/search_ranges.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t moves_seed = 20;

template <class Real>
class Moves : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(Moves, Reals);

Dice dice(std::uint64_t position) {
  Stream stream(moves_seed, name_hash("moves_test"), 1, Precision::binary32, position);
  return Dice(stream);
}

template <class Real>
void move(Dice& random, Query<Real>& q, const Query<Real>& other) {
  static const QueryShape shape = shape_of(sphere_triangle_predicate().entries.front());
  Numbers<Real> v = q;
  move(random, shape, v, Numbers<Real>(other));
  q = query_from(v);
}

// Computed by GMP: |a - p| <= 1.
template <class Real>
bool in_box(const Query<Real>& q) {
  const auto v = coordinates(q);
  for (std::size_t i = 0; i < 9; ++i) {
    if (abs(exact(v[i]) - exact(v[9 + i % 3])) > 1) return false;
  }
  return is_valid(q) && q.r <= 1;
}

TYPED_TEST(Moves, WhatIsWithinOneIsSoExactly) {
  using Real = TypeParam;
  Dice random = dice(0);
  int beyond = 0;
  for (int i = 0; i < 20000; ++i) {
    // Near the boundary, and with a centre that may be far below an ulp of 1.
    const auto exponent = -static_cast<int>(random.below(70));
    const Real p = std::ldexp(random.template symmetric<Real>(), exponent);
    const Real a = moved_by_ulps(Real(p + (random.coin() ? Real(1) : Real(-1))), random.integer(-2, 2));
    const bool expected = abs(exact(a) - exact(p)) <= 1;
    EXPECT_EQ(is_within_one(a, p), expected) << a << " - " << p << ", seed " << moves_seed;
    beyond += !expected;
  }
  EXPECT_GT(beyond, 2000);
}

TYPED_TEST(Moves, WhateverTheyMakeSettlesInTheBox) {
  using Real = TypeParam;
  Dice random = dice(1);
  for (const Family* family : families_of(sphere_triangle_predicate())) {
    Query<Real> q = family->make<Real>(moves_seed, 0);
    const Query<Real> other = family->make<Real>(moves_seed, 1);
    for (int i = 0; i < 2000; ++i) {
      move(random, q, other);
      settle(q);
      ASSERT_TRUE(in_box(q)) << family->name << ", move " << i << ", seed " << moves_seed;
      const auto before = coordinates(q);
      settle(q);
      ASSERT_EQ(coordinates(q), before) << "settled already; " << family->name << ", move " << i;
    }
  }
}

TYPED_TEST(Moves, UlpsAreFloatsInOrder) {
  using Real = TypeParam;
  for (const Real x : {Real(0), Real(1), Real(-1), Real(0.75), std::numeric_limits<Real>::denorm_min()}) {
    EXPECT_EQ(moved_by_ulps(x, 1), std::nextafter(x, Real(9)));
    EXPECT_EQ(moved_by_ulps(x, -1), std::nextafter(x, Real(-9)));
    EXPECT_EQ(moved_by_ulps(moved_by_ulps(x, 1000), -1000), x);
  }
}

TYPED_TEST(Moves, RepeatThemselves) {
  using Real = TypeParam;
  const auto walk = [] {
    Dice random = dice(2);
    Query<Real> q = find_family("general").make<Real>(moves_seed, 0);
    for (int i = 0; i < 1000; ++i) {
      move(random, q, q);
      settle(q);
    }
    return coordinates(q);
  };
  EXPECT_EQ(walk(), walk());
}

}  // namespace
}  // namespace axiscert
