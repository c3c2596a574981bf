#include "fuzz/confirm/record.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "exact/trait/oracles.h"
#include "fuzz/queries/address.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/confirm/asymmetry.h"
#include "fuzz/confirm/asymmetry_record.h"
#include "fuzz/confirm/class_record.h"
#include "fuzz/campaign/counts/tally.h"
#include "fuzz/confirm/finding_record.h"
#include "fuzz/confirm/motion_record.h"
#include "fuzz/confirm/plan.h"
#include "fuzz/confirm/witness.h"

namespace axiscert {
namespace {

Json link_counts(const LinkCounts& counts, std::size_t first, std::size_t last) {
  Json json = Json::object();
  for (std::size_t i = first; i <= last; ++i) json[std::string(link_names[i])] = counts[i];
  return json;
}

// The members that axes and comparisons have in common. The error is empty where no sides were measured. What was not
// measured, or not asked for by a tolerance, is null and no count of zero.
void put_signs(Json& json, const SignTally& tally, bool has_tolerance, const std::optional<Decimal6>& max_error) {
  json["false_separation"] = tally.false_separation;
  json["missed_separation"] = tally.missed_separation;
  json["masked"] = tally.masked;
  json["decisive"] = tally.decisive;
  json["tolerance_failures"] = has_tolerance && max_error ? Json(tally.tolerance_failures) : Json(nullptr);
  json["max_error_u"] = json["smallest_passing_tolerance"] = max_error ? decimal_json(*max_error) : Json(nullptr);
  // Flips are relative to the kernel's own exact formulae, so none is a specification fault.
  json["links"] = link_counts(tally.links, index_of(Link::rounding), link_count - 1);
}

Json margins_json(const MarginTally& tally, std::size_t comparison) {
  Json json = {{"right", Json::object()}, {"wrong", Json::object()}};
  for (const auto& [key, count] : tally.counts()) {
    const auto [of, exponent] = key;
    if (of != comparison) continue;
    const std::string name = exponent == tied_margin ? "tie" : std::to_string(exponent);
    if (count.right != 0) json["right"][name] = count.right;
    if (count.wrong != 0) json["wrong"][name] = count.wrong;
  }
  return json;
}

Json comparison_json(const ComparisonTally& tally, bool has_tolerance, bool has_sides, Json margins) {
  Json json = {{"margins", std::move(margins)}};
  put_signs(json, tally, has_tolerance, has_sides ? std::optional(tally.largest_error.best()) : std::nullopt);
  json["ties"] = tally.ties;
  json["range_events"] = has_sides ? Json(tally.range_events) : Json(nullptr);
  json["error_without_scale"] = has_sides ? Json(tally.error_without_scale) : Json(nullptr);
  return json;
}

}  // namespace

Json critical_radius_json(CriticalRadiusTally tally) {
  std::vector<double>& errors = tally.errors_ulps;
  std::sort(errors.begin(), errors.end());
  const auto count_if = [&](const auto& is) {
    return static_cast<std::uint64_t>(std::count_if(errors.begin(), errors.end(), is));
  };
  const Json signed_median = errors.empty() ? Json(nullptr) : Json(errors[(errors.size() - 1) / 2]);
  const std::uint64_t early = count_if([](double error) { return error < 0; });
  // The least float that is not below the distance is up to one ulp above the distance's nearest.
  const std::uint64_t late = count_if([](double error) { return error > 1; });
  for (double& error : errors) error = std::abs(error);
  std::sort(errors.begin(), errors.end());
  const auto at = [&](std::size_t i) { return errors.empty() ? Json(nullptr) : Json(errors[i]); };
  return {{"sampled", errors.size() + tally.unbounded},
          {"median_ulps", at((errors.size() - 1) / 2)},
          {"largest_ulps", at(errors.size() - 1)},
          {"unbounded", tally.unbounded},
          {"unanswered", tally.unanswered},
          {"undecided", tally.undecided},
          {"invalid", tally.invalid},
          {"signed_median_ulps", signed_median},
          {"early", early},
          {"late", late}};
}

namespace {

Json first_by_link_json(const VerdictTally& v) {
  Json json = Json::object();
  for (std::size_t i = 0; i < link_count; ++i) {
    json[std::string(link_names[i])] = v.first_by_link[i] ? Json(*v.first_by_link[i] + 1) : Json(nullptr);
  }
  return json;
}

Json outside_json(const OutsideTally& outside) {
  return {{"trials", outside.trials},
          {"false_separation", outside.false_separation},
          {"false_contact", outside.false_contact},
          {"unanswered", outside.unanswered},
          {"contact", outside.contact},
          {"touching", outside.touching},
          {"deepest", outside.deepest}};
}

Json decades_json(const DecadeCounts& counts) {
  Json json = Json::object();
  for (std::size_t i = 0; i < decade_count; ++i) {
    if (counts[i] != 0) json[decade_name(i)] = counts[i];
  }
  return json;
}

Json depths_json(const DepthTally& depths) {
  return {{"false_separation", decades_json(depths.false_separation)},
          {"false_contact", decades_json(depths.false_contact)}};
}

Json engine_json(const EngineTally& engine) {
  const auto sum = [](const DecadeCounts& counts) {
    return std::accumulate(counts.begin(), counts.end(), std::uint64_t{0});
  };
  return {{"queries", engine.queries},
          {"false_separation", sum(engine.wrong.false_separation)},
          {"false_contact", sum(engine.wrong.false_contact)},
          {"depths", depths_json(engine.wrong)}};
}

Json verdict_json(const VerdictTally& v, const Kernel& kernel) {
  const TestDescription& test = *kernel.test;
  const bool is_limited = kernel.limits.any() || kernel.motion != MotionPolicy{};
  const double separation = v.deepest_false_separation.best(), contact = v.deepest_false_contact.best();
  constexpr std::size_t last = link_count - 1;
  return {{"false_separation", v.false_separation},
          {"false_contact", v.false_contact},
          {"undecided", v.undecided},
          {"undecided_contact", v.undecided_contact},
          {"undecided_touching", v.undecided_touching},
          {"invalid", v.invalid},
          {"unanswered", v.unanswered},
          {"deepest", std::max(separation, contact)},
          {"deepest_false_separation", separation},
          {"deepest_false_contact", contact},
          {"links", link_counts(v.links, 0, last)},
          {"masked_links", link_counts(v.masked_links, 0, last)},
          {"first_by_link", first_by_link_json(v)},
          {"touching_flips", v.touching_flips},
          {"touching_links", link_counts(v.touching_links, 0, last)},
          {"outside_limits", is_limited ? outside_json(v.outside_limits) : Json(nullptr)},
          {"depths", oracles_of(test).has_depth() ? depths_json(v.depths) : Json(nullptr)},
          {"engine_like", capabilities_of(test).has_engine_queries ? engine_json(v.engine) : Json(nullptr)}};
}

Json truth_json(const Tally& tally) {
  return {{"separated", tally.separated},
          {"contact", tally.contact},
          {"touching", tally.touching},
          {"invalid", tally.invalid}};
}

Json family_json(const SeededSource& of, const Kernel& kernel, const Tolerances& tolerances, const Tally& tally,
                 const std::optional<Asymmetry>& asymmetry) {
  const TestDescription& test = *kernel.test;
  const AddressOf address = of.addresses();
  Json json = {{"trials", tally.trials},
               {"base_triangles", of.source.base_triangles(of.precision, tally.trials)},
               {"exact_arithmetic", of.source.exact_arithmetic()},
               {"truth", truth_json(tally)},
               {"verdict", verdict_json(tally.verdict, kernel)},
               {"axes", nullptr},
               {"comparisons", nullptr},
               {"critical_radius", critical_radius_json(tally.critical_radius)}};
  if (asymmetry) {
    json["asymmetry"] = asymmetry_json(*asymmetry, address);
    json["invariance"] = invariance_of(of, *asymmetry);
  }
  if (has_input_classes(kernel)) json["classes"] = classes_json(tally.classes, address);
  if (!test.measures.empty()) json["motion"] = motion_json(tally.motion, kernel);
  Json &axes = json["axes"], &all = json["comparisons"];
  if (kernel.exposes == Exposure::verdict) return json;
  axes = all = Json::object();
  const std::uint64_t promised = tally.trials - tally.invalid - tally.verdict.outside_limits.trials;
  const bool has_sides = kernel.exposes == Exposure::sides && promised > tally.verdict.unanswered;
  for (std::size_t a = 0; a < test.clauses.size(); ++a) {
    bool has_tolerance = false;
    Decimal6 max_error;
    for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
      if (test.comparisons[i].clause != a) continue;
      has_tolerance |= tolerances[i].has_value();
      max_error = std::max(max_error, tally.comparisons[i].largest_error.best());
    }
    Json& axis = axes[std::string(test.clauses[a].name)];
    put_signs(axis, tally.axes[a], has_tolerance, has_sides ? std::optional(max_error) : std::nullopt);
    axis["sole_separator"] = tally.axes[a].sole_separator;
  }
  for (std::size_t i = 0; i < test.comparisons.size(); ++i) {
    all[std::string(test.comparisons[i].name)] =
        comparison_json(tally.comparisons[i], tolerances[i].has_value(), has_sides, margins_json(tally.margins, i));
  }
  return json;
}

// The digests of the files of which somebody else's kernel consists; null for a kernel that comes with axiscert.
Json digest_json(const std::vector<FileInfo>& plugins, const Kernel& kernel) {
  Json digest;
  for (const FileInfo& file : plugins) {
    if (file.kernel == kernel.id && !file.sha256.empty())
      digest.push_back({{"kind", file.kind}, {"sha256", file.sha256}});
  }
  return digest;
}

}  // namespace

