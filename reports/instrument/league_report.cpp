#include "reports/instrument/league_report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "fuzz/text/json_form.h"
#include "reports/instrument/figures.h"
#include "reports/wording/everyday.h"

namespace axiscert {
namespace {

std::uint64_t count_of(const Tally& tally, FindingKind kind) { return tally.findings[kind].count; }
std::uint64_t other_findings(const Tally& tally) {
  std::uint64_t all = 0;
  for (const FindingTally& finding : tally.findings) all += finding.count;
  return all - count_of(tally, FindingKind::crash) - count_of(tally, FindingKind::hang);
}

// The rate with three digits: 57, 1.31k, 999k.
std::string counts_per_million(std::uint64_t count, std::uint64_t of) {
  const double rate = 1e6 * static_cast<double>(count) / static_cast<double>(of);
  return rate < 999.5 ? fmt::format("{:.3g}", rate) : fmt::format("{:.3g}k", rate / 1000);
}

// The rates "missed/phantom" of the decided queries, "-" where none of these could be wrong so, followed by what else
// there was: d, n, u and o with the numbers of those that it declined, called `invalid`, did not answer, or that are
// outside its limits.
std::string family_cell(const Kernel& kernel, const Tally& tally) {
  const std::uint64_t of = decided(tally);
  const auto rate = [&](FlipKind kind, std::uint64_t count) {
    return decided_for(kind, kernel, tally) == 0 ? "-" : counts_per_million(count, of);
  };
  std::string cell = of == 0 ? "none decided"
                             : rate(FlipKind::false_separation, tally.verdict.false_separation) + "/" +
                                   rate(FlipKind::false_contact, tally.verdict.false_contact);
  const auto add = [&](char letter, std::uint64_t count) {
    if (count != 0) cell += fmt::format(" {}{}", letter, count);
  };
  add('d', tally.verdict.undecided);
  add('n', tally.verdict.invalid);
  add('u', tally.verdict.unanswered);
  add('o', tally.verdict.outside_limits->trials);
  return cell;
}

// Errors without their signs.
std::vector<double> sizes(std::vector<double> errors) {
  for (double& error : errors) error = std::abs(error);
  return errors;
}

struct Radii {
  std::string median = "not measured", largest = "not measured";
};
Radii radii(std::vector<double> errors, std::uint64_t unbounded) {
  if (errors.empty() && unbounded == 0) return {};
  std::sort(errors.begin(), errors.end());
  const std::size_t all = errors.size() + unbounded, middle = (all - 1) / 2;
  return {middle < errors.size() ? fmt::format("{:.3g}", errors[middle]) : "unbounded",
          unbounded == 0 ? fmt::format("{:.3g}", errors.back()) : "unbounded"};
}

class LeagueReport {
 public:
  LeagueReport(const League& league, const CampaignResult& result) : league_(league), result_(result) {}

  InstrumentReport report(const std::string& command) const {
    InstrumentReport report{"league", title(), command, notes(), {}, {}, data(command)};
    report.first = league_first(league_, result_);
    report.notes_heading = "What the words mean, and what was left out";
    report.are_notes_last = true;
    for (const Precision precision : league_.questions.precisions)
      report.tables.push_back(trust_table(league_, result_, precision));
    report.tables.push_back(worst_table(league_, result_));
    for (const Precision precision : league_.questions.precisions) {
      report.tables.push_back(by_family(precision));
      report.tables.push_back(overall(precision));
    }
    for (const Precision precision : league_.questions.precisions) {
      if (league_.contenders < league_.kernels.size()) report.tables.push_back(faults(precision));
    }
    report.add(findings());
    report.add(causes());
    return report;
  }

 private:
  std::string title() const {
    std::string text = "Kernels and libraries on the same queries";
    const std::vector<std::string> silent = undecided_contenders(league_, result_);
    return silent.empty() ? text : fmt::format("Nothing was looked at of {}. {}", fmt::join(silent, ", "), text);
  }

