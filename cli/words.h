// The words of reports, terminal and documents, and what they mean: those of the glossary, and what the names that
// commands print say of themselves, predicates, families, kernels, levels, properties and classes.
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

struct NamedWord {
  std::string_view kind;  // "family"
  std::string name;
  std::string text;  // one line, without a line's end
};
std::vector<NamedWord> named_words();

// A figure of one of the files that axiscert writes, by its name or the end of its path: "kernels.families.trials:
// Number of queries: ...", a line for each sentence, of the first file that has it; empty where no member has that
// name.
std::string figure_text(std::string name);

// A value that a member of one of these files may have, as "not replayed": that member, with all of its values; empty
// where none has it.
std::string listed_value_text(const std::string& word);

// A heading of a table without what it has besides a name: "median, ulps" is a median; lower case, '_' for what is
// between words.
std::string comparable_heading(std::string_view heading);

}  // namespace axiscert
