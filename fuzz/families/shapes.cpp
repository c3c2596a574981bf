#include "fuzz/families/shapes.h"

#include <algorithm>
#include <cmath>

#include "fuzz/boundary.h"

namespace axiscert::shapes {

std::array<std::int64_t, 3> weights(Stream& random, Axis axis, std::int64_t parts) {
  std::array<std::int64_t, 3> w{};
  const auto number = static_cast<std::size_t>(axis);
  if (axis == Axis::plane) {
    w[0] = random.integer(1, parts - 2);
    w[1] = random.integer(1, parts - 1 - w[0]);
    w[2] = parts - w[0] - w[1];
  } else if (number < 4) {
    w[number - 1] = parts;
  } else {
    w[number - 4] = random.integer(1, parts - 1);
    w[next(number - 4)] = parts - w[number - 4];
  }
  return w;
}

template <class Real>
Vec3<Real> scaled(const Vec3<Real>& v, int exponent) {
  return {std::ldexp(v.x, exponent), std::ldexp(v.y, exponent), std::ldexp(v.z, exponent)};
}

template <class Real>
Vec3<Real> at_unit_length(const Vec3<Real>& v) {
  const Real length = std::sqrt(dot(v, v));
  return length > 0 ? Vec3<Real>{v.x / length, v.y / length, v.z / length} : v;
}

template <class Real>
Directions<Real> directions(const Vertices<Real>& vertices) {
  Directions<Real> result;
  result.normal = at_unit_length(cross(vertices[1] - vertices[0], vertices[2] - vertices[0]));
  for (std::size_t i = 0; i < 3; ++i) {
    result.outward[i] = at_unit_length(cross(vertices[next(i)] - vertices[i], result.normal));
  }
  return result;
}

template <class Real>
Vec3<Real> inside(Stream& random, const Vertices<Real>& vertices) {
  std::array<Real, 3> weight;
  for (Real& w : weight) w = random.unit<Real>() + Real(0x1p-5);
  const Real sum = (weight[0] + weight[1]) + weight[2];
  return (vertices[0] * (weight[0] / sum) + vertices[1] * (weight[1] / sum)) + vertices[2] * (weight[2] / sum);
}

template <class Real>
Vec3<Real> inside_edge(Stream& random, const Vertices<Real>& vertices, std::size_t edge) {
  const Real t = Real(0x1p-5) + random.unit<Real>() * Real(0.9375);
  return vertices[edge] + (vertices[next(edge)] - vertices[edge]) * t;
}

template <class Real>
Real height(Stream& random) {
  const Real significand = 1 + random.unit<Real>();
  return std::ldexp(significand, -static_cast<int>(random.below(8)));
}

template <class Real>
Query<Real> placed(Stream& random, const Vertices<Real>& around_origin, int halvings) {
  Query<Real> q = query(around_origin, in_cube<Real>(random));
  if (random.below(4) == 0) q.p = scaled(q.p, -static_cast<int>(random.integer(0, halvings)));
  if (!random.coin()) return q;
  const Vec3<Real> offset = in_cube<Real>(random);
  return {q.a + offset, q.b + offset, q.c + offset, q.p + offset, 0};
}

template <class Real>
Real radius_near_distance(Stream& random, const Query<Real>& q, int ulps) {
  return step_radius(radius_at_distance(q), static_cast<int>(random.integer(-ulps, ulps)));
}

template <class Real>
Real aimed_radius(Stream& random, const Query<Real>& q) {
  switch (random.below(4)) {
    case 0:
      return radius_near_distance(random, q, 4);
    case 1: {
      const Real sign = random.coin() ? Real(1) : Real(-1);
      const Real off = std::ldexp(sign, -static_cast<int>(random.integer(1, 20)));
      return radius_at_distance(q) * (1 + off);
    }
    default: {
      const Vec3<Real> a = q.a - q.p, b = q.b - q.p, c = q.c - q.p;
      return random.unit<Real>() * std::sqrt(std::max({dot(a, a), dot(b, b), dot(c, c)}));
    }
  }
}

#define AXISCERT_INSTANTIATE(Real)                                                    \
  template Vec3<Real> scaled<Real>(const Vec3<Real>&, int);                           \
  template Vec3<Real> at_unit_length<Real>(const Vec3<Real>&);                        \
  template Directions<Real> directions<Real>(const Vertices<Real>&);                  \
  template Vec3<Real> inside<Real>(Stream&, const Vertices<Real>&);                   \
  template Vec3<Real> inside_edge<Real>(Stream&, const Vertices<Real>&, std::size_t); \
  template Real height<Real>(Stream&);                                                \
  template Query<Real> placed<Real>(Stream&, const Vertices<Real>&, int);             \
  template Real radius_near_distance<Real>(Stream&, const Query<Real>&, int);         \
  template Real aimed_radius<Real>(Stream&, const Query<Real>&);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)

}  // namespace axiscert::shapes
