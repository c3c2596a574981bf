// SplitMix64 (Steele, Lea and Flood, "Fast splittable pseudorandom number generators", 2014): random words from a state
// of 64 bits, the same on every machine.
#pragma once

#include <cstdint>

namespace axiscert {

inline constexpr std::uint64_t golden_gamma = 0x9e3779b97f4a7c15u;

// A bijection of 64 bits in which every bit reaches every other.
constexpr std::uint64_t mixed(std::uint64_t z) {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
  return z ^ (z >> 31);
}

// Advances the state.
constexpr std::uint64_t split_mix(std::uint64_t& state) { return mixed(state += golden_gamma); }

}  // namespace axiscert
