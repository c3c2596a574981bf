// How far a sphere may move before it meets the ground: by the verdict of the twenty axes, or by what a kernel says.
#pragma once

#include <memory>
#include <optional>
#include <span>

#include "examples/character/sweeps/grid.h"
#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert::character {

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
