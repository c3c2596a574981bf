// The errors that are thrown, each caught once, in main; and what their messages are made of: text of foreign origin in
// a form that may be quoted, and the names there are beside one that there is not.
#pragma once

#include <stdexcept>
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

// Bad usage or input: exit 2. The message says what was given, where, and what would be right. It is made a printable
// line, because it may quote text of any origin.
struct Error : std::runtime_error {
  explicit Error(const std::string& message) : std::runtime_error(printable_line(message)) {}
};

// The harness found a fault of its own (oracles that differ, a contracted build): exit 3.
struct HarnessFault : std::runtime_error {
  using std::runtime_error::runtime_error;
};

// Sorted by likeness to a given one. The measure is edit distance, where upper and lower case are one; names at equal
// distance keep their order.
std::vector<std::string_view> most_alike_first(std::string_view given, std::vector<std::string_view> names);

// The name that `given` may have been meant for: it differs in its case, begins so, or has few other letters. Empty
// where no name is so near.
std::string_view meant(std::string_view given, const std::vector<std::string_view>& names);

// "; did you mean 'NAME'?", or ";" where no name is so near: a message goes on with a space.
std::string did_you_mean(std::string_view given, const std::vector<std::string_view>& names);

// "unknown family 'GIVEN'; did you mean 'NAME'? families: NAME, ...", the most alike first: of the kind `family`, of
// the kinds `families`. A list with commas is told that one name is given at a time.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names);

// "families: NAME, ...", the most alike first; of more than eight "the nearest of 97 families: NAME, ...; `COMMAND`
// lists them".
std::string names_alike(std::string_view kinds, std::string_view given, const std::vector<std::string_view>& names,
                        std::string_view command);

// The same of names that a command lists.
std::string unknown_name(std::string_view kind, std::string_view kinds, std::string_view given,
                         const std::vector<std::string_view>& names, std::string_view command);

}  // namespace axiscert