Json invariance_of(const SeededSource& of, const Asymmetry& asymmetry) {
  return invariance_json(asymmetry.invariance, *image_group(of.source.name()), of.precision, of.addresses(),
                         [&](const auto& flips) { return absolute_sizes(of, flips); });
}

// Figures that levels do not read, and those that do not add up, are left out.
Json counts_json(const Kernel& kernel, const Tally& tally) {
  Json json = {{"trials", tally.trials},
               {"truth", truth_json(tally)},
               {"verdict", verdict_json(tally.verdict, kernel)},
               {"critical_radius", critical_radius_json(tally.critical_radius)}};
  for (const char* member : {"masked_links", "first_by_link", "depths", "engine_like"}) json["verdict"].erase(member);
  for (const char* member : {"median_ulps", "signed_median_ulps"}) json["critical_radius"].erase(member);
  if (has_input_classes(kernel)) {
    json["classes"] = classes_json(tally.classes, [](std::uint64_t) { return std::string(); });
    for (Json& count : json["classes"]) count.erase("witness");
  }
  if (!kernel.test->measures.empty()) {
    Json& motion = json["motion"] = motion_json(tally.motion, kernel);
    if (!motion["time"].is_null()) {
      for (const char* errors : {"late_errors", "early_errors"}) motion["time"][errors].erase("by_power");
    }
  }
  Json& findings = json["findings"] = Json::object();
  for (std::size_t i = 0; i < finding_kind_count; ++i) {
    if (tally.findings[i].count != 0) findings[std::string(finding_kind_names[i])] = tally.findings[i].count;
  }
  return json;
}

