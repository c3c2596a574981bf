#include "reports/certificate/derived/reduced.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "fuzz/confirm/record.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/text/number_text.h"
#include "reports/certificate/derived/counts.h"
#include "reports/certificate/derived/stated.h"
#include "reports/certificate/statement/canonical.h"
#include "reports/certificate/statement/statement.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// So that no sum of counts overflows; deep asks 2^30.
constexpr std::uint64_t most_queries = std::uint64_t{1} << 48;

std::uint64_t reduced_count(const Json& object, const char* member) { return object[member].get<std::uint64_t>(); }

class Reducer {
 public:
  Reducer(const Json& predicate, const std::string& name)
      : name_(name),
        kernel_(predicate["kernel"]),
        materials_(predicate["materials"]),
        plan_(plan_again()),
        test_(test_of(plan_)),
        stretches_(cells(), reduced_count(materials_["plan"], "units_per_stretch")) {}

  const Stretches& stretches() const { return stretches_; }
  void require_usual_stretches() const {
    const std::uint64_t usual = Stretches::default_units_each(cells());
    if (stretches_.units_each() != usual)
      refuse(
          fmt::format("its stretches have {} units, and `certify` makes them of {}", stretches_.units_each(), usual));
  }

  Json record() {
    require_all_stretches();
    Json record = {{"schema", record_schema}, {"complete", true},          {"plan", plan_},
                   {"kernels", kernels()},    {"findings", Json::array()}, {"witnesses", Json::array()}};
    add_up(record);
    take_findings(record);
    return record;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw NotValid(fmt::format("{}: {}", name_, what)); }

  Json plan_again() const {
    Json plan = materials_["plan"]["plan"];
    if (!plan.contains("kernels") || !plan["kernels"].is_array() || plan["kernels"].empty() ||
        plan["kernels"][0] != portable_id) {
      refuse("the first kernel of its plan is not called \"kernel\"");
    }
    plan["kernels"][0] = kernel_["id"];
    plan["axiscert"] = materials_["axiscert"]["version"];
    require_form<PlanRecord>(plan, name_ + ": its plan");
    if (!plan["units_done"].is_null()) refuse("its plan was not done to its end");
    if (plan.value("test", Json()) != kernel_["test"]) refuse("its kernel and its plan are of different tests");
    for (const Json& family : plan["families"]) {
      const Json by_precision = plan["trials"].value(family.get<std::string>(), Json::object());
      for (const Json& precision : plan["precisions"]) {
        const Json count = by_precision.value(precision.get<std::string>(), Json());
        if (!count.is_number_integer() || count > most_queries)
          refuse(fmt::format("its plan does not say how many queries of {} are asked in {}", shown(family.dump()),
                             precision.get<std::string>()));
      }
      if (!plan["generators"].contains(family.get<std::string>()))
        refuse(fmt::format("its plan does not say what makes the queries of {}", shown(family.dump())));
    }
    for (const char* member : {"trials", "generators"}) {
      if (plan[member].size() != plan["families"].size())
        refuse(fmt::format("its plan has {} of other families", member));
    }
    return plan;
  }

  std::vector<PlannedCell> cells() const {
    std::vector<PlannedCell> cells;
    for (const Precision precision : {Precision::binary64, Precision::binary32}) {  // as cells_of
      const Json& all = plan_["precisions"];
      if (std::find(all.begin(), all.end(), Json(name(precision))) == all.end()) continue;
      for (std::size_t s = 0; s < plan_["families"].size(); ++s) {
        const std::string family = plan_["families"][s];
        cells.push_back(
            {s, precision, reduced_count(plan_["trials"][family], std::string(name(precision)).c_str()), family});
      }
    }
    return cells;
  }

  // Every stretch of the plan once, in rising order.
  void require_all_stretches() const {
    const Json& tallies = materials_["tallies"];
    const std::uint64_t count = stretches_.count();
    std::uint64_t next = 0;
    for (const Json& tally : tallies) {
      const std::uint64_t number = reduced_count(tally, "stretch");
      if (number >= count) refuse(fmt::format("it has a stretch {}, and its plan has {}", number, thousands(count)));
      if (number < next)
        refuse(fmt::format("its stretches are not in rising order, each once: {} is there again", number));
      if (number > next) {
        refuse(fmt::format("it has {} of the plan's {} stretches: {} is missing", thousands(tallies.size()),
                           thousands(count), stretches_.text(next)));
      }
      ++next;
    }
    if (next != count) {
      refuse(fmt::format("it has {} of the plan's {} stretches: {} is missing", thousands(next), thousands(count),
                         stretches_.text(next)));
    }
  }

