// report.html: one file that needs nothing else. The page's own text is under page/; this fills in the data.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/number_text.h"
#include "kernel/names.h"
#include "reports/embedded.h"
#include "reports/finding.h"
#include "reports/format.h"
#include "reports/page_template.h"
#include "reports/reproduce.h"
#include "reports/requirement.h"
#include "reports/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t witness_limit = 200;

// What the schema says of each counter: the page's column notes.
Json notes() {
  const Json schema = Json::parse(embedded::record_schema_json);
  Json notes;
  for (const char* part : {"family", "truth", "verdict", "links", "axis", "comparison", "critical_radius", "axes",
                           "comparisons", "outside_limits", "finding"}) {
    for (const auto& [member, rule] : schema["$defs"][part]["properties"].items()) {
      notes[part][member] = rule.value("description", "");
    }
  }
  return notes;
}

std::string decimal(const Json& number, const Json& precision) {
  const std::string text = number;
  return precision == name(Precision::binary32) ? fmt::format("{}", parse_number<float>(text))
                                                : fmt::format("{}", parse_number<double>(text));
}

Json witness_card(const Json& witness, const Json& plan) {
  Json card = witness;
  Json& decimals = card["decimal"] = Json::object();
  for (const char* point : {"a", "b", "c", "p"}) {
    for (const Json& number : witness[point]) decimals[point].push_back(decimal(number, witness["precision"]));
  }
  decimals["r"] = decimal(witness["r"], witness["precision"]);
  card["command"] = replay_command(witness, plan);
  return card;
}

// The members that the page shows, and no other.
Json throughput(const Json& info) {
  Json rows = Json::array();
  if (!info.contains("throughput")) return rows;
  for (const Json& given : info["throughput"]) {
    Json& row = rows.emplace_back();
    for (const char* member : {"family", "precision", "queries", "seconds_of_core", "queries_per_second_and_core"}) {
      row[member] = given[member];
    }
  }
  return rows;
}

Json kernel_data(const Json& kernel) {
  Json data = kernel;
  const auto limit = [](const Json& family) {
    const double per_million = zero_limit_per_million(family);
    return per_million < 0 ? Json(nullptr) : Json(per_million);
  };
  for (Json& family : data["families"]) family["zero_limit_per_million"] = limit(family);
  data["touching_text"] = touching_text(kernel);
  data["limits_text"] = limits_text(kernel);
  data["all"] = all_families(kernel);
  if (data["all"].empty()) data["all"] = nullptr;
  else data["all"]["zero_limit_per_million"] = limit(data["all"]);
  return data;
}

Json findings_data(const Json& record) {
  Json data = Json::array();
  for (const FindingGroup& group : finding_groups(record)) {
    const Json& finding = *group.first;
    Json& shown = data.emplace_back();
    for (const char* member : {"kernel", "precision", "family", "kind", "count", "detail", "address"}) {
      shown[member] = finding[member];
    }
    shown["others"] = group.others_text();
    shown["command"] = finding["address"].is_null() ? "" : replay_command(finding, record["plan"]);
  }
  return data;
}

Json requirement_data(const Json& record) {
  const Json& require = record["plan"]["require"];
  if (require.is_null()) return nullptr;
  Json data = {{"level", require}, {"sentence", parse_requirement(require).sentence()}, {"failures", Json::array()}};
  for (const Failure& f : unmet(record, require)) {
    data["failures"].push_back({{"kernel", f.kernel},
                                {"precision", f.precision},
                                {"family", f.family},
                                {"count", f.count},
                                {"what", f.what},
                                {"witness", f.witness}});
  }
  return data;
}

Json page_data(const Run& run) {
  const Json& record = run.record;
  Json data = {{"complete", record["complete"]}, {"plan", record["plan"]}, {"requirement", requirement_data(record)},
               {"links", Json::object()},        {"notes", notes()},       {"kernels", Json::array()}};
  data["plan"].erase("seed");  // 64 bits: a number in a page holds 53; the facts have it as text
  for (std::size_t i = 0; i < link_count; ++i) data["links"][std::string(link_names[i])] = link_meanings[i];
  for (const Json& kernel : record["kernels"]) data["kernels"].push_back(kernel_data(kernel));
  data["findings"] = findings_data(record);
  data["not_judged"] = not_judged(record);
  data["witnesses"] = {{"total", record["witnesses"].size()}, {"cards", Json::array()}};
  for (const Json* witness : worst_witnesses(record, witness_limit)) {
    data["witnesses"]["cards"].push_back(witness_card(*witness, record["plan"]));
  }
  data["command"] = run_command(record["plan"]);
  data["facts"] = plan_facts(run);
  data["throughput"] = throughput(run.info);
  data["not_checked"] = not_checked(record);
  return data;
}

std::string render(const Run& run) {
  const std::pair<std::string_view, std::string> places[] = {
      {"/*CSS*/", std::string(embedded::report_css)},
      {"/*DATA*/", inert_json(page_data(run))},
      {"/*JS*/", fmt::format("{}\n{}\n{}\n{}", embedded::table_js, embedded::results_js, embedded::witnesses_js,
                             embedded::report_js)}};
  return filled(embedded::report_html, places);
}

}  // namespace

extern const Format html_format = {"report.html", render};

}  // namespace axiscert
