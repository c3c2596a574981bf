// One sphere against an indexed mesh of more than a chunk, most of it beyond the sphere's box: on every instruction set
// each triangle's answer is that of the pair alone, in whatever order the triangles are.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <random>

#include "kernel/include/axiscert/certified.hpp"
#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/certified/default_modes.h"
#include "kernel/sphere_triangle/forms/simd.h"

namespace axiscert::certified {
namespace {

constexpr std::uint64_t seed = 20101230;
constexpr std::uint32_t side = 100;  // vertices in a row: in all more than the table of outcodes holds
constexpr axiscert_question questions[] = {AXISCERT_CLOSED_SPHERE, AXISCERT_OPEN_SPHERE, AXISCERT_CONSERVATIVE};

// Ground with cells of one unit, level except at some vertices; some vertices are not finite. The last vertex has only
// its three coordinates.
template <class Real>
struct Ground {
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;
  std::size_t stride;

  explicit Ground(std::size_t stride_) : stride(stride_) {
    constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        vertices.insert(vertices.end(), {Real(x), Real(y), Real((x * 7 + y * 3) % 11 == 0 ? 1 : 0)});
        if (x + 1 < side || y + 1 < side) vertices.resize(vertices.size() + stride - 3, nan);
      }
    }
    const Real none[] = {nan, infinity, -infinity};
    for (std::size_t i = 0; i < 24; ++i) {  // the first 2 are near the spheres
      const std::size_t v = i < 2 ? 48 * side + 47 + 5 * i : i * 401 + 11;
      vertices[v * stride + i % 3] = none[i / 3 % 3];
    }
    for (std::uint32_t y = 0; y + 1 < side; ++y) {
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t at = y * side + x;
        indices.insert(indices.end(), {at, at + 1, at + side, at + 1, at + side + 1, at + side});
      }
    }
  }
  std::size_t size() const { return indices.size() / 3; }
  Mesh<Real> mesh() const { return {vertices.data(), stride, indices.data()}; }

  std::vector<std::uint8_t> pair_by_pair(const Real* sphere, axiscert_question question) const {
    std::vector<std::uint8_t> expected;
    for (std::size_t t = 0; t < size(); ++t) {
      Real triangle[9];
      for (std::size_t k = 0; k < 9; ++k) triangle[k] = vertices[indices[3 * t + k / 3] * stride + k % 3];
      expected.push_back(static_cast<std::uint8_t>(pair(triangle, sphere, question)));
    }
    return expected;
  }
};

// Centres on vertices and radii of whole cells, so that vertices are on the faces of the box; some spheres are invalid.
template <class Real>
std::vector<std::array<Real, 4>> spheres() {
  constexpr Real nan = std::numeric_limits<Real>::quiet_NaN(), infinity = std::numeric_limits<Real>::infinity();
  return {{50, 50, 0, 3},        {50, 50, 2, 1},       {Real(49.6), 47, Real(0.5), Real(2.2)},
          {0, 0, 0, 2},          {99, 99, 0, 0},       {50, 50, 9, 3},
          {50, 50, -8, 60},      {50, 50, 0, -3},      {50, nan, 0, 3},
          {50, 50, 0, infinity}, {-infinity, 50, 0, 3}};
}

// The orders of the triangles: by vertices, reversed, alternately from either end, and shuffled.
std::vector<std::vector<std::uint32_t>> orders(std::size_t size) {
  std::vector<std::uint32_t> forwards(size);
  std::iota(forwards.begin(), forwards.end(), 0u);
  std::vector<std::uint32_t> backwards(forwards.rbegin(), forwards.rend()), turns, shuffled = forwards;
  for (std::size_t from = 0; from < size / 2; from += mesh_chunk_size) {
    const std::size_t end = std::min(from + mesh_chunk_size, size / 2);
    turns.insert(turns.end(), forwards.begin() + static_cast<std::ptrdiff_t>(from),
                 forwards.begin() + static_cast<std::ptrdiff_t>(end));
    turns.insert(turns.end(), backwards.begin() + static_cast<std::ptrdiff_t>(from),
                 backwards.begin() + static_cast<std::ptrdiff_t>(end));
  }
  std::shuffle(shuffled.begin(), shuffled.end(), std::mt19937_64(seed));
  return {forwards, backwards, turns, shuffled};
}

// The ground with its triangles in that order.
template <class Real>
Ground<Real> ordered(Ground<Real> ground, const std::vector<std::uint32_t>& order) {
  std::vector<std::uint32_t> indices;
  for (const std::uint32_t t : order) {
    for (std::size_t k = 0; k < 3; ++k) indices.push_back(ground.indices[3 * t + k]);
  }
  ground.indices = indices;
  return ground;
}

