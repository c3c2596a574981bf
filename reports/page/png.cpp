#include "reports/page/png.h"

#include <fmt/format.h>
#include <png.h>

#include <vector>

#include "kernel/base/error.h"

namespace axiscert {

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
