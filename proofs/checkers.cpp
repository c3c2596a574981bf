#include "proofs/checkers.h"

#include <stdlib.h>
#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "kernel/base/error.h"

namespace axiscert::proofs {
namespace {

namespace fs = std::filesystem;

// A temporary folder, removed at the end.
class Scratch {
 public:
  Scratch() {
    std::string pattern = (fs::temp_directory_path() / "axiscert-prove-XXXXXX").string();
    if (mkdtemp(pattern.data()) == nullptr) throw Error(pattern + ": cannot be created");
    path_ = pattern;
  }
  ~Scratch() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

bool succeeds(const std::string& command) {
  const int status = std::system((command + " >/dev/null 2>&1").c_str());
  return status != -1 && WIFEXITED(status) && WEXITSTATUS(status) == 0;
}

std::optional<std::string> first_line(const std::string& command) {
  FILE* pipe = popen((command + " 2>/dev/null").c_str(), "r");
  if (pipe == nullptr) return std::nullopt;
  std::array<char, 256> line{};
  const bool read = std::fgets(line.data(), static_cast<int>(line.size()), pipe) != nullptr;
  if (pclose(pipe) != 0 || !read) return std::nullopt;
  std::string text = line.data();
  while (!text.empty() && text.back() == '\n') text.pop_back();
  return text;
}

void write(const fs::path& path, const std::string& text) {
  std::ofstream out(path, std::ios::binary);
  out << text;
  if (!out.flush()) throw Error(path.string() + ": cannot be written");
}

}  // namespace

std::optional<std::string> gappa_version() { return first_line("gappa --version"); }
std::optional<std::string> coq_version() { return first_line("coqc --version"); }

bool gappa_accepts(const std::string& script) {
  const Scratch scratch;
  write(scratch.path() / "bound.g", script);
  return succeeds("gappa '" + (scratch.path() / "bound.g").string() + "'");
}

bool coq_accepts_ranges(const std::string& folder, const std::string& claimed) {
  const Scratch scratch;
  const fs::path ranges = fs::path(folder) / "coq" / "Ranges.v";
  std::error_code fault;
  fs::copy_file(ranges, scratch.path() / "Ranges.v", fault);
  if (fault) throw Error(ranges.string() + ": cannot be read: " + fault.message());
  write(scratch.path() / "RangesClaimed.v", claimed);
  const std::string coqc = "cd '" + scratch.path().string() + "' && coqc -Q . Axiscert ";
  return succeeds(coqc + "Ranges.v") && succeeds(coqc + "RangesClaimed.v");
}

}  // namespace axiscert::proofs
