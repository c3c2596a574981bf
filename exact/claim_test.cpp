// What the kernels claim, in exact arithmetic, over the lattice.
#include "exact/claim.h"

#include <gtest/gtest.h>

#include <cmath>

#include "exact/geometric_oracle.h"

namespace axiscert {
namespace {

bool has_area(const Query<double>& q) {
  const auto normal = portable::cross(q.b - q.a, q.c - q.a);
  return portable::dot(normal, normal) != 0;
}
bool same_point(const Vec3<double>& u, const Vec3<double>& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }

// On which triangles a kernel's formulae must give the geometric verdict in exact arithmetic; empty: they do not.
using Domain = bool (*)(const Query<double>&);
Domain domain_of(const Kernel& kernel) {
  switch (kernel.formulae) {
    case Formulae::minkowski:
      return [](const Query<double>&) { return true; };
    case Formulae::closest_point:
      return [](const Query<double>& q) { return !same_point(q.a, q.b); };
    case Formulae::first_publication:
    case Formulae::vertex_typo:
      return nullptr;
    default:
      if (kernel.strictness == Strictness::strict) return has_area;
      return [](const Query<double>&) { return true; };
  }
}

// What the lattice found for one kernel.
struct Found {
  std::uint64_t wrong_inside = 0, wrong_outside = 0;  // of its domain
};

// All triangles with vertices in {-n..n}^3, the first in {first..n}^3 with x <= y <= z; centre at the origin. Radii:
// the binary64 numbers next to the exact distance on both sides, and the distance where it is one.
std::vector<Found> judge_lattice(int n, int first, std::uint64_t& triangles) {
  std::vector<Found> found(kernels().size());
  const int side = 2 * n + 1, points = side * side * side;
  const auto vertex = [&](int i) {
    return Vec3<double>{double(i % side - n), double(i / side % side - n), double(i / side / side - n)};
  };
  const auto is_first = [&](const Vec3<double>& v) {
    return first == -n || (v.x >= first && v.x <= v.y && v.y <= v.z);
  };
  for (int i = 0; i < points; ++i) {
    if (!is_first(vertex(i))) continue;
    for (int j = 0; j < points; ++j)
      for (int k = 0; k < points; ++k) {
        ++triangles;
        Query<double> q{vertex(i), vertex(j), vertex(k), {0, 0, 0}, 0};
        const Rational distance2 = squared_distance(q);
        const double near = nearest_sqrt<double>(distance2);
        for (const double r : {std::nextafter(near, 0), near, std::nextafter(near, INFINITY)}) {
          const int order = cmp(distance2, Rational(exact(r) * exact(r)));
          // Of the two that are not the distance, one on each side is enough.
          if (r != near && cmp(exact(near) * exact(near), distance2) != 0 &&
              (order > 0) == (cmp(distance2, exact(near) * exact(near)) > 0))
            continue;
          q.r = r;
          const Verdict truth = order > 0 ? Verdict::separated : Verdict::contact;
          const FormulaTruth published = formula_truth(q);
          Claims<double> claims(q, published);
          for (std::size_t which = 0; which < kernels().size(); ++which) {
            const Kernel& kernel = kernels()[which];
            const FormulaTruth* sides = claims.sides(kernel.formulae);  // throws where a rung's signs are not published
            const Verdict verdict =
                sides ? outcome_of(sides->bits(kernel.strictness)).verdict : exact_verdict(kernel.formulae, q);
            if (verdict == truth) continue;
            const Domain domain = domain_of(kernel);
            ++(domain && domain(q) ? found[which].wrong_inside : found[which].wrong_outside);
          }
        }
      }
  }
  return found;
}

void expect_claims_hold(const std::vector<Found>& found) {
  for (std::size_t which = 0; which < kernels().size(); ++which) {
    const Kernel& kernel = kernels()[which];
    EXPECT_EQ(found[which].wrong_inside, 0u) << kernel.id;
    const bool right_everywhere = kernel.formulae == Formulae::minkowski || kernel.strictness != Strictness::strict;
    if (right_everywhere) EXPECT_EQ(found[which].wrong_outside, 0u) << kernel.id;
    else EXPECT_GT(found[which].wrong_outside, 0u) << kernel.id << ": its claim could be wider";
  }
}

// Each triangle of {-1, 0, 1}^3 is one of these, turned or mirrored by a symmetry of the cube.
TEST(Claims, HoldOnTheLatticeUpToItsSymmetries) {
  std::uint64_t triangles = 0;
  expect_claims_hold(judge_lattice(1, 0, triangles));
  EXPECT_EQ(triangles, 4u * 27 * 27);
}
TEST(ClaimsLong, HoldOnTheWholeLattice) {
  std::uint64_t triangles = 0;
  expect_claims_hold(judge_lattice(1, -1, triangles));
  EXPECT_EQ(triangles, 19683u);
}

}  // namespace
}  // namespace axiscert
