// The numbers of the proof in exact/boxes/cofactor_bound.h: the whole constants cover the sums, and the
// two lemmas of exact geometry that it uses hold on small integers.
#include "exact/boxes/cofactor_bound.h"

#include <cmath>

#include "exact/boxes/boxes_testing.h"

namespace axiscert::boxes {
namespace {

TEST(CofactorBound, TheWholeConstantsCoverTheSumsOfTheProof) {
  for (const double u : {0x1p-24, 0x1p-53}) {
    for (double d = 0x1p-60; d <= 0x1p-10; d *= 1.0625) {
      const CofactorBound whole = cofactor_bound(u, d), full = cofactor_bound_in_full(u, d);
      EXPECT_LE(full.missed, whole.missed) << u << ' ' << d;
      EXPECT_LE(full.phantom, whole.phantom) << u << ' ' << d;
    }
    EXPECT_GT(cofactor_bound_in_full(u, 0).missed, 27 * u) << "no smaller whole constant does";
    EXPECT_GT(cofactor_bound_in_full(u, 0).phantom, 97 * u);
  }
}

// Rounded once from a rotation, two columns differ from orthonormal by 2 u + u^2 at most.
TEST(CofactorBound, ARoundedRotationHasADefectOfTwoRoundings) {
  Random random(5);
  for (int i = 0; i < 300; ++i) {
    std::array<double, 4> q;
    for (double& x : q) x = whole(random, 3000);
    if (q[0] == 0) q[0] = 1;
    const ExactBox exact = exact_pair(TurnedPair<double>{{{0, 0, 0}, {1, 1, 1}, q}, {{0, 0, 0}, {1, 1, 1}, q}}).a;
    ExactBox rounded = exact;
    for (Point& v : rounded.axis) {
      v = {static_cast<double>(nearest<float>(v.x)), static_cast<double>(nearest<float>(v.y)),
           static_cast<double>(nearest<float>(v.z))};
    }
    EXPECT_EQ(orthonormality_defect(exact), 0);
    EXPECT_LE(orthonormality_defect(rounded), Rational(0x1p-23 + 0x1p-48)) << i;
  }
}

// The lemma: where A is upright, the distance is at most sqrt(3) times the greatest gap on one of the axes.
TEST(CofactorBound, TheDistanceIsAtMostRootThreeTimesTheGreatestGap) {
  Random random(11);
  double greatest = 0;
  for (int i = 0; i < 400; ++i) {
    BoxPair<double> q = independent_pair(random, 2, 6);
    q.a.axis = {{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    if (i % 4 == 0) q.b.axis = q.a.axis;
    if (i == 0) q.b.centre = q.a.centre + Vec3<double>{9, 9, 9};
    if (i == 0) q.a.half = q.b.half = {1, 1, 1};
    const ExactPair exact = exact_pair(q);
    const Rational squared = squared_distance(exact);
    if (squared == 0) continue;
    const double ratio = std::sqrt(Rational(squared / squared_gap(exact)).get_d());
    EXPECT_LE(ratio, std::sqrt(3.0) * (1 + 1e-15)) << i;
    greatest = std::max(greatest, ratio);
  }
  EXPECT_GT(greatest, std::sqrt(3.0) * (1 - 1e-15)) << "two corners attain it";
}

}  // namespace
}  // namespace axiscert::boxes
