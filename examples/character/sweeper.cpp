#include "examples/character/sweeper.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "exact/judge/trait.h"
#include "exact/numbers/enclosed.h"
#include "kernel/ask.h"
#include "kernel/moving_sphere/names.h"
#include "kernel/moving_sphere/twenty.h"

namespace axiscert::character {
namespace {

// An enclosure as a number type of the formulae: a comparison holds where it is certain.
struct Certain {
  EnclosedNumber<double> x{0, 0};

  Certain() = default;
  explicit Certain(double value) : x{value, 0} {}
  explicit Certain(const EnclosedNumber<double>& enclosed) : x(enclosed) {}

  bool is_zero() const { return x.value == 0 && x.error == 0; }
  friend Certain operator+(const Certain& a, const Certain& b) { return Certain(a.x + b.x); }
  friend Certain operator-(const Certain& a, const Certain& b) { return Certain(a.x - b.x); }
  // A product with an exact zero is one, as it is on floors that are at right angles to an axis.
  friend Certain operator*(const Certain& a, const Certain& b) {
    return a.is_zero() || b.is_zero() ? Certain() : Certain(a.x * b.x);
  }
  friend bool operator>(const Certain& a, const Certain& b) { return a.x.low() > b.x.high(); }
  friend bool operator>=(const Certain& a, const Certain& b) { return a.x.low() >= b.x.high(); }
};

template <class T>
MovingQuery<T> as_numbers(const MovingQuery<float>& q) {
  const Numbers<float> numbers = q;
  return MovingSphere::problem<T>([&](std::size_t k) { return T(double(numbers[k])); });
}

bool separates(ComparisonBits holds) { return verdict_of(moving_sphere_predicate(), holds) == Verdict::separated; }

}  // namespace

Clearance clearance_by_enclosures(const MovingQuery<float>& q) {
  ComparisonBits possible = 0;
  const auto see = [&](std::size_t i, const Certain& lhs, const Certain& rhs) {
    if (!(lhs.x.high() < rhs.x.low())) possible |= one_bit<ComparisonBits>(i);  // NaN: possible
  };
  const ComparisonBits certain = bits_of<moving_sphere::TwentyNonstrict, Certain>(as_numbers<Certain>(q), see);
  if (separates(certain)) return Clearance::clear;
  return separates(possible) ? Clearance::open : Clearance::contact;
}

bool is_clear_by_rationals(const MovingQuery<float>& q) {
  const auto ignore = [](std::size_t, const ExactNumber&, const ExactNumber&) {};
  return separates(bits_of<moving_sphere::TwentyNonstrict, ExactNumber>(as_numbers<ExactNumber>(q), ignore));
}

bool is_clear(const MovingQuery<float>& q) {
  const Clearance quick = clearance_by_enclosures(q);
  return quick == Clearance::open ? is_clear_by_rationals(q) : quick == Clearance::clear;
}

namespace {

constexpr float no_time = std::numeric_limits<float>::quiet_NaN();

double length(const Point& v) { return std::sqrt((v[0] * v[0] + v[1] * v[1]) + v[2] * v[2]); }

// Places on the way by halving: share / 2^whole_bits of the displacement, to the nearest place. The displacement is
// below 2^24 units, so its product with a share fits.
constexpr int whole_bits = 24;
constexpr std::int64_t whole = std::int64_t{1} << whole_bits;
Steps part_of(const Steps& by, std::int64_t share) {
  Steps part;
  for (std::size_t k = 0; k < 3; ++k) part[k] = (by[k] * share + whole / 2) >> whole_bits;
  return part;
}

class ByVerdict : public Sweeper {
 public:
  // Halving keeps a share to which the motion is clear of the triangles in the way and one to which it is not; that
  // there might be clear ones beyond does not matter. A place beside the straight way may meet a triangle that the
  // whole motion does not: that one is then in the way too, and it is halved again.
  Stop stop(const World& world, const Path& path, std::vector<SweeperAnswer>& said) override {
    std::vector<std::uint32_t> in_the_way = contacts(world, path.from, path.by, path.triangles);
    said.clear();
    for (const std::uint32_t t : path.triangles) said.push_back({std::ranges::binary_search(in_the_way, t), no_time});
    if (in_the_way.empty()) return {path.by, std::nullopt};
    const auto met = [&](std::int64_t share, std::span<const std::uint32_t> triangles) {
      return contacts(world, path.from, part_of(path.by, share), triangles);
    };
    std::int64_t clear = 0, blocked = whole;
    for (;;) {
      while (part_of(path.by, clear) != part_of(path.by, blocked)) {
        const std::int64_t middle = (clear + blocked) / 2;
        if (middle == clear) break;
        (met(middle, in_the_way).empty() ? clear : blocked) = middle;
      }
      if (part_of(path.by, clear) == Steps{}) break;  // it does not move
      const std::vector<std::uint32_t> others = met(clear, path.triangles);
      if (others.empty()) break;
      in_the_way.insert(in_the_way.end(), others.begin(), others.end());
      blocked = std::exchange(clear, 0);
    }
    const Steps made = part_of(path.by, clear);
    return {made, nearest_of(world, path.from + made, met(blocked, in_the_way))};
  }

