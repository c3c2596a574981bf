// A sphere that moves by sweeps: each of its steps is a motion, stopped at the first contact. It records every motion.
#pragma once

#include "examples/character/sweeper.h"

namespace axiscert::character {

// The errand of the sphere.
enum class Errand : std::uint8_t {
  walk,    // a character: a stride ahead, sliding along what it meets, then down to the ground
  fall,    // dropped from above the mesh, at once to below it, above a point of a triangle, an edge or a vertex
  bullet,  // shot from outside at such a point, at once to the other side
};
inline constexpr std::array<std::string_view, 3> errand_names = {"walk", "fall", "bullet"};

// The purpose of a motion.
enum class Purpose : std::uint8_t { drop, stride, slide, descend, shot };
inline constexpr std::array<std::string_view, 5> purpose_names = {"drop", "stride", "slide", "descend", "shot"};

struct Motion {
  Purpose purpose;
  Steps from, by, made;      // `made` is the displacement until it stopped
  std::size_t first, count;  // range of the triangles and answers below
};

struct Journey {
  Grid grid;
  std::vector<Motion> motions;
  std::vector<std::uint32_t> triangles;  // the candidates of the broad phase, motion by motion
  std::vector<SweeperAnswer> said;       // by the sweeper, of each
  std::uint64_t turns = 0;               // strides that got nowhere
  std::uint64_t set_down = 0;            // times that a walk began anew
  std::uint64_t left = 0;                // of these because the sphere had walked off the mesh, or fallen through it
};

struct JourneyOptions {
  Errand errand = Errand::walk;
  std::uint64_t seed = 1;
  std::uint64_t steps = 2000;  // strides, falls or bullets
  float radius = 0;            // greater than 0
  double stride = 0.5;         // radii
  double skin = 0x1p-6;        // radii: how far from a wall a slide leads, and an engine's form stops
};

// The same random numbers for every sweeper: all falls and bullets are the same motions.
Journey journey(const Ground& ground, Sweeper& sweeper, const JourneyOptions& options);

}  // namespace axiscert::character
