#include "fuzz/search/pools.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

#include "fuzz/campaign/campaign.h"
#include "fuzz/text/json.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

// A query of the run by its place, with the severity of what it showed.
template <class Rank>
struct RankedPlace {
  Rank rank;
  const Source* source;
  std::uint64_t position;
};

template <class Rank>
void add(std::vector<RankedPlace<Rank>>& all, const Leaders<Rank>& leaders, const Source& source) {
  for (const auto& [rank, position] : leaders.candidates()) all.push_back({rank, &source, position});
}

// The most severe first; of equals the one whose source and position come first.
template <class Real, class Rank>
std::vector<Numbers<Real>> most_severe(std::vector<RankedPlace<Rank>> all, std::uint64_t seed) {
  std::stable_sort(all.begin(), all.end(), [](const auto& x, const auto& y) { return x.rank > y.rank; });
  all.resize(std::min(all.size(), Pool<Real>::capacity));
  std::vector<Numbers<Real>> queries;
  for (const auto& [rank, source, position] : all) queries.push_back(source->template make<Real>(seed, position));
  return queries;
}

}  // namespace

template <class Real>
Beginning<Real> first_found(const SearchPlan& plan, const std::vector<Aim>& aims,
                            const std::atomic<bool>& interrupted) {
  Beginning<Real> beginning{
      std::vector<std::vector<Numbers<Real>>>(aims.size()), {}, std::vector<std::uint64_t>(aims.size())};
  if (plan.first_queries == 0 || plan.first_sources.empty()) return beginning;
  Plan run;
  run.questions.seed = plan.seed;
  run.answerers.kernels = {plan.kernel};
  run.questions.sources = plan.first_sources;
  run.questions.precisions = {plan.precision};
  run.questions.trials = [&](const Source&, Precision) { return plan.first_queries; };
  run.running.target = plan.target;
  run.running.threads = plan.threads;
  const CampaignResult result = run_campaign(run, interrupted, {});
  for (const CellResult& cell : result.cells) merge_fields(beginning.looked_at, looked_at_of(cell.tallies.front()));
  for (std::size_t i = 0; i < aims.size(); ++i) {
    const Aim& aim = aims[i];
    std::vector<RankedPlace<double>> wrong;
    std::vector<RankedPlace<Decimal6>> errors;
    for (const CellResult& cell : result.cells) {
      const Source& source = *run.questions.sources[cell.source];
      const Tally& tally = cell.tallies.front();
      if (aim.goal == Goal::missed_contact || aim.goal == Goal::critical_radius) {
        add(wrong, tally.verdict.deepest_false_separation, source);
      }
      if (aim.goal == Goal::phantom_contact || aim.goal == Goal::critical_radius) {
        add(wrong, tally.verdict.deepest_false_contact, source);
      }
      if (aim.goal == Goal::number) {
        beginning.judged[i] += judged_counted(tally.contacts, fault_of(aim));
        for (const auto& [size, position] : worst_counted(tally.contacts, fault_of(aim)))
          wrong.push_back({size, &source, position});
      }
      if (aim.goal == Goal::error || aim.goal == Goal::relative_error) {
        add(errors, tally.comparisons[aim.which].largest_error, source);
      }
    }
    beginning.found[i] = is_about_a_comparison(aim.goal) ? most_severe<Real>(std::move(errors), plan.seed)
                                                         : most_severe<Real>(std::move(wrong), plan.seed);
  }
  return beginning;
}
template Beginning<float> first_found(const SearchPlan&, const std::vector<Aim>&, const std::atomic<bool>&);
template Beginning<double> first_found(const SearchPlan&, const std::vector<Aim>&, const std::atomic<bool>&);

namespace {

using Json = nlohmann::ordered_json;

// Has to be raised whenever the same plan would give a different result.
constexpr int search_version = 5;
constexpr const char* state_format = "axiscert-search-state/5";

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
  return {{"schema", state_format},
          {"search_version", search_version},
          {"kernel", plan.kernel->id},
          {"precision", name(plan.precision)},
          {"seed", plan.seed},
          {"comparisons", comparison_names},
          {"what", plan.what},
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
  header["judged"] = state.judged;
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

namespace {

Json state_header(std::string_view text, const std::string& name) {
  const std::size_t end = text.find('\n');
  const Json header = Json::parse(text.substr(0, end), nullptr, false);
  if (end == text.npos || !header.is_object() || !header.contains("schema")) {
    throw Error(fmt::format("{} is not the state of a search", name));
  }
  if (header["schema"] != state_format) {
    throw Error(fmt::format("{}: its schema is {}, but this axiscert reads \"{}\"; begin the search without --resume",
                            name, shown(header["schema"].dump()), state_format));
  }
  return header;
}

}  // namespace

void require_state_format(std::string_view text, const std::string& name) { state_header(text, name); }

SearchState parse_state(std::string_view text, const SearchPlan& plan, const std::vector<Aim>& aims) {
  const std::size_t end = text.find('\n');
  const Json header = state_header(text, "the state to resume from");
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
  SearchState state{count("islands"), count("evaluations"), std::vector<StoredPools>(aims.size()), {}, {}, {}};
  const Json looked_at = header.value("looked_at", Json::array());
  for (std::size_t i = 0; i < aims.size(); ++i) {
    state.looked_at.push_back(parse_looked_at(looked_at.size() == aims.size() ? looked_at[i] : Json()));
    state.judged.push_back(count_of("judged", i));
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
