// Kernels that show a verdict alone, each with one property that is known because it is made so.
#pragma once

#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "fuzz/queries/floats.h"
#include "kernel/base/environment.h"
#include "kernel/sphere_triangle/forms/contracted.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/forms/scalar_kernel.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::made {

template <class Real>
Verdict by_reference(Formulae formulae, const Query<Real>& q, Strictness strictness = Strictness::strict) {
  return reference(formulae, Arithmetic::plain, strictness, q).verdict;
}
// The formulae that are right for triangles without area too.
template <class Real>
Verdict right(const Query<Real>& q) {
  return by_reference(Formulae::published, q, Strictness::nonstrict);
}

// Where a query stands in its batch.
template <class Real>
struct Place {
  const QueryColumns<Real>& batch;
  std::size_t position;
  Query<Real> at(std::size_t i) const { return query_at(batch, i); }
};

// A kernel that answers one query after the other: Verdict answer(q, place).
template <class Answer>
Kernel kernel_of(std::string id, Answer answer) {
  Kernel kernel;
  kernel.id = std::move(id);
  kernel.summary = "made for the tests";
  kernel.predicate = &sphere_triangle_predicate();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  const auto made = [answer]<class Real>() {
    Implementation<Real> implementation;
    implementation.verdicts = [answer](const QueryColumns<Real>& batch, Verdict* out) {
      for (std::size_t i = 0; i < batch.size; ++i) out[i] = answer(query_at(batch, i), Place<Real>{batch, i});
    };
    return implementation;
  };
  kernel.binary32 = [made](std::string_view) { return made.template operator()<float>(); };
  kernel.binary64 = [made](std::string_view) { return made.template operator()<double>(); };
  return kernel;
}

template <class Real>
Vec3<Real> normal_of(const Query<Real>& q) {
  return cross(q.b - q.a, q.c - q.a);
}
template <class Real>
bool has_no_area(const Query<Real>& q) {
  const Vec3<Real> n = normal_of(q);
  return n.x == 0 && n.y == 0 && n.z == 0;
}
template <class Real>
Query<Real> with_less_radius(Query<Real> q) {
  q.r = step_radius(q.r, -1);
  return q;
}
inline Query<float> narrowed(const Query<double>& q) {
  std::array<float, coordinate_count> v;
  for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = static_cast<float>(coordinates(q)[k]);
  return from_coordinates(v);
}
inline const Query<float>& narrowed(const Query<float>& q) { return q; }

inline Kernel open_sphere() {
  return kernel_of("open-sphere", [](const auto& q, const auto&) { return right(with_less_radius(q)); });
}
// Closed on one side of the world, and open on the other.
inline Kernel half_open_sphere() {
  return kernel_of("half-open-sphere",
                   [](const auto& q, const auto&) { return right(q.p.x > 0 ? q : with_less_radius(q)); });
}
inline Kernel one_sided(bool is_front) {
  return kernel_of(is_front ? "front-only" : "back-only", [is_front](const auto& q, const auto&) {
    const auto offset = dot(q.p - q.a, normal_of(q));
    return (is_front ? offset < 0 : offset > 0) ? Verdict::separated : right(q);
  });
}
inline Kernel flat_triangles(std::string id, Verdict verdict) {
  return kernel_of(std::move(id),
                   [verdict](const auto& q, const auto&) { return has_no_area(q) ? verdict : right(q); });
}
inline Kernel flushing() {
  return kernel_of("flushing", [](const auto& q, const auto&) {
    const FloatingEnvironment flushed(Rounding::nearest, true);
    return by_reference(Formulae::published, q);
  });
}
inline Kernel float_inside() {
  return kernel_of("float-inside",
                   [](const auto& q, const auto&) { return by_reference(Formulae::published, narrowed(q)); });
}
// Points in floats, the radius and all operations in double.
inline Kernel float_points() {
  return kernel_of("float-points", [](const auto& q, const auto&) {
    Query<double> points = widened(narrowed(q));
    points.r = q.r;
    return by_reference(Formulae::published, points);
  });
}
inline Kernel double_inside() {
  return kernel_of("double-inside",
                   [](const auto& q, const auto&) { return by_reference(Formulae::published, widened(q)); });
}
inline Kernel contracted_kernel() {
  return kernel_of("contracted", [](const auto& q, const auto&) {
    return verdict_of(axes_of(bits_of(contracted_sides(q), Strictness::strict)));
  });
}
// Another answer every so many queries, wherever they stand.
inline Kernel changing(std::uint64_t every) {
  const auto asked = std::make_shared<std::atomic<std::uint64_t>>(0);
  return kernel_of("changing", [asked, every](const auto& q, const auto&) {
    const Verdict said = right(q);
    if (++*asked % every != 0) return said;
    return said == Verdict::contact ? Verdict::separated : Verdict::contact;
  });
}
// Every fourth lane takes a radius that is one ulp less.
inline Kernel lane_dependent() {
  return kernel_of("lane-dependent", [](const auto& q, const auto& place) {
    return right(place.position % 4 == 3 ? with_less_radius(q) : q);
  });
}
inline Kernel length_dependent() {
  return kernel_of("length-dependent", [](const auto& q, const auto& place) {
    return right(place.batch.size % 2 == 1 ? with_less_radius(q) : q);
  });
}
// The last queries of a batch, beyond a multiple of four, by other formulae.
inline Kernel other_tail() {
  return kernel_of("other-tail", [](const auto& q, const auto& place) {
    const bool is_tail = place.position >= place.batch.size / 4 * 4;
    return is_tail ? by_reference(Formulae::closest_point, q) : right(q);
  });
}
// A query after one in contact is in contact, however it lies.
inline Kernel carries_over() {
  return kernel_of("carries-over", [](const auto& q, const auto& place) {
    if (place.position > 0 && right(place.at(place.position - 1)) == Verdict::contact) return Verdict::contact;
    return right(q);
  });
}
// Separated where a number exceeds 2^10.
inline Kernel clipped() {
  return kernel_of("clipped", [](const auto& q, const auto&) {
    for (const auto x : coordinates(q)) {
      if (std::abs(x) > 1024) return Verdict::separated;
    }
    return right(q);
  });
}
inline Kernel constant(Verdict verdict) {
  return kernel_of(std::string("always-") + std::string(name(verdict)),
                   [verdict](const auto&, const auto&) { return verdict; });
}
// Contact or not as a coin falls, which is the query's own.
inline Kernel by_coin() {
  return kernel_of("by-coin", [](const auto& q, const auto&) {
    double sum = 0;
    for (const auto x : coordinates(q)) sum = sum * 1.7 + static_cast<double>(x) * 1e4;
    return std::fmod(std::abs(sum), 2) < 1 ? Verdict::contact : Verdict::separated;
  });
}

}  // namespace axiscert::made
