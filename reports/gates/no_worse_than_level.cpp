// no-worse-than=KERNEL: on no family more wrong verdicts than another kernel of the run, beyond what chance explains.
#include <fmt/format.h>

#include <algorithm>

#include "fuzz/record/proportions.h"
#include "kernel/base/error.h"
#include "reports/comparison/compare.h"
#include "reports/gates/level.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// A count of this kernel beside the other's on the same queries.
struct Pair {
  Cell mine, others;
  double p;
};

FlipKind kind_of(const Cell& cell) {
  return cell.member == name(FlipKind::false_separation) ? FlipKind::false_separation : FlipKind::false_contact;
}

// The other kernel's cell of the same precision, family and name; null where it was not run there.
const Cell* counterpart(const std::vector<Cell>& cells, const Cell& mine, const std::string& other) {
  for (const Cell& cell : cells) {
    const bool is_it = cell.kernel == other && cell.precision == mine.precision && cell.family == mine.family &&
                       cell.name() == mine.name();
    if (is_it) return &cell;
  }
  return nullptr;
}

std::string rate_text(const Cell& cell) {
  return fmt::format("{} of {}", thousands(cell.of.failures), thousands(cell.of.trials));
}

double rate_of(const Cell& cell) {
  return static_cast<double>(cell.of.failures) / static_cast<double>(std::max<std::uint64_t>(cell.of.trials, 1));
}

LevelFindings judge_no_worse_than(const AskedLevel& asked, const Subject& subject) {
  LevelFindings found;
  const KernelRecord& own = subject.kernel();
  const std::string &other = asked.argument, precision(name(own.precision));
  const std::vector<Cell> cells = cells_of(subject.record());
  std::vector<Pair> pairs;
  std::vector<double> p;
  for (const Cell& cell : cells) {
    const bool is_mine = cell.kernel == own.id && cell.precision == precision && cell.place == "verdict";
    // A level that is about some families judges those alone.
    if (!is_mine || !subject.families().contains(cell.family) ||
        (cell.member != "false_separation" && cell.member != "false_contact"))
      continue;
    const Cell* theirs = counterpart(cells, cell, other);
    if (theirs == nullptr) {
      found.not_checked = fmt::format("{} was not run on {} in {}", other, cell.family, precision);
      return found;
    }
    const auto [x, y] = independent(cell, *theirs);
    pairs.push_back({cell, *theirs, fisher_two_sided(x, y)});
    p.push_back(pairs.back().p);
  }
  for (const KernelRecord& entry : subject.record().kernels) {
    if (entry.id != other || entry.precision != own.precision) continue;
    for (const auto& [family, result] : subject.families()) {
      const std::uint64_t mine = subject.evidence(result).promised(),
                          theirs = evidence_of(entry, entry.families.at(family)).promised();
      if (mine == theirs) continue;
      found.not_checked = fmt::format("on {} it promises {} queries, and {} {}: the counts are of other queries",
                                      family, thousands(mine), other, thousands(theirs));
      return found;
    }
  }
  for (const auto& [mine, others, alone] : pairs) {
    const FlipKind kind = kind_of(mine);
    if (others.looked_at != 0 || subject.evidence(subject.families().at(mine.family)).promised_for(kind) == 0) continue;
    found.not_checked = fmt::format("{} decided none of the {} of {}, so there is no rate to compare with", other,
                                    kind == FlipKind::false_separation ? "contacts" : "separations", mine.family);
    return found;
  }
  const std::vector<double> corrected = holm(p);
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    const auto& [mine, others, alone] = pairs[i];
    if (corrected[i] > family_wise_error || rate_of(mine) <= rate_of(others)) continue;
    const FlipKind kind = kind_of(mine);
    subject.add(found.failures, mine.family, mine.of.failures,
                fmt::format("{} contacts, {}, more than {} with {} (p = {:.2g} after Holm's correction)",
                            kind == FlipKind::false_separation ? "missed" : "phantom", rate_text(mine), other,
                            rate_text(others), corrected[i]),
                [kind](const FlipRecord& flip) { return flip.kind == kind; });
  }
  for (const auto& [family, result] : subject.families()) found.families[family] = subject.whole_look(result);
  found.covers = fmt::format(
      "missed and phantom contacts of {}, each count beside that of {} on the same queries, by Fisher's exact test "
      "with "
      "Holm's correction over {} counts at 5 %",
      subject.list_of_families(), other, pairs.size());
  found.leaves_out = "depths, and differences that chance explains";
  return found;
}

}  // namespace

extern const GateLevel no_worse_than_level = {
    .usage = "no-worse-than=KERNEL",
    .meaning = "on no family more wrong verdicts than that kernel of the run",
    .sentence =
        [](const AskedLevel& asked) {
          if (asked.argument.empty())
            throw Error(fmt::format(
                "requirement '{}': it is written no-worse-than=KERNEL, KERNEL as it is given to --kernel", asked.text));
          return fmt::format("on no family more missed or phantom contacts than {}, beyond what chance explains",
                             asked.argument);
        },
    .judge = judge_no_worse_than,
    .yardstick = [](const AskedLevel& asked) { return asked.argument; },
    .in_certificates = {}};

}  // namespace axiscert
