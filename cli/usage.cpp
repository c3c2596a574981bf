#include "cli/usage.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <vector>

#include "cli/commands.h"
#include "fuzz/queries/family.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"

namespace axiscert {

std::string full_name(const CLI::App& command) {
  return command.get_parent() == nullptr ? "axiscert" : full_name(*command.get_parent()) + " " + command.get_name();
}

namespace {

// The subcommand that was reached: the innermost one that the command line names.
const CLI::App& reached(const CLI::App& app) {
  const std::vector<CLI::App*> chosen = app.get_subcommands();
  return chosen.empty() ? app : reached(*chosen.front());
}

std::vector<std::string> option_names(const CLI::App& command) {
  std::vector<std::string> names;
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
  }
  return names;
}

std::vector<std::string_view> views(const std::vector<std::string>& texts) { return {texts.begin(), texts.end()}; }

bool has_option(const CLI::App& command, std::string_view name) {
  const std::vector<std::string> names = option_names(command);
  return std::find(names.begin(), names.end(), name) != names.end();
}

std::string unknown_subcommand(const CLI::App& command, const std::string& given) {
  std::vector<std::string> names;
  for (const CLI::App* part : command.get_subcommands({})) {
    if (!part->get_group().empty()) names.push_back(part->get_name());
  }
  if (given.empty()) {
    return fmt::format("{}: a subcommand is missing; subcommands: {}", full_name(command), fmt::join(names, ", "));
  }
  return fmt::format("{}: {}", full_name(command),
                     unknown_name("subcommand", "subcommands", given, views(names), full_name(command) + " --help"));
}

std::string unknown_option(const CLI::App& command, const std::string& given) {
  const std::string word = given.substr(0, given.find('='));
  for (const CLI::App* part : command.get_subcommands({})) {
    if (has_option(command, word) || !has_option(*part, word)) continue;
    return fmt::format("{}: the option {} belongs after a subcommand, as in {} {} {}", full_name(command), word,
                       full_name(command), part->get_name(), word);
  }
  const std::vector<std::string> names = option_names(command);
  return fmt::format("{}: unknown option '{}'{} {}", full_name(command), word, did_you_mean(word, views(names)),
                     names_alike("options", word, views(names), full_name(command) + " --help"));
}

// A word where none belongs, which may be the value of an option.
std::string unexpected_word(const CLI::App& command, const std::string& given) {
  const auto is_named = [&](const auto& all, auto&& name) {
    return std::any_of(all.begin(), all.end(), [&](const auto& each) { return name(each) == given; });
  };
  std::string option;
  if (is_named(families(), [](const Family* family) { return family->name; })) option = "--family";
  else if (is_named(kernels(), [](const Kernel& kernel) { return std::string_view(kernel.id); }) ||
           plugin::is_given_by_file(given))
    option = "--kernel";
  const bool is_value = !option.empty() && has_option(command, option);
  return fmt::format("{}: '{}' is not expected here; {}", full_name(command), given,
                     is_value ? fmt::format("did you mean {} {}?", option, given)
                              : fmt::format("`{} --help` shows what is", full_name(command)));
}

std::string unexpected_text(const CLI::App& command, const std::vector<std::string>& remaining) {
  const bool lacks_subcommand = command.get_require_subcommand_min() > 0;
  if (lacks_subcommand && !remaining.empty() && !remaining.front().starts_with('-'))
    return unknown_subcommand(command, remaining.front());
  const auto option = std::find_if(remaining.begin(), remaining.end(),
                                   [](const std::string& word) { return word.size() > 1 && word[0] == '-'; });
  if (option != remaining.end()) return unknown_option(command, *option);
  return unexpected_word(command, remaining.empty() ? "" : remaining.front());
}

// The option whose value is another's name; empty where there is none.
std::string missing_value(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    for (const std::string& value : option->results()) {
      if (!value.starts_with("--") || !has_option(command, value)) continue;
      return fmt::format("{}: {} has no value: the option {} follows it; write {} VALUE", full_name(command),
                         option->get_name(), value, option->get_name());
    }
  }
  return "";
}

// The option that takes one value and has more; empty where there is none.
std::string repeated_text(const CLI::App& command) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_max() != 1 || option->results().size() < 2) continue;
    return fmt::format("{}: {} is given {} times ({}); give it once", full_name(command), option->get_name(),
                       option->results().size(), fmt::join(option->results(), ", "));
  }
  return "";
}

