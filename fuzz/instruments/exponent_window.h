// Exponents m of factors 2^m by which queries are scaled.
#pragma once

#include <limits>

#include "kernel/names.h"

namespace axiscert {

// Both ends included; of the factor of every number.
struct ExponentWindow {
  int low, high;
  int width() const { return high - low + 1; }
  bool operator==(const ExponentWindow&) const = default;
};

// All that are scanned. Numbers that are multiples of u below 2 can be scaled by them exactly: u 2^m must not be below
// the least subnormal number, and 2 2^m must not exceed the greatest power of two.
inline ExponentWindow scanned_exponents(Precision precision) {
  if (precision == Precision::binary32)
    return {std::numeric_limits<float>::min_exponent, std::numeric_limits<float>::max_exponent - 1};
  return {std::numeric_limits<double>::min_exponent, std::numeric_limits<double>::max_exponent - 1};
}

}  // namespace axiscert
