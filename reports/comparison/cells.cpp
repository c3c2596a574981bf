#include "reports/comparison/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "fuzz/text/json_form.h"
#include "kernel/outcome.h"
#include "reports/run_folder/identity.h"
#include "reports/wording/evidence.h"

namespace axiscert {
namespace {

constexpr std::string_view verdict_counts[] = {"false_separation", "false_contact", "undecided", "invalid",
                                               "unanswered"};
constexpr std::string_view verdict_maxima[] = {"deepest_false_separation", "deepest_false_contact"};
constexpr std::string_view comparison_counts[] = {"false_separation", "missed_separation", "tolerance_failures",
                                                  "range_events"};

// What is told beside verdicts, by place. Where a time is late, its tunnel goes with it; errors in u are compared on
// the same queries, and not listed.
struct ContactMembers {
  std::string_view place;
  std::vector<std::string_view> members;
};
const std::vector<ContactMembers>& contact_members() {
  static const std::vector<ContactMembers> all = {
      {"time", {"late", "early", "none", "invalid", "through", "deepest_tunnel"}},
      {"missed", {"through", "deepest_tunnel"}},
      {"consistency", {"positive", "negative", "missing"}},
      {"separation", {"none", "largest_error"}},
      {"feature", {"wrong", "unnamed", "none", "largest_error"}},
      {"normal", {"none", "largest_angle", "largest_length_error"}},
      {"pushed", {"flips", "largest_left"}},
      {"point", {"none", "largest_error"}},
      {"point_a", {"none", "largest_error"}},
      {"point_b", {"none", "largest_error"}},
      {"points", {"largest_error"}}};
  return all;
}
constexpr std::string_view errors_in_u[] = {"latest_u", "earliest_u", "largest_in_u"};

class Collector {
 public:
  Collector(std::vector<Cell>& cells, const Record& record) : cells_(cells), identities_(identities_of(record)) {}

  void add_family(const KernelRecord& kernel, const std::string& family, const FamilyRecord& result) {
    kernel_ = kernel.id;
    precision_ = name(kernel.precision);
    family_ = family;
    bases_ = result.base_triangles;
    const VerdictTally& verdict = result.verdict;
    const Evidence evidence = evidence_of(kernel, result);
    const std::uint64_t contacts = evidence.decided_for(FlipKind::false_separation),
                        separations = evidence.decided_for(FlipKind::false_contact);
    among_ = evidence.population - evidence.outside;
    over(contacts).add_count("verdict", "false_separation", verdict.false_separation);
    over(separations).add_count("verdict", "false_contact", verdict.false_contact);
    over(evidence.decided()).add_count("verdict", "undecided", verdict.undecided);
    add_count("verdict", "invalid", verdict.invalid);
    add_count("verdict", "unanswered", verdict.unanswered);
    over(contacts).add_maximum("verdict", "deepest_false_separation", verdict.deepest_false_separation);
    over(separations).add_maximum("verdict", "deepest_false_contact", verdict.deepest_false_contact);
    if (result.contacts) over(contacts).add_contacts(*result.contacts);
    if (!result.comparisons) return;
    for (const auto& [comparison, tally] : *result.comparisons) {
      over(tally.judged).add_count(comparison, "false_separation", tally.false_separation);
      add_count(comparison, "missed_separation", tally.missed_separation);
      over(evidence.decided());
      if (tally.tolerance_failures) add_count(comparison, "tolerance_failures", *tally.tolerance_failures);
      if (tally.range_events) add_count(comparison, "range_events", *tally.range_events);
      if (tally.max_error) add_maximum(comparison, "max_error_u", *tally.max_error);
    }
  }

  void add_finding(const FindingRecord& finding) {
    kernel_ = finding.kernel;
    precision_ = finding.precision ? name(*finding.precision) : "";
    family_ = finding.family.value_or("");
    over(0).add("finding", name(finding.kind), Cell::Kind::finding).figure = finding.count;
  }

