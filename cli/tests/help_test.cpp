// The examples of each command's help are lines that the parser accepts, and descriptions are wrapped.
#include "cli/help.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <sstream>

#include "cli/commands.h"

namespace axiscert {
namespace {

using Visit = std::function<void(const CLI::App&)>;

// Each command that the help of another lists.
void for_each_command(const CLI::App& app, const Visit& visit) {
  for (const CLI::App* part : app.get_subcommands({})) {
    if (part->get_group().empty()) continue;
    visit(*part);
    for_each_command(*part, visit);
  }
}

// "axiscert a b | ./program | axiscert c" are the words "a", "b" and the word "c".
std::vector<std::vector<std::string>> own_lines(const std::string& line) {
  std::vector<std::vector<std::string>> all;
  std::istringstream commands(line);
  for (std::string command; std::getline(commands, command, '|');) {
    std::istringstream words(command.substr(0, command.find('>')));
    std::vector<std::string> own;
    for (std::string word; words >> word;) own.push_back(word);
    if (own.empty() || own.front() != "axiscert") continue;
    own.erase(own.begin());
    all.push_back(own);
  }
  return all;
}

// What the parser says against a line; empty where nothing.
std::string refusal(std::vector<std::string> words) {
  CLI::App app;
  Action action;
  declare_command_line(app, action);
  std::reverse(words.begin(), words.end());
  try {
    app.parse(words);
    return action ? "" : "it chose no command";
  } catch (const CLI::ParseError& refused) {
    return refused.what();
  }
}

TEST(Help, EachCommandHasExamplesThatParse) {
  CLI::App app;
  Action action;
  declare_command_line(app, action);
  int commands = 0;
  for_each_command(app, [&](const CLI::App& command) {
    ++commands;
    const std::vector<Example> examples = examples_of(command);
    EXPECT_GE(examples.size(), 2u) << command.get_name();
    EXPECT_LE(examples.size(), 3u) << command.get_name();
    for (const Example& example : examples) {
      const auto lines = own_lines(example.line);
      EXPECT_FALSE(lines.empty()) << example.line;
      bool is_of_command = false;
      for (const auto& line : lines) {
        EXPECT_EQ(refusal(line), "") << example.line;
        is_of_command |= std::find(line.begin(), line.end(), command.get_name()) != line.end();
      }
      EXPECT_TRUE(is_of_command || command.get_name() == "corpus") << example.line;
    }
  });
  EXPECT_GT(commands, 25);
}

TEST(Help, ALineThatDoesNotParseIsSeen) {
  EXPECT_NE(refusal({"run", "--kernle", "published"}), "");
  EXPECT_NE(refusal({"run", "--family", "tangnet"}), "");
  EXPECT_NE(refusal({"check"}), "");
  EXPECT_EQ(refusal({"check", "mine.jsonl"}), "");
}

TEST(Help, TextIsWrappedAtWords) {
  EXPECT_EQ(wrapped("one two three", 7, 2), "one two\n  three");
  EXPECT_EQ(wrapped("one two three", 8, 0), "one two\nthree");
  EXPECT_EQ(wrapped("unbreakable a", 4, 1), "unbreakable\n a");
  EXPECT_EQ(wrapped("", 4, 1), "");
}

TEST(Help, AValueIsShownByItsWords) {
  CLI::App app;
  std::string format;
  bool quiet = false;
  EXPECT_EQ(value_label(*add_format(app, format, {"json"})), "{text,json}");
  EXPECT_EQ(value_label(*app.add_flag("--quiet", quiet)), "");
}

}  // namespace
}  // namespace axiscert
