// The kernels of the moving sphere on queries by hand, their faults over the reals among them, and the forms in lanes
// against the scalar ones, bit for bit.
#include <gtest/gtest.h>

#include <random>

#include "kernel/ask.h"
#include "kernel/moving_sphere/timed.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/sphere_triangle/forms/simd.h"
#include "kernel/sphere_triangle/forms/methods.h"
#include "kernel/random_testing.h"

namespace axiscert::moving_sphere {
namespace {

using testing_support::same;

template <class Real>
Reply<Real> asked(std::string_view id, const QueryBatch<Real>& batch, std::string_view target = scalar_target) {
  Reply<Real> reply;
  ask(find_kernel(std::string("moving-sphere/") + std::string(id)).on<Real>(target), batch.columns(), reply);
  return reply;
}

// The time that a kernel reports of one query; empty where it says "separated".
std::optional<double> time_by(std::string_view id, const MovingQuery<double>& q) {
  QueryBatch<double> batch(1, 16);
  batch.push_back(q);
  const Reply<double> reply = asked(id, batch);
  if (reply.verdicts[0] == Verdict::separated) return std::nullopt;
  return reply.measures(0).at(time_measure);
}

constexpr std::string_view with_time[] = {"gated",   "walk",   "rounded", "rounded-quotient", "rounded-products",
                                          "fauerby", "physx4", "physx5",  "advance"};

// From (1, 1, 3) down on the triangle (0,0,0) (4,0,0) (0,4,0).
MovingQuery<double> falling() { return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {0, 0, -4}, 1}; }

TEST(MotionKernels, AllFindTheFaceAnEdgeAndAVertex) {
  for (const std::string_view id : with_time) {
    EXPECT_EQ(time_by(id, falling()), 0.5) << id << ": down on the face";
    const auto edge = time_by(id, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {2, -3, 0.5}, {0, 4, -0.25}, 1});
    ASSERT_TRUE(edge) << id;
    EXPECT_NEAR(*edge, 0.51780, 1e-4) << id << ": against AB, from a little above the plane";
    EXPECT_EQ(time_by(id, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {0, 0, 4}, 1}), std::nullopt) << id << ": away";
    EXPECT_EQ(time_by(id, {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 3}, {0, 0, -1}, 1}), std::nullopt)
        << id << ": short";
  }
}

TEST(MotionKernels, GatedAndRoundedSayWhereTheyTouch) {
  QueryBatch<double> batch(1, 16);
  batch.push_back(falling());
  for (const std::string_view id : {"gated", "rounded", "rounded-products"}) {
    EXPECT_EQ(asked(id, batch).measures(0), (std::vector<double>{0.5, 6, 0, 0, 1, 1, 1, 0})) << id;
  }
}

// A motion in the plane of the triangle, at height 0 and at height 1/2; PhysX gives both up.
TEST(PhysX, MissesAMotionParallelToThePlane) {
  const MovingQuery<double> known{{-1, 1, 0}, {1, -1, 1}, {0, 0, 1}, {0, 0, -1}, {0, 0, 1}, 0.75};
  const MovingQuery<double> above{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, -3, 0.5}, {0, 4, 0}, 1};
  for (const MovingQuery<double>& q : {known, above}) {
    EXPECT_EQ(time_by("physx4", q), std::nullopt);
    EXPECT_EQ(time_by("physx5", q), std::nullopt);
    for (const std::string_view id : {"gated", "walk", "rounded", "fauerby"}) EXPECT_TRUE(time_by(id, q)) << id;
  }
  EXPECT_NEAR(time_by("gated", known).value(), 0.7045, 1e-4);
}

// A triangle of area 2^-19, in units of the user: its determinant is less than 1e-5.
TEST(PhysX, MissesASmallTriangle) {
  MovingQuery<double> q = falling();
  for (auto* v : {&q.a, &q.b, &q.c, &q.p, &q.d}) *v = *v * 0x1p-11;
  q.r *= 0x1p-11;
  EXPECT_EQ(time_by("physx4", q), std::nullopt);
  EXPECT_EQ(time_by("physx5", q), std::nullopt);
  EXPECT_EQ(time_by("gated", q), 0.5);
}

TEST(PhysX, MissesZeroAreaAndNoMotion) {
  const MovingQuery<double> line{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 0, 3}, {0, 0, -4}, 1};
  const MovingQuery<double> still{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 0.5}, {0, 0, 0}, 1};
  for (const std::string_view id : {"physx4", "physx5"}) {
    EXPECT_EQ(time_by(id, line), std::nullopt) << id;
    EXPECT_EQ(time_by(id, still), std::nullopt) << id;
  }
  EXPECT_EQ(time_by("walk", line), 0.5);
  EXPECT_EQ(time_by("walk", still), 0);
}

