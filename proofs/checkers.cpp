#include "proofs/checkers.h"

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>

#include "kernel/base/error.h"
#include "kernel/base/folders.h"

namespace axiscert::proofs {
namespace {

namespace fs = std::filesystem;

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

}  // namespace

std::optional<std::string> gappa_version() { return first_line("gappa --version"); }
std::optional<std::string> coq_version() { return first_line("coqc --version"); }

bool gappa_accepts(const std::string& script) {
  const TemporaryFolder scratch;
  return succeeds("gappa '" + scratch.write("bound.g", script) + "'");
}

bool coq_accepts_ranges(const std::string& folder, const std::string& claimed) {
  const TemporaryFolder scratch;
  const fs::path ranges = fs::path(folder) / "coq" / "formulae" / "Ranges.v";
  std::error_code fault;
  fs::copy_file(ranges, scratch.path() / "Ranges.v", fault);
  if (fault) throw Error(ranges.string() + ": cannot be read: " + fault.message());
  scratch.write("RangesClaimed.v", claimed);
  const std::string coqc = "cd '" + scratch.path().string() + "' && coqc -Q . Axiscert ";
  return succeeds(coqc + "Ranges.v") && succeeds(coqc + "RangesClaimed.v");
}

}  // namespace axiscert::proofs
