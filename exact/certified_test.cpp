// The certified predicate against CGAL's distance: on every instruction set, in every floating-point mode, through
// every shape of the interface; and how far the conservative one may be off.
#include "kernel/certified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>
#include <utility>

#include "exact/depth.h"
#include "exact/geometric_oracle.h"
#include "kernel/certified.hpp"
#include "kernel/environment.h"
#include "kernel/kernel.h"
#include "kernel/testing/random.h"

namespace axiscert {
namespace {

using testing_support::coarse_query_of_any_size, testing_support::random_query;

constexpr std::uint64_t seed = 20101230;

// A sphere whose radius is within one ulp of the distance.
template <class Real>
Query<Real> tangent_query(std::mt19937_64& random) {
  Query<Real> q = random_query<Real>(random, false);
  const Real d = static_cast<Real>(std::sqrt(squared_distance(q).get_d()));
  q.r = random() % 3 == 0 ? d : std::nextafter(d, random() % 2 ? Real(0) : Real(4));
  return q;
}

// Integers whose margins are zero, or far smaller than what they are the difference of and yet not small: a centre on
// the plane or on an edge, with a sphere of any size or of none; or a sphere that touches an edge, or misses by less
// than a 2^100th of its radius. Of some, what is zero is a few of the least number there is instead.
template <class Real>
Query<Real> integer_query(std::mt19937_64& random) {
  const int bits = static_cast<int>(4 + random() % (random() % 2 ? std::numeric_limits<Real>::digits - 6 : 4));
  const auto below = [&](int n) { return static_cast<std::int64_t>(random() >> (64 - n)); };
  const auto point = [&](std::int64_t unit) {
    const auto one = [&] { return (below(bits) - (std::int64_t{1} << (bits - 1))) * unit; };
    return Vec3<std::int64_t>{one(), one(), one()};
  };
  Vec3<std::int64_t> a = point(4), b = point(4), c = point(4), p = (a + a + b + c) / std::int64_t{4};
  std::int64_t r = random() % 2 ? 0 : below(3);
  if (random() % 3 == 0) p = (a + b) / std::int64_t{2};
  if (random() % 2 == 0) {
    r = random() % 4 ? (std::int64_t{1} << bits) + below(bits) : 0;
    const unsigned longest = static_cast<unsigned>(57 - bits / 2);
    const std::int64_t along = std::int64_t{1} << (random() % 2 ? longest : random() % longest);
    a = {-along * below(bits / 2 + 1), 0, r}, b = {along * below(bits / 2 + 1), 0, r}, c = {0, 0, r + below(bits)};
    p = {0, static_cast<std::int64_t>(random() % 3) - 1, 0};
  }
  std::array<std::size_t, 3> axes = {0, 1, 2};
  std::shuffle(axes.begin(), axes.end(), random);
  const int exponent = static_cast<int>(random() % 21) + (sizeof(Real) == 8 && random() % 4 == 0 ? 60 : -10);
  // A centre on the plane or on an edge stays there where the axes are scaled.
  std::array<int, 3> scale = {exponent, exponent, exponent};
  if (random() % 4 == 0) scale[random() % 3] -= static_cast<int>(random() % 60);
  const auto real = [&](const Vec3<std::int64_t>& v) {
    const std::array<std::int64_t, 3> own = {v.x, v.y, v.z};
    const auto one = [&](std::size_t k) { return std::ldexp(static_cast<Real>(own[axes[k]]), scale[k]); };
    return Vec3<Real>{one(0), one(1), one(2)};
  };
  std::array<Vec3<Real>, 3> v = {real(a), real(b), real(c)};
  std::rotate(v.begin(), v.begin() + random() % 3, v.end());
  Query<Real> q = {v[0], v[1], v[2], real(p), std::ldexp(static_cast<Real>(r), exponent)};
  // Of no common unit that the others are few of.
  if (random() % 4 == 0) q.p = q.p * std::ldexp(Real(1), -static_cast<int>(random() % 90));
  if (random() % 4 == 0) q.r = std::nextafter(q.r, std::numeric_limits<Real>::infinity());
  if (random() % 4 != 0) return q;
  // Of the least numbers there are.
  auto all = coordinates(q);
  for (std::size_t k = 0; k < 12; ++k) {
    if (all[k] == 0 && random() % 2 == 0)
      all[k] = std::numeric_limits<Real>::denorm_min() * Real(random() % 2 ? 1 : -3);
  }
  return from_coordinates(all);
}

// The inverse of x modulo m, or 0 where there is none.
std::int64_t inverse(std::int64_t x, std::int64_t m) {
  std::int64_t a = x % m, b = m, u = 1, v = 0;
  while (b != 0) {
    const std::int64_t q = a / b;
    a = std::exchange(b, a - q * b);
    u = std::exchange(v, u - q * v);
  }
  return a == 1 ? (u % m + m) % m : 0;
}

// A centre as near to the plane of its triangle as a point of integers may be that is not on it, and a radius that this
// is, but for what it is rounded by, or near: far below the units that the other numbers are few of.
template <class Real>
Query<Real> plane_query(std::mt19937_64& random) {
  const int bits = sizeof(Real) == 4 ? 20 : 28;
  const auto number = [&] { return static_cast<std::int64_t>(random() >> (64 - bits)) | 1; };
  for (;;) {
    // AB = (p, 0, s), AC = (0, q, t), V = (-s q, -t p, p q); x V = 1, above the triangle.
    const std::int64_t p = number(), q = number(), s = number(), t = number();
    const std::int64_t x = inverse(p - s % p * (q % p) % p, p), y = inverse(q - t % q * (p % q) % q, q);
    const double area =
        static_cast<double>(x) / static_cast<double>(p) + static_cast<double>(y) / static_cast<double>(q);
    if (x == 0 || y == 0 || area >= 1) continue;
    __extension__ using Int128 = __int128;
    const Int128 V[3] = {-Int128{s} * q, -Int128{t} * p, Int128{p} * q};
    const auto z = static_cast<std::int64_t>((1 - V[0] * x - V[1] * y) / V[2]);
    const double normal = std::hypot(static_cast<double>(V[0]), static_cast<double>(V[1]), static_cast<double>(V[2]));
    const auto point = [](std::int64_t a, std::int64_t b, std::int64_t c) {
      return Vec3<Real>{static_cast<Real>(a), static_cast<Real>(b), static_cast<Real>(c)};
    };
    const auto r = static_cast<Real>(
        (1 + std::ldexp(static_cast<double>(random() % 5) - 2, -static_cast<int>(random() % 60))) / normal);
    return {point(0, 0, 0), point(p, 0, s), point(0, q, t), point(x, y, z), r};
  }
}

template <class Real>
struct Judged {
  std::vector<Query<Real>> queries;
  std::vector<int> order;  // of distance and r; 2: invalid

