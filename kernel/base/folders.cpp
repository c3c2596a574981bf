#include "kernel/base/folders.h"

#include <stdlib.h>

#include <cerrno>
#include <cstring>
#include <fstream>

#include "kernel/base/error.h"

namespace axiscert {
namespace {

std::filesystem::path& given_folder() {
  static std::filesystem::path folder;
  return folder;
}

}  // namespace

std::filesystem::path own_folder() {
  if (!given_folder().empty()) return given_folder();
  std::error_code none;
  return std::filesystem::read_symlink("/proc/self/exe", none).parent_path();
}

void set_own_folder(const std::filesystem::path& folder) { given_folder() = folder; }

TemporaryFolder::TemporaryFolder() {
  std::string pattern = (std::filesystem::temp_directory_path() / "axiscert-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern + ": cannot be created: " + std::strerror(errno));
  path_ = std::filesystem::canonical(pattern);
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string TemporaryFolder::write(std::string_view name, std::string_view bytes) const {
  const std::string path = (path_ / name).string();
  std::ofstream file(path, std::ios::binary);
  file << bytes;
  if (!file.flush()) throw Error(path + ": cannot be written");
  return path;
}

}  // namespace axiscert
