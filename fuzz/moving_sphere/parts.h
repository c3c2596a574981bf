// Parts of the moving sphere's families: a triangle of integers that a sphere at X + n touches in X alone, or along a
// feature of it.
#pragma once

#include <array>
#include <cmath>
#include <utility>

#include "fuzz/moving_sphere/situations.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/floats.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::moving_sphere {

using portable::cross;
using portable::dot;
using portable::Vec3;
using Whole = Vec3<std::int64_t>;

enum class FeatureKind { face, vertex, edge };

// The vertices' order is random. n.n = r r, and n.(Y - at) <= 0 for every vertex Y, with equality on the feature.
struct TouchedTriangle {
  std::array<Whole, 3> vertex;
  Whole at, normal;
  std::int64_t r;
  Whole along;  // the edge's direction, or one in the plane of normal n through `at`
};

// A vector of integers with an integer length.
inline std::pair<Whole, std::int64_t> whole_normal(Stream& random) {
  static constexpr std::array<std::array<std::int64_t, 4>, 10> all = {{{0, 0, 1, 1},
                                                                       {0, 3, 4, 5},
                                                                       {1, 2, 2, 3},
                                                                       {2, 3, 6, 7},
                                                                       {1, 4, 8, 9},
                                                                       {4, 4, 7, 9},
                                                                       {2, 6, 9, 11},
                                                                       {6, 6, 7, 11},
                                                                       {3, 4, 12, 13},
                                                                       {2, 5, 14, 15}}};
  auto [x, y, z, r] = all[random.below(all.size())];
  if (random.coin()) std::swap(x, y);
  if (random.coin()) std::swap(y, z);
  if (random.coin()) std::swap(x, y);
  if (random.coin()) x = -x;
  if (random.coin()) y = -y;
  if (random.coin()) z = -z;
  return {{x, y, z}, r};
}

// An integer vector at right angles to n, not 0.
inline Whole across(Stream& random, const Whole& n) {
  const Whole u = cross(n, shapes::integers(random, 3));
  if (dot(u, u) != 0) return u;
  const Whole v = cross(n, Whole{1, 0, 0});  // n was along the first choice
  return dot(v, v) != 0 ? v : cross(n, Whole{0, 1, 0});
}

// An integer vector w with n.w <= 0.
inline Whole behind(Stream& random, const Whole& n, std::int64_t bound = 20) {
  const Whole w = shapes::integers(random, bound);
  return dot(n, w) > 0 ? Whole{0, 0, 0} - w : w;
}
// The same with n.w < 0.
inline Whole against(Stream& random, const Whole& n, std::int64_t bound = 20) {
  const Whole w = behind(random, n, bound);
  return dot(n, w) < 0 ? w : w - n;
}

inline TouchedTriangle touched(Stream& random, FeatureKind feature) {
  TouchedTriangle t;
  std::tie(t.normal, t.r) = whole_normal(random);
  t.at = shapes::integers(random, 20);
  t.along = across(random, t.normal);
  switch (feature) {
    case FeatureKind::vertex:
      t.vertex = {t.at, t.at + behind(random, t.normal), t.at + behind(random, t.normal)};
      break;
    case FeatureKind::edge: {
      const std::int64_t before = random.integer(1, 3), after = random.integer(1, 3);
      t.vertex = {t.at - t.along * before, t.at + t.along * after, t.at + behind(random, t.normal)};
      break;
    }
    case FeatureKind::face: {
      Whole other = cross(t.normal, t.along);
      if (random.coin()) other = other + t.along;
      t.vertex = {t.at + t.along, t.at + other, t.at - t.along - other};  // `at` is their centroid
      break;
    }
  }
  t.vertex = shapes::shuffled(random, t.vertex);
  return t;
}

constexpr FeatureKind feature_in_turn(std::uint64_t position) { return static_cast<FeatureKind>(position % 3); }

// All numbers times one odd integer, so that products have to be rounded, though the query is exact. The numbers are
// below 2^13 in magnitude.
template <class Real>
MovingQuery<Real> spread(Stream& random, const std::array<Whole, 3>& vertex, const Whole& p, const Whole& d,
                         std::int64_t r) {
  const std::int64_t bound = sizeof(Real) == 4 ? 1 << 10 : 1 << 30, factor = 2 * random.integer(0, bound / 2 - 1) + 1;
  const auto real = [&](const Whole& v) {
    const Whole w = v * factor;
    return Vec3<Real>{static_cast<Real>(w.x), static_cast<Real>(w.y), static_cast<Real>(w.z)};
  };
  return {real(vertex[0]), real(vertex[1]), real(vertex[2]), real(p), real(d), static_cast<Real>(r * factor)};
}

// In turn, in runs of three positions: as it is (every other time), else the radius or a coordinate of P moved by up to
// four ulps.
template <class Real>
void nudge(Stream& random, std::uint64_t position, MovingQuery<Real>& q) {
  const std::uint64_t turn = position / 3 % 4;
  const int ulps = static_cast<int>(random.integer(1, 4)), signed_ulps = random.coin() ? ulps : -ulps;
  const auto which = random.below(3);
  if (turn == 1) q.r = step_radius(q.r, signed_ulps);
  Real& coordinate = which == 0 ? q.p.x : which == 1 ? q.p.y : q.p.z;
  if (turn == 3) coordinate = step_ulps(coordinate, signed_ulps);
}

// Integers up to m in magnitude, and a radius in halves up to 4 m, on which no operation of `twenty` rounds: the
// greatest term is (r r) (V.V), in quarters at most 12,288 m^6, below 2^24 for m = 3 and below 2^53 for m = 90.
template <class Real>
MovingQuery<Real> small_integers(Stream& random, std::int64_t m) {
  const auto point = [&] {
    const auto x = static_cast<Real>(random.integer(-m, m)), y = static_cast<Real>(random.integer(-m, m));
    const auto z = static_cast<Real>(random.integer(-m, m));
    return Vec3<Real>{x, y, z};
  };
  const Vec3<Real> a = point(), b = point(), c = point(), p = point(), d = point();
  const auto halves = static_cast<Real>(random.integer(0, 8 * m));
  return {a, b, c, p, d, halves * Real(0.5)};
}

template <auto one32, auto one64, std::uint32_t version = 1>
constexpr Family moving_family(std::string_view name, const Situation& situation, std::string_view purpose,
                               bool exact_arithmetic = false) {
  return {.predicate = moving_sphere_predicate,
          .name = name,
          .purpose = purpose,
          .version = version,
          .exact_arithmetic = exact_arithmetic,
          .binary32 = fill_one_by_one<one32, float>,
          .binary64 = fill_one_by_one<one64, double>,
          .situation = &situation};
}

}  // namespace axiscert::moving_sphere
