// Counter-based random numbers: Philox4x32-10, keyed by the seed. Any machine makes the same query from the same
// address.
#pragma once

#include <Random123/philox.h>

#include <cstdint>
#include <string_view>

#include "kernel/names.h"

namespace axiscert {
// The key of the random numbers of one generator: the seed, its name, version and precision.

// FNV-1a, 64 bits: identifies a generator.
constexpr std::uint64_t name_hash(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : text) hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  return hash;
}

// The part of the Philox key and counter that the streams of one generator share. Philox is a bijection of its counter
// for each key, so that two addresses of one seed share no block unless their counters are equal. The key is the seed,
// low word first; the counter's words are
//   0  position, low                    1  position, high
//   2  the halves of the name's hash, exclusive or      3  block number | version << 20 | precision << 31
// Names that give the same word 2 would give the same numbers: a predicate checks that the families' words differ. A
// mesh is named by the SHA-256 of its file, and has the same word as another by chance, once in 2^32, which does no
// harm.
struct StreamName {
  std::uint64_t seed;
  std::uint32_t generator, kind;  // words 2 and 3, for block 0

  // `hash` is name_hash of the generator's name; versions are below 2^11.
  constexpr StreamName(std::uint64_t seed_of_run, std::uint64_t hash, int version, Precision precision)
      : seed(seed_of_run),
        generator(static_cast<std::uint32_t>(hash ^ (hash >> 32))),
        kind((static_cast<std::uint32_t>(version) & 0x7ffu) << 20 | static_cast<std::uint32_t>(precision) << 31) {}
};

// The random numbers of one query. Every function advances the stream; only integers and exact scalings are used, so
// the values are the same on every machine. Words have 32 bits; after 2^22 of them the stream repeats.
class Stream {
 public:
  // `position` is unit * 2^16 + index.
  Stream(const StreamName& name, std::uint64_t position)
      : counter_{{static_cast<std::uint32_t>(position), static_cast<std::uint32_t>(position >> 32), name.generator,
                  name.kind}},
        key_{{static_cast<std::uint32_t>(name.seed), static_cast<std::uint32_t>(name.seed >> 32)}} {}
  Stream(std::uint64_t seed, std::uint64_t generator, int version, Precision precision, std::uint64_t position)
      : Stream(StreamName(seed, generator, version, precision), position) {}

  std::uint32_t word() {
    if (used_ == 4) {
      block_ = r123::Philox4x32()(counter_, key_);
      counter_[3] = (counter_[3] & ~block_mask) | ((counter_[3] + 1) & block_mask);
      used_ = 0;
    }
    return block_[used_++];
  }
  // Two words, the high one first.
  std::uint64_t bits() {
    const std::uint64_t high = word();
    return high << 32 | word();
  }
  // Uniform in [0, n), n > 0: the high part of a product with one word if n <= 2^32, otherwise with two. No value's
  // probability differs from 1 / n by more than 2^-32 (2^-64); this is part of the definition.
  std::uint64_t below(std::uint64_t n) {
    if (n <= std::uint64_t{1} << 32) return (word() * n) >> 32;
    return static_cast<std::uint64_t>((static_cast<unsigned __int128>(bits()) * n) >> 64);
  }
  // Uniform integer in [low, high].
  std::int64_t integer(std::int64_t low, std::int64_t high) {
    return low + static_cast<std::int64_t>(below(static_cast<std::uint64_t>(high - low) + 1));
  }
  bool coin() { return (word() >> 31) != 0; }
  // Uniform multiples of u in [0, 1) and, with a sign, in (-1, 1): full significands, from one word (binary64: two).
  // The significand is the highest bits, the sign the lowest.
  template <class Real>
  Real unit() {
    if constexpr (sizeof(Real) == 4) return static_cast<Real>(word() >> 8) * Real(0x1p-24);
    else return static_cast<Real>(bits() >> 11) * Real(0x1p-53);
  }
  template <class Real>
  Real symmetric() {
    if constexpr (sizeof(Real) == 4) {
      const std::uint32_t w = word();
      const Real x = static_cast<Real>(w >> 8) * Real(0x1p-24);
      return (w & 1u) != 0 ? -x : x;
    } else {
      const std::uint64_t w = bits();
      const Real x = static_cast<Real>(w >> 11) * Real(0x1p-53);
      return (w & 1u) != 0 ? -x : x;
    }
  }

 private:
  static constexpr std::uint32_t block_mask = (1u << 20) - 1;
  r123::Philox4x32::ctr_type counter_, block_{};
  r123::Philox4x32::key_type key_;
  unsigned used_ = 4;
};

}  // namespace axiscert
