// The theorem: with `>=` in the sides and headings, one of the twenty axes separates exactly where the motion has no
// contact; and what strict ones get wrong.
#include <gtest/gtest.h>

#include <array>
#include <bit>
#include <cmath>

#include "exact/moving_sphere/moving_sphere_testing.h"

namespace axiscert::moving_sphere {
namespace {

using Point = portable::Vec3<double>;

// The greatest squared radius below which an axis separates, as numerator over denominator; -1 over 1: none does. Over
// small integers, so that doubles are exact.
struct Reach {
  double numerator = -1, denominator = 1;
  bool operator==(const Reach& other) const { return numerator * other.denominator == other.numerator * denominator; }
};

// Every radius at once: an axis whose sides hold separates where r r is below the quotient of its radius comparison's
// sides at r = 1. holds(i, lhs, rhs) is a side.
template <class Sides>
Reach reach_of_the_axes(const MovingQuery<double>& at_radius_1, Sides&& holds) {
  std::array<double, comparison_names.size()> lhs, rhs;
  bits_of<Twenty, double>(at_radius_1, [&](std::size_t i, double l, double r) {
    lhs[i] = l;
    rhs[i] = r;
  });
  Reach most;
  for (std::size_t i = 0; i < comparison_names.size();) {
    const std::size_t radius = i++;
    bool all = rhs[radius] > 0;  // 0 > 0 never holds
    for (; i < comparison_names.size() && !is_radius(i); ++i) all = all && holds(i, lhs[i], rhs[i]);
    if (all && lhs[radius] * most.denominator > most.numerator * rhs[radius]) most = {lhs[radius], rhs[radius]};
  }
  return most;
}

// The queries that `>` gets wrong in place of `>=`: all, and by what is degenerate, each in the first that it is.
enum WrongClass : std::uint8_t { all_wrong, zero_area, no_motion, parallel, other_wrong };
using WrongOf = std::array<int, 5>;

// The triangles of {-1, 0, 1}^3 and displacements of the same, with P = 0. `>` in none of the sides and headings, in
// one of them, in the sides alone, in the headings alone, and in both.
struct WrongConfigurations {
  int all = 0, nonstrict = 0, one_strict = 0, missed = 0;
  WrongOf strict_sides{}, strict_headings{}, strict{};
};

WrongConfigurations wrong_configurations(int step) {
  WrongConfigurations found;
  const auto point = [](int i) { return Point{double(i % 3 - 1), double(i / 3 % 3 - 1), double(i / 9 % 3 - 1)}; };
  for (int i = 0; i < 531441; i += step) {
    ++found.all;
    const Point a = point(i), b = point(i / 27), c = point(i / 729), d = point(i / 19683);
    const MovingQuery<double> q{a, b, c, {0, 0, 0}, d, 1};
    const Rational least = least_distance(q).squared;
    const Reach truth{least.get_num().get_d(), least.get_den().get_d()};
    const auto reach_where = [&](auto&& is_strict) {
      return reach_of_the_axes(
          q, [&](std::size_t k, double lhs, double rhs) { return is_strict(k) ? lhs > rhs : lhs >= rhs; });
    };
    // Contact at every radius is a least distance of 0; an axis then reaches no further than 0.
    const auto is_right = [&](const Reach& reach) { return reach == truth || (least == 0 && reach.numerator <= 0); };
    for (std::size_t strict = 0; strict < comparison_names.size(); ++strict) {
      if (is_radius(strict)) continue;
      found.one_strict += !is_right(reach_where([=](std::size_t k) { return k == strict; }));
    }
    found.nonstrict += !is_right(reach_where([](std::size_t) { return false; }));

    const auto is_heading = [](std::size_t k) { return (heading_bits & one_bit<ComparisonBits>(k)) != 0; };
    const Point normal = cross(b - a, c - a);
    const auto count = [&](const Reach& reach, WrongOf& wrong) {
      if (is_right(reach)) return;
      ++wrong[all_wrong];
      found.missed += reach.numerator * truth.denominator > truth.numerator * reach.denominator;
      ++wrong[dot(normal, normal) == 0 ? zero_area
              : dot(d, d) == 0         ? no_motion
              : dot(d, normal) == 0    ? parallel
                                       : other_wrong];
    };
    count(reach_where([&](std::size_t k) { return !is_heading(k); }), found.strict_sides);
    count(reach_where(is_heading), found.strict_headings);
    count(reach_where([](std::size_t) { return true; }), found.strict);
  }
  return found;
}

TEST(TwentyAxes, NonstrictAreRightOnASampleOfTheLattice) {
  const WrongConfigurations found = wrong_configurations(101);
  EXPECT_EQ(found.nonstrict, 0);
  EXPECT_EQ(found.one_strict, 0) << "of the 41 sides and headings, each strict alone (docs/mutation.md)";
  EXPECT_EQ(found.missed, 0);
  EXPECT_GT(found.strict[all_wrong], found.all / 6);
  EXPECT_GT(found.strict[parallel], 0);
  EXPECT_EQ(found.strict_sides[all_wrong], found.strict_sides[zero_area]);
  EXPECT_EQ(found.strict_headings[parallel], 0);
  EXPECT_EQ(found.strict[other_wrong] + found.strict_headings[other_wrong], 0);
}

TEST(TwentyAxesLong, OfAllLatticeConfigurationsTheNonstrictAreWrongOnNoneAndTheStrictOnThese) {
  const WrongConfigurations found = wrong_configurations(1);
  EXPECT_EQ(found.all, 531441);
  EXPECT_EQ(found.nonstrict, 0);
  EXPECT_EQ(found.one_strict, 0);
  EXPECT_EQ(found.missed, 0) << "strict sides and headings invent contacts alone";
  // All, zero area, D = 0, parallel to the plane, any other.
  EXPECT_EQ(found.strict_sides, (WrongOf{50428, 50428, 0, 0, 0}));
  EXPECT_EQ(found.strict_headings, (WrongOf{15146, 2114, 13032, 0, 0}));
  EXPECT_EQ(found.strict, (WrongOf{109252, 50428, 13032, 45792, 0}));
}

TEST(TwentyAxes, AreTheSixtyOneComparisonsOfTheDescription) {
  const Predicate& predicate = moving_sphere_predicate();
  EXPECT_EQ(predicate.comparisons.size(), 61u);
  EXPECT_EQ(predicate.clauses.size(), 20u);
  EXPECT_EQ(predicate.entries[0].columns.size(), 16u);
  for (const PredicateClause& clause : predicate.clauses) {
    EXPECT_EQ(std::popcount(clause.comparisons & ~side_bits), 1) << clause.name << " has one radius comparison";
  }
  EXPECT_EQ(comparison_names[start_axes], "start.plane.radius");
  EXPECT_EQ(comparison_names[end_axes], "end.plane.radius");
  EXPECT_EQ(comparison_names[sweep_axes], "sweep.vertex_a.radius");
}

const Oracles& real_oracles() { return oracles_of(moving_sphere_predicate()); }

TEST(MovingSphereOracles, AnswerByHand) {
  const auto truth = [](const MovingQuery<double>& q) { return real_oracles().truth(Numbers<double>(q)); };
  const Truth grazes = truth(at_the_corner({1, 1, 1}, {1, 0, 0}, 1));
  EXPECT_EQ(grazes.verdict, Verdict::contact);
  EXPECT_TRUE(grazes.touching);
  EXPECT_EQ(truth(at_the_corner({1, 1, 1}, {1, 0, 0}, 0.5)).verdict, Verdict::separated);
  EXPECT_FALSE(truth(at_the_corner({1, 1, 1}, {1, 0, -0.5}, 1)).touching);
  EXPECT_FALSE(truth(at_the_corner({1, 1, 1}, {0, 0, -2}, 0)).touching) << "a point that crosses the face";
  EXPECT_TRUE(truth(at_the_corner({1, 0, 1}, {0, 0, -2}, 0)).touching) << "a point that crosses an edge";
  EXPECT_EQ(truth(at_the_corner({1, 1, 1}, {0, 0, 0}, -1)).verdict, Verdict::invalid);
  EXPECT_EQ(truth(at_the_corner({1, 1, INFINITY}, {0, 0, 0}, 1)).verdict, Verdict::invalid);
  // Least distance 1, radius 1/2; B and C are farthest from P, at the root of 11.
  const auto q = at_the_corner({1, 1, 1}, {0, 0, 0}, 0.5);
  EXPECT_EQ(real_oracles().depth(Numbers<double>(q)), 0.5 / std::sqrt(11.0));
}

// The same motions by their ends: nothing is rounded where all are small integers.
TEST(MovingSphereOracles, OfEndsAnswerAsThoseOfDisplacements) {
  const Oracles& of_ends = oracles_of(moving_sphere_predicate(), MovingEnds::entry);
  constexpr std::uint64_t seed = 20261126;
  std::mt19937_64 random(seed);
  int contacts = 0;
  for (int i = 0; i < 1000; ++i) {
    const MovingQuery<double> q = small_query(random, 1 + i % 3);
    const Numbers<double> motion = q, ends = EndsQuery<double>{q.a, q.b, q.c, q.p, q.p + q.d, q.r};
    const Truth truth = real_oracles().truth(motion), other = of_ends.truth(ends);
    ASSERT_TRUE(truth.verdict == other.verdict && truth.touching == other.touching)
        << "seed " << seed << ", query " << i;
    ASSERT_EQ(real_oracles().depth(motion), of_ends.depth(ends)) << "seed " << seed << ", query " << i;
    if (truth.verdict != Verdict::contact) continue;
    ++contacts;
    const auto one = real_oracles().details(motion), two = of_ends.details(ends);
    for (std::size_t k = 0; k < one.size(); ++k)
      ASSERT_EQ(one[k].value, two[k].value) << one[k].name << ", seed " << seed << ", query " << i;
  }
  EXPECT_GT(contacts, 100);
  EXPECT_THROW(real_oracles().truth(Numbers<double>(15)), HarnessFault);
}

// Whether the oracles refuse one of the first `queries` small queries.
template <class Trait>
bool is_caught(int queries) {
  const OraclesOf<Trait> oracles;
  std::mt19937_64 random(20261125);
  for (int i = 0; i < queries; ++i) {
    MovingQuery<double> q = small_query(random, 1 + i % 3);
    // Every other one backwards: the axes at the end are then as often needed as those at the start.
    if (i % 2 == 1) {
      q.p = q.p + q.d;
      q.d = portable::Vec3<double>{0, 0, 0} - q.d;
    }
    const Numbers<double> numbers = q;
    try {
      oracles.truth(numbers);
    } catch (const OracleDisagreement&) {
      return true;
    }
  }
  return false;
}

TEST(MovingSphereOracles, AgreeOnSmallIntegersAndNotWithAnOpenBound) {
  EXPECT_FALSE(is_caught<MovingSphereTrait>(2000));
  EXPECT_TRUE(is_caught<WithOpenBound>(2000));
}

TEST(MovingSphereOracles, RefuseEachComparisonWithItsSidesExchanged) {
  for (std::size_t i = 0; i < comparison_names.size(); ++i) {
    PlantedAxes::exchanged = i;
    EXPECT_TRUE(is_caught<WithPlantedAxes>(20000)) << comparison_names[i];
  }
  PlantedAxes::exchanged = comparison_names.size();
  EXPECT_FALSE(is_caught<WithPlantedAxes>(200));
}

TEST(MovingSphereOraclesLong, RefuseAnAxisThatIsDropped) {
  for (const PredicateClause& clause : moving_sphere_predicate().clauses) {
    PlantedAxes::dropped = clause.name;
    EXPECT_TRUE(is_caught<WithPlantedAxes>(400000)) << clause.name;
  }
  PlantedAxes::dropped = "";
}

}  // namespace
}  // namespace axiscert::moving_sphere
