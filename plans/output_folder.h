// The folder that a command writes its results in.
#pragma once

#include <chrono>
#include <filesystem>
#include <string>

#include "exact/judge/judge.h"
#include "fuzz/text/json.h"

namespace axiscert {

// Creates the folder of `--out` where it does not exist yet. Throws Error where nothing can be written there.
void make_folder(const std::string& path);

// The folder of a run. It is created, and checked to be writable, before anything runs; a file appears in it whole or
// not at all.
class OutputFolder {
 public:
  explicit OutputFolder(const std::string& path);  // throws Error
  std::string path(const std::string& file) const { return (path_ / file).string(); }
  void write(const std::string& file, const Json& json) const;
  void write_text(const std::string& file, const std::string& text) const;  // whole or not at all
  void remove(const std::string& file) const;                               // where it exists
  // Saves the query on which the oracles disagree, and returns the file's path.
  std::string save(const OracleDisagreement& disagreement) const;

 private:
  std::filesystem::path path_;
};

std::string iso_time(std::chrono::system_clock::time_point time);

}  // namespace axiscert
