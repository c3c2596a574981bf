// The meaning of a fuzzer's bytes for the kernel target: a kernel, and a query in one of the two precisions.
#pragma once

#include <cstdint>
#include <span>
#include <variant>
#include <vector>

#include "kernel/sphere_triangle/query.h"

namespace axiscert::fuzzing {

// Byte 0: bit 0 is the precision, 0 for binary32, 1 for binary64. Byte 1: the kernel, modulo the number of kernels.
// Then the thirteen numbers in the order of every column, as in memory (little-endian): 54 or 106 bytes in all.
struct FuzzedQuery {
  std::uint8_t kernel = 0;
  std::variant<Query<float>, Query<double>> query;
};
inline constexpr std::size_t greatest_size = 2 + coordinate_count * sizeof(double);

// Any bytes are accepted: missing ones are zero, and surplus ones are ignored.
FuzzedQuery fuzzed_query(std::span<const std::uint8_t> bytes);
std::vector<std::uint8_t> bytes_of(const FuzzedQuery& fuzzed);

}  // namespace axiscert::fuzzing
