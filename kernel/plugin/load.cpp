#include "kernel/plugin/load.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "kernel/base/alike.h"
#include "kernel/base/error.h"
#include "kernel/include/axiscert/plugin.h"
#include "kernel/plugin/interface_1.h"
#include "kernel/plugin/supervisor.h"
#include "kernel/base/utf8.h"

namespace axiscert::plugin {
namespace {

static_assert(most_columns == AXISCERT_MOST_COLUMNS && most_comparisons == AXISCERT_MOST_COMPARISONS &&
              most_measures == AXISCERT_MOST_MEASURES);

constexpr double load_seconds = 20;  // of processor time; large libraries take their time

struct Kind {
  std::string_view prefix, folder;
};
constexpr Kind kinds[] = {{"peer/", "peers"}, {"fault/", "faults"}};

// A claim of a plug-in that cannot be true; thrown in this file, a finding outside it.
struct Refused {
  FindingKind kind;
  std::string detail;
};
[[noreturn]] void refuse(std::string detail) { throw Refused{FindingKind::load, std::move(detail)}; }

template <class Enum>
Enum one_of(std::uint32_t value, std::size_t count, const char* member) {
  if (value >= count) refuse(fmt::format("its {} is {}; known: 0 to {}", member, value, count - 1));
  return static_cast<Enum>(value);
}

// Texts are shown in reports: one line of printable ASCII, a question mark for any other byte.
std::string text_of(const char* text) {
  std::string clean = text;
  for (char& c : clean) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
    else if (static_cast<unsigned char>(c) > 0x7e) c = '?';
  }
  return clean;
}

// The kernel that a plug-in claims to be like: a built-in one that exists in its precision.
const Kernel& builtin(const char* member, const std::string& id, Precision precision) {
  const Kernel* kernel = nullptr;
  try {
    kernel = &find_kernel(id);
  } catch (const Error&) {
  }
  if (kernel == nullptr || !kernel->file.empty()) {
    refuse(fmt::format("its {} is '{}', which is no built-in kernel; `axiscert kernels` lists those", member, id));
  }
  if (!kernel->has(precision)) {
    refuse(fmt::format("its {} is '{}', which does not exist in {}", member, id, name(precision)));
  }
  return *kernel;
}

// The check comes first, because nothing else is known of a struct that is too short.
void check_sizes(const Description& d) {
  const auto check = [](const char* of, const char* type, std::size_t size, std::size_t least) {
    if (size < least) {
      refuse(fmt::format("{} has the size {}; sizeof({}) was expected, at least {}", of, size, type, least));
    }
  };
  check("it", "axiscert_kernel", d.size, d.least_size);
  if (d.has_limits) check("its `limits`", "axiscert_limits", d.limits_size, d.least_limits_size);
}

// The test and entry of the kernel. Refuses unknown ones, and counts that differ from theirs.
void subject(const Description& d, Kernel& kernel) {
  try {
    if (d.test[0] != 0) kernel.test = &find_test(text_of(d.test));
    kernel.entry = find_entry(*kernel.test, text_of(d.entry));
  } catch (const Error& unknown) {
    refuse(fmt::format("what it answers: {}; `axiscert tests` lists them", unknown.what()));
  }
  const TestEntry& entry = kernel.test->entries[kernel.entry];
  if (d.column_count != entry.columns.size()) {
    refuse(fmt::format("it reads {} columns; test '{}' in entry '{}' has {}", d.column_count, kernel.test->id,
                       entry.name, entry.columns.size()));
  }
  if (d.measure_count > kernel.test->measures.size()) {
    refuse(fmt::format("it gives {} measures; test '{}' has {}", d.measure_count, kernel.test->id,
                       kernel.test->measures.size()));
  }
}

Limits limits_of(const Description& d) {
  const Limits limits{d.limits[0], d.limits[1], d.limits[2], d.limits[3], d.limits[4]};
  for (const double limit : d.limits) {
    if (!(limit >= 0) || !std::isfinite(limit)) refuse(fmt::format("a limit is {}; known: finite, from 0 on", limit));
  }
  return limits;
}

void claim(const Description& d, Kernel& kernel) {
  const Precision precision = d.precision == 32 ? Precision::binary32 : Precision::binary64;
  kernel.is_reference = d.has_conforms_to;
  kernel.formulae = Formulae::none;
  if (d.has_conforms_to) {
    const Kernel& own = builtin("conforms_to", text_of(d.conforms_to), precision);
    kernel.formulae = own.formulae;
    kernel.strictness = own.strictness;
    kernel.arithmetic = own.arithmetic;
    if (!own.is_reference) refuse(fmt::format("it conforms_to '{}', whose bits depend on its target", own.id));
  } else if (d.has_formulae || kernel.exposes != Exposure::verdict) {
    const Kernel& own = builtin("formulae", d.has_formulae ? text_of(d.formulae) : "published", precision);
    kernel.formulae = own.formulae;
    kernel.strictness = own.strictness;
  }
  if (kernel.is_reference && kernel.touching != Touching::contact) {
    refuse(fmt::format("it conforms_to '{}', for which touching is contact, and says that for it touching is '{}'",
                       text_of(d.conforms_to), name(kernel.touching)));
  }
  if (kernel.exposes != Exposure::verdict && !has_comparisons(kernel.formulae)) {
    refuse(fmt::format("it exposes comparisons, but formulae '{}' have none", name(kernel.formulae)));
  }
}

void add(const Description& d, std::uint32_t index, const std::string& path, Kernel& kernel) {
  if (d.abi != AXISCERT_PLUGIN_ABI && d.abi != interface_1::number) {
    throw Refused{FindingKind::abi,
                  fmt::format("it was made for version {} of the plug-in interface; this axiscert knows {} and {}",
                              d.abi, interface_1::number, AXISCERT_PLUGIN_ABI)};
  }
  check_sizes(d);
  if (d.precision != 32 && d.precision != 64) refuse(fmt::format("its precision is {}; known: 32, 64", d.precision));
  if (!d.has_run) refuse("it has no function `run`");
  if (d.is_truncated) refuse("one of its texts is too long");
  Kernel described;
  subject(d, described);
  described.source = text_of(d.source);
  described.exposes = one_of<Exposure>(d.exposes, exposure_names.size(), "exposure");
  described.touching = one_of<Touching>(d.touching, touching_names.size(), "touching convention");
  described.limits = limits_of(d);
  described.summary = d.summary[0] != 0 ? fmt::format("{}: {}", text_of(d.name), text_of(d.summary)) : text_of(d.name);
  if (d.name[0] == 0) refuse("it has no name");
  described.declared_name = kernel.declared_name.empty() ? text_of(d.name) : kernel.declared_name;
  claim(d, described);
  const bool is_first = !kernel.binary32 && !kernel.binary64;
  if (!is_first &&
      (described.exposes != kernel.exposes || described.touching != kernel.touching ||
       described.limits != kernel.limits || described.test != kernel.test || described.entry != kernel.entry ||
       described.formulae != kernel.formulae || described.strictness != kernel.strictness ||
       described.arithmetic != kernel.arithmetic || described.is_reference != kernel.is_reference)) {
    refuse("its kernels in binary32 and in binary64 say different things of themselves; make two plug-ins of them");
  }
  const Supervised supervised{
      {path, index, d.abi, {described.test, described.entry}}, described.exposes, described.strictness};
  if (d.precision == 32 ? kernel.binary32 != nullptr : kernel.binary64 != nullptr) {
    refuse(fmt::format("it has two kernels of precision {}", d.precision));
  }
  if (d.precision == 32) {
    described.binary32 = [=](std::string_view) { return supervised_implementation<float>(supervised); };
    described.binary64 = kernel.binary64;
  } else {
    described.binary64 = [=](std::string_view) { return supervised_implementation<double>(supervised); };
    described.binary32 = kernel.binary32;
  }
  described.id = kernel.id;
  described.file = kernel.file;
  kernel = std::move(described);
}

// The plug-ins of one kind, read from its folder.
Shipped shipped(const Kind& kind) {
  Shipped found;
  found.prefix = kind.prefix;
  const auto folder = shipped_folder(kind.folder);
  if (!folder) return found;
  for (const auto& entry : std::filesystem::directory_iterator(*folder)) {
    if (entry.path().extension() == ".so") found.names.push_back(entry.path().stem().string());
  }
  std::sort(found.names.begin(), found.names.end());
  std::ifstream list(std::filesystem::path(*folder) / "absent.txt");
  for (std::string line; std::getline(list, line);) {
    const std::size_t tab = line.find('\t');
    if (tab != line.npos) found.absent.push_back({line.substr(0, tab), line.substr(tab + 1)});
  }
  return found;
}

// The shared objects of a folder, by their names, at most a hundred.
std::vector<std::string> shared_objects(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code unreadable;
  for (std::filesystem::directory_iterator at(folder, unreadable), end; !unreadable && at != end && names.size() < 100;
       at.increment(unreadable)) {
    if (at->path().extension() == ".so") names.push_back(at->path().filename().string());
  }
  std::sort(names.begin(), names.end());
  return names;
}

// Throws Error, which guesses what file was meant, where the path is not that of a file.
void require_file(const std::string& id, const std::string& path) {
  if (std::filesystem::is_regular_file(path)) return;
  const auto refuse_path = [&](const std::string& what) {
    throw Error(fmt::format("kernel '{}': {} Give the path of a plug-in's shared object, as in {}my_kernel.so", id,
                            what, by_path));
  };
  if (path.empty()) refuse_path(fmt::format("no path after '{}'.", by_path));
  const std::filesystem::path given(path);
  const bool is_folder = std::filesystem::is_directory(given);
  const std::filesystem::path folder = is_folder ? given : given.parent_path();
  const std::vector<std::string> found = shared_objects(folder.empty() ? "." : folder);
  const std::vector<std::string_view> names(found.begin(), found.end());
  if (is_folder) {
    refuse_path(fmt::format("{} is a directory{}.", path,
                            names.empty() ? "" : fmt::format(", which has {}", fmt::join(names, ", "))));
  }
  const std::string_view name = meant(given.filename().string(), names);
  const std::string guess = name.empty() ? "." : fmt::format("; did you mean {}{}?", by_path, (folder / name).string());
  if (std::filesystem::exists(given)) refuse_path(fmt::format("{} is not a file{}", path, guess));
  refuse_path(fmt::format("there is no file {}{}", path, guess));
}

}  // namespace

