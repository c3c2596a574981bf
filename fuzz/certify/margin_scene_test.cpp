// Scenes by their size and by what their triangles are.
#include "fuzz/certify/margin_scene.h"

#include <gtest/gtest.h>

#include <limits>

#include "kernel/test.h"

namespace axiscert {
namespace {

const SceneMeasure& of_spheres() {
  static const SceneMeasure measure(first_test());
  return measure;
}

// The triangle (-1, -1, z), (1, -1, z), (c, y, z) beside a sphere at (x, 0, 0).
template <class Real>
Numbers<Real> scene(Real y, Real z, Real x, Real r) {
  return {-1, -1, z, 1, -1, z, 0, y, z, x, 0, 0, r};
}

TEST(MarginScene, ItsSizeIsSeenFromTheCentre) {
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 0, 0.5f)), (MarginScene{false, 0}));
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 9, 0.5f)), (MarginScene{false, 1}));   // 10 from the first vertex
  EXPECT_EQ(of_spheres().of(scene<float>(1, 0, 0, 9.75f)), (MarginScene{false, 0}));  // the radius counts
  EXPECT_EQ(of_spheres().of(scene<double>(1, 1e99, 0, 1)), (MarginScene{true, 99}));  // and beyond degree 6
  EXPECT_EQ(of_spheres().of(Numbers<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0}), (MarginScene{true, -400}));
}

TEST(MarginScene, TrianglesWithoutAnAreaAndNeedlesAreDegenerate) {
  EXPECT_TRUE(of_spheres().of(scene<float>(-1, 0, 0, 1)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(-0.999f, 0, 0, 1)).is_degenerate);    // a height of 0.001 on 2
  EXPECT_FALSE(of_spheres().of(scene<float>(-0.9375f, 0, 0, 1)).is_degenerate);  // of a sixteenth
  EXPECT_FALSE(of_spheres().of(scene<float>(1, 0, 0, 0)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(1, 0, 0, 0x1p-70f)).is_degenerate);  // whose square is not a normal number
}

TEST(MarginScene, AMovingSphereIsMeasuredByTheSameTriangle) {
  const SceneMeasure moving(find_test("moving-sphere"));
  Numbers<float> motion = {-1, -1, 0, 1, -1, 0, 0, -1, 0, 0, 0, 5, 30, 0, 0, 1};
  EXPECT_EQ(moving.of(motion), (MarginScene{true, 1}));  // the displacement counts
  motion[7] = 1;
  EXPECT_EQ(moving.of(motion), (MarginScene{false, 1}));
}

}  // namespace
}  // namespace axiscert
