#include "cli/shared_options.h"

#include <fmt/format.h>
#include <fnmatch.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>

#include "cli/usage.h"
#include "fuzz/queries/family.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/kernel.h"
#include "kernel/plugin/load.h"

namespace axiscert {
namespace {

// The words of both options, in the order in which they were given.
std::vector<std::string> kernels_in_order(const CLI::App& command, const KernelArguments& both) {
  std::vector<std::string> words;
  std::size_t named = 0, argument = 0;
  for (const CLI::Option* option : command.parse_order()) {
    if (option == both.named) words.push_back(option->results().at(named++));
    if (option == both.argument) words.push_back(option->results().at(argument++));
  }
  return words;
}

bool is_built_in_id(std::string_view word) {
  return std::ranges::any_of(kernels(), [&](const Kernel& kernel) { return kernel.id == word; });
}

// Whether a word is meant as a kernel: a built-in one, also in another arithmetic, called otherwise or as a mutant; a
// file that is given as one; or one that comes with axiscert.
bool names_a_kernel(std::string_view word) {
  if (plugin::is_given_by_file(word) || is_built_in_id(word.substr(0, word.find_first_of("+@~")))) return true;
  return std::ranges::any_of(plugin::shipped_plugins(),
                             [&](const plugin::ShippedPlugins& shipped) { return word.starts_with(shipped.prefix); });
}

// A family given as a kernel is told where it belongs (cli/usage.cpp).
CLI::Validator no_family() {
  return {[](std::string& word) -> std::string {
            const bool is_one = std::ranges::any_of(families(), [&](const Family* f) { return f->name == word; });
            return is_one && !is_built_in_id(word) ? fmt::format("'{}' is a family", word) : "";
          },
          ""};
}

template <class Set>
KernelArguments add_both(CLI::App& command, const std::string& use, const Set& set) {
  const auto both = std::make_shared<KernelArguments>();
  const auto take = [&command, both, set](const std::vector<std::string>&) { set(kernels_in_order(command, *both)); };
  both->named = command.add_option_function<std::vector<std::string>>("--kernel", take, use)
                    ->allow_extra_args(false)
                    ->group(asked_group);
  both->argument = command.add_option_function<std::vector<std::string>>("KERNEL", take, "the same as --kernel KERNEL")
                       ->check(no_family())
                       ->group(asked_group);
  command.validate_positionals();
  return *both;
}

// The names that a word stands for: those that a pattern matches, else its own. Throws Error where it stands for none.
std::vector<std::string> families_of_word(const std::string& word) {
  if (word == "all") return {word};
  std::vector<std::string> names;
  for (const Family* family : families()) {
    const std::string name(family->name);
    if (fnmatch(word.c_str(), name.c_str(), FNM_PATHNAME) == 0) names.push_back(name);
  }
  if (names.empty()) find_family(word);  // which says what there is
  return names;
}

std::string or_default(const std::string& text, const std::string& otherwise) {
  return otherwise.empty() ? text : fmt::format("{} (default: {})", text, otherwise);
}

const CLI::Validator& count_of_trials() {
  static const CLI::Validator check = whole_number(1, std::uint64_t{1} << 48);
  return check;
}

}  // namespace

CLI::Validator known_by(std::function<void(const std::string&)> look) {
  return {[look = std::move(look)](std::string& text) -> std::string {
            try {
              look(text);
              return "";
            } catch (const Error& unknown) {
              return unknown.what();
            }
          },
          ""};
}

KernelArguments add_kernels(CLI::App& command, std::vector<std::string>& kernels, const std::string& use,
                            const std::string& otherwise) {
  return add_both(command, or_default(use + ", repeatable", otherwise),
                  [&](std::vector<std::string> given) { kernels = std::move(given); });
}

KernelArguments add_kernel(CLI::App& command, std::string& kernel, const std::string& use,
                           const std::string& otherwise) {
  return add_both(command, or_default(use, otherwise), [&](const std::vector<std::string>& given) {
    if (given.size() > 1)
      throw CLI::ValidationError(
          fmt::format("--kernel is given {} times ({}); give it once", given.size(), fmt::join(given, ", ")));
    kernel = given.front();
  });
}

CLI::Validator no_kernel() {
  return {[](std::string& word) -> std::string {
            std::error_code ignored;
            return names_a_kernel(word) && !std::filesystem::exists(word, ignored)
                       ? fmt::format("'{}' is a kernel", word)
                       : "";
          },
          ""};
}

CLI::Option* add_predicate(CLI::App& command, std::string& predicate, const std::string& use,
                           const std::string& otherwise) {
  return command.add_option("--predicate", predicate, or_default(use, otherwise))
      ->check(known_by([](const std::string& id) { find_predicate(id); }))
      ->group(asked_group);
}

CLI::Option* add_families(CLI::App& command, std::vector<std::string>& families, const std::string& otherwise) {
  const auto take = [&families](const std::vector<std::string>& words) {
    families.clear();
    for (const std::string& word : words) std::ranges::copy(families_of_word(word), std::back_inserter(families));
  };
  return command
      .add_option_function<std::vector<std::string>>(
          "--family", take,
          or_default("family of queries, a pattern of names as scene-*, or all of the predicate; repeatable",
                     otherwise))
      ->allow_extra_args(false)
      ->check(known_by(families_of_word))
      ->group(asked_group);
}

CLI::Option* add_query_files(CLI::App& command, std::vector<std::string>& files) {
  return command.add_option("--queries", files, "query file, JSON Lines or CSV, - for standard input, repeatable")
      ->allow_extra_args(false)
      ->group(asked_group);
}

CLI::Option* add_precision(CLI::App& command, std::string& precision, const std::string& use,
                           const std::string& otherwise) {
  CLI::Option* option = command
                            .add_option("--precision", precision,
                                        or_default("precision of the queries: binary32 or binary64" + use, otherwise))
                            ->check(known_by([](const std::string& name) { parse_precision(name); }))
                            ->group(asked_group);
  return precision.empty() ? option : option->capture_default_str();
}

CLI::Option* add_trials(CLI::App& command, std::optional<std::uint64_t>& trials, const std::string& otherwise) {
  return command.add_option("--trials", trials, or_default("queries per family and precision", otherwise))
      ->check(count_of_trials())
      ->group(asked_group);
}

CLI::Option* add_trials(CLI::App& command, std::uint64_t& trials) {
  return command.add_option("--trials", trials, "queries per family and precision")
      ->check(count_of_trials())
      ->capture_default_str()
      ->group(asked_group);
}

CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed) {
  return command.add_option("--seed", seed, "seed of all random choices")
      ->check(whole_number())
      ->capture_default_str()
      ->group(asked_group);
}

CLI::Option* add_target(CLI::App& command, std::string& target) {
  return command.add_option("--target", target, "instruction set (axiscert kernels), or auto")
      ->capture_default_str()
      ->group(running_group);
}

CLI::Option* add_out(CLI::App& command, std::string& folder, const std::string& content) {
  CLI::Option* option = command.add_option("--out", folder, "folder for " + content)->group(output_group);
  return folder.empty() ? option : option->capture_default_str();
}

CLI::Option* add_out_file(CLI::App& command, std::string& file, const std::string& content) {
  return command.add_option("-o,--out-file", file, "file for " + content)->capture_default_str()->group(output_group);
}

CLI::Option* add_quiet(CLI::App& command, bool& quiet, const std::string& what_is_printed) {
  return command.add_flag("--quiet", quiet, what_is_printed)->group(output_group);
}

void add_address_files(CLI::App& command, AddressFiles& files) {
  command.add_option("--mesh", files.mesh, "the mesh in which the address is");
  command.add_option("--queries", files.queries, "the query file in which the address is");
  command.add_option("--corpus", files.corpus,
                     "the corpus in which the address is (default: the one supplied with axiscert)");
}

}  // namespace axiscert
