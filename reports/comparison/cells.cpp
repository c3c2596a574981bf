#include "reports/comparison/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "kernel/outcome.h"
#include "reports/run_folder/identity.h"

namespace axiscert {
namespace {

constexpr std::string_view verdict_counts[] = {"false_separation", "false_contact", "undecided", "invalid",
                                               "unanswered"};
constexpr std::string_view verdict_maxima[] = {"deepest_false_separation", "deepest_false_contact"};
constexpr std::string_view comparison_counts[] = {"false_separation", "missed_separation", "tolerance_failures"};

// Those of first contacts, by place. Where a time is late, its tunnel goes with it.
constexpr std::string_view time_counts[] = {"late", "early", "none", "invalid", "through"};
constexpr std::string_view missed_counts[] = {"through"};
constexpr std::string_view feature_members[] = {"wrong", "unnamed", "none", "largest_error"};
constexpr std::string_view normal_members[] = {"none", "largest_angle", "largest_length_error"};
constexpr std::string_view point_members[] = {"none", "largest_error"};
constexpr std::string_view contact_maxima[] = {"deepest_tunnel"};
constexpr std::string_view time_errors[] = {"latest_u", "earliest_u"};

class Collector {
 public:
  Collector(std::vector<Cell>& cells, const Record& record) : cells_(cells), identities_(identities_of(record)) {}

  void add_family(const KernelRecord& kernel, const std::string& family, const FamilyRecord& result) {
    kernel_ = kernel.id;
    precision_ = name(kernel.precision);
    family_ = family;
    bases_ = result.base_triangles;
    const VerdictTally& verdict = result.verdict;
    const std::uint64_t outside = verdict.outside_limits ? verdict.outside_limits->trials : 0;
    among_ = result.trials - result.truth.invalid - outside;
    add_count("verdict", "false_separation", verdict.false_separation);
    add_count("verdict", "false_contact", verdict.false_contact);
    add_count("verdict", "undecided", verdict.undecided);
    add_count("verdict", "invalid", verdict.invalid);
    add_count("verdict", "unanswered", verdict.unanswered);
    add_maximum("verdict", "deepest_false_separation", verdict.deepest_false_separation);
    add_maximum("verdict", "deepest_false_contact", verdict.deepest_false_contact);
    if (result.motion) add_contacts(*result.motion);
    if (!result.comparisons) return;
    for (const auto& [comparison, tally] : *result.comparisons) {
      add_count(comparison, "false_separation", tally.false_separation);
      add_count(comparison, "missed_separation", tally.missed_separation);
      if (tally.tolerance_failures) add_count(comparison, "tolerance_failures", *tally.tolerance_failures);
      if (tally.max_error) add_maximum(comparison, "max_error_u", *tally.max_error);
    }
  }

  void add_finding(const FindingRecord& finding) {
    kernel_ = finding.kernel;
    precision_ = finding.precision ? name(*finding.precision) : "";
    family_ = finding.family.value_or("");
    add("finding", name(finding.kind), Cell::Kind::finding).figure = finding.count;
  }

 private:
  // The first contacts of one family; nothing for what the kernel does not give.
  void add_contacts(const MotionTally& motion) {
    const auto add_tunnels = [&](const char* place, const TunnelTally& tunnels) {
      add_count(place, "through", tunnels.through);
      add_maximum(place, "deepest_tunnel", tunnels.deepest);
    };
    add_tunnels("missed", motion.missed);
    const std::uint64_t within = std::exchange(among_, motion.hits);
    if (const auto& time = motion.time) {
      add_count("time", "late", time->late);
      add_count("time", "early", time->early);
      add_count("time", "none", time->none);
      add_count("time", "invalid", time->invalid);
      add_tunnels("time", time->late_tunnels);
      add_maximum("time", "latest_u", time->late_errors.largest_in_u);
      add_maximum("time", "earliest_u", time->early_errors.largest_in_u);
    }
    if (const auto& feature = motion.feature) {
      among_ = feature->judged;
      add_count("feature", "wrong", feature->wrong);
      add_count("feature", "unnamed", feature->unnamed);
      among_ = motion.hits;
      add_count("feature", "none", feature->none);
      add_maximum("feature", "largest_error", feature->largest_error);
    }
    if (const auto& normal = motion.normal) {
      add_count("normal", "none", normal->none);
      add_maximum("normal", "largest_angle", normal->largest_angle);
      add_maximum("normal", "largest_length_error", normal->largest_length_error);
    }
    if (const auto& point = motion.point) {
      add_count("point", "none", point->none);
      add_maximum("point", "largest_error", point->largest_error);
    }
    among_ = within;
  }

  Cell& add(const std::string& place, std::string_view member, Cell::Kind kind) {
    return cells_.emplace_back(
        Cell{kernel_, precision_, family_, place, std::string(member), kind, 0, {}, 0, identity()});
  }
  void add_count(const std::string& place, std::string_view member, std::uint64_t figure) {
    Cell& cell = add(place, member, Cell::Kind::count);
    cell.figure = figure;
    cell.of = {figure, std::max(among_, figure)};
    cell.independent = std::min(bases_, cell.of.trials);
  }
  void add_maximum(const std::string& place, std::string_view member, const auto& figure) {
    add(place, member, Cell::Kind::maximum).figure = json_of(figure);
  }

