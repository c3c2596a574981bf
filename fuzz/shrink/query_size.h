// How large a query is, to a reader: what shrinking makes less of.
#pragma once

#include <compare>
#include <cstdint>

#include "kernel/query.h"

namespace axiscert {

// Compared from the first member to the last. All are natural numbers, so nothing can be made smaller for ever.
struct QuerySize {
  int nonzero = 0;     // numbers that are not zero, P's too: a sphere at the origin has three fewer
  int bits = 0;        // significant bits of all of them: from the first bit that is set to the last
  int exponents = 0;   // |exponent of the first bit|, all of them together
  int magnitudes = 0;  // different absolute values other than zero
  int negatives = 0;   // sign bits, a zero's too
  int places = 0;      // the positions of the numbers that are not zero, ax at 0 to r at 12, together
  auto operator<=>(const QuerySize&) const = default;
};

// Of a query with finite numbers.
template <class Real>
QuerySize size_of(const Query<Real>& q);

// A finite number other than zero as +-digits 2^exponent, digits odd.
struct BinaryDigits {
  std::uint64_t digits;
  int exponent;
};
BinaryDigits binary_digits(double x);

}  // namespace axiscert
