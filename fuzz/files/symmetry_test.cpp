// The canonical form: the same for all images of a query, and different for other queries.
#include "fuzz/sphere_triangle/families/parts/images.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <set>

#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "fuzz/files/corpus.h"
#include "fuzz/queries/random.h"
#include "kernel/queries_testing.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr std::uint64_t symmetry_seed = 20260611;

template <class Real>
StoredQuery stored(const Query<Real>& q) {
  return {"q", precision_of<Real>, q, &sphere_triangle_predicate()};
}

// Small integers, sometimes equal or zero: translations by integers and powers of two are exact.
template <class Real>
Query<Real> small_query(Stream& random) {
  std::array<Real, coordinate_count> v;
  for (Real& x : v) x = static_cast<Real>(random.integer(-40, 40));
  v[12] = std::fabs(v[12]);
  return from_coordinates(v);
}

template <class Real>
Query<Real> translated_and_scaled(const Query<Real>& q, Stream& random) {
  std::array<Real, 3> by;
  for (Real& x : by) x = static_cast<Real>(random.integer(-1000, 1000));
  const int power = static_cast<int>(random.integer(-60, 60));
  auto v = coordinates(q);
  for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = std::ldexp(k < 12 ? v[k] + by[k % 3] : v[k], power);
  return from_coordinates(v);
}

template <class Real>
void expect_one_form() {
  SCOPED_TRACE(testing::Message() << "seed " << symmetry_seed);
  for (std::uint64_t n = 0; n < 4; ++n) {
    Stream random(symmetry_seed, name_hash("symmetry"), 1, precision_of<Real>, n);
    const Query<Real> q = small_query<Real>(random);
    const std::string form = canonical_form(stored(q));
    const auto truth = second_opinion(q);
    for (const Symmetry& symmetry : symmetries()) {
      const Query<Real> other = translated_and_scaled(image(q, symmetry), random);
      ASSERT_EQ(canonical_form(stored(other)), form);
      // compares MPFR's answers for a few images, of each vertex order
      if ((&symmetry - symmetries().data()) % 19 == 0) {
        ASSERT_EQ(second_opinion(other).distance_order, truth.distance_order);
      }
    }
    // Queries that are not images: another radius, another coordinate.
    for (std::size_t k = 0; k < coordinate_count; ++k) {
      auto v = coordinates(q);
      v[k] += Real(128);
      EXPECT_NE(canonical_form(stored(from_coordinates(v))), form) << coordinate_names[k];
    }
  }
}

TEST(CanonicalForm, IsOneForAllImages) {
  expect_one_form<float>();
  expect_one_form<double>();
}

TEST(CanonicalForm, ThereAre288Images) {
  const Query<float> q = {{1, 2, 4}, {8, 16, 32}, {64, 128, 256}, {0, 0, 0}, 3};
  std::set<std::array<float, coordinate_count>> images;
  for (const Symmetry& symmetry : symmetries()) images.insert(coordinates(image(q, symmetry)));
  EXPECT_EQ(images.size(), symmetry_count);
  expect_same_bits(image(q, symmetries().front()), q);
}

TEST(CanonicalForm, PrecisionsAreApart) {
  const Query<float> q = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, 0}, 1};
  EXPECT_NE(canonical_form(stored(q)), canonical_form(stored(widened(q))));
}

TEST(CanonicalForm, ATranslationThatRoundsIsNone) {
  const float p = 0x1p-40f;
  const Query<float> at_p = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {p, p, p}, 1};
  Query<float> at_origin = at_p;
  at_origin.p = {0, 0, 0};
  EXPECT_NE(canonical_form(stored(at_p)), canonical_form(stored(at_origin)));
}

TEST(CanonicalForm, NumbersThatAreNotFinite) {
  constexpr float inf = std::numeric_limits<float>::infinity(), nan = std::numeric_limits<float>::quiet_NaN();
  const Query<float> q = {{inf, 2, -0.0f}, {nan, 1, 5}, {3, 4, 0}, {0, 7, 0}, 1};
  const std::string form = canonical_form(stored(q));
  for (const Symmetry& symmetry : symmetries()) ASSERT_EQ(canonical_form(stored(image(q, symmetry))), form);
  Query<float> other = q;
  other.b.x = inf;
  EXPECT_NE(canonical_form(stored(other)), form);
}

TEST(CanonicalForm, TheExtremesOfBinary64) {
  constexpr double most = std::numeric_limits<double>::max(), least = 0x1p-1074;
  const Query<double> q = {{most, -most, least}, {-most, 0, 0}, {least, -least, 0}, {-most, most, 0}, most};
  const std::string form = canonical_form(stored(q));
  for (const Symmetry& symmetry : symmetries()) ASSERT_EQ(canonical_form(stored(image(q, symmetry))), form);
  const Query<double> zero = {};
  EXPECT_EQ(canonical_form(stored(zero)), canonical_form(stored(image(zero, symmetries().back()))));
}

}  // namespace
}  // namespace axiscert