  Json kernels() const {
    Json kernels = Json::array();
    std::set<std::pair<std::string, std::string>> seen;
    for (const Json& entry : materials_["kernels"]) {
      const std::string where = fmt::format("{}: its kernel {} {}", name_, shown(entry["id"].get<std::string>()),
                                            entry["precision"].get<std::string>());
      kernels.push_back(entry_again(entry, kernel_["id"], where));
      if (!seen.emplace(entry["id"], entry["precision"]).second) throw NotValid(where + " is there twice");
      if (std::ranges::find(plan_["kernels"], kernels.back()["id"]) == plan_["kernels"].end())
        throw NotValid(where + " is none of its plan");
    }
    for (const Json& id : plan_["kernels"]) {
      if (std::ranges::none_of(kernels, [&](const Json& entry) { return entry["id"] == id; }))
        refuse(fmt::format("it has no counts of the kernel {}", shown(id.get<std::string>())));
    }
    return kernels;
  }

  // Adds the counts of every stretch to the families of its kernels.
  void add_up(Json& record) {
    struct Place {
      Json* entry = nullptr;  // none where the kernel does not exist in that precision
      Json none;
    };
    // By kernel of the plan and precision.
    std::map<std::pair<std::size_t, std::string>, Place> places;
    for (std::size_t k = 0; k < plan_["kernels"].size(); ++k) {
      for (Json& entry : record["kernels"]) {
        if (entry["id"] == plan_["kernels"][k])
          places[{k, entry["precision"].get<std::string>()}] = {&entry, no_counts(entry, test_)};
      }
    }
    std::map<const Json*, std::map<std::string, Json>> by_entry;
    for (const Json& tally : materials_["tallies"]) {
      const std::uint64_t number = reduced_count(tally, "stretch");
      const Stretch stretch = stretches_.at(number);
      const std::string precision(name(stretch.precision)), family = plan_["families"][stretch.source];
      const std::string of = stretches_.text(number);
      if (tally["of"] != of)
        refuse(fmt::format("its stretch {} is said to be {}, and is {} in its plan", number, shown(tally["of"].dump()),
                           of));
      const Json& counts = tally["counts"];
      if (counts.size() != plan_["kernels"].size() || tally["sha256"].size() != plan_["kernels"].size())
        refuse(
            fmt::format("{}: {} kernels were run, and it has {} tallies", of, plan_["kernels"].size(), counts.size()));
      std::optional<Json> truth;  // the same for every kernel
      for (std::size_t k = 0; k < counts.size(); ++k) {
        const std::string where =
            fmt::format("{}: {}: the counts of {}", name_, of, plan_["kernels"][k].get<std::string>());
        const auto place = places.find({k, precision});
        if (place == places.end()) {
          if (!counts[k].empty()) throw NotValid(where + ": it does not exist in that precision");
          continue;
        }
        Json whole = whole_counts(place->second.none, counts[k], 1024 * stretch.queries, where);
        require_counts(whole, stretch.queries, where);
        Json& total = by_entry[place->second.entry][family];
        if (!truth) truth = whole["truth"];
        if (*truth != whole["truth"])
          throw NotValid(
              fmt::format("{}: the truth of the same queries is another than for the kernel before it", where));
        add_counts(total, whole);
      }
    }
    for (Json& entry : record["kernels"]) put_families(entry, by_entry[&entry]);
  }

  void put_families(Json& entry, std::map<std::string, Json>& totals) const {
    const Json& stated = families_stated(entry);
    const std::string who =
        fmt::format("{}: {} {}", name_, entry["id"].get<std::string>(), entry["precision"].get<std::string>());
    Json radius;
    for (const Json& named : plan_["families"]) {
      const std::string family = named;
      const auto total = totals.find(family);
      const bool is_there = total != totals.end();
      if (stated.contains(family) != is_there)
        throw NotValid(fmt::format("{}: {} {} in its stretches, and not among its families, or the other way round",
                                   who, family, is_there ? "is" : "is not"));
      if (!is_there) continue;
      const std::string where = fmt::format("{} on {}", who, family);
      Json result = std::move(total->second);
      const Json& beside = stated[family];
      result["base_triangles"] = beside["base_triangles"];
      if (result["base_triangles"] > result["trials"]) throw NotValid(where + ": more triangles than queries");
      result["exact_arithmetic"] = plan_["generators"][family]["exact_arithmetic"];
      result["axes"] = result["comparisons"] = nullptr;
      add_counts(radius, result["critical_radius"]);
      put_invariance(result, beside, family, where);
      entry["families"][family] = std::move(result);
    }
    if (stated.size() != entry["families"].size()) throw NotValid(who + ": it has families that its plan has not");
    put_radius(entry["critical_radius"], radius, who);
  }

  const Json& families_stated(const Json& entry) const {
    for (const Json& stated : materials_["kernels"]) {
      const Json& id = stated["id"] == portable_id ? kernel_["id"] : stated["id"];
      if (id == entry["id"] && stated["precision"] == entry["precision"]) return stated["families"];
    }
    throw std::logic_error("an entry that came from nowhere");
  }

