#include "kernel/program/code_lines.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <span>

namespace axiscert::plugin {
namespace {

// The line with text(place) for each of its places.
std::string with_places(std::string_view line, const std::function<std::string(std::string_view)>& text) {
  std::string filled;
  while (!line.empty()) {
    const std::size_t open = line.find('{');
    filled += line.substr(0, open);
    if (open == line.npos) break;
    line.remove_prefix(open + 1);
    const std::size_t end = line.find_first_not_of("abcdefghijklmnopqrstuvwxyz");
    if (end == 0 || end == line.npos || line[end] != '}') {
      filled += '{';
      continue;
    }
    filled += text(line.substr(0, end));
    line.remove_prefix(end + 1);
  }
  return filled;
}

}  // namespace

std::vector<std::string> places_of(const PredicateEntry& entry) {
  std::vector<std::string> places;
  for (const PredicateColumn& column : entry.columns) places.emplace_back(column.name);
  for (const ColumnGroup& group : groups_of(entry)) {
    if (group.size > 1) places.emplace_back(group.name);
  }
  return places;
}

std::string unknown_place(std::string_view line, const std::vector<std::string>& known) {
  std::string unknown;
  with_places(line, [&](std::string_view place) {
    if (unknown.empty() && std::find(known.begin(), known.end(), place) == known.end()) unknown = place;
    return std::string();
  });
  return unknown;
}

std::string filled_code(const std::vector<std::string>& lines, const PredicateEntry& entry,
                        const std::vector<std::string>& numbers) {
  const auto text = [&](std::string_view place) {
    for (std::size_t k = 0; k < entry.columns.size(); ++k) {
      if (entry.columns[k].name == place) return numbers[k];
    }
    for (const auto& [name, first, size] : groups_of(entry)) {
      if (name == place) return fmt::format("{}", fmt::join(std::span(numbers).subspan(first, size), ", "));
    }
    return fmt::format("{{{}}}", place);
  };
  std::string code;
  for (const std::string& line : lines) code += with_places(line, text) + "\n";
  return code;
}

}  // namespace axiscert::plugin
