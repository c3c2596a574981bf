// The sweep of a sphere against one triangle in two generations of PhysX, up to the sphere or capsule that is asked.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "kernel/moving_sphere/timed.h"
#include "kernel/sphere_triangle/forms/methods.h"

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

namespace axiscert::moving_sphere::physx {

// PhysX 4.1: the sphere's ray against one vertex's sphere or one edge's capsule.

// Outside the triangle one of its vertices or edges is asked and no other, chosen by the place where a ray from the
// sphere's first point meets the plane. Over the reals that is wrong where the sphere comes at a slant and meets its
// neighbour first: missed, or late. At a vertex it is an edge's if the place is not beyond the edge's end.
struct OneCapsule {
  template <class Real>
  static std::optional<Real> hit(const Ray<Real>& ray, const Corners<Real>& corner, Real r, Real u, Real v) {
    const Region region = region_of(u, v);
    if (region.is_edge()) return capsule(ray, corner[region.at], corner[region.one], r);
    const auto place = corner[1] * u + corner[2] * v + corner[0] * (1 - u - v);
    for (const std::size_t to : {region.one, region.other}) {
      const auto along = corner[region.at] - corner[to];
      if (dot(along, place - corner[to]) < dot(along, along)) return capsule(ray, corner[region.at], corner[to], r);
    }
    return sphere(ray, std::numeric_limits<Real>::max(), corner[region.at], r);
  }

 private:
  static constexpr double least_edge = 1e-6;        // a shorter capsule is a sphere
  static constexpr double slack_along_edge = 1e-3;  // by which a foot may be beyond an edge's end
  static constexpr double parallel = 0x1p-23;       // by which the cosine may fall short of 1

  // Both begin nearer by the free way less kept_back, and see nothing behind or past `length`.
  template <class Real>
  static std::optional<Real> sphere(const Ray<Real>& ray, Real length, const portable::Vec3<Real>& at, Real r) {
    const auto seen = ray.origin - at;
    const Real skipped = std::max(std::sqrt(dot(seen, seen)) - r - Real(kept_back), Real(0));
    const auto offset = at - (ray.origin + ray.along * skipped);
    const Real ahead = dot(ray.along, offset), squared = dot(offset, offset), rr = r * r;
    if (squared <= rr) return skipped;
    if (ahead <= 0 || ahead - (length - skipped) > r) return std::nullopt;
    const Real left = rr - (squared - ahead * ahead);
    if (left < 0) return std::nullopt;
    const Real hit = ahead - std::sqrt(left);
    return hit > length - skipped ? std::nullopt : std::optional(hit + skipped);
  }

  template <class Real>
  static std::optional<Real> capsule(const Ray<Real>& begun, const portable::Vec3<Real>& from,
                                     const portable::Vec3<Real>& to, Real r) {
    return capsule_hit(begun, from, to, r, [&](const Ray<Real>& ray) { return in_frame(ray, from, to, r); });
  }

  // Two vectors at right angles to the unit vector w.
  template <class Real>
  static std::pair<portable::Vec3<Real>, portable::Vec3<Real>> across(const portable::Vec3<Real>& w) {
    portable::Vec3<Real> u;
    if (std::fabs(w.x) >= std::fabs(w.y)) {
      const Real inverse = 1 / std::sqrt(w.x * w.x + w.z * w.z);
      u = {-w.z * inverse, 0, w.x * inverse};
    } else {
      const Real inverse = 1 / std::sqrt(w.y * w.y + w.z * w.z);
      u = {0, w.z * inverse, -w.y * inverse};
    }
    const auto v = cross(w, u);
    return {u, v / std::sqrt(dot(v, v))};
  }

  // The least of the hits found, in the capsule's own frame with z along it: two of the cylinder's wall, or what the
  // wall and the two half spheres give until there are two.
  template <class Real>
  static std::optional<Real> in_frame(const Ray<Real>& ray, const portable::Vec3<Real>& from,
                                      const portable::Vec3<Real>& to, Real r) {
    using Vector = portable::Vec3<Real>;
    const Vector along = to - from;
    const Real length = std::sqrt(dot(along, along)), rr = r * r;
    if (length <= Real(least_edge)) {
      const auto squared_to = [&](const Vector& end) { return dot(ray.origin - end, ray.origin - end); };
      return sphere(ray, (std::max(squared_to(from), squared_to(to)) + r) * 2, from, r);
    }
    const Vector w = along / length;
    const auto [u, v] = across(w);
    Vector direction{dot(u, ray.along), dot(v, ray.along), dot(w, ray.along)};
    const Real speed = std::sqrt(dot(direction, direction)), inverse = speed != 0 ? 1 / speed : Real(0);
    direction = direction * inverse;
    const Vector seen = ray.origin - from, place{dot(u, seen), dot(v, seen), dot(w, seen)};
    const Real flat_c = place.x * place.x + place.y * place.y - rr;

    if (std::fabs(direction.z) >= 1 - Real(parallel) || speed < Real(parallel)) {
      const Real heading = dot(ray.along, w);
      if (flat_c > 0 || heading == 0) return std::nullopt;
      const Real depth = std::sqrt(-flat_c);
      const Real near = heading < 0 ? place.z - length - depth : -(place.z + depth);
      const Real far = heading < 0 ? place.z + depth : length - place.z + depth;
      return std::min(near, far) * inverse;
    }

    FoundRoots<Real> found{inverse};
    const Real a = direction.x * direction.x + direction.y * direction.y;
    const Real flat_b = place.x * direction.x + place.y * direction.y;
    const Real discriminant = flat_b * flat_b - a * flat_c;
    if (discriminant < 0) return std::nullopt;
    if (discriminant > 0) {
      const Real root = std::sqrt(discriminant), over = 1 / a;
      for (const Real t : {(-flat_b - root) * over, (-flat_b + root) * over}) {
        const Real foot = place.z + t * direction.z;
        if (foot >= -Real(slack_along_edge) && foot <= length + Real(slack_along_edge)) found.take(t);
      }
      if (found.count == 2) return found.least;
    } else {
      const Real t = -flat_b / a, foot = place.z + t * direction.z;
      if (0 <= foot && foot <= length) return t * inverse;
    }
    const Real b = flat_b + place.z * direction.z, c = flat_c + place.z * place.z;
    half_sphere(found, b, c, [&](Real t) { return place.z + t * direction.z <= 0; });
    half_sphere(found, b - direction.z * length, c + length * (length - 2 * place.z),
                [&](Real t) { return place.z + t * direction.z >= length; });
    return found.count == 0 ? std::nullopt : std::optional(found.least);
  }