 private:
  // The figures that follow could have been raised by so many answers.
  Collector& over(std::uint64_t looked_at) {
    looked_at_ = looked_at;
    return *this;
  }

  // What is told beside the verdicts of one family; nothing for what the kernel does not give.
  void add_contacts(const ContactTally& contacts) {
    const auto add_tunnels = [&](const char* place, const TunnelTally& tunnels) {
      add_count(place, "through", tunnels.through);
      add_maximum(place, "deepest_tunnel", tunnels.deepest);
    };
    if (contacts.missed) add_tunnels("missed", *contacts.missed);
    const std::uint64_t within = std::exchange(among_, contacts.answers);
    if (const auto& time = contacts.time) {
      over(time->judged()).add_count("time", "late", time->late);
      add_count("time", "early", time->early);
      over(contacts.answers).add_count("time", "none", time->none);
      add_count("time", "invalid", time->invalid);
      over(time->judged());
      add_tunnels("time", time->late_tunnels);
      add_maximum("time", "latest_u", time->late_errors.largest_in_u);
      add_maximum("time", "earliest_u", time->early_errors.largest_in_u);
    }
    if (const auto& consistency = contacts.consistency) {
      over(consistency->contacts).add_count("consistency", "positive", consistency->positive);
      over(consistency->separations).add_count("consistency", "negative", consistency->negative);
      over(contacts.answers).add_count("consistency", "missing", consistency->missing);
    }
    if (const auto& separation = contacts.separation) {
      over(contacts.answers).add_count("separation", "none", separation->none);
      over(separation->judged).add_maximum("separation", "largest_error", separation->largest_error);
      add_maximum("separation", "largest_in_u", separation->largest_in_u);
    }
    if (const auto& feature = contacts.feature) {
      among_ = feature->judged;
      over(feature->judged).add_count("feature", "wrong", feature->wrong);
      add_count("feature", "unnamed", feature->unnamed);
      among_ = contacts.answers;
      over(contacts.answers).add_count("feature", "none", feature->none);
      over(feature->judged).add_maximum("feature", "largest_error", feature->largest_error);
    }
    if (const auto& normal = contacts.normal) {
      over(contacts.answers).add_count("normal", "none", normal->none);
      over(normal->judged).add_maximum("normal", "largest_angle", normal->largest_angle);
      over(normal->lengths).add_maximum("normal", "largest_length_error", normal->largest_length_error);
    }
    if (const auto& pushed = contacts.pushed) {
      among_ = pushed->judged;
      over(pushed->with_a_side()).add_count("pushed", "flips", pushed->flips);
      among_ = contacts.answers;
      over(pushed->judged).add_maximum("pushed", "largest_left", pushed->largest_left);
    }
    const auto add_point = [&](const char* place, const std::optional<PointTally>& point) {
      if (!point) return;
      over(contacts.answers).add_count(place, "none", point->none);
      over(point->judged).add_maximum(place, "largest_error", point->largest_error);
    };
    add_point("point", contacts.point);
    add_point("point_a", contacts.point_a);
    add_point("point_b", contacts.point_b);
    if (const auto& points = contacts.points)
      over(points->judged).add_maximum("points", "largest_error", points->largest_error);
    among_ = within;
  }

