#include "reports/wording/depths.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "reports/wording/evidence.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr int first_column_decade = -8;  // two columns before it: zero, and all that is less
constexpr std::size_t last_column = 2 - first_column_decade - 1;

std::size_t column_of(std::size_t decade) {
  constexpr std::size_t before = static_cast<std::size_t>(first_column_decade - least_decade);
  if (decade < 2 + before) return std::min(decade, std::size_t{1});
  return std::min(decade - before, last_column);
}

}  // namespace

const std::vector<std::string>& depth_columns() {
  static const std::vector<std::string> columns = [] {
    std::vector<std::string> names = {"zero", fmt::format("< 1e{}", first_column_decade)};
    for (int decade = first_column_decade; decade < -3; ++decade) names.push_back(fmt::format("1e{}", decade));
    for (const char* name : {"0.001", "0.01", "0.1"}) names.emplace_back(name);
    return names;
  }();
  return columns;
}

std::vector<std::uint64_t> depth_counts(const DecadeCounts& decades) {
  std::vector<std::uint64_t> counts(depth_columns().size());
  for (std::size_t i = 0; i < decades.size(); ++i) counts[column_of(i)] += decades[i];
  return counts;
}

std::string depths_text(const DecadeCounts& decades) {
  std::vector<std::string> parts;
  const std::vector<std::uint64_t> counts = depth_counts(decades);
  for (std::size_t i = 0; i < counts.size(); ++i) {
    if (counts[i] != 0) parts.push_back(fmt::format("{}: {}", depth_columns()[i], thousands(counts[i])));
  }
  return parts.empty() ? "none" : fmt::format("{}", fmt::join(parts, ", "));
}

std::string engine_text(const FamilyRecord& family) {
  if (!family.verdict.engine) return "";
  const EngineTally& engine = *family.verdict.engine;
  if (engine.decided() == 0) return fmt::format("none of {} engine-like queries decided", thousands(engine.queries));
  const auto told = [](std::uint64_t decided, std::uint64_t wrong, const char* none, const char* what) {
    return decided == 0 ? none : fmt::format("{} {}", thousands(wrong), what);
  };
  return fmt::format(
      "{} and {} on {} engine-like queries{}",
      told(engine.decided_contacts, engine.false_separation(), "no contact decided", "missed"),
      told(engine.decided_separations, engine.false_contact(), "no separation decided", "phantom contacts"),
      thousands(engine.queries),
      engine.decided() < engine.queries ? fmt::format(", of which it decided {}", thousands(engine.decided())) : "");
}

std::string bias_text(const KernelRecord& kernel, const FamilyRecord& family) {
  const std::uint64_t missed = family.verdict.false_separation, phantom = family.verdict.false_contact;
  const CriticalRadiusRecord& radius = family.critical_radius;
  std::vector<std::string> parts;
  const auto ratio = [](std::uint64_t more, std::uint64_t less) {
    return amount(static_cast<double>(more) / static_cast<double>(less), 2);
  };
  if (missed != 0 && phantom != 0) {
    parts.push_back(phantom >= missed ? fmt::format("{} phantom contacts for each missed one", ratio(phantom, missed))
                                      : fmt::format("{} missed contacts for each phantom one", ratio(missed, phantom)));
  } else if (missed + phantom != 0) {
    // Those of the other kind could have been wrong the other way, where they were decided.
    const FlipKind other = missed != 0 ? FlipKind::false_contact : FlipKind::false_separation;
    const Evidence evidence = evidence_of(kernel, family);
    const std::uint64_t decided = evidence.decided_for(other);
    const bool is_whole = decided != 0 && decided == evidence.promised_for(other);
    parts.push_back(fmt::format("{} contacts alone{}", missed != 0 ? "missed" : "phantom",
                                is_whole ? "" : ", with " + decided_text(evidence, other)));
  }
  if (radius.sampled != 0) {
    std::string text = fmt::format("critical radius early on {}, late on {} of {}", thousands(radius.early),
                                   thousands(radius.late), thousands(radius.sampled));
    if (radius.signed_median_ulps)
      text += fmt::format(", signed median {:+.3g} ulps", radius.signed_median_ulps->value);
    parts.push_back(text);
  }
  return fmt::format("{}", fmt::join(parts, "; "));
}

const char* contact_note(bool moves) {
  if (!moves) {
    return "A separation is the distance of the two where they are apart, less their penetration where not; it is off "
           "by a "
           "share of the scene, and by ulps of the number nearest to the exact one. Answers contradict themselves "
           "where a "
           "contact has a separation above 0, separated one below 0, or one number is not given beside others. A flip "
           "is a "
           "normal to the other side. What is left of a penetration is a share of it, after a push by its exact depth "
           "along "
           "the normal. Angles are in radians, errors of points shares of the scene.";
  }
  return "Late is after the exact first contact, early before the best time, the greatest number that is not late. A "
         "tunnel "
         "is how far the sphere goes in until a late time, or in a missed contact, as a share of its radius; with 1 "
         "its "
         "centre comes to the triangle. Times are off by ulps of the best one, or where these are many by a share of "
         "the "
         "way and a length in the queries' unit, the greatest of each. Angles are in radians, errors of points shares "
         "of "
         "the scene.";
}

const std::vector<std::string>& contact_columns(bool moves) {
  static const std::vector<std::string> of_motions = {
      "contacts", "late",           "late by",       "tunnel",       "early",           "early by",
      "no time",  "wrong features", "normal off by", "point off by", "missed, through", "missed, tunnel"};
  static const std::vector<std::string> of_bodies = {
      "answers", "separation off by", "in ulps",    "contradictions", "wrong features",       "flips",
      "left",    "normal off by",     "its length", "point off by",   "points and separation"};
  return moves ? of_motions : of_bodies;
}

