#include "kernel/base/own_folder.h"

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

}  // namespace axiscert
