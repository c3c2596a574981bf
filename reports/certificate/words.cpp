// A certificate's report on a terminal: tables of short cells aligned, sentences wrapped below their row.
#include <fmt/format.h>

#include <algorithm>

#include "kernel/base/plain_line.h"
#include "reports/certificate/page.h"

namespace axiscert {
namespace {

constexpr std::size_t columns_of_text = 110, longest_cell = 44;

std::string wrapped(const std::string& sentence, std::size_t indent) {
  std::string text, line;
  const auto end_line = [&] {
    text += std::string(indent, ' ') + line + "\n";
    line.clear();
  };
  std::size_t at = 0;
  const std::string words = printable_line(sentence);
  while (at < words.size()) {
    const std::size_t end = std::min(words.find(' ', at), words.size());
    const std::string_view word = std::string_view(words).substr(at, end - at);
    if (!line.empty() && indent + line.size() + 1 + word.size() > columns_of_text) end_line();
    if (!line.empty()) line += ' ';
    line += word;
    at = end + 1;
  }
  if (!line.empty()) end_line();
  return text;
}

std::string table_words(const InstrumentTable& table) {
  std::string text = table.caption + "\n";
  const auto is_long = [&](std::size_t column) {
    return std::any_of(table.rows.begin(), table.rows.end(),
                       [&](const auto& row) { return row[column].size() > longest_cell; });
  };
  std::vector<bool> long_columns;
  for (std::size_t k = 0; k < table.columns.size(); ++k) long_columns.push_back(is_long(k));
  const auto short_cells = [&](const std::vector<std::string>& row) {
    std::vector<std::string> cells;
    for (std::size_t k = 0; k < row.size(); ++k)
      if (!long_columns[k]) cells.push_back(row[k]);
    return cells;
  };
  if (std::none_of(long_columns.begin(), long_columns.end(), [](bool is) { return is; }))
    return text + aligned_table(table.columns, table.rows);
  // The short cells of all rows are aligned with each other; each row's sentences follow its line.
  std::vector<std::vector<std::string>> rows;
  for (const auto& row : table.rows) rows.push_back(short_cells(row));
  const std::vector<std::string> columns = short_cells(table.columns);
  const std::string aligned = columns.empty() ? "" : aligned_table(columns, rows);
  std::size_t at = columns.empty() ? 0 : aligned.find('\n') + 1;
  if (at != 0) text += aligned.substr(0, at);
  for (const auto& row : table.rows) {
    if (!columns.empty()) {
      const std::size_t end = aligned.find('\n', at) + 1;
      text += aligned.substr(at, end - at);
      at = end;
    }
    for (std::size_t k = 0; k < row.size(); ++k)
      if (long_columns[k]) text += wrapped(row[k], columns.empty() ? 2 : 6);
  }
  return text;
}

}  // namespace

std::string certificate_words(const InstrumentReport& report) {
  std::string text = wrapped(report.title, 0);
  for (const std::string& note : report.notes) text += wrapped(note, 0);
  for (const InstrumentTable& table : report.tables) {
    text += "\n" + table_words(table);
    for (const InstrumentScene& scene : table.scenes)
      text += fmt::format("{}{}", wrapped(scene.sentence, 2), "      " + printable_line(scene.command) + "\n");
  }
  return text;
}

}  // namespace axiscert