  static const Judged& all() {
    static const Judged judged = [] {
      Judged made;
      std::mt19937_64 random(seed);
      for (int i = 0; i < 4403; ++i) {
        Query<Real> q = i >= 4003    ? plane_query<Real>(random)
                        : i >= 2403  ? integer_query<Real>(random)
                        : i % 4 == 0 ? coarse_query_of_any_size<Real>(random)
                        : i % 4 == 1 ? tangent_query<Real>(random)
                                     : random_query<Real>(random, i % 4 == 2 && i % 16 != 2);
        if (i < 2403 && i % 4 == 2 && i % 3 != 0) q.r = std::abs(q.r);
        made.queries.push_back(q);
        made.order.push_back(is_valid(q) ? distance_order(q) : 2);
      }
      return made;
    }();
    return judged;
  }
  int expected(std::size_t i, axiscert_question question) const {
    if (order[i] == 2) return AXISCERT_INVALID;
    const bool contact = question == AXISCERT_OPEN_SPHERE ? order[i] < 0 : order[i] <= 0;
    return contact ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
  }
  QueryBatch<Real> batch() const {
    QueryBatch<Real> made(queries.size());
    for (const Query<Real>& q : queries) made.push_back(q);
    return made;
  }
};

template <class Real>
class CertifiedTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(CertifiedTest, Reals);

TYPED_TEST(CertifiedTest, QueriesAreOfEveryKind) {
  int counts[4] = {};
  for (const int order : Judged<TypeParam>::all().order) ++counts[order + 1];
  for (const int count : counts) EXPECT_GT(count, 10);
}

TYPED_TEST(CertifiedTest, IsExactOnEveryInstructionSet) {
  const auto& judged = Judged<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(batch.size());
    find_kernel("certified").on<TypeParam>(target).verdicts(batch.columns(), found.data());
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_EQ(static_cast<int>(found[i]), judged.expected(i, AXISCERT_CLOSED_SPHERE))
          << target << ", query " << i << " of seed " << seed;
    }
  }
}

TYPED_TEST(CertifiedTest, IsExactInEveryFloatingPointModeAndLeavesItAsItWas) {
  const auto& judged = Judged<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  std::vector<std::uint8_t> found(batch.size());
  for (const Rounding rounding : {Rounding::nearest, Rounding::upward, Rounding::downward, Rounding::toward_zero}) {
    for (const bool flush : {false, true}) {
      for (const axiscert_question question : {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE}) {
        {
          const FloatingEnvironment callers(rounding, flush);
          const std::uint64_t before = FloatingEnvironment::control();
          certified::pairs(batch.columns().column, batch.size(), question,
                           axiscert_results{found.data(), nullptr, nullptr});
          EXPECT_EQ(FloatingEnvironment::control() & ~std::uint64_t{0x3f}, before & ~std::uint64_t{0x3f});
        }
        for (std::size_t i = 0; i < batch.size(); ++i) {
          ASSERT_EQ(found[i], judged.expected(i, question))
              << "query " << i << " of seed " << seed << ", rounding " << static_cast<int>(rounding)
              << (flush ? ", flushed, question " : ", question ") << question;
        }
      }
    }
  }
}