TEST(Fauerby, HasNoTestOfTheStartAndNoMotionOfAPoint) {
  const MovingQuery<double> inside{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {-0.5, -0.25, 0}, {8, 0, 0.5}, 1};
  EXPECT_GT(time_by("fauerby", inside).value(), 0) << "late";
  EXPECT_EQ(time_by("gated", inside), 0);
  MovingQuery<double> point = falling();
  point.r = 0;
  EXPECT_EQ(time_by("fauerby", point), std::nullopt);
  EXPECT_EQ(time_by("gated", point), 0.75);
}

// D = 0 has no time at which anything is met, and zero area no normal.
TEST(Rounded, HasNoStartOfATriangleWithoutArea) {
  const MovingQuery<double> line{{0, 0, 0}, {2, 0, 0}, {4, 0, 0}, {1, 0, 0.5}, {0, 0, 0}, 1};
  EXPECT_EQ(time_by("rounded", line), std::nullopt);
  EXPECT_EQ(time_by("gated", line), 0);
}

EndsQuery<double> by_ends(const MovingQuery<double>& q) { return {q.a, q.b, q.c, q.p, q.p + q.d, q.r}; }

TEST(Ends, AreTheMotionByItsDisplacementWhereNothingIsRounded) {
  std::mt19937_64 random(11);
  QueryBatch<double> motions(3000, 16), ends(3000, 16);
  for (int i = 0; i < 3000; ++i) {
    Numbers<double> numbers(16);
    for (double& x : numbers) x = static_cast<double>(static_cast<int>(random() % 9) - 4);
    const auto q = MovingSphere::problem<double>([&](std::size_t k) { return numbers[k]; });
    motions.push_back(q);
    ends.push_back(by_ends(q));
  }
  for (const auto& [by_displacement, by_end] : {std::pair{"twenty", "ends-twenty"},
                                                {"twenty-nonstrict", "ends-twenty-nonstrict"},
                                                {"twenty-nonstrict", "ends-difference"},
                                                {"gated", "ends-gated"},
                                                {"rounded", "ends-rounded"}}) {
    const Reply<double> one = asked(by_displacement, motions), other = asked(by_end, ends);
    EXPECT_EQ(one.verdicts, other.verdicts) << by_end;
    if (other.has_bits) {
      EXPECT_EQ(one.answers.bits, other.answers.bits) << by_end;
    }
    EXPECT_EQ(find_kernel("moving-sphere/" + std::string(by_end)).entry, MovingEnds::entry);
    for (std::size_t i = 0; i < motions.size(); ++i) {
      if (one.verdicts[i] != Verdict::contact) continue;
      const auto measures = one.measures(i), others = other.measures(i);
      ASSERT_TRUE(std::equal(measures.begin(), measures.end(), others.begin(), others.end(), same<double>))
          << by_end << " query " << i;
    }
  }
}

// From z = 10^8 down to z = 1, a radius of 1/2 above the face: in binary32 1 - 10^8 is -10^8, which goes on to the
// face.
TEST(Ends, AreExactWhereTheDisplacementIsRounded) {
  const EndsQuery<float> q{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {1, 1, 1e8f}, {1, 1, 1}, 0.5f};
  QueryBatch<float> batch(1, 16);
  batch.push_back(q);
  for (const std::string_view id : {"ends-twenty", "ends-twenty-nonstrict"})
    EXPECT_EQ(asked(id, batch).verdicts[0], Verdict::separated) << id;
  for (const std::string_view id : {"ends-difference", "ends-gated", "ends-rounded"})
    EXPECT_EQ(asked(id, batch).verdicts[0], Verdict::contact) << id << " asks about another motion";
}

TEST(Nearest, IsTheClosestPointOfTheStaticPredicateToTheBit) {
  std::mt19937_64 random(5);
  for (int i = 0; i < 20000; ++i) {
    const Query<double> q = testing_support::random_query<double>(random, false);
    const portable::CentredProblem<double> at{q.a, q.b, i % 5 == 0 ? q.b : q.c, 0};
    const auto expected = methods::ClosestPoint::closest(at, 0.0), found = portable::nearest_point(at.a, at.b, at.c);
    ASSERT_TRUE(same(expected.x, found.x) && same(expected.y, found.y) && same(expected.z, found.z)) << i;
  }
}

template <class Real>
class MotionSimdTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(MotionSimdTest, Reals);