  template <class Real>
  struct FoundRoots {
    Real scale;
    int count = 0;
    Real least = std::numeric_limits<Real>::infinity();
    void take(Real t) {
      if (count == 2) return;
      ++count;
      least = std::min(least, t * scale);
    }
  };

  // The roots of t^2 + 2 b t + c that are on its half.
  template <class Real, class IsOnHalf>
  static void half_sphere(FoundRoots<Real>& found, Real b, Real c, IsOnHalf&& is_on_half) {
    const Real discriminant = b * b - c;
    if (discriminant < 0) return;
    const Real root = std::sqrt(discriminant);
    if (is_on_half(-b - root)) found.take(-b - root);
    if (root > 0 && is_on_half(-b + root)) found.take(-b + root);
  }
};

}  // namespace axiscert::moving_sphere::physx

namespace axiscert::moving_sphere {
using PhysX4 = physx::Sweep<physx::OneCapsule>;
}

namespace axiscert::moving_sphere::physx {

// PhysX 5: against one or two capsules.

// Outside the triangle the region of the plane's point says which edge's capsule is asked, at a vertex those of both
// edges, and the nearer hit counts. Over the reals that misses nothing; what Sweep gives up is still missed.
struct TwoCapsules {
  template <class Real>
  static std::optional<Real> hit(const Ray<Real>& ray, const Corners<Real>& corner, Real r, Real u, Real v) {
    const Region region = region_of(u, v);
    std::optional<Real> first = capsule(ray, corner[region.at], corner[region.one], r);
    if (region.is_edge()) return first;
    const std::optional<Real> second = capsule(ray, corner[region.at], corner[region.other], r);
    return !first || (second && *second < *first) ? second : first;
  }

 private:
  template <class Real>
  static std::optional<Real> capsule(const Ray<Real>& begun, const portable::Vec3<Real>& from,
                                     const portable::Vec3<Real>& to, Real r) {
    return capsule_hit(begun, from, to, r, [&](const Ray<Real>& ray) -> std::optional<Real> {
      const auto along = to - from, seen = ray.origin - from;
      const Real e = dot(along, along), inverse = e != 0 ? 1 / e : Real(0);
      const Real slope = dot(along, ray.along) * inverse, share = dot(along, seen) * inverse;
      const auto turned = ray.along - along * slope, away = seen - along * share;
      const Real a = dot(turned, turned), b = 2 * dot(turned, away), c = dot(away, away) - r * r;
      if (a == 0) {  // parallel: both ends have to be met
        const auto one = sphere(ray, from, r), other = sphere(ray, to, r);
        if (!one || !other) return std::nullopt;
        return *one < *other ? one : other;
      }
      const auto t = lesser_root(a, b, c);
      if (!t) return std::nullopt;
      const Real foot = *t * slope + share;
      if (foot < 0) return sphere(ray, from, r);
      if (foot > 1) return sphere(ray, to, r);
      return t;
    });
  }

  template <class Real>
  static std::optional<Real> sphere(const Ray<Real>& ray, const portable::Vec3<Real>& at, Real r) {
    const auto seen = ray.origin - at;
    return lesser_root(dot(ray.along, ray.along), 2 * dot(seen, ray.along), dot(seen, seen) - r * r);
  }
  // The lesser root of a t^2 + b t + c, with a > 0.
  template <class Real>
  static std::optional<Real> lesser_root(Real a, Real b, Real c) {
    const Real discriminant = b * b - 4 * a * c;
    if (discriminant < 0) return std::nullopt;
    return (-b - std::sqrt(discriminant)) * (1 / (2 * a));
  }
};

}  // namespace axiscert::moving_sphere::physx

namespace axiscert::moving_sphere {
using PhysX5 = physx::Sweep<physx::TwoCapsules>;
}
