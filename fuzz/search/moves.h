// The moves of a search from one query to the next, and the random numbers that they are drawn from.
#pragma once

#include <limits>

#include "fuzz/queries/query_shape.h"
#include "fuzz/queries/random.h"
#include "kernel/base/split_mix.h"
#include "kernel/query.h"

namespace axiscert {
// The random numbers of a search, which uses about a dozen for every query that it tries. SplitMix64 is an order of
// magnitude faster than the counter-based stream that seeds it, and equally independent of the machine.
class Dice {
 public:
  explicit Dice(Stream& seed) : state_(seed.bits()) {}

  std::uint64_t bits() { return split_mix(state_); }
  // Uniform below n, which is at most 2^32.
  std::uint64_t below(std::uint64_t n) { return ((bits() >> 32) * n) >> 32; }
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(static_cast<std::uint64_t>(
                     (static_cast<unsigned __int128>(bits()) * (static_cast<std::uint64_t>(high - low) + 1)) >> 64));
  }
  bool coin() { return (bits() >> 63) != 0; }
  // A multiple of u in (-1, 1).
  template <class Real>
  Real symmetric() {
    constexpr int digits = std::numeric_limits<Real>::digits;
    const std::uint64_t w = bits();
    const Real x = static_cast<Real>(w >> (64 - digits)) / static_cast<Real>(std::uint64_t{1} << digits);
    return (w & 1u) != 0 ? -x : x;
  }

 private:
  std::uint64_t state_;
};

// The moves of a search that turn the axes of a box. Only sums and products: the same everywhere.

// The axes of one box: those of another one of this query or of the other's; two of them exchanged, or one reversed; or
// turned about one of them by an angle of up to 1, down to 2^-digits. Precondition: the shape has a frame.
template <class Real>
void move_frame(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other);

// The moves of a search from one query to the next. Only integers, sums, products and quotients: the same everywhere.

// Brings a query to where wrong verdicts are looked for: every number finite and at most 2^8 in magnitude, so that
// formulae of degree 6 keep to the normal numbers, lengths not negative, and the greatest number at least 1/2 unless
// all are zero. The axes of a box that are not a rotation but for roundings are made one, since no predicate of boxes
// is right for others.
template <class Real>
void settle(const QueryShape& shape, Numbers<Real>& q);

// One random move: numbers changed by ulps, random low bits, exponents, signs; numbers copied, swapped or replaced; the
// whole scene moved to a new centre, with the translated vertices unchanged; vertices, directions, axes of the box,
// blends with `other`; the axes of a box turned a little, or taken from the other box. The result is not settled.
template <class Real>
void move(Dice& random, const QueryShape& shape, Numbers<Real>& q, const Numbers<Real>& other);

// Moves one number by `ulps` steps, for refining the least significant bits of a result; negative steps go downwards.
template <class Real>
Real moved_by_ulps(Real x, std::int64_t ulps);

}  // namespace axiscert
