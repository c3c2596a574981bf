// SHA-256 of bytes: raw, and as 64 lower-case hex digits.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string>

namespace axiscert {

std::array<std::byte, 32> sha256(std::span<const std::byte> bytes);
std::string sha256_hex(std::span<const std::byte> bytes);

}  // namespace axiscert
