// Verdicts of motions against CGAL's quadratic program for the distance of two convex hulls, here of the centre and of
// the prism's six corners: it knows nothing of triangles, axes or times.
#include <CGAL/Gmpq.h>
#include <CGAL/Polytope_distance_d.h>
#include <CGAL/Polytope_distance_d_traits_3.h>
#include <CGAL/Simple_cartesian.h>
#include <gtest/gtest.h>

#include <array>

#include "exact/moving_sphere/given_motion.h"
#include "exact/trait/oracles.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert {
namespace {

using Gmpq = CGAL::Gmpq;
using Cartesian = CGAL::Simple_cartesian<Gmpq>;
using PolytopeDistance = CGAL::Polytope_distance_d<CGAL::Polytope_distance_d_traits_3<Cartesian, Gmpq, Gmpq>>;

// The sign of the squared distance of the centre from the prism, less r^2. Exact.
CGAL::Comparison_result polytope_order(const moving_sphere::GivenMotion& q) {
  const auto point = [](const portable::Vec3<double>& v) {
    return Cartesian::Point_3(Gmpq(v.x), Gmpq(v.y), Gmpq(v.z));
  };
  const auto exactly = q.displacement<Gmpq>([](double x) { return Gmpq(x); });
  const Cartesian::Vector_3 d{exactly.x, exactly.y, exactly.z};
  std::array<Cartesian::Point_3, 6> prism;
  std::size_t corner = 0;
  for (const auto& vertex : {q.a, q.b, q.c}) {
    prism[corner++] = point(vertex);
    prism[corner++] = point(vertex) - d;
  }
  const std::array centre{point(q.p)};
  const PolytopeDistance found(centre.begin(), centre.end(), prism.begin(), prism.end());
  EXPECT_TRUE(found.is_valid());
  return CGAL::compare(found.squared_distance_numerator() / found.squared_distance_denominator(),
                       Gmpq(q.r) * Gmpq(q.r));
}

TEST(PolytopeDistance, IsAsComputedByHand) {
  MovingQuery<double> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {4, 4, 1}, {-1, -1, 0}, 1};
  EXPECT_EQ(polytope_order(q), CGAL::LARGER) << "the line x + y = 4 is sqrt(3) away at the end";
  q.r = 2;
  EXPECT_EQ(polytope_order(q), CGAL::SMALLER);
  q.p = {1, 1, 5}, q.d = {0, 0, -3};
  EXPECT_EQ(polytope_order(q), CGAL::EQUAL) << "2 above the face at the end";
}

template <class Real>
class PolytopeDistanceLong : public testing::Test {};
using PolytopeReals = testing::Types<float, double>;
TYPED_TEST_SUITE(PolytopeDistanceLong, PolytopeReals);

TYPED_TEST(PolytopeDistanceLong, IsTheOraclesOnTenThousandQueriesOfEachFamily) {
  for (const Family* family : families_of(moving_sphere_test())) {
    const Oracles& oracles = oracles_of(moving_sphere_test(), family->entry);
    const ImageGroup* group = image_group(family->name);
    const std::uint64_t stride = group ? group->size + 1 : 1;  // an image of each base, and another one of the next
    for (std::uint64_t i = 0; i < 10000 / TRIAL_DIVISOR; ++i) {
      const Numbers<TypeParam> numbers = family->make<TypeParam>(1, i * stride);
      const Truth truth = oracles.truth(numbers);
      const auto load = [&](std::size_t k) { return static_cast<double>(numbers[k]); };
      const auto order = family->entry == MovingSphere::entry ? polytope_order(MovingSphere::problem<double>(load))
                                                              : polytope_order(MovingEnds::problem<double>(load));
      ASSERT_EQ(truth.verdict == Verdict::contact, order != CGAL::LARGER)
          << family->name << ", seed 1, query " << i * stride;
      ASSERT_EQ(truth.touching, order == CGAL::EQUAL) << family->name << ", seed 1, query " << i * stride;
    }
  }
}

}  // namespace
}  // namespace axiscert
