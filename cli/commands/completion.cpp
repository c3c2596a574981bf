// `axiscert completion`: what a shell completes on the command line, from the definitions that parse it.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/commands.h"
#include "cli/help.h"
#include "cli/usage.h"
#include "cli/words.h"
#include "fuzz/queries/family.h"
#include "kernel/base/version.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

struct OptionWords {
  std::vector<std::string> names;  // "--kernel", "-o"
  std::string description;
  bool has_value = false;
  std::vector<std::string> values;  // those that are known; without any, the value may be a file
};

struct CommandWords {
  std::vector<std::string> path;  // {} is axiscert itself; {"corpus", "add"}
  std::string description;
  std::vector<OptionWords> options;
  std::vector<std::pair<std::string, std::string>> parts;  // the subcommands and what they do
  std::vector<std::string> words;  // known ones of the first argument; without any, it may be a file
};

std::vector<std::string> kernel_words() {
  std::vector<std::string> words{"plugin:", "program:"};
  for (const Kernel& kernel : kernels()) words.push_back(kernel.id);
  for (const plugin::ShippedPlugins& shipped : plugin::shipped_plugins()) {
    for (const std::string& name : shipped.names) words.push_back(shipped.prefix + name);
  }
  return words;
}

std::vector<std::string> family_words() {
  std::vector<std::string> words{"all"};
  for (const Family* family : families()) words.emplace_back(family->name);
  return words;
}

// Those of the glossary that are one word.
std::vector<std::string> explained_words() {
  std::vector<std::string> words;
  for (const GlossaryEntry& entry : glossary_entries(glossary_text())) {
    for (const std::string& word : entry.words) {
      if (word.find(' ') == word.npos) words.push_back(word);
    }
  }
  return words;
}

// "TEXT:{text,jsonl}" is text or jsonl, as one_of of usage.h writes it.
std::vector<std::string> listed_values(const std::string& type) {
  const std::size_t begin = type.find('{'), end = type.find('}');
  return begin < end && end != type.npos ? CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',')
                                         : std::vector<std::string>();
}

OptionWords words_of(const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_lnames()) words.names.push_back("--" + name);
  for (const std::string& name : option.get_snames()) words.names.push_back("-" + name);
  words.description = option.get_description();
  words.has_value = option.get_items_expected_max() != 0;
  const auto is_named = [&](std::string_view name) { return option.get_name() == name; };
  if (is_named("--kernel") || is_named("KERNEL")) words.values = kernel_words();
  else if (is_named("--family")) words.values = family_words();
  else if (is_named("WORD")) words.values = explained_words();
  else words.values = listed_values(option.get_type_name());
  return words;
}

void add_commands(const CLI::App& app, const std::vector<std::string>& path, std::vector<CommandWords>& all) {
  CommandWords words{path, app.get_description(), {}, {}, {}};
  const CLI::Option* first = nullptr;  // of the arguments, whose words are offered
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_group().empty()) continue;
    if (option->nonpositional()) words.options.push_back(words_of(*option));
    else if (first == nullptr) words.words = words_of(*(first = option)).values;
  }
  std::vector<const CLI::App*> parts;
  for (const CLI::App* part : app.get_subcommands({})) {
    if (part->get_group().empty()) continue;
    words.parts.emplace_back(part->get_name(), part->get_description());
    parts.push_back(part);
  }
  all.push_back(std::move(words));
  for (const CLI::App* part : parts) {
    std::vector<std::string> longer = path;
    longer.push_back(part->get_name());
    add_commands(*part, longer, all);
  }
}

// 'TEXT' as a shell reads it; fish has the same form but for the quote inside.
std::string shell_quoted(std::string_view text) {
  std::string out = "'";
  for (const char c : text) out += c == '\'' ? std::string("'\\''") : std::string(1, c);
  return out + "'";
}

// bash: one function that names the words after a command, or the values of one of its options.
std::string bash_script(const std::vector<CommandWords>& commands) {
  std::string cases;
  for (const CommandWords& command : commands) {
    const std::string path = fmt::format("{}", fmt::join(command.path, " "));
    std::vector<std::string> words;
    for (const auto& [name, description] : command.parts) words.push_back(name);
    words.insert(words.end(), command.words.begin(), command.words.end());
    for (const OptionWords& option : command.options) {
      words.insert(words.end(), option.names.begin(), option.names.end());
      if (!option.has_value) continue;
      for (const std::string& name : option.names) {
        cases += fmt::format(
            "    {}) echo {} ;;\n", shell_quoted(path + " " + name),
            shell_quoted(option.values.empty() ? "FILE" : fmt::format("{}", fmt::join(option.values, " "))));
      }
    }
    cases +=
        fmt::format("    {}) echo {} ;;\n", shell_quoted(path), shell_quoted(fmt::format("{}", fmt::join(words, " "))));
  }
  return fmt::format(R"sh(# bash completion for axiscert {}, from `axiscert completion bash`.
# The words after a command, or the values of an option of it; FILE where any file is one.
_axiscert_words() {{
  case $1 in
{}  esac
}}
_axiscert() {{
  local word=${{COMP_WORDS[COMP_CWORD]}} before=${{COMP_WORDS[COMP_CWORD - 1]}} path= longer words i
  for ((i = 1; i < COMP_CWORD; ++i)); do
    longer="${{path:+$path }}${{COMP_WORDS[i]}}"
    [ -n "$(_axiscert_words "$longer")" ] && [[ ${{COMP_WORDS[i]}} != -* ]] && path=$longer
  done
  words=$(_axiscert_words "$path $before")
  if [ -z "$words" ]; then
    case $word in
      -*) words=$(_axiscert_words "$path") ;;
      *) words=$(_axiscert_words "$path" | tr ' ' '\n' | grep -v '^-') || words=FILE ;;
    esac
  fi
  if [ "$words" = FILE ]; then
    compopt -o filenames
    COMPREPLY=($(compgen -f -- "$word"))
  else
    COMPREPLY=($(compgen -W "$words" -- "$word"))
  fi
}}
complete -F _axiscert axiscert
)sh",
                     axiscert_version, cases);
}

