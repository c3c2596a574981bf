#include "reports/page/encoding.h"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <png.h>
#include <zlib.h>

#include <stdexcept>
#include <vector>

#include "kernel/base/error.h"

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

std::string indexed_png(std::size_t columns, std::span<const std::uint8_t> pixels, std::span<const Colour> palette) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(columns);
  image.height = static_cast<png_uint_32>(pixels.size() / columns);
  image.format = PNG_FORMAT_RGB_COLORMAP;
  image.colormap_entries = static_cast<png_uint_32>(palette.size());
  std::vector<std::uint8_t> colours;
  for (const Colour& c : palette) colours.insert(colours.end(), {c.red, c.green, c.blue});
  const auto write = [&](void* to, png_alloc_size_t& size) {
    if (png_image_write_to_memory(&image, to, &size, 0, pixels.data(), 0, colours.data()) != 0) return;
    throw Error(fmt::format("a picture of {} x {} pixels cannot be written as PNG: {}", image.width, image.height,
                            image.message));
  };
  png_alloc_size_t size = 0;
  write(nullptr, size);  // finds how many bytes it takes
  std::string bytes(size, '\0');
  write(bytes.data(), size);
  bytes.resize(size);
  return bytes;
}

}  // namespace axiscert
