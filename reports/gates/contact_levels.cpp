// The levels of the numbers beside a contact in a predicate of motions: early, features, normals and points.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <charconv>
#include <cmath>
#include <functional>

#include "fuzz/text/length_unit.h"
#include "kernel/base/error.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

// What an argument is, and the greatest that says anything.
struct ContactBound {
  const char *letter, *what, *example;
  double least, most;
};
constexpr double pi_rounded_up = 3.1416;
constexpr ContactBound displacement_bound = {"U",
                                             "a number of u of the displacement (u = 2^-24 or 2^-53), 1 or more, or a "
                                             "length of the way such as 1mm",
                                             "64", 1, 1e300},
                       scene_bound = {"D", "a share of the scene, from 0 to 1", "0.001", 0, 1},
                       angle_bound = {"A", "an angle in radians, from 0 to pi", "0.001", 0, pi_rounded_up};

double bound_of(const AskedLevel& asked, const ContactBound& bound) {
  double most = 0;
  const char* const end = asked.argument.data() + asked.argument.size();
  const auto [stop, problem] = std::from_chars(asked.argument.data(), end, most);
  if (problem != std::errc() || stop != end || !(most >= bound.least && most <= bound.most)) {
    throw Error(fmt::format("requirement '{}': {} is {}, as in {}={}", asked.text, bound.letter, bound.what, asked.name,
                            bound.example));
  }
  return most;
}

// How many hits of a family have the number that a level is about, and how many have none though there is one.
struct Given {
  std::uint64_t judged, none;
};
using Counts = std::function<std::optional<Given>(const MotionTally& motion)>;  // empty: the kernel gives none

// Looks at the hits with the number; why that is too little stands in `not_checked`.
LevelFindings look_at(const Subject& subject, const Counts& counts, const char* what) {
  LevelFindings found;
  const Predicate& predicate = predicate_of(subject.record().plan);
  if (predicate.measures.empty()) {
    found.not_checked = fmt::format("the predicate {} has no {} of contact", predicate.id, what);
    return found;
  }
  std::uint64_t judged = 0;
  std::vector<std::string> seldom;
  for (const auto& [family, result] : subject.families()) {
    const std::optional<Given> given = counts(*result.motion);
    if (!given) {
      found.not_checked = fmt::format("the kernel gives no {} of contact", what);
      return found;
    }
    found.families[family] = {given->judged + given->none + result.verdict.false_separation, given->judged};
    if (given->judged == 0) found.unseen.push_back(family);
    if (given->none > given->judged) {
      seldom.push_back(fmt::format("on {} it gives no {} beside {} of {} contacts, and has to beside half of them",
                                   family, what, thousands(given->none), thousands(given->judged + given->none)));
    }
    judged += given->judged;
  }
  if (judged == 0) found.not_checked = fmt::format("no contact that it found has a {}", what);
  else if (!seldom.empty()) found.not_checked = seldom.front();
  found.covers = fmt::format("the {} of {} contacts of {}, each compared with the exact one", what, thousands(judged),
                             subject.list_of_families());
  found.leaves_out = "missed and phantom contacts";
  return found;
}

// How early a time may be: in u of the displacement, or by a length of the way.
struct EarlyBound {
  double most;
  bool is_length;

  std::string text() const { return is_length ? metric_text(most) : fmt::format("{} u", most); }
};
EarlyBound early_bound(const AskedLevel& asked) {
  if (const auto length = length_in_metres(asked.argument)) return {*length, true};
  return {bound_of(asked, displacement_bound), false};
}

LevelFindings judge_early(const AskedLevel& asked, const Subject& subject) {
  const EarlyBound bound = early_bound(asked);
  const double metres_of_unit = metres_of(subject.record().plan);
  LevelFindings found = look_at(
      subject,
      [](const MotionTally& motion) {
        return motion.time ? std::optional(Given{motion.hits - motion.time->none - motion.time->invalid, 0})
                           : std::nullopt;
      },
      "time");
  subject.add_untimed(found.failures);
  for (const auto& [family, result] : subject.families()) {
    if (!result.motion || !result.motion->time) continue;
    const TimeTally& time = *result.motion->time;
    const Decimal6 earliest = time.early_errors.largest_in_u.best();
    const double length = time.early_errors.largest_length.best(), metres = length * metres_of_unit;
    if ((bound.is_length ? metres : earliest.value()) <= bound.most) continue;
    const std::string by = bound.is_length ? metric_text(metres) + " of the way"
                                           : fmt::format("{} u of the displacement, {}", error_amount(earliest),
                                                         way_text(time.early_errors));
    // Of those that are early by more than a length the record has the earliest, and not how many.
    subject.add_shown(found.failures, family, bound.is_length ? 1 : time.early,
                      fmt::format("times before the best one, the earliest by {}: {} is allowed", by, bound.text()),
                      bound.is_length ? fmt::format("earliest time: {:.6g} in length", length) : "earliest time");
  }
  found.leaves_out = "late times, which never-late asks about; " + found.leaves_out;
  return found;
}