// A description in zsh's `name[description]:value:(values)`: brackets and colons end its parts.
std::string zsh_text(std::string text) {
  for (char& c : text) {
    if (c == '[' || c == ']' || c == ':' || c == '\n') c = ' ';
  }
  return text;
}

std::string zsh_script(const std::vector<CommandWords>& commands) {
  std::string functions;
  for (const CommandWords& command : commands) {
    std::string arguments, cases, parts;
    for (const OptionWords& option : command.options) {
      for (const std::string& name : option.names) {
        std::string value;
        if (option.has_value) {
          value = option.values.empty() ? ":value:_files" : fmt::format(":value:({})", fmt::join(option.values, " "));
          for (std::size_t at = 0; (at = value.find("plugin:", at)) != value.npos; at += 8) value.insert(at + 6, "\\");
          for (std::size_t at = 0; (at = value.find("program:", at)) != value.npos; at += 9) value.insert(at + 7, "\\");
        }
        arguments +=
            fmt::format("    {} \\\n", shell_quoted("*" + name + "[" + zsh_text(option.description) + "]" + value));
      }
    }
    const std::string function =
        fmt::format("_axiscert{}{}", command.path.empty() ? "" : "_", fmt::join(command.path, "_"));
    for (const auto& [name, description] : command.parts) {
      parts += fmt::format("    {}\n", shell_quoted(name + ":" + zsh_text(description)));
      cases += fmt::format("    {0}) {1}_{0} ;;\n", name, function);
    }
    const std::string rest = !parts.empty() ? "    '1:command:->command' '*::argument:->argument'\n"
                             : command.words.empty()
                                 ? "    '*:file:_files'\n"
                                 : fmt::format("    '*:word:({})'\n", fmt::join(command.words, " "));
    functions += fmt::format("{}() {{\n  local state line\n  _arguments -C \\\n{}{}", function, arguments, rest);
    if (!parts.empty()) {
      functions += fmt::format(
          "  local -a commands=(\n{}  )\n  case $state in\n    command) _describe command commands ;;\n    argument) "
          "case "
          "$line[1] in\n{}    esac ;;\n  esac\n",
          parts, cases);
    }
    functions += "}\n";
  }
  return fmt::format(
      "#compdef axiscert\n# zsh completion for axiscert {}, from `axiscert completion zsh`; it belongs into a file "
      "_axiscert in $fpath.\n{}compdef _axiscert axiscert\n",
      axiscert_version, functions);
}

std::string fish_script(const std::vector<CommandWords>& commands) {
  std::string lines;
  for (const CommandWords& command : commands) {
    std::string seen;
    for (const std::string& name : command.path) seen += fmt::format("__fish_seen_subcommand_from {}; and ", name);
    std::vector<std::string> names;
    for (const auto& [name, description] : command.parts) names.push_back(name);
    const std::string none = fmt::format("not __fish_seen_subcommand_from {}", fmt::join(names, " "));
    for (const auto& [name, description] : command.parts) {
      lines += fmt::format("complete -c axiscert -f -n {} -a {} -d {}\n", shell_quoted(seen + none), shell_quoted(name),
                           shell_quoted(description));
    }
    const std::string where = seen + (names.empty() ? "true" : none);
    if (!command.words.empty()) {
      lines += fmt::format("complete -c axiscert -f -n {} -a {}\n", shell_quoted(where),
                           shell_quoted(fmt::format("{}", fmt::join(command.words, " "))));
    }
    for (const OptionWords& option : command.options) {
      std::string line = fmt::format("complete -c axiscert -n {}", shell_quoted(where));
      for (const std::string& name : option.names)
        line += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
      if (option.has_value)
        line += option.values.empty()
                    ? " -r"
                    : fmt::format(" -x -a {}", shell_quoted(fmt::format("{}", fmt::join(option.values, " "))));
      lines += fmt::format("{} -d {}\n", line, shell_quoted(option.description));
    }
  }
  return fmt::format("# fish completion for axiscert {}, from `axiscert completion fish`.\n{}", axiscert_version,
                     lines);
}

}  // namespace

void add_completion(CLI::App& app, Action& action) {
  auto* command = app.add_subcommand(
      "completion", "Print the completion of this command line for a shell: source <(axiscert completion bash)");
  auto shell = std::make_shared<std::string>();
  command->add_option("SHELL", *shell, "bash, zsh or fish")->required()->check(one_of({"bash", "zsh", "fish"}));
  add_examples(*command, {{"For this shell alone", "axiscert completion bash > axiscert.bash"},
                          {"For fish", "axiscert completion fish > axiscert.fish"}});
  command->callback([&app, &action, shell] {
    action = [&app, shell] {
      std::vector<CommandWords> commands;
      add_commands(app, {}, commands);
      const auto script = *shell == "bash" ? bash_script : *shell == "zsh" ? zsh_script : fish_script;
      fmt::print("{}", script(commands));
      return static_cast<int>(exit_done);
    };
  });
}

}  // namespace axiscert
