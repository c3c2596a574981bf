#include "examples/character/journey.h"

#include <algorithm>
#include <cmath>

#include "fuzz/queries/random.h"

namespace axiscert::character {
namespace {

constexpr int slides = 4;                 // most slides of a stride
constexpr std::uint64_t patience = 48;    // strides allowed to move two radii away, else it is set down elsewhere
constexpr double least_progress = 0.125;  // share of a stride: less means a wall
constexpr double beyond = 8;              // radii outside the mesh's box at which a sphere has left it
constexpr std::int64_t most_boxes = 64;   // in which the broad phase asks for a long motion

double dot(const Point& u, const Point& v) { return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]; }
Point sum(const Point& u, const Point& v, double times) {
  return {u[0] + v[0] * times, u[1] + v[1] * times, u[2] + v[2] * times};
}

class Traveller {
 public:
  Traveller(const Ground& ground, Sweeper& sweeper, const JourneyOptions& options)
      : sweeper_(sweeper),
        options_(options),
        ground_(ground),
        up_(ground.up()),
        diagonal_(std::sqrt(dot(extent(), extent()))),
        world_{ground, Grid(reach()), options.radius},
        numbers_(options.seed, name_hash("sweeps"), 1, Precision::binary32),
        random_(numbers_, 0),
        journey_{world_.grid, {}, {}, {}} {}

  Journey travel() {
    if (options_.errand == Errand::walk) begin_walk();
    for (std::uint64_t step = 0; step < options_.steps; ++step) {
      random_ = Stream(numbers_, step + 1);
      switch (options_.errand) {
        case Errand::walk:
          walk_on(step);
          break;
        case Errand::fall:
          drop();
          break;
        case Errand::bullet:
          shoot();
          break;
      }
    }
    return std::move(journey_);
  }

 private:
  Point extent() const { return sum(ground_.high(), ground_.low(), -1); }
  double radius() const { return double(options_.radius); }
  // No place is farther out: a bullet comes from 1.25 diagonals away, a walk ends `beyond` the box.
  double reach() const {
    double greatest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      greatest = std::max({greatest, std::abs(ground_.low()[k]), std::abs(ground_.high()[k])});
    }
    return greatest + 1.5 * diagonal_ + (2 * beyond + 2 * options_.stride) * radius();
  }

  // Moves from place_; returns the triangle at which the sphere stopped.
  std::optional<std::uint32_t> move(const Steps& by, Purpose purpose) {
    find_candidates(by);
    const Stop stop = sweeper_.stop(world_, {place_, by, candidates_}, said_);
    journey_.motions.push_back({purpose, place_, by, stop.made, journey_.triangles.size(), candidates_.size()});
    journey_.triangles.insert(journey_.triangles.end(), candidates_.begin(), candidates_.end());
    journey_.said.insert(journey_.said.end(), said_.begin(), said_.end());
    place_ = place_ + stop.made;
    return stop.wall;
  }

