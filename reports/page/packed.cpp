#include "reports/page/packed.h"

#include <openssl/evp.h>
#include <zlib.h>

#include <stdexcept>

namespace axiscert {

std::string base64(std::string_view bytes) {
  std::string text(4 * ((bytes.size() + 2) / 3) + 1, '\0');  // and the terminator that OpenSSL writes
  EVP_EncodeBlock(reinterpret_cast<unsigned char*>(text.data()), reinterpret_cast<const unsigned char*>(bytes.data()),
                  static_cast<int>(bytes.size()));
  text.pop_back();
  return text;
}

std::string packed(std::string_view bytes) {
  uLongf size = compressBound(bytes.size());
  std::string small(size, '\0');
  if (compress2(reinterpret_cast<Bytef*>(small.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), Z_BEST_COMPRESSION) != Z_OK) {
    throw std::runtime_error("zlib: out of memory");
  }
  small.resize(size);
  return base64(small);
}

}  // namespace axiscert
