// The walk on grounds small enough to know the answer, its answers against CGAL's exact distance on a real mesh, and
// the comparison's counts for kernels with planted faults.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>

#include "examples/character/comparison.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "kernel/base/sha256.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::character {
namespace {

constexpr float radius = 0.25f;

using Triangles = std::vector<MeshTriangle>;

void add_rectangle(Triangles& to, const std::array<Vec3<float>, 4>& v) {
  to.push_back({v[0], v[1], v[2]});
  to.push_back({v[0], v[2], v[3]});
}
// The square [0,4] x [0,4] at z = 0, as one triangle below the diagonal y = x and one above it.
Triangles flat_floor() {
  Triangles floor;
  add_rectangle(floor, {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}});
  return floor;
}

struct Spider {
  Ground ground{load_mesh(std::string(TEST_MODELS) + "/OBJ/spider.obj", 0).triangles, 1};
  Walk walk = walked(ground, {.seed = 1, .steps = 60, .radius = 2});
};
const Spider& spider() {
  static const Spider all;
  return all;
}

// Calls check(ask, index of the answer) for each triangle of each ask.
template <class Check>
void for_each_answer(const Walk& walk, Check&& check) {
  for (const Ask& ask : walk.asks) {
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) check(ask, i);
  }
}

TEST(Walk, OnAFlatFloorTheSphereRestsAtItsRadiusAndTouchesWhatIsBelowIt) {
  const Ground ground(flat_floor(), 2);
  const Walk walk = walked(ground, {.seed = 3, .steps = 400, .radius = radius});
  EXPECT_GE(walk.rests.size(), 400u);
  int inside = 0;
  for (const std::size_t rest : walk.rests) {
    const Ask& ask = walk.asks[rest];
    const auto [x, y, z] = ask.sphere.centre;
    ASSERT_EQ(ask.moment, Moment::rest);
    if (x < 0 || y < 0 || x > 4 || y > 4) {
      EXPECT_LT(z, radius) << "leaning over the brink";
      continue;
    }
    ++inside;
    EXPECT_EQ(z, radius);
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) {
      const bool below = walk.triangles[i] == 0 ? y <= x : y >= x;
      EXPECT_EQ(walk.closed[i], below ? AXISCERT_CONTACT : AXISCERT_SEPARATED) << x << ", " << y;
      EXPECT_EQ(walk.open[i], AXISCERT_SEPARATED) << "it touches, and sinks into nothing";
    }
  }
  EXPECT_GT(inside, 200);
}

TEST(Walk, AWallIsTouchedAndNotEntered) {
  Triangles room = flat_floor();
  add_rectangle(room, {{{4, 0, 0}, {4, 4, 0}, {4, 4, 2}, {4, 0, 2}}});
  const Ground ground(room, 2);
  const Walk walk = walked(ground, {.seed = 1, .steps = 600, .radius = radius});
  float furthest = 0;
  for (const std::size_t rest : walk.rests) {
    const Vec3<float> p = walk.asks[rest].sphere.centre;
    if (p.z < 1 && p.y >= 0 && p.y <= 4) furthest = std::max(furthest, p.x);
  }
  EXPECT_NEAR(furthest, 4 - radius, 1e-6);
  EXPECT_GT(asked(ground, walk)[static_cast<std::size_t>(Moment::slide)].spheres, 0u);
  EXPECT_GT(walk.turns, 0u);
}

TEST(Walk, StandsOnWhatHasNoAreaAndNotOnWhatIsSteep) {
  const WalkOptions options{.seed = 1, .steps = 1, .radius = radius};
  EXPECT_NO_THROW(walked(Ground({{{{0, 0, 0}, {4, 0, 0}, {4, 0, 0}}}}, 2), options));
  const Ground steep({{{{0, 0, 0}, {0, 1, 0}, {1, 0.5f, 20}}}}, 2);
  try {
    walked(steep, options);
    FAIL();
  } catch (const Error& wrong) {
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "nothing to stand on along the axis z", wrong.what());
  }
}

