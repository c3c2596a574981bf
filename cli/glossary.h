// The words of reports, terminal and documents, and what they mean.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

struct GlossaryEntry {
  std::vector<std::string> words;  // that mean the same or belong together, as the glossary's heading has them
  std::string text;                // without a line's end at the end
};

// docs/glossary.md, compiled in.
std::string_view glossary_text();

// The entries of a glossary in its order: a heading of the second level, words separated by ", ", and the text below
// it.
std::vector<GlossaryEntry> glossary_entries(std::string_view text);

// Whether a word is the known one: in any case, with spaces, '-' or '_' between its parts, in the plural too.
bool is_same_word(std::string_view known, std::string_view word);
// The entry of a word; null where there is none.
const GlossaryEntry* find_entry(const std::vector<GlossaryEntry>& entries, std::string_view word);

}  // namespace axiscert
