// examples/cgal-double.jsonl: binary32 queries that CGAL's squared_distance in double gets wrong.
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "fuzz/files/query_file.h"
#include "fuzz/sphere_triangle/families/parts/sphere_triangle_query.h"
#include "kernel/peers/peers_testing.h"

namespace axiscert {
namespace {

TEST(CgalDoubleExamples, AreWrongInDoubleAndRightInEpick) {
  const auto queries = read_query_file(SOURCE_FOLDER "/examples/cgal-double.jsonl", Precision::binary32);
  ASSERT_EQ(queries.size(), 3u);
  for (const StoredQuery& stored : queries) {
    ASSERT_EQ(stored.precision, Precision::binary32) << stored.id;
    const Query<float> q = sphere_triangle_query_in<float>(stored);
    const int order = distance_order(q);
    EXPECT_EQ(second_opinion(q).distance_order, order) << stored.id;
    const std::string right(1, order > 0 ? 's' : 'c'), wrong(1, order > 0 ? 'c' : 's');
    EXPECT_EQ(peer::ask<float>("cgal-double", {q}).bytes, wrong) << stored.id;
    EXPECT_EQ(peer::ask<double>("cgal-double", {widened(q)}).bytes, wrong) << stored.id;
    EXPECT_EQ(peer::ask<float>("cgal-epick", {q}).bytes, right) << stored.id;
    EXPECT_EQ(peer::ask<double>("cgal-epick", {widened(q)}).bytes, right) << stored.id;
  }
}

}  // namespace
}  // namespace axiscert
