// mutation-by-verdict.json.
#include "fuzz/queries/address.h"
#include "reports/instrument/mutation/black_box_reason.h"
#include "reports/instrument/mutation/black_box_report.h"

namespace axiscert {
namespace {

using namespace black_box;

std::optional<FailureData> failure_data(const std::optional<GateFailure>& failure) {
  return failure ? std::optional(FailureData{failure->family, failure->what}) : std::nullopt;
}

std::optional<SurvivalData> survival_data(const MutationPlan& plan, const BlackBoxResult& r) {
  if (!r.survival || r.refused) return std::nullopt;
  SurvivalData survival{*r.survival, {}};
  if (const auto& deepest = r.survival->deepest) {
    const SourcePtr source = family_source(*deepest->family);
    survival.deepest = {deepest->family->name, text(address_of(*source, plan.seed, r.precision, deepest->position)),
                        deepest->depth};
  }
  return survival;
}

}  // namespace

Json black_box_json(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                    const std::string& command) {
  MutationByVerdictData data;
  data.command = command;
  data.run = run_data(plan, score.complete, require);
  for (const Precision precision : plan.precisions) {
    BoxScore of_precision;
    for (const BlackBoxResult& r : score.mutants) {
      if (r.precision == precision) of_precision.add(r);
    }
    data.score[precision] = of_precision;
  }
  for (const BlackBoxResult& r : score.mutants) {
    const bool has_reason = !r.refused && (r.survival || is_equivalent(r));
    data.mutants.push_back({mutant_data(*r.mutant, r.precision),
                            has_magnitude(r) ? std::optional(r.mutant->magnitude) : std::nullopt, r.trials,
                            failure_data(r.refused), has_reason ? std::optional<Name>(reason_of(r).id) : std::nullopt,
                            survival_data(plan, r)});
  }
  for (const BlackBoxControl& c : score.controls) data.controls.push_back({c.id, c.precision, failure_data(c.refused)});
  return json_of(data);
}

}  // namespace axiscert
