// The claims of the kernels, checked in exact arithmetic over small integer triangles.
#include "exact/sphere_triangle/asked_sphere_triangle.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "exact/sphere_triangle/oracles/geometric_oracle.h"

namespace axiscert {
namespace {

bool has_area(const Query<double>& q) {
  const auto normal = portable::cross(q.b - q.a, q.c - q.a);
  return portable::dot(normal, normal) != 0;
}
bool same_point(const Vec3<double>& u, const Vec3<double>& v) { return u.x == v.x && u.y == v.y && u.z == v.z; }

// The triangles on which a kernel's formulae must give the geometric verdict in exact arithmetic; null: none.
using Domain = bool (*)(const Query<double>&);
Domain domain_of(const Kernel& kernel) {
  switch (formulae_of(kernel)) {
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

// Wrong verdicts of one kernel on the lattice.
struct WrongCounts {
  std::uint64_t wrong_inside = 0, wrong_outside = 0;  // inside and outside its domain
};

using WrongCountsByKernel = std::vector<WrongCounts>;

// Judges one triangle with the centre at the origin, at these radii: the binary64 numbers next to the exact distance on
// both sides, and the distance itself where it is a binary64 number.
void judge_triangle(Query<double> q, WrongCountsByKernel& found) {
  found.resize(kernels().size());
  const Rational distance2 = squared_distance(q);
  const double near = nearest_sqrt<double>(distance2);
  const auto order_at = [&](double r) { return cmp(distance2, Rational(exact(r) * exact(r))); };
  for (const double r : {std::nextafter(near, 0), near, std::nextafter(near, INFINITY)}) {
    const int order = order_at(r);
    if (r != near && order == order_at(near)) continue;  // one radius on each side is enough
    q.r = r;
    const Verdict truth = order > 0 ? Verdict::separated : Verdict::contact;
    AskedSphereTriangle<double> asked(q, Opinion::first);
    for (std::size_t which = 0; which < kernels().size(); ++which) {
      const Kernel& kernel = kernels()[which];
      if (formulae_of(kernel) == Formulae::none) continue;
      // Throws if a rung's signs are not the published ones.
      const ExactSides* sides = asked.sides(kernel);
      const Verdict verdict = sides ? outcome_of(sides->holding(nonstrict_comparisons(kernel.strictness))).verdict
                                    : exact_verdict(formulae_of(kernel), q);
      if (verdict == truth) continue;
      const Domain domain = domain_of(kernel);
      ++(domain && domain(q) ? found[which].wrong_inside : found[which].wrong_outside);
    }
  }
}

// Judges all triangles with vertices in {-1, 0, 1}^3 whose first vertex satisfies `first`. Returns their number.
template <class First>
int judge_lattice(First&& first, WrongCountsByKernel& found) {
  int triangles = 0;
  const auto vertex = [](int i) { return Vec3<double>{double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 - 1)}; };
  for (int i = 0; i < 27; ++i) {
    if (!first(vertex(i))) continue;
    for (int j = 0; j < 27; ++j) {
      for (int k = 0; k < 27; ++k, ++triangles) {
        judge_triangle({vertex(i), vertex(j), vertex(k), {0, 0, 0}, 0}, found);
      }
    }
  }
  return triangles;
}

void expect_claims_hold(const WrongCountsByKernel& found) {
  for (std::size_t which = 0; which < kernels().size(); ++which) {
    const Kernel& kernel = kernels()[which];
    if (formulae_of(kernel) == Formulae::none) continue;
    EXPECT_EQ(found[which].wrong_inside, 0u) << kernel.id;
    const bool right_everywhere = formulae_of(kernel) == Formulae::minkowski || kernel.strictness != Strictness::strict;
    if (right_everywhere) {
      EXPECT_EQ(found[which].wrong_outside, 0u) << kernel.id;
    } else {
      EXPECT_GT(found[which].wrong_outside, 0u) << kernel.id << ": its claim could be wider";
    }
  }
}

// A symmetry of the cube maps each triangle of the lattice to one of these.
TEST(Claims, HoldOnTheLatticeUpToItsSymmetries) {
  WrongCountsByKernel found;
  EXPECT_EQ(judge_lattice([](const Vec3<double>& v) { return 0 <= v.x && v.x <= v.y && v.y <= v.z; }, found),
            4 * 27 * 27);
  expect_claims_hold(found);
}
TEST(ClaimsLong, HoldOnTheWholeLattice) {
  WrongCountsByKernel found;
  EXPECT_EQ(judge_lattice([](const Vec3<double>&) { return true; }, found), 19683);
  expect_claims_hold(found);
}

// The lattice has no query whose centre lies beyond the end of an edge: with coordinates in {-1, 0, 1}, A.B <= B.B.
TEST(Claims, HoldOnIntegerTrianglesInEveryRegion) {
  constexpr int seed = 81;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  std::mt19937_64 random(seed);
  WrongCountsByKernel found;
  for (int i = 0; i < 2000; ++i) {
    const auto integer = [&] { return static_cast<double>(random() % 9) - 4; };
    const auto vertex = [&] { return Vec3<double>{integer(), integer(), integer()}; };
    Query<double> q{vertex(), vertex(), vertex(), {0, 0, 0}, 0};
    if (i % 8 == 0) (i % 3 == 0 ? q.a : i % 3 == 1 ? q.b : q.c) = i % 3 == 0 ? q.b : q.a;
    if (i % 8 == 1) q.c = q.a + (q.b - q.a) * integer();
    judge_triangle(q, found);
  }
  expect_claims_hold(found);
}

}  // namespace
}  // namespace axiscert