  // A record that was edited may hold a kernel that its plan does not.
  std::string identity() const {
    const auto known = identities_.find(kernel_);
    return known == identities_.end() ? kernel_ : known->second;
  }

  std::vector<Cell>& cells_;
  Identities identities_;
  std::string kernel_, precision_, family_;
  std::uint64_t among_ = 0, bases_ = 0;  // queries among which is counted, and those that do not share a triangle
};

bool shows_flip(const WitnessRecord& witness, const Cell& cell) {
  return std::ranges::any_of(witness.flips, [&](const FlipRecord& flip) {
    const std::string_view kind = name(flip.kind);
    return flip.name == cell.place && (cell.member == kind || cell.member == fmt::format("deepest_{}", kind));
  });
}

// Whether a witness of a predicate of motions shows what a cell of first contacts counts.
bool shows_contact(const WitnessRecord& witness, const Cell& cell) {
  if (!witness.measures || !*witness.measures) return false;
  const MeasuresRecord& measures = **witness.measures;
  const std::optional<TimeVerdict> time = measures.time.value_or(std::nullopt);
  const auto is_figure = [&](const std::optional<std::optional<double>>& error) {
    return error && *error && json_of(**error) == cell.figure;
  };
  if (cell.place == "normal")
    return is_figure(cell.member == "largest_angle" ? measures.normal_angle : measures.normal_length_error);
  if (cell.place == "point") return is_figure(measures.point_error);
  if (cell.member == "largest_error") return is_figure(measures.feature_error);
  if (cell.place == "feature")
    return cell.member != "none" && measures.feature_is_right.value_or(std::nullopt) == false;
  if (cell.member == "latest_u") return time == TimeVerdict::late;
  if (cell.member == "earliest_u") return time == TimeVerdict::early;
  if (cell.member != "through" && cell.member != "deepest_tunnel") return time && name(*time) == cell.member;
  const bool is_missed = witness.computed != witness.truth;
  if (!measures.tunnel || is_missed != (cell.place == "missed")) return false;
  return cell.member == "deepest_tunnel" || measures.tunnel->value == 1;
}

}  // namespace

bool is_place_of_contacts(std::string_view place) {
  return std::find(std::begin(places_of_contacts), std::end(places_of_contacts), place) != std::end(places_of_contacts);
}

bool is_error_in_u(const Cell& cell) {
  const auto is_member = [&](std::string_view error) { return cell.member == error; };
  return cell.member == "max_error_u" || std::any_of(std::begin(time_errors), std::end(time_errors), is_member);
}

std::vector<std::string_view> members_of(std::string_view place) {
  if (place == "finding") return {finding_kind_names.begin(), finding_kind_names.end()};
  const auto with_tunnels = [](const auto& counts) {
    std::vector<std::string_view> all(std::begin(counts), std::end(counts));
    all.insert(all.end(), std::begin(contact_maxima), std::end(contact_maxima));
    return all;
  };
  if (place == "time") return with_tunnels(time_counts);
  if (place == "missed") return with_tunnels(missed_counts);
  if (place == "feature") return {std::begin(feature_members), std::end(feature_members)};
  if (place == "normal") return {std::begin(normal_members), std::end(normal_members)};
  if (place == "point") return {std::begin(point_members), std::end(point_members)};
  if (place != "verdict") return {std::begin(comparison_counts), std::end(comparison_counts)};
  std::vector<std::string_view> all(std::begin(verdict_counts), std::end(verdict_counts));
  all.insert(all.end(), std::begin(verdict_maxima), std::end(verdict_maxima));
  return all;
}

std::vector<Cell> cells_of(const Record& record) {
  std::vector<Cell> cells;
  Collector collector(cells, record);
  for (const FindingRecord& finding : record.findings) collector.add_finding(finding);
  for (const KernelRecord& kernel : record.kernels) {
    for (const auto& [family, result] : kernel.families) collector.add_family(kernel, family, result);
  }
  return cells;
}

std::string fingerprint(const Json& key) { return short_sha256(key.dump()); }

std::string cell_text(const Json& key) {
  const auto part = [&](std::size_t i) { return key[i].get<std::string>(); };
  return fmt::format("{} {} on {}: {}", part(0), part(1), part(2), part(3));
}

WitnessesByCell::WitnessesByCell(const Record& record) {
  for (const WitnessRecord& witness : record.witnesses)
    by_place_[{witness.kernel, std::string(name(witness.precision)), witness.family}].push_back(&witness);
}

std::vector<const WitnessRecord*> WitnessesByCell::of(const Cell& cell) const {
  const auto place = by_place_.find({cell.kernel, cell.precision, cell.family});
  if (place == by_place_.end()) return {};
  std::vector<const WitnessRecord*> found;
  std::ranges::copy_if(place->second, std::back_inserter(found), [&](const WitnessRecord* witness) {
    return cell.is_of_contacts() ? shows_contact(*witness, cell) : shows_flip(*witness, cell);
  });
  return found;
}

}  // namespace axiscert
