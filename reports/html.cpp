// report.html: one file that needs nothing else. The page's own text is under page/; this fills in the data.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/number_text.h"
#include "kernel/names.h"
#include "reports/embedded.h"
#include "reports/format.h"
#include "reports/reproduce.h"
#include "reports/requirement.h"
#include "reports/summary.h"

namespace axiscert {
namespace {

constexpr std::size_t witness_limit = 200;

// JSON that stays JSON inside a script element, whatever its strings hold. These characters occur in strings only.
std::string inert(const Json& data) {
  std::string text;
  const std::string json = data.dump();
  for (std::size_t i = 0; i < json.size(); ++i) {
    const bool is_separator =
        json.compare(i, 2, "\xE2\x80") == 0 && i + 2 < json.size() && (json[i + 2] == '\xA8' || json[i + 2] == '\xA9');
    if (json[i] == '<') text += "\\u003c";
    else if (json[i] == '>') text += "\\u003e";
    else if (json[i] == '&') text += "\\u0026";
    else if (is_separator) {
      text += json[i + 2] == '\xA8' ? "\\u2028" : "\\u2029";
      i += 2;
    } else text += json[i];
  }
  return text;
}

// What the schema says of each counter: the page's column notes.
Json notes() {
  const Json schema = Json::parse(embedded::record_schema_json);
  Json notes;
  for (const char* part :
       {"family", "truth", "verdict", "links", "axis", "comparison", "critical_radius", "axes", "comparisons"}) {
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

Json witness_card(const Json& witness) {
  Json card = witness;
  Json& decimals = card["decimal"] = Json::object();
  for (const char* point : {"a", "b", "c", "p"}) {
    for (const Json& number : witness[point]) decimals[point].push_back(decimal(number, witness["precision"]));
  }
  decimals["r"] = decimal(witness["r"], witness["precision"]);
  card["command"] = replay_command(witness);
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
  data["all"] = all_families(kernel);
  if (data["all"].empty()) data["all"] = nullptr;
  else data["all"]["zero_limit_per_million"] = limit(data["all"]);
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
  data["witnesses"] = {{"total", record["witnesses"].size()}, {"cards", Json::array()}};
  for (const Json* witness : worst_witnesses(record, witness_limit)) {
    data["witnesses"]["cards"].push_back(witness_card(*witness));
  }
  data["command"] = run_command(record["plan"]);
  data["facts"] = plan_facts(run);
  data["throughput"] = throughput(run.info);
  data["not_checked"] = not_checked(record);
  return data;
}

std::string render(const Run& run) {
  const std::string data = inert(page_data(run));
  const std::pair<std::string_view, std::string> parts[] = {
      {"/*CSS*/", std::string(embedded::report_css)},
      {"/*DATA*/", data},
      {"/*JS*/", fmt::format("{}\n{}\n{}\n{}", embedded::table_js, embedded::results_js, embedded::witnesses_js,
                             embedded::report_js)}};
  // Places are found in the template only, in its order, so that nothing in the data is taken for one.
  std::string page;
  std::string_view rest = embedded::report_html;
  for (const auto& [place, text] : parts) {
    const std::size_t at = rest.find(place);
    if (at == rest.npos) throw std::logic_error(fmt::format("report.html has no place {}", place));
    page.append(rest.substr(0, at)).append(text);
    rest.remove_prefix(at + place.size());
  }
  return page.append(rest);
}

}  // namespace

extern const Format html_format = {"report.html", render};

}  // namespace axiscert
