// `axiscert explain`: a word of reports and documents, in plain English.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/glossary.h"

namespace axiscert {

void add_explain(CLI::App& app, Action& action) {
  auto* command =
      app.add_subcommand("explain", "Say what a word of reports and documents means; without one, list the words");
  auto given = std::make_shared<std::vector<std::string>>();
  command->add_option("WORD", *given, "for example depth, or missed contact");
  command->callback([&action, given] {
    action = [given] {
      const std::vector<GlossaryEntry> entries = glossary_entries(glossary_text());
      if (given->empty()) {
        for (const GlossaryEntry& entry : entries) fmt::print("{}\n", fmt::join(entry.words, ", "));
      } else {
        const GlossaryEntry& entry = find_entry(entries, fmt::format("{}", fmt::join(*given, " ")));
        fmt::print("{}: {}\n", fmt::join(entry.words, ", "), entry.text);
      }
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert
