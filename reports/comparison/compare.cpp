#include "reports/comparison/compare.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "kernel/base/error.h"
#include "reports/comparison/given_measures.h"
#include "reports/run_folder/identity.h"
#include "reports/run_folder/plan_queries.h"
#include "reports/wording/finding.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

Change direction(const Cell& before, const Cell& after, bool grew) {
  if (grew) return before.is_zero() ? Change::fresh : Change::worse;
  return after.is_zero() ? Change::fixed : Change::better;
}

class Comparer {
 public:
  Comparer(const Json& before, const Json& after)
      : before_(before), after_(after), identities_(identities_of(before, after)) {}

  RunComparison run(std::vector<Replayed> replayed) {
    list_kernels();
    std::map<Json, Cell> in_after;
    for (Cell& cell : cells_of(after_)) in_after.emplace(key(cell, false), std::move(cell));
    for (Cell& cell : cells_of(before_)) {
      const auto match = in_after.extract(key(cell, true));
      if (!match.empty()) add(std::move(cell), std::move(match.mapped()));
      else if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), false);
      else note_absent(cell, true, "is only in OLD");
    }
    // A record has a cell for a finding only where there was one.
    for (Cell& cell : cells_of(after_)) {
      if (in_after.count(key(cell, false)) == 0) continue;
      if (cell.kind == Cell::Kind::finding) add_finding(std::move(cell), true);
      else note_absent(cell, false, "is only in NEW");
    }
    correct();
    const WitnessesByCell witnesses(after_);
    for (ComparedCell& cell : result_.cells) {
      if (cell.is_compared()) {
        ++kernel_of(cell.before, true)->cells;
        compared_.emplace(cell.before.kernel, cell.before.precision);
      }
      if (!cell.is_alarm()) continue;
      for (const Json* witness : witnesses.of(cell.after)) cell.witnesses.push_back((*witness)["id"]);
    }
    say_what_is_unchecked();
    for (const auto& [what, why] : absent_) result_.not_compared.push_back({what, why});
    result_.replayed = std::move(replayed);
    return std::move(result_);
  }

 private:
  const std::string& identity(const std::string& id, bool is_before) const {
    const Identities& all = is_before ? identities_.first : identities_.second;
    const auto known = all.find(id);
    return known == all.end() ? id : known->second;
  }
  Json key(const Cell& cell, bool is_before) const { return cell.key_of(identity(cell.kernel, is_before)); }

  ComparedKernel* kernel_called(const std::string& name) {
    const auto found = std::find_if(result_.kernels.begin(), result_.kernels.end(),
                                    [&](const ComparedKernel& kernel) { return kernel.name == name; });
    return found == result_.kernels.end() ? nullptr : &*found;
  }
  // That of a cell; one that the plan does not name is added.
  ComparedKernel* kernel_of(const Cell& cell, bool is_before) {
    const std::string& name = identity(cell.kernel, is_before);
    if (ComparedKernel* known = kernel_called(name)) return known;
    ComparedKernel& added = result_.kernels.emplace_back();
    added.name = name;
    (is_before ? added.before : added.after) = cell.kernel;
    return &added;
  }

  void list_kernels() {
    for (const Json& id : before_["plan"]["kernels"])
      result_.kernels.push_back({identity(id, true), id, "", "", false, 0});
    for (const Json& id : after_["plan"]["kernels"]) {
      const std::string& name = identity(id, false);
      if (ComparedKernel* both = kernel_called(name)) both->after = id;
      else result_.kernels.push_back({name, "", id, "", false, 0});
    }
    for (ComparedKernel& kernel : result_.kernels) {
      if (kernel.before.empty() || kernel.after.empty()) continue;
      const Json then = digest_of(before_, kernel.before), now = digest_of(after_, kernel.after);
      kernel.has_digests = !then.is_null() && !now.is_null();
      kernel.digest_change = digest_change(then, now);
    }
  }

  // Why the other record does not have a kernel, where more than its absence is to be said.
  std::string reason(const ComparedKernel& kernel) const {
    const bool is_before = !kernel.before.empty();
    const std::string& id = is_before ? kernel.before : kernel.after;
    const Json &own = is_before ? before_ : after_, &other = is_before ? after_ : before_;
    const char* const which = is_before ? "NEW" : "OLD";
    const auto is_id = [&](const Json& given) { return given == id; };
    const Json& ids = other["plan"]["kernels"];
    const std::string name = declared_name(own, id);
    if (std::any_of(ids.begin(), ids.end(), is_id)) {
      const std::string there = declared_name(other, id);
      if (there.empty()) return fmt::format("; in {} it could not be loaded", which);
      return fmt::format("; in {} it declares another name, '{}' and not '{}'", which, there, name);
    }
    if (id.find(':') != id.npos && (!has_names(before_) || !has_names(after_))) {
      return fmt::format("; {} is of a version that wrote no names, so kernels are known by their ids",
                         has_names(after_) ? "OLD" : "NEW");
    }
    for (const Json& given : ids) {
      if (!name.empty() && declared_name(other, given) == name)
        return fmt::format("; several kernels of one run declare the name '{}', so each is known by its id", name);
    }
    return "";
  }

  void say_what_is_unchecked() {
    const std::vector<std::string> unloaded = not_judged(after_), unloaded_before = not_judged(before_);
    const auto is_in = [](const std::vector<std::string>& all, const std::string& id) {
      return std::find(all.begin(), all.end(), id) != all.end();
    };
    const auto say = [&](const std::string& who, const std::string& why) {
      result_.unchecked.push_back(fmt::format("{}: {}", who, why));
      absent_[who] = why;
    };
    if (result_.compared() == 0) {
      result_.unchecked.emplace_back(
          "nothing was compared: the two runs have no kernel, precision and family with valid "
          "queries in common");
    }
    for (const ComparedKernel& kernel : result_.kernels) {
      if (!kernel.after.empty() && is_in(unloaded, kernel.after)) {
        say(kernel.after, "could not be loaded in NEW, so it was not judged");
      } else if (kernel.before.empty()) {
        absent_[kernel.after] = "is only in NEW" + reason(kernel);
      } else if (kernel.after.empty()) {
        say(kernel.before, "is only in OLD" + reason(kernel));
      } else if (kernel.cells == 0) {
        say(kernel.before, is_in(unloaded_before, kernel.before)
                               ? "could not be loaded in OLD"
                               : "has no precision and family with valid queries in both runs");
      } else {
        say_given_by_one(before_, after_, kernel, result_);
        for (const Json& precision : precisions_of(before_, kernel.before)) {
          if (compared_.contains({kernel.before, precision})) continue;
          say(fmt::format("{} {}", kernel.before, precision.get<std::string>()),
              has_precision(after_, kernel.after, precision) ? "has no family with valid queries in both runs"
                                                             : "is only in OLD");
        }
        for (const Json& precision : precisions_of(after_, kernel.after)) {
          if (!has_precision(before_, kernel.before, precision))
            absent_[fmt::format("{} {}", kernel.after, precision.get<std::string>())] = "is only in NEW";
        }
      }
    }
  }

  static std::vector<Json> precisions_of(const Json& record, const std::string& id) {
    std::vector<Json> precisions;
    for (const Json& kernel : record["kernels"]) {
      if (kernel["id"] == id) precisions.push_back(kernel["precision"]);
    }
    return precisions;
  }
  static bool has_precision(const Json& record, const std::string& id, const Json& precision) {
    const std::vector<Json> all = precisions_of(record, id);
    return std::find(all.begin(), all.end(), precision) != all.end();
  }

  // Reports a missing family once, not once for each cell; a missing kernel, or one of its precisions, is reported as
  // one. A family's verdict comes first.
  void note_absent(const Cell& cell, bool is_before, const std::string& why) {
    const ComparedKernel& kernel = *kernel_of(cell, is_before);
    if (kernel.before.empty() || kernel.after.empty()) return;
    if (!has_precision(is_before ? after_ : before_, is_before ? kernel.after : kernel.before, cell.precision)) return;
    const std::string family = fmt::format("{} {} on {}", cell.kernel, cell.precision, cell.family);
    if (cell.place == "verdict" || cell.kind == Cell::Kind::finding) absent_.emplace(family, why);
    else if (cell.is_of_contacts()) absent_.emplace(family + ": first contacts", why);
    else if (cell.member == "tolerance_failures") absent_.emplace(family + ": " + cell.name(), why);
    else if (absent_.count(family) == 0) absent_.emplace(family + ": comparisons", why);
  }

  void add_finding(Cell cell, bool is_new) {
    // Chance cannot explain a finding. A kernel that NEW did not run at all has not been mended.
    if (!is_new && kernel_of(cell, true)->after.empty()) return;
    Cell none = cell;
    none.figure = 0;
    ComparedCell compared{is_new ? none : cell, is_new ? cell : none};
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
      return note_absent(before, true, "was counted with a different tolerance");
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
  std::pair<Identities, Identities> identities_;
  std::set<std::pair<std::string, std::string>> compared_;  // OLD's ids, and precisions
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

std::size_t RunComparison::compared() const {
  return static_cast<std::size_t>(
      std::count_if(cells.begin(), cells.end(), [](const ComparedCell& cell) { return cell.is_compared(); }));
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
