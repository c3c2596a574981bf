// A box and a triangle: anywhere, of small integers, touching on each of the thirteen axes in turn, of zero area, and
// as a mesh meets the cells of a grid.
#include <algorithm>

#include "exact/boxes/measures.h"
#include "fuzz/boxes/triangles.h"

namespace axiscert::boxes {

namespace {

template <class Entry, class Real>
ExactBoxAndTriangle exactly_of_entry(const Numbers<Real>& numbers) {
  return exact_box_and_triangle(
      Entry::template problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); }));
}
template <class Real>
ExactBoxAndTriangle exact_of(const CentredAndTriangle<Real>& q) {
  return exactly_of_entry<CentreEntry>(numbers_of(q));
}
template <class Real>
ExactBoxAndTriangle exact_of(const CornersAndTriangle<Real>& q) {
  return exactly_of_entry<MinmaxEntry>(numbers_of(q));
}
template <class Real>
ExactBoxAndTriangle exact_of(const BoxAndTriangle<Real>& q) {
  return exactly_of_entry<OrientedEntry>(numbers_of(q));
}
template <class Real>
ExactBoxAndTriangle exact_of(const TurnedAndTriangle<Real>& q) {
  return exactly_of_entry<TurnedEntry>(numbers_of(q));
}

struct GeneralTriangle {
  template <class Query>
  static Query make(Stream& random, std::uint64_t) {
    using Real = RealOf<Query>;
    Query q{};
    put_box(random, q);
    for (Vec3<Real>& corner : q.corner) corner = point_in_cube<Real>(random) * Real(3);
    return q;
  }
};

// The triangle is moved so that it touches the box on one axis: the axis' plane has the box on one side and the
// triangle on the other. Each corner is rounded once, and every other time moved by up to two ulps in a coordinate.
struct TouchingTriangle {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    Query q{};
    put_box(random, q);
    for (Vec3<Real>& corner : q.corner) corner = point_in_cube<Real>(random);
    const ExactBoxAndTriangle exact = exact_of(q);
    const Point product = direction(exact, position / 2 % thirteen_count);
    const Point along = random.coin() ? product : product * Rational(-1);
    Point of_box = exact.box.centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational slope = dot(along, exact.box.axis[k]);
      Rational t(random.integer(-7, 7), 8);
      t.canonicalize();
      if (slope != 0) t = slope > 0 ? 1 : -1;
      of_box = of_box + exact.box.axis[k] * Rational(exact.box.half[k] * t);
    }
    const Point of_triangle = nearest_corner_or_edge(random, exact.corner, along);
    const Point by = of_box - of_triangle;
    for (std::size_t k = 0; k < 3; ++k) q.corner[k] = rounded_point<Real>(exact.corner[k] + by);
    if (position % 2 == 1) {
      Vec3<Real>& corner = q.corner[random.below(3)];
      const int ulps = static_cast<int>(random.integer(-2, 2));
      corner.x = step_ulps(corner.x, ulps);
    }
    return q;
  }

 private:
  // The least along the direction: a corner; where an edge or all of the triangle is, a point of it at an eighth.
  static Point nearest_corner_or_edge(Stream& random, const std::array<Point, 3>& corner, const Point& along) {
    std::array<Rational, 3> at;
    for (std::size_t k = 0; k < 3; ++k) at[k] = dot(along, corner[k]);
    const Rational least = *std::min_element(at.begin(), at.end());
    Point sum{0, 0, 0};
    Rational weights = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational weight = random.integer(1, 7);
      if (at[k] != least) continue;
      sum = sum + corner[k] * weight;
      weights += weight;
    }
    return sum / weights;
  }
};

template <class Real>
Vec3<Real> whole_point(Stream& random, std::int64_t bound) {
  const auto x = static_cast<Real>(random.integer(-bound, bound)), y = static_cast<Real>(random.integer(-bound, bound));
  const auto z = static_cast<Real>(random.integer(-bound, bound));
  return {x, y, z};
}
template <class Real>
Vec3<Real> whole_extents(Stream& random, std::int64_t bound) {
  const auto x = static_cast<Real>(random.integer(0, bound)), y = static_cast<Real>(random.integer(0, bound));
  const auto z = static_cast<Real>(random.integer(0, bound));
  return {x, y, z};
}
template <class Real>
void put_whole_box(Stream& random, std::int64_t bound, CentredAndTriangle<Real>& q) {
  q.centre = whole_point<Real>(random, bound);
  const Vec3<Real> half = whole_extents<Real>(random, bound);
  q.half = {half.x, half.y, half.z};
}
template <class Real>
void put_whole_box(Stream& random, std::int64_t bound, CornersAndTriangle<Real>& q) {
  q.low = whole_point<Real>(random, bound);
  q.high = q.low + whole_extents<Real>(random, bound);
}
template <class Real>
void put_whole_box(Stream& random, std::int64_t bound, BoxAndTriangle<Real>& q) {
  CentredAndTriangle<Real> given;
  put_whole_box(random, bound, given);
  q.box.centre = given.centre;
  q.box.half = given.half;
  const auto first = random.below(3);
  for (std::size_t k = 0; k < 3; ++k) {
    const Real one = random.coin() ? Real(1) : Real(-1);
    const std::size_t at = (k + first) % 3;
    q.box.axis[k] = {at == 0 ? one : Real(0), at == 1 ? one : Real(0), at == 2 ? one : Real(0)};
  }
}
template <class Real>
void put_whole_box(Stream& random, std::int64_t bound, TurnedAndTriangle<Real>& q) {
  CentredAndTriangle<Real> given;
  put_whole_box(random, bound, given);
  q.box.centre = given.centre;
  q.box.half = given.half;
  turn_by_quarters(random, q.box);
}