// Whether a text is of nothing but spaces, or is what CLI11 reads as an empty list.
bool is_blank(std::string_view text) { return text.find_first_not_of(" \t\r\n") == text.npos || text == "{}"; }

// Options whose values are NAME=VALUE, of which neither part may be empty.
constexpr std::string_view pairs[] = {"--require", "--source", "--tolerance"};

bool has_blank_part(const CLI::Option& option, std::string_view value) {
  if (is_blank(value)) return true;
  const std::size_t equals = value.find('=');
  return equals != value.npos && std::find(std::begin(pairs), std::end(pairs), option.get_name()) != std::end(pairs) &&
         (is_blank(value.substr(0, equals)) || is_blank(value.substr(equals + 1)));
}

std::string empty_message(const CLI::App& command, const CLI::Option& option, std::string_view value) {
  const std::string type = option.get_type_name();
  const std::size_t words = type.find('{');
  const std::string takes = option.get_description() + (words == type.npos ? "" : ", of " + type.substr(words));
  return fmt::format("{}: {}: {}, as of an unset variable; give {}{}", full_name(command), option.get_name(),
                     is_blank(value) ? "an empty value" : fmt::format("an empty part in '{}'", value),
                     option.get_required() ? "one" : "one, or leave the option out", takes.empty() ? "" : ": " + takes);
}

// The option that takes a value and has this name; nullptr where there is none.
const CLI::Option* taker(const CLI::App& command, const std::string& name) {
  const CLI::Option* option = name.starts_with('-') ? command.get_option_no_throw(name) : nullptr;
  return option != nullptr && option->get_items_expected_max() != 0 ? option : nullptr;
}

// Says what is wrong with a word that is empty, or empty after its `=`; an empty text where nothing is. CLI11 takes
// `--key= x` for `--key x`, and `--corpus ''` for `--corpus`.
std::string empty_word(const CLI::App& command, const std::string& word, const std::string& before) {
  const std::size_t equals = word.starts_with('-') ? word.find('=') : word.npos;
  if (equals != word.npos && is_blank(word.substr(equals + 1))) {
    const CLI::Option* option = command.get_option_no_throw(word.substr(0, equals));
    return option == nullptr ? "" : empty_message(command, *option, "");
  }
  if (!is_blank(word)) return "";
  if (const CLI::Option* option = taker(command, before)) return empty_message(command, *option, "");
  return fmt::format("{}: an empty word{}, as of an unset variable; leave it out", full_name(command),
                     before.empty() ? "" : fmt::format(" after '{}'", before));
}

// The value that is empty, as in `--key "$UNSET"`: an empty text where there is none. Taken as not given, it would ask
// for less than its author did: no key, no ratchet, the kernel that is the default.
std::string empty_value(const CLI::App& command, const std::vector<std::string>& words) {
  for (const CLI::Option* option : command.get_options()) {
    if (option->get_items_expected_min() == 0)
      continue;  // a flag, or a value that may be left out, whose default this is
    for (const std::string& value : option->results()) {
      if (has_blank_part(*option, value)) return empty_message(command, *option, value);
    }
  }
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (const std::string text = empty_word(command, words[i], i == 0 ? "" : words[i - 1]); !text.empty()) return text;
  }
  return "";
}

}  // namespace

std::string usage_message(const CLI::App& app, const CLI::ParseError& refused, const std::vector<std::string>& words) {
  const CLI::App& command = reached(app);
  if (const std::string text = empty_value(command, words); !text.empty()) return text;
  const std::vector<std::string> remaining = command.remaining();
  if (const std::string text = missing_value(command); !text.empty()) return text;
  // Its value was taken for an argument, which may be one too many.
  if (std::ranges::any_of(remaining, [](const std::string& word) { return word.starts_with('-'); }))
    return unexpected_text(command, remaining);
  if (dynamic_cast<const CLI::ArgumentMismatch*>(&refused) != nullptr) {
    if (const std::string text = repeated_text(command); !text.empty()) return text;
    if (!words.empty() && words.back().starts_with("--") && has_option(command, words.back()))
      return fmt::format("{}: {} has no value: the line ends after it; write {} VALUE", full_name(command),
                         words.back(), words.back());
  }
  const bool is_required = dynamic_cast<const CLI::RequiredError*>(&refused) != nullptr;
  if (dynamic_cast<const CLI::ExtrasError*>(&refused) != nullptr || (is_required && !remaining.empty()))
    return unexpected_text(command, remaining);
  if (is_required && command.get_require_subcommand_min() > 0) return unknown_subcommand(command, "");
  if (dynamic_cast<const CLI::ValidationError*>(&refused) != nullptr)  // which says all, in the words of its own check
    return fmt::format("{}: {}", full_name(command), refused.what());
  return fmt::format("{}: {}; `{} --help` shows what is accepted", full_name(command), refused.what(),
                     full_name(command));
}

