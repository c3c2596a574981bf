#include "examples/character/judgement.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "examples/character/sweeper.h"
#include "exact/moving_sphere/first_contact.h"
#include "exact/moving_sphere/motion_distance.h"
#include "exact/judge/oracles.h"
#include "kernel/base/error.h"

namespace axiscert::character {
namespace {

constexpr std::uint64_t sample = 64;  // of the triangles without contact, so many to one that is confirmed
constexpr Decimal6 hundredth{-7, 100000};

MovingQuery<double> widened(const MovingQuery<float>& q) {
  const Numbers<float> numbers = q;
  return MovingSphere::problem<double>([&](std::size_t k) { return double(numbers[k]); });
}

class SweepJudge {
 public:
  SweepJudge(const World& world, const Journey& journey, const Kernel* kernel)
      : world_(world), journey_(journey), kernel_(kernel), radius_(world.radius) {}

  SweepCounts counts() {
    for (const Motion& motion : journey_.motions) {
      ++counts_.motions;
      counts_.stopped += motion.made != motion.by;
      for (std::size_t i = motion.first; i < motion.first + motion.count; ++i) judge_answer(motion, i);
      judge_motion(motion);
    }
    if (!kernel_ && counts_.entered > 0) {
      throw HarnessFault(fmt::format("a sphere that moves by certain verdicts alone entered {} triangles by the oracle",
                                     counts_.entered));
    }
    return counts_;
  }

 private:
  void judge_answer(const Motion& motion, std::size_t i) {
    const MovingQuery<float> q = world_.query(motion.from, motion.by, journey_.triangles[i]);
    const bool contact = !is_clear(q);
    std::optional<moving_sphere::FirstContact> first;
    if (contact || counts_.triangles % sample == 0) {
      first = moving_sphere::first_contact(widened(q));
      if (first.has_value() != contact) {
        throw HarnessFault(
            fmt::format("the twenty axes answer {} for a motion of which the oracle by rationals says {}",
                        contact ? "contact" : "clear", first ? "contact" : "clear"));
      }
    }
    ++counts_.triangles;
    counts_.contacts += contact;
    if (!kernel_) return;
    const SweeperAnswer& said = journey_.said[i];
    if (said.contact != contact) {
      if (counts_against_it(q)) ++(contact ? counts_.missed : counts_.phantom);
    } else if (contact && kernel_->measure_count > 0) {
      const bool has_time = said.time >= 0 && said.time <= 1;
      counts_.without_time += !has_time;
      counts_.late += has_time && compare(first->time, exact(double(said.time))) < 0;
    }
  }

  // Whether a wrong answer is beyond what the kernel promises.
  bool counts_against_it(const Numbers<float>& q) const {
    const Oracles& oracles = oracles_of(moving_sphere_predicate());
    if (!oracles.is_promised(kernel_->motion, q)) return false;
    return kernel_->touching == TouchingPolicy::contact || !oracles.truth(q).touching;
  }

  void judge_motion(const Motion& motion) {
    bool entered = false, sunk = false, through = false;
    for (std::size_t i = motion.first; i < motion.first + motion.count; ++i) {
      const MovingQuery<float> made = world_.query(motion.from, motion.made, journey_.triangles[i]);
      if (is_clear(made)) continue;
      const Rational least = moving_sphere::least_distance(widened(made)).squared;
      MovingQuery<double> still = widened(made);
      still.d = {0, 0, 0};
      if (least >= moving_sphere::least_distance(still).squared) continue;
      const Tunnel tunnel = moving_sphere::tunnel_of(radius_, least);
      entered = true;
      sunk |= tunnel.depth >= hundredth;
      through |= tunnel.is_through;
      counts_.deepest = std::max(counts_.deepest, tunnel.depth);
    }
    counts_.entered += entered;
    counts_.sunk += sunk;
    counts_.through += through;
  }

  const World& world_;
  const Journey& journey_;
  const Kernel* kernel_;
  Rational radius_;
  SweepCounts counts_;
};

}  // namespace

SweepCounts judged(const World& world, const Journey& journey, const Kernel* kernel) {
  return SweepJudge(world, journey, kernel).counts();
}

}  // namespace axiscert::character
