// The distance at which a query touches, for tests of which the answer depends on a radius: what a critical radius is
// measured from.
#pragma once

#include <vector>

#include "exact/numbers/rational.h"
#include "kernel/test.h"

namespace axiscert {

struct CriticalDistance {
  const TestDescription& test;
  std::size_t radius;                                 // the column of the radius, in the first entry
  Rational (*squared)(const Numbers<double>& query);  // exact, for finite numbers; the radius is not read
};

// The tests that have one.
std::vector<const TestDescription*> tests_with_critical_distance();
// Throws HarnessFault for a test that has none.
CriticalDistance critical_distance_of(const TestDescription& test);

}  // namespace axiscert