  static void put_invariance(Json& result, const Json& beside, const std::string& family, const std::string& where) {
    const ImageGroup* group = image_group(family);
    if (group != nullptr && !beside.contains("invariance"))
      throw NotValid(where + ": it does not say what its images came to");
    if (!beside.contains("invariance")) return;
    result["invariance"] = invariance_again(beside["invariance"], where);
    for (std::size_t i = 1; group != nullptr && i < group->size; ++i) {
      const std::string_view kind = image_kind_names[group->kind(i)];
      if (!result["invariance"].contains(std::string(kind)))
        throw NotValid(fmt::format("{}: it does not say what its images of {} came to", where, kind));
    }
    for (const Json& changes : result["invariance"]) {
      if (changes["images"] > result["trials"]) throw NotValid(where + ": more images than queries");
    }
  }

  // All but the medians follows from the stretches.
  static void put_radius(Json& stated, Json& radius, const std::string& who) {
    if (radius.is_null()) return;
    const bool has_errors = reduced_count(radius, "sampled") > reduced_count(radius, "unbounded");
    if (!has_errors) radius["largest_ulps"] = nullptr;
    for (const auto& [member, value] : radius.items()) {
      if (stated[member] != value)
        throw NotValid(fmt::format("{}: critical_radius: {} is {}, and its stretches come to {}", who, member,
                                   shown(stated[member].dump()), value.dump()));
    }
    if (stated["median_ulps"].is_null() == has_errors)
      throw NotValid(fmt::format("{}: critical_radius: it has {} median error", who, has_errors ? "no" : "a"));
  }

  void take_findings(Json& record) const {
    std::map<std::tuple<std::string, std::string, std::string, std::string>, std::uint64_t> counted;
    for (Json& entry : record["kernels"]) {
      for (auto& [family, result] : entry["families"].items()) {
        for (const auto& [kind, count] : result["findings"].items()) {
          if (count != 0) counted[{entry["id"], entry["precision"], family, kind}] = count.get<std::uint64_t>();
        }
        result.erase("findings");
      }
    }
    for (Json finding : materials_["findings"]) {
      if (finding["kernel"] == portable_id) finding["kernel"] = kernel_["id"];
      const std::string what = fmt::format("its finding {} of {}", shown(finding["kind"].get<std::string>()),
                                           shown(finding["kernel"].get<std::string>()));
      if (!finding["family"].is_null()) {
        if (finding["precision"].is_null()) refuse(what + " is in no precision");
        const auto found = counted.find({finding["kernel"], finding["precision"], finding["family"], finding["kind"]});
        if (found == counted.end() || finding["count"] != found->second)
          refuse(fmt::format("{} is counted {} times, and {} in its stretches", what, finding["count"].dump(),
                             found == counted.end() ? 0 : found->second));
        counted.erase(found);
      }
      record["findings"].push_back(finding);
    }
    for (const auto& [key, count] : counted)
      refuse(fmt::format("its stretches have the finding {} of {}, which it does not name", std::get<3>(key),
                         std::get<0>(key)));
  }

  const std::string& name_;
  const Json &kernel_, &materials_;
  const Json plan_;
  const TestDescription& test_;
  const Stretches stretches_;
};

}  // namespace

Json kernels_of_record(const Json& record) {
  Json kernels = Json::array();
  for (Json entry : record["kernels"]) {
    Json families = Json::object();
    for (const auto& [family, result] : entry["families"].items()) {
      families[family] = {{"base_triangles", result["base_triangles"]}};
      if (result.contains("invariance")) families[family]["invariance"] = result["invariance"];
    }
    if (entry["id"] == record["plan"]["kernels"][0]) entry["id"] = portable_id;
    entry["families"] = std::move(families);
    kernels.push_back(without_fractions(entry));
  }
  return kernels;
}

Json findings_of_record(const Json& record) {
  Json findings = Json::array();
  for (const Json& finding : record["findings"]) {
    Json kept = Json::object();
    for (const char* member : {"kernel", "precision", "family", "kind", "count", "detail", "address"})
      kept[member] = finding[member];
    if (kept["kernel"] == record["plan"]["kernels"][0]) kept["kernel"] = portable_id;
    findings.push_back(kept);
  }
  return findings;
}

Stretches stretches_of(const Json& predicate, const std::string& name) { return Reducer(predicate, name).stretches(); }

void require_usual_stretches(const Json& predicate, const std::string& name) {
  Reducer(predicate, name).require_usual_stretches();
}

Json reduced_record(const Json& predicate, const std::string& name) { return Reducer(predicate, name).record(); }

}  // namespace axiscert