  std::vector<std::string> notes() const {
    std::vector<std::string> all = {
        fmt::format("May I trust it: of the queries of a kind that were decided, how many are wrong: contacts that are "
                    "missed, contacts that are invented. yes: none, of at least {} decided ones, among them half of "
                    "the contacts and of the separations. rarely: less than 1 in 1,000. too few: nothing is wrong, and "
                    "too little was decided. no: also where a valid query is called invalid, has no answer, or is "
                    "declined by a kernel that does not declare that it may. declines: it refuses to make the shape, "
                    "or says that it cannot decide.",
                    least_looked_at),
        "Thin is sliver, needle and ratio; small is subnormal and scale; "
        "degenerate is collinear and repeated; resting is tangent, on and tie; scene has the sizes of a game, in "
        "metres.",
        "By family: missed/phantom, the contacts that are missed and those that are invented, for a million decided "
        "queries; -: no contact, or no separation, was decided. Then numbers of queries: d: it declined. n: it called "
        "them `invalid`. u: no answer, since the "
        "library "
        "crashed or hung on them, or did so too often in their unit to be called again. o: outside its limits.",
        "Touching is judged by the convention that each declares; where it declares none, neither answer is wrong.",
        "Deepest: |d - r| / max(|A-P|, |B-P|, |C-P|, r) of a wrong verdict. Critical radius: for every 256th of a "
        "source's first 2^24 queries the smallest radius that is called a contact, its error in ulps of the exact "
        "distance. Time: verdicts alone on one core, median over repetitions of 2^17 distinct queries of family "
        "general, in the library's own process, without the cost of communicating with it.",
        "Zero wrong verdicts hold for these queries only: at most 3 in as many queries, at 95 %."};
    all.insert(all.end(), league_.not_checked.begin(), league_.not_checked.end());
    return all;
  }

  InstrumentTable causes() const {
    InstrumentTable table{"Why they are wrong", {"kernel", "precision", "why"}, {}};
    for (const auto& [of, cause] : league_.causes)
      table.rows.push_back({league_.kernels[of.second]->id, std::string(name(of.first)), cause.sentence()});
    return table;
  }

  // Puts the columns of families, which follow `first` others, under headings.
  void put_headings(InstrumentTable& table, std::size_t first) const {
    table.headings.assign(family_group_headings.begin(), family_group_headings.end());
    table.heading_of.assign(first, 0);
    for (const SourcePtr& source : league_.questions.sources)
      table.heading_of.push_back(1 + static_cast<std::size_t>(family_group(source->name())));
  }

  template <class Visit>
  void for_each_cell(std::size_t k, Precision precision, const Visit& visit) const {
    for (const CellResult& cell : result_.cells) {
      if (cell.precision == precision) visit(*league_.questions.sources[cell.source], cell.tallies[k]);
    }
  }

  template <class Row>
  void for_each_contender(Precision precision, const Row& row) const {
    for (std::size_t k = 0; k < league_.contenders; ++k) {
      if (league_.kernels[k]->has(precision)) row(k);
    }
  }

  std::vector<std::string> families(std::vector<std::string> first) const {
    for (const SourcePtr& source : league_.questions.sources) first.push_back(source->name());
    return first;
  }

  InstrumentTable by_family(Precision precision) const {
    InstrumentTable table{
        fmt::format("{}: missed/phantom contacts per million, by family", name(precision)), families({"kernel"}), {}};
    put_headings(table, 1);
    for_each_contender(precision, [&](std::size_t k) {
      auto& row = table.rows.emplace_back(std::vector<std::string>{league_.kernels[k]->id});
      for_each_cell(k, precision,
                    [&](const Source&, const Tally& tally) { row.push_back(family_cell(*league_.kernels[k], tally)); });
    });
    return table;
  }

