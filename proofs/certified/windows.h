// What the exact step takes for a query.
#pragma once

#include <cstdint>
#include <vector>

namespace axiscert::proofs::certified {

struct RecordedWindow {
  int bits;    // that the twelve coordinates span
  int widest;  // that it was allowed as integers; 0: the way of AXISCERT_EXACT_ONLY
  bool open;
  double query[13];
  int size;  // of the integers taken; 0: digits; -1: nothing, since the answer was there
  bool open_after;
  std::uint64_t known;                              // after balls, where they were asked
  std::vector<std::vector<std::uint64_t>> numbers;  // words, the least significant first
};
std::vector<RecordedWindow> recorded_windows();

}  // namespace axiscert::proofs::certified
