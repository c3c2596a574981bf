// Placement of spheres about the triangles of a mesh, in lanes of binary64: one placement per vector, one triangle per
// lane. Included once for each instruction set, by mesh_queries.cpp.
#include "fuzz/sphere_triangle/families/parts/lane_shapes-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {
namespace {

using Random = LaneStream<double>;
using T = Random::T;
using Point = Vec3<T>;
constexpr std::size_t lanes = Random::lanes;

AXISCERT_INLINE T number(double x) { return Random::constant(x); }
AXISCERT_INLINE Point zero_point() { return {number(0), number(0), number(0)}; }

// Any direction, denser towards the vertices of a cube than towards its faces, by a factor of at most 3 sqrt(3).
AXISCERT_INLINE Point direction(Random& random) {
  Point v = in_cube(random);
  v.x = select(hn::Eq(v.x.v, number(0).v), number(1), v.x);
  return at_unit_length(v);
}

// A number between 2^low and 2^high, with uniform exponent and uniform significand.
AXISCERT_INLINE T magnitude(Random& random, int low, int high) {
  const auto exponent = random.below(static_cast<std::uint32_t>(high - low));
  const T significand = number(1) + random.unit();
  const auto biased = hn::Add(exponent, hn::Set(Random::DW(), static_cast<std::uint64_t>(1023 + low)));
  return significand * T{hn::BitCast(Random::D(), hn::ShiftLeft<52>(biased))};
}

// A rotation by an integer quaternion combined with a scale: the columns are the images of the unit vectors.
struct ScaledRotation {
  Point x, y, z;
  T scale;
  AXISCERT_INLINE Point operator()(const Point& v) const { return (x * v.x + y * v.y) + z * v.z; }
};

AXISCERT_INLINE ScaledRotation drawn_placement(Random& random) {
  const T real = random.integer(-9, 9), x = random.integer(-9, 9), y = random.integer(-9, 9), z = random.integer(-9, 9);
  const T squares = (x * x + y * y) + z * z;
  const auto all_zero = hn::Eq((real * real + squares).v, number(0).v);
  const T w = select(all_zero, number(1), real);
  const T square = w * w + squares;
  const T scale = magnitude(random, -4, 5);
  const auto entry = [&](const T& n) HWY_ATTR { return n / square * scale; };  // n is an integer below 2^10: exact
  const T two = number(2);
  return {{entry(w * w + x * x - y * y - z * z), entry(two * (x * y + w * z)), entry(two * (x * z - w * y))},
          {entry(two * (x * y - w * z)), entry(w * w - x * x + y * y - z * z), entry(two * (y * z + w * x))},
          {entry(two * (x * z + w * y)), entry(two * (y * z - w * x)), entry(w * w - x * x - y * y + z * z)},
          scale};
}

// A triangle and its sizes and directions, to the accuracy of binary64: nothing below relies on their being exact.
struct Frame {
  LaneVertices<T> v;
  T edge;        // mean length, never zero
  Point normal;  // unit length; an arbitrary direction if the triangle has no area

  Frame(const LaneVertices<T>& vertices, const T& substitute, Random& random) : v(vertices) {
    const T zero = number(0);
    const T mean = ((length(v[1] - v[0]) + length(v[2] - v[1])) + length(v[0] - v[2])) / number(3);
    const T other = select(hn::Gt(substitute.v, zero.v), substitute, number(1));
    edge = select(hn::Gt(mean.v, zero.v), mean, other);
    const Point across = cross(v[1] - v[0], v[2] - v[0]), any = direction(random);
    const T size = length(across);
    normal = select(hn::Gt(size.v, zero.v), across / size, any);
  }

