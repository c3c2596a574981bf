// Scenes by their size and by what their triangles are.
#include "fuzz/certify/margin_scene.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <string>

#include "kernel/predicate.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

const SceneMeasure& of_spheres() {
  static const SceneMeasure measure(sphere_triangle_predicate());
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

int decade(double size) { return of_spheres().of(Numbers<double>{0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, size}).decade; }
int decade_of_the_shortest_decimal(double size) {
  char text[32];
  const auto end = std::to_chars(text, text + sizeof text, size, std::chars_format::scientific).ptr;
  return std::stoi(std::string(std::find(text, end, 'e') + 1, end));
}

TEST(MarginScene, ADecadeIsThatOfTheShortestDecimal) {
  std::mt19937_64 random(1);
  for (int e = -323; e <= 308; ++e) {
    const double power = std::strtod(fmt::format("1e{}", e).c_str(), nullptr);
    for (const double size : {std::nextafter(power, 0), power, std::nextafter(power, 1e308)})
      if (size > 0) {
        EXPECT_EQ(decade(size), decade_of_the_shortest_decimal(size)) << size;
      }
    EXPECT_EQ(decade(power), e);
  }
  for (int i = 0; i < 10'000; ++i) {
    const double size = std::fabs(std::bit_cast<double>(random()));
    if (std::isfinite(size)) {
      EXPECT_EQ(decade(size), decade_of_the_shortest_decimal(size)) << size;
    }
  }
}

TEST(MarginScene, AnInfiniteSizeIsInTheGreatestDecade) {
  Numbers<double> query = scene<double>(1, 0, -1.5e308, 1);
  query[0] = 1.5e308;  // 3e308 from the centre, which is beyond the numbers
  EXPECT_EQ(of_spheres().of(query).decade, 308);
}

TEST(MarginScene, TrianglesWithoutAnAreaAndNeedlesAreDegenerate) {
  EXPECT_TRUE(of_spheres().of(scene<float>(-1, 0, 0, 1)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(-0.999f, 0, 0, 1)).is_degenerate);    // a height of 0.001 on 2
  EXPECT_FALSE(of_spheres().of(scene<float>(-0.9375f, 0, 0, 1)).is_degenerate);  // of a sixteenth
  EXPECT_FALSE(of_spheres().of(scene<float>(1, 0, 0, 0)).is_degenerate);
  EXPECT_TRUE(of_spheres().of(scene<float>(1, 0, 0, 0x1p-70f)).is_degenerate);  // whose square is not a normal number
}

TEST(MarginScene, AMovingSphereIsMeasuredByTheSameTriangle) {
  const SceneMeasure moving(find_predicate("moving-sphere"));
  Numbers<float> motion = {-1, -1, 0, 1, -1, 0, 0, -1, 0, 0, 0, 5, 30, 0, 0, 1};
  EXPECT_EQ(moving.of(motion), (MarginScene{true, 1}));  // the displacement counts
  motion[7] = 1;
  EXPECT_EQ(moving.of(motion), (MarginScene{false, 1}));
}

}  // namespace
}  // namespace axiscert
