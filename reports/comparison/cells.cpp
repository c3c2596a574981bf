#include "reports/comparison/cells.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "kernel/finding.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/plan_queries.h"

namespace axiscert {
namespace {

constexpr std::string_view verdict_counts[] = {"false_separation", "false_contact", "undecided", "invalid",
                                               "unanswered"};
constexpr std::string_view verdict_maxima[] = {"deepest_false_separation", "deepest_false_contact"};
constexpr std::string_view comparison_counts[] = {"false_separation", "missed_separation", "tolerance_failures"};

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
    if (result["comparisons"].is_null()) return;
    for (const auto& [comparison, tally] : result["comparisons"].items()) {
      for (const std::string_view member : comparison_counts) {
        if (!tally[member].is_null()) add_count(comparison, member, tally[member], valid, bases);
      }
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

}  // namespace

std::vector<std::string_view> members_of(std::string_view place) {
  if (place == "finding") return {finding_kind_names.begin(), finding_kind_names.end()};
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

std::vector<const Json*> witnesses_of(const Json& record, const Cell& cell) {
  std::vector<const Json*> found;
  for (const Json& witness : record["witnesses"]) {
    if (witness["kernel"] != cell.kernel || witness["precision"] != cell.precision || witness["family"] != cell.family)
      continue;
    const bool shows = std::any_of(witness["flips"].begin(), witness["flips"].end(), [&](const Json& flip) {
      return flip["name"] == cell.place &&
             (cell.member == "deepest_" + flip["kind"].get<std::string>() || flip["kind"] == cell.member);
    });
    if (shows) found.push_back(&witness);
  }
  return found;
}

}  // namespace axiscert
