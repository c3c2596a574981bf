// What the kernel tests share: a query in every vertex order, and a kernel's answer to one query.
#pragma once

#include <gtest/gtest.h>

#include <string_view>

#include "kernel/evaluate.h"
#include "kernel/kernel.h"

namespace axiscert::testing_support {

// Calls body(query, order), order "abc", "acb", ...: the same sphere and the same triangle, its vertices renamed.
template <class Real, class Body>
void for_each_vertex_order(const Query<Real>& q, Body&& body) {
  const Vec3<Real> vertices[] = {q.a, q.b, q.c};
  constexpr std::string_view orders[] = {"abc", "acb", "bac", "bca", "cab", "cba"};
  for (const std::string_view order : orders) {
    const auto vertex = [&](std::size_t i) { return vertices[order[i] - 'a']; };
    body(Query<Real>{vertex(0), vertex(1), vertex(2), q.p, q.r}, order);
  }
}

// A kernel's verdict and, where it exposes them, its comparison bits, which have to make that verdict.
template <class Real>
Outcome answer(const Kernel& kernel, const Query<Real>& q, std::string_view target = scalar_target) {
  const Implementation<Real> implementation = kernel.on<Real>(target);
  QueryBatch<Real> one(1);
  one.push_back(q);
  Outcome found{Verdict::invalid, std::nullopt};
  implementation.verdicts(one.columns(), &found.verdict);
  if (implementation.explain) {
    Answers<Real> answers;
    answers.resize(1);
    implementation.explain(one.columns(), answers);
    found.bits = answers.bits[0];
    EXPECT_EQ(verdict_of(axes_of(*found.bits)), found.verdict) << kernel.id << " on " << target;
  }
  return found;
}

// The computed sides of one query.
template <class Real>
Sides<Real> sides_in(const Kernel& kernel, const Query<Real>& q, std::string_view target = scalar_target) {
  QueryBatch<Real> one(1);
  one.push_back(q);
  Answers<Real> answers;
  answers.resize(1);
  kernel.on<Real>(target).explain(one.columns(), answers);
  Sides<Real> sides;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    sides.lhs[k] = answers.lhs[k][0];
    sides.rhs[k] = answers.rhs[k][0];
  }
  return sides;
}

}  // namespace axiscert::testing_support
