// Folders: where this program is, beside which it finds what comes with it; and one for scratch files, which no other
// process has.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

namespace axiscert {

// The folder of the command; of a library that another program has loaded, the one that set_own_folder() was given.
std::filesystem::path own_folder();
// Before anything is looked for.
void set_own_folder(const std::filesystem::path& folder);

// Made under the system's folder for temporary files, and removed with all that is in it. Tests run side by side, also
// as processes of several builds, so a file with a fixed name there is another's as well.
class TemporaryFolder {
 public:
  TemporaryFolder();  // throws Error
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder& operator=(const TemporaryFolder&) = delete;

  // Without symbolic links.
  const std::filesystem::path& path() const { return path_; }
  // The path of the file of this name, which now has these bytes; its folder exists. Throws Error.
  std::string write(std::string_view name, std::string_view bytes) const;

 private:
  std::filesystem::path path_;
};

}  // namespace axiscert
