// The size of a query to a reader, which shrinking reduces.
#pragma once

#include <compare>
#include <cstdint>

#include "kernel/query.h"

namespace axiscert {

// Compared from the first member to the last. All are natural numbers, so a sequence of decreasing sizes is finite.
struct QuerySize {
  int nonzero = 0;     // numbers that are not zero, including a sphere's centre: at the origin it has three fewer
  int bits = 0;        // significant bits of all of them: from the first set bit to the last
  int exponents = 0;   // the sum of |exponent of the first bit|
  int magnitudes = 0;  // different nonzero absolute values
  int negatives = 0;   // sign bits, including those of zeros
  int places = 0;      // the sum of the columns of the numbers that are not zero, the first at 0
  auto operator<=>(const QuerySize&) const = default;
};

// The size of a query of any predicate with finite numbers.
QuerySize size_of(const Numbers<float>& q);
QuerySize size_of(const Numbers<double>& q);

// A finite nonzero number as +-digits 2^exponent with odd digits.
struct BinaryDigits {
  std::uint64_t digits;
  int exponent;
};
BinaryDigits binary_digits(double x);

}  // namespace axiscert