std::string misnamed_path(std::string_view id) {
  const auto begins_alike = [&] {
    return id.size() >= by_path.size() - 1 &&
           std::equal(by_path.begin(), by_path.end() - 1, id.begin(),
                      [](char wanted, char given) { return wanted == (given | 0x20); });
  };
  if (id == by_path.substr(0, by_path.size() - 1)) return "PATH.so";
  if (begins_alike() && id.size() > by_path.size() &&
      !std::isalnum(static_cast<unsigned char>(id[by_path.size() - 1]))) {
    return std::string(id.substr(by_path.size()));
  }
  if (id.ends_with(".so")) return std::string(id);
  std::error_code ignored;
  const std::string beside = std::string(id) + ".so";
  if (!id.empty() && std::filesystem::is_regular_file(beside, ignored)) return beside;
  return id.find('/') != id.npos && std::filesystem::exists(id, ignored) ? std::string(id) : "";
}

Kernel load_plugin(std::string id, const std::string& path) {
  require_utf8(id, "kernel");
  require_file(id, path);
  // With a slash, so that it is this file and not one of that name in the library path.
  const std::string absolute = std::filesystem::absolute(path).string();
  Kernel kernel;
  kernel.id = id;
  kernel.file = path;
  try {
    HostProcess host(absolute);
    if (const auto stop = host.start(load_seconds)) throw Refused{stop->kind, "while it was loaded: " + stop->detail};
    const Control& control = host.control();
    if (control.load_error[0] != 0) refuse(fmt::format("it cannot be loaded: {}", text_of(control.load_error)));
    if (control.kernel_count == 0) refuse("its axiscert_plugin(0) gives no kernel");
    if (control.kernel_count > most_kernels) refuse(fmt::format("it has more than {} kernels", most_kernels));
    for (std::uint32_t i = 0; i < control.kernel_count; ++i) add(control.kernels[i], i, absolute, kernel);
    // It is called in the default environment all the same; whoever else loads it is not.
    if (control.changed != 0) {
      kernel.findings.push_back({FindingKind::environment, 0,
                                 fmt::format("loading it left changed: {}; -ffast-math links code that does that",
                                             changed_modes(control.changed))});
    }
  } catch (const Refused& refused) {
    Kernel unusable;
    unusable.id = std::move(id);
    unusable.file = path;
    unusable.summary = "not loaded";
    unusable.formulae = Formulae::none;
    unusable.is_reference = false;
    unusable.exposes = Exposure::verdict;
    unusable.findings.push_back({refused.kind, 0, refused.detail});
    return unusable;
  }
  return kernel;
}

