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

// The name of column i under a header; empty beyond the last column.
std::string_view column_name(const CsvHeader& header, std::size_t i) {
  if (header.has_id && i == 0) return "id";
  const auto& columns = header.of.columns().columns;
  const std::size_t k = i - (header.has_id ? 1 : 0);
  return k < columns.size() ? columns[k].name : std::string_view();
}

std::size_t width(const CsvHeader& header) { return header.of.columns().columns.size() + (header.has_id ? 1 : 0); }

// How many cells are what the header says at their place.
std::size_t right_cells(const std::vector<std::string_view>& cells, const CsvHeader& header) {
  std::size_t right = 0;
  for (std::size_t i = 0; i < std::min(cells.size(), width(header)); ++i) right += cells[i] == column_name(header, i);
  return right;
}

std::string columns_text(const TestEntry& entry) {
  std::string text;
  for (const TestColumn& column : entry.columns) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  return text;
}

}  // namespace

std::string csv_columns(KnownTests known) { return columns_text(known.front()->entries.front()); }

std::optional<CsvHeader> csv_header(std::string_view line, const Place& place, KnownTests known) {
  const auto cells = cells_of(line);
  const bool has_id = cells[0] == "id";
  // A header that no entry has is measured by the one that is most like it, and among those by the first.
  std::optional<CsvHeader> header;
  bool begins_like_one = has_id;
  for (const TestDescription* test : known) {
    for (std::size_t e = 0; e < test->entries.size(); ++e) {
      const CsvHeader candidate{has_id, {test, e}};
      const auto& columns = test->entries[e].columns;
      begins_like_one |= std::any_of(columns.begin(), columns.end(),
                                     [&](const TestColumn& column) { return cells[0] == column.name; });
      const std::size_t right = right_cells(cells, candidate);
      if (right == cells.size() && right == width(candidate)) return candidate;
      if (!header || right > right_cells(cells, *header)) header = candidate;
    }
  }
  if (!begins_like_one) return std::nullopt;
  for (std::size_t i = 0; i < std::max(cells.size(), width(*header)); ++i) {
    const std::string_view expected = column_name(*header, i);
    const std::string_view given = i < cells.size() ? cells[i] : std::string_view();
    if (i >= cells.size() || given != expected) {
      place.fail(expected.empty() ? given : expected,
                 fmt::format("column {} of the header is '{}'; the header is [id,]{}", i + 1, shown(given),
                             columns_text(header->of.columns())));
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
  std::vector<NumberText> numbers;
  for (const TestColumn& column : header.of.columns().columns) {
    numbers.push_back({std::string(column.name), "", std::string(cells[first + numbers.size()])});
  }
  std::string id = header.has_id && !cells[0].empty() ? std::string(cells[0]) : place.default_id();
  return stored_query(std::move(id), precision, header.of, numbers, place);
}

}  // namespace axiscert
