// What the kernels of boxes say beside a contact, against the exact numbers.
#include "exact/boxes/contact.h"

#include "exact/boxes/boxes_testing.h"
#include "exact/numbers/roots.h"
#include "kernel/boxes/contact.h"

namespace axiscert::boxes {
namespace {

Point point_at(const double* v) { return {exact(v[0]), exact(v[1]), exact(v[2])}; }

// The worst of what a kernel says, as shares of the scene but for `left`.
struct Worst {
  int contacts = 0, deep = 0, unique = 0;
  double separation = 0, left = 0, off_body = 0, mismatch = 0, point = 0;

  void see(const ExactContact& right, const std::array<double, contact_measures>& said) {
    ++contacts;
    const double scene = nearest_sqrt<double>(right.squared_scene());
    const auto share = [&](const Rational& square) { return nearest_sqrt<double>(square) / scene; };
    const auto off = [&](const Point& p, const Point& q) {
      const Point between = p - q;
      return share(Rational(dot(between, between)));
    };
    separation = std::max(separation, std::abs(said[0] + nearest_sqrt<double>(right.squared_separation())) / scene);
    const Point normal = point_at(&said[1]), a = point_at(&said[4]), b = point_at(&said[7]);
    off_body = std::max({off_body, share(right.squared_distance_from_a(a)), share(right.squared_distance_from_b(b))});
    mismatch = std::max(mismatch, nearest<double>(right.mismatch(a, b)) / scene);
    if (right.squared_separation() == 0) return;
    ++deep;
    left = std::max(left, right.left(normal).value());
    if (!right.only_points()) return;
    ++unique;
    point = std::max({point, off(a, right.only_points()->a), off(b, right.only_points()->b)});
  }
};
std::ostream& operator<<(std::ostream& out, const Worst& w) {
  return out << w.contacts << " contacts, " << w.deep << " deep, " << w.unique << " of one pair; separation "
             << w.separation << ", left " << w.left << ", off its body " << w.off_body << ", mismatch " << w.mismatch
             << ", point " << w.point;
}

TurnedBox<double> small_turned(Random& random, double centre) {
  TurnedBox<double> box;
  box.centre = {real(random, -centre, centre), real(random, -centre, centre), real(random, -centre, centre)};
  for (double& s : box.half) s = below(random, 6) == 0 ? 0 : real(random, 0.25, 2);
  do {
    for (double& x : box.q) x = whole(random, 3);
  } while (box.q == std::array<double, 4>{});
  return box;
}

template <class Method, class Problem, class Exact>
void see_contact(const Problem& q, const Exact& right, Worst& worst) {
  std::array<double, contact_measures> said;
  Method::measure(q, said.data());
  if (right.is_apart() || std::isnan(said[0])) return;
  worst.see(right, said);
}

TEST(ContactKernels, OfTwoBoxesAreRightButForRounding) {
  Random random(20261127);
  Worst ours, engine;
  for (int i = 0; i < 400; ++i) {
    const TurnedPair<double> q{small_turned(random, 1.5), small_turned(random, 1.5)};
    const ExactContact right(exact_pair(q));
    see_contact<WithContact<ByMatrices<Cofactor>>>(q, right, ours);
    see_contact<WithContact<ByMatrices<Cofactor>, 105>>(q, right, engine);
  }
  SCOPED_TRACE(testing::Message() << "ours: " << ours << "\nedges weighted by 1.05: " << engine);
  EXPECT_GT(ours.deep, 100);
  EXPECT_GT(ours.unique, 50);
  EXPECT_LT(ours.separation, 0x1p-50);
  EXPECT_LT(ours.left, 1e-14) << "a tie of two axes may be decided otherwise, by a rounding";
  EXPECT_LT(ours.off_body, 0x1p-46);
  EXPECT_LT(ours.mismatch, 0x1p-46);
  EXPECT_LT(ours.point, 0x1p-40);
  // The weight costs up to a twentieth of the depth, and no more.
  EXPECT_GT(engine.left, 0.01);
  EXPECT_LT(engine.left, 0.0501);
}

TEST(ContactKernels, OfABoxAndATriangleAreRightButForRounding) {
  Random random(20261127);
  Worst found;
  const auto corner = [&] { return Vec3<double>{real(random, -2, 2), real(random, -2, 2), real(random, -2, 2)}; };
  for (int i = 0; i < 400; ++i) {
    TurnedAndTriangle<double> q{small_turned(random, 1), {{corner(), corner(), corner()}}};
    if (i % 16 == 0) q.corner[2] = q.corner[1];
    const ExactContact right(exact_box_and_triangle(q));
    see_contact<WithTriangleContact<TurnedThirteen>>(q, right, found);
  }
  SCOPED_TRACE(testing::Message() << found);
  EXPECT_GT(found.deep, 100);
  EXPECT_GT(found.unique, 50);
  EXPECT_LT(found.separation, 0x1p-48);
  EXPECT_LT(found.left, 1e-13);
  EXPECT_LT(found.off_body, 0x1p-44);
  EXPECT_LT(found.mismatch, 0x1p-44);
  EXPECT_LT(found.point, 0x1p-40);
}

// Faces that touch in a part of each: the points are clipped to it.
TEST(ContactKernels, PointsOfFacesAreOnBothBodies) {
  const BoxPair<double> q{{{0, 0, 0}, {{1, 1, 1}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                          {{1.5, 1.25, 1.875}, {{1, 1, 1}}, {{{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}}}}};
  std::array<double, contact_measures> said;
  WithContact<Cofactor>::measure(q, said.data());
  const ExactContact right(exact_pair(q));
  EXPECT_EQ(said[0], -0.125);
  EXPECT_EQ(right.squared_distance_from_a(point_at(&said[4])), 0);
  EXPECT_EQ(right.squared_distance_from_b(point_at(&said[7])), 0);
  EXPECT_EQ(right.mismatch(point_at(&said[4]), point_at(&said[7])), 0);
}

TEST(ContactKernels, SayNothingOfBoxesApart) {
  const BoxPair<double> q{{{0, 0, 0}, {{1, 1, 1}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}},
                          {{3, 0, 0}, {{1, 1, 1}}, {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}}}};
  std::array<double, contact_measures> said;
  WithContact<Cofactor>::measure(q, said.data());
  for (const double x : said) EXPECT_TRUE(std::isnan(x));
}

}  // namespace
}  // namespace axiscert::boxes
