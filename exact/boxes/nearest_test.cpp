// Nearest points of hulls, and that their certificate is refused where anything in it is wrong.
#include "exact/boxes/nearest.h"

#include "exact/boxes/boxes_testing.h"

namespace axiscert::boxes {
namespace {

const Hull square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

Rational distance2(const Hull& a, const Hull& b) { return squared_distance(a, b); }

// The coordinates are small integers.
BinaryHull binary(const Hull& hull) {
  BinaryHull points;
  const auto number = [](const Rational& x) { return BinaryNumber(x.get_d()); };
  for (const Point& p : hull) points.push_back({number(p.x), number(p.y), number(p.z)});
  return points;
}
std::vector<BinaryNumber> weights(std::initializer_list<double> values) {
  std::vector<BinaryNumber> all;
  for (const double x : values) all.emplace_back(x);
  return all;
}

TEST(NearestPoints, OfAVertexAnEdgeAndAFace) {
  EXPECT_EQ(distance2(square, {{3, 3, 1}}), 3) << "vertex to vertex";
  EXPECT_EQ(distance2(square, {{1, 4, 1}, {3, 4, 1}}), 5) << "edge to edge";
  EXPECT_EQ(distance2(square, {{1, 1, 2}, {1, 1, 5}}), 4) << "face to vertex";
  EXPECT_EQ(distance2({{0, 0, 0}, {1, 2, 2}}, {{3, 0, 0}}), 8) << "a line and a point";
  EXPECT_EQ(distance2({{Rational(1, 3), 0, 0}}, {{0, Rational(1, 7), 0}}), Rational(58, 441));
}

TEST(NearestPoints, OfHullsInContactAreOnePointInBoth) {
  for (const Hull& other : {Hull{{1, 1, -1}, {1, 1, 1}}, Hull{{2, 2, 0}}, Hull{{1, 1, 0}, {1, 1, 0}}, square,
                            Hull{{5, 1, -2}, {-2, 1, 1}, {1, 1, 1}, {0, 5, 1}}}) {
    const NearestPoints found = nearest_points(binary(square), binary(other));
    EXPECT_TRUE(found.in_contact());
    EXPECT_EQ(refutation_text(found, binary(square), binary(other)), "");
  }
}

TEST(NearestPoints, ACertificateWithAnythingWrongIsRefused) {
  const Hull other = {{3, 3, 1}, {4, 3, 1}};
  const NearestPoints right = nearest_points(binary(square), binary(other));
  EXPECT_EQ(refutation_text(right, binary(square), binary(other)), "");
  const auto refusal = [&](auto change) {
    NearestPoints wrong = right;
    change(wrong);
    return refutation_text(wrong, binary(square), binary(other));
  };
  EXPECT_EQ(refusal([](NearestPoints& n) { n.weights_a.pop_back(); }), "there is not one weight a vertex");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.weights_b = weights({2, -1}); }), "a weight is negative");
  EXPECT_EQ(refusal([](NearestPoints& n) {
              n.weights_b = weights({1, 1});
            }),
            "the weights of a hull do not sum to the total");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.total = n.total + n.total; }),
            "the weights of a hull do not sum to the total");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.total = BinaryNumber(); }), "the total is not positive");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.apart.z = n.apart.z + BinaryNumber(1); }), "the points are not `apart`");
  // From vertex to vertex, and not the nearest two: first of A, then of B.
  const auto from_to = [&](std::size_t i, std::size_t j) {
    const BinaryHull a = binary(square), b = binary(other);
    NearestPoints n{std::vector<BinaryNumber>(4), std::vector<BinaryNumber>(2), BinaryNumber(1), a[i] - b[j]};
    n.weights_a[i] = BinaryNumber(1);
    n.weights_b[j] = BinaryNumber(1);
    return refutation_text(n, a, b);
  };
  EXPECT_EQ(from_to(1, 0), "a vertex of A is nearer along `apart`");
  EXPECT_EQ(from_to(2, 1), "a vertex of B is nearer along `apart`");
  EXPECT_EQ(from_to(2, 0), "");
}

TEST(NearestPoints, AgreeWithTheEdgesClippedOnSmallIntegers) {
  constexpr std::uint64_t seed = 20261124;
  SCOPED_TRACE(testing::Message() << "seed " << seed);
  Random random(seed);
  int contacts = 0, touching = 0;
  for (int i = 0; i < 1000; ++i) {
    const BoxPair<double> q = independent_pair(random, 1 + i % 3, 4 + i % 3);
    const Common common = common_of(scaled<DyadicNumber>(q));
    ASSERT_EQ(common.meets, !are_apart(q)) << i;
    contacts += common.meets;
    touching += common.meets && !common.interiors_meet;
  }
  EXPECT_GT(contacts, 200);
  EXPECT_LT(contacts, 800);
  EXPECT_GT(touching, 40);
}

TEST(NearestPointsLong, AgreeWithTheEdgesClippedOnTwentyThousandPairs) {
  Random random(5);
  for (int i = 0; i < 20000 / TRIAL_DIVISOR; ++i) {
    const BoxPair<double> q = independent_pair(random, 1 + i % 4, 4 + i % 5);
    ASSERT_EQ(common_of(scaled<DyadicNumber>(q)).meets, !are_apart(q)) << i;
  }
}

TEST(Clipping, TellsTouchingFromOverlap) {
  const auto boxes = [](const Vec3<double>& at, std::array<double, 3> half_a, std::array<double, 3> half_b) {
    const std::array<Vec3<double>, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    return common_of(scaled<DyadicNumber>(BoxPair<double>{{{0, 0, 0}, half_a, axes}, {at, half_b, axes}}));
  };
  EXPECT_FALSE(boxes({3, 0, 0}, {1, 1, 1}, {1, 1, 1}).meets);
  EXPECT_TRUE(boxes({2, 0, 0}, {1, 1, 1}, {1, 1, 1}).meets);
  EXPECT_FALSE(boxes({2, 0, 0}, {1, 1, 1}, {1, 1, 1}).interiors_meet);
  EXPECT_FALSE(boxes({2, 2, 2}, {1, 1, 1}, {1, 1, 1}).interiors_meet) << "at a corner";
  EXPECT_TRUE(boxes({1, 1, 1}, {1, 1, 1}, {1, 1, 1}).interiors_meet);
  EXPECT_TRUE(boxes({0, 0, 0}, {9, 9, 9}, {1, 1, 1}).interiors_meet) << "one inside the other";
  EXPECT_TRUE(boxes({0, 0, 0}, {1, 1, 1}, {0, 0, 0}).interiors_meet) << "a point inside";
  EXPECT_FALSE(boxes({1, 0, 0}, {1, 1, 1}, {0, 0, 0}).interiors_meet) << "a point on a face";
  EXPECT_TRUE(boxes({0, 0, 0}, {1, 1, 0}, {0, 0, 1}).interiors_meet) << "a segment through a rectangle";
  EXPECT_FALSE(boxes({0, 0, 0}, {1, 1, 0}, {1, 1, 0}).interiors_meet) << "two rectangles in one plane";
}

}  // namespace
}  // namespace axiscert::boxes