TYPED_TEST(CertifiedTest, OnePairIsTheSame) {
  const auto& judged = Judged<TypeParam>::all();
  for (std::size_t i = 0; i < judged.queries.size(); ++i) {
    const auto v = coordinates(judged.queries[i]);
    for (const axiscert_question question : {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE}) {
      ASSERT_EQ(certified::pair(v.data(), v.data() + 9, question), judged.expected(i, question)) << "query " << i;
    }
  }
}

// One sphere against all of the triangles: by columns, by a list of a mesh's and by a range of them, the same verdicts,
// bits and hits, for sizes around the block's.
TYPED_TEST(CertifiedTest, EveryShapeGivesTheSameAnswers) {
  using Real = TypeParam;
  std::mt19937_64 random(seed);
  std::vector<Real> vertices;  // four numbers a vertex: the fourth is the caller's own
  for (int i = 0; i < 200; ++i) {
    const auto q = random_query<Real>(random, false);
    vertices.insert(vertices.end(), {q.a.x, q.a.y, q.a.z, std::numeric_limits<Real>::quiet_NaN()});
  }
  constexpr std::size_t triangles = 1000;
  std::vector<std::uint32_t> indices;
  for (std::size_t i = 0; i < 3 * triangles; ++i) indices.push_back(static_cast<std::uint32_t>(random() % 200));
  std::array<std::vector<Real>, 9> storage;
  for (std::size_t t = 0; t < triangles; ++t) {
    for (std::size_t k = 0; k < 9; ++k) storage[k].push_back(vertices[indices[3 * t + k / 3] * 4 + k % 3]);
  }
  const Real sphere[4] = {Real(0.1), Real(-0.2), Real(0.3), Real(0.4)};
  const certified::Mesh<Real> mesh{vertices.data(), 4, indices.data()};
  constexpr std::size_t first = 17;
  for (const std::size_t size :
       {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{256}, std::size_t{257}, triangles - first}) {
    struct Found {
      std::vector<std::uint8_t> verdict;
      std::vector<std::uint64_t> bits;
      std::vector<std::uint32_t> hits;
      axiscert_counts counts{};
    };
    const auto ask = [&](auto&& call) {
      Found found{std::vector<std::uint8_t>(size + 1, 99), std::vector<std::uint64_t>(size / 64 + 2, 99),
                  std::vector<std::uint32_t>(size + 1, 99)};
      found.counts = call(axiscert_results{found.verdict.data(), found.bits.data(), found.hits.data()});
      EXPECT_EQ(found.verdict[size], 99) << "wrote past the verdicts";
      EXPECT_EQ(found.bits[(size + 63) / 64], 99u) << "wrote past the bits";
      EXPECT_EQ(found.counts.invalid, 0u);
      found.hits.resize(found.counts.contacts);
      return found;
    };
    std::array<const Real*, 9> columns;
    for (std::size_t k = 0; k < 9; ++k) columns[k] = storage[k].data() + first;
    const auto closed = AXISCERT_CLOSED_SPHERE;
    const Found soa =
        ask([&](const axiscert_results& to) { return certified::triangles(sphere, columns, size, closed, to); });
    const Found range =
        ask([&](const axiscert_results& to) { return certified::mesh_range(sphere, mesh, first, size, closed, to); });
    std::vector<std::uint32_t> list;
    for (std::size_t i = 0; i < size; ++i) list.push_back(static_cast<std::uint32_t>(first + i));
    const Found listed = ask([&](const axiscert_results& to) {
      return certified::mesh_list(sphere, mesh, list.data(), list.size(), closed, to);
    });
    EXPECT_EQ(range.verdict, soa.verdict);
    EXPECT_EQ(listed.verdict, soa.verdict);
    EXPECT_EQ(range.bits, soa.bits);
    EXPECT_EQ(listed.hits, range.hits);
    std::size_t next = 0;
    for (std::size_t i = 0; i < size; ++i) {
      Real triangle[9];
      for (std::size_t k = 0; k < 9; ++k) triangle[k] = columns[k][i];
      const int expected = certified::pair(triangle, sphere, closed);
      EXPECT_EQ(soa.verdict[i], expected);
      EXPECT_EQ((soa.bits[i / 64] >> (i % 64)) & 1u, expected == AXISCERT_CONTACT ? 1u : 0u);
      if (expected != AXISCERT_CONTACT) continue;
      ASSERT_LT(next, soa.hits.size());
      EXPECT_EQ(soa.hits[next], i);
      EXPECT_EQ(range.hits[next++], first + i);
    }
    EXPECT_EQ(next, soa.counts.contacts);
    EXPECT_TRUE(size < triangles - first || next > 20) << next;
  }
}

