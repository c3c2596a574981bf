#include "fuzz/confirm/plan.h"

#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The statement that no kernel was run, and the claim made for the program.
Json replies_json(const Plan& plan) {
  const auto given = [](const std::string& id) { return id.empty() ? Json(nullptr) : Json(id); };
  Json json = {{"conforms_to", given(plan.claim.conforms_to)},
               {"formulae", given(plan.claim.formulae)},
               {"touching", name(plan.kernels.front()->touching)},
               {"may_decline", plan.kernels.front()->may_decline}};
  if (plan.replies->measure_count() != 0) json["measures"] = plan.replies->measure_count();
  return json;
}

// One level as text, as records of one level have it.
Json require_json(const std::vector<std::string>& levels) {
  if (levels.empty()) return nullptr;
  return levels.size() == 1 ? Json(levels.front()) : Json(levels);
}

}  // namespace

Json plan_json(const Plan& plan, const CampaignResult& result, const Required& required) {
  Json json = {{"axiscert", axiscert_version}, {"test", plan.test().id}, {"seed", plan.seed}};
  for (const char* list : {"kernels", "precisions", "families"}) json[list] = Json::array();
  for (const char* map : {"generators", "trials"}) json[map] = Json::object();
  json["files"] = Json::array();
  for (const Kernel* kernel : plan.kernels) json["kernels"].push_back(kernel->id);
  for (const Precision p : plan.precisions) json["precisions"].push_back(name(p));
  for (const SourcePtr& source : plan.sources) {
    json["families"].push_back(source->name());
    json["generators"][source->name()] = {{"version", source->version()},
                                          {"exact_arithmetic", source->exact_arithmetic()},
                                          {"purpose", source->purpose()}};
    if (const auto file = source->file()) {
      Json& entry =
          json["files"].emplace_back(Json{{"name", file->name}, {"kind", file->kind}, {"sha256", file->sha256}});
      if (file->kind == "queries") entry["queries"] = file->queries;
      else {
        entry["triangles"] = file->triangles;
        entry["degenerate_triangles"] = file->degenerate_triangles;
        entry["skipped_primitives"] = file->skipped_primitives;
      }
    }
  }
  for (const FileInfo& file : plan.plugins) {
    json["files"].push_back({{"name", file.name},
                             {"kind", file.kind},
                             {"sha256", file.sha256.empty() ? Json(nullptr) : Json(file.sha256)}});
  }
  Json units = Json::object();
  for (std::size_t s = 0; s < plan.sources.size(); ++s) {
    for (const CellResult& cell : result.cells) {
      if (cell.source != s) continue;
      const std::string family = plan.sources[s]->name(), precision(name(cell.precision));
      json["trials"][family][precision] = cell.queries;
      units[family][precision] = cell.units_done;
    }
  }
  json["tolerance"] = plan.tolerance_texts;
  json["require"] = require_json(required.levels);
  if (!required.allow_unchecked.empty()) json["allow_unchecked"] = required.allow_unchecked;
  json["margin_queries"] = margin_queries;
  // Without a time limit the trials determine the units; an interrupted run did only some of them.
  if (plan.replies) json["replies"] = replies_json(plan);
  json["units_done"] = plan.seconds || !result.complete ? units : Json(nullptr);
  return json;
}

}  // namespace axiscert
