#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <map>

#include "kernel/base/error.h"
#include "kernel/plugin/host_process.h"
#include "kernel/plugin/load.h"
#include "kernel/plugin/manifest.h"

namespace axiscert::plugin {
namespace {

constexpr std::string_view peers_folder = "peers", faults_folder = "faults";
constexpr std::string_view programs_folder = "npm";  // in that of the peers

// The command that brings the packages of the programs in `folder`, which in a build tree is a link to the source's.
std::string engines_command(const std::filesystem::path& folder) {
  if (std::filesystem::is_symlink(folder)) return "./dev engines";
  return fmt::format("npm ci --ignore-scripts --prefix {}", std::filesystem::weakly_canonical(folder).string());
}

// Plug-ins of a predicate, in `folder`; where ids name the predicate, in a folder of its name there.
struct Kind {
  const Predicate* predicate;
  std::string prefix;
  std::string_view folder;
  std::string inside;  // of `folder`: "", or "moving-sphere/"
};

std::vector<Kind> kinds() {
  std::vector<Kind> all;
  for (const Predicate* predicate : predicates()) {
    const std::string inside = id_prefix(*predicate);
    all.push_back({predicate, inside + "peer/", peers_folder, inside});
    all.push_back({predicate, inside + "fault/", faults_folder, inside});
  }
  return all;
}

// A program that comes along: its manifest, and the package or program that it needs and that is not here.
struct ShippedProgram {
  std::string manifest, missing;
};

// Those that answer a predicate, in PEERS/npm/PREDICATE, by the names that they declare. The packages are in PEERS/npm.
std::map<std::string, ShippedProgram> shipped_programs(const std::filesystem::path& peers, const Predicate& predicate) {
  std::map<std::string, ShippedProgram> found;
  const std::filesystem::path folder = peers / programs_folder, inside = folder / predicate.id;
  std::error_code none;
  for (std::filesystem::directory_iterator at(inside, none), end; !none && at != end; at.increment(none)) {
    if (at->path().extension() != ".json") continue;
    const std::string path = at->path().string();
    const Manifest manifest = read_manifest(manifest_text(path), path);
    ShippedProgram& program = found[manifest.name];
    program.manifest = path;
    if (program_file(manifest.command.front(), inside).empty()) program.missing = manifest.command.front();
    else if (!manifest.package.empty() && !std::filesystem::is_directory(folder / "node_modules" / manifest.package))
      program.missing = manifest.package;
  }
  return found;
}

// The plug-ins of one kind, and their files by name.
struct LocatedPlugins {
  ShippedPlugins found;
  std::map<std::string, std::string, std::less<>> files;
};

// Reads the folder of a kind.
LocatedPlugins read_kind(const Kind& kind) {
  LocatedPlugins all;
  ShippedPlugins& found = all.found;
  found.predicate = kind.predicate;
  found.prefix = kind.prefix;
  const auto folder = shipped_folder(kind.folder);
  if (!folder) return all;
  std::error_code none;
  const std::filesystem::path inside = std::filesystem::path(*folder) / kind.inside;
  for (std::filesystem::directory_iterator at(inside, none), end; !none && at != end; at.increment(none)) {
    if (at->path().extension() != ".so") continue;
    found.names.push_back(at->path().stem().string());
    all.files[found.names.back()] = at->path().string();
  }
  std::sort(found.names.begin(), found.names.end());
  // Lines "NAME<TAB>package", and "PREDICATE/NAME<TAB>package" for the others.
  std::ifstream list(std::filesystem::path(*folder) / "absent.txt");
  for (std::string line; std::getline(list, line);) {
    const std::size_t tab = line.find('\t'), slash = line.substr(0, tab).rfind('/');
    if (tab == line.npos || line.substr(0, slash == line.npos ? 0 : slash + 1) != kind.inside) continue;
    found.absent.push_back({line.substr(kind.inside.size(), tab - kind.inside.size()), line.substr(tab + 1), ""});
  }
  if (kind.folder != peers_folder) return all;
  for (const auto& [name, program] : shipped_programs(*folder, *kind.predicate)) {
    if (!program.missing.empty()) {
      found.absent.push_back(
          {name, program.missing, engines_command(std::filesystem::path(*folder) / programs_folder)});
      continue;
    }
    found.names.push_back(name);
    all.files[name] = program.manifest;
  }
  return all;
}

}  // namespace

std::vector<ShippedPlugins> shipped_plugins() {
  std::vector<ShippedPlugins> all;
  for (const Kind& kind : kinds()) all.push_back(read_kind(kind).found);
  return all;
}

std::optional<std::string> plugin_path(std::string_view id) {
  for (const std::string_view prefix : {by_path, by_manifest}) {
    if (id.starts_with(prefix)) return std::string(id.substr(prefix.size()));
  }
  for (const Kind& kind : kinds()) {
    if (!id.starts_with(kind.prefix)) continue;
    const auto [known, files] = read_kind(kind);
    const std::string_view name = id.substr(kind.prefix.size());
    if (const auto file = files.find(name); file != files.end()) return file->second;
    for (const ShippedPlugins::Absent& absent : known.absent) {
      if (absent.name == name && !absent.command.empty()) {
        throw Error(fmt::format("kernel '{}' is not installed, for want of {}; `{}` installs it", id, absent.package,
                                absent.command));
      }
      if (absent.name == name) {
        throw Error(fmt::format("kernel '{}' was not built, for want of the Debian package {}", id, absent.package));
      }
    }
    const std::vector<std::string_view> names(known.names.begin(), known.names.end());
    const std::string_view guess = meant(name, names);
    throw Error(fmt::format(
        "unknown kernel '{}'{} {}", id, guess.empty() ? ";" : fmt::format("; did you mean '{}{}'?", kind.prefix, guess),
        names.empty()
            ? fmt::format("this axiscert was built without those of {}", kind.prefix)
            : names_alike(fmt::format("kernels of {}", kind.prefix), name, names, "axiscert kernels --format json")));
  }
  return std::nullopt;
}

}  // namespace axiscert::plugin
