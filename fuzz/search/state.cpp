#include "fuzz/search/state.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "kernel/base/error.h"

namespace axiscert {
namespace {

using Json = nlohmann::ordered_json;

// Has to be raised whenever the same plan would give a different result.
constexpr int search_version = 3;

// The part of the plan that has to be the same for a search to continue.
Json search_plan_json(const SearchPlan& plan) {
  Json comparison_names = Json::array();
  const auto versions = [](const std::vector<SourcePtr>& sources) {
    Json all = Json::array();
    for (const SourcePtr& source : sources) all.push_back(fmt::format("{}:{}", source->name(), source->version()));
    return all;
  };
  for (const std::size_t which : plan.comparisons) {
    comparison_names.push_back(plan.kernel->predicate->comparisons[which].name);
  }
  return {{"schema", "axiscert-search-state/2"},
          {"search_version", search_version},
          {"kernel", plan.kernel->id},
          {"precision", name(plan.precision)},
          {"seed", plan.seed},
          {"comparisons", comparison_names},
          {"families", versions(plan.sources)},
          {"first_queries", plan.first_queries},
          {"first_families", versions(plan.first_sources)}};
}

// The pools of an aim, and the beginnings of the ids of their queries.
struct Kind {
  std::string_view prefix;
  std::vector<StoredQuery> StoredPools::*queries;
};
constexpr Kind kinds[] = {
    {"lineage ", &StoredPools::lineage}, {"fresh ", &StoredPools::fresh}, {"best ", &StoredPools::best}};

// Calls visit(name, count) for each count of queries in a state.
template <class Of, class Visit>
void for_each_count(Of& looked_at, const Visit& visit) {
  for_each_field<LookedAt>([&](const auto& field) {
    if constexpr (std::is_same_v<decltype(value_of(looked_at, field)), decltype((looked_at.decided))>)
      visit(std::string(field.name), value_of(looked_at, field));
  });
}

Json stored_looked_at(const LookedAt& looked_at) {
  Json json = Json::object();
  for_each_count(looked_at, [&](const std::string& key, std::uint64_t count) { json[key] = count; });
  if (const auto& fault = looked_at.first_fault) {
    json["first_fault"] = {
        {"place", fault->place}, {"said", name(fault->said)}, {"query", static_cast<const std::string&>(fault->query)}};
  }
  return json;
}

LookedAt parse_looked_at(const Json& json) {
  const auto fail = [] { return Error("the state to resume from does not say how much was looked at"); };
  if (!json.is_object()) throw fail();
  LookedAt looked_at;
  for_each_count(looked_at, [&](const std::string& key, std::uint64_t& count) {
    if (!json.contains(key) || !json[key].is_number_unsigned()) throw fail();
    count = json[key].get<std::uint64_t>();
  });
  if (!json.contains("first_fault")) return looked_at;
  const Json& fault = json["first_fault"];
  if (!fault.is_object() || !fault.value("place", Json()).is_number_unsigned() ||
      !fault.value("said", Json()).is_string() || !fault.value("query", Json()).is_string())
    throw fail();
  for (const Verdict verdict : enumerators<Verdict>) {
    if (fault["said"] == name(verdict)) {
      looked_at.first_fault = {fault["place"].get<std::uint64_t>(), verdict, fault["query"].get<std::string>()};
    }
  }
  return looked_at;
}

}  // namespace

std::string state_text(const SearchPlan& plan, const std::vector<Aim>& aims, const SearchState& state) {
  Json header = search_plan_json(plan);
  header["islands"] = state.islands;
  header["evaluations"] = state.evaluations;
  for (const StoredPools& pools : state.pools) {
    header["stalled"].push_back(pools.stalled);
    header["restarts"].push_back(pools.restarts);
  }
  header["looked_at"] = Json::array();
  for (const LookedAt& looked_at : state.looked_at) header["looked_at"].push_back(stored_looked_at(looked_at));
  header["begun"] = stored_looked_at(state.begun);
  std::string text = header.dump() + "\n";
  for (std::size_t i = 0; i < aims.size(); ++i) {
    for (const Kind& kind : kinds) {
      for (StoredQuery stored : state.pools[i].*kind.queries) {
        stored.id = std::string(kind.prefix) + name(aims[i], *plan.kernel->predicate);
        text += query_line(stored) + "\n";
      }
    }
  }
  return text;
}

SearchState parse_state(std::string_view text, const SearchPlan& plan, const std::vector<Aim>& aims) {
  const std::size_t end = text.find('\n');
  const Json header = Json::parse(text.substr(0, end), nullptr, false);
  if (end == text.npos || !header.is_object() || !header.contains("schema")) {
    throw Error("the state to resume from is not the state of a search");
  }
  const Json expected = search_plan_json(plan);
  for (const auto& [key, value] : expected.items()) {
    if (header.contains(key) && header[key] == value) continue;
    throw Error(fmt::format("the state to resume from has {} {}, this search {}", key,
                            header.contains(key) ? header[key].dump() : "missing", value.dump()));
  }
  const auto number = [&](const Json& value, const char* key) {
    if (!value.is_number_unsigned()) throw Error(fmt::format("the state to resume from has no number '{}'", key));
    return value.get<std::uint64_t>();
  };
  const auto count = [&](const char* key) { return number(header.value(key, Json()), key); };
  const auto count_of = [&](const char* key, std::size_t i) {
    const Json all = header.value(key, Json::array());
    return number(all.is_array() && all.size() == aims.size() ? all[i] : Json(), key);
  };
  SearchState state{count("islands"), count("evaluations"), std::vector<StoredPools>(aims.size()), {}, {}};
  const Json looked_at = header.value("looked_at", Json::array());
  for (std::size_t i = 0; i < aims.size(); ++i) {
    state.looked_at.push_back(parse_looked_at(looked_at.size() == aims.size() ? looked_at[i] : Json()));
  }
  state.begun = parse_looked_at(header.value("begun", Json()));
  for (std::size_t i = 0; i < aims.size(); ++i) {
    state.pools[i].stalled = count_of("stalled", i);
    state.pools[i].restarts = count_of("restarts", i);
  }
  if (end + 1 == text.size()) return state;  // nothing was found so far
  for (StoredQuery& stored : parse_queries(text.substr(end + 1), "the state to resume from", plan.precision)) {
    bool found = false;
    for (std::size_t i = 0; i < aims.size(); ++i) {
      for (const Kind& kind : kinds) {
        if (found || stored.precision != plan.precision || stored.predicate != plan.kernel->predicate ||
            stored.id != std::string(kind.prefix) + name(aims[i], *plan.kernel->predicate))
          continue;
        (state.pools[i].*kind.queries).push_back(stored);
        found = true;
      }
    }
    if (!found) throw Error(fmt::format("the state to resume from: '{}' does not belong to this search", stored.id));
  }
  return state;
}

}  // namespace axiscert