// Numbers in [-1, 1), every third query with arbitrary bits, every fourth of small integers.
template <class Real>
QueryBatch<Real> mixed_queries(std::size_t count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  QueryBatch<Real> batch(count, 16);
  for (std::size_t i = 0; i < count; ++i) {
    Numbers<Real> numbers(16);
    for (Real& x : numbers) {
      const std::uint64_t bits = random();
      if (i % 3 == 2) x = std::bit_cast<Real>(static_cast<testing_support::Bits<Real>>(bits));
      else if (i % 4 == 1) x = static_cast<Real>(static_cast<int>(bits % 7) - 3);
      else x = static_cast<Real>(static_cast<std::int64_t>(bits) >> 11) * Real(0x1p-52);
    }
    batch.push_back(numbers);
  }
  return batch;
}

template <class Real>
void expect_same(std::string_view id, const QueryBatch<Real>& batch, const std::string& target) {
  const Reply<Real> scalar = asked(id, batch), found = asked(id, batch, target);
  ASSERT_EQ(found.verdicts, scalar.verdicts) << id << " " << target;
  if (!scalar.has_bits) return;
  ASSERT_EQ(found.answers.bits, scalar.answers.bits) << id << " " << target;
  for (std::size_t k = 0; k < comparison_names.size(); ++k) {
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_TRUE(same(found.answers.lhs[k][i], scalar.answers.lhs[k][i]) &&
                  same(found.answers.rhs[k][i], scalar.answers.rhs[k][i]))
          << id << " " << target << " query " << i << " " << comparison_names[k];
    }
  }
}

TYPED_TEST(MotionSimdTest, AgreesWithTheScalarFormToTheBitForEveryTail) {
  for (const std::string& target : simd_targets()) {
    for (const std::string_view id : {"twenty", "twenty-nonstrict", "rounded"}) {
      ASSERT_TRUE(find_kernel("moving-sphere/" + std::string(id)).has_simd);
      expect_same(id, mixed_queries<TypeParam>(6000, 20261125), target);
      for (std::size_t size = 1; size <= 35; ++size) expect_same(id, mixed_queries<TypeParam>(size, size), target);
    }
  }
}

// The comparison above does tell forms apart.
TYPED_TEST(MotionSimdTest, TheStrictFormIsNotTheNonstrictOne) {
  const QueryBatch<TypeParam> batch = mixed_queries<TypeParam>(6000, 20261125);
  const std::string target = simd_targets().front();
  EXPECT_NE(asked("twenty", batch, target).answers.bits, asked("twenty-nonstrict", batch).answers.bits);
  EXPECT_NE(asked("rounded", batch, target).verdicts, asked("twenty", batch).verdicts);
}

// Whether a side of some query differs by more than which NaN it is.
template <class Real>
bool differ(const Reply<Real>& one, const Reply<Real>& other) {
  for (std::size_t k = 0; k < comparison_names.size(); ++k) {
    const auto& a = one.answers.lhs[k];
    if (!std::equal(a.begin(), a.end(), other.answers.lhs[k].begin(), same<Real>)) return true;
  }
  return false;
}

// On {-1, 0, 1} no operation is rounded in any of them; on other numbers some are rounded otherwise.
TYPED_TEST(MotionSimdTest, EveryArithmeticIsThePlainOneWhereNothingIsRounded) {
  std::mt19937_64 random(9);
  QueryBatch<TypeParam> lattice(2000, 16);
  for (int i = 0; i < 2000; ++i) {
    Numbers<TypeParam> numbers(16);
    for (TypeParam& x : numbers) x = static_cast<TypeParam>(static_cast<int>(random() % 3) - 1);
    lattice.push_back(numbers);
  }
  const QueryBatch<TypeParam> rounded = mixed_queries<TypeParam>(2000, 3);
  int checked = 0, different = 0;
  for (const std::string rung : {"twenty", "twenty-nonstrict"}) {
    const Reply<TypeParam> plain = asked(rung, lattice), plain_rounded = asked(rung, rounded);
    for (const ArithmeticInfo& arithmetic : arithmetics()) {
      const std::string id = rung + "+" + arithmetic.name;
      const Kernel& kernel = find_kernel("moving-sphere/" + id);
      if (!kernel.has(precision_of<TypeParam>)) continue;
      ++checked;
      const Reply<TypeParam> there = asked(id, lattice);
      EXPECT_EQ(there.verdicts, plain.verdicts) << id;
      EXPECT_EQ(there.answers.bits, plain.answers.bits) << id;
      different += differ(asked(id, rounded), plain_rounded);
      EXPECT_FALSE(kernel.is_reference) << id;
      EXPECT_EQ(kernel.formulae, rung);
    }
  }
  EXPECT_GE(checked, 26);
  EXPECT_GE(different, 16) << "of " << checked;
}

}  // namespace
}  // namespace axiscert::moving_sphere
