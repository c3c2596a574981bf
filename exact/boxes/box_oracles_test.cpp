// The oracles of both entries: queries by hand, agreement on small numbers, and planted faults that they refuse; the
// penetration of a contact that ODE is known to miss.
#include <gmock/gmock.h>

#include <cmath>

#include "exact/boxes/boxes_testing.h"
#include "exact/boxes/trait.h"
#include "exact/judge/oracles_of.h"

namespace axiscert::boxes {
namespace {

using testing::ElementsAre;

const Oracles& matrix_oracles() { return oracles_of(box_box_predicate(), MatrixBoxes::entry); }
const Oracles& quaternion_oracles() { return oracles_of(box_box_predicate(), QuaternionBoxes::entry); }

constexpr std::array<Vec3<double>, 3> unit_axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};

Numbers<double> cubes(const Vec3<double>& at) {
  return numbers_of(BoxPair<double>{{{0, 0, 0}, {1, 1, 1}, unit_axes}, {at, {1, 1, 1}, unit_axes}});
}

TEST(BoxOracles, AnswerByHand) {
  const Oracles& oracles = matrix_oracles();
  EXPECT_EQ(oracles.truth(cubes({3, 0, 0})).verdict, Verdict::separated);
  EXPECT_NEAR(*oracles.depth(cubes({3, 4, 0})), std::sqrt(5.0) / 5, 1e-15);
  EXPECT_TRUE(oracles.truth(cubes({2, 1, 0})).touching);
  EXPECT_EQ(oracles.depth(cubes({2, 1, 0})), 0);
  EXPECT_EQ(oracles.truth(cubes({1.5, 0, 0})).verdict, Verdict::contact);
  EXPECT_FALSE(oracles.truth(cubes({1.5, 0, 0})).touching);
  EXPECT_NEAR(*oracles.depth(cubes({1.5, 0, 0})), 0.5 / std::sqrt(3.0), 1e-15);
  EXPECT_NEAR(*oracles.depth(cubes({0, 0, 0})), 2 / std::sqrt(3.0), 1e-15) << "deeper than 1: one in the other";
  EXPECT_EQ(quaternion_oracles()
                .truth(Numbers<float>{0, 0, 0, 1, 1, 1, 1, 0, 0, 0,  //
                                      2, 0, 0, 1, 1, 1, 0, 5, 0, 0})
                .touching,
            true);
}

TEST(BoxOracles, InvalidAreDependentAxesNegativeExtentsAndNoNumbers) {
  const auto verdict = [](std::size_t column, double value) {
    Numbers<double> numbers = cubes({0, 0, 0});
    numbers[column] = value;
    return matrix_oracles().truth(numbers).verdict;
  };
  EXPECT_EQ(verdict(6, 0), Verdict::invalid) << "axis 0 is 0";
  EXPECT_EQ(verdict(3, -1), Verdict::invalid);
  EXPECT_EQ(verdict(20, INFINITY), Verdict::invalid);
  EXPECT_EQ(verdict(3, 0), Verdict::contact) << "a rectangle";
  EXPECT_EQ(verdict(6, -1), Verdict::contact) << "a basis of the other handedness";
  EXPECT_EQ(verdict(6, 0x1p-1074), Verdict::contact);
  const Numbers<double> no_turn{0, 0, 0, 1, 1, 1, 0, 0, 0, 0, 2, 0, 0, 1, 1, 1, 0, 5, 0, 0};
  EXPECT_EQ(quaternion_oracles().truth(no_turn).verdict, Verdict::invalid);
}

TEST(BoxOracles, SayWhyNumbersAreNoBoxes) {
  const auto why = [](std::size_t column, double value) {
    Numbers<double> numbers = cubes({0, 0, 0});
    numbers[column] = value;
    return matrix_oracles().why_invalid(numbers);
  };
  EXPECT_EQ(why(6, 1), "");
  EXPECT_EQ(why(6, 0), "a.b has the determinant 0; the axes of a box are linearly independent");
  EXPECT_EQ(why(19, -2), "b.s, element 2, is -2; half extents are 0 or more");
  EXPECT_EQ(why(20, INFINITY), "b.s, element 3, is inf; every number is finite");
  EXPECT_EQ(why(10, NAN), "a.b.1, element 2, is nan; every number is finite");
  const Numbers<double> no_turn{0, 0, 0, 1, 1, 1, 1, 0, 0, 0, 2, 0, 0, 1, 1, 1, 0, 0, 0, 0};
  EXPECT_EQ(quaternion_oracles().why_invalid(no_turn), "b.q is 0, 0, 0, 0; a quaternion has an element other than 0");
}

TEST(BoxOracles, RefuseNumbersOfAnotherEntry) {
  EXPECT_THROW(quaternion_oracles().truth(cubes({0, 0, 0})), HarnessFault);
}

TEST(BoxOracles, ToldDetailsAreThePenetrationOrTheDistanceAndTheAxes) {
  const auto details = [](const Vec3<double>& at) { return matrix_oracles().details(cubes(at)); };
  const auto value = [](const Detail& detail) { return std::get<double>(detail.value); };
  const auto axes = [](const Detail& detail) { return std::get<std::vector<std::string_view>>(detail.value); };
  const std::vector<Detail> inside = details({0.5, 1.5, 0}), apart = details({0, 0, -5});
  EXPECT_EQ(value(inside[0]), 0.5);
  EXPECT_TRUE(std::holds_alternative<std::monostate>(inside[1].value));
  // The edges a0 and b2 are at right angles to y too.
  EXPECT_THAT(axes(inside[2]), ElementsAre("a1", "b1", "a0b2", "a2b0"));
  EXPECT_TRUE(std::holds_alternative<std::monostate>(apart[0].value));
  EXPECT_EQ(value(apart[1]), 3);
  EXPECT_THAT(axes(apart[2]), ElementsAre("a2", "b2", "a0b1", "a1b0"));
}

// Faults of the fifteen axes: one that never separates, or one without a term of B's extent that is not 0 on it.
struct PlantedFifteen : ProjectedFifteen {
  inline static std::size_t dropped = axis_count, shortened = axis_count;  // none
  template <class T, class Sink>
  static void comparisons(const BoxPair<T>& q, Sink& sink) {
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) {
      const std::size_t k = i < 3 ? 2 : i < 6 ? i - 3 : next((i - 6) % 3);
      const T short_rhs = rhs - q.b.half[k] * magnitude(dot(direction(q, i), q.b.axis[k]));
      sink(i, i == dropped ? T(0.0) : lhs, i == shortened ? short_rhs : rhs);
    };
    ProjectedFifteen::comparisons<T>(q, planted);
  }
};
struct WithPlantedAxes : MatrixTrait {
  using AllFormulae = FormulaeList<PlantedFifteen>;
};

