// The answers to a block as a verdict for each query.
#pragma once

#include <cstring>

#include "kernel/sphere_triangle/certified/steps.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert::certified {

template <std::size_t most>
void write_verdicts(const Answer<most>& answer, std::size_t size, std::uint8_t* out) noexcept {
  // Spreads eight bits over eight bytes of 0 or 1.
  const auto spread = [](std::uint64_t bits) {
    const std::uint64_t each = ((bits & 0xff) * 0x0101010101010101ull) & 0x8040201008040201ull;
    return ((each + 0x7f7f7f7f7f7f7f7full) >> 7) & 0x0101010101010101ull;
  };
  static_assert(static_cast<int>(Verdict::contact) == 0 && static_cast<int>(Verdict::separated) == 1 &&
                static_cast<int>(Verdict::invalid) == 3);
  for (std::size_t i = 0; i < size; i += 8) {
    const std::uint64_t separated = spread(~answer.contact[i / 64] >> (i % 64));
    const std::uint64_t invalid = spread(answer.invalid[i / 64] >> (i % 64));
    const std::uint64_t verdicts = separated | (invalid << 1);  // an invalid query is not a contact: 1 and 2
    std::memcpy(out + i, &verdicts, size - i < 8 ? size - i : 8);
  }
}

}  // namespace axiscert::certified
