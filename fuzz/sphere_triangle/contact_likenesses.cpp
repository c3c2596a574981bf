#include "fuzz/sphere_triangle/capability_parts.h"

#include <cmath>

#include "kernel/base/geometry.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert {
namespace {

using Double3 = portable::Vec3<double>;
using portable::cross;
using portable::dot;

struct Placed {
  Double3 a, b, c, p;
  double r;
};
Placed placed(const Numbers<double>& q) {
  const auto point = [&](std::size_t k) { return Double3{q[k], q[k + 1], q[k + 2]}; };
  return {point(0), point(3), point(6), point(9), q[12]};
}
std::vector<double> list(const Double3& v) { return {v.x, v.y, v.z}; }
std::vector<double> unit(const Double3& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? list(v / size) : std::vector<double>();
}

std::vector<double> against_plane(const Numbers<double>& q, std::size_t) {
  const auto [a, b, c, p, r] = placed(q);
  const Double3 normal = cross(b - a, c - a);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0)) return {};
  return {std::abs(dot(p - a, normal)) / size - r};
}
std::vector<double> of_centres(const Numbers<double>& q, std::size_t) {
  const auto [a, b, c, p, r] = placed(q);
  return unit(p - (a + b + c) / 3.0);
}
std::vector<double> of_face(const Numbers<double>& q, std::size_t) {
  const auto [a, b, c, p, r] = placed(q);
  const Double3 normal = cross(b - a, c - a);
  return unit(dot(p - a, normal) < 0 ? normal * -1.0 : normal);
}
std::vector<double> on_the_sphere(const Numbers<double>& q, std::size_t) {
  const auto [a, b, c, p, r] = placed(q);
  const Double3 to = methods::ClosestPoint::closest(portable::CentredProblem<double>{a - p, b - p, c - p, r * r}, 0.0);
  const double size = std::sqrt(dot(to, to));
  return size > 0 ? list(p + to * (r / size)) : std::vector<double>();
}

}  // namespace

std::span<const ContactLikeness* const> sphere_triangle_contact_likenesses() {
  static constexpr ContactLikeness
      plane = {MeasureKind::separation, "against_plane",
               "It is the distance to the triangle's plane, less the radius, wherever the triangle ends",
               against_plane},
      centres = {MeasureKind::normal, "of_centres", "It goes from the middle of the triangle to the centre",
                 of_centres},
      face = {MeasureKind::normal, "of_face", "It is the face's, beside edges and vertices too", of_face},
      sphere = {MeasureKind::point, "other_body", "It is on the sphere, and has to be the triangle's", on_the_sphere};
  static constexpr const ContactLikeness* all[] = {&plane, &centres, &face, &sphere};
  return all;
}

}  // namespace axiscert