// A bound that should be closed: touching is not a contact.
struct WithOpenBoxes : MatrixTrait {
  static ClippedTruth geometric_truth(const Numbers<double>& numbers) {
    const ClippedTruth right = MatrixTrait::geometric_truth(numbers);
    return right.touching ? ClippedTruth{{Verdict::separated, false}, right.common} : right;
  }
};

// Whether the oracles refuse one of the first queries of small integers.
template <class Trait>
bool is_caught(int queries) {
  const OraclesOf<Trait> oracles;
  Random random(20261124);
  for (int i = 0; i < queries; ++i) {
    const Numbers<double> numbers = numbers_of(independent_pair(random, 1 + i % 2, 3 + i % 2));
    try {
      oracles.truth(numbers);
    } catch (const OracleDisagreement&) {
      return true;
    }
  }
  return false;
}

TEST(BoxOracles, AgreeOnSmallIntegersAndNotWithAnOpenBound) {
  EXPECT_FALSE(is_caught<MatrixTrait>(400));
  EXPECT_TRUE(is_caught<WithOpenBoxes>(400));
}

TEST(BoxOraclesLong, RefuseEachAxisThatIsDroppedOrShort) {
  for (std::size_t i = 0; i < axis_count; ++i) {
    PlantedFifteen::dropped = i;
    EXPECT_TRUE(is_caught<WithPlantedAxes>(100000)) << axis_names[i] << " dropped";
    PlantedFifteen::dropped = axis_count;
    PlantedFifteen::shortened = i;
    EXPECT_TRUE(is_caught<WithPlantedAxes>(100000)) << axis_names[i] << " short";
    PlantedFifteen::shortened = axis_count;
  }
}

