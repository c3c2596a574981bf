// What a kernel says of a walk that it did not steer, held against the certified answers.
#pragma once

#include "examples/character/walk.h"
#include "kernel/kernel.h"

namespace axiscert::character {

// Of the walk itself, by moment.
struct Asked {
  std::uint64_t spheres = 0, triangles = 0, contacts = 0;
  std::uint64_t touching = 0;      // contacts at exactly the distance r
  std::uint64_t without_area = 0;  // contacts with a triangle without area
};
using AskedByMoment = std::array<Asked, moment_count>;
AskedByMoment asked(const Ground& ground, const Walk& walk);

// An answer that is neither contact nor separated counts as no contact. Where the sphere touches exactly, a kernel is
// held to what it declares of touching; with Touching::either nothing that it says is wrong.
struct Wrong {
  std::size_t ask;
  std::uint32_t triangle;
  bool missed;   // else invented
  double depth;  // exact/sphere_triangle/measures/depth.h
};

struct Errors {
  std::uint64_t missed = 0, invented = 0;
  double deepest_missed = 0, deepest_invented = 0;

  void add(const Wrong& wrong);
};
// Of one moment.
struct Tally {
  Errors errors;
  std::uint64_t lost = 0;     // spheres that touch, and the kernel finds nothing that they touch
  std::uint64_t phantom = 0;  // spheres that touch nothing, and the kernel finds something
};

struct Comparison {
  std::string kernel;
  Touching touching;
  std::array<Tally, moment_count> tallies;
  Tally all;
  Errors with_area, without_area;  // by the triangle
  std::vector<Wrong> wrong;        // in the order of the walk
  std::vector<std::size_t> lost;   // the asks at rest
};

// CGAL's exact distance confirms that each answer is wrong; HarnessFault where it does not.
Comparison compared(const Ground& ground, const Walk& walk, const Kernel& kernel);

}  // namespace axiscert::character
