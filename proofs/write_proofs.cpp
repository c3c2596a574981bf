// write_proofs FOLDER: writes every file of emit.h under FOLDER.
#include <filesystem>
#include <fstream>
#include <iostream>

#include "proofs/emit.h"

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: write_proofs FOLDER\n";
    return 2;
  }
  for (const auto& [name, text] : axiscert::proofs::proof_files()) {
    const std::filesystem::path path = std::filesystem::path(argv[1]) / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream out(path, std::ios::binary);
    out << text;
    if (!out.flush()) {
      std::cerr << path.string() << ": cannot be written\n";
      return 2;
    }
  }
}
