// Compression of bytes to text that is safe in HTML.
#pragma once

#include <string>
#include <string_view>

namespace axiscert {

std::string base64(std::string_view bytes);
// zlib's format (RFC 1950) in base64, which a browser's DecompressionStream('deflate') reads. Throws Error.
std::string packed(std::string_view bytes);

}  // namespace axiscert
