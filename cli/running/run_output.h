// The output of `axiscert run`: the run folder, the summary.
#pragma once

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "exact/judge/judge.h"
#include "fuzz/campaign/campaign.h"
#include "fuzz/confirm/record.h"
#include "fuzz/record/record.h"

namespace axiscert {
// Output that depends on whether a person sees it: colour.

enum class TextColour { red, yellow, green };

// Whether standard output is a terminal that shows colours, and NO_COLOR is not set to any value.
bool output_has_colour();
// The text in that colour where output_has_colour(), otherwise unchanged. A line end stays outside the colour.
std::string coloured(const std::string& text, TextColour colour);

// The folder of a run. It is created, and checked to be writable, before anything runs; a file appears in it whole or
// not at all.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& path);  // throws Error
  void write(const std::string& file, const Json& json) const;
  void write_text(const std::string& file, const std::string& text) const;  // whole or not at all
  void remove(const std::string& file) const;                               // where it exists
  // Saves the query on which the oracles disagree, and returns the file's path.
  std::string save(const OracleDisagreement& disagreement) const;

 private:
  std::filesystem::path path_;
};

std::string iso_time(std::chrono::system_clock::time_point time);
// The final output of `run`: findings first, each with the command that reproduces it, then causes and the sentences
// about each kernel and precision, then tables; in colour on a terminal.
std::string summary_text(const Record& record, double seconds);

}  // namespace axiscert
