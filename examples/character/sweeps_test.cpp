// The verdict by which a sphere sweeps safely against the oracles, journeys on grounds small enough to know the answer,
// and the counts for kernels with planted faults.
#include <gtest/gtest.h>

#include <functional>

#include "examples/character/sweeper.h"
#include "examples/character/judgement.h"
#include "exact/judge/oracles.h"
#include "fuzz/queries/family.h"
#include "kernel/ask.h"
#include "kernel/base/error.h"
#include "kernel/base/sha256.h"
#include "kernel/moving_sphere/names.h"

namespace axiscert::character {
namespace {

using MovingTriangles = std::vector<MeshTriangle>;

constexpr JourneyOptions walking = {.errand = Errand::walk, .seed = 3, .steps = 60, .radius = 0.25f};

// The square [0,4] x [0,4] at z = 0, and a wall over its side x = 4.
MovingTriangles floor_and_wall() {
  return {{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}}},
          {{{0, 0, 0}, {4, 4, 0}, {0, 4, 0}}},
          {{{4, 0, 0}, {4, 4, 0}, {4, 4, 2}}},
          {{{4, 0, 0}, {4, 4, 2}, {4, 0, 2}}}};
}
const Ground& room() {
  static const Ground ground(floor_and_wall(), 2);
  return ground;
}
const Ground& spider_ground() {
  static const Ground ground(load_mesh(std::string(TEST_MODELS) + "/OBJ/spider.obj", 0).triangles, 1);
  return ground;
}

World world_of(const Ground& ground, const Journey& made, const JourneyOptions& options) {
  return {ground, made.grid, options.radius};
}
SweepCounts counts_of(const Ground& ground, Sweeper& sweeper, const JourneyOptions& options) {
  const Journey made = journey(ground, sweeper, options);
  return judged(world_of(ground, made, options), made, sweeper.kernel());
}

TEST(Clear, IsTheVerdictOfTheOraclesOnEveryFamily) {
  std::size_t open = 0, asked = 0;
  for (const Family* family : families_of(moving_sphere_predicate(), MovingSphere::entry)) {
    for (std::uint64_t i = 0; i < 60; ++i) {
      const Numbers<float> numbers = family->make<float>(7, i);
      const auto q = MovingSphere::problem<float>([&](std::size_t k) { return numbers[k]; });
      const bool clear = oracles_of(moving_sphere_predicate()).truth(numbers).verdict == Verdict::separated;
      ASSERT_EQ(is_clear(q), clear) << family->name << " " << i;
      ASSERT_EQ(is_clear_by_rationals(q), clear) << family->name << " " << i;
      const Clearance quick = clearance_by_enclosures(q);
      if (quick != Clearance::open) {
        ASSERT_EQ(quick == Clearance::clear, clear) << family->name << " " << i;
      }
      open += quick == Clearance::open;
      ++asked;
    }
  }
  EXPECT_GT(open, asked / 20) << "what touches is left open";
  EXPECT_LT(open, asked / 2) << "and hardly anything else";
}

TEST(CertainSweeper, StopsAtTheLastPlaceThatIsClear) {
  const World world{room(), Grid(16), 0.25f};
  const std::vector<std::uint32_t> all = {0, 1, 2, 3};
  std::vector<SweeperAnswer> said;
  const Steps from = world.grid.nearest({1, 2, 3}), down = world.grid.nearest({0, 0, -5});
  const Stop stop = certain_sweeper()->stop(world, {from, down, all}, said);
  EXPECT_EQ(stop.wall, 1u);
  EXPECT_EQ(said[0].contact, false);
  EXPECT_EQ(said[1].contact, true);
  const Steps lower = stop.made + Steps{0, 0, -1};
  for (const std::uint32_t t : all) EXPECT_TRUE(is_clear(world.query(from, stop.made, t))) << t;
  EXPECT_FALSE(is_clear(world.query(from, lower, 1)));
  EXPECT_EQ(world.grid.exact(from + lower)[2], 0.25) << "one unit lower it touches";
}

TEST(CertainSweeper, WhatOnlyARoundedPlaceMeetsIsInTheWayToo) {
  // A long way in a plane that is no grid's: each place beside it is asked about with all triangles.
  const World world{spider_ground(), Grid(4096), 2};
  std::vector<std::uint32_t> all(spider_ground().size());
  for (std::uint32_t t = 0; t < all.size(); ++t) all[t] = t;
  std::vector<SweeperAnswer> said;
  const Point at = point(spider_ground().triangle(700)[0]);
  const Steps from = world.grid.nearest({at[0] + 311.7, at[1] + 171.3, at[2] - 153.1}),
              by = world.grid.nearest({-623.4, -342.6, 306.2});
  const Stop stop = certain_sweeper()->stop(world, {from, by, all}, said);
  ASSERT_TRUE(stop.wall);
  for (const std::uint32_t t : all) EXPECT_TRUE(is_clear(world.query(from, stop.made, t))) << t;
}

