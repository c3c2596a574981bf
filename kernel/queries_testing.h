// Shared parts of tests: a query in every vertex order, a kernel's answer to one query, and whether two queries are the
// same bits.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string_view>

#include "kernel/ask.h"
#include "kernel/sphere_triangle/forms/scalar.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::testing_support {

// Calls body(query, order) for each order "abc", "acb", ...: the same sphere and triangle with the vertices renamed.
template <class Real, class Body>
void for_each_vertex_order(const Query<Real>& q, Body&& body) {
  const Vec3<Real> vertices[] = {q.a, q.b, q.c};
  constexpr std::string_view orders[] = {"abc", "acb", "bac", "bca", "cab", "cba"};
  for (const std::string_view order : orders) {
    const auto vertex = [&](std::size_t i) { return vertices[order[i] - 'a']; };
    body(Query<Real>{vertex(0), vertex(1), vertex(2), q.p, q.r}, order);
  }
}

// A kernel's verdict and, if it exposes them, its comparison bits; checks that the bits make that verdict.
template <class Real>
Outcome answer(const Kernel& kernel, const Query<Real>& q, std::string_view target = scalar_target) {
  const Outcome found = ask(kernel.on<Real>(target), q).outcome(0);
  if (found.bits) {
    EXPECT_EQ(verdict_of(axes_of(*found.bits)), found.verdict) << kernel.id << " on " << target;
  }
  return found;
}

// The computed sides of one query.
template <class Real>
Sides<Real> sides_in(const Kernel& kernel, const Query<Real>& q, std::string_view target = scalar_target) {
  return sides_at(ask(kernel.on<Real>(target), q).answers, 0);
}

}  // namespace axiscert::testing_support

namespace axiscert {

// Expects the same thirteen numbers, with signed zeros distinguished; a NaN equals a NaN.
template <class Real>
void expect_same_bits(const Query<Real>& x, const Query<Real>& y) {
  const auto u = coordinates(x), v = coordinates(y);
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    if (std::isnan(u[k])) {
      EXPECT_TRUE(std::isnan(v[k]));
    } else {
      EXPECT_TRUE(u[k] == v[k] && std::signbit(u[k]) == std::signbit(v[k])) << coordinate_names[k] << " " << u[k];
    }
  }
}

}  // namespace axiscert
