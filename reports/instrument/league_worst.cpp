#include "fuzz/text/json_form.h"
#include "reports/instrument/league_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "fuzz/confirm/record.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/number_text.h"
#include "kernel/base/error.h"
#include "kernel/plugin/load.h"
#include "kernel/plugin/manifest.h"
#include "reports/wording/everyday.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// Calls act(numbers) with the query in its own precision.
template <class Act>
auto with_query(const WorstQuery& worst, std::uint64_t seed, const Act& act) {
  if (worst.precision == Precision::binary32) return act(worst.source->make<float>(seed, worst.position));
  return act(worst.source->make<double>(seed, worst.position));
}

// The greatest of |A-P|, |B-P|, |C-P| and r, of which a depth is a share; rounded.
template <class Real>
long double size_of_scene(const Numbers<Real>& q) {
  long double size = q[12];
  for (std::size_t vertex = 0; vertex < 9; vertex += 3) {
    long double d[3];
    for (std::size_t k = 0; k < 3; ++k) d[k] = static_cast<long double>(q[vertex + k]) - q[9 + k];
    size = std::max(size, std::hypot(d[0], d[1], d[2]));
  }
  return size;
}

const char* kind_of(const WorstQuery& worst) { return worst.is_missed ? "missed" : "invented"; }

// "none of 60 contacts and 68 separations"; a kind without a verdict is no part of that.
std::string none_words(const Kernel& kernel, const Tally& tally) {
  const std::uint64_t contacts = decided_for(FlipKind::false_separation, kernel, tally),
                      separations = decided_for(FlipKind::false_contact, kernel, tally);
  if (contacts + separations == 0) return "not looked at";
  if (contacts == 0) return fmt::format("none of {} separations, and no contact decided", thousands(separations));
  if (separations == 0) return fmt::format("none of {} contacts, and no separation decided", thousands(contacts));
  return fmt::format("none of {} contacts and {} separations", thousands(contacts), thousands(separations));
}

std::string judging_commands(const WorstQuery& worst, const std::string& address) {
  return fmt::format("axiscert query {} > worst.jsonl\naxiscert check worst.jsonl --kernel {}\n", shell_word(address),
                     shell_word(worst.kernel->id));
}

}  // namespace

std::string WorstQuery::address(std::uint64_t seed) const {
  return text(address_of(*source, seed, precision, position));
}

std::optional<WorstQuery> worst_of(const League& league, const CampaignResult& result, std::size_t k,
                                   Precision precision) {
  std::optional<WorstQuery> missed, invented;
  for (const CellResult& cell : result.cells) {
    if (cell.precision != precision) continue;
    const auto offer = [&](std::optional<WorstQuery>& worst, const Leaders<double>& deepest, bool is_missed) {
      if (deepest.candidates().empty()) return;
      const Candidate<double>& found = deepest.candidates().front();
      if (worst && worst->depth >= found.rank) return;
      worst = WorstQuery{league.kernels[k], league.questions.sources[cell.source].get(),
                         precision,         found.position,
                         is_missed,         found.rank};
    };
    const VerdictTally& verdict = cell.tallies[k].verdict;
    offer(missed, verdict.deepest_false_separation, true);
    offer(invented, verdict.deepest_false_contact, false);
  }
  return missed ? missed : invented;
}

bool WorstQuery::is_everyday() const { return family_group(source->name()) == FamilyGroup::everyday; }

std::optional<WorstQuery> worst_scene_of(const League& league, const CampaignResult& result) {
  std::optional<WorstQuery> worst, deepest;
  double greatest = -1;
  for (std::size_t k = 0; k < league.contenders; ++k) {
    for (const Precision precision : league.questions.precisions) {
      const std::optional<WorstQuery> found = worst_of(league, result, k, precision);
      if (found && (!deepest || found->depth > deepest->depth)) deepest = found;
    }
    for (const CellResult& cell : result.cells) {
      const Source& source = *league.questions.sources[cell.source];
      if (family_group(source.name()) != FamilyGroup::everyday) continue;
      const VerdictTally& verdict = cell.tallies[k].verdict;
      for (const bool is_missed : {true, false}) {
        const auto& farthest =
            (is_missed ? verdict.farthest_false_separation : verdict.farthest_false_contact).candidates();
        if (farthest.empty() || farthest.front().rank <= greatest) continue;
        greatest = farthest.front().rank;
        worst = WorstQuery{league.kernels[k], &source, cell.precision, farthest.front().position, is_missed, 0};
      }
    }
  }
  if (!worst) return deepest;
  const auto of_scene = with_query(*worst, league.questions.seed, [](const auto& q) { return size_of_scene(q); });
  worst->depth = static_cast<double>(greatest / of_scene);
  return worst;
}

