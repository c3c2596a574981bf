// The class of an input: each definition at its threshold and one float beside it, in both precisions.
#include "exact/sphere_triangle/measures/input_class.h"

#include <gtest/gtest.h>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
namespace {

using enum InputClass;

template <class Real>
class InputClasses : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(InputClasses, Reals);

template <class Real>
Query<Real> ordinary_query() {
  return {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, Real(0.25)};
}
template <class Real>
Query<Real> times(Query<Real> q, int exponent) {
  auto v = coordinates(q);
  for (Real& x : v) x = std::ldexp(x, exponent);
  return from_coordinates(v);
}
template <class Real>
InputClassSet all_of(const Query<Real>& q) {
  return input_classes(q, squared_distance(q));
}
// The same by exact arithmetic alone.
template <class Real>
void expect_shape(const Query<Real>& q, InputClassSet expected) {
  EXPECT_EQ(shape_classes(q), expected);
  EXPECT_EQ(shape_classes(q, false), expected);
}

TYPED_TEST(InputClasses, AQueryOfNoOtherClassIsOrdinary) {
  EXPECT_EQ(all_of(ordinary_query<TypeParam>()), InputClassSet{ordinary});
  EXPECT_EQ(class_of(all_of(ordinary_query<TypeParam>())), ordinary);
}

TYPED_TEST(InputClasses, ATieTouchesAndANearTieIsWithin64U) {
  using Real = TypeParam;
  Query<Real> q = {{1, 0, 1}, {0, 1, 1}, {-1, -1, 1}, {0, 0, 0}, 1};
  EXPECT_EQ(all_of(q), InputClassSet{tie});
  // The scene is as long as the farthest vertex: sqrt(3).
  const auto off_by = [&](double depth) {
    q.r = static_cast<Real>(1 + depth * std::sqrt(3.0));
    return all_of(q);
  };
  EXPECT_EQ(off_by(near_tie_depth<Real> * 0.9), InputClassSet{near_tie});
  EXPECT_EQ(off_by(near_tie_depth<Real> * 1.1), InputClassSet{ordinary});
  EXPECT_EQ(input_classes(q, false, near_tie_depth<Real>), InputClassSet{near_tie}) << "the threshold itself";
  EXPECT_EQ(near_tie_depth<Real>, std::ldexp(64.0, -std::numeric_limits<Real>::digits));
}

TYPED_TEST(InputClasses, TheScaleWindowIsClosed) {
  using Real = TypeParam;
  using Window = ScaleWindow<Real>;
  const Query<Real> q = ordinary_query<Real>();
  const auto beside = [](Query<Real> at, Real towards) {
    at.a.x = std::nextafter(at.a.x, towards);
    return at;
  };
  expect_shape(times(q, Window::greatest_exponent), {});
  expect_shape(beside(times(q, Window::greatest_exponent), std::numeric_limits<Real>::infinity()), {scale});
  expect_shape(times(q, Window::least_exponent), {});
  Query<Real> below = times(q, Window::least_exponent);
  below.r = 0;
  for (Real* x : {&below.a.x, &below.b.y, &below.c.z}) *x = std::nextafter(*x, Real(0));
  expect_shape(below, {scale});
  Query<Real> small = q;
  small.r = std::ldexp(Real(1), Window::least_radius_exponent);
  expect_shape(small, {});
  small.r = std::nextafter(small.r, Real(0));
  expect_shape(small, {scale});
  small.r = 0;
  expect_shape(small, {});
}

// A - P rounds to the bound and lies beyond it by far less than an ulp.
TYPED_TEST(InputClasses, ALengthThatRoundsToItsBoundIsComparedExactly) {
  using Real = TypeParam;
  Query<Real> q = times(ordinary_query<Real>(), ScaleWindow<Real>::greatest_exponent);
  q.p.x = -std::ldexp(Real(1), -100);
  ASSERT_EQ(double(q.a.x) - double(q.p.x), double(q.a.x));
  expect_shape(q, {scale});
  q.p.x = -q.p.x;
  expect_shape(q, {});
}

TYPED_TEST(InputClasses, EqualVerticesWhateverTheSignOfZero) {
  Query<TypeParam> q = ordinary_query<TypeParam>();
  q.b = {1, TypeParam(-0.0), 0};
  expect_shape(q, {repeated});
  q.c = q.b;
  expect_shape(q, {repeated});
}

TYPED_TEST(InputClasses, ThreePointsOfALineAreCollinearAndNoSliver) {
  using Real = TypeParam;
  const Real tiny = std::numeric_limits<Real>::denorm_min();
  Query<Real> q = {{0, 0, 0}, {1, 2, 3}, {3, 6, 9}, {0, 5, 0}, 1};
  expect_shape(q, {collinear});
  q.b.x = std::nextafter(q.b.x, Real(2));
  expect_shape(q, {sliver});
  expect_shape(Query<Real>{{0, 0, 0}, {1, 0, 0}, {2, tiny, 0}, {0, 5, 0}, 1}, {sliver});
}

// Base 1 and height 2^-10: the longest edge is the base, and the definition says `below`.
TYPED_TEST(InputClasses, ASliverIsLessThanAThousandthHigh) {
  using Real = TypeParam;
  Query<Real> q = {{0, 0, 0}, {1, 0, 0}, {Real(0.5), Real(0x1p-10), 0}, {0, 0, 3}, 1};
  expect_shape(q, {});
  q.c.y = std::nextafter(q.c.y, Real(0));
  expect_shape(q, {sliver});
}

TYPED_TEST(InputClasses, FarIs64TimesTheScene) {
  using Real = TypeParam;
  Query<Real> q = ordinary_query<Real>();
  for (Vec3<Real>* v : {&q.a, &q.b, &q.c, &q.p}) v->z += 62;
  expect_shape(q, {});
  for (Vec3<Real>* v : {&q.a, &q.b, &q.c, &q.p}) v->z += 1;
  expect_shape(q, {far});
  expect_shape(Query<Real>{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}, {1, 1, 1}, 0}, {repeated});
}

TEST(InputClass, TheFirstDefinitionThatIsMetNamesIt) {
  EXPECT_EQ(class_of({far, sliver, near_tie}), near_tie);
  EXPECT_EQ(class_of({far, sliver}), sliver);
  for (const InputClass which : enumerators<InputClass>) EXPECT_FALSE(input_class_names[which].empty());
}

}  // namespace
}  // namespace axiscert
