// The words that commands print, as what they name says of itself: predicates, families, kernels, levels, properties,
// classes. What is no name of one of these is in docs/glossary.md.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace axiscert {

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
