#include "reports/wording/everyday.h"

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

#include "fuzz/queries/source.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr EnumArray<FamilyGroup, std::string_view> asked_words = {
    "everyday scenes", "of your own queries", "queries that nothing rounds",
    "other queries (random, touching, degenerate, huge, tiny)"};

// "27 contacts invented, worst 16.6 cm (scene-edge)", or "none invented", of the queries that could be.
std::string side_text(std::uint64_t count, std::uint64_t could_be, const char* what, const std::string& worst,
                      const std::string& family) {
  if (count == 0) return could_be == 0 ? fmt::format("{}: not checked", what) : fmt::format("none {}", what);
  return fmt::format("{} {} {}, worst {} ({})", thousands(count), count == 1 ? "contact" : "contacts", what, worst,
                     family);
}

// Families of scenes are in metres where nothing else is said.
std::string length_in(FamilyGroup group, double length, const LengthUnit* unit) {
  return length_text(length, unit == nullptr && group == FamilyGroup::everyday ? find_length_unit("m") : unit);
}

bool has_lengths(FamilyGroup group) { return group == FamilyGroup::everyday || group == FamilyGroup::own; }

// A length where one has a meaning; else a share.
std::string size_text(FamilyGroup group, double length, double depth, const LengthUnit* unit) {
  const std::string share = fmt::format("{} of the scene", amount(depth, 3));
  return has_lengths(group) ? length_in(group, length, unit) + ", " + share : share;
}

// "; 266 times late, by 12.4 cm at most, 0.957 of the way".
std::string times_text(FamilyGroup group, const GroupResult::Times& times, const char* side, const LengthUnit* unit) {
  if (times.count == 0) return "";
  return fmt::format("; {} time{} {}, by {} at most, {} of the way", thousands(times.count),
                     times.count == 1 ? "" : "s", side, length_in(group, times.farthest, unit),
                     amount(times.largest_share, 3));
}

// "12 of 1,000": so many, and so many others.
std::string of_text(std::uint64_t count, std::uint64_t others) {
  return fmt::format("{} of {}", thousands(count), thousands(count + others));
}

// Errors of contacts as a person would see them: times, or "; separations off by 3.2 mm at most; 2 separations of
// the wrong sign; no flip", then "; 259 features wrong; normals up to 139 degrees
// off; points up to 0.2 of the scene off". Normals from one degree on, points from a thousandth of the scene on.
std::string contacts_text(FamilyGroup group, const GroupResult& result, const LengthUnit* unit) {
  std::string text = times_text(group, result.late, "late", unit) + times_text(group, result.early, "early", unit);
  if (result.times != 0 && text.empty()) text += "; no time late or early";
  if (result.without_time != 0)
    text += fmt::format("; no time beside {} contacts", of_text(result.without_time, result.times));
  if (result.wrong_features != 0)
    text +=
        fmt::format("; {} feature{} wrong", thousands(result.wrong_features), result.wrong_features == 1 ? "" : "s");
  if (result.separations == 0 && result.without_separation != 0)
    text += fmt::format("; no separation beside {} answers", thousands(result.without_separation));
  if (result.separations != 0) {
    const std::string how_often =
        result.without_separation == 0
            ? ""
            : fmt::format(", given beside {} answers,", of_text(result.separations, result.without_separation));
    text +=
        fmt::format("; separations{} off by {} at most", how_often, length_in(group, result.farthest_separation, unit));
  }
  if (result.contradictions != 0)
    text += fmt::format("; {} separation{} of the wrong sign", thousands(result.contradictions),
                        result.contradictions == 1 ? "" : "s");
  if (result.flips != 0) text += fmt::format("; {} flip{}", thousands(result.flips), result.flips == 1 ? "" : "s");
  else if (result.sided != 0) text += "; no flip";
  if (result.without_push != 0)
    text += fmt::format("; no normal beside {} overlaps", of_text(result.without_push, result.pushes));
  const double degrees = result.largest_normal_angle * 180 / std::numbers::pi;
  if (degrees >= 1) text += fmt::format("; normals up to {} degrees off", amount(degrees, 3));
  if (result.without_point != 0)
    text += fmt::format("; no point beside {} answers", of_text(result.without_point, result.points));
  if (result.largest_point_error >= 1e-3)
    text += fmt::format("; points up to {} of the scene off", amount(result.largest_point_error, 3));
  return text;
}

