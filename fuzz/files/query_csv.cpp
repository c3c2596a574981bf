// CSV: plain cells between commas, white space around them ignored, no quoting.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "fuzz/text/number_text.h"
#include "fuzz/files/query_line.h"

namespace axiscert {
namespace {

std::string_view trimmed(std::string_view cell) {
  const std::size_t first = cell.find_first_not_of(" \t");
  if (first == cell.npos) return {};
  return cell.substr(first, cell.find_last_not_of(" \t") - first + 1);
}

std::vector<std::string_view> cells_of(std::string_view line) {
  std::vector<std::string_view> cells;
  for (;;) {
    const std::size_t end = line.find(',');
    cells.push_back(trimmed(line.substr(0, end)));
    if (end == line.npos) return cells;
    line.remove_prefix(end + 1);
  }
}

// The name of column i; empty beyond the last column.
std::string_view column_name(const CsvHeader& header, std::size_t i) {
  if (header.has_id && i == 0) return "id";
  const std::size_t k = i - (header.has_id ? 1 : 0);
  return k < coordinate_count ? std::string_view(coordinate_names[k]) : std::string_view();
}

std::size_t width(const CsvHeader& header) { return coordinate_count + (header.has_id ? 1 : 0); }

}  // namespace

std::optional<CsvHeader> csv_header(std::string_view line, const Place& place) {
  const auto cells = cells_of(line);
  const bool begins_like_one = std::any_of(coordinate_names.begin(), coordinate_names.end(),
                                           [&](std::string_view name) { return cells[0] == name; });
  const CsvHeader header{cells[0] == "id"};
  if (!header.has_id && !begins_like_one) return std::nullopt;
  for (std::size_t i = 0; i < std::max(cells.size(), width(header)); ++i) {
    const std::string_view expected = column_name(header, i);
    const std::string_view given = i < cells.size() ? cells[i] : std::string_view();
    if (i >= cells.size() || given != expected) {
      place.fail(
          expected.empty() ? given : expected,
          fmt::format("column {} of the header is '{}'; the header is [id,]{}", i + 1, shown(given), csv_columns));
    }
  }
  return header;
}

StoredQuery query_of_csv(std::string_view line, const CsvHeader& header, Precision precision, const Place& place) {
  const auto cells = cells_of(line);
  if (cells.size() != width(header)) {
    place.fail(cells.size() < width(header) ? column_name(header, cells.size()) : "",
               fmt::format("{} cells under a header of {}", cells.size(), width(header)));
  }
  const std::size_t first = header.has_id ? 1 : 0;
  if (header.has_id && cells[0].find('"') != std::string_view::npos) {
    place.fail("id", fmt::format("{} is quoted; write the cell without quotes or commas", shown(cells[0])));
  }
  std::array<NumberText, coordinate_count> numbers;
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    numbers[k] = {coordinate_names[k], "", std::string(cells[first + k])};
  }
  std::string id = header.has_id && !cells[0].empty() ? std::string(cells[0]) : place.default_id();
  return stored_query(std::move(id), precision, numbers, place);
}

}  // namespace axiscert
