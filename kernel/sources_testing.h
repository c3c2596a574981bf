// The definitions in the sources of a folder, so that a test finds those that lack their line in a list.
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <sstream>
#include <string>

namespace axiscert::testing_support {

// The first group of each match of `pattern` in the .cpp files of the folder and those below it, with its file. Fails
// where there is none.
inline std::map<std::string, std::string> defined_in(const std::string& folder, const char* pattern) {
  const std::filesystem::path root = SOURCE_FOLDER;
  const std::regex wanted(pattern);
  std::map<std::string, std::string> found;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(root / folder)) {
    if (entry.path().extension() != ".cpp") continue;
    std::ostringstream stream;
    stream << std::ifstream(entry.path()).rdbuf();
    const std::string text = stream.str();
    for (std::sregex_iterator match(text.begin(), text.end(), wanted), end; match != end; ++match)
      found.emplace((*match)[1], entry.path().lexically_relative(root).string());
  }
  EXPECT_FALSE(found.empty()) << "no source below " << folder << " matches " << pattern;
  return found;
}

}  // namespace axiscert::testing_support
