// Names in UTF-8, which JSON requires. Names that a user types or a file system holds are arbitrary bytes.
#pragma once

#include <string>
#include <string_view>

namespace axiscert {

// Whether these bytes are well-formed UTF-8 (RFC 3629: no overlong form, no surrogate, at most U+10FFFF).
bool is_utf8(std::string_view bytes);
// The bytes unchanged if they are UTF-8; otherwise, for display, with "\xff" in place of each byte that is not part of
// a character.
std::string as_utf8(std::string_view bytes);
// Throws Error unless a name is UTF-8. `what` says what kind of thing it names; the message shows both.
void require_utf8(std::string_view name, std::string_view what);

}  // namespace axiscert
