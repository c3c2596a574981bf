#include "reports/comparison/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "kernel/base/error.h"
#include "reports/run_folder/plan_queries.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

Change direction(const Cell& before, const Cell& after, bool grew) {
  if (grew) return before.is_zero() ? Change::fresh : Change::worse;
  return after.is_zero() ? Change::fixed : Change::better;
}

class Comparer {
 public:
  Comparer(const Json& before, const Json& after) : before_(before), after_(after) {}

  RunComparison run(std::vector<Replayed> replayed) {
    std::map<Json, Cell> in_after;
    for (Cell& cell : cells_of(after_)) in_after.emplace(cell.key(), std::move(cell));
    for (Cell& cell : cells_of(before_)) {
      const auto match = in_after.extract(cell.key());
      if (!match.empty()) add(std::move(cell), std::move(match.mapped()));
      else if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), false);
      else note_absent(cell, "is only in OLD");
    }
    // A record has a cell for a finding only where there was one.
    for (Cell& cell : cells_of(after_)) {
      if (in_after.count(cell.key()) == 0) continue;
      if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), true);
      else note_absent(cell, "is only in NEW");
    }
    correct();
    for (ComparedCell& cell : result_.cells) {
      if (!cell.is_alarm()) continue;
      for (const Json* witness : witnesses_of(after_, cell.after)) cell.witnesses.push_back((*witness)["id"]);
    }
    for (const auto& [what, why] : absent_) result_.not_compared.push_back({what, why});
    result_.replayed = std::move(replayed);
    return std::move(result_);
  }

 private:
  // Reports a missing kernel or family once, not once for each cell. A family's verdict comes first.
  void note_absent(const Cell& cell, const std::string& why) {
    const std::string family = fmt::format("{} {} on {}", cell.kernel, cell.precision, cell.family);
    if (cell.place == "verdict" || cell.kind == Cell::Kind::finding) absent_.emplace(family, why);
    else if (cell.member == "tolerance_failures") absent_.emplace(family + ": " + cell.name(), why);
    else if (absent_.count(family) == 0) absent_.emplace(family + ": comparisons", why);
  }

  void add_finding(Cell cell, bool is_new) {
    Cell none = cell;
    none.figure = 0;
    ComparedCell compared{is_new ? none : cell, is_new ? cell : none};
    // Chance cannot explain a finding. A kernel that NEW did not run at all has not been mended.
    const auto has_kernel = [&](const Json& record) {
      const Json& kernels = record["plan"]["kernels"];
      return std::find(kernels.begin(), kernels.end(), cell.kernel) != kernels.end();
    };
    if (!is_new && !has_kernel(after_)) return note_absent(cell, "is only in OLD");
    compared.change = is_new ? Change::fresh : Change::fixed;
    result_.cells.push_back(std::move(compared));
  }

  bool has_same_queries(const Cell& cell) const {
    const Json mine = queries_of(before_["plan"], cell.family, cell.precision);
    return !mine.is_null() && mine == queries_of(after_["plan"], cell.family, cell.precision);
  }

  static Json tolerance_of(const Json& record, const Cell& cell) {
    const Json& tolerances = record["plan"]["tolerance"];
    return tolerances.contains(cell.place) ? tolerances[cell.place] : Json(nullptr);
  }

  void add(Cell before, Cell after) {
    if (before.member == "tolerance_failures" && tolerance_of(before_, before) != tolerance_of(after_, after)) {
      return note_absent(before, "was counted with a different tolerance");
    }
    ComparedCell compared{std::move(before), std::move(after)};
    compared.same_queries = has_same_queries(compared.before);
    const Cell &x = compared.before, &y = compared.after;
    if (x.kind == Cell::Kind::count && !compared.same_queries) {
      const auto [u, v] = independent(x, y);
      compared.p = fisher_two_sided(u, v);
    } else if (x.kind != Cell::Kind::finding && compared.same_queries && x.figure != y.figure) {
      const bool grew = x.kind == Cell::Kind::count ? x.count() < y.count() : is_less(x.figure, y.figure);
      compared.change = direction(x, y, grew);
    }
    result_.cells.push_back(std::move(compared));
  }

  void correct() {
    std::vector<double> p;
    for (const ComparedCell& cell : result_.cells) {
      if (cell.p) p.push_back(*cell.p);
    }
    result_.tested = p.size();
    const std::vector<double> corrected = holm(p);
    std::size_t next = 0;
    for (ComparedCell& cell : result_.cells) {
      if (!cell.p) continue;
      cell.p_corrected = corrected[next++];
      if (*cell.p_corrected > family_wise_error) continue;
      const auto rate = [](const Cell& of) {
        return static_cast<double>(of.of.failures) / static_cast<double>(of.of.trials);
      };
      cell.change = direction(cell.before, cell.after, rate(cell.before) < rate(cell.after));
    }
  }

  const Json &before_, &after_;
  RunComparison result_;
  std::map<std::string, std::string> absent_;
};

}  // namespace

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

std::size_t RunComparison::alarms() const {
  const auto is_alarm = [](const auto& item) { return item.is_alarm(); };
  return static_cast<std::size_t>(std::count_if(cells.begin(), cells.end(), is_alarm) +
                                  std::count_if(replayed.begin(), replayed.end(), is_alarm));
}

std::size_t RunComparison::count(Change change) const {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [&](const ComparedCell& cell) { return cell.change == change; }));
}

void require_same_test(const Json& before, const Json& after, const std::string& before_name,
                       const std::string& after_name) {
  const Json &old_test = before["plan"]["test"], &new_test = after["plan"]["test"];
  if (old_test == new_test) return;
  throw Error(fmt::format("{} is of the test {}, and {} of {}; only runs of one test can be compared", before_name,
                          old_test.get<std::string>(), after_name, new_test.get<std::string>()));
}

RunComparison compare_records(const Json& before, const Json& after, std::vector<Replayed> replayed) {
  require_same_test(before, after, "OLD", "NEW");
  return Comparer(before, after).run(std::move(replayed));
}

}  // namespace axiscert