std::string group_text(FamilyGroup group, const GroupResult& result, const LengthUnit* unit) {
  const Evidence& evidence = result.evidence;
  const std::uint64_t contacts = evidence.decided_for(FlipKind::false_separation),
                      separations = evidence.decided_for(FlipKind::false_contact);
  const std::string missed =
                        side_text(result.missed, contacts, "missed",
                                  size_text(group, result.worst_missed, result.deepest_missed, unit), result.missed_in),
                    invented = side_text(result.invented, separations, "invented",
                                         size_text(group, result.worst_invented, result.deepest_invented, unit),
                                         result.invented_in);
  std::string text = fmt::format("{} {}: ", thousands(evidence.promised()), asked_words[group]);
  if (evidence.decided() == 0) return text + "no verdict";
  if (result.missed + result.invented == 0) {
    text += "no wrong verdict";
    for (const FlipKind kind : {FlipKind::false_separation, FlipKind::false_contact}) {
      const bool is_one_kind = evidence.promised_for(kind) == 0;
      if (is_one_kind) text += kind == FlipKind::false_separation ? " on separations alone" : " on contacts alone";
    }
  } else text += result.missed == 0 && result.invented != 0 ? invented + "; " + missed : missed + "; " + invented;
  if (has_lengths(group)) text += contacts_text(group, result, unit);
  const std::uint64_t no_answer = evidence.declined() + evidence.invalid + evidence.unanswered;
  if (no_answer == 0) return text;
  text += fmt::format("; {} without a verdict", thousands(no_answer));
  for (const FlipKind kind : {FlipKind::false_separation, FlipKind::false_contact}) {
    const bool are_few = declines_too_many(evidence.promised_for(kind) - evidence.decided_for(kind),
                                           evidence.promised_for(kind), least_decided_share);
    if (are_few) text += "; " + decided_text(evidence, kind);
  }
  return text;
}

std::string window_text(const WindowRecord& window) {
  const std::string asked = fmt::format("2^{} to 2^{}", window.scanned_low, window.scanned_high);
  if (window.is_whole()) return fmt::format("in other units: as in this one, times {}", asked);
  if (window.low == 0 && window.high == 0)
    return fmt::format("in other units: other answers at half the unit and at twice it ({} were asked)", asked);
  return fmt::format("in other units: as in this one only from 2^{} to 2^{} times it ({} were asked)", window.low,
                     window.high, asked);
}

}  // namespace

FamilyGroup family_group(std::string_view name) {
  if (name.starts_with("mesh/") || is_query_file(name)) return FamilyGroup::own;
  for (const Family* family : families()) {
    if (family->name != name) continue;
    if (family->trust_group == TrustGroup::scene) return FamilyGroup::everyday;
    return family->exact_arithmetic ? FamilyGroup::exact : FamilyGroup::other;
  }
  return FamilyGroup::other;
}