// Does what a call of the interface does, on the instruction set of these forms.
template <class Real>
std::vector<std::uint8_t> verdicts(const Forms& forms, const Ground<Real>& ground, const std::uint32_t* list,
                                   std::size_t size, const Real* sphere, axiscert_question question,
                                   Outcodes& outcodes) {
  std::vector<std::uint8_t> found(size);
  const DefaultModes modes;
  for (std::size_t first = 0; first < size; first += mesh_chunk_size) {
    const MeshChunk<Real> chunk{sphere,
                                ground.vertices.data(),
                                ground.stride,
                                ground.indices.data() + (list ? 0 : 3 * first),
                                list ? list + first : nullptr,
                                std::min(size - first, mesh_chunk_size)};
    MeshAnswer answer;
    forms.mesh<Real>()(chunk, static_cast<Question>(question), outcodes, answer);
    write_verdicts(answer, chunk.size, found.data() + first);
  }
  return found;
}

// Empty if there is no difference.
std::string first_difference(const std::vector<std::uint8_t>& found, const std::vector<std::uint8_t>& expected) {
  for (std::size_t i = 0; i < expected.size(); ++i) {
    if (found[i] != expected[i]) {
      return "query " + std::to_string(i) + " is " + std::to_string(found[i]) + ", not " + std::to_string(expected[i]);
    }
  }
  return {};
}

template <class Real>
class MeshTest : public testing::Test {};
using Reals = testing::Types<float, double>;
TYPED_TEST_SUITE(MeshTest, Reals);

TYPED_TEST(MeshTest, IsThePairsAnswerOnEveryInstructionSetInEveryOrder) {
  using Real = TypeParam;
  const SimdTable<Forms> table([] { return chosen_forms(); });
  int counts[4] = {};
  for (const std::size_t stride : {std::size_t{3}, std::size_t{4}, std::size_t{5}}) {
    const Ground<Real> ground(stride);
    const auto all_orders = orders(ground.size());
    for (const std::array<Real, 4>& sphere : spheres<Real>()) {
      const std::string at = testing::PrintToString(sphere);
      for (const axiscert_question question : questions) {
        const std::vector<std::uint8_t> by_pair = ground.pair_by_pair(sphere.data(), question);
        for (const std::uint8_t verdict : by_pair) ++counts[verdict];
        for (std::size_t o = 0; o < all_orders.size(); ++o) {
          const std::vector<std::uint32_t>& order = all_orders[o];
          std::vector<std::uint8_t> expected;
          for (const std::uint32_t t : order) expected.push_back(by_pair[t]);
          const Ground<Real> in_order = ordered(ground, order);
          for (const std::string& target : simd_targets()) {
            SCOPED_TRACE(target + ", order " + std::to_string(o) + ", stride " + std::to_string(stride) +
                         ", question " + std::to_string(question) + ", sphere " + at);
            Outcodes of_range, of_list;
            const Forms& forms = table.on(target);
            ASSERT_EQ(
                first_difference(verdicts(forms, in_order, nullptr, order.size(), sphere.data(), question, of_range),
                                 expected),
                "");
            ASSERT_EQ(
                first_difference(verdicts(forms, ground, order.data(), order.size(), sphere.data(), question, of_list),
                                 expected),
                "");
          }
        }
      }
    }
  }
  EXPECT_GT(counts[AXISCERT_CONTACT], 1000);
  EXPECT_GT(counts[AXISCERT_SEPARATED], 1000);
  EXPECT_GT(counts[AXISCERT_INVALID], 1000);
}

// One triangle far from the others, at each place of chunks that are not whole vectors; all codes are wrong before they
// are computed.
TYPED_TEST(MeshTest, SeesTheOneTriangleThatIsFarFromTheOthers) {
  using Real = TypeParam;
  const SimdTable<Forms> table([] { return chosen_forms(); });
  const std::array<Real, 4> sphere{2, 4, 0, Real(0.5)};
  const std::uint32_t near = 3 * 2 * (side - 1) + 4;  // its vertices are 302, 303 and 402; the last touches
  Ground<Real> ground(3);
  ASSERT_EQ(ground.pair_by_pair(sphere.data(), AXISCERT_CLOSED_SPHERE)[near], AXISCERT_CONTACT);
  for (std::size_t size = 64; size < 90; ++size) {
    for (std::size_t place = 0; place < size; ++place) {
      std::vector<std::uint32_t> order(size, 0);
      std::vector<std::uint8_t> expected(size, AXISCERT_SEPARATED);
      order[place] = near;
      expected[place] = AXISCERT_CONTACT;
      const Ground<Real> in_order = ordered(ground, order);
      for (const std::string& target : simd_targets()) {
        Outcodes outcodes;
        outcodes.are_useful = true;  // otherwise the one triangle may be among those tried
        std::fill(std::begin(outcodes.code), std::end(outcodes.code), std::uint8_t{63});
        ASSERT_EQ(first_difference(verdicts(table.on(target), in_order, nullptr, size, sphere.data(),
                                            AXISCERT_CLOSED_SPHERE, outcodes),
                                   expected),
                  "")
            << target << ", " << size << " triangles";
        ASSERT_EQ(outcodes.end, 403u);
      }
    }
  }
}

