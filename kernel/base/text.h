// Text in messages: of foreign origin in a form that may be quoted, names in UTF-8, and the name that was meant.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {
// The text as one line of UTF-8 without a character that a terminal, a browser or an editor would obey: "\n", "\u001b"
// or
// "\u202e" in place of control characters, of the separators of lines, and of those that turn the direction of text;
// "\xff" in place of a byte that is not UTF-8. Nothing else changes, so that it may be applied again. All text of
// foreign origin comes through here where it enters: what a kernel says of itself, a manifest, the name of a file, the
// id of a query, the texts of a record.
std::string printable_line(std::string_view text);

// Names in UTF-8, which JSON requires. Names that a user types or a file system holds are arbitrary bytes.

// Whether these bytes are well-formed UTF-8 (RFC 3629: no overlong form, no surrogate, at most U+10FFFF).
bool is_utf8(std::string_view bytes);
// Throws Error unless a name is UTF-8. `what` says what kind of thing it names; the message shows both.
void require_utf8(std::string_view name, std::string_view what);

// Names sorted by likeness to a given one, for a message that says what would have been right.

// The measure is edit distance, where upper and lower case are one; names at equal distance keep their order.
std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names);

// The name that `given` may have been meant for: it differs in its case, begins so, or has few other letters. Empty
// where no name is so near.
std::string_view meant(std::string_view given, const std::vector<std::string_view>& names);

// "; did you mean 'NAME'?", or ";" where no name is so near: a message goes on with a space.
std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& names);

// "unknown family 'GIVEN'; did you mean 'NAME'? families: NAME, ...", the most alike first; `kind` is "family" and
// `kinds` "families". A list with commas is told that one name is given at a time.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names);

}  // namespace axiscert
