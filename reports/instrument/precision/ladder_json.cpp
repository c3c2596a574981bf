#include <cmath>

#include "fuzz/sphere_triangle/formulae/ladder_steps.h"
#include "reports/instrument/data.h"
#include "reports/instrument/precision/ladder_report.h"

namespace axiscert {
namespace {

// As in a record: the text of the number where binary64 cannot hold it.
Json number(Decimal6 decimal) {
  const double value = decimal.value();
  return std::isfinite(value) ? Json(value) : Json(decimal.text());
}
Json number(std::optional<double> value) {
  if (!value) return nullptr;
  return std::isfinite(*value) ? Json(*value) : Json("beyond binary64");
}
Json number(const std::optional<ExponentWindow>& window) {
  return window ? Json{window->low, window->high} : Json(nullptr);
}

Json accuracy_json(const ComparisonAccuracy& accuracy, bool has_sides) {
  Json json = {{"false_separation", accuracy.false_separation},
               {"missed_separation", accuracy.missed_separation},
               {"by_range", accuracy.by_range}};
  if (!has_sides) return json;
  json["median_u"] = number(accuracy.errors.quantile(50));
  json["p99_u"] = number(accuracy.errors.quantile(99));
  json["worst_u"] = accuracy.errors.count() == 0 ? Json(nullptr) : number(accuracy.errors.worst());
  json["errors"] = accuracy.errors.count();
  json["range_events"] = accuracy.range_events;
  json["error_without_scale"] = accuracy.without_scale;
  return json;
}

Json critical_radius_json(const KernelAccuracy& accuracy) {
  const auto& ascending = accuracy.radius_errors_ulps;
  const auto at = [&](std::size_t i) { return ascending.empty() ? Json(nullptr) : Json(ascending[i]); };
  return {{"sampled", ascending.size() + accuracy.radius_unbounded},
          {"median_ulps", at((ascending.size() - 1) / 2)},
          {"largest_ulps", at(ascending.size() - 1)},
          {"unbounded", accuracy.radius_unbounded}};
}

Json kernel_json(const KernelAccuracy& accuracy, bool has_sides) {
  Json json = {{"queries", accuracy.queries},
               {"verdict",
                {{"false_separation", accuracy.false_separation},
                 {"false_contact", accuracy.false_contact},
                 {"touching_flips", accuracy.touching_flips},
                 {"flips_per_million", accuracy.flips_per_million()}}},
               {"critical_radius", critical_radius_json(accuracy)}};
  for (std::size_t i = 0; i < axis_count; ++i) {
    json["axes"][std::string(axis_names[i])] = accuracy_json(accuracy.of(axis_comparisons[i]), has_sides);
  }
  for (std::size_t i = 0; i < axis_kind_count; ++i) {
    const ComparisonBits which = comparisons_of_kind(static_cast<AxisKind>(i));
    Json& kind = json["kinds"][std::string(axis_kind_names[i])] = accuracy_json(accuracy.of(which), has_sides);
    const auto radius = static_cast<ComparisonBits>(which & ~side_comparisons);
    const auto side = static_cast<ComparisonBits>(which & side_comparisons);
    kind["radius"] = accuracy_json(accuracy.of(radius), has_sides);
    if (side != 0) kind["side"] = accuracy_json(accuracy.of(side), has_sides);
  }
  for (std::size_t i = 0; i < comparison_count; ++i) {
    json["comparisons"][std::string(comparisons[i].name)] = accuracy_json(accuracy.comparisons[i], has_sides);
  }
  return json;
}

Json entry_json(const LadderPlan& plan, const LadderEntry& entry) {
  const bool has_sides = entry.kernel->exposes == Exposure::sides;
  Json json = {{"id", entry.kernel->id}, {"summary", entry.kernel->summary}, {"shows_sides", has_sides}};
  json.update(kernel_json(entry.all, has_sides));
  for (std::size_t i = 0; i < axis_count; ++i) {
    json["axes"][std::string(axis_names[i])]["window"] = number(entry.windows[i]);
  }
  for (std::size_t i = 0; i < axis_kind_count; ++i) {
    json["kinds"][std::string(axis_kind_names[i])]["window"] =
        number(common_window(entry.windows, axes_of_kind(static_cast<AxisKind>(i))));
  }
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    json["families"][plan.sources[s]->name()] = kernel_json(entry.by_source[s], has_sides);
  }
  return json;
}

Json speed_json(const std::vector<LadderEntry>& entries) {
  Json json = {{"unit", "ns a query, median"},
               {"queries", speed_queries},
               {"repetitions", speed_repetitions},
               {"kernels", Json::object()},
               {"front", Json::array()}};
  for (const LadderEntry& entry : entries) {
    Json& kernel = json["kernels"][entry.kernel->id] = {{"scalar", entry.speed->scalar_ns},
                                                        {"scalar_least", entry.speed->least_scalar_ns}};
    if (entry.speed->best_target) kernel[entry.speed->best_target->first] = entry.speed->best_target->second;
  }
  for (const std::size_t i : accuracy_speed_front(entries)) json["front"].push_back(entries[i].kernel->id);
  return json;
}

Json steps_json(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps) {
  Json all = Json::array();
  for (const LadderStep& step : steps) {
    all.push_back({{"from", entries[step.from].kernel->id}, {"to", entries[step.to].kernel->id}});
  }
  return all;
}

Json costliest_json(const std::vector<LadderEntry>& entries, const std::vector<LadderStep>& steps) {
  Json json = Json::object();
  const auto step = [&](std::optional<std::size_t> i) { return i ? Json(entries[steps[*i].to].kernel->id) : Json(); };
  for (std::size_t i = 0; i < axis_kind_count; ++i) {
    const CostliestSteps costliest = costliest_steps(entries, steps, static_cast<AxisKind>(i));
    json[std::string(axis_kind_names[i])] = {{"sign_errors", step(costliest.sign_errors)},
                                             {"rounding_sign_errors", step(costliest.rounding_sign_errors)},
                                             {"worst_error", step(costliest.worst_error)},
                                             {"range", step(costliest.range)}};
  }
  return json;
}

}  // namespace

Json ladder_json(const LadderPlan& plan, const std::vector<LadderEntry>& entries, const std::string& command) {
  const ExponentWindow scanned = scanned_exponents(plan.precision);
  const std::vector<LadderStep> steps = ladder_steps(entries);
  Json json = {{"command", command},
               {"precision", name(plan.precision)},
               {"seed", plan.seed},
               {"trials", plan.trials},
               {"families", Json::array()},
               {"scanned_exponents", {scanned.low, scanned.high}},
               {"kernels", Json::array()},
               {"steps", steps_json(entries, steps)},
               {"costliest_steps", costliest_json(entries, steps)}};
  for (const SourcePtr& source : plan.sources) json["families"].push_back(source->name());
  for (const LadderEntry& entry : entries) json["kernels"].push_back(entry_json(plan, entry));
  if (plan.speed) json["speed"] = speed_json(entries);
  return headed("axiscert-ladder/1", json);
}

}  // namespace axiscert
