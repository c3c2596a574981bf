// A sphere moves and slides over the ground, as the character of a game does, and keeps every question that it asked.
//
// A step: go half a radius ahead; push out of what the sphere sinks into, along the way from its nearest point; fall to
// a float at which the ground is touched and above which it is not. What is too steep or leads over a brink turns the
// character round. Whether there is contact is always what the certified predicate says; directions are rounded.
#pragma once

#include <cstdint>
#include <string_view>

#include "examples/character/ground.h"

namespace axiscert::character {

// What a sphere was asked for.
enum class Moment : std::uint8_t {
  fall,   // on the way down, and halving the last stretch between contact and none
  move,   // where the step leads
  slide,  // pushed out of what it sank into
  rest,   // where it stands after the step
};
inline constexpr std::size_t moment_count = 4;
inline constexpr std::array<std::string_view, moment_count> moment_names = {"fall", "move", "slide", "rest"};

struct Ask {
  Sphere sphere;
  Moment moment;
  std::size_t first, count;  // of the triangles and verdicts below
};

struct Walk {
  std::vector<Ask> asks;
  std::vector<std::uint32_t> triangles;         // that the broad phase left, ask by ask
  std::vector<std::uint8_t> closed, open;       // an axiscert_verdict for each: touching counts as contact, or not
  std::vector<std::size_t> rests;               // the asks of the moment `rest`, in order
  std::vector<std::vector<Vec3<float>>> paths;  // of centres at rest; another where the character was set down again
  std::uint64_t turns = 0;                      // steps in a direction in which there was no way
};

struct WalkOptions {
  std::uint64_t seed = 1;
  std::uint64_t steps = 2000;
  float radius = 0;  // more than 0
};

// Throws Error where there is nothing to stand on.
Walk walked(const Ground& ground, const WalkOptions& options);

}  // namespace axiscert::character
