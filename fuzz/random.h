// Counter-based random numbers: Philox, keyed by an address. Any machine makes the same query from the same address.
#pragma once

#include <Random123/philox.h>

#include <cstdint>
#include <string_view>

#include "kernel/names.h"

namespace axiscert {

// FNV-1a, 64 bits: names a generator to Philox.
constexpr std::uint64_t name_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

// The random numbers of one query. Every function advances the stream; integers and exact scalings only, so the values
// are the same on every machine.
class Stream {
 public:
  // `generator` is name_hash of the family's name, `position` unit * 2^16 + index.
  Stream(std::uint64_t seed, std::uint64_t generator, int version, Precision precision, std::uint64_t position)
      : counter_{{0, position, static_cast<std::uint64_t>(version), static_cast<std::uint64_t>(precision)}},
        key_{{seed, generator}} {}

  std::uint64_t bits() {
    if (used_ == 4) {
      block_ = r123::Philox4x64()(counter_, key_);
      ++counter_[0];
      used_ = 0;
    }
    return block_[used_++];
  }
  // Uniform in [0, n), n > 0: the high half of a 64 x 64 bit product. Its bias, n / 2^64, is part of the definition.
  std::uint64_t below(std::uint64_t n) {
    return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits()) * n) >> 64);
  }
  // Uniform integer in [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  bool coin() { return (bits() >> 63) != 0; }
  // Uniform multiples of u in [0, 1) and, with a sign, in [-1, 1): full significands.
  template <class Real>
  Real unit() {
    if constexpr (sizeof(Real) == 4) return static_cast<Real>(bits() >> 40) * Real(0x1p-24);
    else return static_cast<Real>(bits() >> 11) * Real(0x1p-53);
  }
  template <class Real>
  Real symmetric() {
    const Real x = unit<Real>();
    return coin() ? -x : x;
  }

 private:
  r123::Philox4x64::ctr_type counter_, block_{};
  r123::Philox4x64::key_type key_;
  unsigned used_ = 4;
};

}  // namespace axiscert