std::string worst_sentence(const WorstQuery& worst, std::uint64_t seed) {
  const auto [size, r] = with_query(
      worst, seed, [](const auto& q) { return std::pair(size_of_scene(q), static_cast<long double>(q[12])); });
  const auto length = [&](long double x) {
    return worst.is_everyday() ? metric_text(static_cast<double>(x)) : fmt::format("{:.3g}", x);
  };
  const std::string radius = fmt::format("r is {}", length(r));
  if (worst.depth == 0) {
    return fmt::format("{} at a distance of exactly r, where {}",
                       worst.is_missed ? "misses a contact" : "invents a contact", radius);
  }
  const long double off = worst.depth * size;
  return worst.is_missed
             ? fmt::format("misses a contact {} deep, where {}: {:.3g} of the scene", length(off), radius, worst.depth)
             : fmt::format("invents a contact across a gap of {}, where {}: {:.3g} of the scene", length(off), radius,
                           worst.depth);
}

InstrumentScene worst_scene(const WorstQuery& worst, std::uint64_t seed) {
  const PredicateEntry& entry = worst.source->predicate().entries[worst.source->entry()];
  const std::string address = worst.address(seed);
  InstrumentScene scene;
  scene.title = fmt::format("{}, {}", worst.kernel->id, name(worst.precision));
  scene.sentence =
      fmt::format("It {}. Family {}, address {}.", worst_sentence(worst, seed), worst.source->name(), address);
  std::vector<std::string> numbers;
  with_query(worst, seed, [&](const auto& q) {
    scene.query = json_of(groups_of_numbers(entry, q));
    for (std::size_t i = 0; i < entry.columns.size(); ++i) {
      numbers.push_back(fmt::format("{}", static_cast<double>(q[i])));
    }
  });
  scene.command = judging_commands(worst, address);
  if (!plugin::is_program(*worst.kernel)) return scene;
  const plugin::Manifest manifest =
      plugin::read_manifest(plugin::manifest_text(worst.kernel->file), worst.kernel->file);
  scene.code = plugin::filled_code(manifest.code, entry, numbers);
  if (!manifest.package.empty()) scene.needs = printable_line(fmt::format("{} {}", manifest.package, manifest.version));
  return scene;
}

InstrumentTable worst_table(const League& league, const CampaignResult& result) {
  InstrumentTable table{"The deepest miss of each; of one that misses nothing, its deepest invented contact",
                        {"kernel", "precision", "what", "family", "depth", "address"},
                        {}};
  for (std::size_t k = 0; k < league.contenders; ++k) {
    for (const Precision precision : league.questions.precisions) {
      const std::optional<WorstQuery> found = worst_of(league, result, k, precision);
      if (!league.kernels[k]->has(precision)) continue;
      if (!found) {
        table.rows.push_back(
            {league.kernels[k]->id, std::string(name(precision)),
             none_words(*league.kernels[k], tally_of_group(league, result, k, precision, std::nullopt)), "", "", ""});
        continue;
      }
      table.rows.push_back({league.kernels[k]->id, std::string(name(precision)), kind_of(*found), found->source->name(),
                            fmt::format("{:.3g}", found->depth), found->address(league.questions.seed)});
      table.scenes.push_back(worst_scene(*found, league.questions.seed));
    }
  }
  return table;
}

std::optional<WorstData> worst_data(const League& league, const CampaignResult& result, std::size_t k,
                                    Precision precision) {
  const std::optional<WorstQuery> found = worst_of(league, result, k, precision);
  if (!found) return std::nullopt;
  const InstrumentScene scene = worst_scene(*found, league.questions.seed);
  return WorstData{kind_of(*found), found->source->name(),
                   found->depth,    found->address(league.questions.seed),
                   scene.query,     scene.code.empty() ? std::nullopt : std::optional(scene.code)};
}

}  // namespace axiscert
