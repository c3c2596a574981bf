// The key of the random numbers of one generator: the seed, its name, version and precision.
#pragma once

#include <cstdint>
#include <string_view>

#include "kernel/names.h"

namespace axiscert {

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

}  // namespace axiscert
