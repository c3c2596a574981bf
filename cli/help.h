// What `--help` shows of a command, from the definitions that parse its line: what it does, examples, and its options
// by group, in lines no longer than the terminal's.
#pragma once

#include <CLI/CLI.hpp>

#include <string>
#include <vector>

namespace axiscert {

// Under these the help of a command lists options that others have too; what is its own stands before them.
inline constexpr const char* asked_group = "Kernels and queries";
inline constexpr const char* required_group = "What has to hold";
inline constexpr const char* output_group = "Output";
inline constexpr const char* running_group = "How it runs";

// A command line that can be tried, and what it is for. Its files are mine.jsonl and mine.csv, queries; my_kernel.so,
// a plug-in; and folders that other examples write.
struct Example {
  std::string about, line;
};
void add_examples(CLI::App& command, const std::vector<Example>& examples);
std::vector<Example> examples_of(const CLI::App& command);

// "KERNEL", "UINT", "{text,csv}": what stands for the value of an option; empty of a flag.
std::string value_label(const CLI::Option& option);

// The text in lines of at most `width` columns, each but the first after `indent` spaces; a word that is longer has a
// line of its own.
std::string wrapped(const std::string& text, std::size_t width, std::size_t indent);

class Help final : public CLI::Formatter {
 public:
  std::string make_help(const CLI::App* app, std::string name, CLI::AppFormatMode mode) const override;
};

}  // namespace axiscert
