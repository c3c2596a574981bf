#include "kernel/base/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include "kernel/base/error.h"

namespace axiscert {

std::array<std::byte, 32> sha256(std::span<const std::byte> bytes) {
  std::array<std::byte, 32> digest;
  unsigned size = 0;
  auto* const out = reinterpret_cast<unsigned char*>(digest.data());
  if (EVP_Digest(bytes.data(), bytes.size(), out, &size, EVP_sha256(), nullptr) != 1 || size != digest.size()) {
    throw HarnessFault("OpenSSL refused to compute a SHA-256");
  }
  return digest;
}

std::string sha256_hex(std::span<const std::byte> bytes) {
  std::string text;
  for (const std::byte b : sha256(bytes)) text += fmt::format("{:02x}", static_cast<unsigned>(b));
  return text;
}

}  // namespace axiscert
