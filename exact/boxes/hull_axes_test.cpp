// The axes of hulls in general, beside their nearest points.
#include "exact/boxes/hull_axes.h"

#include "exact/boxes/boxes_testing.h"

namespace axiscert::boxes {
namespace {

Point whole_point(Random& random, int bound) {
  const Vec3<double> v = whole_vector(random, bound);
  return {v.x, v.y, v.z};
}
Hull polyhedron(Random& random) {
  Hull hull;
  const int points = 4 + below(random, 5);
  const Point at = whole_point(random, 3);
  for (int i = 0; i < points; ++i) hull.push_back(at + whole_point(random, 2));
  return hull;
}
// In the plane z = 0; three to six points.
Hull polygon(Random& random) {
  Hull hull;
  const int points = 3 + below(random, 4);
  const double x = whole(random, 4), y = whole(random, 4);
  for (int i = 0; i < points; ++i) hull.push_back({x + whole(random, 2), y + whole(random, 2), 0});
  return hull;
}
Hull first_points(Hull hull, std::size_t count) {
  hull.resize(count);
  return hull;
}
// Points (x, y, 0) in the plane 2 x + y + 2 z = 0 instead, with whole coordinates.
Hull tilted(const Hull& hull) {
  Hull made;
  for (const Point& p : hull) made.push_back(Point{1, -2, 0} * p.x + Point{0, -2, 1} * p.y);
  return made;
}
Hull lifted(Hull hull, int by) {
  for (Point& p : hull) p.z += by;
  return hull;
}

struct Kind {
  std::string_view name;
  std::pair<Hull, Hull> (*make)(Random& random);
};
constexpr Kind kinds[] = {
    {"two polyhedra",
     [](Random& r) {
       return std::pair{polyhedron(r), polyhedron(r)};
     }},
    {"a polyhedron and a polygon",
     [](Random& r) {
       return std::pair{polyhedron(r), tilted(polygon(r))};
     }},
    {"two polygons, planes that cross",
     [](Random& r) {
       return std::pair{polygon(r), tilted(polygon(r))};
     }},
    {"two polygons, parallel planes",
     [](Random& r) {
       return std::pair{polygon(r), lifted(polygon(r), below(r, 2))};
     }},
    {"two polygons of one plane",
     [](Random& r) {
       return std::pair{tilted(polygon(r)), tilted(polygon(r))};
     }},
    {"a polygon and a segment of its plane",
     [](Random& r) {
       return std::pair{polygon(r), first_points(polygon(r), 2)};
     }},
    {"two segments of one plane",
     [](Random& r) {
       return std::pair{first_points(polygon(r), 2), first_points(polygon(r), 2)};
     }},
    {"a polygon and a point",
     [](Random& r) {
       return std::pair{polygon(r), first_points(polygon(r), 1)};
     }},
};

struct HullRates {
  Wrong all, without;
  int apart = 0;
};
HullRates hull_rates(const Kind& kind, int pairs) {
  Random random(20261124);
  HullRates found;
  for (int i = 0; i < pairs; ++i) {
    const auto [a, b] = kind.make(random);
    const bool apart = squared_distance(a, b) > 0;
    found.apart += apart;
    found.all.count(are_apart_on(separating_axes(a, b), a, b), apart);
    found.without.count(are_apart_on(separating_axes(a, b, InPlane::left_out), a, b), apart);
  }
  return found;
}

void expect_right_hulls(int pairs) {
  for (const Kind& kind : kinds) {
    const HullRates found = hull_rates(kind, pairs);
    EXPECT_EQ(found.all.all(), 0) << kind.name << ": " << found.all;
    EXPECT_EQ(found.without.missed, 0) << kind.name;
  }
}
TEST(HullAxes, AreRightForEveryKindOfHull) { expect_right_hulls(60); }
TEST(HullAxesLong, AreRightForEveryKindOfHull) { expect_right_hulls(1000 / TRIAL_DIVISOR); }

// The planted fault: polygons of one plane are never told apart without the axes in it.
TEST(HullAxes, WithoutThoseInThePlaneContactsAreInvented) {
  const HullRates found = hull_rates(kinds[4], 60);
  EXPECT_EQ(found.without.phantom, found.apart);
  EXPECT_GT(found.apart, 10);
}

TEST(HullAxes, OfBoxesAreTheFifteen) {
  Random random(3);
  for (int i = 0; i < 12; ++i) {
    const ExactPair q = exact_pair(independent_pair(random, 2, 5));
    const Hull a = corners_of(q.a), b = corners_of(q.b);
    EXPECT_EQ(are_apart_on(separating_axes(a, b), a, b), are_apart(q)) << i;
  }
}

}  // namespace
}  // namespace axiscert::boxes
