#include "cli/options/source_place.h"

#include <fmt/format.h>

#include <charconv>
#include <filesystem>
#include <optional>

#include "kernel/base/error.h"
#include "kernel/base/utf8.h"

namespace axiscert {
namespace {

namespace fs = std::filesystem;

// "FILE:LINE"; nothing where the text is not of that form.
std::optional<SourcePlace> place_of(const std::string& text) {
  const std::size_t colon = text.rfind(':');
  if (colon == text.npos || colon == 0 || !is_utf8(text)) return std::nullopt;
  std::uint32_t line = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, problem] = std::from_chars(text.data() + colon + 1, end, line);
  if (problem != std::errc() || stop != end || line == 0) return std::nullopt;
  fs::path file = fs::path(text.substr(0, colon)).lexically_normal();
  std::error_code none;
  if (const fs::path inside = file.lexically_relative(fs::current_path(none));
      file.is_absolute() && !inside.empty() && *inside.begin() != "..")
    file = inside;
  return SourcePlace{file.string(), line};
}

}  // namespace

SourcePlaces source_places(const std::vector<const Kernel*>& kernels, const std::vector<std::string>& given) {
  SourcePlaces places;
  for (const Kernel* kernel : kernels) {
    if (const auto own = place_of(kernel->source)) places.put(kernel->id) = *own;
  }
  for (const std::string& value : given) {
    std::vector<std::string> about;  // the kernels that the value names, or all of them
    std::string where = value;
    for (const Kernel* kernel : kernels) {
      if (value.starts_with(kernel->id + "=")) {
        about = {kernel->id};
        where = value.substr(kernel->id.size() + 1);
        break;
      }
      about.push_back(kernel->id);
    }
    const auto place = place_of(where);
    if (!place) {
      throw Error(fmt::format(
          "--source {}: give FILE:LINE, as in src/my_kernel.c:12, or KERNEL=FILE:LINE for one kernel", as_utf8(value)));
    }
    if (!fs::is_regular_file(where.substr(0, where.rfind(':')))) {
      throw Error(
          fmt::format("--source {}: there is no file {}; give a path from the folder in which axiscert runs, or "
                      "KERNEL=FILE:LINE with a kernel of this run",
                      value, where.substr(0, where.rfind(':'))));
    }
    for (const std::string& id : about) places.put(id) = *place;
  }
  return places;
}

}  // namespace axiscert
