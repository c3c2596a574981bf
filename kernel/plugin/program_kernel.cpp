#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <memory>
#include <mutex>
#include <sstream>

#include "kernel/base/error.h"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/declared.h"
#include "kernel/plugin/load.h"
#include "kernel/plugin/manifest.h"
#include "kernel/plugin/supervisor.h"

namespace axiscert::plugin {
namespace {

constexpr std::size_t longest_manifest = std::size_t{1} << 20;  // bytes
constexpr const char* lock_file = "package-lock.json";

std::string folder_of(const std::string& manifest) {
  return std::filesystem::absolute(manifest).parent_path().string();
}

template <std::size_t size>
void put(char (&to)[size], const std::string& from, bool& is_truncated) {
  std::snprintf(to, size, "%s", from.c_str());
  is_truncated |= from.size() >= size;
}

// The manifest in the words in which a plug-in describes itself.
Description described(const Manifest& manifest, Precision precision) {
  Description d = {};
  d.abi = AXISCERT_PLUGIN_ABI;
  d.precision = precision == Precision::binary32 ? 32 : 64;
  d.exposes = static_cast<std::uint32_t>(manifest.exposes);
  d.touching = static_cast<std::uint32_t>(manifest.touching);
  d.size = d.least_size = sizeof(axiscert_kernel);
  const Predicate& predicate = predicate_named(manifest.predicate);
  d.column_count = predicate.entries[find_entry(predicate, manifest.entry)].columns.size();
  d.measure_count = manifest.measures;
  d.start = static_cast<std::uint32_t>(manifest.motion.start);
  d.still = static_cast<std::uint32_t>(manifest.motion.still);
  const bool has_motions = is_of_motions(predicate);
  if (has_motions && manifest.limits.sides != SidesPolicy::both)
    throw Error(fmt::format("\"sides\": predicate '{}' is of motions: give it in \"motion\"", predicate.id));
  if (!has_motions && manifest.motion.sides != SidesPolicy::both)
    throw Error(fmt::format("\"motion\": predicate '{}' has none; \"sides\" stands beside it", predicate.id));
  d.sides = static_cast<std::uint32_t>(has_motions ? manifest.motion.sides : manifest.limits.sides);
  d.may_decline = manifest.may_decline ? 1 : 0;
  const Limits& l = manifest.limits;
  const double limits[] = {l.least_coordinate, l.greatest_coordinate, l.least_area,
                           l.least_radius,     l.greatest_radius,     l.margin};
  static_assert(sizeof limits == sizeof d.limits);
  std::copy(std::begin(limits), std::end(limits), d.limits);
  d.has_run = true;
  d.has_conforms_to = !manifest.conforms_to.empty();
  d.has_formulae = !manifest.formulae.empty();
  put(d.name, manifest.name, d.is_truncated);
  std::string summary = manifest.summary;
  if (!manifest.package.empty()) {
    const std::string of = manifest.version.empty() ? manifest.package : manifest.package + " " + manifest.version;
    summary = summary.empty() ? of : fmt::format("{} ({})", summary, of);
  }
  put(d.summary, summary, d.is_truncated);
  put(d.predicate, manifest.predicate, d.is_truncated);
  put(d.entry, manifest.entry, d.is_truncated);
  put(d.conforms_to, manifest.conforms_to, d.is_truncated);
  put(d.formulae, manifest.formulae, d.is_truncated);
  put(d.source, manifest.source, d.is_truncated);
  return d;
}

// Throws Error, which says what is meant, where the path is not that of a file.
void require_manifest(const std::string& id, const std::string& path) {
  if (std::filesystem::is_regular_file(path)) return;
  const char* const what = path.empty()                          ? "no path after 'program:'"
                           : std::filesystem::is_directory(path) ? "that is a directory"
                                                                 : "there is no such file";
  throw Error(fmt::format("kernel '{}': {}; give the path of a program's manifest, as in {}my_kernel.json", id, what,
                          by_manifest));
}

// Throws Error where the command's program is not there.
void require_program(const Manifest& manifest, const std::string& path, const std::string& folder) {
  const std::string& word = manifest.command.front();
  if (!program_file(word, folder).empty()) return;
  const std::filesystem::path beside = std::filesystem::path(folder) / word;
  if (word.find('/') != word.npos) {
    throw Error(fmt::format("{}: \"command\": {} {}", path, word,
                            std::filesystem::exists(beside) ? "cannot be executed" : "is not there"));
  }
  throw Error(
      fmt::format("{}: \"command\": the program {} is not installed{}", path, word,
                  std::filesystem::exists(beside) ? fmt::format("; a file beside the manifest is ./{}", word) : ""));
}

// One trial start, before the first question of all; who asks next finds what came of it.
class TryOut {
 public:
  TryOut(std::string id, HostedPlugin hosted, Subject subject, Precision precision)
      : id_(std::move(id)), hosted_(std::move(hosted)), subject_(subject), precision_(precision) {}