// Integers up to 2, 5 or 20 in turn: nothing is rounded, and many touch.
template <class Query>
Query whole_query(Stream& random, std::uint64_t position) {
  const std::int64_t bound = std::array<std::int64_t, 3>{2, 5, 20}[position % 3];
  Query q{};
  put_whole_box(random, bound, q);
  for (auto& corner : q.corner) corner = whole_point<RealOf<Query>>(random, bound);
  return q;
}
struct LatticeTriangle {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    return whole_query<Query>(random, position);
  }
};

// In turn: two equal corners, a corner on the edge of the others or beyond it, three equal corners; and a box without
// one or two of its extents.
struct DegenerateTriangle {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    Query q = whole_query<Query>(random, position / 4);
    const Real times = static_cast<Real>(random.integer(-2, 3));
    if (position % 4 == 0) q.corner[2] = q.corner[0];
    if (position % 4 == 1) q.corner[2] = q.corner[0] + (q.corner[1] - q.corner[0]) * times;
    if (position % 4 == 2) q.corner[1] = q.corner[2] = q.corner[0];
    if (position % 4 == 3) q.half[random.below(3)] = 0;
    return q;
  }
};

// A cell of a grid, and a triangle a few cells wide in a plane through a corner of the cell. Two of three cells are up
// to 2^10 cells from 0, where the plane is rounded by more than a kernel errs, the others up to 1, 2, 4 ... 2^10 in
// turn.
struct Voxel {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    const Real cell = std::ldexp(Real(1), -static_cast<int>(position % 8));
    Query q{};
    q.low = whole_point<Real>(random, std::int64_t{1} << (position / 8 % 3 != 0 ? 10 : position / 24 % 11)) * cell;
    q.high = q.low + Vec3<Real>{cell, cell, cell};
    const Vec3<Real> corner{random.coin() ? q.high.x : q.low.x, q.low.y, q.high.z};
    const Vec3<Real> u = point_in_cube<Real>(random) * (cell * 3), v = point_in_cube<Real>(random) * (cell * 3);
    q.corner = {corner + u, corner + v, corner - (u + v)};
    return q;
  }
};

}  // namespace

extern const Family box_triangle_general_family =
    triangle_family<GeneralTriangle, CentreEntry>("box-triangle/general", box_triangle_situation::everyday,
                                                  "half extents 0.5 to 1.5, a triangle in the cube of side 6");
extern const Family box_triangle_touching_family = triangle_family<TouchingTriangle, CentreEntry>(
    "box-triangle/touching", box_triangle_situation::touching,
    "the triangle touches the box on each axis in turn, rounded; every other one up to 2 ulps");
extern const Family box_triangle_lattice_family = triangle_family<LatticeTriangle, CentreEntry>(
    "box-triangle/lattice", box_triangle_situation::small_integers, "small integers: nothing is rounded", true);
extern const Family box_triangle_degenerate_family = triangle_family<DegenerateTriangle, CentreEntry>(
    "box-triangle/degenerate", box_triangle_situation::degenerate,
    "small integers, the triangle a segment or a point, or the box a rectangle, in turn", true);

extern const Family box_triangle_general_minmax_family = triangle_family<GeneralTriangle, MinmaxEntry>(
    "box-triangle/general_minmax", box_triangle_situation::everyday, "general, the box by two corners");
extern const Family box_triangle_touching_minmax_family = triangle_family<TouchingTriangle, MinmaxEntry>(
    "box-triangle/touching_minmax", box_triangle_situation::touching, "touching, the box by two corners");
extern const Family box_triangle_lattice_minmax_family =
    triangle_family<LatticeTriangle, MinmaxEntry>("box-triangle/lattice_minmax", box_triangle_situation::small_integers,
                                                  "small integers, the box by two corners: nothing is rounded", true);
extern const Family box_triangle_voxel_family = in_metres(triangle_family<Voxel, MinmaxEntry>(
    "box-triangle/voxel", box_triangle_situation::everyday,
    "a cell of a grid, and a triangle in a plane through a corner of the cell, of a few cells", false, 2));

extern const Family box_triangle_general_oriented_family =
    triangle_family<GeneralTriangle, OrientedEntry>("box-triangle/general_oriented", box_triangle_situation::everyday,
                                                    "general, the box turned by any rotation, rounded");
extern const Family box_triangle_touching_oriented_family =
    triangle_family<TouchingTriangle, OrientedEntry>("box-triangle/touching_oriented", box_triangle_situation::touching,
                                                     "touching, the box turned by any rotation, rounded");
extern const Family box_triangle_lattice_oriented_family = triangle_family<LatticeTriangle, OrientedEntry>(
    "box-triangle/lattice_oriented", box_triangle_situation::small_integers,
    "small integers, the box turned by quarter turns: nothing is rounded", true);

extern const Family box_triangle_general_turned_family = triangle_family<GeneralTriangle, TurnedEntry>(
    "box-triangle/general_turned", box_triangle_situation::everyday, "general, the box by a quaternion of integers");
extern const Family box_triangle_touching_turned_family = triangle_family<TouchingTriangle, TurnedEntry>(
    "box-triangle/touching_turned", box_triangle_situation::touching, "touching, the box by a quaternion of integers");
extern const Family box_triangle_lattice_turned_family = triangle_family<LatticeTriangle, TurnedEntry>(
    "box-triangle/lattice_turned", box_triangle_situation::small_integers,
    "small integers, quarter turns as quaternions: nothing is rounded", true);

}  // namespace axiscert::boxes
