// Kernels with a slack that is known, since it is planted: right methods, but for one number.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>

#include "kernel/ask.h"
#include "kernel/boxes/boxes.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::planted {

template <class Real>
using Point = portable::Vec3<Real>;

// A kernel that answers query by query: Verdict answer(const Numbers<Real>&).
template <class Answer>
Kernel kernel_of(std::string id, const Predicate& predicate, Answer answer, std::size_t entry = 0) {
  Kernel kernel;
  kernel.id = std::move(id);
  kernel.summary = "made for the tests";
  kernel.predicate = &predicate;
  kernel.entry = entry;
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  const auto made = [answer]<class Real>() {
    Implementation<Real> implementation;
    implementation.verdicts = [answer](const QueryColumns<Real>& batch, Verdict* out) {
      Numbers<Real> query(batch.count);
      for (std::size_t i = 0; i < batch.size; ++i) {
        for (std::size_t k = 0; k < batch.count; ++k) query[k] = batch.column[k][i];
        out[i] = answer(query);
      }
    };
    return implementation;
  };
  kernel.binary32 = [made](std::string_view) { return made.template operator()<float>(); };
  kernel.binary64 = [made](std::string_view) { return made.template operator()<double>(); };
  return kernel;
}
// One that asks another about the query changed.
template <class Change>
Kernel changed(std::string id, const Kernel& right, Change change) {
  return kernel_of(
      std::move(id), *right.predicate,
      [&right, change]<class Real>(Numbers<Real> query) {
        change(query);
        static const Implementation<Real> asked = right.on<Real>(scalar_target);
        return ask(asked, query).verdicts[0];
      },
      right.entry);
}

template <class Real>
Point<Real> point_at(const Numbers<Real>& q, std::size_t k) {
  return {q[k], q[k + 1], q[k + 2]};
}

// The distance to the triangle, by its face and its three sides.
struct SphereSlack {
  double skin = 0, skin_of_face = 0, margin = 0, barycentric = 0, edge = 0;
  bool has_vertices = true;  // without: no contact where a vertex is nearest
};
inline Kernel sphere(std::string id, const SphereSlack& slack) {
  return kernel_of(std::move(id), sphere_triangle_predicate(), [slack]<class Real>(const Numbers<Real>& q) {
    const Point<Real> v[] = {point_at(q, 0), point_at(q, 3), point_at(q, 6)}, p = point_at(q, 9);
    const Point<Real> n = cross(v[1] - v[0], v[2] - v[0]);
    const Real r = q[12], square = dot(n, n);
    bool is_over = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real weight = dot(cross(v[(k + 1) % 3] - v[k], p - v[k]), n) / square;
      is_over = is_over && weight >= Real(-slack.barycentric);
    }
    const Real reach = r + r * Real(slack.skin) + Real(slack.margin);
    if (is_over && std::abs(dot(p - v[0], n)) <= (reach + r * Real(slack.skin_of_face)) * std::sqrt(square))
      return Verdict::contact;
    for (std::size_t k = 0; k < 3; ++k) {
      const Point<Real> along = v[(k + 1) % 3] - v[k];
      const Real t = std::clamp(dot(p - v[k], along) / dot(along, along), Real(0), Real(1 + slack.edge));
      if (!slack.has_vertices && (t == 0 || t == 1)) continue;
      const Point<Real> apart = p - v[k] - along * t;
      if (dot(apart, apart) <= reach * reach) return Verdict::contact;
    }
    return Verdict::separated;
  });
}

// Two boxes by fifteen axes in A's frame, as books have them.
struct BoxSlack {
  double edges = 0, all = 0, margin = 0, inflated = 0, least_half = 0, relative = 0;
};
inline Kernel boxes_by_book(std::string id, const BoxSlack& slack) {
  return kernel_of(std::move(id), box_box_predicate(), [slack]<class Real>(const Numbers<Real>& q) {
    const boxes::BoxPair<Real> pair = boxes::MatrixBoxes::problem<Real>([&](std::size_t k) { return q[k]; });
    std::array<Real, 3> a = pair.a.half, b = pair.b.half, t{};
    for (std::size_t k = 0; k < 3; ++k) {
      for (Real* half : {&a[k], &b[k]}) *half = std::max(*half * Real(1 + slack.inflated), Real(slack.least_half));
      t[k] = dot(pair.b.centre - pair.a.centre, pair.a.axis[k]);
    }
    Real r[3][3], s[3][3];
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = 0; j < 3; ++j) {
        r[i][j] = dot(pair.a.axis[i], pair.b.axis[j]);
        s[i][j] = std::abs(r[i][j]) + Real(slack.all);
      }
    }
    const Real margin = Real(slack.margin) + Real(slack.relative) * (a[0] + a[1] + a[2] + b[0] + b[1] + b[2]) / 2;
    for (std::size_t i = 0; i < 3; ++i) {
      if (std::abs(t[i]) > a[i] + b[0] * s[i][0] + b[1] * s[i][1] + b[2] * s[i][2] + margin) return Verdict::separated;
      const Real along = t[0] * r[0][i] + t[1] * r[1][i] + t[2] * r[2][i];
      if (std::abs(along) > b[i] + a[0] * s[0][i] + a[1] * s[1][i] + a[2] * s[2][i] + margin) return Verdict::separated;
    }
    const Real eps = Real(slack.edges);
    for (std::size_t i = 0; i < 3; ++i) {
      const std::size_t i1 = (i + 1) % 3, i2 = (i + 2) % 3;
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t j1 = (j + 1) % 3, j2 = (j + 2) % 3;
        const Real of_a = a[i1] * (s[i2][j] + eps) + a[i2] * (s[i1][j] + eps);
        const Real of_b = b[j1] * (s[i][j2] + eps) + b[j2] * (s[i][j1] + eps);
        if (std::abs(t[i2] * r[i1][j] - t[i1] * r[i2][j]) > of_a + of_b + margin) return Verdict::separated;
      }
    }
    return Verdict::contact;
  });
}

}  // namespace axiscert::planted