  // The broad phase in boxes along the way, their corners rounded outwards to places: no contact is left out.
  void find_candidates(const Steps& by) {
    std::int64_t longest = 0;
    for (const std::int64_t x : by) longest = std::max(longest, std::abs(x));
    const double radii = static_cast<double>(longest) * world_.grid.unit() / radius();
    const std::int64_t boxes = std::clamp<std::int64_t>(static_cast<std::int64_t>(radii / 4), 1, most_boxes);
    path_.clear();
    for (std::int64_t i = 0; i < boxes; ++i) {
      Steps low, high;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::int64_t one = by[k] * i, other = by[k] * (i + 1);
        low[k] = place_[k] + (std::min(one, other) - (boxes - 1)) / boxes - 1;
        high[k] = place_[k] + (std::max(one, other) + (boxes - 1)) / boxes + 1;
      }
      path_.push_back({world_.grid.exact(low), world_.grid.exact(high)});
    }
    ground_.broad_phase().candidates(path_, options_.radius, candidates_);
  }

  // One stride ahead, sliding along what is met: what is left of the stride, without its part into the wall, and the
  // skin away from it.
  void stride() {
    const Point ahead = forward();
    Point rest = ahead;
    for (int slide = 0; slide <= slides; ++slide) {
      const Steps by = world_.grid.nearest(rest);
      if (by == Steps{} || dot(rest, ahead) <= 0) return;
      const Steps before = place_;
      const auto wall = move(by, slide == 0 ? Purpose::stride : Purpose::slide);
      if (!wall) return;
      rest = sum(rest, world_.grid.exact(place_ - before), -1);
      const Point away = direction_from(*wall);
      const double into = dot(rest, away);
      rest = sum(rest, away, options_.skin * radius() - std::min(into, 0.0));
    }
  }
  Point forward() const {
    Point ahead = {};
    ahead[(up_ + 1) % 3] = heading_[0] * options_.stride * radius();
    ahead[(up_ + 2) % 3] = heading_[1] * options_.stride * radius();
    return ahead;
  }
  // The direction from the triangle's nearest point to the centre, of length 1.
  Point direction_from(std::uint32_t triangle) const {
    const Point centre = world_.grid.exact(place_);
    Point away = sum(centre, nearest_point(ground_.triangle(triangle), centre), -1);
    const double length = std::sqrt(dot(away, away));
    for (std::size_t k = 0; k < 3; ++k) away[k] = length > 0 ? away[k] / length : k == up_;
    return away;
  }

  // Down to the ground, two radii at a time; not, once the sphere has left the mesh.
  void descend() {
    Point down = {};
    down[up_] = -2 * radius();
    while (!has_left()) {
      if (move(world_.grid.nearest(down), Purpose::descend)) return;
    }
  }
  bool has_left() const {
    const Point at = world_.grid.exact(place_);
    for (std::size_t k = 0; k < 3; ++k) {
      const double room = (k == up_ ? 2 : beyond) * radius();
      if (at[k] < ground_.low()[k] - room || (k != up_ && at[k] > ground_.high()[k] + room)) return true;
    }
    return false;
  }

  void walk_on(std::uint64_t step) {
    turn();
    const Point from = world_.grid.exact(place_), ahead = forward();
    stride();
    if (dot(sum(world_.grid.exact(place_), from, -1), ahead) < least_progress * dot(ahead, ahead)) {
      ++journey_.turns;
      face_anywhere();
    }
    descend();
    const bool left = has_left();
    journey_.left += left;
    const Point moved = sum(world_.grid.exact(place_), before_, -1);
    const bool is_stuck = step % patience == patience - 1 && dot(moved, moved) < 4 * radius() * radius();
    if (left || is_stuck) begin_walk();
    else if (step % patience == patience - 1) before_ = world_.grid.exact(place_);
  }
  void begin_walk() {
    ++journey_.set_down;
    face_anywhere();
    drop();
    before_ = world_.grid.exact(place_);
  }

  // From two radii above the mesh, clear of it, to as far below.
  void drop() {
    Point at = target();
    at[up_] = ground_.high()[up_] + 2 * radius();
    place_ = world_.grid.nearest(at);
    Point down = {};
    down[up_] = -(extent()[up_] + 4 * radius());
    move(world_.grid.nearest(down), Purpose::drop);
  }

  // From 1.25 diagonals away, and so clear of the mesh, to as far beyond.
  void shoot() {
    const Point at = target(), way = any_direction();
    place_ = world_.grid.nearest(sum(at, way, 1.25 * diagonal_));
    move(world_.grid.nearest(sum({}, way, -2.5 * diagonal_)), Purpose::shot);
  }

  // The middle of a triangle or of an edge, or a vertex, up to half a radius away in each coordinate.
  Point target() {
    const MeshTriangle& t = ground_.triangle(random_.below(ground_.size()));
    const std::uint64_t kind = random_.below(3), first = random_.below(3);
    const std::size_t corners = 3 - kind;
    Point at = {};
    for (std::size_t i = 0; i < corners; ++i) {
      at = sum(at, point(t[(first + i) % 3]), 1.0 / static_cast<double>(corners));
    }
    for (std::size_t k = 0; k < 3; ++k) at[k] += random_.symmetric<double>() * 0.5 * radius();
    return at;
  }
  Point any_direction() {
    for (;;) {
      const double x = random_.symmetric<double>(), y = random_.symmetric<double>(), z = random_.symmetric<double>();
      const double length = std::sqrt(dot({x, y, z}, {x, y, z}));
      if (length <= 1 && length > 0x1p-5) return {x / length, y / length, z / length};
    }
  }
  void face_anywhere() {
    for (;;) {
      const double x = random_.symmetric<double>(), y = random_.symmetric<double>();
      const double length = std::sqrt(x * x + y * y);
      if (length > 1 || length < 0x1p-5) continue;
      heading_ = {x / length, y / length};
      return;
    }
  }
  // Turns by up to 2 atan(1/16), 7 degrees, to either side, without library cosines, which are not the same everywhere.
  void turn() {
    const double t = random_.symmetric<double>() / 16;
    const double scale = 1 / (1 + t * t), cosine = (1 - t * t) * scale, sine = 2 * t * scale;
    heading_ = {heading_[0] * cosine - heading_[1] * sine, heading_[0] * sine + heading_[1] * cosine};
  }

  Sweeper& sweeper_;
  JourneyOptions options_;
  const Ground& ground_;
  std::size_t up_;
  double diagonal_;
  World world_;
  StreamName numbers_;
  Stream random_;
  Journey journey_;
  Steps place_ = {};
  Point before_ = {};
  std::array<double, 2> heading_ = {1, 0};
  std::vector<CentreBox> path_;
  std::vector<std::uint32_t> candidates_;
  std::vector<SweeperAnswer> said_;
};

}  // namespace

Journey journey(const Ground& ground, Sweeper& sweeper, const JourneyOptions& options) {
  return Traveller(ground, sweeper, options).travel();
}

}  // namespace axiscert::character
