// The moves of the kernel target: their promises about numbers, bytes and seeds.
#include "fuzz/targets/query_moves.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <map>
#include <set>

namespace axiscert::fuzzing {
namespace {

constexpr std::uint64_t moves_seed = 20;

Dice dice_of(std::uint64_t position) {
  Stream stream(moves_seed, name_hash("query-moves-test"), 1, Precision::binary32, position);
  return Dice(stream);
}

FuzzedQuery usual(Precision precision) {
  const Query<double> q = from_coordinates<double>({0.25, 1, -3, 2, 0.5, 1, -1, 4, 0.75, 1, 1, 2, 0.5});
  FuzzedQuery fuzzed{3, q};
  if (precision == Precision::binary32) change_precision(fuzzed);
  return fuzzed;
}

TEST(FuzzedQuery, IsWhatItsBytesSayInBothPrecisions) {
  for (const Precision precision : {Precision::binary32, Precision::binary64}) {
    const FuzzedQuery fuzzed = usual(precision);
    const auto bytes = bytes_of(fuzzed);
    EXPECT_EQ(bytes.size(), precision == Precision::binary32 ? 54u : 106u);
    EXPECT_EQ(fuzzed_query(bytes).query.index(), index_of(precision));
    EXPECT_EQ(bytes_of(fuzzed_query(bytes)), bytes);
  }
}

TEST(FuzzedQuery, IsMadeOfBytesOfAnyNumber) {
  const auto bytes = bytes_of(usual(Precision::binary64));
  for (std::size_t size = 0; size <= bytes.size(); ++size) {
    // On the heap and of this size, so that a sanitized build sees a read beyond it.
    const std::vector<std::uint8_t> part(bytes.begin(), bytes.begin() + static_cast<std::ptrdiff_t>(size));
    const auto again = bytes_of(fuzzed_query(part));
    if (size >= 2) {
      ASSERT_GE(again.size(), part.size());
      EXPECT_TRUE(std::equal(part.begin(), part.end(), again.begin()));
    }
  }
}

TEST(QueryMoves, DependOnTheSeedAlone) {
  std::set<std::vector<std::uint8_t>> found;
  for (std::uint32_t s = 0; s < 200; ++s) {
    FuzzedQuery one = usual(Precision::binary32), two = one;
    mutate(one, s);
    mutate(two, s);
    EXPECT_EQ(bytes_of(one), bytes_of(two)) << "seed " << s;
    found.insert(bytes_of(one));
  }
  EXPECT_GT(found.size(), 150u) << "different seeds make the same query";
}

// The number of coordinates whose bits a move leaves unchanged.
template <class Real>
std::size_t kept(const FuzzedQuery& before, const FuzzedQuery& after) {
  const auto x = coordinates(std::get<Query<Real>>(before.query)), y = coordinates(std::get<Query<Real>>(after.query));
  std::size_t same = 0;
  for (std::size_t k = 0; k < coordinate_count; ++k) same += std::memcmp(&x[k], &y[k], sizeof(Real)) == 0;
  return same;
}

template <class Real>
class QueryMoveTest : public testing::Test {};
using Precisions = testing::Types<float, double>;
TYPED_TEST_SUITE(QueryMoveTest, Precisions);

TYPED_TEST(QueryMoveTest, EachChangesTheQueryAndNoMoreOfItThanItSays) {
  const FuzzedQuery before = usual(precision_of<TypeParam>);
  const std::map<QueryMove, std::size_t> least_kept = {
      {QueryMove::ulps, 12},   {QueryMove::special, 12}, {QueryMove::copy, 12},
      {QueryMove::repeat, 10}, {QueryMove::swap, 5},     {QueryMove::tie, 12},
      {QueryMove::sign, 1},    {QueryMove::exponent, 0}, {QueryMove::kernel, 13}};
  for (const auto& [move, least] : least_kept) {
    int changes = 0;
    for (std::uint64_t position = 0; position < 200; ++position) {
      FuzzedQuery after = before;
      Dice dice = dice_of(position);
      apply(move, dice, after);
      ASSERT_EQ(after.query.index(), before.query.index());
      EXPECT_GE(kept<TypeParam>(before, after), least)
          << query_move_names[move] << ", seed " << moves_seed << ", position " << position;
      changes += bytes_of(after) != bytes_of(before);
    }
    EXPECT_GT(changes, 50) << query_move_names[move];
  }
}

TYPED_TEST(QueryMoveTest, SpecialNumbersAreAllReached) {
  using Limits = std::numeric_limits<TypeParam>;
  bool nan = false, infinite = false, zero = false, negative_zero = false, least = false, greatest_subnormal = false;
  for (std::uint64_t position = 0; position < 5000; ++position) {
    FuzzedQuery fuzzed = usual(precision_of<TypeParam>);
    Dice dice = dice_of(position);
    apply(QueryMove::special, dice, fuzzed);
    for (const TypeParam x : coordinates(std::get<Query<TypeParam>>(fuzzed.query))) {
      nan |= std::isnan(x);
      infinite |= std::isinf(x);
      zero |= x == 0 && !std::signbit(x);
      negative_zero |= x == 0 && std::signbit(x);
      least |= std::fabs(x) == Limits::denorm_min();
      greatest_subnormal |= std::fabs(x) == Limits::min() - Limits::denorm_min();
    }
  }
  EXPECT_TRUE(nan && infinite && zero && negative_zero && least && greatest_subnormal)
      << nan << infinite << zero << negative_zero << least << greatest_subnormal << " of seed " << moves_seed;
}

TYPED_TEST(QueryMoveTest, TiesBringTheSphereToWhereItTouches) {
  // The triangle is in the plane z = 0, with the centre 2 above it: both the tie of plane.radius and the distance are
  // at r = 2.
  const auto flat = from_coordinates<TypeParam>({-9, -9, 0, 9, -9, 0, 0, 9, 0, 0, 0, 2, 7});
  int touching = 0;
  for (std::uint64_t position = 0; position < 400; ++position) {
    FuzzedQuery fuzzed{0, flat};
    Dice dice = dice_of(position);
    apply(QueryMove::tie, dice, fuzzed);
    touching += std::get<Query<TypeParam>>(fuzzed.query).r == 2;
  }
  EXPECT_GT(touching, 20) << "seed " << moves_seed;
}

TEST(QueryMoves, TakeNumbersOfEveryKind) {
  std::vector<std::uint8_t> bytes(greatest_size, 0xff);  // NaNs
  for (const int fill : {0x00, 0x7f, 0x80, 0xff}) {
    for (const int wide : {0, 1}) {
      std::fill(bytes.begin(), bytes.end(), static_cast<std::uint8_t>(fill));
      bytes[0] = static_cast<std::uint8_t>(wide);
      for (std::uint32_t s = 0; s < 300; ++s) {
        FuzzedQuery fuzzed = fuzzed_query(bytes);
        mutate(fuzzed, s);
        EXPECT_LE(bytes_of(fuzzed).size(), greatest_size);
      }
    }
  }
}

TEST(QueryMoves, CrossingTakesEachNumberFromOneOfTheTwo) {
  FuzzedQuery other = usual(Precision::binary64);
  for (double* x : {&std::get<Query<double>>(other.query).a.x, &std::get<Query<double>>(other.query).r}) *x += 64;
  bool first = false, second = false;
  for (std::uint32_t s = 0; s < 50; ++s) {
    FuzzedQuery crossed = usual(Precision::binary32);
    cross(crossed, other, s);
    ASSERT_EQ(crossed.query.index(), 0u) << "the first one's precision";
    const float r = std::get<Query<float>>(crossed.query).r;
    EXPECT_TRUE(r == 0.5f || r == 64.5f) << r;
    first |= r == 0.5f;
    second |= r == 64.5f;
  }
  EXPECT_TRUE(first && second);
}

}  // namespace
}  // namespace axiscert::fuzzing
