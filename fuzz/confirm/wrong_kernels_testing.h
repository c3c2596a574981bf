// Kernels that show a verdict alone, each wrong by one slip of those that people make.
#pragma once

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>

#include "kernel/ask.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/thirteen.h"
#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::causes {

// A kernel that answers one query after the other: Verdict answer(numbers).
template <class Answer>
Kernel wrong_kernel(const Predicate& predicate, std::size_t entry, std::string id, Answer answer) {
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
      for (std::size_t i = 0; i < batch.size; ++i) {
        Numbers<Real> query(batch.count);
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

enum class Slip : std::uint8_t { none, no_vertex_a, no_edge_bc, first_edge, barycentric, one_sided, line_ca };

// The nearest point of the triangle, region by region, as in C. Ericson's book, in double.
inline Verdict by_regions(const Query<double>& q, Slip slip) {
  const auto within = [&](const Vec3<double>& nearest) {
    const Vec3<double> v = q.p - nearest;
    return dot(v, v) <= q.r * q.r ? Verdict::contact : Verdict::separated;
  };
  const Vec3<double> ab = q.b - q.a, ac = q.c - q.a, ap = q.p - q.a, bp = q.p - q.b, cp = q.p - q.c;
  const double d1 = dot(ab, ap), d2 = dot(ac, ap), d3 = dot(ab, bp), d4 = dot(ac, bp), d5 = dot(ab, cp),
               d6 = dot(ac, cp);
  const double va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2, sum = va + vb + vc;
  if (slip == Slip::one_sided && dot(cross(ab, ac), ap) < 0) return Verdict::separated;
  if (slip == Slip::barycentric && va > -1e-3 * sum && vb > -1e-3 * sum && vc > -1e-3 * sum && sum > 0)
    return within(q.a + ab * (vb / sum) + ac * (vc / sum));
  // The side of edge ca is not asked: all that is beyond its line is separated.
  if (slip == Slip::line_ca) {
    const Vec3<double> normal = cross(ap, ac);
    if (dot(normal, normal) > q.r * q.r * dot(ac, ac)) return Verdict::separated;
  }
  // The edge of which it is outside first, though another may be nearer: right of triangles without an obtuse corner.
  if (slip == Slip::first_edge) {
    const auto on = [&](const Vec3<double>& from, const Vec3<double>& edge) {
      const double t = dot(q.p - from, edge) / dot(edge, edge);
      return within(from + edge * (t < 0 ? 0 : t > 1 ? 1 : t));
    };
    if (vc < 0) return on(q.a, ab);
    if (va < 0) return on(q.b, q.c - q.b);
    if (vb < 0) return on(q.a, ac);
    return within(q.a + ab * (vb / sum) + ac * (vc / sum));
  }
  if (slip != Slip::no_vertex_a && d1 <= 0 && d2 <= 0) return within(q.a);
  if (d3 >= 0 && d4 <= d3) return within(q.b);
  if (vc <= 0 && d1 >= 0 && d3 <= 0) return within(q.a + ab * (d1 / (d1 - d3)));
  if (d6 >= 0 && d5 <= d6) return within(q.c);
  if (vb <= 0 && d2 >= 0 && d6 <= 0) return within(q.a + ac * (d2 / (d2 - d6)));
  if (slip != Slip::no_edge_bc && va <= 0 && d4 >= d3 && d5 >= d6)
    return within(q.b + (q.c - q.b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6))));
  return within(q.a + ab * (vb / sum) + ac * (vc / sum));
}

inline Kernel sphere_kernel(std::string id, Slip slip) {
  return wrong_kernel(sphere_triangle_predicate(), 0, std::move(id), [slip]<class Real>(const Numbers<Real>& numbers) {
    return by_regions(widened(query_from(numbers)), slip);
  });
}

