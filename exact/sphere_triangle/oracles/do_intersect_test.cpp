// An oracle built on do_intersect is wrong, and the cross-check says so.
#include <gtest/gtest.h>

#include "exact/sphere_triangle/asked_sphere_triangle.h"

namespace axiscert {
namespace {

TEST(DoIntersectOracle, FailsOnATriangleInsideTheSphere) {
  const Query<float> inside{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0}, 100};
  try {
    exact_truth(inside, false);
    FAIL() << "a triangle inside the sphere passed as separated";
  } catch (const OracleDisagreement& disagreement) {
    EXPECT_NE(std::string(disagreement.what()).find("CGAL says separated"), std::string::npos) << disagreement.what();
    EXPECT_NE(std::string(disagreement.what()).find("MPFR's own verdict is contact"), std::string::npos);
    EXPECT_EQ(disagreement.query[12], 100);
  }
}

TEST(DoIntersectOracle, PassesWhereTheSurfaceIsReached) {
  EXPECT_NO_THROW(exact_truth(Query<float>{{0, 0, 0}, {10, 0, 0}, {0, 10, 0}, {1, 1, 1}, 2}, true));
}

}  // namespace
}  // namespace axiscert