Json decimal_json(Decimal6 decimal) {
  const double value = decimal.value();
  return std::isfinite(value) ? Json(value) : Json(decimal.text());
}

Json exposures_json(const Kernel& kernel) {
  Json names = Json::array();
  for (std::size_t i = 0; i <= index_of(kernel.exposes); ++i) names.push_back(exposure_names[i]);
  return names;
}

Json limits_json(const Limits& limits) {
  if (!limits.any()) return nullptr;
  const auto bound = [](double value) { return value == 0 ? Json(nullptr) : Json(value); };
  return {{"least_coordinate", bound(limits.least_coordinate)},
          {"greatest_coordinate", bound(limits.greatest_coordinate)},
          {"least_area", bound(limits.least_area)},
          {"least_radius", bound(limits.least_radius)},
          {"greatest_radius", bound(limits.greatest_radius)}};
}

Json entry_json(const std::vector<FileInfo>& plugins, const Kernel& kernel, Precision precision) {
  const Json digest = digest_json(plugins, kernel);
  const bool claimed = !kernel.formulae.empty(), has_arithmetic = claimed && kernel.test->claims_arithmetic;
  const bool has_strictness = has_comparisons(kernel) && kernel.test->has_strictness;
  Json entry = {{"id", kernel.id},
                {"name", kernel.declared_name.empty() || digest.is_null() ? Json(nullptr) : Json(kernel.declared_name)},
                {"digest", digest},
                {"precision", name(precision)},
                {"summary", kernel.summary},
                {"formulae", claimed ? Json(kernel.formulae) : Json(nullptr)},
                {"arithmetic", has_arithmetic ? Json(name(kernel.arithmetic)) : Json(nullptr)},
                {"strictness", has_strictness ? Json(name(kernel.strictness)) : Json(nullptr)},
                {"reference", claimed ? Json(kernel.is_reference) : Json(nullptr)},
                {"exposes", exposures_json(kernel)},
                {"touching", name(kernel.touching)},
                {"limits", limits_json(kernel.limits)},
                {"may_decline", kernel.may_decline},
                {"critical_radius", nullptr},
                {"families", Json::object()}};
  if (!kernel.test->measures.empty()) {
    entry["measures"] = given_measures_json(kernel);
    entry["motion"] = policy_json(kernel.motion);
  }
  return entry;
}

