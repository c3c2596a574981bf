#include "reports/wording/aligned_table.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiscert {
namespace {

std::string printable(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = '?';
  }
  return text;
}

}  // namespace

bool is_number(const std::string& cell) {
  return cell.find_first_of("0123456789") <= 1 && cell.find_first_not_of("0123456789.,+-e") == cell.npos;
}

std::string aligned_table(const std::vector<std::string>& columns, const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths;
  for (const std::string& column : columns) widths.push_back(column.size());
  for (const auto& row : rows) {
    for (std::size_t i = 0; i < row.size(); ++i) widths[i] = std::max(widths[i], row[i].size());
  }
  std::string text;
  const auto add = [&](const std::vector<std::string>& cells, bool is_head) {
    std::string line;
    for (std::size_t i = 0; i < cells.size(); ++i) {
      const bool right = is_head ? !rows.empty() && is_number(rows.front()[i]) : is_number(cells[i]);
      line += right ? fmt::format("  {:>{}}", printable(cells[i]), widths[i])
                    : fmt::format("  {:<{}}", printable(cells[i]), widths[i]);
    }
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  };
  add(columns, true);
  for (const auto& row : rows) add(row, false);
  return text;
}

}  // namespace axiscert
