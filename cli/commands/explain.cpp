// `axiscert explain`: a word of reports and documents, a figure of a record, and the schema of a file.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "cli/words.h"
#include "fuzz/text/json.h"
#include "kernel/base/error.h"
#include "reports/formats/schemas.h"

namespace axiscert {
namespace {

// What is said of a word: the glossary's entry, and each thing of that name; else the figure; else the value. Empty
// where there is none of these.
std::string said_of(const std::string& word, const std::vector<GlossaryEntry>& entries,
                    const std::vector<NamedWord>& named) {
  std::string text;
  if (const GlossaryEntry* entry = find_entry(entries, word))
    text += fmt::format("{}: {}\n", fmt::join(entry->words, ", "), entry->text);
  for (const NamedWord& one : named) {
    if (is_same_word(one.name, word)) text += fmt::format("{}, {}: {}\n", one.name, one.kind, one.text);
  }
  if (text.empty()) text = figure_text(word);
  return text.empty() ? listed_value_text(word) : text;
}

// A heading of a table without what qualifies its word, a step each: "worst depth, u" is a "worst depth", and that a
// "depth"; "mutants of nonstrict" are "mutants". Empty where nothing is left to leave out.
std::string less_qualified(const std::string& heading) {
  for (const char* end : {", ", ": ", " = ", "=", " of", " by "}) {
    if (const std::size_t at = heading.find(end); at != heading.npos && at != 0) return heading.substr(0, at);
  }
  const std::size_t space = heading.find(' ');
  return space == heading.npos ? "" : heading.substr(space + 1);
}

std::string explanation_of(const std::string& word) {
  const std::vector<GlossaryEntry> entries = glossary_entries(glossary_text());
  const std::vector<NamedWord> named = named_words();
  for (std::string part = word; !part.empty(); part = less_qualified(part)) {
    if (std::string text = said_of(part, entries, named); !text.empty()) return text;
  }
  std::vector<std::string_view> known;
  for (const GlossaryEntry& entry : entries) known.insert(known.end(), entry.words.begin(), entry.words.end());
  for (const NamedWord& one : named) known.push_back(one.name);
  std::ranges::sort(known);
  known.erase(std::ranges::unique(known).begin(), known.end());
  constexpr std::size_t most_words = 12;
  std::vector<std::string_view> nearest = most_alike_first(word, known);
  nearest.resize(std::min(nearest.size(), most_words));
  throw Error(fmt::format("unknown word '{}'{} the nearest of {} words: {}", word, did_you_mean(word, known),
                          known.size(), fmt::join(nearest, ", ")));
}

}  // namespace

void add_explain(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "explain",
      "Say what a word of reports and documents, or a figure of record.json, means; without one, list the words");
  auto given = std::make_shared<std::vector<std::string>>();
  auto schema = std::make_shared<std::string>();
  auto* words = command->add_option("WORD", *given, "for example depth, or missed contact, or max_error_u");
  command
      ->add_option("--schema", *schema, "instead, the JSON Schema of what a command writes, such as record or ladder")
      ->excludes(words);
  add_examples(*command, {{"A word of a report", "axiscert explain missed contact"},
                          {"A figure of record.json", "axiscert explain max_error_u"},
                          {"The schema of a file", "axiscert explain --schema record"}});
  command->callback([&action, given, schema] {
    action = [given, schema] {
      if (!schema->empty()) {
        fmt::print("{}\n", schema_named(*schema).dump(2));
      } else if (!given->empty()) {
        fmt::print("{}", explanation_of(fmt::format("{}", fmt::join(*given, " "))));
      } else {
        for (const GlossaryEntry& entry : glossary_entries(glossary_text()))
          fmt::print("{}\n", fmt::join(entry.words, ", "));
      }
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert
