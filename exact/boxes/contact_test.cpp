// The numbers beside the verdict of boxes, by hand, of scenes that people reported, and of boxes at random.
#include "exact/boxes/contact.h"

#include "exact/boxes/boxes_testing.h"
#include "exact/numbers/roots.h"

namespace axiscert::boxes {
namespace {

ExactBox upright(const Point& centre, const Point& half) {
  return {centre, {{half.x, half.y, half.z}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}};
}
ExactContact cubes_at(const Point& between) {
  return ExactContact(ExactPair{upright({0, 0, 0}, {1, 1, 1}), upright(between, {1, 1, 1})});
}
double root(const Rational& square) { return nearest_sqrt<double>(square); }
bool is(const Point& p, const Rational& x, const Rational& y, const Rational& z) {
  return p.x == x && p.y == y && p.z == z;
}

TEST(RootSums, HaveTheirSignsExactly) {
  EXPECT_EQ(sign_of_sum({1, 2}, {1, 3}, {-1, 10}), -1) << "3.146 - 3.162";
  EXPECT_EQ(sign_of_sum({1, 2}, {1, 3}, {-1, 9}), 1);
  EXPECT_EQ(sign_of_sum({1, 2}, {2, 2}, {-3, 2}), 0);
  EXPECT_EQ(sign_of_sum({1, 8}, {-1, 2}, {-1, 2}), 0);
  EXPECT_EQ(sign_of_sum({1, 0}, {0, 5}, {0, 1}), 0);
  EXPECT_EQ(sign_of_sum({-1, 2}, {1, 3}), 1);
  EXPECT_EQ(sign_of_sum({-1, 2}, {-1, 3}, {0, 1}), -1);
  const Rational tiny(mpz_class(1), mpz_class(1) << 2000);
  EXPECT_EQ(sign_of_sum({1, 2}, {1, 3}, {-1, Rational(5 + 2 * tiny)}),
            sign_of_sum({2, 6}, {-2, Rational(tiny * tiny)}));
}

TEST(RootSums, AreRoundedUpOnce) {
  const auto order = [](const Rational& y) { return sgn(Rational(2 - y * y)); };
  for (const Rational& guess : {Rational(1414, 1000), Rational(141422, 100000), Rational(1), Rational(3, 2)})
    EXPECT_EQ(round_up(guess, order).text(), "1.41422") << guess;
  const auto exactly = [](const Rational& y) { return cmp(Rational(1, 4), y); };
  EXPECT_EQ(round_up(Rational(251, 1000), exactly).text(), "0.25");
}

TEST(BoxContact, OfCubesOneOnAnother) {
  const ExactContact found = cubes_at({Rational(1, 2), 0, Rational(7, 4)});
  EXPECT_FALSE(found.is_apart());
  EXPECT_EQ(found.squared_separation(), Rational(1, 16));
  ASSERT_TRUE(found.only_normal());
  EXPECT_TRUE(is(*found.only_normal(), 0, 0, found.only_normal()->z));
  EXPECT_GT(found.only_normal()->z, 0) << "the second is above";
  EXPECT_FALSE(found.only_points()) << "faces touch in a rectangle";
  EXPECT_EQ(found.left({0, 0, 3}).text(), "0");
  EXPECT_EQ(found.left({0, 0, -1}).text(), "2");
  EXPECT_EQ(found.left({0, 1, 0}).text(), "1") << "across, nothing is gained";
  EXPECT_EQ(found.compare_left({0, 1, 0}, 1), 0);
  // At the angle t the share is 1 - cos t: 3, 4, 5.
  EXPECT_EQ(found.left({3, 0, 4}).text(), "0.2");
  EXPECT_EQ(found.compare_left({3, 0, 4}, Rational(1, 5)), 0);
  EXPECT_EQ(found.compare_left({3, 0, 4}, Rational(1999999, 10000000)), 1);
  const Decimal6 tilted = found.left({Rational(mpz_class(1), mpz_class(1) << 1000), 0, 1});
  EXPECT_EQ(tilted, round_up(Rational(mpz_class(1), mpz_class(1) << 2001))) << "1 - cos of 2^-1000";
}

TEST(BoxContact, PointsAreUniqueWhereAVertexOrTwoEdgesTouch) {
  const ExactBox tilted{{0, 0, Rational(15, 4)}, {{1, 1, 1}}, {{{1, 0, 2}, {0, 1, 1}, {1, -1, 1}}}};
  const ExactContact found(ExactPair{upright({0, 0, 0}, {3, 3, Rational(1, 4)}), tilted});
  ASSERT_TRUE(found.only_points());
  // The lowest corner is the centre less every axis.
  EXPECT_TRUE(is(found.only_points()->b, -2, 0, Rational(-1, 4)));
  EXPECT_TRUE(is(found.only_points()->a, -2, 0, Rational(1, 4)));
  EXPECT_EQ(found.squared_separation(), Rational(1, 4));
  EXPECT_EQ(found.mismatch({-2, 0, Rational(1, 4)}, {-2, 0, Rational(-1, 4)}), 0);
  EXPECT_EQ(found.mismatch({-2, 0, Rational(1, 4)}, {-2, 0, Rational(1, 8)}), Rational(3, 8));
  EXPECT_EQ(found.squared_distance_from_a({-2, 0, Rational(1, 4)}), 0);
  EXPECT_EQ(found.squared_distance_from_a({-2, 0, 1}), Rational(9, 16));
  EXPECT_EQ(found.squared_distance_from_b({-2, 0, -1}), Rational(9, 16));
}

TEST(BoxContact, OfBoxesApart) {
  const ExactContact found = cubes_at({3, 4, 0});
  EXPECT_TRUE(found.is_apart());
  EXPECT_EQ(found.squared_separation(), 5);
  EXPECT_TRUE(is(*found.only_normal(), 1, 2, 0));
  EXPECT_FALSE(found.only_points()) << "from edge to edge, and these are parallel";
  const ExactContact vertices = cubes_at({3, 4, 5});
  EXPECT_EQ(vertices.squared_separation(), 14);
  EXPECT_TRUE(is(vertices.only_points()->a, 1, 1, 1));
  EXPECT_TRUE(is(vertices.only_points()->b, 2, 3, 4));
  EXPECT_EQ(vertices.mismatch({1, 1, 1}, {2, 3, 4}), 0);
}

TEST(BoxContact, EveryTieIsRight) {
  const ExactContact same = cubes_at({0, 0, 0});
  EXPECT_EQ(same.squared_separation(), 4);
  EXPECT_EQ(same.normals().size(), 6u) << "both ways of three axes";
  EXPECT_FALSE(same.only_normal());
  for (const Point& normal : same.normals()) EXPECT_TRUE(same.left(normal).is_zero());
  EXPECT_EQ(same.left({0, 3, 4}).text(), "0.2");
  const ExactContact diagonal = cubes_at({1, 1, 0});
  EXPECT_EQ(diagonal.normals().size(), 2u);
  EXPECT_TRUE(diagonal.left({5, 0, 0}).is_zero());
  EXPECT_EQ(diagonal.left({-5, 0, 0}).text(), "1") << "the other axis is as it was";
}

TEST(BoxContact, OfFlatBoxesAndDegenerateTriangles) {
  const ExactContact flat(ExactPair{upright({0, 0, 0}, {1, 1, 0}), upright({1, 0, 0}, {1, 1, 0})});
  EXPECT_FALSE(flat.is_apart());
  EXPECT_EQ(flat.squared_separation(), 0) << "in one plane, which a push leaves at once";
  const ExactContact crossing(ExactPair{upright({0, 0, 0}, {1, 1, 0}), upright({0, 0, 0}, {0, 0, 1})});
  EXPECT_EQ(crossing.squared_separation(), 1);
  EXPECT_EQ(crossing.normals().size(), 6u);
  const ExactBox cube = upright({0, 0, 0}, {1, 1, 1});
  const ExactContact point(
      ExactBoxAndTriangle{cube, {{{0, 0, Rational(1, 2)}, {0, 0, Rational(1, 2)}, {0, 0, Rational(1, 2)}}}});
  EXPECT_EQ(point.squared_separation(), Rational(1, 4));
  EXPECT_TRUE(is(point.only_points()->a, 0, 0, 1));
  EXPECT_TRUE(is(point.only_points()->b, 0, 0, Rational(1, 2)));
  const ExactContact segment(ExactBoxAndTriangle{cube, {{{-3, 0, 0}, {3, 0, 0}, {0, 0, 0}}}});
  EXPECT_EQ(segment.squared_separation(), 1);
  EXPECT_EQ(segment.normals().size(), 4u);
}

// A push along an axis that is not a facet's leaves no less than the least one.
TEST(BoxContact, LeftIsAtMostOneMinusTheCosine) {
  Random random(20261127);
  int contacts = 0;
  for (int i = 0; i < 60; ++i) {
    const ExactContact found(exact_pair(independent_pair(random, 2, 2)));
    if (found.is_apart() || found.squared_separation() == 0) continue;
    ++contacts;
    const Vec3<double> v = whole_vector(random, 3);
    Point n{v.x, v.y, v.z};
    if (v.x == 0 && v.y == 0 && v.z == 0) n.x = 1;
    const Decimal6 left = found.left(n);
    EXPECT_LE(left.value(), 2);
    EXPECT_LE(found.compare_left(n, exact(left)), 0) << i;
    if (!left.is_zero()) {
      EXPECT_GT(found.compare_left(n, exact(previous(left))), 0) << i;
    }
    for (const Point& normal : found.normals()) {
      const double cosine =
          nearest<double>(Rational(dot(n, normal))) / (root(Rational(dot(n, n))) * root(Rational(dot(normal, normal))));
      EXPECT_LE(left.value(), 1 - cosine + 1e-5) << i;
    }
  }
  EXPECT_GT(contacts, 20);
}

ExactBox turned_box(const Point& centre, const Point& half, const std::array<Rational, 4>& q) {
  const auto& [w, x, y, z] = q;
  const Rational n = w * w + x * x + y * y + z * z;
  ExactBox box = upright(centre, half);
  box.axis = {{{(w * w + x * x - y * y - z * z) / n, 2 * (x * y + w * z) / n, 2 * (x * z - w * y) / n},
               {2 * (x * y - w * z) / n, (w * w - x * x + y * y - z * z) / n, 2 * (y * z + w * x) / n},
               {2 * (x * z + w * y) / n, 2 * (y * z - w * x) / n, (w * w - x * x - y * y + z * z) / n}}};
  return box;
}
Rational given(std::string_view text) { return parse_decimal(text); }

TEST(BoxContact, OfScenesThatPeopleReported) {
  // A library said 71.056 of these: github.com/google-deepmind/mujoco/issues/3476.
  const ExactContact yawed(ExactPair{upright({0, 0, 0}, {given("35.5"), given("35.5"), 20}),
                                     turned_box({10, given("71.02"), 0}, {given("35.5"), given("35.5"), 20},
                                                {given("0.9999994"), 0, 0, given("0.00107")})});
  EXPECT_NEAR(root(yawed.squared_separation()), 0.055888670699442415, 1e-14);
  EXPECT_TRUE(is(*yawed.only_normal(), 0, yawed.only_normal()->y, 0));
  EXPECT_EQ(yawed.left({0, -1, 0}).text(), "2");
  // A small box on a great one: github.com/google-deepmind/mujoco_warp/issues/1430.
  const ExactContact small(ExactPair{upright({0, 0, given("0.25")}, {100, 100, given("0.25")}),
                                     upright({0, 0, given("0.5995")}, {given("0.1"), given("0.1"), given("0.1")})});
  EXPECT_EQ(root(small.squared_separation()), 0.0005);
  // Nearest points that were NaN: github.com/flexible-collision-library/fcl/issues/293.
  const ExactContact apart(
      ExactPair{upright({given("1.625"), 0, given("0.5")}, {given("1.375"), 3, given("0.025")}),
                turned_box({given("0.192074"), given("-0.277870"), given("0.273546")},
                           {given("0.212"), given("0.075"), given("0.0843")},
                           {given("0.672811"), given("0.340674"), given("0.155066"), given("0.638138")})});
  EXPECT_TRUE(apart.is_apart());
  EXPECT_NEAR(root(apart.squared_separation()), 0.053516162824549275, 1e-15);
  EXPECT_TRUE(apart.only_points());
}

}  // namespace
}  // namespace axiscert::boxes
