#include "fuzz/confirm/plan.h"

#include "fuzz/campaign/parts/stretch.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The statement that no kernel was run, and the claim made for the program.
Json replies_json(const Answerers& answerers) {
  const auto given = [](const std::string& id) { return id.empty() ? Json(nullptr) : Json(id); };
  Json json = {{"conforms_to", given(answerers.claim.conforms_to)},
               {"formulae", given(answerers.claim.formulae)},
               {"touching", name(answerers.kernels.front()->touching)},
               {"may_decline", answerers.kernels.front()->may_decline}};
  if (answerers.replies->measure_count() != 0) json["measures"] = answerers.replies->measure_count();
  return json;
}

// One level as text, as records of one level have it.
Json require_json(const std::vector<std::string>& levels) {
  if (levels.empty()) return nullptr;
  return levels.size() == 1 ? Json(levels.front()) : Json(levels);
}

}  // namespace

Json plan_json(const Plan& plan, const CampaignResult& result, const Required& required) {
  const Questions& questions = plan.questions;
  const Answerers& answerers = plan.answerers;
  Json json = {{"axiscert", axiscert_version}, {"test", questions.test().id}, {"seed", questions.seed}};
  for (const char* list : {"kernels", "precisions", "families"}) json[list] = Json::array();
  for (const char* map : {"generators", "trials"}) json[map] = Json::object();
  json["files"] = Json::array();
  for (const Kernel* kernel : answerers.kernels) json["kernels"].push_back(kernel->id);
  for (const Precision p : questions.precisions) json["precisions"].push_back(name(p));
  for (const SourcePtr& source : questions.sources) {
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
  for (const FileInfo& file : answerers.plugins) {
    json["files"].push_back({{"name", file.name},
                             {"kind", file.kind},
                             {"sha256", file.sha256.empty() ? Json(nullptr) : Json(file.sha256)}});
  }
  Json units = Json::object();
  for (std::size_t s = 0; s < questions.sources.size(); ++s) {
    for (const CellResult& cell : result.cells) {
      if (cell.source != s) continue;
      const std::string family = questions.sources[s]->name(), precision(name(cell.precision));
      json["trials"][family][precision] = cell.queries;
      units[family][precision] = cell.units_done;
    }
  }
  json["tolerance"] = plan.judging.tolerance_texts;
  json["require"] = require_json(required.levels);
  if (!required.allow_unchecked.empty()) json["allow_unchecked"] = required.allow_unchecked;
  json["margin_queries"] = margin_queries;
  // Without a time limit the trials determine the units; an interrupted run did only some of them.
  if (answerers.replies) json["replies"] = replies_json(answerers);
  json["units_done"] = questions.seconds || !result.complete ? units : Json(nullptr);
  return json;
}

Json plan_json(const Plan& plan, const Required& required) {
  return plan_json(plan, planned(plan.questions), required);
}

}  // namespace axiscert
