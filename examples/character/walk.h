// A sphere moves and slides over the ground, as the character of a game does, and records every question that it asked.
//
// A step goes half a radius ahead; pushes the sphere out of what it penetrates, away from the nearest point; and lets
// it fall to a float at which it touches the ground and above which it does not. Where the ground is too steep, or the
// way leads over a drop, the character turns. Contact is always decided by the certified predicate; directions are
// rounded.
#pragma once

#include <cstdint>
#include <string_view>

#include "examples/character/ground.h"

namespace axiscert::character {

// The purpose for which a sphere was asked.
enum class Moment : std::uint8_t {
  fall,   // on the way down, and halving the last interval between contact and none
  move,   // the place where the step leads
  slide,  // pushed out of what it penetrated
  rest,   // the place where it stands after the step
};
inline constexpr std::size_t moment_count = 4;
inline constexpr std::array<std::string_view, moment_count> moment_names = {"fall", "move", "slide", "rest"};

struct Ask {
  Sphere sphere;
  Moment moment;
  std::size_t first, count;  // range of the triangles and verdicts below
};

struct Walk {
  std::vector<Ask> asks;
  std::vector<std::uint32_t> triangles;         // the candidates of the broad phase, ask by ask
  std::vector<std::uint8_t> closed, open;       // an axiscert_verdict for each triangle: touching counts as contact, or
                                                // does not
  std::vector<std::size_t> rests;               // the asks of the moment `rest`, in order
  std::vector<std::vector<Vec3<float>>> paths;  // centres at rest; a new path begins where the character was set down
                                                // again
  std::uint64_t turns = 0;                      // attempts in a direction that was blocked
};

struct WalkOptions {
  std::uint64_t seed = 1;
  std::uint64_t steps = 2000;
  float radius = 0;  // greater than 0
};

// Throws Error if there is nothing to stand on.
Walk walked(const Ground& ground, const WalkOptions& options);

}  // namespace axiscert::character
