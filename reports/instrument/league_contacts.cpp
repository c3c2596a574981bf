#include "reports/instrument/league_contacts.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "exact/judge/examine.h"
#include "fuzz/confirm/record.h"
#include "fuzz/confirm/witness.h"
#include "fuzz/queries/source.h"
#include "fuzz/text/json_form.h"
#include "fuzz/text/number_text.h"
#include "reports/wording/reproduce.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr const char* not_given = "not given";

double degrees_of(double radians) { return radians * 180 / std::numbers::pi; }

// Answers with other numbers, and without this one: "; none beside 12 others".
std::string lack_words(std::uint64_t none) { return none == 0 ? "" : fmt::format("; none beside {}", thousands(none)); }

// "off by up to 0.1 of the scene on scenes, 0.5 at most"; without scenes "off by up to 0.5 of the scene".
std::string with_scenes(const char* how, const char* unit, double most, std::optional<double> of_scenes) {
  if (!of_scenes) return fmt::format("{} by up to {:.3g} {}", how, most, unit);
  return fmt::format("{} by up to {:.3g} {} on scenes, {:.3g} at most", how, *of_scenes, unit, most);
}

// A part of a tally that counts what was judged; null where the kernel gives none, or gave none here.
template <class Part>
const Part* given(const std::optional<Part>& part) {
  return part && part->judged != 0 ? &*part : nullptr;
}

}  // namespace

ContactTally contacts_of_group(const League& league, const CampaignResult& result, std::size_t k, Precision precision,
                               std::optional<TrustGroup> group) {
  const Kernel& kernel = *league.kernels[k];
  return given_contacts(tally_of_group(league, result, k, precision, group).contacts, *kernel.predicate,
                        kernel.measure_count);
}

std::string separation_words(const ContactTally& all, const ContactTally& scenes) {
  const SeparationTally* const separation = given(all.separation);
  if (!separation) return not_given;
  std::string words;
  if (separation->largest_error.best() == 0) {
    words = fmt::format("the nearest numbers on all {}", thousands(separation->judged));
  } else {
    if (const SeparationTally* const of_scenes = given(scenes.separation))
      words = fmt::format("{} on scenes, ", metric_text(of_scenes->largest_length.best()));
    words = fmt::format("off by up to {}{:.3g} of the scene", words, separation->largest_error.best());
  }
  return words + lack_words(separation->none);
}

std::string contradiction_words(const ContactTally& all) {
  if (!given(all.separation)) return "-";
  std::vector<std::string> words;
  add_count(words, all.consistency->positive, "contacts with a separation above 0");
  add_count(words, all.consistency->negative, "separated with one below 0");
  add_count(words, all.consistency->missing, "answers without one of their numbers");
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, "; "));
}

std::string flip_words(const ContactTally& all) {
  const PushTally* const pushed = given(all.pushed);
  if (!pushed) return not_given;
  const std::string left = error_amount(pushed->largest_left.best());
  const std::uint64_t sided = pushed->with_a_side();
  const std::string flips = sided == 0           ? "no normal with a side"
                            : pushed->flips == 0 ? fmt::format("none of {}", thousands(sided))
                                                 : fmt::format("{} of {}", thousands(pushed->flips), thousands(sided));
  return fmt::format("{}; a push leaves up to {} of the depth", flips, left);
}

std::string normal_words(const ContactTally& all, const ContactTally& scenes) {
  const NormalTally* const normal = given(all.normal);
  if (!normal) return not_given;
  // Below this a length is off by roundings alone.
  constexpr double rounding = 1e-6;
  const NormalTally* const of_scenes = given(scenes.normal);
  std::string words =
      with_scenes("tilted", "degrees", degrees_of(normal->largest_angle.best()),
                  of_scenes ? std::optional(degrees_of(of_scenes->largest_angle.best())) : std::nullopt);
  if (const double off = normal->largest_length_error.best(); off > rounding)
    words += fmt::format(", length off by up to {:.3g}", off);
  return words + lack_words(normal->none);
}

std::string feature_words(const ContactTally& all) {
  const FeatureTally* const feature = given(all.feature);
  if (!feature) return not_given;
  return fmt::format("{} of {} wrong", feature->wrong == 0 ? "none" : thousands(feature->wrong),
                     thousands(feature->judged)) +
         lack_words(feature->none);
}

