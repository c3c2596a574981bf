#include "fuzz/text/json_form.h"
#include "reports/certificate/derived.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "fuzz/queries/image_groups.h"
#include "fuzz/text/merge.h"
#include "fuzz/text/number_text.h"
#include "reports/certificate/canonical.h"
#include "reports/certificate/materials.h"
#include "reports/certificate/statement.h"
#include "reports/run_folder/count_checks.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// So that no sum of counts overflows; deep asks 2^30.
constexpr std::uint64_t most_queries = std::uint64_t{1} << 48;

class Reducer {
 public:
  Reducer(const CertificatePredicate& predicate, const std::string& name)
      : name_(name),
        kernel_(predicate.kernel),
        materials_(predicate.materials),
        plan_(plan_again()),
        predicate_(predicate_of(plan_)),
        stretches_(cells(), materials_.plan.units_per_stretch.value) {}

  const Stretches& stretches() const { return stretches_; }
  void require_usual_stretches() const {
    const std::uint64_t usual = Stretches::default_units_each(cells());
    if (stretches_.units_each() != usual)
      refuse(
          fmt::format("its stretches have {} units, and `certify` makes them of {}", stretches_.units_each(), usual));
  }

  Record record() const {
    require_all_stretches();
    Record record;
    record.plan = plan_;
    record.kernels = kernels();
    take_findings(record, put_families(record));
    return record;
  }

 private:
  [[noreturn]] void refuse(const std::string& what) const { throw NotValid(fmt::format("{}: {}", name_, what)); }

  PlanRecord plan_again() const {
    Json json = materials_.plan.plan.json;
    if (!json.contains("kernels") || !json["kernels"].is_array() || json["kernels"].empty() ||
        json["kernels"][0] != portable_id) {
      refuse("the first kernel of its plan is not called \"kernel\"");
    }
    json["kernels"][0] = json_of(kernel_.id);
    json["axiscert"] = json_of(materials_.axiscert.version);
    auto plan = form_again<PlanRecord>(json, name_ + ": its plan");
    if (plan.units_done) refuse("its plan was not done to its end");
    if (plan.predicate != kernel_.question) refuse("its kernel and its plan are of different predicates");
    for (const std::string& family : plan.families) {
      const auto* const by_precision = plan.trials.find(family);
      for (const Precision precision : plan.precisions) {
        if (by_precision == nullptr || !by_precision->contains(precision) || by_precision->at(precision) > most_queries)
          refuse(fmt::format("its plan does not say how many queries of {} are asked in {}", shown(Json(family).dump()),
                             name(precision)));
      }
      if (!plan.generators.contains(family))
        refuse(fmt::format("its plan does not say what makes the queries of {}", shown(Json(family).dump())));
    }
    const auto require_no_others = [&](const char* member, std::size_t size) {
      if (size != plan.families.size()) refuse(fmt::format("its plan has {} of other families", member));
    };
    require_no_others("trials", plan.trials.size());
    require_no_others("generators", plan.generators.size());
    return plan;
  }

  std::vector<PlannedCell> cells() const {
    std::vector<PlannedCell> cells;
    for (const Precision precision : {Precision::binary64, Precision::binary32}) {  // as cells_of
      if (std::ranges::find(plan_.precisions, precision) == plan_.precisions.end()) continue;
      for (std::size_t s = 0; s < plan_.families.size(); ++s) {
        const std::string& family = plan_.families[s];
        cells.push_back({s, precision, plan_.trials.at(family).at(precision), family});
      }
    }
    return cells;
  }

