// write_proofs FOLDER: writes every generated file under FOLDER, which is proofs/ of the source tree.
// write_proofs --check FOLDER: names those that are not current, and exits 1 if there are any.
#include <filesystem>
#include <fstream>
#include <iostream>
#include <sstream>

#include "proofs/emit/emit.h"

namespace {

std::string read(const std::filesystem::path& path) {
  std::ostringstream text;
  text << std::ifstream(path, std::ios::binary).rdbuf();
  return text.str();
}

}  // namespace

int main(int argc, char** argv) {
  const bool check = argc == 3 && std::string_view(argv[1]) == "--check";
  if (argc != 2 && !check) {
    std::cerr << "usage: write_proofs [--check] FOLDER\n";
    return 2;
  }
  const std::filesystem::path folder = argv[argc - 1];
  int stale = 0;
  for (const auto& [name, text] : axiscert::proofs::proof_files()) {
    const std::filesystem::path path = folder / name;
    if (read(path) == text) continue;
    if (check) {
      std::cerr << path.string() << ": not what write_proofs makes of the formulae\n";
      ++stale;
      continue;
    }
    std::filesystem::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) {
      std::cerr << path.string() << ": cannot be written\n";
      return 2;
    }
    std::cout << path.string() << "\n";
  }
  return stale == 0 ? 0 : 1;
}