  Cell& add(const std::string& place, std::string_view member, Cell::Kind kind) {
    return cells_.emplace_back(
        Cell{kernel_, precision_, family_, place, std::string(member), kind, 0, {}, 0, looked_at_, identity()});
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
  std::uint64_t looked_at_ = 0;
};

bool shows_flip(const WitnessRecord& witness, const Cell& cell) {
  return std::ranges::any_of(witness.flips, [&](const FlipRecord& flip) {
    const std::string_view kind = name(flip.kind);
    return flip.name == cell.place && (cell.member == kind || cell.member == fmt::format("deepest_{}", kind));
  });
}

// Whether a witness shows what a cell of contacts counts.
bool shows_contact(const WitnessRecord& witness, const Cell& cell) {
  if (!witness.measures || !*witness.measures) return false;
  const MeasuresRecord& measures = **witness.measures;
  const std::optional<TimeVerdict> time = measures.time.value_or(std::nullopt);
  const auto is_figure = [&](const auto& error) { return error && *error && json_of(**error) == cell.figure; };
  if (cell.place == "consistency") {
    const std::optional<Consistency> found = measures.consistency.value_or(std::nullopt);
    return found && name(*found) == cell.member;
  }
  if (cell.place == "separation") return is_figure(measures.separation_error) || is_figure(measures.separation_u);
  if (cell.place == "pushed")
    return cell.member == "flips" ? measures.is_flip.value_or(std::nullopt) == true : is_figure(measures.left);
  if (cell.place == "normal")
    return is_figure(cell.member == "largest_angle" ? measures.normal_angle : measures.normal_length_error);
  if (cell.place == "point") return is_figure(measures.point_error);
  if (cell.place == "point_a") return is_figure(measures.point_a_error);
  if (cell.place == "point_b") return is_figure(measures.point_b_error);
  if (cell.place == "points") return is_figure(measures.points_apart);
  if (cell.place == "feature" && cell.member == "largest_error") return is_figure(measures.feature_error);
  if (cell.place == "feature")
    return cell.member != "none" && measures.feature_is_right.value_or(std::nullopt) == false;
  if (cell.member == "latest_u") return time == TimeVerdict::late;
  if (cell.member == "earliest_u") return time == TimeVerdict::early;
  if (cell.member != "through" && cell.member != "deepest_tunnel") return time && name(*time) == cell.member;
  const std::optional<ErrorNumber> tunnel = measures.tunnel.value_or(std::nullopt);
  const bool is_missed = witness.computed != witness.truth;
  if (!tunnel || is_missed != (cell.place == "missed")) return false;
  return cell.member == "deepest_tunnel" || tunnel->value == 1;
}

}  // namespace

bool is_place_of_contacts(std::string_view place) {
  return std::ranges::any_of(contact_members(), [&](const ContactMembers& one) { return one.place == place; });
}

std::vector<std::string_view> places_of_contacts(const Predicate& predicate) {
  const ContactTally tally = given_contacts({}, predicate, predicate.measures.size());
  Json given = json_of(tally);
  put_unseen(given, tally);
  std::vector<std::string_view> places;
  for (const ContactMembers& one : contact_members()) {
    if (!predicate.measures.empty() && !given.at(std::string(one.place)).is_null()) places.push_back(one.place);
  }
  return places;
}

bool is_error_in_u(const Cell& cell) {
  const auto is_member = [&](std::string_view error) { return cell.member == error; };
  return cell.member == "max_error_u" || std::any_of(std::begin(errors_in_u), std::end(errors_in_u), is_member);
}

std::vector<std::string_view> members_of(std::string_view place) {
  if (place == "finding") return {finding_kind_names.begin(), finding_kind_names.end()};
  for (const ContactMembers& one : contact_members()) {
    if (one.place == place) return one.members;
  }
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

std::pair<Proportion, Proportion> independent(const Cell& x, const Cell& y) {
  const auto scaled = [](const Cell& cell, bool up) {
    const std::uint64_t n = cell.of.trials, m = cell.independent;
    if (m >= n) return cell.of;
    const auto product = static_cast<unsigned __int128>(cell.of.failures) * m;
    return Proportion{static_cast<std::uint64_t>((product + (up ? n - 1 : 0)) / n), m};
  };
  const auto cross = [](const Proportion& u, const Proportion& v) {
    return static_cast<unsigned __int128>(u.failures) * v.trials;
  };
  const bool x_is_lower = cross(x.of, y.of) < cross(y.of, x.of);
  std::pair both = {scaled(x, x_is_lower), scaled(y, !x_is_lower)};
  const auto left = cross(both.first, both.second), right = cross(both.second, both.first);
  if (x_is_lower ? left >= right : left <= right) both.second = both.first;  // scaling left no difference
  return both;
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