std::string point_words(const ContactTally& all, const ContactTally& scenes) {
  const PointTally* const point = given(all.point);
  if (!point) return not_given;
  const PointTally* const of_scenes = given(scenes.point);
  return with_scenes("off", "of the scene", point->largest_error.best(),
                     of_scenes ? std::optional(of_scenes->largest_error.best()) : std::nullopt) +
         lack_words(point->none);
}

InstrumentTable contacts_table(const League& league, const CampaignResult& result, Precision precision) {
  InstrumentTable table{
      fmt::format("{}: what is said beside the verdicts", name(precision)),
      {"kernel", "looked at", "separation", "contradictions", "flips", "normals", "features", "points"},
      {}};
  for (std::size_t k = 0; k < league.contenders; ++k) {
    const Kernel& kernel = *league.kernels[k];
    if (!kernel.has(precision)) continue;
    const ContactTally all = contacts_of_group(league, result, k, precision, std::nullopt),
                       scenes = contacts_of_group(league, result, k, precision, TrustGroup::scene);
    if (kernel.measure_count == 0) {
      table.rows.push_back({kernel.id, "-", not_given, "-", not_given, not_given, not_given, not_given});
      continue;
    }
    table.rows.push_back({kernel.id, thousands(all.answers), separation_words(all, scenes), contradiction_words(all),
                          flip_words(all), normal_words(all, scenes), feature_words(all), point_words(all, scenes)});
  }
  return table;
}

namespace {

constexpr std::size_t shown_of_each_kind = 5;

// A kind of wrong number: the worst of it in a tally, by its size, and that in words.
struct ContactFault {
  const char* name;
  std::function<std::optional<Candidate<double>>(const ContactTally&)> worst;
  std::function<std::string(double)> words;
};

template <class Rank>
std::optional<Candidate<double>> first_of(const Leaders<Rank>& leaders) {
  if (leaders.candidates().empty()) return std::nullopt;
  const Candidate<Rank>& found = leaders.candidates().front();
  if constexpr (requires { found.rank.value(); }) return Candidate<double>{found.rank.value(), found.position};
  else return Candidate<double>{static_cast<double>(found.rank), found.position};
}

const std::vector<ContactFault>& contact_faults() {
  static const auto share = [](double x) { return fmt::format("{:.3g} of the scene", x); };
  static const std::vector<ContactFault> all = {
      {"separation",
       [](const ContactTally& t) { return t.separation ? first_of(t.separation->largest_error) : std::nullopt; },
       share},
      {"contradiction",
       [](const ContactTally& t) {
         return t.consistency ? first_of(t.consistency->first[Consistency::positive]) : std::nullopt;
       },
       [](double) { return std::string("a contact with a separation above 0"); }},
      {"left", [](const ContactTally& t) { return t.pushed ? first_of(t.pushed->largest_left) : std::nullopt; },
       [](double x) { return fmt::format("{:.6g} of the depth", x); }},
      {"normal", [](const ContactTally& t) { return t.normal ? first_of(t.normal->largest_angle) : std::nullopt; },
       [](double x) { return fmt::format("{:.3g} degrees", degrees_of(x)); }},
      {"point", [](const ContactTally& t) { return t.point ? first_of(t.point->largest_error) : std::nullopt; },
       share}};
  return all;
}

struct WorstContact {
  std::size_t k;
  const CellResult* cell;
  Candidate<double> found;
};

// The worst of each contender and precision, the worst first; those of one that is right are left out.
std::vector<WorstContact> worst_by(const League& league, const CampaignResult& result, const ContactFault& fault) {
  std::vector<WorstContact> all;
  for (std::size_t k = 0; k < league.contenders; ++k) {
    for (const Precision precision : league.questions.precisions) {
      std::optional<WorstContact> worst;
      for (const CellResult& cell : result.cells) {
        if (cell.precision != precision || !league.kernels[k]->has(precision)) continue;
        const Kernel& kernel = *league.kernels[k];
        const auto found =
            fault.worst(given_contacts(cell.tallies[k].contacts, *kernel.predicate, kernel.measure_count));
        if (found && found->rank > 0 && (!worst || found->rank > worst->found.rank)) worst = {k, &cell, *found};
      }
      if (worst) all.push_back(*worst);
    }
  }
  std::ranges::stable_sort(all, std::ranges::greater(), [](const WorstContact& one) { return one.found.rank; });
  if (all.size() > shown_of_each_kind) all.resize(shown_of_each_kind);
  return all;
}

// The query as a picture, with the point and the normal that were given.
InstrumentScene contact_scene(const League& league, const WorstContact& worst, const std::string& words) {
  const Kernel& kernel = *league.kernels[worst.k];
  const Source& source = *league.questions.sources[worst.cell->source];
  const PredicateEntry& entry = source.predicate().entries[source.entry()];
  const Precision precision = worst.cell->precision;
  const std::string address = text(address_of(source, league.questions.seed, precision, worst.found.position));
  InstrumentScene scene;
  scene.title = fmt::format("{}, {}", kernel.id, name(precision));
  scene.sentence = fmt::format("{}. Family {}, address {}.", words, source.name(), address);
  Examiner examiner(kernel, "auto");
  const auto put = [&](const auto& q) {
    scene.query = json_of(groups_of_numbers(entry, q));
    if (const auto measures = measures_of(*kernel.predicate, examiner.examine(q)))
      scene.query["measures"] = json_of(*measures);
  };
  if (precision == Precision::binary32) put(source.make<float>(league.questions.seed, worst.found.position));
  else put(source.make<double>(league.questions.seed, worst.found.position));
  scene.command = fmt::format("axiscert query {} > worst.jsonl\naxiscert check worst.jsonl --kernel {}\n",
                              shell_word(address), shell_word(kernel.id));
  return scene;
}

}  // namespace