// Over quaternions all forms without an epsilon have the signs of the first, which chain() compares.
TEST(BoxOracles, AllFormsWithoutAnEpsilonHaveOneSignOnQuaternions) {
  Random random(7);
  Kernel kernel = formulae_kernel<QuaternionBoxes, Homogeneous>("box-box/any", "");
  kernel.is_reference = false;
  for (int i = 0; i < 60; ++i) {
    Numbers<double> numbers(20);
    for (double& x : numbers) x = whole(random, 3);
    for (const std::size_t k : {3, 4, 5, 13, 14, 15}) numbers[k] = std::abs(numbers[k]);
    if (quaternion_oracles().truth(numbers).verdict == Verdict::invalid) continue;
    for (const std::string_view formulae : quaternion_oracles().formulae()) {
      kernel.formulae = formulae;
      EXPECT_TRUE(quaternion_oracles().about(numbers)->chain(kernel));
    }
  }
}

// q = (2, 1, 0, 0) turns by the angle about x whose cosine is (4 - 1) / 5 and whose sine is 2 * 2 / 5; the inverse turn
// has the other sign. A needle along the turned y touches a plate where the needle of the inverse is far away.
TEST(BoxOracles, AQuaternionTurnsAsHamiltonHasIt) {
  const ExactBox turned =
      exact_pair(TurnedPair<double>{{{0, 0, 0}, {1, 1, 1}, {2, 1, 0, 0}}, {{0, 0, 0}, {1, 1, 1}, {1, 0, 0, 0}}}).a;
  EXPECT_EQ(turned.axis[0].x, 1);
  EXPECT_EQ(turned.axis[1].y, Rational(3, 5));
  EXPECT_EQ(turned.axis[1].z, Rational(4, 5));
  EXPECT_EQ(turned.axis[2].y, Rational(-4, 5));
  EXPECT_EQ(turned.axis[2].z, Rational(3, 5));
  const auto verdict = [](double x) {
    const Numbers<double> needle_and_cube = numbers_of(
        TurnedPair<double>{{{0, 0, 0}, {0, 5, 0}, {2, x, 0, 0}}, {{0, 3, 4}, {0.5, 0.5, 0.5}, {1, 0, 0, 0}}});
    return quaternion_oracles().truth(needle_and_cube).verdict;
  };
  EXPECT_EQ(verdict(1), Verdict::contact);
  EXPECT_EQ(verdict(-1), Verdict::separated);
}

// Columns of Rz(z) Ry(y) Rx(x), angles in degrees.
std::array<Vec3<double>, 3> turned_by(double x, double y, double z) {
  const auto turn = [](double angle) {
    const double radians = angle * std::acos(-1.0) / 180;
    return std::pair{std::cos(radians), std::sin(radians)};
  };
  const auto [cx, sx] = turn(x);
  const auto [cy, sy] = turn(y);
  const auto [cz, sz] = turn(z);
  return {{{cz * cy, sz * cy, -sy},
           {cz * sy * sx - sz * cx, sz * sy * sx + cz * cx, cy * sx},
           {cz * sy * cx + sz * sx, sz * sy * cx - cz * sx, cy * cx}}};
}

// Two unit cubes, one a quarter turn further than the other. ODE 0.16.2 reports no contact.
TEST(Penetration, OfTheContactThatOdeMissesIsNearlyAHalfExtent) {
  const BoxPair<double> q{{{0, 0, 0}, {1, 1, 1}, turned_by(65, 20, 10)},
                          {{0.5, 1, -0.75}, {1, 1, 1}, turned_by(155, 20, 10)}};
  EXPECT_EQ(matrix_oracles().truth(numbers_of(q)).verdict, Verdict::contact);
  EXPECT_NEAR(nearest_sqrt<double>(squared_penetration(exact_pair(q))), 0.985, 0.0005);
}

TEST(Penetration, IsZeroWhereTheyTouch) {
  const BoxPair<double> q{{{0, 0, 0}, {1, 1, 1}, unit_axes}, {{2, 0.5, 0}, {1, 1, 1}, unit_axes}};
  EXPECT_EQ(squared_penetration(exact_pair(q)), 0);
  EXPECT_EQ(squared_scene(exact_pair(q)), Rational(17, 4));
}

}  // namespace
}  // namespace axiscert::boxes