  // In the plane, away from the triangle, perpendicular to the edge; zero if there is no such direction.
  static Point outward(const Point& from, const Point& to, const Point& third) {
    const Point along = to - from, inner = third - from;
    const T square = dot(along, along);
    const Point away = at_unit_length(along * (dot(inner, along) / square) - inner);
    return select(hn::Gt(square.v, number(0).v), away, zero_point());
  }
  Point on_face(Random& random) const {
    const T s = random.unit(), t = random.unit(), one = number(1);
    const auto beyond = hn::Gt((s + t).v, one.v);
    return v[0] + ((v[1] - v[0]) * select(beyond, one - s, s) + (v[2] - v[0]) * select(beyond, one - t, t));
  }
  // The vertices rotated cyclically so that a random one is first.
  LaneVertices<T> turned(Random& random) const {
    const T i = random.integer(0, 2), one = number(1), two = number(2);
    const auto last = hn::Eq(i.v, two.v);
    return arranged(v, i, select(last, number(0), i + one));
  }
};

AXISCERT_INLINE Point on_edge(const LaneVertices<T>& v, Random& random) { return v[0] + (v[1] - v[0]) * random.unit(); }

AXISCERT_INLINE Point edge_centre(const Frame& frame, Random& random, const T& height) {
  const auto v = frame.turned(random);
  const Point foot = on_edge(v, random);
  const T outwards = random.unit(), upwards = random.symmetric();
  return foot + at_unit_length(Frame::outward(v[0], v[1], v[2]) * outwards + frame.normal * upwards) * height;
}

// Between the outward directions of the two edges that meet at the vertex, that vertex is the feature nearest to P.
AXISCERT_INLINE Point vertex_centre(const Frame& frame, Random& random, const T& height) {
  const auto v = frame.turned(random);
  const T first = random.unit(), second = random.unit(), upwards = random.symmetric();
  const Point beside = Frame::outward(v[0], v[1], v[2]) * first + Frame::outward(v[2], v[0], v[1]) * second;
  return v[0] + at_unit_length(beside + frame.normal * upwards) * height;
}

AXISCERT_INLINE void place_far(const Frame& frame, Random& random, LaneQuery<T>& q) {
  q.r = frame.edge * magnitude(random, -6, 6);
  const T times = magnitude(random, 0, 10);
  const Point foot = frame.on_face(random);
  // No edge is longer than half the perimeter, 1.5 mean edges: this is out of reach from every point of the triangle.
  q.p = foot + direction(random) * ((q.r * number(2) + frame.edge * number(2)) * times);
}

AXISCERT_INLINE Point centre_on(const Frame& frame, Random& random) {
  const T where = random.integer(0, 2), one = number(1);
  const auto v = frame.turned(random);
  const Point beside = on_edge(v, random), above = frame.on_face(random);
  return select(hn::Lt(where.v, one.v), v[0], select(hn::Eq(where.v, one.v), beside, above));
}

// Zero, the least positive number, the distance itself or a tiny radius: all equally likely.
template <class Real>
AXISCERT_INLINE void give_tiny_radius(const Frame& frame, Random& random, LaneQuery<T>& q) {
  const T how = random.integer(0, 3), ulps = random.integer(-4, 4), tiny = frame.edge * magnitude(random, -26, -6);
  const T zero = number(0), one = number(1), least = number(std::numeric_limits<Real>::denorm_min());
  const auto is_none = hn::Lt(how.v, one.v), is_least = hn::Eq(how.v, one.v), at_distance = hn::Eq(how.v, number(2).v);
  q.r = select(is_none, zero, select(is_least, least, tiny));
  q.wishes[0] = ulps;
  q.wishes[1] = select(at_distance, one, zero);
}

template <class Real>
LaneQuery<T> placed_query(Placement placement, const Frame& frame, Random& random) {
  LaneQuery<T> q;
  q.v = frame.v;
  q.r = number(0);
  q.wishes[0] = number(0);
  q.wishes[1] = number(1);
  const T height = frame.edge * magnitude(random, -6, 6);
  switch (placement) {
    case Placement::resting:
    case Placement::sinking:
    case Placement::hovering: {
      const T share = number(0.001) + number(0.499) * random.unit(), side = random.sign();
      q.p = frame.on_face(random) + frame.normal * side * height;
      if (placement == Placement::resting) q.wishes[0] = random.integer(-4, 4);
      else if (placement == Placement::sinking) q.wishes[1] = number(1) + share;
      else q.wishes[1] = number(1) - share;
      break;
    }
    case Placement::edge_graze:
      q.p = edge_centre(frame, random, height);
      q.wishes[0] = random.integer(-4, 4);
      break;
    case Placement::vertex_graze:
      q.p = vertex_centre(frame, random, height);
      q.wishes[0] = random.integer(-4, 4);
      break;
    case Placement::centre_on:
      q.p = centre_on(frame, random);
      give_tiny_radius<Real>(frame, random, q);
      break;
    case Placement::far:
      place_far(frame, random, q);
      q.wishes[1] = number(0);
      break;
  }
  return q;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