TEST(SweptJourney, NeverTouchesAnythingOnTheWholeOfItsWay) {
  for (const Errand errand : {Errand::walk, Errand::fall, Errand::bullet}) {
    const JourneyOptions options{errand, 1, 12, errand == Errand::bullet ? 0.0625f : 4.0f};
    const auto sweeper = certain_sweeper();
    const Journey made = journey(spider_ground(), *sweeper, options);
    const World world = world_of(spider_ground(), made, options);
    std::size_t stopped = 0;
    for (std::size_t m = 0; m < made.motions.size(); m += made.motions.size() / 4) {
      const Motion& motion = made.motions[m];
      stopped += motion.made != motion.by;
      // Also those that the broad phase left out: every fifth of the mesh.
      for (auto t = static_cast<std::uint32_t>(m % 5); t < spider_ground().size(); t += 5) {
        const Numbers<float> q = world.query(motion.from, motion.made, t);
        const Truth truth = oracles_of(moving_sphere_predicate()).truth(q);
        ASSERT_EQ(truth.verdict, Verdict::separated) << m << ", triangle " << t;
      }
    }
    EXPECT_GT(stopped, 0u);
  }
}

TEST(SweptJourney, AWalkStandsOnTheFloorAndSlidesAlongTheWall) {
  const auto sweeper = certain_sweeper();
  JourneyOptions options = walking;
  options.steps = 400;
  const Journey made = journey(room(), *sweeper, options);
  double furthest = 0;
  std::size_t slid = 0, standing = 0;
  for (const Motion& motion : made.motions) {
    const Point at = made.grid.exact(motion.from + motion.made);
    if (at[0] < 4 && at[1] > 0 && at[1] < 4 && at[2] < 2) furthest = std::max(furthest, at[0]);
    slid += motion.purpose == Purpose::slide && motion.made != Steps{};
    const bool over_the_floor = at[0] > 0 && at[0] < 3.7 && at[1] > 0 && at[1] < 4;
    if (motion.purpose != Purpose::descend || !over_the_floor || motion.made == motion.by) continue;
    EXPECT_EQ(at[2], 0.25 + made.grid.unit());
    ++standing;
  }
  EXPECT_GT(standing, 200u);
  EXPECT_GT(slid, 0u);
  EXPECT_LT(furthest, 3.75);
  EXPECT_GT(furthest, 3.7499);
  const SweepCounts counts = judged(world_of(room(), made, options), made, nullptr);
  EXPECT_EQ(counts.entered, 0u);
  EXPECT_GT(counts.contacts, 400u);
}

TEST(SweptJourney, IsTheSameEverywhere) {
  std::string bytes;
  for (const Errand errand : {Errand::walk, Errand::fall, Errand::bullet}) {
    const auto sweeper = certain_sweeper();
    const Journey made = journey(spider_ground(), *sweeper, {errand, 1, 40, 4});
    for (const Motion& motion : made.motions) {
      bytes.append(reinterpret_cast<const char*>(motion.from.data()), sizeof motion.from);
      bytes.append(reinterpret_cast<const char*>(motion.made.data()), sizeof motion.made);
    }
  }
  EXPECT_EQ(sha256_hex(std::as_bytes(std::span(bytes))),
            "d0f0028d8661065eb5737b735184e0fdd3ebc86062fa3d5e7c55a32f85674b5f");
}

// A kernel that gives `time` of what it is asked, empty for no contact.
Kernel kernel_by(const std::function<std::optional<float>(const MovingQuery<float>&)>& time) {
  Kernel kernel;
  kernel.id = "moving-sphere/planted";
  kernel.predicate = &moving_sphere_predicate();
  kernel.measure_count = 1;
  kernel.binary32 = [time](std::string_view) {
    const auto at = [time](const QueryColumns<float>& batch, std::size_t i) {
      return time(MovingSphere::problem<float>([&](std::size_t k) { return batch.column[k][i]; }));
    };
    Implementation<float> planted;
    planted.verdicts = [at](const QueryColumns<float>& batch, Verdict* out) {
      for (std::size_t i = 0; i < batch.size; ++i) out[i] = at(batch, i) ? Verdict::contact : Verdict::separated;
    };
    planted.measure = [at](const QueryColumns<float>& batch, Answers<float>& out) {
      for (std::size_t i = 0; i < batch.size; ++i) {
        out.measures[moving_sphere::time_measure][i] = at(batch, i).value_or(0);
      }
    };
    return planted;
  };
  return kernel;
}
std::optional<float> gated_time(const MovingQuery<float>& q) {
  static const Implementation<float> gated = find_kernel("moving-sphere/gated").on<float>(scalar_target);
  const Reply<float> reply = ask(gated, Numbers<float>(q));
  if (reply.verdicts[0] != Verdict::contact) return std::nullopt;
  return reply.answers.measures[moving_sphere::time_measure][0];
}