TEST(Walk, EveryAnswerIsThatOfCgalsExactDistance) {
  const auto& [ground, walk] = spider();
  std::uint64_t contacts = 0, touching = 0;
  for_each_answer(walk, [&](const Ask& ask, std::size_t i) {
    const int order = distance_order(ground.query(ask.sphere, walk.triangles[i]));
    ASSERT_EQ(walk.closed[i], order <= 0 ? AXISCERT_CONTACT : AXISCERT_SEPARATED) << i;
    ASSERT_EQ(walk.open[i], order < 0 ? AXISCERT_CONTACT : AXISCERT_SEPARATED) << i;
    contacts += order <= 0;
    touching += order == 0;
  });
  std::uint64_t counted = 0, touched = 0;
  for (const WalkCounts& a : asked(ground, walk)) {
    counted += a.contacts;
    touched += a.touching;
  }
  EXPECT_EQ(counted, contacts);
  EXPECT_EQ(touched, touching);
  EXPECT_GT(contacts, 2000u);
  EXPECT_GT(walk.triangles.size(), 2 * contacts);
}

TEST(Walk, TheBroadPhaseLeavesOutNoContact) {
  const auto& [ground, walk] = spider();
  std::vector<std::uint32_t> hits(ground.size());
  for (std::size_t a = 0; a < walk.asks.size(); a += 5) {
    const Ask& ask = walk.asks[a];
    const float sphere[4] = {ask.sphere.centre.x, ask.sphere.centre.y, ask.sphere.centre.z, ask.sphere.radius};
    const axiscert_mesh_f32 mesh = ground.mesh();
    const axiscert_results results{nullptr, nullptr, hits.data()};
    const std::size_t count =
        axiscert_mesh_range_f32(sphere, &mesh, 0, ground.size(), AXISCERT_CLOSED_SPHERE, &results).contacts;
    std::vector<std::uint32_t> listed;
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) {
      if (walk.closed[i] == AXISCERT_CONTACT) listed.push_back(walk.triangles[i]);
    }
    ASSERT_EQ(listed, std::vector<std::uint32_t>(hits.begin(), hits.begin() + static_cast<std::ptrdiff_t>(count))) << a;
  }
}

TEST(Walk, IsTheSameEverywhere) {
  std::string bytes;
  for (const Ask& ask : spider().walk.asks) {
    const std::array<float, 4> sphere = {ask.sphere.centre.x, ask.sphere.centre.y, ask.sphere.centre.z,
                                         ask.sphere.radius};
    bytes.append(reinterpret_cast<const char*>(sphere.data()), sizeof sphere);
  }
  EXPECT_EQ(sha256_hex(std::as_bytes(std::span(bytes))),
            "ae96030204c104f8eef442cb6034f3e524d553e2645fdcf326fd0271aaf0cd88");
  const Walk other = walked(spider().ground, {.seed = 2, .steps = 60, .radius = 2});
  EXPECT_NE(other.paths.front().front().x, spider().walk.paths.front().front().x);
}

// A kernel that gives the answers of `answer`.
template <class Answer>
Kernel kernel_of(const std::string& id, TouchingPolicy touching, Answer answer) {
  Kernel kernel;
  kernel.id = id;
  kernel.predicate = &sphere_triangle_predicate();
  kernel.formulae = "published";
  kernel.touching = touching;
  kernel.binary32 = [answer](std::string_view) {
    Implementation<float> implementation;
    implementation.verdicts = [answer](const QueryColumns<float>& batch, Verdict* out) {
      for (std::size_t i = 0; i < batch.size; ++i) {
        std::array<float, coordinate_count> v;
        for (std::size_t k = 0; k < coordinate_count; ++k) v[k] = batch.column[k][i];
        out[i] = answer(from_coordinates(v));
      }
    };
    return implementation;
  };
  return kernel;
}
Verdict certified(const Query<float>& q) {
  const auto v = coordinates(q);
  return static_cast<Verdict>(axiscert_pair_f32(v.data(), v.data() + 9, AXISCERT_CLOSED_SPHERE));
}

// On the floor every contact is known: the tests above count them by hand.
TEST(Comparison, AKernelThatNeverOrAlwaysFindsContactIsCountedSo) {
  const Ground ground(flat_floor(), 2);
  const Walk walk = walked(ground, {.seed = 3, .steps = 50, .radius = radius});
  WalkCounts all;
  std::uint64_t with_contact = 0, without = 0;
  for (const WalkCounts& a : asked(ground, walk)) {
    all.triangles += a.triangles;
    all.contacts += a.contacts;
    all.touching += a.touching;
  }
  for (const Ask& ask : walk.asks) {
    std::size_t contacts = 0;
    for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) contacts += walk.closed[i] == AXISCERT_CONTACT;
    ++(contacts > 0 ? with_contact : without);
  }
  ASSERT_GT(all.touching, 40u);
  const auto never = [](const Query<float>&) { return Verdict::separated; };
  const auto always = [](const Query<float>&) { return Verdict::contact; };
  const Comparison blind = compared(ground, walk, kernel_of("never", TouchingPolicy::contact, never));
  EXPECT_EQ(blind.all.errors.missed, all.contacts);
  EXPECT_EQ(blind.all.errors.invented, 0u);
  EXPECT_EQ(blind.all.lost, with_contact);
  EXPECT_EQ(blind.lost, walk.rests);
  const Tally open = compared(ground, walk, kernel_of("never", TouchingPolicy::separated, never)).all;
  EXPECT_EQ(open.errors.missed, all.contacts - all.touching) << "touching is not contact to it";
  const Tally sees = compared(ground, walk, kernel_of("always", TouchingPolicy::contact, always)).all;
  EXPECT_EQ(sees.errors.missed, 0u);
  EXPECT_EQ(sees.errors.invented, all.triangles - all.contacts);
  EXPECT_LE(sees.phantom, without);
  const Tally either = compared(ground, walk, kernel_of("never", TouchingPolicy::either, never)).all;
  EXPECT_EQ(either.errors.missed, all.contacts - all.touching);
}

TEST(Comparison, OneWrongAnswerIsFoundWhereItIs) {
  const auto& [ground, walk] = spider();
  for (const int planted : {AXISCERT_CONTACT, AXISCERT_SEPARATED}) {
    // The last answer of its kind, at rest.
    std::size_t where = 0, at = 0;
    for (const std::size_t rest : walk.rests) {
      const Ask& ask = walk.asks[rest];
      for (std::size_t i = ask.first; i < ask.first + ask.count; ++i) {
        if (walk.closed[i] == planted) where = rest, at = i;
      }
    }
    const auto wrong = coordinates(ground.query(walk.asks[where].sphere, walk.triangles[at]));
    const auto answer = [&](const Query<float>& q) {
      const Verdict right = certified(q);
      if (coordinates(q) != wrong) return right;
      return right == Verdict::contact ? Verdict::separated : Verdict::contact;
    };
    const Comparison found = compared(ground, walk, kernel_of("planted", TouchingPolicy::contact, answer));
    ASSERT_FALSE(found.wrong.empty());
    for (const Wrong& w : found.wrong) {
      EXPECT_EQ(w.triangle, walk.triangles[at]);
      EXPECT_EQ(w.missed, planted == AXISCERT_CONTACT);
    }
    const Errors& rest = found.tallies[static_cast<std::size_t>(Moment::rest)].errors;
    EXPECT_EQ(rest.missed + rest.invented, 1u);
    EXPECT_EQ(
        found.with_area.missed + found.with_area.invented + found.without_area.missed + found.without_area.invented,
        found.wrong.size());
    EXPECT_EQ(found.wrong.back().ask, where);
  }
  EXPECT_TRUE(compared(ground, walk, kernel_of("right", TouchingPolicy::contact, certified)).wrong.empty());
}

TEST(Comparison, AnAnswerThatCgalDoesNotConfirmIsTheHarnesssFault) {
  Walk walk = spider().walk;
  walk.closed.back() = walk.closed.back() == AXISCERT_CONTACT ? AXISCERT_SEPARATED : AXISCERT_CONTACT;
  EXPECT_THROW(compared(spider().ground, walk, kernel_of("right", TouchingPolicy::contact, certified)), HarnessFault);
}

TEST(NearestPoint, IsInTheFaceOnAnEdgeAtAVertexAndWithoutArea) {
  const MeshTriangle t = {{{0, 0, 0}, {4, 0, 0}, {0, 4, 0}}}, needle = {{{0, 0, 0}, {4, 0, 0}, {2, 0, 0}}};
  EXPECT_EQ(nearest_point(t, {1, 1, 3}), (Point{1, 1, 0}));
  EXPECT_EQ(nearest_point(t, {1, -2, 3}), (Point{1, 0, 0}));
  EXPECT_EQ(nearest_point(t, {4, 4, 3}), (Point{2, 2, 0}));
  EXPECT_EQ(nearest_point(t, {-1, -2, 3}), (Point{0, 0, 0}));
  EXPECT_EQ(nearest_point(needle, {3, 1, 0}), (Point{3, 0, 0}));
  EXPECT_EQ(nearest_point({{{1, 1, 1}, {1, 1, 1}, {1, 1, 1}}}, {3, 1, 0}), (Point{1, 1, 1}));
}

}  // namespace
}  // namespace axiscert::character
