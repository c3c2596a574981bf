#include "cli/help.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <sstream>

#include "cli/usage.h"

namespace axiscert {
namespace {

constexpr std::size_t widest_line = 100, narrowest_line = 40;
// Where descriptions begin; where a name is longer, on the line after it.
constexpr std::size_t described_at = 26;
constexpr const char* about_mark = "# ";

// COLUMNS, or the terminal's columns; at most and at least as above.
std::size_t columns_here() {
  std::size_t columns = widest_line;
  winsize size{};
  if (const char* given = std::getenv("COLUMNS"); given != nullptr && std::atol(given) > 0)
    columns = static_cast<std::size_t>(std::atol(given));
  else if (ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0) columns = size.ws_col;
  return std::clamp(columns, narrowest_line, widest_line);
}

// "  NAME      what it is", both wrapped.
std::string entry_of(const std::string& name, const std::string& text, std::size_t width) {
  std::string head = "  " + wrapped(name, width - 2, 6);
  if (head.size() + 2 > described_at) head += "\n" + std::string(described_at, ' ');
  else head.resize(described_at, ' ');
  return head + wrapped(text, width - described_at, described_at) + "\n";
}

std::string names_of(const std::set<CLI::Option*>& options) {
  std::vector<std::string> names;
  for (const CLI::Option* option : options) {
    if (option->nonpositional()) names.push_back(option->get_name());
  }
  std::sort(names.begin(), names.end());
  return fmt::format("{}", fmt::join(names, ", "));
}

std::string option_text(const CLI::Option& option) {
  std::string text = option.get_description();
  if (const std::string standard = option.get_default_str(); !standard.empty())
    text += fmt::format(" (default: {})", standard);
  if (const std::string needed = names_of(option.get_needs()); !needed.empty())
    text += fmt::format("; needs {}", needed);
  if (const std::string excluded = names_of(option.get_excludes()); !excluded.empty())
    text += fmt::format("; not with {}", excluded);
  return text;
}

std::string option_head(const CLI::Option& option) {
  if (option.get_positional()) return option.get_name(true) + (option.get_items_expected_max() > 1 ? "..." : "");
  const std::string label = value_label(option);
  return option.get_name(false, true) + (label.empty() ? "" : " " + label);
}

// The groups as they first occur, what is the command's own first.
std::vector<std::string> groups_in_order(const CLI::App& app) {
  std::vector<std::string> groups = app.get_groups();
  std::stable_partition(groups.begin(), groups.end(), [](const std::string& group) { return group == "Options"; });
  return groups;
}

std::string options_text(const CLI::App& app, std::size_t width) {
  std::string text;
  for (const std::string& group : groups_in_order(app)) {
    std::string entries;
    for (const CLI::Option* option : app.get_options()) {
      if (group.empty() || option->get_group() != group) continue;
      entries += entry_of(option_head(*option), option_text(*option), width);
    }
    if (!entries.empty()) text += fmt::format("\n{}:\n{}", group, entries);
  }
  return text;
}

std::string subcommands_text(const CLI::App& app, std::size_t width) {
  std::vector<std::string> groups;
  for (const CLI::App* part : app.get_subcommands({})) {
    const std::string& group = part->get_group();
    if (!group.empty() && std::find(groups.begin(), groups.end(), group) == groups.end()) groups.push_back(group);
  }
  std::string text;
  for (const std::string& group : groups) {
    text += fmt::format("\n{}:\n", group);
    for (const CLI::App* part : app.get_subcommands({})) {
      if (part->get_group() == group) text += entry_of(part->get_name(), part->get_description(), width);
    }
  }
  return text;
}

std::string usage_line(const CLI::App& app) {
  std::string usage = "Usage: " + full_name(app) + " [OPTIONS]";
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_positional()) continue;
    const std::string head = option_head(*option);
    usage += option->get_required() ? " " + head : " [" + head + "]";
  }
  return usage + (app.get_subcommands({}).empty() ? "" : " SUBCOMMAND");
}

// The line, continued after a backslash where it is longer than `width`.
std::string continued(const std::string& line, std::size_t width) {
  std::string text = wrapped(line, width - 2, 4);
  for (std::size_t at = 0; (at = text.find('\n', at)) != text.npos; at += 3) text.insert(at, " \\");
  return text;
}

std::string examples_text(const CLI::App& app, std::size_t width) {
  std::string text;
  for (const Example& example : examples_of(app))
    text += fmt::format("  {}\n  {}\n", wrapped(about_mark + example.about, width - 2, 4),
                        continued(example.line, width - 2));
  return text.empty() ? text : "\nExamples:\n" + text;
}

}  // namespace

void add_examples(CLI::App& command, const std::vector<Example>& examples) {
  std::string text;
  for (const Example& example : examples) text += about_mark + example.about + "\n" + example.line + "\n";
  command.footer(text);
}

std::vector<Example> examples_of(const CLI::App& command) {
  std::vector<Example> examples;
  std::istringstream lines(command.get_footer());
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with(about_mark)) examples.push_back({line.substr(2), ""});
    else if (!examples.empty()) examples.back().line = line;
  }
  return examples;
}

std::string value_label(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  const std::string type = option.get_type_name();
  const std::size_t words = type.find('{'), colon = type.find(':');
  return words != type.npos ? type.substr(words) : type.substr(0, colon);
}

std::string wrapped(const std::string& text, std::size_t width, std::size_t indent) {
  std::string out;
  std::size_t column = 0;
  std::istringstream words(text);
  for (std::string word; words >> word;) {
    if (column != 0 && column + 1 + word.size() > width) {
      out += "\n" + std::string(indent, ' ');
      column = 0;
    }
    if (column != 0) out += ' ', ++column;
    out += word;
    column += word.size();
  }
  return out;
}

std::string Help::make_help(const CLI::App* app, std::string, CLI::AppFormatMode) const {
  const std::size_t width = columns_here();
  std::string text = wrapped(app->get_description(), width, 0) + "\n" + wrapped(usage_line(*app), width, 4) + "\n";
  text += examples_text(*app, width) + options_text(*app, width) + subcommands_text(*app, width);
  if (examples_of(*app).empty() && !app->get_footer().empty())
    text += "\n" + wrapped(app->get_footer(), width, 0) + "\n";
  return text;
}

}  // namespace axiscert