TEST(SweepCounts, AKernelThatFindsNothingMissesEverythingAndGoesThrough) {
  const Kernel blind = kernel_by([](const MovingQuery<float>&) { return std::nullopt; });
  const JourneyOptions falling{Errand::fall, 1, 50, 0.25f};
  const SweepCounts counts = counts_of(room(), *sweeper_by(blind, 0), falling);
  EXPECT_EQ(counts.missed, counts.contacts);
  EXPECT_EQ(counts.stopped, 0u);
  EXPECT_GE(counts.entered, 40u);
  EXPECT_GT(counts.through, 15u) << "what falls on the floor, and not on its brink";
  EXPECT_LE(counts.through, counts.sunk);
  EXPECT_EQ(counts.deepest, round_up(Rational(1)));
}

TEST(SweepCounts, AKernelThatFindsContactEverywhereInventsIt) {
  const Kernel anxious = kernel_by([](const MovingQuery<float>&) { return std::optional(0.0f); });
  const SweepCounts counts = counts_of(room(), *sweeper_by(anxious, 0), walking);
  EXPECT_EQ(counts.missed, 0u);
  EXPECT_EQ(counts.phantom, counts.triangles - counts.contacts);
  EXPECT_EQ(counts.entered, 0u);
}

TEST(SweepCounts, LateTimesSinkByWhatTheSkinDoesNotMakeUpFor) {
  const Kernel right = kernel_by(gated_time);
  const Kernel late = kernel_by([](const MovingQuery<float>& q) -> std::optional<float> {
    const auto time = gated_time(q);
    return time ? std::optional(std::min(*time + 0.1f, 1.0f)) : time;
  });
  const Kernel timeless = kernel_by([](const MovingQuery<float>& q) -> std::optional<float> {
    return gated_time(q) ? std::optional(2.0f) : std::nullopt;
  });
  const JourneyOptions falling{Errand::fall, 1, 50, 0.25f};
  const SweepCounts at_rest = counts_of(room(), *sweeper_by(right, 0x1p-6), falling);
  EXPECT_EQ(at_rest.entered, 0u);
  EXPECT_EQ(at_rest.missed + at_rest.phantom, 0u);
  const SweepCounts sinking = counts_of(room(), *sweeper_by(late, 0x1p-6), falling);
  EXPECT_EQ(sinking.late, sinking.contacts);
  EXPECT_GT(sinking.sunk, 35u);
  const SweepCounts skinned = counts_of(room(), *sweeper_by(late, 1), falling);
  EXPECT_EQ(skinned.late, skinned.contacts);
  EXPECT_EQ(skinned.entered, 0u) << "a tenth of this way is less than the skin";
  const SweepCounts without = counts_of(room(), *sweeper_by(timeless, 0), falling);
  EXPECT_EQ(without.without_time, without.contacts);
  EXPECT_GT(without.through, 15u) << "a contact without a time stops nothing";
}

TEST(SweepCounts, WhatAKernelDoesNotPromiseIsNotCounted) {
  Kernel blind = kernel_by([](const MovingQuery<float>&) { return std::nullopt; });
  blind.motion.sides = SidesPolicy::front;
  const JourneyOptions falling{Errand::fall, 1, 50, 0.25f};
  const SweepCounts counts = counts_of(room(), *sweeper_by(blind, 0), falling);
  EXPECT_GT(counts.missed, 0u) << "the floor is met from its front";
  EXPECT_LT(counts.missed, counts.contacts) << "the wall's edge is not";
}

TEST(SweepCounts, AJourneyByCertainVerdictsThatEntersATriangleIsTheHarnesssFault) {
  const auto sweeper = certain_sweeper();
  Journey made = journey(room(), *sweeper, walking);
  for (Motion& motion : made.motions) motion.made = motion.by;
  EXPECT_THROW(judged(world_of(room(), made, walking), made, nullptr), HarnessFault);
}

}  // namespace
}  // namespace axiscert::character
