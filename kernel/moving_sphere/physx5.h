// PhysX 5: the sphere's ray against one or two capsules.
#pragma once

#include <utility>

#include "kernel/moving_sphere/physx.h"

namespace axiscert::moving_sphere::physx {

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
