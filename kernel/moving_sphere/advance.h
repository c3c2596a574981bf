// Conservative advancement: the sphere is moved on by what the distance allows, until it touches.
#pragma once

#include <cmath>
#include <optional>

#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/forms/methods.h"

namespace axiscert::moving_sphere {

// Each step goes for (distance - r) / closing speed. By the speed along the nearest direction it is Newton's method for
// a convex function of time, which comes to the first contact from before, fast; by |D| it never passes it either and
// takes as many steps as the path is long. It has arrived where a step changes nothing. After most_steps without
// arriving it answers "separated", as libraries do: a contact that it did not reach in time is missed.
// Source: the method of B. Mirtich, Impulse-based Dynamic Simulation of Rigid Body Systems (1996).
template <bool along_nearest>
struct Advance {
  static constexpr int most_steps = 32;

  template <class Real>
  static std::optional<Real> first_time(const MovingQuery<Real>& q) {
    using portable::dot;
    const portable::Vec3<Real> a = q.a - q.p, b = q.b - q.p, c = q.c - q.p;
    Real t = 0;
    for (int step = 0; step < most_steps; ++step) {
      const portable::Vec3<Real> moved = q.d * t;
      const portable::Vec3<Real> nearest = methods::ClosestPoint::closest(
          portable::CentredProblem<Real>{a - moved, b - moved, c - moved, Real(0)}, Real(0));
      const Real distance = std::sqrt(dot(nearest, nearest));
      if (distance <= q.r) return t;
      const Real closing = along_nearest ? dot(nearest, q.d) / distance : std::sqrt(dot(q.d, q.d));
      const Real next = t + (distance - q.r) / closing;
      if (!(closing > 0) || next > 1) return std::nullopt;
      if (next == t) return t;
      t = next;
    }
    return std::nullopt;
  }
};

}  // namespace axiscert::moving_sphere
