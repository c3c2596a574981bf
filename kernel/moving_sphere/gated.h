// The verdict by the twenty axes, and the time by roots in which nothing cancels: the better form of `rounded`.
#pragma once

#include <algorithm>
#include <array>

#include "kernel/moving_sphere/timed.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert::moving_sphere {

// Where the twenty axes with `>=` find no separation there is a contact. It is at 0 where the static ones among them
// find none before the motion; else at the least root of the pieces, in their form `products`; else, where rounding has
// lost that root, as that of a graze may be, at the time of least distance among those at which it can be least, and
// neither feature nor point is given.
// Over the reals the verdict is right for every query, degree 6, and so is the time, a root of degrees up to 8.
struct GatedTwenty {
  template <class Real>
  static std::optional<ContactFound<Real>> first_contact(const MovingQuery<Real>& query) {
    const ComparisonBits holds = bits_of<TwentyNonstrict, Real>(query, [](std::size_t, Real, Real) {});
    if (separates(holds)) return std::nullopt;
    const auto q = portable::start_of<Real>(query);
    auto hit = portable::RoundedPieces<portable::RootForm::products>::first(q, portable::face_plane(q));
    if (!separates(start_alone(holds))) hit = {true, 0, -1};
    else if (!hit.contact) return ContactFound<Real>{.time = least_time(q)};
    return contact_of(q, hit);
  }
  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& query) {
    const auto contact = first_contact(query);
    return contact ? std::optional(contact->time) : std::nullopt;
  }

 private:
  static bool separates(ComparisonBits holds) {
    return std::any_of(clause_bits.begin(), clause_bits.end(),
                       [&](ComparisonBits clause) { return (holds & clause) == clause; });
  }
  // The comparisons of the static axes at the start, with the headings taken as holding and all other axes as not.
  static ComparisonBits start_alone(ComparisonBits holds) {
    constexpr ComparisonBits start = one_bit<ComparisonBits>(end_axes) - 1;
    return (holds & start) | (heading_bits & start);
  }

  template <class Real>
  static Real least_time(const portable::Start<Real>& q) {
    const auto squared_distance = [&](Real t) {
      const Vec3<Real> moved = q.d * t;
      const Vec3<Real> nearest = methods::ClosestPoint::closest(
          portable::CentredProblem<Real>{q.a - moved, q.b - moved, q.c - moved, q.rr}, Real(0));
      return dot(nearest, nearest);
    };
    Real best = 1, least = squared_distance(best);
    const auto look = [&](Real b, Real a) {
      const Real t = std::clamp(b / a, Real(0), Real(1));
      const Real squared = squared_distance(t);
      if (squared < least) {
        best = t;
        least = squared;
      }
    };
    for (const auto& [from, to] : {std::pair{q.a, q.b}, std::pair{q.b, q.c}, std::pair{q.c, q.a}}) {
      const Vec3<Real> along = to - from, m = cross(q.d, along);
      look(dot(from, q.d), dot(q.d, q.d));
      look(dot(cross(from, along), m), dot(m, m));
    }
    return best;
  }
};

}  // namespace axiscert::moving_sphere
