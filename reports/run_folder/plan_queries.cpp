#include "reports/run_folder/plan_queries.h"

#include <span>

#include "kernel/base/sha256.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {

std::string short_sha256(const std::string& text) { return sha256_hex(std::as_bytes(std::span(text))).substr(0, 16); }

Json queries_of(const PlanRecord& plan, const std::string& family, Precision precision) {
  // The number of queries of a run that was stopped by time or by hand does not follow from its plan.
  if (plan.units_done) return nullptr;
  const auto* trials = plan.trials.find(family);
  if (trials == nullptr || !trials->contains(precision)) return nullptr;
  Json queries = {{"generator", plan.generators.at(family).version}, {"trials", trials->at(precision)}};
  bool is_list = false;
  for (const FileRecord& file : plan.files) {
    const bool is_queries = file.kind == "queries";
    if (family != file.kind + "/" + file.name && !(family == "corpus" && file.name == family && is_queries)) continue;
    queries["sha256"] = json_of(file.sha256);
    is_list |= is_queries;
  }
  if (!is_list) queries["seed"] = json_of(plan.seed);  // a list of queries is the same with every seed
  return queries;
}

std::string plan_fingerprint(const PlanRecord& plan) {
  if (plan.units_done) return "";
  Json all = {{"tolerance", json_of(plan.tolerance)}, {"families", Json::object()}};
  if (const std::string_view name = written_name(predicate_of(plan)); !name.empty()) all["predicate"] = name;
  for (const std::string& family : plan.families) {
    for (const Precision precision : plan.precisions)
      all["families"][family][std::string(name(precision))] = queries_of(plan, family, precision);
  }
  return short_sha256(all.dump());
}

}  // namespace axiscert