std::vector<WorstContactData> worst_contacts(const League& league, const CampaignResult& result,
                                             InstrumentTable& table) {
  std::vector<WorstContactData> all;
  for (const ContactFault& fault : contact_faults()) {
    for (const WorstContact& worst : worst_by(league, result, fault)) {
      const Source& source = *league.questions.sources[worst.cell->source];
      const Precision precision = worst.cell->precision;
      const std::string words = fault.words(worst.found.rank);
      const InstrumentScene scene = contact_scene(league, worst, fmt::format("{}: {}", fault.name, words));
      const WorstContactData& data = all.emplace_back(WorstContactData{
          fault.name, league.kernels[worst.k]->id, precision, source.name(), worst.found.rank,
          text(address_of(source, league.questions.seed, precision, worst.found.position)), scene.query});
      table.rows.push_back({data.kind, data.kernel, std::string(name(precision)), data.family, words, data.address});
      table.scenes.push_back(scene);
    }
  }
  return all;
}

InstrumentReport league_contacts_report(const League& league, const CampaignResult& result,
                                        const std::string& command) {
  InstrumentReport report{"league", "What kernels and libraries say beside their verdicts", command, {}, {}, {}, {}};
  report.notes = {
      "Looked at: the answers whose numbers were judged, of the first 4,096 queries of a family, right or wrong. Not "
      "given: the library's function has no such number, or gave none; \"none beside\" counts the answers that lack "
      "one "
      "beside a contact or beside other numbers.",
      "Separation: the greatest difference from the exact one; on scenes, which are in metres, as a length too. "
      "Contradictions need no oracle. Flips: normals at more than a right angle to the exact one, along which a push "
      "by the exact depth leaves more than 1/16 of it. Points: the greatest distance from the exact one.",
      "What is right here holds for these queries only. docs/contacts.md says how each number is judged."};
  report.notes.insert(report.notes.end(), league.not_checked.begin(), league.not_checked.end());
  report.notes_heading = "What the words mean, and what was left out";
  report.are_notes_last = true;
  for (const Precision precision : league.questions.precisions)
    report.tables.push_back(contacts_table(league, result, precision));
  report.data = league_report(league, result, command).data;
  InstrumentTable worst{"The worst of each kind", {"kind", "kernel", "precision", "family", "off by", "address"}, {}};
  report.data["worst_contacts"] = json_of(worst_contacts(league, result, worst));
  report.add(std::move(worst));
  return report;
}

}  // namespace axiscert
