// Names as JSON holds them: UTF-8. What a user types and what a file system holds are bytes.
#pragma once

#include <string>
#include <string_view>

namespace axiscert {

// Whether these bytes are well-formed UTF-8 (RFC 3629: no overlong form, no surrogate, at most U+10FFFF).
bool is_utf8(std::string_view bytes);
// The bytes as they are where they are UTF-8; otherwise each byte that is part of no character as "\xff", for display.
std::string as_utf8(std::string_view bytes);
// Throws Error where a name is not UTF-8: `what` says which, and `name` is shown in it.
void require_utf8(std::string_view name, std::string_view what);

}  // namespace axiscert