  // Every stretch of the plan once, in rising order.
  void require_all_stretches() const {
    const std::vector<TallyMaterial>& tallies = materials_.tallies;
    const std::uint64_t count = stretches_.count();
    std::uint64_t next = 0;
    for (const TallyMaterial& tally : tallies) {
      const std::uint64_t number = tally.stretch;
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

  // In the order of the materials.
  std::vector<KernelRecord> kernels() const {
    std::vector<KernelRecord> kernels;
    std::set<std::pair<std::string, Precision>> seen;
    for (const KernelMaterial& entry : materials_.kernels) {
      const std::string where = fmt::format("{}: its kernel {} {}", name_, shown(entry.id), name(entry.precision));
      const std::string& id = kernels.emplace_back(entry_again(json_of(entry), kernel_.id, where)).id;
      if (!seen.emplace(entry.id, entry.precision).second) throw NotValid(where + " is there twice");
      if (std::ranges::find(plan_.kernels, id) == plan_.kernels.end()) throw NotValid(where + " is none of its plan");
    }
    for (const std::string& id : plan_.kernels) {
      if (std::ranges::none_of(kernels, [&](const KernelRecord& entry) { return entry.id == id; }))
        refuse(fmt::format("it has no counts of the kernel {}", shown(id)));
    }
    return kernels;
  }

  using ByFamily = std::map<std::string, StretchCounts>;

  // The counts of every stretch added up, of each of the kernels.
  std::vector<ByFamily> added_up(const std::vector<KernelRecord>& kernels) const {
    struct Place {
      std::size_t entry;
      Json none;
    };
    // By kernel of the plan and precision: none where the kernel does not exist in that precision.
    std::map<std::pair<std::size_t, Precision>, Place> places;
    for (std::size_t k = 0; k < plan_.kernels.size(); ++k) {
      for (std::size_t i = 0; i < kernels.size(); ++i) {
        if (kernels[i].id == plan_.kernels[k])
          places[{k, kernels[i].precision}] = {i, no_counts(kernels[i], predicate_)};
      }
    }
    std::vector<ByFamily> totals(kernels.size());
    for (const TallyMaterial& tally : materials_.tallies) {
      const std::uint64_t number = tally.stretch;
      const Stretch stretch = stretches_.at(number);
      const std::string of = stretches_.text(number);
      if (tally.of != of)
        refuse(fmt::format("its stretch {} is said to be {}, and is {} in its plan", number,
                           shown(Json(tally.of).dump()), of));
      const std::vector<JsonObject>& counts = tally.counts;
      if (counts.size() != plan_.kernels.size() || tally.sha256.size() != plan_.kernels.size())
        refuse(fmt::format("{}: {} kernels were run, and it has {} tallies", of, plan_.kernels.size(), counts.size()));
      std::optional<TruthCounts> truth;  // the same for every kernel
      for (std::size_t k = 0; k < counts.size(); ++k) {
        const std::string& id = plan_.kernels[k];
        const std::string where = fmt::format("{}: {}: the counts of {}", name_, of, id);
        const auto place = places.find({k, stretch.precision});
        if (place == places.end()) {
          if (!counts[k].json.empty()) throw NotValid(where + ": it does not exist in that precision");
          continue;
        }
        const auto& [entry, none] = place->second;
        const StretchCounts whole = counts_again(whole_counts(none, counts[k].json, 1024 * stretch.queries, where),
                                                 kernels[entry].touching, stretch.queries, where);
        if (!truth) truth = whole.truth;
        if (*truth != whole.truth)
          throw NotValid(
              fmt::format("{}: the truth of the same queries is another than for the kernel before it", where));
        const auto [total, is_first] = totals[entry].try_emplace(plan_.families[stretch.source], whole);
        if (!is_first) merge_fields(total->second, whole);
      }
    }
    return totals;
  }

  // By kernel, precision and family.
  using Findings = std::map<std::tuple<std::string, Precision, std::string, FindingKind>, std::uint64_t>;

  // Returns the findings that the stretches have.
  Findings put_families(Record& record) const {
    Findings findings;
    const std::vector<ByFamily> totals = added_up(record.kernels);
    for (std::size_t i = 0; i < record.kernels.size(); ++i) {
      KernelRecord& entry = record.kernels[i];
      put_families(entry, materials_.kernels[i].families, totals[i]);
      for (const auto& [family, total] : totals[i]) {
        for (const auto& [kind, count] : total.findings) {
          if (count != 0) findings[{entry.id, entry.precision, family, kind}] = count;
        }
      }
    }
    return findings;
  }

  // `stated`: what the certificate says of its families beside the stretches.
  void put_families(KernelRecord& entry, const NamedValues<FamilyMaterial>& stated, const ByFamily& totals) const {
    const std::string& id = entry.id;
    const std::string who = fmt::format("{}: {} {}", name_, id, name(entry.precision));
    std::optional<CriticalRadiusRecord> radius;
    for (const std::string& family : plan_.families) {
      const auto total = totals.find(family);
      const bool is_there = total != totals.end();
      if (stated.contains(family) != is_there)
        throw NotValid(fmt::format("{}: {} {} in its stretches, and not among its families, or the other way round",
                                   who, family, is_there ? "is" : "is not"));
      if (!is_there) continue;
      const std::string where = fmt::format("{} on {}", who, family);
      const StretchCounts& counts = total->second;
      const FamilyMaterial& beside = stated.at(family);
      FamilyRecord& result = entry.families.put(family);
      static_cast<FamilyCounts&>(result) = counts;
      result.critical_radius = counts.critical_radius;
      if (counts.classes) {
        result.classes.emplace();
        for (const auto& [which, count] : *counts.classes) (*result.classes)[which] = {count, {}};
      }
      result.base_triangles = beside.base_triangles;
      if (result.base_triangles > result.trials) throw NotValid(where + ": more triangles than queries");
      result.exact_arithmetic = plan_.generators.at(family).exact_arithmetic;
      if (radius) RadiiAdded::merge(*radius, counts.critical_radius);
      else radius = counts.critical_radius;
      put_invariance(result, beside, family, where);
    }
    if (stated.size() != entry.families.size()) throw NotValid(who + ": it has families that its plan has not");
    if (radius) require_radius(entry.critical_radius, *radius, who);
  }

  static void put_invariance(FamilyRecord& result, const FamilyMaterial& beside, const std::string& family,
                             const std::string& where) {
    const ImageGroup* group = image_group(family);
    if (group != nullptr && !beside.invariance) throw NotValid(where + ": it does not say what its images came to");
    if (!beside.invariance) return;
    result.invariance = invariance_again(beside.invariance->json, where);
    for (std::size_t i = 1; group != nullptr && i < group->size; ++i) {
      if (!result.invariance->contains(group->kind(i)))
        throw NotValid(fmt::format("{}: it does not say what its images of {} came to", where, name(group->kind(i))));
    }
    for (const auto& [kind, changes] : *result.invariance) {
      if (changes.images > result.trials) throw NotValid(where + ": more images than queries");
    }
    result.asymmetry.emplace();
    if (!beside.image_numbers) return;
    const auto& numbers = result.asymmetry->numbers = image_numbers_again(beside.image_numbers->json, where);
    if (const auto fault = fault_of_image_numbers(*numbers, result.trials))
      throw NotValid(fmt::format("{}: {}", where, *fault));
  }

  // All but the medians follows from the stretches, `counted`.
  static void require_radius(const CriticalRadiusRecord& stated, CriticalRadiusRecord counted, const std::string& who) {
    const bool has_errors = counted.sampled > counted.unbounded;
    if (!has_errors) counted.largest_ulps.reset();
    counted.median_ulps = stated.median_ulps;
    counted.signed_median_ulps = stated.signed_median_ulps;
    const Json radius = json_of(stated), counted_radius = json_of(counted);
    for (const auto& [member, value] : counted_radius.items()) {
      if (radius[member] != value)
        throw NotValid(fmt::format("{}: critical_radius: {} is {}, and its stretches come to {}", who, member,
                                   shown(radius[member].dump()), value.dump()));
    }
    if (stated.median_ulps.has_value() != has_errors)
      throw NotValid(fmt::format("{}: critical_radius: it has {} median error", who, has_errors ? "no" : "a"));
  }

  void take_findings(Record& record, Findings counted) const {
    for (const FindingMaterial& stated : materials_.findings) {
      FindingRecord finding{stated.kernel == portable_id ? Name(kernel_.id) : stated.kernel,
                            stated.precision,
                            stated.family,
                            stated.kind,
                            stated.count.value,
                            stated.detail,
                            stated.address,
                            {}};
      const std::string what = fmt::format("its finding {} of {}", name(finding.kind), shown(finding.kernel));
      if (finding.family) {
        if (!finding.precision) refuse(what + " is in no precision");
        const auto found = counted.find({finding.kernel, *finding.precision, *finding.family, finding.kind});
        if (found == counted.end() || finding.count != found->second)
          refuse(fmt::format("{} is counted {} times, and {} in its stretches", what, finding.count,
                             found == counted.end() ? 0 : found->second));
        counted.erase(found);
      }
      record.findings.push_back(std::move(finding));
    }
    for (const auto& [key, count] : counted)
      refuse(fmt::format("its stretches have the finding {} of {}, which it does not name",
                         name(std::get<FindingKind>(key)), std::get<0>(key)));
  }

  const std::string& name_;
  const KernelStatement& kernel_;
  const MaterialsStatement& materials_;
  const PlanRecord plan_;
  const Predicate& predicate_;
  const Stretches stretches_;
};

}  // namespace

std::vector<KernelMaterial> kernels_of_record(const Record& record) {
  std::vector<KernelMaterial> kernels;
  for (const KernelRecord& kernel : record.kernels) {
    KernelRecord said = kernel;
    said.families = {};
    said.slack.reset();  // the diagnosis states them
    said.window.reset();
    if (said.id == record.plan.kernels.front()) said.id = portable_id;
    KernelMaterial& entry = kernels.emplace_back(read_as<KernelMaterial>(without_fractions(json_of(said))));
    for (const auto& [family, result] : kernel.families) {
      FamilyMaterial& beside = entry.families.put(family);
      beside.base_triangles = result.base_triangles;
      if (result.invariance) beside.invariance.emplace().json = without_fractions(json_of(*result.invariance));
      if (result.asymmetry && result.asymmetry->numbers)
        beside.image_numbers.emplace().json = without_fractions(json_of(*result.asymmetry->numbers));
    }
  }
  return kernels;
}

std::vector<FindingMaterial> findings_of_record(const Record& record) {
  std::vector<FindingMaterial> findings;
  for (const FindingRecord& finding : record.findings) {
    const bool is_its = finding.kernel == record.plan.kernels.front();
    findings.push_back({is_its ? portable_id : std::string(finding.kernel),
                        finding.precision,
                        finding.family,
                        finding.kind,
                        {finding.count},
                        finding.detail,
                        finding.address});
  }
  return findings;
}

Stretches stretches_of(const CertificatePredicate& predicate, const std::string& name) {
  return Reducer(predicate, name).stretches();
}

void require_usual_stretches(const CertificatePredicate& predicate, const std::string& name) {
  Reducer(predicate, name).require_usual_stretches();
}

Record reduced_record(const CertificatePredicate& predicate, const std::string& name) {
  return Reducer(predicate, name).record();
}

}  // namespace axiscert
