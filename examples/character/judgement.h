// The motions of a journey, judged exactly.
#pragma once

#include "examples/character/journey.h"
#include "exact/numbers/rational.h"

namespace axiscert::character {

struct SweepCounts {
  std::uint64_t motions = 0, stopped = 0;
  std::uint64_t triangles = 0;  // that a motion was asked about
  std::uint64_t contacts = 0;   // exactly, of these
  // Answers to the whole motion and one triangle. What a kernel does not promise, or touching that it does not count as
  // contact, is not counted.
  std::uint64_t missed = 0, phantom = 0;
  std::uint64_t late = 0, without_time = 0;  // of the contacts that it finds rightly
  // Motions as made. They entered a triangle where the sphere had a point in common with it and was nearer to it than
  // at the start, so that a sphere that leaves one is not counted again.
  std::uint64_t entered = 0;
  std::uint64_t sunk = 0;     // of these by more than a hundredth of the radius
  std::uint64_t through = 0;  // and those whose centre came to the triangle: it passed through
  Decimal6 deepest;           // (r - least distance) / r
};

// Answers by is_clear(), which the rational oracle confirms: for each contact, and for every 64th triangle without one.
// Throws HarnessFault where it does not, and where a journey by is_clear() entered a triangle.
SweepCounts judged(const World& world, const Journey& journey, const Kernel* kernel);

}  // namespace axiscert::character
