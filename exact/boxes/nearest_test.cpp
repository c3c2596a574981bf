// Nearest points of hulls, and that their certificate is refused where anything in it is wrong.
#include "exact/boxes/nearest.h"

#include "exact/boxes/boxes_testing.h"

namespace axiscert::boxes {
namespace {

const Hull square = {{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}};

Rational distance2(const Hull& a, const Hull& b) { return nearest_points(a, b).squared(); }

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
    const NearestPoints found = nearest_points(square, other);
    EXPECT_EQ(found.squared(), 0);
    EXPECT_EQ(refuted(found, square, other), "");
  }
}

TEST(NearestPoints, ACertificateWithAnythingWrongIsRefused) {
  const Hull other = {{3, 3, 1}, {4, 3, 1}};
  const NearestPoints right = nearest_points(square, other);
  EXPECT_EQ(refuted(right, square, other), "");
  const auto refusal = [&](auto change) {
    NearestPoints wrong = right;
    change(wrong);
    return refuted(wrong, square, other);
  };
  EXPECT_EQ(refusal([](NearestPoints& n) { n.weights_a.pop_back(); }), "there is not one weight a vertex");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.weights_b = {2, -1}; }), "a weight is negative");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.weights_b = {1, 1}; }), "the weights of a hull do not sum to 1");
  EXPECT_EQ(refusal([](NearestPoints& n) { n.apart.z += 1; }), "the points are not `apart`");
  // From vertex to vertex, and not the nearest two: first of A, then of B.
  const auto from_to = [&](std::size_t i, std::size_t j) {
    NearestPoints n{std::vector<Rational>(4), std::vector<Rational>(2), square[i] - other[j]};
    n.weights_a[i] = 1;
    n.weights_b[j] = 1;
    return refuted(n, square, other);
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
    const ExactPair q = exact_pair(independent_pair(random, 1 + i % 3, 4 + i % 3));
    const Common common = common_of(q);
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
    const ExactPair q = exact_pair(independent_pair(random, 1 + i % 4, 4 + i % 5));
    ASSERT_EQ(common_of(q).meets, !are_apart(q)) << i;
  }
}

TEST(Clipping, TellsTouchingFromOverlap) {
  const auto boxes = [](const Vec3<double>& at, std::array<double, 3> half_a, std::array<double, 3> half_b) {
    const std::array<Vec3<double>, 3> axes = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    return common_of(exact_pair(BoxPair<double>{{{0, 0, 0}, half_a, axes}, {at, half_b, axes}}));
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
