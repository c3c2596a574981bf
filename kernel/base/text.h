// Text in messages: of foreign origin in a form that may be quoted, and names in UTF-8.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {
// The text as one line of UTF-8 without a character that a terminal, a browser or an editor would obey: "\n",
// "\u001b" or "\u202e" in place of control characters, separators of lines, and those that turn the direction of text;
// "\xff" in place of a byte that is not UTF-8. Nothing else changes, so that it may be applied again. All text of
// foreign origin comes through here where it enters: what a kernel says of itself, a manifest, the name of a file, the
// id of a query, the texts of a record.
std::string printable_line(std::string_view text);

// Names in UTF-8, which JSON requires. Names that a user types or a file system holds are arbitrary bytes.

// Whether these bytes are well-formed UTF-8 (RFC 3629: no overlong form, no surrogate, at most U+10FFFF).
bool is_utf8(std::string_view bytes);
// Throws Error unless a name is UTF-8. `what` says what kind of thing it names; the message shows both.
void require_utf8(std::string_view name, std::string_view what);

}  // namespace axiscert
