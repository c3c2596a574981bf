// Bytes in forms that a page can hold: compressed to text that is safe in HTML, and pictures with few colours as PNG.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace axiscert {
std::string base64(std::string_view bytes);
// zlib's format (RFC 1950) in base64, which a browser's DecompressionStream('deflate') reads. Throws Error.
std::string packed(std::string_view bytes);

// Pictures with few colours as PNG.

struct Colour {
  std::uint8_t red, green, blue;
};

// The bytes of a PNG file: `columns` pixels in each row, the uppermost row first; each pixel is an index into the
// palette of at most 256 colours.
std::string indexed_png(std::size_t columns, std::span<const std::uint8_t> pixels, std::span<const Colour> palette);

}  // namespace axiscert
