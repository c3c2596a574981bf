// An instrument's tables for the terminal.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/instrument/instrument.h"

namespace axiscert {
namespace {

std::string table_text(const InstrumentTable& table) {
  std::vector<std::size_t> widths;
  for (const std::string& column : table.columns) widths.push_back(column.size());
  for (const auto& row : table.rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text = fmt::format("{}\n", table.caption);
  const auto add = [&](const std::vector<std::string>& cells) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      line += is_number(cells[i]) ? fmt::format("  {:>{}}", cells[i], widths[i])
                                  : fmt::format("  {:<{}}", cells[i], widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add(table.columns);
  for (const auto& row : table.rows) add(row);
  return text;
}

}  // namespace

bool is_number(const std::string& cell) {
  return cell.find_first_of("0123456789") <= 1 && cell.find_first_not_of("0123456789.,+-e") == cell.npos;
}

std::string instrument_text(const InstrumentReport& report) {
  std::string text = report.title + "\n\n";
  for (const InstrumentTable& table : report.tables) text += table_text(table) + "\n";
  return text + fmt::format("{}\n", fmt::join(report.notes, "\n"));
}

}  // namespace axiscert
