// Verdicts of motions against CGAL's quadratic program for the distance of two convex hulls, here of the centre and of
// the prism's six corners: it knows nothing of triangles, axes or times.
#include <CGAL/Gmpq.h>
#include <CGAL/QP_functions.h>
#include <CGAL/QP_models.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <array>

#include "exact/judge/oracles.h"
#include "exact/moving_sphere/motion_distance.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert {
namespace {

using Gmpq = CGAL::Gmpq;
using Cartesian = CGAL::Simple_cartesian<Gmpq>;

Cartesian::Point_3 exact_point(const portable::Vec3<double>& v) { return {Gmpq(v.x), Gmpq(v.y), Gmpq(v.z)}; }
Cartesian::Vector_3 exact_displacement(const moving_sphere::GivenMotion& q) {
  const auto d = q.displacement<Gmpq>([](double x) { return Gmpq(x); });
  return {d.x, d.y, d.z};
}

// The sign of the squared distance of the centre from the prism, less r^2. Exact: the least of |sum of w_i (v_i -
// centre)|^2 over weights that are not negative and add up to 1. By Bland's rule, which cannot cycle:
// Polytope_distance_d prices by another, and does not return on query 1383 of `point` in binary64.
CGAL::Comparison_result polytope_order(const moving_sphere::GivenMotion& q) {
  const Cartesian::Point_3 centre = exact_point(q.p);
  const Cartesian::Vector_3 d = exact_displacement(q);
  std::array<Cartesian::Vector_3, 6> prism;
  int corner = 0;
  for (const auto& vertex : {q.a, q.b, q.c}) {
    prism[corner++] = exact_point(vertex) - centre;
    prism[corner++] = exact_point(vertex) - d - centre;
  }
  CGAL::Quadratic_program<Gmpq> program(CGAL::EQUAL, true, Gmpq(0), false);
  for (int i = 0; i < corner; ++i) {
    for (int j = 0; j <= i; ++j) program.set_d(i, j, 2 * (prism[i] * prism[j]));
    program.set_a(i, 0, Gmpq(1));
  }
  program.set_b(0, Gmpq(1));
  CGAL::Quadratic_program_options options;
  options.set_pricing_strategy(CGAL::QP_BLAND);
  const auto solution = CGAL::solve_quadratic_program(program, Gmpq(), options);
  EXPECT_TRUE(solution.is_optimal());
  return CGAL::compare(solution.objective_value_numerator() / solution.objective_value_denominator(),
                       Gmpq(q.r) * Gmpq(q.r));
}

// The centre passes from one side of the face to the other, strictly inside its edges. Exact.
bool crosses_the_face(const moving_sphere::GivenMotion& q) {
  const Cartesian::Point_3 a = exact_point(q.a), b = exact_point(q.b), c = exact_point(q.c), p = exact_point(q.p),
                           end = p + exact_displacement(q);
  const CGAL::Orientation before = CGAL::orientation(a, b, c, p), turn = CGAL::orientation(p, end, a, b);
  return before != CGAL::COPLANAR && CGAL::orientation(a, b, c, end) == -before && turn != CGAL::COPLANAR &&
         CGAL::orientation(p, end, b, c) == turn && CGAL::orientation(p, end, c, a) == turn;
}

// Touching as the predicate's description has it: at the radius exactly, unless a point crosses the inside of the face.
bool is_touching(const moving_sphere::GivenMotion& q, CGAL::Comparison_result order) {
  return order == CGAL::EQUAL && !(q.r == 0 && crosses_the_face(q));
}

TEST(PolytopeDistance, IsAsComputedByHand) {
  MovingQuery<double> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 1}, {-1, -1, 0}, 1};
  EXPECT_EQ(polytope_order(q), CGAL::LARGER) << "the line x + y = 4 is sqrt(3) away at the end";
  q.r = 2;
  EXPECT_EQ(polytope_order(q), CGAL::SMALLER);
  q.p = {1, 1, 5}, q.d = {0, 0, -3};
  EXPECT_EQ(polytope_order(q), CGAL::EQUAL) << "2 above the face at the end";
  EXPECT_TRUE(is_touching(q, CGAL::EQUAL));
  q.r = 0, q.d = {0, 0, -5};
  EXPECT_EQ(polytope_order(q), CGAL::EQUAL) << "a point that ends on the face";
  EXPECT_TRUE(is_touching(q, CGAL::EQUAL));
  q.d = {0, 0, -6};
  EXPECT_FALSE(is_touching(q, polytope_order(q))) << "a point that crosses the face";
  q.p = {2, 2, 5};
  EXPECT_TRUE(is_touching(q, polytope_order(q))) << "a point that crosses the edge";
}

template <class Real>
class PolytopeDistanceLong : public testing::Test {};
using PolytopeReals = testing::Types<float, double>;
TYPED_TEST_SUITE(PolytopeDistanceLong, PolytopeReals);

TYPED_TEST(PolytopeDistanceLong, IsTheOraclesOnTenThousandQueriesOfEachFamily) {
  for (const Family* family : families_of(moving_sphere_predicate())) {
    const Oracles& oracles = oracles_of(moving_sphere_predicate(), family->entry);
    const ImageGroup* group = image_group(family->name);
    const std::uint64_t stride = group ? group->size + 1 : 1;  // an image of each base, and another one of the next
    for (std::uint64_t i = 0; i < 10000 / TRIAL_DIVISOR; ++i) {
      const Numbers<TypeParam> numbers = family->make<TypeParam>(1, i * stride);
      const Truth truth = oracles.truth(numbers);
      const auto load = [&](std::size_t k) { return static_cast<double>(numbers[k]); };
      const moving_sphere::GivenMotion motion = family->entry == MovingSphere::entry
                                                    ? moving_sphere::GivenMotion(MovingSphere::problem<double>(load))
                                                    : moving_sphere::GivenMotion(MovingEnds::problem<double>(load));
      const CGAL::Comparison_result order = polytope_order(motion);
      ASSERT_EQ(truth.verdict == Verdict::contact, order != CGAL::LARGER)
          << family->name << ", seed 1, query " << i * stride;
      ASSERT_EQ(truth.touching, is_touching(motion, order)) << family->name << ", seed 1, query " << i * stride;
    }
  }
}

}  // namespace
}  // namespace axiscert