  // Throws Error where the program fails with no queries at all.
  void require_success() {
    const std::lock_guard lock(mutex_);
    if (!is_done_) {
      HostProcess host(hosted_, subject_);
      Request request = {};
      request.kernel = static_cast<std::uint32_t>(index_of(precision_));
      request.start_seconds = program_start * batch_seconds;
      Reply reply;
      if (const auto stop = host.call(request, request.start_seconds, reply)) failure_ = stop->detail;
      is_done_ = true;
    }
    if (!failure_.empty())
      throw Error(fmt::format("kernel '{}': {}: {}", id_, fmt::join(hosted_.command, " "), failure_));
  }

 private:
  std::string id_;
  HostedPlugin hosted_;
  Subject subject_;
  Precision precision_;
  std::mutex mutex_;
  bool is_done_ = false;
  std::string failure_;
};

template <class Real>
void try_first(const std::shared_ptr<TryOut>& out, std::function<Implementation<Real>(std::string_view)>& made) {
  if (!made) return;
  made = [out, make = std::move(made)](std::string_view target) {
    out->require_success();
    return make(target);
  };
}

}  // namespace

bool is_program(std::string_view id, std::string_view file) {
  return id.starts_with(by_manifest) || (!id.starts_with(by_path) && file.ends_with(".json"));
}

std::string manifest_text(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string text(longest_manifest + 1, '\0');
  in.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (in.bad() || (!in && !in.eof())) throw Error(fmt::format("{}: cannot be read", path));
  text.resize(static_cast<std::size_t>(in.gcount()));
  if (text.size() > longest_manifest)
    throw Error(fmt::format("{}: not a manifest: longer than {} bytes", path, longest_manifest));
  return text;
}

std::string program_file(const std::string& word, const std::string& folder) {
  const auto runs = [](const std::filesystem::path& file) {
    return std::filesystem::is_regular_file(file) && access(file.c_str(), X_OK) == 0;
  };
  if (word.find('/') != word.npos) {
    const std::filesystem::path file = std::filesystem::path(folder) / word;
    return runs(file) ? file.string() : "";
  }
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "/usr/local/bin:/usr/bin:/bin");
  for (std::string one; std::getline(folders, one, ':');) {
    const std::filesystem::path file = std::filesystem::path(one.empty() ? folder : one) / word;
    if (runs(file)) return file.string();
  }
  return "";
}

std::vector<KernelFile> files_of(const Kernel& kernel) {
  if (!is_program(kernel)) return {{"plugin", kernel.file}};
  std::vector<KernelFile> files = {{"manifest", kernel.file}};
  const std::filesystem::path folder = folder_of(kernel.file);
  std::size_t number = 0;
  const Manifest manifest = read_manifest(manifest_text(kernel.file), kernel.file);
  for (const std::string& word : manifest.command) {
    const std::filesystem::path file = folder / word;
    std::error_code none;
    if (word.empty() || !std::filesystem::is_regular_file(file, none)) continue;
    files.push_back({++number == 1 ? "program" : fmt::format("program-{}", number), file.string()});
  }
  number = 0;
  for (const std::string& file : manifest.files) {
    files.push_back({++number == 1 ? "file" : fmt::format("file-{}", number), (folder / file).string()});
  }
  if (std::filesystem::is_regular_file(folder / lock_file)) files.push_back({"lock", (folder / lock_file).string()});
  return files;
}

Kernel load_program(const std::string& id, const std::string& path) {
  require_utf8(id, "kernel");
  require_manifest(id, path);
  const Manifest manifest = read_manifest(manifest_text(path), path);
  const std::string folder = folder_of(path);
  require_program(manifest, path, folder);
  for (const std::string& file : manifest.files) {
    std::error_code none;
    if (!std::filesystem::is_regular_file(std::filesystem::path(folder) / file, none)) {
      throw Error(fmt::format("{}: \"files\": '{}' is not the name of a file", path, printable_line(file)));
    }
  }
  Kernel kernel;
  kernel.id = printable_line(id);
  kernel.file = path;
  const HostedPlugin hosted{folder, manifest.command};
  try {
    for (const Precision precision : manifest.precisions) {
      add_declared(described(manifest, precision), static_cast<std::uint32_t>(index_of(precision)), hosted, kernel);
    }
  } catch (const RefusedClaim& refused) {
    throw Error(fmt::format("{}: {}", path, refused.detail));
  } catch (const Error& unknown) {
    throw Error(fmt::format("{}: {}", path, unknown.what()));
  }
  const auto out = std::make_shared<TryOut>(
      kernel.id, hosted, Subject{kernel.predicate, kernel.entry, kernel.measure_count}, manifest.precisions.front());
  try_first<float>(out, kernel.binary32);
  try_first<double>(out, kernel.binary64);
  return kernel;
}

}  // namespace axiscert::plugin
