// An instrument's tables for the terminal.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/instrument/instrument.h"

namespace axiscert {

std::string instrument_text(const InstrumentReport& report) {
  std::string text = report.title + "\n\n";
  for (const InstrumentTable& table : report.tables) {
    text += fmt::format("{}\n{}\n", table.caption, aligned_table(table.columns, table.rows));
  }
  return text + fmt::format("{}\n", fmt::join(report.notes, "\n"));
}

}  // namespace axiscert
