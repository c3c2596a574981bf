// The other methods: the points and regions on their way, compared with hand computations.
#include <gtest/gtest.h>

#include <cmath>

#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert {
namespace {

using testing_support::answer, testing_support::for_each_vertex_order;

std::array<double, 3> list(const Vec3<double>& v) { return {v.x, v.y, v.z}; }

// The closest point of the right triangle (0,0,0) (4,0,0) (0,4,0) to P, in every vertex order.
void expect_closest(const Vec3<double>& p, const Vec3<double>& closest) {
  const Query<double> original{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, p, 1};
  for_each_vertex_order(original, [&](const Query<double>& q, std::string_view order) {
    const auto centred = centred_as<double>(q, [](double x) { return x; });
    EXPECT_EQ(list(methods::ClosestPoint::closest(centred, 0.0) + p), list(closest)) << order;
  });
}

TEST(ClosestPoint, OneInEachRegion) {
  expect_closest({1, 1, 3}, {1, 1, 0});
  expect_closest({1, -3, 0}, {1, 0, 0});
  expect_closest({4, 4, 1}, {2, 2, 0});
  expect_closest({-3, 1, 2}, {0, 1, 0});
  expect_closest({-3, -4, 0}, {0, 0, 0});
  expect_closest({9, -1, 0}, {4, 0, 0});
  expect_closest({-1, 9, 5}, {0, 4, 0});
}

TEST(ClosestPoint, OnTheBordersOfRegions) {
  expect_closest({0, -3, 0}, {0, 0, 0});  // A | AB
  expect_closest({2, 0, 1}, {2, 0, 0});   // AB | face
  expect_closest({5, 1, 0}, {4, 0, 0});   // B | BC
}

// The region of the edge is entered with weight 0/0: the foot lies within the segment, and A = B.
TEST(ClosestPoint, ARepeatedVertexGivesNoNumber) {
  const Query<double> q{{-2, 3, 0}, {-2, 3, 0}, {2, 3, 0}, {0, 0, 0}, 1};
  const auto centred = centred_as<double>(q, [](double x) { return x; });
  EXPECT_TRUE(std::isnan(methods::ClosestPoint::closest(centred, 0.0).x));
  EXPECT_EQ(answer(find_kernel("closest-point"), q).verdict, Verdict::contact);
  const Query<double> turned{q.a, q.c, q.b, q.p, q.r};
  EXPECT_EQ(answer(find_kernel("closest-point"), turned).verdict, Verdict::separated) << "A = C is not such a case";
}

TEST(Segments, ClosestPointOfASegmentIsClampedToItsEnds) {
  const auto closest = [](Vec3<double> from, Vec3<double> to) {
    return list(methods::closest_on_segment(from, to, 0.0));
  };
  using Point = std::array<double, 3>;
  EXPECT_EQ(closest({-1, 2, 0}, {3, 2, 0}), (Point{0, 2, 0}));
  EXPECT_EQ(closest({1, 2, 0}, {3, 2, 0}), (Point{1, 2, 0}));
  EXPECT_EQ(closest({-3, 2, 0}, {-1, 2, 0}), (Point{-1, 2, 0}));
  EXPECT_EQ(closest({3, 2, 0}, {3, 2, 0}), (Point{3, 2, 0})) << "no division by zero";
}

// Seven comparisons decide: those of the vertices never hold, and the sixteen names stay those of the published test.
TEST(Segments, VertexComparisonsNeverHold) {
  const Outcome found = answer<double>(find_kernel("segments"), {{3, 4, 0}, {7, 4, 0}, {3, 8, 0}, {0, 0, 0}, 1});
  EXPECT_EQ(found.verdict, Verdict::separated);
  EXPECT_EQ(axes_of(*found.bits) & 0b0001110, 0);
  EXPECT_NE(axes_of(*found.bits) & 0b1110000, 0);
}

// The centre in one part of the inflated triangle is enough for contact: for each part, a centre inside that part
// alone.
TEST(Minkowski, EachOfTheSevenVolumesCoversItsOwn) {
  const auto verdict = [](Vec3<double> p) {
    const Query<double> original{{0, 0, 0}, {16, 0, 0}, {0, 16, 0}, p, 1};
    Verdict first = answer(find_kernel("minkowski"), original).verdict;
    for_each_vertex_order(original, [&](const Query<double>& q, std::string_view order) {
      EXPECT_EQ(answer(find_kernel("minkowski"), q).verdict, first) << order;
    });
    return first;
  };
  EXPECT_EQ(verdict({5, 5, 0.5}), Verdict::contact);       // prism
  EXPECT_EQ(verdict({8, -0.5, 0}), Verdict::contact);      // cylinder AB
  EXPECT_EQ(verdict({8.5, 8.5, 0}), Verdict::contact);     // cylinder BC
  EXPECT_EQ(verdict({-0.5, 8, 0}), Verdict::contact);      // cylinder CA
  EXPECT_EQ(verdict({-0.5, -0.5, 0}), Verdict::contact);   // sphere A
  EXPECT_EQ(verdict({16.5, -0.25, 0}), Verdict::contact);  // sphere B
  EXPECT_EQ(verdict({-0.25, 16.5, 0}), Verdict::contact);  // sphere C
  EXPECT_EQ(verdict({-0.75, -0.75, 0}), Verdict::separated) << "the spheres round the vertices off";
  EXPECT_EQ(verdict({5, 5, 1.5}), Verdict::separated);
}

}  // namespace
}  // namespace axiscert
