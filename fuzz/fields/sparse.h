// Counts under many names, most of them zero: JSON has the others.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>

namespace axiscert {

// `Rule` has `size`, `name(i)` and `about`.
template <class Rule>
struct SparseCounts : std::array<std::uint64_t, Rule::size> {
  std::uint64_t sum() const { return std::accumulate(this->begin(), this->end(), std::uint64_t{0}); }
  void merge(const SparseCounts& other) {
    for (std::size_t i = 0; i < Rule::size; ++i) (*this)[i] += other[i];
  }
  void put(auto& encoder) const {
    for (const std::uint64_t count : *this) encoder.put(count);
  }
  void get(auto& decoder) {
    for (std::uint64_t& count : *this) decoder.get(count);
  }
};

}  // namespace axiscert
