#include "fuzz/queries/capabilities.h"

#include <algorithm>
#include <cmath>

#include "exact/capsule_triangle/contact.h"
#include "fuzz/capsule_triangle/situations.h"
#include "kernel/capsule_triangle/capsule.h"

namespace axiscert {
namespace {

EndsQuery<double> given(const Numbers<double>& q) {
  return Capsule::problem<double>([&](std::size_t k) { return q[k]; });
}

// How far the segment's nearer end is from the triangle's plane, less the radius; minus the radius where it crosses it.
std::vector<double> above_plane(const Numbers<double>& numbers, std::size_t) {
  const EndsQuery<double> q = given(numbers);
  const portable::Vec3<double> normal = cross(q.b - q.a, q.c - q.a);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0)) return {};
  const double first = dot(q.p - q.a, normal) / size, second = dot(q.p1 - q.a, normal) / size;
  const bool crosses = (first < 0) != (second < 0);
  return {(crosses ? 0 : std::min(std::fabs(first), std::fabs(second))) - q.r};
}

// From the middle of the segment to the middle of the triangle.
std::vector<double> between_middles(const Numbers<double>& numbers, std::size_t) {
  const EndsQuery<double> q = given(numbers);
  const portable::Vec3<double> way = (q.a + q.b + q.c) / 3.0 - (q.p + q.p1) * 0.5;
  const double size = std::sqrt(dot(way, way));
  if (!(size > 0)) return {};
  return {way.x / size, way.y / size, way.z / size};
}

constexpr ContactLikeness plane = {MeasureKind::separation, "against_plane",
                                   "It is the distance to the triangle's plane, less the radius", above_plane},
                          middles = {MeasureKind::normal, "of_centres",
                                     "It goes from the middle of the capsule to the middle of the triangle",
                                     between_middles};
constexpr const ContactLikeness* likenesses[] = {&plane, &middles};

}  // namespace

const Capabilities& capsule_triangle_capabilities() {
  static constexpr std::string_view correct_forms[] = {"capsule-triangle/twenty-nonstrict"};
  static const Capabilities all = {
      .section_of_forms = capsule::situation::section,
      .situations = &capsule::situation::all,
      .correct_forms = correct_forms,
      .contact_likenesses = likenesses,
      .exact_facts = [](const Numbers<double>& q, std::size_t) { return capsule::exact_facts(given(q)); }};
  return all;
}

}  // namespace axiscert
