// The certified predicate compared with CGAL's distance, on every instruction set, in every floating-point mode and
// through every form of the interface; and the bounds on how far the conservative one may be off.
#include "kernel/include/axiscert/certified.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "exact/sphere_triangle/certified_queries.h"
#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/base/environment.h"
#include "kernel/kernel.h"
#include "kernel/random_testing.h"

namespace axiscert {
namespace {

using testing_support::coarse_query_of_any_size, testing_support::integer_query, testing_support::plane_query,
    testing_support::random_query, testing_support::tangent_query;

constexpr std::uint64_t certified_seed = 20101230;
// Through all steps, and straight to the exact one.
constexpr axiscert_question both_questions_both_ways[] = {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE,
                                                          AXISCERT_EXACT_ONLY, AXISCERT_OPEN_EXACT_ONLY};

template <class Real>
struct JudgedQueries {
  std::vector<Query<Real>> queries;
  std::vector<int> order;  // order of distance and r; 2: invalid

  static const JudgedQueries& all() {
    static const JudgedQueries judged = [] {
      JudgedQueries made;
      std::mt19937_64 random(certified_seed);
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
    const bool is_open = question == AXISCERT_OPEN_SPHERE || question == AXISCERT_OPEN_EXACT_ONLY;
    const bool contact = is_open ? order[i] < 0 : order[i] <= 0;
    return contact ? AXISCERT_CONTACT : AXISCERT_SEPARATED;
  }
  QueryBatch<Real> batch() const {
    QueryBatch<Real> made(queries.size(), coordinate_count);
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
  for (const int order : JudgedQueries<TypeParam>::all().order) ++counts[order + 1];
  for (const int count : counts) EXPECT_GT(count, 10);
}

TYPED_TEST(CertifiedTest, IsExactOnEveryInstructionSet) {
  const auto& judged = JudgedQueries<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(batch.size());
    find_kernel("certified").on<TypeParam>(target).verdicts(batch.columns(), found.data());
    for (std::size_t i = 0; i < batch.size(); ++i) {
      ASSERT_EQ(static_cast<int>(found[i]), judged.expected(i, AXISCERT_CLOSED_SPHERE))
          << target << ", query " << i << " of seed " << certified_seed;
    }
  }
}

TYPED_TEST(CertifiedTest, IsExactInEveryFloatingPointModeAndLeavesItAsItWas) {
  const auto& judged = JudgedQueries<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  std::array<const TypeParam*, coordinate_count> columns;
  std::copy_n(batch.columns().column.begin(), coordinate_count, columns.begin());
  std::vector<std::uint8_t> found(batch.size());
  for (const Rounding rounding : {Rounding::nearest, Rounding::upward, Rounding::downward, Rounding::toward_zero}) {
    for (const bool flush : {false, true}) {
      for (const axiscert_question question : both_questions_both_ways) {
        {
          const FloatingEnvironment callers(rounding, flush);
          const std::uint64_t before = FloatingEnvironment::control();
          certified::pairs(columns, batch.size(), question, axiscert_results{found.data(), nullptr, nullptr});
          EXPECT_EQ(FloatingEnvironment::control() & ~std::uint64_t{0x3f}, before & ~std::uint64_t{0x3f});
        }
        for (std::size_t i = 0; i < batch.size(); ++i) {
          ASSERT_EQ(found[i], judged.expected(i, question))
              << "query " << i << " of seed " << certified_seed << ", rounding " << static_cast<int>(rounding)
              << (flush ? ", flushed, question " : ", question ") << question;
        }
      }
    }
  }
}

TYPED_TEST(CertifiedTest, OnePairIsTheSame) {
  const auto& judged = JudgedQueries<TypeParam>::all();
  for (std::size_t i = 0; i < judged.queries.size(); ++i) {
    const auto v = coordinates(judged.queries[i]);
    for (const axiscert_question question : both_questions_both_ways) {
      ASSERT_EQ(certified::pair(v.data(), v.data() + 9, question), judged.expected(i, question)) << "query " << i;
    }
  }
}

// One sphere against all of the triangles: given by columns, by a list of a mesh's triangles and by a range of them,
// the same verdicts, bits and hits, for sizes around the block's.
TYPED_TEST(CertifiedTest, EveryShapeGivesTheSameAnswers) {
  using Real = TypeParam;
  std::mt19937_64 random(certified_seed);
  std::vector<Real> vertices;  // four numbers per vertex: the fourth belongs to the caller
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
  const std::size_t sizes[] = {0, 1, 63, 256, 257, triangles - first};
  for (std::size_t k = 0; k < 2 * std::size(sizes); ++k) {
    const std::size_t size = sizes[k / 2];
    const axiscert_question closed = k % 2 == 0 ? AXISCERT_CLOSED_SPHERE : AXISCERT_EXACT_ONLY;
    struct MeshAnswers {
      std::vector<std::uint8_t> verdict;
      std::vector<std::uint64_t> bits;
      std::vector<std::uint32_t> hits;
      axiscert_counts counts{};
    };
    const auto ask = [&](auto&& call) {
      MeshAnswers found{std::vector<std::uint8_t>(size + 1, 99), std::vector<std::uint64_t>(size / 64 + 2, 99),
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
    const MeshAnswers soa =
        ask([&](const axiscert_results& to) { return certified::triangles(sphere, columns, size, closed, to); });
    const MeshAnswers range =
        ask([&](const axiscert_results& to) { return certified::mesh_range(sphere, mesh, first, size, closed, to); });
    std::vector<std::uint32_t> list;
    for (std::size_t i = 0; i < size; ++i) list.push_back(static_cast<std::uint32_t>(first + i));
    const MeshAnswers listed = ask([&](const axiscert_results& to) {
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
      EXPECT_EQ(has_bit(soa.bits[i / 64], i % 64), expected == AXISCERT_CONTACT);
      if (expected != AXISCERT_CONTACT) continue;
      ASSERT_LT(next, soa.hits.size());
      EXPECT_EQ(soa.hits[next], i);
      EXPECT_EQ(range.hits[next++], first + i);
    }
    EXPECT_EQ(next, soa.counts.contacts);
    EXPECT_TRUE(size < triangles - first || next > 20) << next;
  }
}

// Chunks of triangles beyond each face of the sphere's box, at the face, or across it; and spheres and vertices with
// coordinates that are not numbers.
TYPED_TEST(CertifiedTest, OneSphereAndTrianglesBeyondItsBox) {
  using Real = TypeParam;
  constexpr std::size_t chunk = 64, triangles = 16 * chunk;
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  std::mt19937_64 random(certified_seed);
  std::array<std::vector<Real>, 9> storage;
  for (std::size_t t = 0; t < triangles; ++t) {
    const auto v = coordinates(random_query<Real>(random, false));
    const std::size_t face = t / chunk % 8;  // 6 and 7: no face, the triangles reach across the box
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
    std::vector<std::uint8_t> found_exactly(triangles);
    certified::triangles(sphere, columns, triangles, AXISCERT_EXACT_ONLY, {found_exactly.data(), nullptr, nullptr});
    EXPECT_EQ(found_exactly, found);
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
  const auto& judged = JudgedQueries<TypeParam>::all();
  const QueryBatch<TypeParam> batch = judged.batch();
  const double promised = sizeof(TypeParam) == 4 ? AXISCERT_PHANTOM_DEPTH_F32 : AXISCERT_PHANTOM_DEPTH_F64;
  for (const std::string& target : available_targets()) {
    std::vector<Verdict> found(batch.size());
    find_kernel("conservative").on<TypeParam>(target).verdicts(batch.columns(), found.data());
    int phantoms = 0;
    for (std::size_t i = 0; i < batch.size(); ++i) {
      const int exact = judged.expected(i, AXISCERT_CLOSED_SPHERE);
      if (static_cast<int>(found[i]) == exact) continue;
      ASSERT_EQ(exact, AXISCERT_SEPARATED) << target << ", query " << i << " of seed " << certified_seed;
      ASSERT_EQ(found[i], Verdict::contact) << target << ", query " << i << " of seed " << certified_seed;
      ASSERT_LE(depth(judged.queries[i], squared_distance(judged.queries[i])), promised)
          << target << ", query " << i << " of seed " << certified_seed;
      ++phantoms;
    }
    EXPECT_GT(phantoms, 20) << "no query was close enough to say anything";
  }
}

}  // namespace
}  // namespace axiscert
