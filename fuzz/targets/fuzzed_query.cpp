#include "fuzz/targets/fuzzed_query.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace axiscert::fuzzing {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are copied as they lie in memory");
constexpr std::size_t head = 2;

template <class Real>
Query<Real> query_of(std::span<const std::uint8_t> bytes) {
  std::array<Real, coordinate_count> numbers{};
  std::memcpy(numbers.data(), bytes.data(), std::min(bytes.size(), sizeof numbers));
  return from_coordinates(numbers);
}

}  // namespace

FuzzedQuery fuzzed_query(std::span<const std::uint8_t> bytes) {
  FuzzedQuery fuzzed;
  if (bytes.size() < head) return fuzzed;
  fuzzed.kernel = bytes[1];
  const auto numbers = bytes.subspan(head);
  if ((bytes[0] & 1u) == 0) fuzzed.query = query_of<float>(numbers);
  else fuzzed.query = query_of<double>(numbers);
  return fuzzed;
}

std::vector<std::uint8_t> bytes_of(const FuzzedQuery& fuzzed) {
  return std::visit(
      [&](const auto& query) {
        const auto numbers = coordinates(query);
        std::vector<std::uint8_t> bytes(head + sizeof numbers);
        bytes[0] = sizeof numbers[0] == sizeof(double);
        bytes[1] = fuzzed.kernel;
        std::memcpy(bytes.data() + head, numbers.data(), sizeof numbers);
        return bytes;
      },
      fuzzed.query);
}

}  // namespace axiscert::fuzzing
