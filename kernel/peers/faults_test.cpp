// The known faults of each library, by kind: a change to one of these requires a change to docs/league.md. cgal-epick
// is right on every query here.
#include <cmath>
#include <csignal>

#include "kernel/peers/peers_testing.h"

namespace axiscert::peer {
namespace {

template <class Real>
struct KnownQuery {
  Query<Real> query;
  char truth;
};

// Checks that `peer` answers `letter`, which is wrong, and that CGAL's exact predicate answers the truth.
template <class Real>
void expect_wrong(const char* peer, const KnownQuery<Real>& asked, char letter) {
  EXPECT_NE(letter, asked.truth);
  EXPECT_EQ(ask<Real>(peer, {asked.query}).bytes, std::string(1, letter)) << peer;
  EXPECT_EQ(ask<Real>("cgal-epick", {asked.query}).bytes, std::string(1, asked.truth));
}

template <class Real>
Query<Real> sphere(Real x, Real y, Real z, Real r) {
  return {{0, 0, 0}, {4, 0, 0}, {0, 4, 0}, {x, y, z}, r};
}
template <class Real>
Query<Real> scaled(const Query<Real>& q, Real factor) {
  auto v = coordinates(q);
  for (Real& x : v) x *= factor;
  return from_coordinates(v);
}

template <class Real>
std::vector<KnownQuery<Real>> degenerate_contacts() {
  return {{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, Real{0.5}, 0}, 1}, 'c'},   // three vertices on a line
          {{{1, 0, 0}, {1, 0, 0}, {5, 0, 0}, {3, Real{0.5}, 0}, 1}, 'c'},   // two equal vertices
          {{{1, 0, 0}, {1, 0, 0}, {1, 0, 0}, {1, Real{0.5}, 0}, 1}, 'c'}};  // a point
}

TEST(BulletFaults, DegenerateTrianglesAreMissed) {
  for (const auto& asked : degenerate_contacts<float>()) expect_wrong("bullet", asked, 's');
  for (const auto& asked : degenerate_contacts<double>()) expect_wrong("bullet-double", asked, 's');
}

// The normal of a triangle of edge 4s has length 16 s^2, against 1.19e-7 or 2.2e-16.
TEST(BulletFaults, SmallScenesAreMissed) {
  expect_wrong<float>("bullet", {scaled(sphere(1.0f, 1.0f, 0.5f, 1.0f), 0x1p-14f), 'c'}, 's');
  expect_wrong<double>("bullet-double", {scaled(sphere(1.0, 1.0, 0.5, 1.0), 0x1p-29), 'c'}, 's');
}

TEST(BulletGjkFaults, SmallScenesAreContacts) {
  expect_wrong<float>("bullet-gjk", {scaled(sphere(1.0f, 1.0f, 3.0f, 1.0f), 0x1p-30f), 's'}, 'c');
}

TEST(OdeFaults, DegenerateTrianglesAreMissed) {
  for (const auto& asked : degenerate_contacts<double>()) expect_wrong("ode", asked, 's');
}

TEST(OdeFaults, ACentreOnTheTriangleHasNoDepth) { expect_wrong<double>("ode", {sphere(1.0, 1.0, 0.0, 0.5), 'c'}, 'i'); }

TEST(FclFaults, ADegenerateTriangleHitsAtAnyDistance) {
  const Query<double> far = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1e6, 0}, 1};
  expect_wrong<double>("fcl", {far, 's'}, 'c');
  expect_wrong<float>("fcl-float", {{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {0, 1e6f, 0}, 1}, 's'}, 'c');
}

TEST(FclFaults, ItsEpsilonIsALength) {
  expect_wrong<double>("fcl", {sphere(1.0, 1.0, 0x1p-60, 0.0), 's'}, 'c');
  expect_wrong<float>("fcl-float", {scaled(sphere(1.0f, 1.0f, 3.0f, 1.0f), 0x1p-30f), 's'}, 'c');
}

TEST(FclGjkFaults, AnEllipsoidOfRadiusZeroNeverHits) {
  expect_wrong<double>("fcl-gjk", {sphere(1.0, 1.0, 0.0, 0.0), 'c'}, 's');
}

// A query found by the family of random bit patterns.
TEST(FclGjkFaults, ItDoesNotComeBackFromSomeQueries) {
  const Query<double> scattered = {{-0x1.1c97dp+27, 0x1.730ed8p-62, 0x1.719ea6p-2},
                                   {0x1.eda724p+80, 0x1.2b5842p+105, -0x1.b9d094p+58},
                                   {-0x1.c7c416p-35, -0x1.6b809ap+39, 0x1.3ff196p-60},
                                   {0x1.de23cp-99, 0x1.37bf9ep+16, -0x1.0f6d08p+14},
                                   0x1.9a59d4p-124};
  EXPECT_EQ(ask<double>("fcl-gjk", {scattered}).signal, SIGXCPU);
  EXPECT_EQ(ask<double>("cgal-epick", {scattered}).bytes, "s");
}

