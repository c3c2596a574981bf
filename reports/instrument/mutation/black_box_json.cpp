// mutation-by-verdict.json: schemas/mutation-by-verdict.schema.json.
#include "fuzz/queries/address.h"
#include "reports/instrument/mutation/black_box_reason.h"
#include "reports/instrument/mutation/black_box_report.h"
#include "kernel/base/version.h"

namespace axiscert {
namespace {

using namespace black_box;

class BlackBoxJson {
 public:
  BlackBoxJson(const MutationPlan& plan, const BlackBoxScore& score) : plan_(plan), score_(score) {}

  Json data(const std::string& require, const std::string& command) const {
    Json all = Json::array(), families = Json::array(), scores = Json::object(), controls = Json::array();
    for (const BlackBoxResult& r : score_.mutants) all.push_back(mutant_json(r));
    for (const Family* family : plan_.families) families.push_back(family->name);
    for (const Precision precision : plan_.precisions) {
      BoxScore of_precision;
      for (const BlackBoxResult& r : score_.mutants) {
        if (r.precision == precision) of_precision.add(r);
      }
      scores[std::string(name(precision))] = of_precision.json();
    }
    for (const BlackBoxControl& c : score_.controls) {
      controls.push_back({{"kernel", c.id}, {"precision", name(c.precision)}, {"refused", failure_json(c.refused)}});
    }
    return {{"schema", black_box_schema},
            {"axiscert", axiscert_version},
            {"revision", axiscert_revision},
            {"command", command},
            {"complete", score_.complete},
            {"kernel", plan_.base},
            {"require", require},
            {"seed", plan_.seed},
            {"trials", plan_.trials},
            {"families", families},
            {"score", scores},
            {"mutants", all},
            {"controls", controls}};
  }

 private:
  static Json failure_json(const std::optional<GateFailure>& failure) {
    if (!failure) return nullptr;
    return {{"family", failure->family}, {"what", failure->what}};
  }

  Json survival_json(const BlackBoxResult& r) const {
    if (!r.survival || r.refused) return nullptr;
    const Survival& s = *r.survival;
    Json deepest = nullptr;
    if (s.deepest_family != nullptr) {
      const SourcePtr source = family_source(*s.deepest_family);
      deepest = {{"family", s.deepest_family->name},
                 {"address", text(address_of(*source, plan_.seed, r.precision, s.deepest_position))},
                 {"depth", s.deepest}};
    }
    return {{"queries", s.queries},
            {"other_verdicts", s.other_verdicts},
            {"wrong", s.wrong},
            {"wrong_in_exact_arithmetic", s.wrong_in_exact},
            {"touching_in_exact_arithmetic", s.touching_in_exact},
            {"deepest", deepest}};
  }

  Json mutant_json(const BlackBoxResult& r) const {
    const mutants::Mutant& m = *r.mutant;
    return {{"id", m.id},
            {"precision", name(r.precision)},
            {"fault", m.fault},
            {"where", m.where},
            {"what", m.what},
            {"magnitude", has_magnitude(r) ? Json(m.magnitude) : Json(nullptr)},
            {"trials", r.trials},
            {"refused", failure_json(r.refused)},
            {"reason", r.refused || (!r.survival && !is_equivalent(r)) ? Json(nullptr) : Json(reason_of(r).id)},
            {"survival", survival_json(r)}};
  }

  const MutationPlan& plan_;
  const BlackBoxScore& score_;
};

}  // namespace

Json black_box_json(const MutationPlan& plan, const BlackBoxScore& score, const std::string& require,
                    const std::string& command) {
  return BlackBoxJson(plan, score).data(require, command);
}

}  // namespace axiscert
