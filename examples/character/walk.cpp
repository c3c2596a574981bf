#include "examples/character/walk.h"

#include <fmt/format.h>

#include <cmath>
#include <optional>

#include "fuzz/queries/random.h"
#include "kernel/base/error.h"

namespace axiscert::character {
namespace {

constexpr int pushes = 8;                 // most pushes out of triangles per step
constexpr int directions = 8;             // directions tried for a step before the character is set down elsewhere
constexpr int places = 256;               // places tried to stand on
constexpr std::uint64_t patience = 48;    // steps allowed to move two radii away; after that the character is set down
                                          // elsewhere
constexpr double least_slope = 0.5;       // cosine of the steepest ground
constexpr double least_progress = 0.125;  // share of a stride: less progress means a wall

class Character {
 public:
  Character(const Ground& ground, const WalkOptions& options)
      : ground_(ground),
        options_(options),
        up_(ground.up()),
        numbers_(options.seed, name_hash("character"), 1, Precision::binary32),
        random_(numbers_, 0) {}

  Walk walk() {
    Place place = set_down(), before = place;
    face_anywhere();
    for (std::uint64_t step = 0; step < options_.steps; ++step) {
      random_ = Stream(numbers_, step + 1);
      std::optional<Place> next;
      for (int tried = 0; tried < directions && !next; ++tried) {
        turn();
        next = ahead(place);
        if (next) break;
        ++walk_.turns;
        face_anywhere();
      }
      if (next) stand(*next);
      place = next ? *next : set_down();
      if (step % patience != patience - 1) continue;
      if (is_near(before, place)) place = set_down();
      before = place;
    }
    return std::move(walk_);
  }

 private:
  using Place = std::array<float, 3>;

  Sphere sphere(const Place& p) const { return {{p[0], p[1], p[2]}, options_.radius}; }
  static Place rounded(const Point& p) {
    return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
  }
  static Point exact(const Place& p) { return {p[0], p[1], p[2]}; }
  Place lowered(Place p, double by) const {
    p[up_] = static_cast<float>(double(p[up_]) - by);
    return p;
  }

  bool is_near(const Place& p, const Place& q) const {
    double square = 0;
    for (std::size_t k = 0; k < 3; ++k) square += (double(p[k]) - q[k]) * (double(p[k]) - q[k]);
    return square < 4 * double(options_.radius) * double(options_.radius);
  }

  // The narrow phase over the candidates of the broad phase: the number of contacts of the closed sphere.
  std::size_t contacts(const Place& p, Moment moment) {
    const Sphere s = sphere(p);
    const float numbers[4] = {s.centre.x, s.centre.y, s.centre.z, s.radius};
    ground_.broad_phase().candidates(s, candidates_);
    const std::size_t first = walk_.triangles.size(), count = candidates_.size();
    walk_.asks.push_back({s, moment, first, count});
    walk_.triangles.insert(walk_.triangles.end(), candidates_.begin(), candidates_.end());
    walk_.closed.resize(first + count);
    walk_.open.resize(first + count);
    const axiscert_mesh_f32 mesh = ground_.mesh();
    hits_.resize(count);
    const axiscert_results open{walk_.open.data() + first, nullptr, nullptr};
    axiscert_mesh_list_f32(numbers, &mesh, candidates_.data(), count, AXISCERT_OPEN_SPHERE, &open);
    const axiscert_results closed{walk_.closed.data() + first, nullptr, hits_.data()};
    hits_.resize(
        axiscert_mesh_list_f32(numbers, &mesh, candidates_.data(), count, AXISCERT_CLOSED_SPHERE, &closed).contacts);
    return hits_.size();
  }

  // The direction from a hit's nearest point to the centre, of length 1, and the distance between the two.
  struct Way {
    Point direction;
    double distance;
  };
  Way way_from(std::uint32_t triangle, const Place& p) const {
    const Point near = nearest_point(ground_.triangle(triangle), exact(p));
    Point way = {p[0] - near[0], p[1] - near[1], p[2] - near[2]};
    const double length = std::sqrt((way[0] * way[0] + way[1] * way[1]) + way[2] * way[2]);
    for (std::size_t k = 0; k < 3; ++k) way[k] = length > 0 ? way[k] / length : k == up_;
    return {way, length};
  }
  bool is_held(const Place& p) const {
    for (const std::uint32_t hit : hits_) {
      if (way_from(hit, p).direction[up_] >= least_slope) return true;
    }
    return false;
  }