// Chunks of triangles beyond each face of the sphere's box, or at it, or that reach across; and spheres and vertices
// that are no numbers.
TYPED_TEST(CertifiedTest, OneSphereAndTrianglesBeyondItsBox) {
  using Real = TypeParam;
  constexpr std::size_t chunk = 64, triangles = 16 * chunk;
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  std::mt19937_64 random(seed);
  std::array<std::vector<Real>, 9> storage;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto v = coordinates(random_query<Real>(random, false));
    const std::size_t face = t / chunk % 8;  // the last two: across
    for (std::size_t k = 0; k < 9; ++k) {
      const Real side = face % 2 ? Real(-1) : Real(1), beyond = t < triangles / 2 ? Real(4) : Real(0.25);
      const bool is_axis = k % 3 == face / 2, is_touching = k < 3 && t % 4 == 0;
      if (is_touching) storage[k].push_back(is_axis ? side * beyond : Real(0));
      else storage[k].push_back(is_axis ? side * (beyond + std::abs(v[k])) : v[k] / 4);
    }
  }
  storage[4][7 * chunk + 5] = nan;
  for (const std::size_t t : {std::size_t{3}, 2 * chunk + 9, 5 * chunk + 63})
    storage[t % 9][t] = t % 2 ? nan : infinity;
  std::array<const Real*, 9> columns;
  for (std::size_t k = 0; k < 9; ++k) columns[k] = storage[k].data();

  const Real greatest = std::numeric_limits<Real>::max(), tenth = Real(0.1);
  const Real spheres[][4] = {{0, 0, 0, Real(0.25)}, {0, 0, 0, 3},         {tenth, tenth, -tenth, tenth},
                             {0, 0, 0, 0},          {0, nan, 0, 1},       {0, 0, infinity, 1},
                             {0, 0, 0, infinity},   {0, 0, 0, -1},        {0, 0, 0, nan},
                             {greatest, 0, 0, 1},   {-greatest, 0, 0, 1}, {greatest, 0, 0, greatest},
                             {0, 0, 0, Real(1e-40)}};
  int counts[4] = {};
  for (const auto& sphere : spheres) {
    std::vector<std::uint8_t> found(triangles);
    certified::triangles(sphere, columns, triangles, AXISCERT_CLOSED_SPHERE, {found.data(), nullptr, nullptr});
    for (std::size_t t = 0; t < triangles; ++t) {
      std::array<Real, coordinate_count> v;
      for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = k < 9 ? storage[k][t] : sphere[k - 9];
      const Query<Real> q = from_coordinates(v);
      const int expected = !is_valid(q)             ? AXISCERT_INVALID
                           : distance_order(q) <= 0 ? AXISCERT_CONTACT
                                                    : AXISCERT_SEPARATED;
      ASSERT_EQ(found[t], expected) << "triangle " << t << ", sphere " << sphere[0] << ' ' << sphere[1] << ' '
                                    << sphere[2] << ' ' << sphere[3];
      ++counts[expected];
    }
  }
  EXPECT_GT(counts[AXISCERT_CONTACT], 100);
  EXPECT_GT(counts[AXISCERT_SEPARATED], 1000);
}

TYPED_TEST(CertifiedTest, ConservativeNeverMissesAContactAndItsPhantomsAreAsShallowAsPromised) {
  const auto& judged = Judged<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  const double promised = sizeof(TypeParam) == 4 ? AXISCERT_PHANTOM_DEPTH_F32 : AXISCERT_PHANTOM_DEPTH_F64;
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(batch.size());
    find_kernel("conservative").on<TypeParam>(target).verdicts(batch.columns(), found.data());
    int phantoms = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const int exact = judged.expected(i, AXISCERT_CLOSED_SPHERE);
      if (static_cast<int>(found[i]) == exact) continue;
      ASSERT_EQ(exact, AXISCERT_SEPARATED) << target << ", query " << i << " of seed " << seed;
      ASSERT_EQ(found[i], Verdict::contact) << target << ", query " << i << " of seed " << seed;
      ASSERT_LE(depth(judged.queries[i], squared_distance(judged.queries[i])), promised)
          << target << ", query " << i << " of seed " << seed;
      ++phantoms;
    }
    EXPECT_GT(phantoms, 20) << "no query was close enough to say anything";
  }
}

}  // namespace
}  // namespace axiscert
