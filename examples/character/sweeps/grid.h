// Places of a sphere that moves by sweeps: multiples of a unit, so that nothing is rounded between two motions.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>

#include "examples/character/ground.h"
#include "kernel/base/error.h"

namespace axiscert::character {

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

}  // namespace axiscert::character
