// How far a sphere may move before it meets the ground: by the verdict of the twenty axes, or by what a kernel says.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <memory>
#include <optional>
#include <span>

#include "examples/character/ground.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::character {
// Whether a moving sphere is clear of a triangle: the verdict of the twenty axes, never wrong.

// Whether the closed solid sphere has nowhere on its way a point in common with the closed triangle. For every query of
// finite numbers with r >= 0, of any area and displacement; exact, without a tolerance.
//
// The comparisons of moving-sphere/twenty-nonstrict over enclosures of binary64: an axis of which each comparison is
// certain separates, and where no axis can separate there is contact. What that leaves open is decided by the same
// comparisons over rationals. Over the reals an axis that separates does so rightly, and with `>=` in the sides one
// separates wherever there is no contact (docs/moving.md).
bool is_clear(const MovingQuery<float>& q);

// The two ways, for tests: the enclosures alone, empty where they are not certain, and the rationals alone.
enum class Clearance { clear, contact, open };
Clearance clearance_by_enclosures(const MovingQuery<float>& q);
bool is_clear_by_rationals(const MovingQuery<float>& q);

// Places of a sphere that moves by sweeps: multiples of a unit, so that nothing is rounded between two motions.

// A place, or a displacement, in units of the grid.
using Steps = std::array<std::int64_t, 3>;
inline Steps operator+(const Steps& u, const Steps& v) { return {u[0] + v[0], u[1] + v[1], u[2] + v[2]}; }
inline Steps operator-(const Steps& u, const Steps& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

// A motion leads from a place to a place. Both, and the displacement between them, are floats exactly: so the motion
// that a kernel is asked about is the one that is made, and the next begins where it ends.
class Grid {
 public:
  // The finest on which places with coordinates up to `reach`, > 0, are below 2^23 units, and displacements between two
  // of them below 2^24.
  explicit Grid(double reach) : exponent_(std::ilogb(reach) + 1 - 23) {}

  double unit() const { return std::ldexp(1.0, exponent_); }
  Point exact(const Steps& v) const { return {exact(v[0]), exact(v[1]), exact(v[2])}; }
  // Throws HarnessFault beyond the reach.
  Vec3<float> numbers(const Steps& v) const { return {number(v[0]), number(v[1]), number(v[2])}; }
  Steps nearest(const Point& p) const { return {nearest(p[0]), nearest(p[1]), nearest(p[2])}; }

 private:
  double exact(std::int64_t n) const { return std::ldexp(static_cast<double>(n), exponent_); }
  float number(std::int64_t n) const {
    if (std::abs(n) > std::int64_t{1} << 24) throw HarnessFault("a sphere that moves by sweeps has left its grid");
    return static_cast<float>(exact(n));
  }
  std::int64_t nearest(double x) const { return std::llround(std::ldexp(x, -exponent_)); }

  int exponent_;
};

// The sphere's radius is greater than 0.
struct World {
  const Ground& ground;
  Grid grid;
  float radius;

  MovingQuery<float> query(const Steps& from, const Steps& by, std::uint32_t triangle) const {
    const MeshTriangle& t = ground.triangle(triangle);
    return {t[0], t[1], t[2], grid.numbers(from), grid.numbers(by), radius};
  }
};

// A motion, and the triangles that it can meet.
struct Path {
  Steps from, by;
  std::span<const std::uint32_t> triangles;
};

// A kernel's answer about the whole motion and one triangle; the time is NaN where it gives none.
struct SweeperAnswer {
  bool contact;
  float time;
};

struct Stop {
  Steps made;                         // displacement until the sphere stops
  std::optional<std::uint32_t> wall;  // the triangle at which it stops; empty: it came to the end
};

class Sweeper {
 public:
  virtual ~Sweeper() = default;
  virtual std::string name() const = 0;
  virtual const Kernel* kernel() const { return nullptr; }  // that answers; null: is_clear() does
  // `said` gets an entry for each triangle of the path.
  virtual Stop stop(const World& world, const Path& path, std::vector<SweeperAnswer>& said) = 0;
};

// Stops by is_clear() at the last place on the way, found by halving, to which the motion is clear of every triangle.
// From a place that is clear of them the sphere never touches one, on the whole of its way.
std::unique_ptr<Sweeper> certain_sweeper();
// Stops by a kernel of moving-sphere in binary32: by the least time that it gives, less `skin`, a length, as engines
// do, at the nearest place; by a kernel that gives no times as above, with its verdicts.
std::unique_ptr<Sweeper> sweeper_by(const Kernel& kernel, double skin);

}  // namespace axiscert::character
