// The sweep of a sphere against one triangle in two generations of PhysX, up to the sphere or capsule that is asked.
#pragma once

#include <array>
#include <cmath>

#include "kernel/moving_sphere/timed.h"
#include "kernel/sphere_triangle/formulae/methods.h"

namespace axiscert::moving_sphere::physx {

// A ray from `origin` along the unit vector `along`.
template <class Real>
struct Ray {
  portable::Vec3<Real> origin, along;
};

template <class Real>
using Corners = std::array<portable::Vec3<Real>, 3>;

// Its threshold of a determinant with a unit direction, in the user's units of area; the same number in any precision.
inline constexpr double least_determinant = 1e-5;
// It begins nearer to what it meets, by all but this of the way that is free, in the user's units of length.
inline constexpr double kept_back = 10;

// The nearest contact along the sweep of a sphere, as a distance. Zero where the start overlaps; else a ray from the
// point of the sphere that meets the plane first: if it hits the triangle, there; if not, its place in the plane, by
// barycentric weights u of B and v of C, decides which vertex or edges `Rest` asks. A length above |D| is no hit.
//
// Wrong over the reals: a determinant below 1e-5, which is a motion parallel to the plane or an area below 5e-6, is no
// hit whatever the edges say; zero area is left out; D = 0 has no direction, and is left out with it.
// Source: PhysX 4.1 and 5, the function that sweeps a sphere against a triangle, with its predicate of the initial
// overlap.
template <class Rest>
struct Sweep {
  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    using Vector = portable::Vec3<Real>;
    const Corners<Real> corner{q.a, q.b, q.c};
    const Vector one = corner[1] - corner[0], other = corner[2] - corner[0], crossed = cross(one, other);
    const Real area = std::sqrt(dot(crossed, crossed)), length = std::sqrt(dot(q.d, q.d));
    if (area == 0 || length == 0) return std::nullopt;
    const Ray<Real> centre{q.p, q.d / length};

    const Vector nearest = methods::ClosestPoint::closest(
        portable::CentredProblem<Real>{q.a - q.p, q.b - q.p, q.c - q.p, Real(0)}, Real(0));
    if (dot(nearest, nearest) <= q.r * q.r) return Real(0);

    Vector out = (crossed / area) * q.r;
    if (dot(centre.along, out) >= 0) out = out * Real(-1);
    const Vector turned = cross(centre.along, other);
    const Real determinant = dot(one, turned);
    if (std::fabs(determinant) < Real(least_determinant)) return std::nullopt;
    const Vector from_a = (centre.origin - out) - corner[0], around = cross(from_a, one);
    const Real inverse = 1 / determinant;
    const Real u = dot(from_a, turned) * inverse, v = dot(centre.along, around) * inverse;
    const bool inside = !(u < 0 || u > 1 || v < 0 || u + v > 1);
    const std::optional<Real> distance =
        inside ? ahead(dot(other, around) * inverse) : Rest::hit(centre, corner, q.r, u, v);
    if (!distance || *distance > length) return std::nullopt;
    return *distance / length;
  }

 private:
  template <class Real>
  static std::optional<Real> ahead(Real distance) {
    return distance < 0 ? std::nullopt : std::optional(distance);
  }
};

// The region of a point of the plane outside the triangle: behind one edge, or at a vertex, which is between two.
struct Region {
  std::size_t at, one, other;  // a vertex; or the edge from `at` to `one`, where `other` is `at`
  bool is_edge() const { return other == at; }
};
template <class Real>
Region region_of(Real u, Real v) {
  const bool beyond = u + v > 1;
  if (u < 0) {
    if (v < 0) return {0, 1, 2};
    return beyond ? Region{2, 0, 1} : Region{0, 2, 0};
  }
  if (v < 0) return beyond ? Region{1, 0, 2} : Region{0, 1, 0};
  return {1, 2, 1};
}

// The distance of a point from a segment.
template <class Real>
Real segment_distance(const portable::Vec3<Real>& from, const portable::Vec3<Real>& to,
                      const portable::Vec3<Real>& point) {
  const auto along = to - from;
  auto between = point - from;
  const Real e = dot(along, along), share = dot(between, along);
  if (share > 0) between = share >= e ? between - along : between - along * (share / e);
  return std::sqrt(dot(between, between));
}

// A capsule of radius r: 0 where the ray begins in it, else `inside`(the ray begun nearer) plus the way left out.
template <class Real, class Inside>
std::optional<Real> capsule_hit(const Ray<Real>& ray, const portable::Vec3<Real>& from, const portable::Vec3<Real>& to,
                                Real r, Inside&& inside) {
  Real skipped = segment_distance(from, to, ray.origin) - r;
  if (skipped <= 0) return Real(0);
  skipped = skipped > Real(kept_back) ? skipped - Real(kept_back) : Real(0);
  const std::optional<Real> hit = inside(Ray<Real>{ray.origin + ray.along * skipped, ray.along});
  if (!hit || !(*hit + skipped >= 0)) return std::nullopt;
  return *hit + skipped;
}

}  // namespace axiscert::moving_sphere::physx