GroupResult group_result(const KernelRecord& kernel, FamilyGroup group) {
  GroupResult out;
  for (const auto& [family, result] : kernel.families) {
    if (family_group(family) != group) continue;
    const VerdictTally& verdict = result.verdict;
    const Evidence evidence = evidence_of(kernel, result);
    if (evidence.promised() == 0) continue;
    ++out.families;
    out.evidence.add(evidence);
    out.missed += verdict.false_separation;
    out.invented += verdict.false_contact;
    const auto offer = [&, family = family](double length, double depth, double& farthest, double& deepest,
                                            std::string& in) {
      if (length > farthest || in.empty()) in = family;
      farthest = std::max(farthest, length);
      deepest = std::max(deepest, depth);
    };
    if (verdict.false_separation != 0) {
      offer(verdict.farthest_false_separation.best(), verdict.deepest_false_separation.best(), out.worst_missed,
            out.deepest_missed, out.missed_in);
    }
    if (verdict.false_contact != 0) {
      offer(verdict.farthest_false_contact.best(), verdict.deepest_false_contact.best(), out.worst_invented,
            out.deepest_invented, out.invented_in);
    }
    if (!result.contacts) continue;
    if (const auto& feature = result.contacts->feature) out.wrong_features += feature->wrong;
    if (const auto& normal = result.contacts->normal)
      out.largest_normal_angle = std::max(out.largest_normal_angle, normal->largest_angle.best());
    const auto add_points = [&out](const auto& points) {
      if (points) out.largest_point_error = std::max(out.largest_point_error, points->largest_error.best());
    };
    for (const auto* points : {&result.contacts->point, &result.contacts->point_a, &result.contacts->point_b})
      add_points(*points);
    add_points(result.contacts->points);
    if (const auto& given = result.contacts->point ? result.contacts->point : result.contacts->point_a) {
      out.points += given->judged;
      out.without_point += given->none;
    }
    if (const auto& separation = result.contacts->separation) {
      out.separations += separation->judged;
      out.without_separation += result.contacts->answers - std::min(result.contacts->answers, separation->judged);
      out.farthest_separation = std::max(out.farthest_separation, separation->worst_length());
    }
    if (const auto& numbers = result.contacts->consistency) out.contradictions += numbers->positive + numbers->negative;
    if (const auto& pushed = result.contacts->pushed) {
      out.pushes += pushed->judged;
      out.without_push += pushed->none;
      out.sided += pushed->with_a_side();
      out.flips += pushed->flips;
    }
    if (!result.contacts->time) continue;
    const TimeTally& time = *result.contacts->time;
    out.times += time.judged();
    out.without_time += time.none + time.invalid;
    const auto add_times = [](GroupResult::Times& times, std::uint64_t count, const TimeErrors& errors) {
      times.count += count;
      times.farthest = std::max(times.farthest, errors.largest_length.best());
      times.largest_share = std::max(times.largest_share, errors.largest_share.best());
    };
    add_times(out.late, time.late, time.late_errors);
    add_times(out.early, time.early, time.early_errors);
  }
  return out;
}

std::vector<std::string> first_sentences(const KernelRecord& kernel, const PlanRecord& plan) {
  std::vector<std::string> sentences;
  for (const FamilyGroup group : enumerators<FamilyGroup>) {
    const GroupResult result = group_result(kernel, group);
    if (result.families != 0) sentences.push_back(group_text(group, result, unit_of(plan)));
  }
  if (kernel.window) sentences.push_back(window_text(*kernel.window));
  return sentences;
}

std::string length_words(std::string_view family, double length, const PlanRecord& plan) {
  const FamilyGroup group = family_group(family);
  return has_lengths(group) && length > 0 ? length_in(group, length, unit_of(plan)) : "";
}

const WitnessRecord* worst_scene(const Record& record) {
  const auto worst = [&](auto&& is_meant, auto&& size) {
    const WitnessRecord* found = nullptr;
    for (const WitnessRecord& witness : record.witnesses) {
      if (witness.depth && is_meant(witness) && (found == nullptr || size(witness) > size(*found))) found = &witness;
    }
    return found;
  };
  for (const FamilyGroup group : {FamilyGroup::everyday, FamilyGroup::own}) {
    const auto is_farthest = [&](const WitnessRecord& witness) {
      return family_group(witness.family) == group && std::ranges::any_of(witness.shows, [](const std::string& reason) {
               return reason.starts_with("farthest ");
             });
    };
    if (const auto* found = worst(is_farthest, [](const auto& witness) { return witness.length.value_or(0); }))
      return found;
  }
  return worst([](const auto&) { return true; }, [](const auto& witness) { return *witness.depth; });
}

std::string scene_words(const WitnessRecord& witness, const PlanRecord& plan) {
  const double depth = witness.depth.value_or(0), length = witness.length.value_or(0);
  const bool is_missed = witness.computed == Verdict::separated;
  const std::string what = is_missed ? "misses a contact" : "invents a contact";
  if (depth == 0) return what + " where the two only touch";
  const std::string share = fmt::format("{} of the scene", amount(depth, 3));
  const std::string size = length_words(witness.family, length, plan);
  if (size.empty()) return fmt::format("{}, by {}", what, share);
  return fmt::format("{} {} in a scene of {}: {}", what,
                     is_missed ? size + " deep" : fmt::format("across a gap of {}", size),
                     length_words(witness.family, length / depth, plan), share);
}

}  // namespace axiscert
