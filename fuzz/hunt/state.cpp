#include "fuzz/hunt/state.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/error.h"

namespace axiscert {
namespace {

using Json = nlohmann::ordered_json;

// Raised whenever the same plan would find something else.
constexpr int search_version = 1;

// What has to be the same for a hunt to go on.
Json plan_json(const HuntPlan& plan) {
  Json sources = Json::array(), comparison_names = Json::array();
  for (const SourcePtr& source : plan.sources)
    sources.push_back(fmt::format("{}:{}", source->name(), source->version()));
  for (const Comparison which : plan.comparisons) comparison_names.push_back(info(which).name);
  return {{"schema", "axiscert-search-state/1"},
          {"search_version", search_version},
          {"kernel", plan.kernel->id},
          {"precision", name(plan.precision)},
          {"seed", plan.seed},
          {"comparisons", comparison_names},
          {"families", sources}};
}

constexpr std::string_view settled = "settled ", fresh = "fresh ";

}  // namespace

std::string state_text(const HuntPlan& plan, const std::vector<Aim>& aims, const HuntState& state) {
  Json header = plan_json(plan);
  header["islands"] = state.islands;
  header["evaluations"] = state.evaluations;
  std::string text = header.dump() + "\n";
  const auto add = [&](std::string_view kind, const Aim& aim, const std::vector<StoredQuery>& queries) {
    for (StoredQuery stored : queries) {
      stored.id = std::string(kind) + name(aim);
      text += query_line(stored) + "\n";
    }
  };
  for (std::size_t i = 0; i < aims.size(); ++i) {
    add(settled, aims[i], state.pools[i].settled);
    add(fresh, aims[i], state.pools[i].fresh);
  }
  return text;
}

HuntState parse_state(std::string_view text, const HuntPlan& plan, const std::vector<Aim>& aims) {
  const std::size_t end = text.find('\n');
  const Json header = Json::parse(text.substr(0, end), nullptr, false);
  if (end == text.npos || !header.is_object() || !header.contains("schema")) {
    throw Error("the state to resume from is no state of a search");
  }
  const Json expected = plan_json(plan);
  for (const auto& [key, value] : expected.items()) {
    if (header.contains(key) && header[key] == value) continue;
    throw Error(fmt::format("the state to resume from has {} {}, this search {}", key,
                            header.contains(key) ? header[key].dump() : "missing", value.dump()));
  }
  const auto count = [&](const char* key) {
    if (!header.contains(key) || !header[key].is_number_unsigned()) {
      throw Error(fmt::format("the state to resume from has no number of {}", key));
    }
    return header[key].get<std::uint64_t>();
  };
  HuntState state{count("islands"), count("evaluations"), std::vector<StoredPools>(aims.size())};
  for (StoredQuery& stored : parse_queries(text.substr(end + 1), "the state to resume from", plan.precision)) {
    const bool is_settled = stored.id.starts_with(settled);
    if (!is_settled && !stored.id.starts_with(fresh)) throw Error(fmt::format("'{}': no query of a state", stored.id));
    const std::string of = stored.id.substr(is_settled ? settled.size() : fresh.size());
    std::size_t i = 0;
    while (i < aims.size() && name(aims[i]) != of) ++i;
    if (i == aims.size() || stored.precision != plan.precision) {
      throw Error(fmt::format("the state to resume from: '{}' is none of this search", stored.id));
    }
    (is_settled ? state.pools[i].settled : state.pools[i].fresh).push_back(std::move(stored));
  }
  return state;
}

}  // namespace axiscert
