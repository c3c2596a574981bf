// An instrument's tables for the terminal, and the code of their scenes.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "reports/instrument/instrument.h"

namespace axiscert {
namespace {

std::string scene_text(const InstrumentScene& scene) {
  std::string text = fmt::format("{}: {}{}\n", scene.title, scene.sentence,
                                 scene.needs.empty() ? "" : fmt::format(" With {}:", scene.needs));
  for (std::size_t begin = 0; begin < scene.code.size();) {
    const std::size_t end = scene.code.find('\n', begin);
    text += fmt::format("    {}\n", std::string_view(scene.code).substr(begin, end - begin));
    begin = end == scene.code.npos ? end : end + 1;
  }
  return text + "\n";
}

}  // namespace

std::string instrument_text(const InstrumentReport& report) {
  std::string text = report.title + "\n\n";
  for (const InstrumentTable& table : report.tables) {
    text += fmt::format("{}\n{}\n", table.caption, aligned_table(table.columns, table.rows));
  }
  for (const InstrumentTable& table : report.tables) {
    for (const InstrumentScene& scene : table.scenes) {
      if (!scene.code.empty()) text += scene_text(scene);
    }
  }
  return text + fmt::format("{}\n", fmt::join(report.notes, "\n"));
}

}  // namespace axiscert
