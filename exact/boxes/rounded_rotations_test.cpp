// Rotations rounded to binary32: the textbook, evaluated exactly on the rounded numbers, misses boxes that rest on each
// other, since one of its rewritings holds for orthonormal columns alone; with cofactors it misses none.
#include <cmath>

#include "exact/boxes/boxes_testing.h"
#include "kernel/boxes/textbook.h"
#include "kernel/boxes/projected.h"
#include "kernel/boxes/turned.h"

namespace axiscert::boxes {
namespace {

using Quaternion = std::array<double, 4>;

Quaternion product(const Quaternion& p, const Quaternion& q) {
  return {p[0] * q[0] - p[1] * q[1] - p[2] * q[2] - p[3] * q[3], p[0] * q[1] + p[1] * q[0] + p[2] * q[3] - p[3] * q[2],
          p[0] * q[2] - p[1] * q[3] + p[2] * q[0] + p[3] * q[1], p[0] * q[3] + p[1] * q[2] - p[2] * q[1] + p[3] * q[0]};
}

Quaternion small_quaternion(Random& random) {
  Quaternion q;
  do {
    for (double& x : q) x = whole(random, 3000);
  } while (std::all_of(q.begin(), q.end(), [](double x) { return x == 0; }));
  return q;
}

std::array<Point, 3> exact_axes(const Quaternion& q) {
  return exact_pair(TurnedPair<double>{{{0, 0, 0}, {1, 1, 1}, q}, {{0, 0, 0}, {1, 1, 1}, q}}).a.axis;
}

// Each entry rounded once from the exact rotation; the other route computes in binary32.
std::array<Vec3<float>, 3> rounded_axes(const Quaternion& q) {
  std::array<Vec3<float>, 3> axes;
  const std::array<Point, 3> exact = exact_axes(q);
  for (std::size_t k = 0; k < 3; ++k) {
    axes[k] = {nearest<float>(exact[k].x), nearest<float>(exact[k].y), nearest<float>(exact[k].z)};
  }
  return axes;
}
std::array<Vec3<float>, 3> computed_axes(const Quaternion& q) {
  TurnedBox<float> box{{0, 0, 0}, {{1, 1, 1}}, {}};
  for (std::size_t k = 0; k < 4; ++k) box.q[k] = static_cast<float>(q[k]);
  return with_matrix(box).axis;
}

// The point of A's frame, turned exactly and rounded once.
Vec3<float> placed(const Quaternion& frame, const std::array<double, 3>& at) {
  const std::array<Point, 3> axes = exact_axes(frame);
  Point sum{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) sum = sum + axes[k] * Rational(at[k]);
  return {nearest<float>(sum.x), nearest<float>(sum.y), nearest<float>(sum.z)};
}

std::array<float, 3> extents(Random& random) {
  std::array<float, 3> half;
  for (float& s : half) s = static_cast<float>(real(random, 0.5, 1.5));
  return half;
}

ExactPair exactly(const BoxPair<float>& q) {
  const Numbers<float> numbers = numbers_of(q);
  return exact_pair(MatrixBoxes::problem<double>([&](std::size_t k) { return static_cast<double>(numbers[k]); }));
}

using MakeRounded = BoxPair<float> (*)(Random& random);

BoxPair<float> general(Random& random) {
  const Quaternion p = small_quaternion(random), q = small_quaternion(random);
  const std::array<float, 3> a = extents(random), b = extents(random);
  const double x = real(random, -2, 2), y = real(random, -2, 2), z = real(random, -2, 2);
  return {{{0, 0, 0}, a, rounded_axes(p)}, {placed({1, 0, 0, 0}, {x, y, z}), b, rounded_axes(q)}};
}

// B stands on A, sunk by `sunk`, yawed by about 2^-7 to 2^-23.
BoxPair<float> resting(Random& random, double sunk) {
  const Quaternion p = small_quaternion(random);
  const double yaw = std::ldexp(1.0, 8 + below(random, 17));
  const std::array<float, 3> a = extents(random), b = extents(random);
  const double x = real(random, -0.5, 0.5), y = real(random, -0.5, 0.5);
  return {{{0, 0, 0}, a, rounded_axes(p)},
          {placed(p, {x, y, static_cast<double>(a[2]) + static_cast<double>(b[2]) - sunk}), b,
           rounded_axes(product(p, {yaw, 0, 0, 1}))}};
}

BoxPair<float> resting(Random& random) {
  const double sunk = std::ldexp(1.0, -6 - below(random, 9));
  return resting(random, sunk);
}

// B is turned by some quarter turns against A, which no rotation shows, along another route of rounding.
BoxPair<float> parallel(Random& random) {
  static constexpr std::array<Quaternion, 4> quarters = {{{1, 0, 0, 0}, {1, 1, 0, 0}, {1, 0, 1, 0}, {1, 0, 0, 1}}};
  const Quaternion p = small_quaternion(random);
  const std::size_t one = random() % 4, other = random() % 4;
  const std::array<float, 3> a = extents(random), b = extents(random);
  const double x = real(random, -1, 1), y = real(random, -1, 1), z = real(random, -1, 1);
  return {{{0, 0, 0}, a, rounded_axes(p)},
          {placed(p, {x, y, z}), b, computed_axes(product(product(p, quarters[one]), quarters[other]))}};
}

// A coordinate of B's centre, moved by up to `most` ulps.
void nudge(Random& random, int most, BoxPair<float>& q) {
  const int coordinate = below(random, 3);
  const double ulps = whole(random, most);
  float& x = coordinate == 0 ? q.b.centre.x : coordinate == 1 ? q.b.centre.y : q.b.centre.z;
  for (int i = 0; i < std::abs(ulps); ++i) x = std::nextafter(x, ulps > 0 ? INFINITY : -INFINITY);
}

// As resting, but touching by less than the roundings.
BoxPair<float> stacked(Random& random) {
  BoxPair<float> q = resting(random, 0);
  nudge(random, 8, q);
  return q;
}

// B touches A in direction u from A's centre, but for the rounding and some ulps.
BoxPair<float> tangent(Random& random) {
  BoxPair<float> q = general(random);
  const Vec3<double> u = {static_cast<double>(q.b.centre.x), static_cast<double>(q.b.centre.y),
                          static_cast<double>(q.b.centre.z)};
  const Rational factor = critical_factor(exactly(q), {u.x, u.y, u.z});
  q.b.centre = {nearest<float>(factor * Rational(u.x)), nearest<float>(factor * Rational(u.y)),
                nearest<float>(factor * Rational(u.z))};
  nudge(random, 4, q);
  return q;
}

// Parallel, and A without one extent.
BoxPair<float> flat(Random& random) {
  BoxPair<float> q = parallel(random);
  q.a.half[static_cast<std::size_t>(below(random, 3))] = 0;
  return q;
}

struct RoundedRates {
  Wrong textbook, cofactor, gottschalk;  // over the reals
  Wrong textbook_32, projected_32;       // in binary32
};
RoundedRates rounded_rates(MakeRounded make, int queries) {
  constexpr std::uint64_t seed = 20261124;
  Random random(seed);
  RoundedRates found;
  for (int i = 0; i < queries; ++i) {
    const BoxPair<float> q = make(random);
    const Numbers<float> numbers = numbers_of(q);
    const auto problem = exact_problem<MatrixBoxes>(numbers);
    const ExactPair exact = exactly(q);
    const bool apart = are_apart(exact);
    const auto count = [&](Wrong& wrong, bool said_apart) {
      wrong.count(said_apart, apart);
      if (said_apart && !apart) wrong.deepest_miss = std::max(wrong.deepest_miss, rounded_depth(exact_depth(exact)));
    };
    count(found.textbook, separates<Textbook, ExactNumber>(problem));
    count(found.cofactor, separates<Cofactor, ExactNumber>(problem));
    count(found.gottschalk, separates<Gottschalk, ExactNumber>(problem));
    count(found.textbook_32, separates<Textbook, float>(q));
    count(found.projected_32, separates<ProjectedFifteen, float>(q));
  }
  return found;
}

TEST(RoundedRotations, TheExactTextbookMissesBoxesThatRestOnEachOtherAndCofactorsDoNot) {
  const RoundedRates found = rounded_rates(resting, 150);
  EXPECT_GT(found.textbook.missed, 10) << found.textbook;
  EXPECT_GT(found.textbook_32.missed, 10) << found.textbook_32;
  EXPECT_EQ(found.cofactor.all(), 0) << found.cofactor;
  EXPECT_EQ(found.gottschalk.all(), 0) << found.gottschalk;
  EXPECT_EQ(rounded_rates(general, 100).textbook.all(), 0);
}

TEST(RoundedRotationsLong, RestingIsTheTableOfDocsBoxes) {
  const RoundedRates found = rounded_rates(resting, 2500 / TRIAL_DIVISOR);
  expect_about(found.textbook.missed, found.textbook.asked, 182400, 1e6);
  expect_about(found.textbook_32.missed, found.textbook_32.asked, 215200, 1e6);
  if (TRIAL_DIVISOR == 1) {
    EXPECT_GT(found.textbook.deepest_miss, 0.005);
  }
  EXPECT_LT(found.textbook.deepest_miss, 0.02);
  EXPECT_EQ(found.cofactor.all() + found.gottschalk.all() + found.projected_32.missed, 0);
}

TEST(RoundedRotationsLong, ParallelBoxesAreMissedAndByCofactorsNone) {
  const RoundedRates found = rounded_rates(parallel, 2500 / TRIAL_DIVISOR);
  if (TRIAL_DIVISOR == 1) {
    EXPECT_GT(found.textbook.missed, 0) << found.textbook;
    EXPECT_GT(found.textbook_32.missed, 0) << found.textbook_32;
  }
  EXPECT_EQ(found.cofactor.missed + found.gottschalk.missed + found.projected_32.missed, 0);
}

TEST(RoundedRotationsLong, TouchingBoxesAreMissedByRoundingsAlone) {
  for (const MakeRounded make : {MakeRounded(stacked), MakeRounded(tangent)}) {
    SCOPED_TRACE(make == MakeRounded(stacked) ? "stacked" : "tangent");
    const RoundedRates found = rounded_rates(make, 2500 / TRIAL_DIVISOR);
    EXPECT_GT(found.textbook.missed, found.cofactor.missed);
    expect_about(found.gottschalk.phantom, found.gottschalk.asked, 495000, 1e6);
    EXPECT_EQ(found.gottschalk.missed, 0);
    EXPECT_LT(found.textbook.deepest_miss, 2e-6);
    EXPECT_LT(found.cofactor.deepest_miss, 2e-6);
  }
}

TEST(RoundedRotationsLong, FlatParallelBoxesAreMissedAndByCofactorsNone) {
  const RoundedRates found = rounded_rates(flat, 2500 / TRIAL_DIVISOR);
  if (TRIAL_DIVISOR == 1) {
    EXPECT_GT(found.textbook.missed, 0) << found.textbook;
  }
  EXPECT_EQ(found.cofactor.missed + found.gottschalk.missed, 0);
}

TEST(RoundedRotationsLong, NothingIsWrongOfBoxesInGeneral) {
  const RoundedRates found = rounded_rates(general, 2500 / TRIAL_DIVISOR);
  EXPECT_EQ(found.textbook.all() + found.cofactor.all() + found.gottschalk.all(), 0);
  EXPECT_EQ(found.textbook_32.all(), 0);
}

}  // namespace
}  // namespace axiscert::boxes
