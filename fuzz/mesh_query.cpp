// Placing spheres about one triangle of a mesh. All of it in binary64 with + - * / sqrt and ldexp, one draw a
// statement, so that an address gives the same query everywhere; the query's own precision enters with the last
// rounding.
#include <algorithm>
#include <cmath>
#include <limits>

#include "fuzz/boundary.h"
#include "fuzz/mesh.h"

namespace axiscert {
namespace {

using Point = Vec3<double>;

double length(const Point& v) { return std::sqrt(portable::dot(v, v)); }

// Zero where v is too short for its square.
Point unit_of(const Point& v) {
  const double size = length(v);
  return size > 0 ? Point{v.x / size, v.y / size, v.z / size} : Point{0, 0, 0};
}
bool is_zero(const Point& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Uniform on the sphere, by rejection.
Point direction(Stream& random) {
  for (;;) {
    Point v;
    v.x = random.symmetric<double>();
    v.y = random.symmetric<double>();
    v.z = random.symmetric<double>();
    const double square = portable::dot(v, v);
    if (square <= 1 && square >= 0x1p-20) return unit_of(v);
  }
}

// 2^low to 2^high, the exponent uniform and the significand uniform.
double magnitude(Stream& random, int low, int high) {
  const auto exponent = static_cast<int>(random.integer(low, high - 1));
  const double significand = 1 + random.unit<double>();
  return std::ldexp(significand, exponent);
}

// A rotation and a scale together: the columns are the images of the unit vectors.
struct Placed {
  Point x, y, z;
  double scale;
  Point operator()(const Vec3<float>& v) const {
    return (x * static_cast<double>(v.x) + y * static_cast<double>(v.y)) + z * static_cast<double>(v.z);
  }
};

Placed drawn_placement(Stream& random) {
  std::int64_t q[4];
  std::int64_t square = 0;
  while (square == 0) {
    for (std::int64_t& part : q) {
      part = random.integer(-9, 9);
      square += part * part;
    }
  }
  const auto exponent = static_cast<int>(random.integer(-4, 4));
  const double significand = 1 + random.unit<double>();
  const double scale = std::ldexp(significand, exponent);
  const auto [w, x, y, z] = q;
  const auto entry = [&](std::int64_t n) { return static_cast<double>(n) / static_cast<double>(square) * scale; };
  return {{entry(w * w + x * x - y * y - z * z), entry(2 * (x * y + w * z)), entry(2 * (x * z - w * y))},
          {entry(2 * (x * y - w * z)), entry(w * w - x * x + y * y - z * z), entry(2 * (y * z + w * x))},
          {entry(2 * (x * z + w * y)), entry(2 * (y * z - w * x)), entry(w * w - x * x - y * y + z * z)},
          scale};
}

// A triangle and its sizes and directions, as good as binary64 has them: nothing below relies on their being exact.
struct Frame {
  std::array<Point, 3> v;
  double edge;   // mean length, never zero
  Point normal;  // unit; any direction where the triangle has none

  Frame(const std::array<Point, 3>& vertices, double substitute, Stream& random) : v(vertices) {
    edge = ((length(v[1] - v[0]) + length(v[2] - v[1])) + length(v[0] - v[2])) / 3;
    if (!(edge > 0)) edge = substitute > 0 ? substitute : 1;
    normal = unit_of(portable::cross(v[1] - v[0], v[2] - v[0]));
    if (is_zero(normal)) normal = direction(random);
  }

  // In the plane, away from the triangle, at a right angle to the edge from v[i] to the next; zero where there is none.
  Point outward(std::size_t i) const {
    const Point from = v[i], along = v[(i + 1) % 3] - from, inner = v[(i + 2) % 3] - from;
    const double square = portable::dot(along, along);
    if (!(square > 0)) return {0, 0, 0};
    return unit_of(along * (portable::dot(inner, along) / square) - inner);
  }
  Point on_edge(std::size_t i, Stream& random) const { return v[i] + (v[(i + 1) % 3] - v[i]) * random.unit<double>(); }
  Point on_face(Stream& random) const {
    double s = random.unit<double>(), t = random.unit<double>();
    if (s + t > 1) {
      s = 1 - s;
      t = 1 - t;
    }
    return v[0] + ((v[1] - v[0]) * s + (v[2] - v[0]) * t);
  }
  Point either_normal(Stream& random) const { return normal * (random.coin() ? 1.0 : -1.0); }
};

template <class Real>
Real rounded(double x) {
  constexpr double greatest = static_cast<double>(std::numeric_limits<Real>::max());
  return static_cast<Real>(std::clamp(x, -greatest, greatest));
}
template <class Real>
Vec3<Real> rounded(const Point& p) {
  return {rounded<Real>(p.x), rounded<Real>(p.y), rounded<Real>(p.z)};
}

// P and, where the distance does not decide it, r.
struct Sphere {
  Point centre;
  double radius = 0;
};

Point edge_centre(const Frame& frame, Stream& random, double height) {
  const auto i = static_cast<std::size_t>(random.below(3));
  const Point foot = frame.on_edge(i, random);
  const double outwards = random.unit<double>();
  const double upwards = random.symmetric<double>();
  const Point towards = unit_of(frame.outward(i) * outwards + frame.normal * upwards);
  return foot + towards * height;
}

// Between the outward directions of the two edges that meet there P sees the vertex only.
Point vertex_centre(const Frame& frame, Stream& random, double height) {
  const auto i = static_cast<std::size_t>(random.below(3));
  const double first = random.unit<double>();
  const double second = random.unit<double>();
  const double upwards = random.symmetric<double>();
  const Point towards =
      unit_of((frame.outward(i) * first + frame.outward((i + 2) % 3) * second) + frame.normal * upwards);
  return frame.v[i] + towards * height;
}

Sphere far_sphere(const Frame& frame, Stream& random) {
  const double radius = frame.edge * magnitude(random, -6, 6);
  const double times = magnitude(random, 0, 10);
  const Point foot = frame.on_face(random);
  // No edge is longer than half the perimeter, 1.5 mean edges: this is out of reach from every point of the triangle.
  return {foot + direction(random) * ((radius * 2 + frame.edge * 2) * times), radius};
}

Point centre_on(const Frame& frame, Stream& random) {
  const std::uint64_t where = random.below(3);
  const auto i = static_cast<std::size_t>(random.below(3));
  if (where == 0) return frame.v[i];
  return where == 1 ? frame.on_edge(i, random) : frame.on_face(random);
}

template <class Real>
Real grazing_radius(const Query<Real>& q, Stream& random) {
  const auto ulps = static_cast<int>(random.integer(-4, 4));
  return step_radius(radius_at_distance(q), ulps);
}

template <class Real>
Real tiny_radius(const Query<Real>& q, const Frame& frame, Stream& random) {
  switch (random.below(4)) {
    case 0:
      return 0;
    case 1:
      return std::numeric_limits<Real>::denorm_min();
    case 2:
      return grazing_radius(q, random);
    default:
      return rounded<Real>(frame.edge * magnitude(random, -26, -6));
  }
}

}  // namespace

template <class Real>
Query<Real> mesh_query(const Mesh& mesh, Stream& random, std::uint64_t position) {
  const MeshTriangle& own = mesh.triangles[position % mesh.triangles.size()];
  std::array<Point, 3> vertices;
  double scale = 1;
  if constexpr (sizeof(Real) == 4) {
    for (std::size_t k = 0; k < 3; ++k) vertices[k] = {own[k].x, own[k].y, own[k].z};
  } else {
    const Placed placed = drawn_placement(random);
    for (std::size_t k = 0; k < 3; ++k) vertices[k] = placed(own[k]);
    scale = placed.scale;
  }
  const Frame frame(vertices, mesh.diagonal * scale, random);
  Query<Real> q{rounded<Real>(vertices[0]), rounded<Real>(vertices[1]), rounded<Real>(vertices[2]), {}, 0};

  const Placement placement = placement_at(position, mesh.triangles.size());
  const double height = frame.edge * magnitude(random, -6, 6);
  const double share = 0.001 + 0.499 * random.unit<double>();
  const auto above_face = [&] {
    const Point foot = frame.on_face(random);
    return rounded<Real>(foot + frame.either_normal(random) * height);
  };
  switch (placement) {
    case Placement::resting:
      q.p = above_face();
      q.r = grazing_radius(q, random);
      break;
    case Placement::sinking:
      q.p = above_face();
      q.r = rounded<Real>(static_cast<double>(radius_at_distance(q)) * (1 + share));
      break;
    case Placement::hovering:
      q.p = above_face();
      q.r = rounded<Real>(static_cast<double>(radius_at_distance(q)) * (1 - share));
      break;
    case Placement::edge_graze:
      q.p = rounded<Real>(edge_centre(frame, random, height));
      q.r = grazing_radius(q, random);
      break;
    case Placement::vertex_graze:
      q.p = rounded<Real>(vertex_centre(frame, random, height));
      q.r = grazing_radius(q, random);
      break;
    case Placement::centre_on:
      q.p = rounded<Real>(centre_on(frame, random));
      q.r = tiny_radius(q, frame, random);
      break;
    case Placement::far: {
      const Sphere sphere = far_sphere(frame, random);
      q.p = rounded<Real>(sphere.centre);
      q.r = rounded<Real>(sphere.radius);
      break;
    }
  }
  return q;
}
template Query<float> mesh_query<float>(const Mesh&, Stream&, std::uint64_t);
template Query<double> mesh_query<double>(const Mesh&, Stream&, std::uint64_t);

}  // namespace axiscert
