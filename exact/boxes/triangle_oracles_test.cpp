// The oracles of a box and a triangle in each entry: queries by hand, agreement on small numbers, and planted faults
// that they refuse.
#include <gmock/gmock.h>

#include <cmath>

#include "exact/boxes/boxes_testing.h"
#include "exact/boxes/triangle_trait.h"
#include "exact/judge/oracles_of.h"

namespace axiscert::boxes {
namespace {

using testing::ElementsAre;

const Oracles& oracles_in(std::size_t entry) { return oracles_of(box_triangle_predicate(), entry); }

// The cube of half extent 1 at the origin, and a triangle.
Numbers<double> at_cube(const std::array<Vec3<double>, 3>& corner) {
  return numbers_of(CentredAndTriangle<double>{{0, 0, 0}, {{1, 1, 1}}, corner});
}

TEST(TriangleOracles, AnswerByHand) {
  const Oracles& oracles = oracles_in(CentreEntry::entry);
  EXPECT_EQ(oracles.truth(at_cube({{{2, 0, 0}, {3, 0, 0}, {2, 1, 0}}})).verdict, Verdict::separated);
  EXPECT_TRUE(oracles.truth(at_cube({{{1, 0, 0}, {3, 0, 0}, {2, 1, 0}}})).touching);
  EXPECT_FALSE(oracles.truth(at_cube({{{0.5, 0, 0}, {3, 0, 0}, {2, 1, 0}}})).touching);
  EXPECT_TRUE(oracles.truth(at_cube({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}})).touching) << "a point at a corner";
  EXPECT_EQ(oracles.truth(at_cube({{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}})).verdict, Verdict::contact) << "a point inside";
  // A plane across a corner of the cube, which is 3 / sqrt(3) from the centre.
  const auto across = [](double d) { return at_cube({{{d, 0, 0}, {0, d, 0}, {0, 0, d}}}); };
  EXPECT_EQ(oracles.truth(across(3)).touching, true);
  EXPECT_EQ(oracles.truth(across(4)).verdict, Verdict::separated);
  EXPECT_NEAR(*oracles.depth(across(4)), 1 / std::sqrt(3.0) / 4, 1e-15);
}

TEST(TriangleOracles, TheFormsOfOneBoxHaveOneTruth) {
  Random random(5);
  for (int i = 0; i < 200; ++i) {
    CentredAndTriangle<double> q{whole_vector(random, 2), {{0, 0, 0}}, {}};
    for (double& s : q.half) s = below(random, 3);
    for (Vec3<double>& corner : q.corner) corner = whole_vector(random, 3);
    const Vec3<double> half = {q.half[0], q.half[1], q.half[2]};
    const CornersAndTriangle<double> corners{q.centre - half, q.centre + half, q.corner};
    const Truth truth = oracles_in(CentreEntry::entry).truth(numbers_of(q));
    const Truth of_corners = oracles_in(MinmaxEntry::entry).truth(numbers_of(corners));
    const Truth turned = oracles_in(OrientedEntry::entry).truth(numbers_of(oriented(q)));
    const TurnedAndTriangle<double> straight{{q.centre, q.half, {-2, 0, 0, 0}}, q.corner};
    const Truth of_quaternion = oracles_in(TurnedEntry::entry).truth(numbers_of(straight));
    EXPECT_TRUE(truth.verdict == of_quaternion.verdict && truth.touching == of_quaternion.touching) << i;
    EXPECT_TRUE(truth.verdict == of_corners.verdict && truth.touching == of_corners.touching) << i;
    EXPECT_TRUE(truth.verdict == turned.verdict && truth.touching == turned.touching) << i;
  }
}

TEST(TriangleOracles, SayWhyNumbersAreNoQuery) {
  Numbers<double> numbers = at_cube({{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}});
  numbers[4] = -1;
  EXPECT_EQ(oracles_in(CentreEntry::entry).why_invalid(numbers), "box.s, element 2, is -1; half extents are 0 or more");
  numbers = numbers_of(CornersAndTriangle<double>{{0, 2, 0}, {1, 1, 1}, {}});
  EXPECT_EQ(oracles_in(MinmaxEntry::entry).why_invalid(numbers),
            "box.min on y is 2, above 1 in box.max; on each axis min is at most max");
  EXPECT_EQ(oracles_in(MinmaxEntry::entry).truth(numbers).verdict, Verdict::invalid);
  numbers = numbers_of(CornersAndTriangle<double>{{3, 2, 0}, {1, 1, 1}, {}});
  EXPECT_EQ(oracles_in(MinmaxEntry::entry).why_invalid(numbers),
            "box.min on x is 3, above 1; box.min on y is 2, above 1 in box.max; on each axis min is at most max");
  numbers = numbers_of(BoxAndTriangle<double>{});
  EXPECT_EQ(oracles_in(OrientedEntry::entry).why_invalid(numbers),
            "box.b has the determinant 0; the axes of a box are linearly independent");
}

TEST(TriangleOracles, DetailsAreThePenetrationAndItsAxes) {
  const auto details = oracles_in(CentreEntry::entry).details(at_cube({{{0.5, 0, 0}, {3, 0, 0}, {3, 1, 0.5}}}));
  EXPECT_EQ(std::get<double>(details[0].value), 0.5);
  EXPECT_THAT(std::get<std::vector<std::string_view>>(details[2].value), ElementsAre("x", "y_bc", "z_bc"));
}

// Planted: an axis that never separates.
struct PlantedThirteen {
  static constexpr std::string_view name = "planted";
  static constexpr FormulaeKind kind = FormulaeKind::rung;
  inline static std::size_t dropped = thirteen_count;
  template <class T, class Sink>
  static void comparisons(const BoxAndTriangle<T>& q, Sink& sink) {
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) { sink(i, i == dropped ? T(-1.0) : lhs, rhs); };
    Thirteen::comparisons<T>(q, planted);
  }
};
struct WithoutAnAxis : TriangleTrait<OrientedEntry> {
  using AllFormulae = FormulaeList<PlantedThirteen>;
};

bool is_triangle_caught(int queries) {
  const OraclesOf<WithoutAnAxis> oracles;
  Random random(20261124);
  for (int i = 0; i < queries; ++i) {
    BoxAndTriangle<double> q{independent_box(random, 1 + i % 2, 3), {}};
    for (Vec3<double>& corner : q.corner) corner = whole_vector(random, 4);
    try {
      oracles.truth(numbers_of(q));
    } catch (const OracleDisagreement&) {
      return true;
    }
  }
  return false;
}

TEST(TriangleOracles, AgreeOnSmallIntegers) { EXPECT_FALSE(is_triangle_caught(400)); }
TEST(TriangleOraclesLong, RefuseEachAxisThatIsDropped) {
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    PlantedThirteen::dropped = i;
    EXPECT_TRUE(is_triangle_caught(100000)) << thirteen_names[i];
    PlantedThirteen::dropped = thirteen_count;
  }
}

}  // namespace
}  // namespace axiscert::boxes
