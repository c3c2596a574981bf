// The certified predicate at the edges of its last steps, compared with CGAL's distance: where the exact step takes
// longer integers, and where scaling would lose a bit. A step that goes one bit too far is wrong on these, and on
// hardly any other query.
#include <gtest/gtest.h>

#include <random>
#include <vector>

#include "exact/sphere_triangle/certified_edge_queries.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

using testing_support::beside_an_edge_query, testing_support::losing_query, testing_support::turned,
    testing_support::widest_query;

constexpr std::uint64_t edges_seed = 94126;

int expected_at(int order, axiscert_question question) {
  const bool is_open = question == AXISCERT_OPEN_SPHERE || question == AXISCERT_OPEN_EXACT_ONLY;
  return (is_open ? order < 0 : order <= 0) ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
}

// Asks all four exact questions, one pair and in a batch, and the closed one on every instruction set. `counts`: of the
// orders.
void expect_exact(const std::vector<Query<double>>& queries, int (&counts)[3]) {
  QueryBatch<double> batch(queries.size(), coordinate_count);
  std::vector<int> order;
  for (const Query<double>& q : queries) {
    batch.push_back(q);
    order.push_back(distance_order(q));
    ++counts[order.back() + 1];
  }
  const QueryColumns<double> columns = batch.columns();
  std::array<const double*, coordinate_count> pointers;
  std::copy_n(columns.column.begin(), coordinate_count, pointers.begin());
  const auto at = [&](std::size_t i) { return testing::PrintToString(coordinates(queries[i])); };
  for (const axiscert_question question :
       {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE, AXISCERT_EXACT_ONLY, AXISCERT_OPEN_EXACT_ONLY}) {
    std::vector<std::uint8_t> found(queries.size());
    certified::pairs(pointers, queries.size(), question, {found.data(), nullptr, nullptr});
    for (std::size_t i = 0; i < queries.size(); ++i) {
      const auto v = coordinates(queries[i]);
      ASSERT_EQ(found[i], expected_at(order[i], question))
          << "question " << question << ", query " << i << ": " << at(i);
      ASSERT_EQ(certified::pair(v.data(), v.data() + 9, question), found[i])
          << "question " << question << ": " << at(i);
    }
  }
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(queries.size());
    find_kernel("certified").on<double>(target).verdicts(columns, found.data());
    for (std::size_t i = 0; i < queries.size(); ++i) {
      ASSERT_EQ(static_cast<int>(found[i]), expected_at(order[i], AXISCERT_CLOSED_SPHERE)) << target << ": " << at(i);
    }
  }
}

// Each of these tells one changed token of the steps: integers of 94 bits for numbers of 95, of 126 for 127, and a
// number that is not zero taken for one that lost no bit.
TEST(CertifiedEdges, WhereOneTokenWasOnceWrong) {
  constexpr double wide = 0x1p94 - 0x1p41, wider = 0x1p126 - 0x1p73, edge = 0x1.fffffffffffffp+125;
  constexpr double t = ((1 << 27) + 3) * 0x1p-577, K = 0x1p498, G = 0x1p500;
  const std::vector<Query<double>> witnesses = {
      {{wide, wide, wide}, {wide, wide, wide}, {wide, wide, wide}, {-wide, -wide, -wide}, 1},
      {{wider, wider, wider}, {wider, wider, wider}, {wider, wider, wider}, {-wider, -wider, -wider}, 1},
      {{-edge, -edge, -edge},
       {edge, edge, edge},
       {-0x1.48949cp+63, -0x1.851f7p+62, 0x1.05922ap+64},
       {0x1.48949cp+23, 0x1.851f7p+22, -0x1.05922ap+24},
       0x1.43d7c5p+24},
      {{3 * t, -t, G}, {-3 * K, K, -G}, {3 * K, -K, -G}, {0, 0, 0}, 0}};
  const int orders[] = {1, 1, -1, 0};
  for (std::size_t i = 0; i < witnesses.size(); ++i) EXPECT_EQ(distance_order(witnesses[i]), orders[i]) << i;
  std::mt19937_64 random(edges_seed);
  std::vector<Query<double>> queries;
  for (const Query<double>& q : witnesses) {
    queries.push_back(q);
    for (int i = 0; i < 30; ++i) queries.push_back(turned(q, random));
  }
  int counts[3] = {};
  expect_exact(queries, counts);
}

// Numbers of n bits with a sign, n to both sides of each size of integers: 30, 62, 94, 126 and, for
// AXISCERT_EXACT_ONLY, 286, and of the whole words between.
TEST(CertifiedEdges, IntegersJustBelowAndAboveEachSize) {
  int counts[3] = {};
  for (const int n :
       {29, 30, 31, 32, 33, 61, 62, 63, 64, 65, 93, 94, 95, 96, 97, 125, 126, 127, 128, 129, 278, 285, 286, 287, 288}) {
    std::mt19937_64 random(edges_seed + static_cast<std::uint64_t>(n));
    std::vector<Query<double>> queries;
    for (int i = 0; i < 300; ++i) queries.push_back(widest_query(n, random));
    for (int i = 0; i < 100; ++i) queries.push_back(beside_an_edge_query(n, n / 5, random));
    SCOPED_TRACE(n);
    expect_exact(queries, counts);
  }
  EXPECT_GT(counts[0], 500);
  EXPECT_GT(counts[2], 500);
}

TEST(CertifiedEdges, NumbersThatLoseBitsWhereTheyAreScaled) {
  std::mt19937_64 random(edges_seed);
  std::vector<Query<double>> queries;
  for (int i = 0; i < 2000; ++i) queries.push_back(losing_query(random));
  int counts[3] = {};
  expect_exact(queries, counts);
  EXPECT_GT(counts[0], 50);
  EXPECT_GT(counts[1], 500);
  EXPECT_GT(counts[2], 50);
}

}  // namespace
}  // namespace axiscert
