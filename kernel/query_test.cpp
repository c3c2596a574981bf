// Numbers and batches of as many columns as a predicate has: forty here, and the thirteen of sphere-triangle.
#include "kernel/query.h"

#include <gtest/gtest.h>

#include <cstdint>
#include <numeric>

#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

template <class Real>
class QueryNumbers : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(QueryNumbers, Reals);

// Forty numbers that no other query of a test here has.
template <class Real>
Numbers<Real> forty(std::size_t query) {
  Numbers<Real> v(40);
  std::iota(v.begin(), v.end(), static_cast<Real>(1000 * query));
  return v;
}

template <class Real>
void expect_equal(const Numbers<Real>& x, const Numbers<Real>& y) {
  EXPECT_TRUE(std::equal(x.begin(), x.end(), y.begin(), y.end()));
}

TYPED_TEST(QueryNumbers, ABatchOfFortyColumnsGivesBackWhatWasPut) {
  QueryBatch<TypeParam> batch(100, 40);
  EXPECT_EQ(batch.column_count(), 40u);
  for (std::size_t i = 0; i < 100; ++i) batch.push_back(forty<TypeParam>(i));
  const QueryColumns<TypeParam> columns = batch.columns();
  EXPECT_EQ(columns.size, 100u);
  EXPECT_EQ(columns.count, 40u);
  for (std::size_t i = 0; i < 100; ++i) {
    expect_equal(batch[i], forty<TypeParam>(i));
    EXPECT_EQ(columns.column[39][i], forty<TypeParam>(i)[39]);
  }
}

TYPED_TEST(QueryNumbers, APartOfColumnsIsWrittenAtItsPlace) {
  QueryBatch<TypeParam> batch(10, 40);
  batch.resize(10);
  const auto all = batch.mutable_columns();
  for (std::size_t i = 0; i < 10; ++i) all.set(i, forty<TypeParam>(i));
  const auto part = all.part(3, 4);
  EXPECT_EQ(part.size, 4u);
  EXPECT_EQ(part.count, 40u);
  expect_equal(part[0], forty<TypeParam>(3));
  part.set(1, forty<TypeParam>(77));
  expect_equal(batch[3], forty<TypeParam>(3));
  expect_equal(batch[4], forty<TypeParam>(77));
  expect_equal(batch[5], forty<TypeParam>(5));
}

TYPED_TEST(QueryNumbers, ColumnsDoNotCompeteForTheSameCacheLines) {
  for (const std::size_t capacity : {1, 64, 1024, 4096}) {
    QueryBatch<TypeParam> batch(capacity, 40);
    const auto columns = batch.columns();
    const auto apart =
        reinterpret_cast<std::uintptr_t>(columns.column[1]) - reinterpret_cast<std::uintptr_t>(columns.column[0]);
    EXPECT_EQ(apart / 64 % 2, 1u) << capacity;
    EXPECT_EQ(apart % 64, 0u) << capacity;
  }
}

TYPED_TEST(QueryNumbers, FillingOfOneQuery) {
  const auto filled = filled_numbers<TypeParam>(40, [](const MutableColumns<TypeParam>& one) {
    ASSERT_EQ(one.size, 1u);
    one.set(0, forty<TypeParam>(5));
  });
  expect_equal(filled, forty<TypeParam>(5));
}

TYPED_TEST(QueryNumbers, AQueryOfAPredicateConvertsBothWays) {
  const Query<TypeParam> q = {{1, 2, 3}, {4, 5, 6}, {7, 8, 9}, {10, 11, 12}, 13};
  const Numbers<TypeParam> numbers = q;
  ASSERT_EQ(numbers.size(), coordinate_count);
  EXPECT_EQ(numbers[12], 13);
  const Query<TypeParam> again = numbers;
  EXPECT_EQ(coordinates(again), coordinates(q));
  EXPECT_EQ(coordinates(query_from(numbers)), coordinates(q));
  using Other = Query<std::conditional_t<sizeof(TypeParam) == 4, double, float>>;
  static_assert(!std::is_convertible_v<Numbers<TypeParam>, Other>, "a precision does not change by itself");
}

TYPED_TEST(QueryNumbers, ACopyHasTheSameNumbers) {
  const Numbers<TypeParam> v = forty<TypeParam>(2);
  Numbers<TypeParam> copy = v;
  expect_equal(copy, v);
  copy = Numbers<TypeParam>{1, 2};
  EXPECT_EQ(copy.size(), 2u);
  EXPECT_EQ(copy[1], 2);
  EXPECT_EQ(Numbers<TypeParam>().size(), 0u);
}

}  // namespace
}  // namespace axiscert
