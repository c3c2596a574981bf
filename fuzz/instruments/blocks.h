// A plan's queries in blocks, which threads take one at a time.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace axiscert {

// The queries at positions first to first + size - 1 of a source.
struct QueryBlock {
  std::size_t source;
  std::uint64_t first, size;
};

// `trials` queries of each source, the sources one after the other.
inline std::vector<QueryBlock> blocks_of(std::size_t sources, std::uint64_t trials, std::uint64_t block_size) {
  std::vector<QueryBlock> blocks;
  for (std::size_t source = 0; source < sources; ++source) {
    for (std::uint64_t first = 0; first < trials; first += block_size) {
      blocks.push_back({source, first, std::min(block_size, trials - first)});
    }
  }
  return blocks;
}

}  // namespace axiscert
