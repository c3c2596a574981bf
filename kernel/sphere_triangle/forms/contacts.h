// What the two methods say beside their verdicts, in floats: separation, feature, normal and point, as users of engines
// compute them. Nothing is certified here; the judge says how far they are off.
#pragma once

#include "kernel/sphere_triangle/formulae.h"

namespace axiscert::methods {

inline constexpr std::size_t contact_measures = 8;  // of the predicate, all

// The nearest point of the triangle seen from the centre, and the part that has it: 0, 1, 2 vertex a, b, c; 3, 4, 5
// edge ab, bc, ca; 6 the face.
template <class T>
struct NearestPart {
  portable::Vec3<T> point;
  int feature;
};

// A direction that parts the two where the centre is on the triangle: of the face, across an edge of a triangle without
// area, or any.
template <class Real>
portable::Vec3<Real> parting_direction(const portable::Vec3<Real>& from, const portable::Vec3<Real>& to,
                                       const portable::Vec3<Real>& face) {
  if (dot(face, face) > 0) return face;
  const auto along = to - from;
  const Real x = along.x < 0 ? -along.x : along.x, y = along.y < 0 ? -along.y : along.y;
  if (x > y) return {-along.z, 0, along.x};
  return y > 0 ? portable::Vec3<Real>{0, along.z, -along.y} : portable::Vec3<Real>{1, 0, 0};
}

// Writes the measures: `away` is from the nearest point to the centre, or another direction where that is 0. The sign
// of the separation is that of the verdict, from whose comparison it may differ by rounding.
template <class Real>
void put_contact(const portable::Problem<Real>& q, const NearestPart<Real>& nearest, portable::Vec3<Real> away,
                 bool is_separated, Real* out) {
  const Real distance = portable::square_root(dot(nearest.point, nearest.point));
  const Real separation = distance - q.r, zero = 0;
  out[0] = is_separated ? (separation < zero ? zero : separation) : (separation > zero ? zero : separation);
  out[1] = static_cast<Real>(nearest.feature);
  const Real length = portable::square_root(dot(away, away));
  out[2] = away.x / length;
  out[3] = away.y / length;
  out[4] = away.z / length;
  out[5] = q.p.x + nearest.point.x;
  out[6] = q.p.y + nearest.point.y;
  out[7] = q.p.z + nearest.point.z;
}

// By the closest point: the normal goes from there to the centre.
template <class Real>
void closest_point_contact(const portable::Problem<Real>& q, const NearestPart<Real>& nearest, bool is_separated,
                           Real* out) {
  auto away = portable::Vec3<Real>{-nearest.point.x, -nearest.point.y, -nearest.point.z};
  if (dot(away, away) == 0) away = parting_direction(q.a, q.b, cross(q.b - q.a, q.c - q.a));
  put_contact(q, nearest, away, is_separated, out);
}

// By the triangle inflated by the radius: the nearest of the parts that the centre is over, and over the face the
// normal of its plane.
template <class Real>
void minkowski_contact(const portable::Problem<Real>& q, bool is_separated, Real* out) {
  const auto [A, B, C, rr] = portable::centred(q);
  const auto V = cross(B - A, C - A);
  NearestPart<Real> nearest{A, 0};
  portable::Vec3<Real> away = {-A.x, -A.y, -A.z};
  Real least = dot(A, A);
  const auto offer = [&](const portable::Vec3<Real>& point, int feature) {
    const Real squared = dot(point, point);
    if (!(squared < least)) return;
    least = squared;
    nearest = {point, feature};
    away = {-point.x, -point.y, -point.z};
  };
  offer(B, 1);
  offer(C, 2);
  const auto offer_edge = [&](const auto& from, const auto& to, int feature) {
    const auto along = to - from;
    const Real t = -dot(from, along), e = dot(along, along);
    if (t > 0 && e > t) offer(from + along * (t / e), feature);
  };
  offer_edge(A, B, 3);
  offer_edge(B, C, 4);
  offer_edge(C, A, 5);
  const auto is_inside = [&](const auto& from, const auto& to) { return dot(cross(from, to), V) > 0; };
  if (is_inside(A, B) && is_inside(B, C) && is_inside(C, A)) {
    const Real d = dot(A, V);
    nearest = {V * (d / dot(V, V)), 6};
    away = d > 0 ? portable::Vec3<Real>{-V.x, -V.y, -V.z} : V;
  }
  if (dot(away, away) == 0) away = parting_direction(A, B, V);
  put_contact(q, nearest, away, is_separated, out);
}

}  // namespace axiscert::methods