 private:
  // Those of the triangles, ascending as they are, with which the motion has contact.
  virtual std::vector<std::uint32_t> contacts(const World& world, const Steps& from, const Steps& by,
                                              std::span<const std::uint32_t> triangles) = 0;

  static std::uint32_t nearest_of(const World& world, const Steps& at, const std::vector<std::uint32_t>& triangles) {
    const Point centre = world.grid.exact(at);
    const auto distance = [&](std::uint32_t t) {
      const Point near = nearest_point(world.ground.triangle(t), centre);
      return length({near[0] - centre[0], near[1] - centre[1], near[2] - centre[2]});
    };
    return std::ranges::min(triangles, {}, distance);
  }
};

class ByClearance final : public ByVerdict {
 public:
  std::string name() const override { return "twenty, certain"; }

 private:
  std::vector<std::uint32_t> contacts(const World& world, const Steps& from, const Steps& by,
                                      std::span<const std::uint32_t> triangles) override {
    std::vector<std::uint32_t> met;
    for (const std::uint32_t t : triangles) {
      if (!is_clear(world.query(from, by, t))) met.push_back(t);
    }
    return met;
  }
};

// A kernel's answers to one motion and many triangles.
class Asked32 {
 public:
  explicit Asked32(const Kernel& kernel) : implementation_(kernel.on<float>(resolve_target("auto"))) {}

  const Reply<float>& answers(const World& world, const Steps& from, const Steps& by,
                              std::span<const std::uint32_t> triangles) {
    QueryBatch<float> batch(triangles.size(), moving_sphere_predicate().entries[0].columns.size());
    for (const std::uint32_t t : triangles) batch.push_back(world.query(from, by, t));
    if (triangles.empty()) reply_ = {};
    else ask(implementation_, batch.columns(), reply_);
    return reply_;
  }

 private:
  Implementation<float> implementation_;
  Reply<float> reply_;
};

class ByKernelsVerdict final : public ByVerdict {
 public:
  explicit ByKernelsVerdict(const Kernel& kernel) : kernel_(kernel), asked_(kernel) {}
  std::string name() const override { return kernel_.id; }
  const Kernel* kernel() const override { return &kernel_; }

 private:
  std::vector<std::uint32_t> contacts(const World& world, const Steps& from, const Steps& by,
                                      std::span<const std::uint32_t> triangles) override {
    const Reply<float>& reply = asked_.answers(world, from, by, triangles);
    std::vector<std::uint32_t> met;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
      if (reply.verdicts[i] == Verdict::contact) met.push_back(triangles[i]);
    }
    return met;
  }

  const Kernel& kernel_;
  Asked32 asked_;
};

class ByTime final : public Sweeper {
 public:
  ByTime(const Kernel& kernel, double skin) : kernel_(kernel), asked_(kernel), skin_(skin) {}
  std::string name() const override { return kernel_.id; }
  const Kernel* kernel() const override { return &kernel_; }

  // A contact without a time in [0, 1] stops nothing.
  Stop stop(const World& world, const Path& path, std::vector<SweeperAnswer>& said) override {
    const Reply<float>& reply = asked_.answers(world, path.from, path.by, path.triangles);
    said.clear();
    double first = 1;
    std::optional<std::uint32_t> wall;
    for (std::size_t i = 0; i < path.triangles.size(); ++i) {
      const bool contact = reply.verdicts[i] == Verdict::contact;
      const float time = contact ? reply.answers.measures[moving_sphere::time_measure][i] : no_time;
      said.push_back({contact, time});
      if (!(time >= 0 && time <= 1) || (wall && time >= first)) continue;
      first = time;
      wall = path.triangles[i];
    }
    if (!wall) return {path.by, std::nullopt};
    const Point by = world.grid.exact(path.by);
    const double share = std::max(first - skin_ / length(by), 0.0);
    return {world.grid.nearest({by[0] * share, by[1] * share, by[2] * share}), wall};
  }

 private:
  const Kernel& kernel_;
  Asked32 asked_;
  double skin_;
};

}  // namespace

std::unique_ptr<Sweeper> certain_sweeper() { return std::make_unique<ByClearance>(); }
std::unique_ptr<Sweeper> sweeper_by(const Kernel& kernel, double skin) {
  if (kernel.measure_count == 0) return std::make_unique<ByKernelsVerdict>(kernel);
  return std::make_unique<ByTime>(kernel, skin);
}

}  // namespace axiscert::character
