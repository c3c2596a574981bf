// A kernel's answers on a walk that it did not steer, compared with the certified answers.
#pragma once

#include <span>

#include "examples/character/walk.h"
#include "kernel/kernel.h"

namespace axiscert::character {
// Counts of the walk itself, by moment.
struct WalkCounts {
  std::uint64_t spheres = 0, triangles = 0, contacts = 0;
  std::uint64_t touching = 0;      // contacts at exactly the distance r
  std::uint64_t without_area = 0;  // contacts with a triangle without area
};
using WalkCountsByMoment = std::array<WalkCounts, moment_count>;
WalkCountsByMoment asked(const Ground& ground, const Walk& walk);

// A wrong answer. An answer that is neither contact nor separated counts as no contact. Where the sphere touches
// exactly, a kernel's answer is compared with what it declares for touching; with Touching::either neither answer is
// wrong.
struct Wrong {
  std::size_t ask;
  std::uint32_t triangle;
  bool missed;   // otherwise invented
  double depth;  // as in exact/sphere_triangle/measures/depth.h
};

struct Errors {
  std::uint64_t missed = 0, invented = 0;
  double deepest_missed = 0, deepest_invented = 0;

  void add(const Wrong& wrong);
};
// The counts of one moment.
struct Tally {
  Errors errors;
  std::uint64_t lost = 0;     // spheres that touch something, where the kernel finds nothing
  std::uint64_t phantom = 0;  // spheres that touch nothing, where the kernel finds something
};

struct Comparison {
  std::string kernel;
  TouchingPolicy touching;
  std::array<Tally, moment_count> tallies;
  Tally all;
  Errors with_area, without_area;  // by whether the triangle has area
  std::vector<Wrong> wrong;        // in the order of the walk
  std::vector<std::size_t> lost;   // the asks at rest that lost their contact
};

// Compares the kernel with the walk. CGAL's exact distance confirms each wrong answer; throws HarnessFault where it
// does not.
Comparison compared(const Ground& ground, const Walk& walk, const Kernel& kernel);

// The walk and the comparisons as text.

std::string table(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons);

}  // namespace axiscert::character