  InstrumentTable overall(Precision precision) const {
    InstrumentTable table{
        fmt::format("{}: over all families", name(precision)),
        {"kernel", "decided", "missed", "deepest", "phantom", "deepest", "declined", "invalid", "unanswered",
         "outside limits", "critical radius: median, ulps", "largest", "hangs", "crashes", "other findings"},
        {}};
    if (!league_.nanoseconds.empty()) table.columns.emplace_back("ns a query");
    const std::optional<double> certified = time_of_certified(precision);
    if (certified) table.columns.emplace_back("where certified takes 1");
    table.headings = {"Verdicts", "Critical radius, findings and time"};
    table.heading_of.assign(table.columns.size(), 2);
    table.heading_of[0] = 0;
    std::fill_n(table.heading_of.begin() + 1, 9, 1);
    for_each_contender(precision, [&](std::size_t k) {
      const Tally all = sum(k, precision);
      const std::uint64_t contacts = decided_for(FlipKind::false_separation, *league_.kernels[k], all),
                          separations = decided_for(FlipKind::false_contact, *league_.kernels[k], all);
      const auto radius = radii(sizes(all.critical_radius.errors_ulps), all.critical_radius.unbounded);
      auto& row = table.rows.emplace_back(std::vector<std::string>{
          league_.kernels[k]->id, thousands(decided(all)), wrong_count(all.verdict.false_separation, contacts),
          deepest(all.verdict.deepest_false_separation.best(), contacts),
          wrong_count(all.verdict.false_contact, separations),
          deepest(all.verdict.deepest_false_contact.best(), separations), thousands(all.verdict.undecided),
          thousands(all.verdict.invalid), thousands(all.verdict.unanswered),
          thousands(all.verdict.outside_limits->trials), radius.median, radius.largest,
          thousands(count_of(all, FindingKind::hang)), thousands(count_of(all, FindingKind::crash)),
          thousands(other_findings(all))});
      const std::optional<double> ns = time(k, precision);
      const auto ratio = [&](double by) { return ns ? fmt::format("{:.3g}", *ns / by) : "not measured"; };
      if (!league_.nanoseconds.empty()) row.push_back(ratio(1));
      if (certified) row.push_back(ratio(*certified));
    });
    return table;
  }

  // None have no number of wrong ones, and no deepest of these.
  static std::string wrong_count(std::uint64_t wrong, std::uint64_t of) {
    return of == 0 ? "not measured" : thousands(wrong);
  }
  static std::string deepest(double depth, std::uint64_t of) {
    if (of == 0) return "not measured";
    return depth == 0 ? "0" : fmt::format("{:.3g}", depth);
  }

  std::optional<double> time(std::size_t k, Precision precision) const {
    const auto found = league_.nanoseconds.find({precision, k});
    return found == league_.nanoseconds.end() ? std::nullopt : std::optional(found->second);
  }
  // Empty where it does not compete.
  std::optional<double> time_of_certified(Precision precision) const {
    for (std::size_t k = 0; k < league_.contenders; ++k) {
      if (league_.kernels[k]->id == "certified") return time(k, precision);
    }
    return std::nullopt;
  }

  // Each claims the bits of the published test, so that its own fault is distinguished from rounding and range.
  static std::optional<std::uint64_t> caught(const Tally& tally) {
    return tally.verdict.first_by_link[Link::implementation].position;
  }

  InstrumentTable faults(Precision precision) const {
    InstrumentTable table{
        fmt::format(
            "{}: kernels with a planted fault: after how many queries of each family the first verdict is wrong "
            "by it; - where none was",
            name(precision)),
        families({"kernel", "first caught by"}),
        {}};
    put_headings(table, 2);
    for (std::size_t k = league_.contenders; k < league_.kernels.size(); ++k) {
      if (!league_.kernels[k]->has(precision)) continue;
      std::vector<std::string> cells;
      std::pair<std::uint64_t, std::string> first{UINT64_MAX, "never"};
      for_each_cell(k, precision, [&](const Source& source, const Tally& tally) {
        const auto position = caught(tally);
        cells.push_back(position ? thousands(*position + 1) : "-");
        if (position) first = std::min(first, {*position, source.name()});
      });
      auto& row = table.rows.emplace_back(std::vector<std::string>{league_.kernels[k]->id, first.second});
      row.insert(row.end(), cells.begin(), cells.end());
    }
    return table;
  }

  InstrumentTable findings() const {
    InstrumentTable table{"Findings", {"kernel", "precision", "family", "what", "times", "first at", "detail"}, {}};
    for (std::size_t k = 0; k < league_.kernels.size(); ++k) {
      for (const Finding& finding : league_.kernels[k]->findings) {
        table.rows.push_back(
            {league_.kernels[k]->id, "", "", std::string(name(finding.kind)), "1", "", finding.detail});
      }
      for (const Precision precision : league_.questions.precisions) {
        for_each_cell(k, precision, [&](const Source& source, const Tally& tally) {
          for (std::size_t i = 0; i < finding_kind_count; ++i) {
            const FindingTally& finding = tally.findings[i];
            if (finding.count == 0) continue;
            table.rows.push_back({league_.kernels[k]->id, std::string(name(precision)), source.name(),
                                  std::string(finding_kind_names[i]), thousands(finding.count),
                                  text(address_of(source, league_.questions.seed, precision, finding.first)),
                                  finding.detail});
          }
        });
      }
    }
    return table;
  }