int print_usage(const CLI::App& app, const CLI::ParseError& refused, const std::vector<std::string>& words) {
  if (refused.get_exit_code() == 0) return app.exit(refused);
  fmt::print(stderr, "{}\n", printable_line(usage_message(app, refused, words)));
  return exit_bad_input;
}

void require_values(const CLI::App& app, const std::vector<std::string>& words) {
  for (const std::string& text : {empty_value(reached(app), words), missing_value(reached(app))}) {
    if (!text.empty()) throw CLI::ParseError(text, CLI::ExitCodes::InvalidError);
  }
}

namespace {

constexpr std::uint64_t no_limit = std::numeric_limits<std::uint64_t>::max();

std::optional<double> number_of(const std::string& text) {
  double value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data(), end, value);
  return problem == std::errc() && stop == end && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

// The digits of a whole number that is written in another way, as 1e6, 2^20, 1,000 or 1_000; empty for anything else.
std::string in_digits(const std::string& text) {
  const auto whole = [](double value) {
    return value >= 0 && value < 0x1p53 && value == std::floor(value)
               ? fmt::format("{}", static_cast<std::uint64_t>(value))
               : "";
  };
  if (text.starts_with("2^")) {
    const auto power = number_of(text.substr(2));
    return power && *power >= 0 && *power < 53 ? whole(std::exp2(*power)) : "";
  }
  std::string bare = text;
  std::erase_if(bare, [](char c) { return c == ',' || c == '_'; });
  const auto value = number_of(bare);
  return value ? whole(*value) : "";
}

std::string range_text(std::uint64_t least, std::uint64_t most) {
  return most == no_limit ? fmt::format(">= {}", least) : fmt::format("from {} to {}", least, most);
}

// The fault of the text; empty where it has none.
std::string wrong_whole_number(const std::string& text, std::uint64_t least, std::uint64_t most) {
  if (text.empty() || text.find_first_not_of("0123456789") != text.npos) {
    const std::string digits = in_digits(text);
    return fmt::format("'{}' is not a whole number {}, in digits{}", text, range_text(least, most),
                       digits.empty() ? "" : ": write " + digits);
  }
  std::uint64_t value = 0;
  const auto [stop, problem] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (problem == std::errc::result_out_of_range || value > most)
    return fmt::format("{} is too large; the greatest is {}", text, most);
  return value < least ? fmt::format("{} is too small; the least is {}", text, least) : "";
}

}  // namespace

CLI::Validator whole_number(std::uint64_t least, std::uint64_t most) {
  const bool any = least == 0 && most == no_limit;
  return {[=](std::string& text) { return wrong_whole_number(text, least, most); },
          any                ? ""
          : most == no_limit ? fmt::format("UINT >= {}", least)
                             : fmt::format("UINT in [{} - {}]", least, most)};
}

CLI::Validator number_above_zero() {
  return {[](std::string& text) {
            const auto value = number_of(text);
            return value && *value > 0 ? "" : fmt::format("'{}' is not a number > 0, such as 0.5", text);
          },
          "POSITIVE"};
}

CLI::Validator number_between(double least, double most) {
  return {[=](std::string& text) {
            const auto value = number_of(text);
            return value && *value >= least && *value <= most
                       ? ""
                       : fmt::format("'{}' is not a number from {} to {}", text, least, most);
          },
          fmt::format("FLOAT in [{} - {}]", least, most)};
}

CLI::Validator one_of(std::vector<std::string> words) {
  std::string description = fmt::format("{{{}}}", fmt::join(words, ","));
  return {[words = std::move(words)](std::string& text) -> std::string {
            if (std::find(words.begin(), words.end(), text) != words.end()) return "";
            const std::vector<std::string_view> known(words.begin(), words.end());
            return fmt::format("unknown value '{}'{} values: {}", text, did_you_mean(text, known),
                               fmt::join(known, ", "));
          },
          std::move(description)};
}

}  // namespace axiscert
