#include "fuzz/text/length_unit.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

namespace axiscert {
namespace {

constexpr LengthUnit all_units[] = {{"m", 1},     {"cm", 1e-2},   {"mm", 1e-3},  {"um", 1e-6},
                                    {"km", 1000}, {"in", 0.0254}, {"ft", 0.3048}};

}  // namespace

const LengthUnit* find_length_unit(std::string_view name) {
  const auto* const found = std::ranges::find(all_units, name, &LengthUnit::name);
  return found == std::end(all_units) ? nullptr : found;
}

std::vector<std::string_view> length_unit_names() {
  std::vector<std::string_view> names;
  for (const LengthUnit& unit : all_units) names.push_back(unit.name);
  return names;
}

std::string metric_text(double metres) {
  if (metres == 0) return "0 m";
  constexpr std::string_view metric[] = {"km", "m", "cm", "mm", "um"};
  const double size = std::fabs(metres);
  if (size < 1e-9 || size >= 1e6) return fmt::format("{:.3g} m", metres);
  const auto* const fits = std::ranges::find_if(
      metric, [&](std::string_view name) { return size >= find_length_unit(name)->metres * 0.9995; });
  const std::string_view name = fits == std::end(metric) ? "um" : *fits;
  return fmt::format("{:.3g} {}", metres / find_length_unit(name)->metres, name);
}

std::string length_text(double length, const LengthUnit* unit) {
  if (unit == nullptr) return fmt::format("{:.3g} units", length);
  const bool is_metric = unit->name != "in" && unit->name != "ft";
  return is_metric ? metric_text(length * unit->metres) : fmt::format("{:.3g} {}", length, unit->name);
}

std::optional<double> length_in_metres(std::string_view text) {
  double number = 0;
  const char* const end = text.data() + text.size();
  auto [stop, problem] = std::from_chars(text.data(), end, number);
  while (stop != end && *stop == ' ') ++stop;
  const LengthUnit* const unit = find_length_unit({stop, static_cast<std::size_t>(end - stop)});
  if (problem != std::errc() || unit == nullptr || !(number > 0) || !std::isfinite(number)) return std::nullopt;
  return number * unit->metres;
}

}  // namespace axiscert