  // Pushes p out of the triangle in which the sphere is deepest, until by the exact answer it penetrates none, or
  // rounding prevents it.
  Place slid(Place p) {
    contacts(p, Moment::move);
    for (int push = 0; push < pushes; ++push) {
      const Ask& asked = walk_.asks.back();
      std::optional<Way> deepest;
      for (std::size_t i = 0; i < asked.count; ++i) {
        if (walk_.open[asked.first + i] != AXISCERT_CONTACT) continue;
        const Way way = way_from(walk_.triangles[asked.first + i], p);
        if (!deepest || way.distance < deepest->distance) deepest = way;
      }
      if (!deepest) break;
      Point to = exact(p);
      for (std::size_t k = 0; k < 3; ++k) to[k] += deepest->direction[k] * (options_.radius - deepest->distance);
      const Place out = rounded(to);
      if (out == p) break;
      p = out;
      contacts(p, Moment::slide);
    }
    return p;
  }

  // Falls from p, by at most `reach`, to a float with a contact whose next float above has none; returns p if it has a
  // contact, and nothing if no position tried, every half radius, has one.
  std::optional<Place> fallen(Place p, double reach) {
    if (contacts(p, Moment::fall) > 0) return p;
    for (double depth = options_.radius * 0.5; depth <= reach; depth += options_.radius * 0.5) {
      Place low = lowered(p, options_.radius * 0.5);
      if (contacts(low, Moment::fall) == 0) {
        p = low;
        continue;
      }
      for (;;) {
        const Place middle = lowered(p, (double(p[up_]) - low[up_]) / 2);
        if (middle == p || middle == low) return low;
        if (contacts(middle, Moment::fall) > 0) low = middle;
        else p = middle;
      }
    }
    return std::nullopt;
  }

  std::optional<Place> held(const std::optional<Place>& p) {
    if (!p) return std::nullopt;
    contacts(*p, Moment::fall);
    return is_held(*p) ? p : std::nullopt;
  }

  std::optional<Place> ahead(const Place& from) {
    const double stride = options_.radius * 0.5;
    Point there = exact(from);
    there[(up_ + 1) % 3] += heading_[0] * stride;
    there[(up_ + 2) % 3] += heading_[1] * stride;
    const Place to = slid(rounded(there));
    const double along = (double(to[(up_ + 1) % 3]) - from[(up_ + 1) % 3]) * heading_[0] +
                         (double(to[(up_ + 2) % 3]) - from[(up_ + 2) % 3]) * heading_[1];
    if (along < stride * least_progress) return std::nullopt;
    return held(fallen(to, 2 * double(options_.radius)));
  }

  // Starts above the middle of a triangle, beyond the top of the mesh, and falls.
  Place set_down() {
    const double reach = (ground_.high()[up_] - ground_.low()[up_]) + 8 * double(options_.radius);
    for (int tried = 0; tried < places; ++tried) {
      const std::size_t t = random_.below(ground_.size());
      Point place = {};
      for (const Vec3<float>& v : ground_.triangle(t)) {
        const Point at = point(v);
        for (std::size_t k = 0; k < 3; ++k) place[k] += at[k] / 3;
      }
      place[up_] = ground_.high()[up_] + 2 * double(options_.radius);
      if (const auto found = held(fallen(rounded(place), reach))) {
        walk_.paths.emplace_back();
        stand(*found);
        return *found;
      }
    }
    throw Error(
        fmt::format("nothing to stand on along the axis {}: a sphere of radius {} fell past {} triangles or "
                    "found them steeper than 60 degrees; try another --up or --radius",
                    "xyz"[up_], options_.radius, places));
  }

  void stand(const Place& p) {
    walk_.rests.push_back(walk_.asks.size());
    contacts(p, Moment::rest);
    walk_.paths.back().push_back(sphere(p).centre);
  }

  void face_anywhere() {
    for (;;) {
      const double x = random_.symmetric<double>(), y = random_.symmetric<double>();
      const double square = x * x + y * y;
      if (square > 1 || square < 0x1p-10) continue;
      heading_ = {x / std::sqrt(square), y / std::sqrt(square)};
      return;
    }
  }
  // Turns by up to 2 atan(1/16), 7 degrees, to either side, without library cosines, which are not the same everywhere.
  void turn() {
    const double t = random_.symmetric<double>() / 16;
    const double scale = 1 / (1 + t * t), cosine = (1 - t * t) * scale, sine = 2 * t * scale;
    heading_ = {heading_[0] * cosine - heading_[1] * sine, heading_[0] * sine + heading_[1] * cosine};
  }

  const Ground& ground_;
  WalkOptions options_;
  std::size_t up_;
  StreamName numbers_;
  Stream random_;
  std::array<double, 2> heading_ = {1, 0};
  std::vector<std::uint32_t> candidates_, hits_;
  Walk walk_;
};

}  // namespace

Walk walked(const Ground& ground, const WalkOptions& options) { return Character(ground, options).walk(); }

}  // namespace axiscert::character
