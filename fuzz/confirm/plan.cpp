#include "fuzz/confirm/plan.h"

#include "fuzz/campaign/parts/stretch.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

// The statement that no kernel was run, and the claim made for the program.
RepliesRecord replies_record(const Answerers& answerers) {
  const auto given = [](const std::string& id) { return id.empty() ? std::nullopt : std::optional(id); };
  RepliesRecord record{given(answerers.claim.conforms_to), given(answerers.claim.formulae),
                       answerers.kernels.front()->touching, answerers.kernels.front()->may_decline, std::nullopt};
  if (answerers.replies->measure_count() != 0) record.measures = answerers.replies->measure_count();
  return record;
}

FileRecord file_record(const FileInfo& file) {
  FileRecord record{file.name, file.kind, std::nullopt, {}, {}, {}, {}};
  if (!file.sha256.empty()) record.sha256 = Sha256(file.sha256);
  if (file.kind == "queries") record.queries = file.queries;
  if (file.kind == "mesh") {
    record.triangles = file.triangles;
    record.degenerate_triangles = file.degenerate_triangles;
    record.skipped_primitives = file.skipped_primitives;
  }
  return record;
}

}  // namespace

PlanRecord plan_record(const Plan& plan, const CampaignResult& result, const RunRequirements& required) {
  const Questions& questions = plan.questions;
  const Answerers& answerers = plan.answerers;
  PlanRecord record;
  record.axiscert = axiscert_version;
  record.predicate = questions.predicate().id;
  record.seed = {questions.seed};
  for (const Kernel* kernel : answerers.kernels) record.kernels.push_back(kernel->id);
  record.precisions = questions.precisions;
  for (const SourcePtr& source : questions.sources) {
    record.families.push_back(source->name());
    record.generators.put(source->name()) = {static_cast<std::uint64_t>(source->version()), source->exact_arithmetic(),
                                             source->purpose()};
    if (const auto file = source->file()) record.files.push_back(file_record(*file));
  }
  for (const FileInfo& file : answerers.plugins) record.files.push_back(file_record(file));
  CountsByFamily units;
  for (std::size_t s = 0; s < questions.sources.size(); ++s) {
    for (const CellResult& cell : result.cells) {
      if (cell.source != s) continue;
      const std::string family = questions.sources[s]->name();
      record.trials.put(family)[cell.precision] = cell.queries;
      units.put(family)[cell.precision] = cell.units_done;
    }
  }
  for (const auto& [comparison, tolerance] : plan.judging.tolerance_texts) record.tolerance.put(comparison) = tolerance;
  for (const std::string& level : required.levels) record.require.levels.push_back(level);
  if (!required.allow_unchecked.empty())
    record.allow_unchecked.emplace(required.allow_unchecked.begin(), required.allow_unchecked.end());
  record.margin_queries = margin_queries;
  if (answerers.replies) record.replies = replies_record(answerers);
  // Without a time limit the trials determine the units; an interrupted run did only some of them.
  if (questions.seconds || !result.complete) record.units_done = std::move(units);
  return record;
}

PlanRecord plan_record(const Plan& plan, const RunRequirements& required) {
  return plan_record(plan, planned(plan.questions), required);
}

}  // namespace axiscert