TEST(LibccdFaults, GjkMissesShallowContacts) {
  expect_wrong<double>("libccd-gjk", {sphere(-3.0, -4.0, 0.0, 5 + 0x1p-30), 'c'}, 's');
}

TEST(LibccdFaults, GjkHasPhantomContactsInSmallScenes) {
  expect_wrong<double>("libccd-gjk", {scaled(sphere(1.0, 1.0, 1.5, 1.0), 0x1p-20), 's'}, 'c');
}

// The contact is 2^-16 deep, against an mpr_tolerance of 1e-4.
TEST(LibccdFaults, MprMissesShallowContacts) {
  expect_wrong<double>("libccd-mpr", {sphere(-3.0, -4.0, 0.0, 5 + 0x1p-16), 'c'}, 's');
}

TEST(LibccdFaults, MprDoesNotComeBackFromSomeQueries) {
  const Query<double> on_the_triangle = {{-12, -20, 32}, {32, 28, -20}, {12, 4, -8}, {11, 4, -1}, 0};
  EXPECT_EQ(ask<double>("libccd-mpr", {on_the_triangle}).signal, SIGXCPU);
  EXPECT_EQ(ask<double>("cgal-epick", {on_the_triangle}).bytes, "c");
}

// Numbers beside verdicts that are right. A triangle with a right angle at the origin and legs of length 4.

// The loop over the edges keeps the last one within the radius: here CA, whose nearest point is A.
TEST(FclFaults, AContactIsThatOfTheLastEdgeWithinTheRadius) {
  const std::vector<double> found = ask_numbers("fcl", sphere(2.0, -1.0, 0.0, 4.0));
  EXPECT_NEAR(found[0], std::sqrt(5.0) - 4, 1e-12) << "it is 3 deep, at (2, 0, 0)";
  EXPECT_NEAR(found[2], 2 / std::sqrt(5.0), 1e-12) << "the way out is (0, -1, 0)";
  EXPECT_EQ((std::vector<double>{found[5], found[6], found[7]}), (std::vector<double>{0, 0, 0}));
}

// Its normal is the plane's, at an edge too, and the depth is measured along it.
TEST(OdeFaults, ASphereBesideAnEdgeIsPushedAlongTheNormalOfThePlane) {
  const std::vector<double> beside = ask_numbers("ode", sphere(2.0, -1.0, 0.0, 4.0));
  EXPECT_EQ(beside[0], 0) << "it is 3 deep";
  EXPECT_EQ((std::vector<double>{beside[2], beside[3], beside[4]}), (std::vector<double>{0, 0, 1}));
  const std::vector<double> corner = ask_numbers("ode", sphere(5.0, -1.0, 0.5, 2.0));
  EXPECT_NEAR(corner[0], -1.0 / 6, 1e-6) << "it is 0.5 deep";
  EXPECT_EQ((std::vector<double>{corner[2], corner[3], corner[4]}), (std::vector<double>{0, 0, 1}));
}

// The expanding polytope ends before it has a direction.
TEST(LibccdFaults, GjkSaysNextToNoDepthOfADeepContact) {
  const std::vector<double> found = ask_numbers("libccd-gjk", sphere(-1.0, 3.0, 0.0, 4.0));
  EXPECT_NEAR(found[0], 0, 1e-12) << "it is 3 deep";
}

// MPR looks where the line of centres leaves.
TEST(LibccdFaults, MprDoesNotSayTheLeastDepth) {
  const std::vector<double> found = ask_numbers("libccd-mpr", sphere(1.0, 1.0, 0.125, 20.0));
  EXPECT_LT(found[0], -21) << "it is 19.875 deep";
  EXPECT_LT(found[4], 0.3) << "the way out is (0, 0, 1)";
}

// Overflow: of the numerator alone, and at a larger size of numerator and denominator.
TEST(CgalFloatFaults, LargeScenesAreMissedAndLargerOnesNaN) {
  const Query<float> deep = sphere(1.0f, 1.0f, 0.5f, 1.0f);
  expect_wrong<float>("cgal-float", {scaled(deep, 1e9f), 'c'}, 's');
  expect_wrong<float>("cgal-float", {scaled(deep, 0x1p30f), 'c'}, 'i');
}

// Underflow: r r and the distance become 0, and at a smaller size the distance is 0/0.
TEST(CgalFloatFaults, SmallScenesAreContactsAndSmallerOnesNaN) {
  const Query<float> apart = sphere(1.0f, 1.0f, 3.0f, 1.0f);
  expect_wrong<float>("cgal-float", {scaled(apart, 0x1p-30f), 's'}, 'c');
  expect_wrong<float>("cgal-float", {scaled(apart, 0x1p-40f), 's'}, 'i');
}

}  // namespace
}  // namespace axiscert::peer
