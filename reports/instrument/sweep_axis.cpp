#include "reports/instrument/sweep_axis.h"

#include <fmt/format.h>

#include <algorithm>

namespace axiscert {

std::optional<SignedNumber> swept_value(const Source& source) {
  const SweepPoint* point = swept_point(source);
  return point != nullptr ? std::optional(SignedNumber{point->value}) : std::nullopt;
}

std::optional<SweepData> sweep_of(const std::vector<SourcePtr>& sources) {
  std::optional<SweepData> sweep;
  for (const SourcePtr& source : sources) {
    const SweepPoint* point = swept_point(*source);
    if (point == nullptr) continue;
    if (!sweep) sweep = {point->parameter, {}};
    if (std::ranges::find(sweep->values, point->value, &SignedNumber::value) == sweep->values.end())
      sweep->values.push_back({point->value});
  }
  return sweep;
}

std::vector<std::string> ids_of(const std::vector<const Kernel*>& kernels) {
  std::vector<std::string> ids;
  for (const Kernel* kernel : kernels) ids.push_back(kernel->id);
  return ids;
}

std::optional<InstrumentPlot> sweep_plot(
    const std::vector<SourcePtr>& sources, std::string caption, std::string y_label,
    const std::vector<std::string>& lines,
    const std::function<std::optional<SweepY>(std::size_t line, std::size_t source)>& y, InstrumentPlot::Kind kind) {
  const auto sweep = sweep_of(sources);
  if (!sweep) return std::nullopt;
  std::vector<std::string> bases;
  for (const SourcePtr& source : sources) {
    if (std::ranges::find(bases, unswept(*source).name()) == bases.end()) bases.push_back(unswept(*source).name());
  }
  InstrumentPlot plot{
      std::move(caption), std::string(name(sweep->parameter)), std::move(y_label), kind, true, true, {}};
  for (const std::string& base : bases) {
    for (std::size_t line = 0; line < lines.size(); ++line) {
      InstrumentSeries series{bases.size() == 1 ? lines[line] : fmt::format("{}, {}", lines[line], base), {}, {}};
      std::vector<std::pair<double, SweepY>> found;
      for (std::size_t s = 0; s < sources.size(); ++s) {
        const auto value = swept_value(*sources[s]);
        if (!value || value->value <= 0 || unswept(*sources[s]).name() != base) continue;
        const std::optional<SweepY> at = y(line, s);
        if (at && at->y > 0) found.emplace_back(value->value, *at);
      }
      std::ranges::sort(found, {}, [](const auto& point) { return point.first; });
      for (const auto& [x, at] : found) {
        series.points.emplace_back(x, at.y);
        if (at.interval) series.intervals.push_back(*at.interval);
      }
      plot.series.push_back(std::move(series));
    }
  }
  return plot;
}

}  // namespace axiscert
