#include "examples/character/sweeps/table.h"

#include <fmt/format.h>

#include "reports/wording/aligned_table.h"

namespace axiscert::character {
namespace {

using Row = std::vector<std::string>;

std::string text(std::uint64_t n) { return fmt::format("{}", n); }

}  // namespace

std::string sweeps_table(std::span<const TravelledSweep> travelled, const JourneyOptions& options) {
  const bool walks = options.errand == Errand::walk;
  std::vector<Row> motions, answers, entered, rates;
  for (const TravelledSweep& t : travelled) {
    const SweepCounts& c = t.counts;
    Row row{t.sweeper, text(c.motions), text(c.stopped), text(c.triangles), text(c.contacts)};
    if (walks) {
      for (const std::uint64_t n : {t.turns, t.set_down, t.left}) row.push_back(text(n));
    }
    motions.push_back(row);
    const auto time = [&](std::uint64_t n) { return t.gives_times ? text(n) : std::string("-"); };
    answers.push_back({t.sweeper, text(c.missed), text(c.phantom), time(c.late), time(c.without_time)});
    entered.push_back({t.sweeper, text(c.entered), text(c.sunk), text(c.through),
                       c.deepest.is_zero() ? "-" : fmt::format("{:.2e}", c.deepest.value())});
    const auto rate = [&](std::uint64_t n) {
      return fmt::format("{:.2f}", 1000.0 * static_cast<double>(n) / static_cast<double>(options.steps));
    };
    rates.push_back({t.sweeper, rate(c.missed), rate(c.phantom), t.gives_times ? rate(c.late) : "-", rate(c.entered),
                     rate(c.sunk), rate(c.through)});
  }
  Row columns{"sphere moved by", "motions", "stopped", "triangles", "contacts"};
  if (walks) columns.insert(columns.end(), {"turned", "set down", "left"});
  return aligned_table(columns, motions) + "\n" +
         aligned_table({"answers of", "missed", "phantom", "late", "no time"}, answers) + "\n" +
         aligned_table({"motions by", "entered", "sunk", "through", "deepest"}, entered) + "\n" +
         aligned_table({"per 1000 steps", "missed", "phantom", "late", "entered", "sunk", "through"}, rates);
}

}  // namespace axiscert::character
