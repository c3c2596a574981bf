// Pictures with few colours as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace axiscert {

struct Colour {
  std::uint8_t red, green, blue;
};

// The bytes of a PNG file: `columns` pixels in each row, the uppermost row first; each pixel is an index into the
// palette of at most 256 colours.
std::string indexed_png(std::size_t columns, std::span<const std::uint8_t> pixels, std::span<const Colour> palette);

}  // namespace axiscert
