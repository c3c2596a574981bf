// `axiscert man`: the manual page, generated from the definitions that parse the command line.
#include <fmt/format.h>

#include "cli/commands.h"
#include "cli/help.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The text in the form that roff shows unchanged: no escapes, no requests, hyphens that can be copied.
std::string roff(const std::string& text) {
  std::string out;
  bool at_start = true;
  for (const char c : text) {
    if (at_start && (c == '.' || c == '\'')) out += "\\&";
    if (c == '\\') out += "\\e";
    else if (c == '-') out += "\\-";
    else out += c;
    at_start = c == '\n';
  }
  return out;
}

// The capital letters that stand for the value of an option that takes one.
std::string value_of(const CLI::Option& option) {
  if (option.get_items_expected_max() == 0) return "";
  std::string type = option.get_type_name();
  for (char& c : type) {
    if (c == '\n') c = ' ';
  }
  return type.empty() ? "" : " " + type;
}

std::string option_entry(const CLI::Option& option) {
  const std::string names = option.get_positional() ? option.get_name(true, false) : option.get_name(false, true);
  std::string text = option.get_description();
  if (option.get_required()) text += text.empty() ? "required" : " (required)";
  const std::string standard = option.get_default_str();
  // A default that is a path depends on where axiscert is installed, so it is left out.
  if (!standard.empty() && standard[0] != '/') text += fmt::format(" (default: {})", standard);
  return fmt::format(".TP\n.B {}\n{}\n", roff(names + value_of(option)), roff(text));
}

std::string options_of(const CLI::App& app) {
  std::string text;
  for (const CLI::Option* option : app.get_options()) {
    if (!option->get_group().empty()) text += option_entry(*option);
  }
  return text;
}

std::string command_section(const CLI::App& command, const std::string& name) {
  std::string text = fmt::format(".SS {}\n{}\n{}", roff(name), roff(command.get_description()), options_of(command));
  for (const Example& example : examples_of(command))
    text += fmt::format(".PP\n{}:\n.nf\n{}\n.fi\n", roff(example.about), roff(example.line));
  for (const CLI::App* part : command.get_subcommands({})) {
    if (!part->get_group().empty()) text += command_section(*part, name + " " + part->get_name());
  }
  return text;
}

std::string manual_page(const CLI::App& app) {
  std::string text = fmt::format(
      ".TH AXISCERT 1 \"\" \"axiscert {0}\"\n.SH NAME\naxiscert \\- judges collision tests beside "
      "exact arithmetic\n"
      ".SH SYNOPSIS\n.B axiscert\n.I COMMAND\n.RI [ OPTIONS ]\n.SH DESCRIPTION\n{1}\n.SH OPTIONS\n{2}.SH COMMANDS\n",
      axiscert_version, roff(app.get_description()), options_of(app));
  for (const CLI::App* command : app.get_subcommands({})) {
    if (!command->get_group().empty()) text += command_section(*command, command->get_name());
  }
  return text + fmt::format(
                    ".SH EXIT STATUS\n{}\n.SH ENVIRONMENT\n.TP\n.B NO_COLOR\nset to any value: no colour. Without it "
                    "colour is used on a terminal only.\n",
                    roff(app.get_footer()));
}

}  // namespace

void add_man(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand("man", "Print the manual page, for `man -l -`")->group("");
  command->callback([&app, &action] {
    action = [&app] {
      fmt::print("{}", manual_page(app));
      return exit_done;
    };
  });
}

}  // namespace axiscert