// Checks that the first test takes all of the paths.
TYPED_TEST(MeshTest, TakesTheTableOrTheVerticesOrNeither) {
  using Real = TypeParam;
  const Ground<Real> ground(3);
  const auto all_orders = orders(ground.size());
  const auto after = [&](const std::vector<std::uint32_t>& order, const std::array<Real, 4>& sphere,
                         axiscert_question question) {
    Outcodes outcodes;
    verdicts(chosen_forms(), ground, order.data(), order.size(), sphere.data(), question, outcodes);
    return outcodes;
  };
  const std::array<Real, 4> small{50, 50, 0, 3}, large{50, 50, 0, 90};
  for (std::size_t o = 0; o < all_orders.size(); ++o) {
    EXPECT_TRUE(after(all_orders[o], small, AXISCERT_CLOSED_SPHERE).are_useful);
    EXPECT_EQ(after(all_orders[o], small, AXISCERT_CLOSED_SPHERE).end != 0, o < 3)
        << "the table, where vertices are near";
    EXPECT_FALSE(after(all_orders[o], large, AXISCERT_CLOSED_SPHERE).are_useful);
    EXPECT_EQ(after(all_orders[o], small, AXISCERT_CONSERVATIVE).end, 0u);
  }
}

// Sizes around those of words, blocks and chunks: verdicts, bits, hits and counts are right, and nothing is written
// past them.
TYPED_TEST(MeshTest, WritesEveryResultOfEverySize) {
  using Real = TypeParam;
  const Ground<Real> ground(3);
  const Real sphere[4] = {50, 50, 0, Real(4.5)};
  const std::vector<std::uint8_t> by_pair = ground.pair_by_pair(sphere, AXISCERT_CLOSED_SPHERE);
  constexpr std::size_t first = 50 * 198 + 3 - 4 * 198;  // some rows before that of the sphere
  for (const std::size_t size : {0, 1, 8, 63, 64, 65, 255, 256, 257, 1023, 1024, 1025, 1088, 2047, 2048, 2049, 5000}) {
    std::vector<std::uint32_t> list(size);  // with repeated triangles
    for (std::size_t i = 0; i < size; ++i) list[i] = static_cast<std::uint32_t>(first + (i % 7 == 0 ? i / 2 : i));
    for (const bool is_list : {false, true}) {
      std::vector<std::uint8_t> found(size + 1, 99), expected(size + 1, 99);
      std::vector<std::uint64_t> bits((size + 63) / 64 + 1, 99), expected_bits((size + 63) / 64 + 1, 0);
      std::vector<std::uint32_t> hits(size + 1, 99), expected_hits;
      std::size_t invalid = 0;
      expected_bits.back() = 99;
      for (std::size_t i = 0; i < size; ++i) {
        const std::size_t t = is_list ? list[i] : first + i;
        expected[i] = by_pair[t];
        invalid += by_pair[t] == AXISCERT_INVALID;
        if (by_pair[t] != AXISCERT_CONTACT) continue;
        expected_bits[i / 64] |= std::uint64_t{1} << (i % 64);
        expected_hits.push_back(static_cast<std::uint32_t>(t));
      }
      const axiscert_results to{found.data(), bits.data(), hits.data()};
      const axiscert_counts counts =
          is_list ? mesh_list(sphere, ground.mesh(), list.data(), size, AXISCERT_CLOSED_SPHERE, to)
                  : mesh_range(sphere, ground.mesh(), first, size, AXISCERT_CLOSED_SPHERE, to);
      SCOPED_TRACE(std::to_string(size) + (is_list ? " of a list" : " of a range"));
      EXPECT_EQ(counts.contacts, expected_hits.size());
      EXPECT_EQ(counts.invalid, invalid);
      EXPECT_EQ(hits[counts.contacts], 99u) << "wrote past the hits";
      hits.resize(counts.contacts);
      EXPECT_EQ(found, expected);
      EXPECT_EQ(bits, expected_bits);
      EXPECT_EQ(hits, expected_hits);
      EXPECT_TRUE(size < 1023 || counts.contacts > 20) << counts.contacts;
    }
  }
}

}  // namespace
}  // namespace axiscert::certified
