// The distance at which a query touches, for tests of which the answer depends on a radius: what a critical radius is
// measured from. Of two boxes the radius is the half extent of A's first axis, and the distance that at which they
// touch.
#pragma once

#include <optional>
#include <vector>

#include "exact/numbers/rational.h"
#include "kernel/test.h"

namespace axiscert {

struct CriticalDistance {
  const TestDescription& test;
  std::size_t radius;  // the column of the radius
  // Exact, for finite numbers; the radius is not read. Empty for what is no query with any radius, or touches at none.
  std::optional<Rational> (*squared)(const Numbers<double>& query);
};

// The tests that have one.
std::vector<const TestDescription*> tests_with_critical_distance();
// Whether the answer depends on the radius of a sphere, which may grow; the half extent of a box, which has a critical
// value too, is none.
bool has_sphere_radius(const TestDescription& test, std::size_t entry);
// Throws HarnessFault for a test that has none.
CriticalDistance critical_distance_of(const TestDescription& test, std::size_t entry = 0);

}  // namespace axiscert
