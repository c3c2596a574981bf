// The exact signs of the sixteen published comparisons of one query.
#pragma once

#include "kernel/names.h"

namespace axiscert {

// Bit i is comparison i; none is in both.
struct Signs {
  ComparisonBits strict;  // lhs > rhs
  ComparisonBits ties;    // lhs == rhs
  bool operator==(const Signs&) const = default;
};

}  // namespace axiscert