LevelFindings judge_features(const AskedLevel& asked, const Subject& subject) {
  LevelFindings found = look_at(
      subject,
      [](const MotionTally& motion) {
        return motion.feature ? std::optional(Given{motion.feature->judged, motion.feature->none}) : std::nullopt;
      },
      "feature");
  for (const auto& [family, result] : subject.families()) {
    if (!result.motion || !result.motion->feature) continue;
    const FeatureTally& feature = *result.motion->feature;
    if (!asked.has_argument) {
      subject.add_shown(found.failures, family, feature.wrong, "features that are not touched first", "a feature");
      continue;
    }
    const double most = bound_of(asked, scene_bound), largest = feature.largest_error.best();
    subject.add_shown(found.failures, family, feature.unnamed, "features that there are not", "a feature");
    if (largest > most) {
      subject.add_shown(
          found.failures, family, feature.wrong - feature.unnamed,
          fmt::format("features that are not touched first, the farthest by {:.4g} of the scene: {} is allowed",
                      largest, most),
          "wrong feature farthest");
    }
  }
  return found;
}

LevelFindings judge_normals(const AskedLevel& asked, const Subject& subject) {
  const double most = bound_of(asked, angle_bound);
  LevelFindings found = look_at(
      subject,
      [](const MotionTally& motion) {
        return motion.normal ? std::optional(Given{motion.normal->judged, motion.normal->none}) : std::nullopt;
      },
      "normal");
  for (const auto& [family, result] : subject.families()) {
    if (!result.motion || !result.motion->normal) continue;
    const NormalTally& normal = *result.motion->normal;
    // Of those that are off by more than is allowed the record has the worst, and not how many.
    const auto check = [&, family = family](double largest, const char* what, const char* unit, const char* shown) {
      if (largest <= most) return;
      subject.add_shown(found.failures, family, 1,
                        fmt::format("the worst {} is off by {:.4g}{}: {} is allowed", what, largest, unit, most),
                        shown);
    };
    check(normal.largest_angle.best(), "normal", " radians", "largest angle of a normal");
    check(normal.largest_length_error.best(), "length of a normal", " of 1", "largest error of a normal's length");
  }
  found.leaves_out = "contacts at the distance 0, which have no normal; " + found.leaves_out;
  return found;
}

LevelFindings judge_points(const AskedLevel& asked, const Subject& subject) {
  const double most = bound_of(asked, scene_bound);
  LevelFindings found = look_at(
      subject,
      [](const MotionTally& motion) {
        return motion.point ? std::optional(Given{motion.point->judged, motion.point->none}) : std::nullopt;
      },
      "point");
  for (const auto& [family, result] : subject.families()) {
    if (!result.motion || !result.motion->point) continue;
    const double largest = result.motion->point->largest_error.best();
    if (largest <= most) continue;
    subject.add_shown(found.failures, family, 1,
                      fmt::format("the worst point is off by {:.4g} of the scene: {} is allowed", largest, most),
                      "largest error of a contact's point");
  }
  return found;
}

std::string features_sentence(const AskedLevel& asked) {
  if (!asked.has_argument) return "no feature beside a contact but one that is touched first";
  return fmt::format(
      "no feature beside a contact but one that is touched first, or in whose region the centre is then "
      "but for {} of the scene",
      bound_of(asked, scene_bound));
}

constexpr std::string_view in_u[] = {"64"}, shares[] = {"0.001"};

}  // namespace

extern const GateLevel early_level = {
    .usage = "early=U",
    .meaning = "no time before the best one by more than U, u of the displacement or a length of the way such as 1mm",
    .check = [](const AskedLevel& asked) { early_bound(asked); },
    .sentence =
        [](const AskedLevel& asked) {
          const EarlyBound bound = early_bound(asked);
          return fmt::format(
              "no time of contact before the best one by more than {}{}, and none that is missing or outside [0, 1]",
              bound.text(), bound.is_length ? " of the way" : " of the displacement");
        },
    .judge = judge_early,
    .in_certificates = in_u};

extern const GateLevel features_level = {
    .usage = "features[=D]",
    .meaning = "no wrong feature; with D, none but where the centre is within D of the scene of its region",
    .check =
        [](const AskedLevel& asked) {
          if (asked.has_argument) bound_of(asked, scene_bound);
        },
    .sentence = features_sentence,
    .judge = judge_features,
    .in_certificates = shares};

extern const GateLevel normals_level = {
    .usage = "normals=A",
    .meaning = "no normal that is off by more than A radians, or in length by more than A",
    .check = [](const AskedLevel& asked) { bound_of(asked, angle_bound); },
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format(
              "no normal beside a contact that is off by more than {0} radians, or longer or shorter than "
              "1 by more than {0}",
              bound_of(asked, angle_bound));
        },
    .judge = judge_normals,
    .in_certificates = shares};

extern const GateLevel points_level = {.usage = "points=D",
                                       .meaning = "no point of contact that is off by more than D of the scene",
                                       .check = [](const AskedLevel& asked) { bound_of(asked, scene_bound); },
                                       .sentence =
                                           [](const AskedLevel& asked) {
                                             return fmt::format(
                                                 "no point beside a contact that is off by more than {} of the scene",
                                                 bound_of(asked, scene_bound));
                                           },
                                       .judge = judge_points,
                                       .in_certificates = shares};

}  // namespace axiscert