std::vector<Shipped> shipped_plugins() {
  std::vector<Shipped> all;
  for (const Kind& kind : kinds) all.push_back(shipped(kind));
  return all;
}

std::optional<std::string> plugin_path(std::string_view id) {
  if (id.starts_with(by_path)) return std::string(id.substr(by_path.size()));
  for (const Kind& kind : kinds) {
    if (!id.starts_with(kind.prefix)) continue;
    const Shipped known = shipped(kind);
    const std::string_view name = id.substr(kind.prefix.size());
    if (std::find(known.names.begin(), known.names.end(), name) != known.names.end()) {
      return fmt::format("{}/{}.so", *shipped_folder(kind.folder), name);
    }
    for (const Shipped::Absent& absent : known.absent) {
      if (absent.name == name) {
        throw Error(fmt::format("kernel '{}' was not built, for want of the Debian package {}", id, absent.package));
      }
    }
    const std::vector<std::string_view> names(known.names.begin(), known.names.end());
    const std::string_view guess = meant(name, names);
    throw Error(fmt::format("unknown kernel '{}'{} those of {}: {}", id,
                            guess.empty() ? ";" : fmt::format("; did you mean '{}{}'?", kind.prefix, guess),
                            kind.prefix,
                            names.empty() ? "none, this axiscert was built without them"
                                          : fmt::format("{}", fmt::join(most_alike_first(name, names), ", "))));
  }
  return std::nullopt;
}

}  // namespace axiscert::plugin
