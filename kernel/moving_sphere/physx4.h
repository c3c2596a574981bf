// PhysX 4.1: the sphere's ray against one vertex's sphere or one edge's capsule.
#pragma once

#include <algorithm>
#include <limits>

#include "kernel/moving_sphere/physx.h"

namespace axiscert::moving_sphere::physx {

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
