#include "fuzz/sha256.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <array>

#include "kernel/error.h"

namespace axiscert {

std::string sha256_hex(std::span<const std::byte> bytes) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest;
  unsigned size = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) != 1) {
    throw HarnessFault("OpenSSL refused to compute a SHA-256");
  }
  std::string text;
  for (unsigned i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
  return text;
}

}  // namespace axiscert
