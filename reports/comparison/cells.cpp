#include "reports/comparison/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <limits>

#include "kernel/finding.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/plan_queries.h"

namespace axiscert {
namespace {

constexpr std::string_view verdict_counts[] = {"false_separation", "false_contact", "undecided", "invalid",
                                               "unanswered"};
constexpr std::string_view verdict_maxima[] = {"deepest_false_separation", "deepest_false_contact"};
constexpr std::string_view comparison_counts[] = {"false_separation", "missed_separation", "tolerance_failures"};

// Those of first contacts, by place. Where a time is late, its tunnel goes with it.
constexpr std::string_view time_counts[] = {"late", "early", "none", "invalid", "through"};
constexpr std::string_view missed_counts[] = {"through"};
constexpr std::string_view feature_counts[] = {"wrong"};
constexpr std::string_view contact_maxima[] = {"deepest_tunnel"};
constexpr std::string_view time_errors[] = {"latest_u", "earliest_u"};

std::uint64_t count_of(const Json& count) { return count.get<std::uint64_t>(); }

class Collector {
 public:
  Collector(std::vector<Cell>& cells, const Json& record) : cells_(cells), identities_(identities_of(record)) {}

  void add_family(const Json& kernel, const std::string& family, const Json& result) {
    kernel_ = kernel["id"];
    precision_ = kernel["precision"];
    family_ = family;
    const Json &verdict = result["verdict"], &outside = verdict["outside_limits"];
    const std::uint64_t valid = count_of(result["trials"]) - count_of(result["truth"]["invalid"]);
    const std::uint64_t within = valid - (outside.is_null() ? 0 : count_of(outside["trials"]));
    const std::uint64_t bases = count_of(result["base_triangles"]);
    for (const std::string_view member : verdict_counts) add_count("verdict", member, verdict[member], within, bases);
    for (const std::string_view member : verdict_maxima) {
      add("verdict", member, Cell::Kind::maximum).figure = verdict[member];
    }
    if (const auto motion = result.find("motion"); motion != result.end()) add_contacts(*motion, within, bases);
    if (result["comparisons"].is_null()) return;
    for (const auto& [comparison, tally] : result["comparisons"].items()) {
      for (const std::string_view member : comparison_counts) {
        if (!tally[member].is_null()) add_count(comparison, member, tally[member], within, bases);
      }
      // Null where no sides were measured.
      if (!tally["max_error_u"].is_null())
        add(comparison, "max_error_u", Cell::Kind::maximum).figure = tally["max_error_u"];
    }
  }

  void add_finding(const Json& finding) {
    const auto text = [&](const char* member) {
      return finding[member].is_null() ? "" : finding[member].get<std::string>();
    };
    kernel_ = text("kernel");
    precision_ = text("precision");
    family_ = text("family");
    add("finding", text("kind"), Cell::Kind::finding).figure = finding["count"];
  }

 private:
  // The first contacts of one family; nothing for what the kernel does not give.
  void add_contacts(const Json& motion, std::uint64_t within, std::uint64_t bases) {
    const auto add_tunnels = [&](const std::string& place, const Json& tunnels, std::uint64_t among) {
      add_count(place, "through", tunnels["through"], among, bases);
      add(place, "deepest_tunnel", Cell::Kind::maximum).figure = number_of(tunnels["deepest_tunnel"]);
    };
    const std::uint64_t hits = count_of(motion["hits"]);
    add_tunnels("missed", motion["missed"], within);
    if (const Json& time = motion["time"]; !time.is_null()) {
      for (const char* member : {"late", "early", "none", "invalid"})
        add_count("time", member, time[member], hits, bases);
      add_tunnels("time", time["late_tunnels"], hits);
      add("time", "latest_u", Cell::Kind::maximum).figure = time["late_errors"]["largest_in_u"];
      add("time", "earliest_u", Cell::Kind::maximum).figure = time["early_errors"]["largest_in_u"];
    }
    if (const Json& feature = motion["feature"]; !feature.is_null())
      add_count("feature", "wrong", feature["wrong"], count_of(feature["judged"]), bases);
  }