namespace {

// What was judged on no answer has no figure; on some, and not on all, it says on how many: "0.25 (12)".
std::string figure_on(std::uint64_t judged, std::uint64_t answers, const std::string& figure) {
  if (judged == 0) return "-";
  return judged < answers ? fmt::format("{} ({})", figure, thousands(judged)) : figure;
}

std::vector<std::string> body_cells(const ContactTally& contacts) {
  std::vector<std::string> cells = {thousands(contacts.answers)};
  const auto put = [&](std::uint64_t judged, const std::string& figure) {
    cells.push_back(figure_on(judged, contacts.answers, figure));
  };
  // A part that the kernel does not give was judged on none.
  const auto part_of = [](const auto& part) { return part.value_or(std::remove_cvref_t<decltype(*part)>()); };
  const SeparationTally separation = part_of(contacts.separation);
  put(separation.judged, amount(separation.largest_error.best(), 3));
  put(separation.judged, error_amount(separation.largest_ulps.best()));
  const ConsistencyTally consistency = part_of(contacts.consistency);
  const std::uint64_t contradictions = consistency.positive + consistency.negative + consistency.missing;
  cells.push_back(separation.judged + contradictions == 0 ? "-" : thousands(contradictions));
  const FeatureTally feature = part_of(contacts.feature);
  put(feature.judged, thousands(feature.wrong));
  const PushTally pushed = part_of(contacts.pushed);
  put(pushed.with_a_side(), thousands(pushed.flips));
  put(pushed.judged, error_amount(pushed.largest_left.best()));
  const NormalTally normal = part_of(contacts.normal);
  put(normal.judged, amount(normal.largest_angle.best(), 3));
  put(normal.lengths, amount(normal.largest_length_error.best(), 3));
  double largest = 0;
  std::uint64_t fewest = 0;
  for (const auto* points : {&contacts.point, &contacts.point_a, &contacts.point_b}) {
    const PointTally point = part_of(*points);
    if (point.judged == 0) continue;
    largest = std::max(largest, point.largest_error.best());
    fewest = fewest == 0 ? point.judged : std::min(fewest, point.judged);
  }
  put(fewest, amount(largest, 3));
  const PointsTally points = part_of(contacts.points);
  put(points.judged, amount(points.largest_error.best(), 3));
  return cells;
}

}  // namespace

std::vector<std::string> contact_cells(const FamilyRecord& family) {
  if (!family.contacts) return {};
  const ContactTally& motion = *family.contacts;
  if (!motion.missed) return body_cells(motion);
  if (!motion.time && motion.missed->deepest.best().is_zero()) return {};
  std::vector<std::string> cells = {thousands(motion.answers)};
  if (!motion.time) {
    cells.resize(7, "-");
  } else {
    const TimeTally& time = *motion.time;
    const auto put = [&](const std::string& figure) {
      cells.push_back(figure_on(time.judged(), motion.answers, figure));
    };
    put(thousands(time.late));
    put(time_error_text(time.late_errors));
    put(error_amount(time.late_tunnels.deepest.best()));
    put(thousands(time.early));
    put(time_error_text(time.early_errors));
    cells.push_back(motion.answers == 0 ? "-" : thousands(time.none + time.invalid));
  }
  const auto put = [&](const auto& part, const auto& figure) {
    cells.push_back(part ? figure_on(part->judged, motion.answers, figure(*part)) : "-");
  };
  put(motion.feature, [](const FeatureTally& feature) { return thousands(feature.wrong); });
  put(motion.normal, [](const NormalTally& normal) { return amount(normal.largest_angle.best(), 3); });
  put(motion.point, [](const PointTally& point) { return amount(point.largest_error.best(), 3); });
  const bool has_contacts = motion.decided.value_or(0) != 0;
  cells.push_back(has_contacts ? thousands(motion.missed->through) : "-");
  cells.push_back(has_contacts ? error_amount(motion.missed->deepest.best()) : "-");
  return cells;
}

namespace {

bool has_margin_alone(const KernelRecord& kernel) {
  const LimitsRecord limits = kernel.limits.value_or(LimitsRecord());
  const bool has_others = limits.least_coordinate || limits.greatest_coordinate || limits.least_area ||
                          limits.least_radius || limits.greatest_radius ||
                          limits.sides.value_or(SidesPolicy::both) != SidesPolicy::both ||
                          kernel.motion.value_or(PolicyRecord()) != PolicyRecord();
  return limits.margin && !has_others;
}

}  // namespace

std::optional<WithinMargin> within_margin(const KernelRecord& kernel, const FamilyRecord& result) {
  const std::optional<OutsideTally>& outside = result.verdict.outside_limits;
  if (!has_margin_alone(kernel) || !outside) return std::nullopt;
  return WithinMargin{outside->trials - outside->unanswered, outside->false_contact};
}

std::string why_no_margin(const KernelRecord& kernel) {
  if (!kernel.limits || !kernel.limits->margin) return "the kernel declares no margin";
  if (!has_margin_alone(kernel))
    return "the kernel declares other limits too, and the record counts all queries outside them together";
  return fmt::format("no query is apart by no more than its margin of {}", *kernel.limits->margin);
}

std::string broken_margin_text(const KernelRecord& kernel) {
  WithinMargin all;
  for (const auto& [family, result] : kernel.families) {
    const WithinMargin look = within_margin(kernel, result).value_or(WithinMargin());
    all.answered += look.answered;
    all.contacts += look.contacts;
  }
  if (all.contacts == all.answered) return "";
  return fmt::format("declares a margin of {}, and does not call {} of {} queries that are apart by no more contact",
                     *kernel.limits->margin, thousands(all.answered - all.contacts), thousands(all.answered));
}

}  // namespace axiscert
