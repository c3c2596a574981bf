// Code shared by the tests of the families: queries in order, with the first failing one described by its numbers.
#pragma once

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "fuzz/queries/family.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

using Reals = testing::Types<float, double>;

// The judgement of the published kernel as the scalar reference computes it.
template <class Real>
Judgement judge_published(const Query<Real>& q) {
  AskedSphereTriangle asked(q, Opinion::first);
  const Truth truth = asked.truth();
  const Reference chain = *asked.chain(find_kernel("published"));
  return judge(sphere_triangle_predicate(), truth, chain, chain.rounded->reference);
}

// How often the running test has failed.
inline int failure_count() {
  return testing::UnitTest::GetInstance()->current_test_info()->result()->total_part_count();
}

// Calls check(query, position) for the first `count` positions at seed 1, and stops at the first failure.
template <class Real, class Check>
void for_each_query(std::string_view family_name, std::uint64_t count, Check&& check) {
  const Family& family = find_family(family_name);
  for (std::uint64_t position = 0; position < count; ++position) {
    const Query<Real> q = family.make<Real>(1, position);
    const int failures = failure_count();
    check(q, position);
    if (failure_count() != failures) {
      std::string numbers;
      for (const Real x : coordinates(q)) numbers += fmt::format(" {:a}", x);
      FAIL() << fmt::format("{} {}, seed 1, position {}:{}", family_name, name(precision_of<Real>), position, numbers);
    }
  }
}

}  // namespace axiscert
