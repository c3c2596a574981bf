#include "reports/run_folder/plan_queries.h"

#include <span>

#include "kernel/base/sha256.h"
#include "reports/run_folder/run_folder.h"

namespace axiscert {

std::string short_sha256(const std::string& text) { return sha256_hex(std::as_bytes(std::span(text))).substr(0, 16); }

Json queries_of(const Json& plan, const std::string& family, const std::string& precision) {
  // The number of queries of a run that was stopped by time or by hand does not follow from its plan.
  if (!plan["units_done"].is_null() || !plan["trials"].contains(family) ||
      !plan["trials"][family].contains(precision)) {
    return nullptr;
  }
  Json queries = {{"generator", plan["generators"][family]["version"]}, {"trials", plan["trials"][family][precision]}};
  bool is_list = false;
  for (const Json& file : plan["files"]) {
    const std::string kind = file["kind"], name = file["name"];
    const bool is_source = family == kind + "/" + name || (family == "corpus" && name == family && kind == "queries");
    if (!is_source) continue;
    queries["sha256"] = file["sha256"];
    is_list |= kind == "queries";
  }
  if (!is_list) queries["seed"] = plan["seed"];  // a list of queries is the same with every seed
  return queries;
}

std::string plan_fingerprint(const Json& plan) {
  if (!plan["units_done"].is_null()) return "";
  Json all = {{"tolerance", plan["tolerance"]}, {"families", Json::object()}};
  if (const std::string_view name = written_name(test_of(plan)); !name.empty()) all["test"] = name;
  for (const Json& name : plan["families"]) {
    const std::string family = name;
    for (const Json& precision : plan["precisions"]) {
      all["families"][family][precision.get<std::string>()] = queries_of(plan, family, precision);
    }
  }
  return short_sha256(all.dump());
}

}  // namespace axiscert