Json record_of(const Plan& plan, const CampaignResult& result, const Required& required) {
  const Questions& questions = plan.questions;
  const Answerers& answerers = plan.answerers;
  const Running& running = plan.running;
  const StoredReplies* const replies = answerers.replies.get();
  Json record = {{"schema", record_schema}, {"complete", result.complete}, {"plan", plan_json(plan, result, required)}};
  Json& kernels = record["kernels"] = Json::array();
  WitnessWriter witnesses(replies, running.target);
  Json findings = Json::array();
  for (std::size_t k = 0; k < answerers.kernels.size(); ++k) {
    const Kernel& kernel = *answerers.kernels[k];
    put_loading_findings(findings, kernel);
    for (const Precision precision : questions.precisions) {
      if (!kernel.has(precision)) continue;
      Json entry = entry_json(answerers.plugins, kernel, precision);
      CriticalRadiusTally radii;
      std::vector<TalliedSource> tallied;
      for (std::size_t s = 0; s < questions.sources.size(); ++s) {
        const SeededSource of{*questions.sources[s], questions.seed, precision};
        for (const CellResult& cell : result.cells) {
          if (cell.source != s || cell.precision != precision || cell.tallies[k].trials == 0) continue;
          const Tally& tally = cell.tallies[k];
          // After an interrupted run it is not known which bases have all their images.
          const auto asymmetry =
              result.complete ? asymmetry_of(of, cell.queries, kernel, replies, running) : std::nullopt;
          entry["families"][of.source.name()] = family_json(of, kernel, plan.judging.tolerances, tally, asymmetry);
          radii.merge(tally.critical_radius);
          put_findings(findings, kernel, of, tally);
          witnesses.add(kernel, of, tally, asymmetry);
          tallied.push_back({of, cell.queries, &tally});
        }
      }
      entry["critical_radius"] = critical_radius_json(std::move(radii));
      if (has_input_classes(kernel)) entry["nearest"] = nearest_json(nearest_kernel(kernel, tallied, running.target));
      kernels.push_back(std::move(entry));
    }
  }
  record["findings"] = std::move(findings);
  record["witnesses"] = std::move(witnesses).take();
  return record;
}

}  // namespace axiscert