  // A record has a number below the range of binary64 as text: its least number is told from zero as well.
  static Json number_of(const Json& tunnel) {
    return tunnel.is_string() ? Json(std::numeric_limits<double>::denorm_min()) : tunnel;
  }

  Cell& add(const std::string& place, std::string_view member, Cell::Kind kind) {
    return cells_.emplace_back(
        Cell{kernel_, precision_, family_, place, std::string(member), kind, 0, {}, 0, identity()});
  }
  void add_count(const std::string& place, std::string_view member, const Json& figure, std::uint64_t among,
                 std::uint64_t bases) {
    Cell& cell = add(place, member, Cell::Kind::count);
    cell.figure = figure;
    cell.of = {count_of(figure), std::max(among, count_of(figure))};
    cell.independent = std::min(bases, cell.of.trials);
  }

  // A record that was edited may hold a kernel that its plan does not.
  std::string identity() const {
    const auto known = identities_.find(kernel_);
    return known == identities_.end() ? kernel_ : known->second;
  }

  std::vector<Cell>& cells_;
  Identities identities_;
  std::string kernel_, precision_, family_;
};

bool shows_flip(const Json& witness, const Cell& cell) {
  return std::any_of(witness["flips"].begin(), witness["flips"].end(), [&](const Json& flip) {
    return flip["name"] == cell.place &&
           (cell.member == "deepest_" + flip["kind"].get<std::string>() || flip["kind"] == cell.member);
  });
}

// Whether a witness of a test of motions shows what a cell of first contacts counts.
bool shows_contact(const Json& witness, const Cell& cell) {
  const auto found = witness.find("measures");
  if (found == witness.end() || found->is_null()) return false;
  const Json &measures = *found, time = measures.value("time", Json());
  const bool is_missed = witness["computed"] != witness["truth"];
  if (cell.place == "feature") return measures.value("feature_is_right", Json()) == false;
  if (cell.member == "latest_u" || cell.member == "earliest_u")
    return time == (cell.member == "latest_u" ? "late" : "early");
  if (cell.member != "through" && cell.member != "deepest_tunnel") return time == cell.member;
  if (measures["tunnel"].is_null() || is_missed != (cell.place == "missed")) return false;
  return cell.member == "deepest_tunnel" || measures["tunnel"] == 1;
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
  if (place == "feature") return {std::begin(feature_counts), std::end(feature_counts)};
  if (place != "verdict") return {std::begin(comparison_counts), std::end(comparison_counts)};
  std::vector<std::string_view> all(std::begin(verdict_counts), std::end(verdict_counts));
  all.insert(all.end(), std::begin(verdict_maxima), std::end(verdict_maxima));
  return all;
}

std::vector<Cell> cells_of(const Json& record) {
  std::vector<Cell> cells;
  Collector collector(cells, record);
  for (const Json& finding : record["findings"]) collector.add_finding(finding);
  for (const Json& kernel : record["kernels"]) {
    for (const auto& [family, result] : kernel["families"].items()) collector.add_family(kernel, family, result);
  }
  return cells;
}

std::string fingerprint(const Json& key) { return short_sha256(key.dump()); }

std::string cell_text(const Json& key) {
  const auto part = [&](std::size_t i) { return key[i].get<std::string>(); };
  return fmt::format("{} {} on {}: {}", part(0), part(1), part(2), part(3));
}

WitnessesByCell::WitnessesByCell(const Json& record) {
  for (const Json& witness : record["witnesses"])
    by_place_[{witness["kernel"], witness["precision"], witness["family"]}].push_back(&witness);
}

std::vector<const Json*> WitnessesByCell::of(const Cell& cell) const {
  const auto place = by_place_.find({cell.kernel, cell.precision, cell.family});
  if (place == by_place_.end()) return {};
  std::vector<const Json*> found;
  std::ranges::copy_if(place->second, std::back_inserter(found), [&](const Json* witness) {
    return cell.is_of_contacts() ? shows_contact(*witness, cell) : shows_flip(*witness, cell);
  });
  return found;
}

}  // namespace axiscert
