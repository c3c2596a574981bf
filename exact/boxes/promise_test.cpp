// The front of a triangle and the margin of two bodies, of a box and a triangle, two boxes and a motion.
#include <gtest/gtest.h>

#include <cmath>

#include "exact/judge/oracles.h"

namespace axiscert {
namespace {

bool is_inside(const char* predicate, const Limits& limits, std::initializer_list<double> numbers) {
  const Predicate& of = find_predicate(predicate);
  Numbers<double> q(numbers.size());
  std::copy(numbers.begin(), numbers.end(), q.begin());
  EXPECT_TRUE(oracles_of(of).is_valid(q)) << predicate;
  return oracles_of(of).is_within(limits, q);
}
// A cube of half extents 1 above or below a triangle in z = 0 that faces upwards.
bool cube_at(double z, const Limits& limits) {
  return is_inside("box-triangle", limits, {1, 1, z, 1, 1, 1, 0, 0, 0, 4, 0, 0, 0, 4, 0});
}

TEST(PromisesOfPredicates, TheBoxsCentreIsInFront) {
  const Limits front{.sides = SidesPolicy::front};
  EXPECT_TRUE(cube_at(0x1p-1000, front));
  EXPECT_FALSE(cube_at(0, front));
  EXPECT_FALSE(cube_at(-3, front));
}

TEST(PromisesOfPredicates, AMarginIsOpenBetweenTouchAndItsEnd) {
  const Limits half{.margin = 0.5};
  const double after = std::nextafter(1.5, 2);
  EXPECT_TRUE(cube_at(1, half) && cube_at(0, half) && cube_at(after, half));
  EXPECT_FALSE(cube_at(std::nextafter(1.0, 2), half) || cube_at(1.5, half) || cube_at(-1.5, half));
  const auto boxes = [&](double x) {
    return is_inside("box-box", half,
                     {0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1, x, 0, 0, 1, 1, 1, 1, 0, 0, 0, 1, 0, 0, 0, 1});
  };
  EXPECT_TRUE(boxes(2) && boxes(std::nextafter(2.5, 3)));
  EXPECT_FALSE(boxes(2.5));
  // A sphere of radius 1 passes over the face at height z.
  const auto motion = [&](double z) {
    return is_inside("moving-sphere", half, {0, 0, 0, 4, 0, 0, 0, 4, 0, 1, 1, z, 1, 0, 0, 1});
  };
  EXPECT_TRUE(motion(1) && motion(std::nextafter(1.5, 2)));
  EXPECT_FALSE(motion(1.5));
}

}  // namespace
}  // namespace axiscert
