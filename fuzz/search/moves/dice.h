// The random numbers of a search, which uses about a dozen for every query that it tries: SplitMix64 (Steele, Lea and
// Flood, "Fast splittable pseudorandom number generators", 2014). It is an order of magnitude faster than the
// counter-based stream that seeds it, and equally independent of the machine.
#pragma once

#include <limits>

#include "fuzz/queries/random.h"

namespace axiscert {

class Dice {
 public:
  explicit Dice(Stream& seed) : state_(seed.bits()) {}

  std::uint64_t bits() {
    state_ += 0x9e3779b97f4a7c15u;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
  }
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

}  // namespace axiscert
