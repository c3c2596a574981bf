// Options that several commands have. Each is declared here alone, so that a name has one meaning.
#pragma once

#include <CLI/CLI.hpp>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "cli/help.h"
#include "plans/given_queries.h"

namespace axiscert {

// In each `otherwise` is what stands for an option that is not given, where its value does not say it.

// A check that says what `look` throws of a value.
CLI::Validator known_by(std::function<void(const std::string&)> look);

// The kernels of a command: arguments, and values of --kernel, in the order in which they are given. `use` is what the
// command does with them.
struct KernelArguments {
  CLI::Option *named, *argument;
  bool given() const { return named->count() + argument->count() != 0; }
};
KernelArguments add_kernels(CLI::App& command, std::vector<std::string>& kernels, const std::string& use,
                            const std::string& otherwise = "");
// The same of a command that takes one, and refuses a second.
KernelArguments add_kernel(CLI::App& command, std::string& kernel, const std::string& use,
                           const std::string& otherwise = "");
// For an argument beside kernels, such as a file: a word that names a kernel is not it.
CLI::Validator no_kernel();

CLI::Option* add_predicate(CLI::App& command, std::string& predicate, const std::string& use,
                           const std::string& otherwise = "");
CLI::Option* add_families(CLI::App& command, std::vector<std::string>& families, const std::string& otherwise);
CLI::Option* add_query_files(CLI::App& command, std::vector<std::string>& files);
// `use` follows "precision of the queries: binary32 or binary64".
CLI::Option* add_precision(CLI::App& command, std::string& precision, const std::string& use = "",
                           const std::string& otherwise = "");
inline const std::string of_csv_files = "; that of CSV files, which state none";
CLI::Option* add_trials(CLI::App& command, std::optional<std::uint64_t>& trials, const std::string& otherwise);
CLI::Option* add_trials(CLI::App& command, std::uint64_t& trials);
CLI::Option* add_seed(CLI::App& command, std::uint64_t& seed);
CLI::Option* add_target(CLI::App& command, std::string& target);
// "folder for CONTENT".
CLI::Option* add_out(CLI::App& command, std::string& folder, const std::string& content);
// The one file that a command writes: -o, --out-file.
CLI::Option* add_out_file(CLI::App& command, std::string& file, const std::string& content);
// --mesh, --queries and --corpus, the files in which addresses can be.
void add_address_files(CLI::App& command, AddressFiles& files);
CLI::Option* add_quiet(CLI::App& command, bool& quiet, const std::string& what_is_printed);

}  // namespace axiscert