  Tally sum(std::size_t k, Precision precision) const {
    Tally all = empty_tally(*league_.kernels[k]->predicate);
    for_each_cell(k, precision, [&](const Source&, const Tally& tally) { all.merge(tally); });
    return all;
  }

  Json data(const std::string& command) const {
    LeagueData data;
    data.command = command;
    data.seed = {league_.questions.seed};
    for (std::size_t k = 0; k < league_.kernels.size(); ++k) {
      const Kernel& kernel = *league_.kernels[k];
      for (const Precision precision : league_.questions.precisions) {
        if (!kernel.has(precision)) continue;
        LeagueKernelData& entry = data.kernels.emplace_back();
        entry.id = kernel.id;
        entry.precision = precision;
        entry.summary = kernel.summary;
        entry.touching = kernel.touching;
        entry.may_decline = kernel.may_decline;
        entry.has_planted_fault = k >= league_.contenders;
        entry.ns = time(k, precision);
        if (k < league_.contenders) entry.worst = worst_data(league_, result_, k, precision);
        if (const auto cause = league_.causes.find({precision, k}); cause != league_.causes.end())
          entry.cause = cause->second;
        for (const TrustGroup group : groups_asked(league_.questions.sources)) {
          const Trust trust = trust_in(kernel, tally_of_group(league_, result_, k, precision, group));
          entry.trust.put(name(group)) = {trust.answer, trust.words};
        }
        for_each_cell(k, precision, [&](const Source& source, const Tally& tally) {
          entry.families.put(source.name()) = family_data(kernel, tally);
        });
      }
    }
    data.not_checked.assign(league_.not_checked.begin(), league_.not_checked.end());
    return json_of(data);
  }

  static LeagueFamilyData family_data(const Kernel& kernel, const Tally& tally) {
    const VerdictTally& verdict = tally.verdict;
    std::vector<double> errors = sizes(tally.critical_radius.errors_ulps);
    std::sort(errors.begin(), errors.end());
    LeagueFamilyData data;
    data.trials = tally.trials;
    data.decided = decided(tally);
    if (verdict.decided_touching != 0) data.touching_flips = verdict.touching_flips;
    if (decided_for(FlipKind::false_separation, kernel, tally) != 0) {
      data.false_separation = verdict.false_separation;
      data.deepest_false_separation = verdict.deepest_false_separation.best();
    }
    if (decided_for(FlipKind::false_contact, kernel, tally) != 0) {
      data.false_contact = verdict.false_contact;
      data.deepest_false_contact = verdict.deepest_false_contact.best();
    }
    data.undecided = verdict.undecided;
    data.invalid = verdict.invalid;
    data.unanswered = verdict.unanswered;
    data.outside_limits = verdict.outside_limits->trials;
    if (const auto position = caught(tally)) data.caught_after = *position + 1;
    data.critical_radius = radius_summary(errors, tally.critical_radius.unbounded);
    for (const FindingKind kind : enumerators<FindingKind>) {
      if (tally.findings[kind].count != 0) data.findings[kind] = tally.findings[kind].count;
    }
    if (kernel.measure_count != 0)
      data.contacts = given_contacts(tally.contacts, *kernel.predicate, kernel.measure_count);
    return data;
  }

  const League& league_;
  const CampaignResult& result_;
};

}  // namespace

std::vector<std::string> undecided_contenders(const League& league, const CampaignResult& result) {
  std::vector<std::string> silent;
  for (std::size_t k = 0; k < league.contenders; ++k) {
    for (const Precision precision : league.questions.precisions) {
      if (!league.kernels[k]->has(precision)) continue;
      const Tally all = tally_of_group(league, result, k, precision, std::nullopt);
      if (decided(all) != 0) continue;
      const LookedAt looked_at = looked_at_of(all);
      silent.push_back(fmt::format("{} ({}: {})", league.kernels[k]->id, name(precision),
                                   looked_at_text(looked_at, league.kernels[k]->may_decline)));
    }
  }
  return silent;
}

InstrumentReport league_report(const League& league, const CampaignResult& result, const std::string& command) {
  return LeagueReport(league, result).report(command);
}

}  // namespace axiscert