// The axes of a form, but for those on which leaves_out(problem, axis) holds.
template <class Entry, class Form, class LeavesOut>
Kernel axes_kernel(std::string id, LeavesOut leaves_out) {
  return wrong_kernel(
      Entry::description(), Entry::entry, std::move(id), [leaves_out]<class Real>(const Numbers<Real>& numbers) {
        const auto problem =
            Entry::template problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); });
        bool is_apart = false;
        const auto see = [&](std::size_t i, double lhs, double rhs) {
          is_apart |= lhs > rhs && !leaves_out(problem, i);
        };
        Form::template comparisons<double>(problem, see);
        return is_apart ? Verdict::separated : Verdict::contact;
      });
}
inline Kernel box_kernel(std::string id, std::size_t left_out) {
  return axes_kernel<boxes::MatrixBoxes, boxes::ProjectedFifteen>(
      std::move(id), [left_out](const auto&, std::size_t i) { return i == left_out; });
}
// Products of edges are left out where the edges are nearly parallel: the square of the sine is below 0.01.
inline Kernel skipping_box_kernel() {
  return axes_kernel<boxes::MatrixBoxes, boxes::ProjectedFifteen>("skips-parallel", [](const auto& q, std::size_t i) {
    const auto along = boxes::direction(q, i);
    return i >= 6 && dot(along, along) < 1e-2;
  });
}
inline Kernel box_triangle_kernel(std::string id, std::size_t left_out) {
  return axes_kernel<boxes::CentreEntry, boxes::Thirteen>(
      std::move(id), [left_out](const auto&, std::size_t i) { return i == left_out; });
}

// Another kernel, asked about the query changed; where `changed` gives none, the answer is separated.
template <class Changed>
Kernel changed_kernel(std::string id, const Kernel& right, Changed changed) {
  return wrong_kernel(*right.predicate, right.entry, std::move(id),
                      [&right, changed]<class Real>(const Numbers<Real>& given) {
                        static const Implementation<double> asked = right.on<double>(scalar_target);
                        Numbers<double> numbers(given.size());
                        std::copy(given.begin(), given.end(), numbers.begin());
                        return changed(numbers) ? ask(asked, numbers).verdicts[0] : Verdict::separated;
                      });
}
// The box's facet at low z is not asked.
inline Kernel open_box_kernel() {
  return changed_kernel("open-box", find_kernel("box-triangle/thirteen"), [](Numbers<double>& q) {
    q[2] -= 1e6;
    q[5] += 1e6;
    return true;
  });
}
// Triangles are hit from the front alone.
inline Kernel one_sided_box_kernel() {
  return changed_kernel("one-sided-box", find_kernel("box-triangle/thirteen"), [](Numbers<double>& q) {
    const auto point = [&](std::size_t k) { return Vec3<double>{q[k], q[k + 1], q[k + 2]}; };
    return dot(cross(point(9) - point(6), point(12) - point(6)), point(0) - point(6)) >= 0;
  });
}
// A quaternion whose vector part is below a thousandth of w is taken for one that does not turn.
inline Kernel still_box_kernel() {
  return changed_kernel("still-box", find_kernel("box-box/homogeneous"), [](Numbers<double>& q) {
    for (const std::size_t k : {6, 16}) {
      const double vector = q[k + 1] * q[k + 1] + q[k + 2] * q[k + 2] + q[k + 3] * q[k + 3];
      if (vector < 1e-6 * q[k] * q[k]) q[k + 1] = q[k + 2] = q[k + 3] = 0;
    }
    return true;
  });
}

// A right kernel of motions, of which `changed` alters the query; where it gives none, the answer is separated.
template <class Changed>
Kernel motion_kernel(std::string id, Changed changed) {
  return wrong_kernel(
      moving_sphere_predicate(), MovingSphere::entry, std::move(id),
      [changed]<class Real>(const Numbers<Real>& numbers) {
        static const Implementation<double> right =
            find_kernel("moving-sphere/twenty-nonstrict").on<double>(scalar_target);
        const auto q = MovingSphere::problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); });
        const std::optional<MovingQuery<double>> asked = changed(q);
        return asked ? ask(right, Numbers<double>(*asked)).verdicts[0] : Verdict::separated;
      });
}
// The last twentieth of the way is not looked at.
inline Kernel stopping_kernel() {
  return motion_kernel("stopping", [](MovingQuery<double> q) {
    q.d = q.d * 0.95;
    return std::optional(q);
  });
}
inline Kernel one_way_kernel() {
  return motion_kernel("one-way", [](const MovingQuery<double>& q) {
    const bool is_back = dot(q.d, cross(q.b - q.a, q.c - q.a)) > 0;
    return is_back ? std::nullopt : std::optional(q);
  });
}
inline Kernel parallel_kernel() {
  return motion_kernel("parallel", [](const MovingQuery<double>& q) {
    const portable::Vec3<double> n = cross(q.b - q.a, q.c - q.a);
    const double along = dot(q.d, n);
    return along * along < 1e-6 * dot(q.d, q.d) * dot(n, n) ? std::nullopt : std::optional(q);
  });
}

}  // namespace axiscert::causes
