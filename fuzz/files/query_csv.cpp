// CSV: cells between commas, white space around them ignored, no quoting.
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

std::vector<std::string_view> csv_cells(std::string_view line) {
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

std::string columns_text(const PredicateEntry& entry) {
  std::string text;
  for (const PredicateColumn& column : entry.columns) text += fmt::format("{}{}", text.empty() ? "" : ",", column.name);
  return text;
}

// Text without the quotes and case in which a header may differ.
std::string comparable_cell(std::string_view cell) {
  std::string text;
  for (const char c : cell) {
    if (c != '"' && c != '\'') text += c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  }
  return text;
}

// The character that separates the cells of a line: the most frequent of those that other programs write.
char separator_of(std::string_view line) {
  char most = ',';
  for (const char c : {';', '\t', ' '}) {
    const auto count = [&](char each) { return std::count(line.begin(), line.end(), each); };
    if (count(c) > count(most)) most = c;
  }
  return most;
}

// A separator as messages say it.
std::string in_words(char separator) {
  return separator == '\t' ? "tabs" : separator == ' ' ? "spaces" : fmt::format("'{}'", separator);
}

bool begins_like_a_number(std::string_view cell) {
  return !cell.empty() && std::string_view("+-.0123456789").find(cell.front()) != std::string_view::npos;
}

// Fails where a first line that is not a header is CSV all the same: in words that say what to change.
void refuse_other_csv(std::string_view line, const Place& place, KnownPredicates known) {
  const std::string_view text = trimmed(line);
  if (text.empty() || text.front() == '{' || text.front() == '[') return;
  const char separator = separator_of(text);
  const auto cells = static_cast<std::size_t>(std::count(text.begin(), text.end(), separator)) + 1;
  if (cells < (separator == ' ' ? 4u : 2u)) return;
  const std::string header = fmt::format("the header is [id,]{}", csv_columns(known));
  const auto refuse = [&](const std::string& what) { place.fail("", fmt::format("{}; {}", what, header)); };
  if (separator != ',') {
    refuse(fmt::format("CSV whose cells are separated by {}, not by ','", in_words(separator)));
  }
  const auto given = csv_cells(text);
  if (begins_like_a_number(given.front())) refuse("CSV without a header: its first line has numbers");
  if (text.find('"') != text.npos) refuse("CSV whose header is quoted; write its names without quotes");
  if (comparable_cell(given.front()) == csv_columns(known).substr(0, comparable_cell(given.front()).size())) {
    refuse(
        fmt::format("column 1 of the header of CSV is '{}'; names of columns are in lower case", shown(given.front())));
  }
  refuse(fmt::format("CSV with another header, '{}'", shown(text)));
}

}  // namespace

std::string csv_columns(KnownPredicates known) { return columns_text(predicate_named("", known).entries.front()); }

std::optional<CsvHeader> csv_header(std::string_view line, const Place& place, KnownPredicates known) {
  const auto cells = csv_cells(line);
  const bool has_id = cells[0] == "id";
  // A header that no entry has is measured by the one that is most like it, and among those by the first.
  std::optional<CsvHeader> header;
  bool begins_like_one = has_id;
  for (const Predicate* predicate : known) {
    for (std::size_t e = 0; e < predicate->entries.size(); ++e) {
      const CsvHeader candidate{has_id, {predicate, e}};
      const auto& columns = predicate->entries[e].columns;
      begins_like_one |= std::any_of(columns.begin(), columns.end(),
                                     [&](const PredicateColumn& column) { return cells[0] == column.name; });
      const std::size_t right = right_cells(cells, candidate);
      if (right == cells.size() && right == width(candidate)) return candidate;
      if (!header || right > right_cells(cells, *header)) header = candidate;
    }
  }
  const std::string_view first = trimmed(line);
  const bool has_cells = cells.size() > 1 || separator_of(first) == ',';
  if (!begins_like_one || !has_cells) {
    refuse_other_csv(line, place, known);
    return std::nullopt;
  }
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
  const auto cells = csv_cells(line);
  if (cells.size() != width(header)) {
    place.fail(
        cells.size() < width(header) ? column_name(header, cells.size()) : "",
        fmt::format("{} cell{} under a header of {}{}", cells.size(), cells.size() == 1 ? "" : "s", width(header),
                    separator_of(line) == ','
                        ? ""
                        : fmt::format("; cells are separated by ',', not by {}", in_words(separator_of(line)))));
  }
  const std::size_t first = header.has_id ? 1 : 0;
  if (header.has_id && cells[0].find('"') != std::string_view::npos) {
    place.fail("id", fmt::format("{} is quoted; write the cell without quotes or commas", shown(cells[0])));
  }
  std::vector<NumberText> numbers;
  for (const PredicateColumn& column : header.of.columns().columns) {
    numbers.push_back({std::string(column.name), "", std::string(cells[first + numbers.size()])});
  }
  std::string id = header.has_id && !cells[0].empty() ? std::string(cells[0]) : place.default_id();
  return stored_query(id, precision, header.of, numbers, place);
}

}  // namespace axiscert
