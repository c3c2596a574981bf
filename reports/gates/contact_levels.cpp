// The levels of the numbers beside a verdict: early, separation, feature, normal, unit, no-flip, left and point.
#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <numbers>

#include "fuzz/text/number_text.h"
#include "reports/gates/level.h"
#include "reports/run_folder/run_folder.h"
#include "reports/wording/summary.h"

namespace axiscert {
namespace {

constexpr NumberBound displacement_bound = {"U",
                                            "a number of u of the displacement (u = 2^-24 or 2^-53), 1 or more, or a "
                                            "length of the way such as 1mm",
                                            "64", 1, 1e300},
                      scene_bound = {"D", "a share of the scene, from 0 to 1", "0.001", 0, 1},
                      separation_bound = {"E", "a share of the scene, from 0 to 1, or a length such as 1mm", "0.001", 0,
                                          1},
                      angle_bound = {"DEG", "an angle in degrees, from 0 to 180", "0.1", 0, 180},
                      length_bound = {"E", "a difference from the length 1, from 0 to 1", "0.001", 0, 1},
                      left_bound = {"F", "a share of the depth, from 0 to 2, of at most six digits", "0.001", 0, 2,
                                    true};

// How many answers of a family have the number that a level is about, and how many have none though there is one.
// `nowhere`: those of `none` that have a normal of length 0.
struct Given {
  std::uint64_t judged, none = 0, nowhere = 0;
};
using Counts = std::function<std::optional<Given>(const ContactTally& contacts)>;  // empty: the kernel gives none

// For a part of the tally that counts both, or has nothing that could be missing.
template <class Part>
Counts counts_of(std::optional<Part> ContactTally::*member) {
  return [member](const ContactTally& contacts) -> std::optional<Given> {
    const std::optional<Part>& part = contacts.*member;
    if (!part) return std::nullopt;
    if constexpr (requires { part->none; }) return Given{part->judged, part->none};
    else return Given{part->judged};
  };
}

// Why a number that stands beside so few answers of a family says nothing; empty where it stands beside half of them.
// A contact that was missed has none.
std::string seldom_text(const Subject& subject, const Counts& counts, std::string_view what) {
  const bool moves = is_of_motions(predicate_of(subject.record().plan));
  for (const auto& [family, result] : subject.families()) {
    const std::optional<Given> given = result.contacts ? counts(*result.contacts) : std::nullopt;
    if (!given) continue;
    const std::uint64_t without = given->none + (moves ? result.verdict.false_separation : 0);
    if (without <= given->judged) continue;
    return fmt::format("on {} it {} no {} beside {} of {} {}, and has to beside half of them", family,
                       moves ? "misses, or gives" : "gives", what, thousands(without),
                       thousands(given->judged + without), moves ? "contacts" : "answers");
  }
  return "";
}

// Looks at the answers with the number; why that is too little stands in `not_checked`.
LevelFindings look_at(const Subject& subject, const Counts& counts, MeasureKind kind, std::string_view what,
                      std::string_view without) {
  LevelFindings found;
  const Predicate& predicate = predicate_of(subject.record().plan);
  const bool moves = is_of_motions(predicate);
  const char* const answers = moves ? "contacts" : "answers";
  if (!has_measure(predicate, kind)) {
    found.not_checked = fmt::format("the predicate {} has no {} of contact", predicate.id, what);
    return found;
  }
  std::uint64_t judged = 0, none = 0, nowhere = 0, unjudged = 0;
  for (const auto& [family, result] : subject.families()) {
    const std::optional<Given> given = result.contacts ? counts(*result.contacts) : std::nullopt;
    if (!given) {
      found.not_checked = fmt::format("the kernel gives no {} of contact", what);
      return found;
    }
    const std::uint64_t missed = moves ? result.verdict.false_separation : 0;
    found.families[family] = {given->judged + given->none + missed, given->judged};
    if (given->judged == 0) found.unseen.push_back(family);
    const std::uint64_t decided = subject.evidence(result).decided(), answers_here = result.contacts->answers;
    if (!moves) unjudged += decided - std::min(decided, answers_here);
    judged += given->judged;
    nowhere += given->nowhere;
    none += answers_here - std::min(answers_here, given->judged + given->nowhere);
  }
  if (judged == 0) found.not_checked = fmt::format("no {} has {}", moves ? "contact that it found" : "answer", without);
  else found.not_checked = seldom_text(subject, counts, what);
  found.covers = fmt::format("the {} of {} {} of {}, each compared with the exact one", what, thousands(judged),
                             answers, subject.list_of_families());
  if (none != 0) leave_out(found.leaves_out, fmt::format("{} {} without {}", thousands(none), answers, without));
  if (nowhere != 0)
    leave_out(found.leaves_out, fmt::format("{} normals of length 0, which have no side", thousands(nowhere)));
  if (unjudged != 0)
    leave_out(found.leaves_out, fmt::format("{} queries whose numbers were not judged: of a family the first 4,096 are",
                                            thousands(unjudged)));
  if (moves) leave_out(found.leaves_out, "missed and phantom contacts");
  return found;
}

// The families with that part, each with the failures that it adds.
template <class Part, class Add>
void for_each_part(const Subject& subject, std::optional<Part> ContactTally::*member, Add&& add) {
  for (const auto& [family, result] : subject.families()) {
    if (result.contacts && (*result.contacts).*member) add(family, *((*result.contacts).*member));
  }
}

// A number that is missing fails the level that is about it, as a wrong one does, where most are given. Not of motions:
// those that overlap at the start have none, and a rounding may take others for these.
template <class Part>
void add_missing(const Subject& subject, LevelFindings& found, std::optional<Part> ContactTally::*member,
                 std::string_view what) {
  if (!found.not_checked.empty() || is_of_motions(predicate_of(subject.record().plan))) return;
  for_each_part(subject, member, [&](const std::string& family, const Part& part) {
    subject.add_shown(found.failures, family, part.none, fmt::format("answers {}, though there is one", what),
                      missing_texts::of_answer(what));
  });
}

LevelFindings judge_early(const AskedLevel& asked, const Subject& subject) {
  const SizeLimit bound = size_limit(asked, displacement_bound);
  const double metres_of_unit = metres_of(subject.record().plan);
  LevelFindings found = look_at(
      subject,
      [](const ContactTally& contacts) {
        return contacts.time ? std::optional(Given{contacts.answers - contacts.time->none - contacts.time->invalid})
                             : std::nullopt;
      },
      MeasureKind::time, "time", "a time");
  subject.add_untimed(found.failures);
  for_each_part(subject, &ContactTally::time, [&](const std::string& family, const TimeTally& time) {
    const Decimal6 earliest = time.early_errors.largest_in_u.best();
    const double length = time.early_errors.largest_length.best(), metres = length * metres_of_unit;
    if ((bound.is_length ? metres : earliest.value()) <= bound.most) return;
    const std::string by = bound.is_length ? metric_text(metres) + " of the way"
                                           : fmt::format("{} u of the displacement, {}", error_amount(earliest),
                                                         way_text(time.early_errors));
    // The record has the earliest of those that are early by more than a length, and not how many.
    subject.add_shown(found.failures, family, bound.is_length ? 1 : time.early,
                      fmt::format("times before the best one, the earliest by {}: {} is allowed", by, bound.text("u")),
                      bound.is_length ? fmt::format("earliest time: {:.6g} in length", length) : "earliest time");
  });
  leave_out(found.leaves_out, "late times, which never-late asks about");
  return found;
}

LevelFindings judge_separation(const AskedLevel& asked, const Subject& subject) {
  const SizeLimit bound = size_limit(asked, separation_bound);
  const double metres_of_unit = metres_of(subject.record().plan);
  LevelFindings found = look_at(subject, counts_of(&ContactTally::separation), MeasureKind::separation, "separation",
                                "a separation to compare");
  add_missing(subject, found, &ContactTally::separation, missing_texts::separation);
  for_each_part(subject, &ContactTally::consistency, [&](const std::string& family, const ConsistencyTally& tally) {
    const auto add = [&](std::uint64_t count, const char* what, Consistency which) {
      subject.add_shown(found.failures, family, count, what, consistency_words[which]);
    };
    add(tally.positive, "contacts with a separation above 0", Consistency::positive);
    add(tally.negative, "separations below 0 beside separated", Consistency::negative);
  });
  for_each_part(subject, &ContactTally::separation, [&](const std::string& family, const SeparationTally& tally) {
    const double share = tally.worst_share(), length = tally.worst_length(), metres = length * metres_of_unit;
    if ((bound.is_length ? metres : share) <= bound.most) return;
    // The record has the worst of those that are off by more, and not how many.
    subject.add_shown(
        found.failures, family, 1,
        fmt::format("the worst separation is off by {}{}: {} is allowed",
                    bound.is_length ? metric_text(metres) : fmt::format("{:.4g} of the scene", share),
                    tally.has_margin() ? " with the margin that is declared" : "", bound.text("of the scene")),
        bound.is_length ? fmt::format("largest error of a separation: {:.6g} in length", length)
                        : fmt::format("largest error of a separation: {:.6g} of the scene", share));
  });
  return found;
}

LevelFindings judge_feature(const AskedLevel& asked, const Subject& subject) {
  LevelFindings found =
      look_at(subject, counts_of(&ContactTally::feature), MeasureKind::feature, "feature", "a feature to compare");
  add_missing(subject, found, &ContactTally::feature, missing_texts::feature);
  for_each_part(subject, &ContactTally::feature, [&](const std::string& family, const FeatureTally& feature) {
    if (!asked.has_argument) {
      subject.add_shown(found.failures, family, feature.wrong, "wrong features", "a wrong feature");
      return;
    }
    const double most = number_argument(asked, scene_bound), largest = feature.largest_error.best();
    subject.add_shown(found.failures, family, feature.unnamed, "features that there are not", "a wrong feature");
    if (largest > most) {
      subject.add_shown(
          found.failures, family, feature.wrong - feature.unnamed,
          fmt::format("wrong features, the farthest by {:.4g} of the scene: {} is allowed", largest, most),
          "wrong feature farthest");
    }
  });
  return found;
}

// The worst of a size of which the record has no more: how many are worse than is allowed is not known.
void add_worst(const Subject& subject, LevelFindings& found, const std::string& family, double largest, double most,
               const std::string& what, std::string_view unit, std::string_view shown) {
  if (largest <= most) return;
  subject.add_shown(found.failures, family, 1,
                    fmt::format("the worst {} is off by {:.4g}{}: {} is allowed", what, largest, unit, most), shown);
}

// Normals beside separations alone say nothing of those beside contacts, by which bodies are pushed.
LevelFindings look_at_normals(const Subject& subject, const Counts& counts, std::string_view without) {
  LevelFindings found = look_at(subject, counts, MeasureKind::normal, "normal", without);
  if (found.not_checked.empty())
    found.not_checked = seldom_text(subject, counts_of(&ContactTally::pushed), "normal of an overlap");
  add_missing(subject, found, &ContactTally::normal, missing_texts::normal);
  return found;
}

LevelFindings judge_normal(const AskedLevel& asked, const Subject& subject) {
  const double most = number_argument(asked, angle_bound);
  LevelFindings found = look_at_normals(subject, counts_of(&ContactTally::normal), "a normal to compare");
  for_each_part(subject, &ContactTally::normal, [&](const std::string& family, const NormalTally& normal) {
    const double degrees = normal.largest_angle.best() * 180 / std::numbers::pi;
    add_worst(subject, found, family, degrees, most, "normal", " degrees", "largest angle of a normal");
  });
  leave_out(found.leaves_out, "contacts at the distance 0 or with several normals, which left and no-flip ask about");
  return found;
}

LevelFindings judge_unit(const AskedLevel& asked, const Subject& subject) {
  const double most = number_argument(asked, length_bound);
  const Counts lengths = [](const ContactTally& contacts) {
    return contacts.normal ? std::optional(Given{contacts.normal->lengths, contacts.normal->none}) : std::nullopt;
  };
  LevelFindings found = look_at_normals(subject, lengths, "a normal that has a length");
  for_each_part(subject, &ContactTally::normal, [&](const std::string& family, const NormalTally& normal) {
    add_worst(subject, found, family, normal.largest_length_error.best(), most, "length of a normal", " of 1",
              "largest error of a normal's length");
  });
  return found;
}

LevelFindings look_at_pushed(const Subject& subject, const Counts& counts) {
  LevelFindings found =
      look_at(subject, counts, MeasureKind::normal, "normal", "a depth and a normal along which to push");
  if (is_of_motions(predicate_of(subject.record().plan))) {
    found = {};
    found.not_checked = "in a predicate of motions nothing is pushed out of another";
  }
  add_missing(subject, found, &ContactTally::pushed, missing_texts::push);
  return found;
}

LevelFindings judge_no_flip(const AskedLevel&, const Subject& subject) {
  const auto with_a_side = [](const ContactTally& contacts) -> std::optional<Given> {
    const std::optional<PushTally>& pushed = contacts.pushed;
    if (!pushed) return std::nullopt;
    return Given{pushed->with_a_side(), pushed->none + pushed->nowhere, pushed->nowhere};
  };
  LevelFindings found = look_at_pushed(subject, with_a_side);
  for_each_part(subject, &ContactTally::pushed, [&](const std::string& family, const PushTally& pushed) {
    subject.add_shown(found.failures, family, pushed.flips, "normals to the other side", "a normal to the other side");
  });
  return found;
}

LevelFindings judge_left(const AskedLevel& asked, const Subject& subject) {
  const double most = number_argument(asked, left_bound);
  LevelFindings found = look_at_pushed(subject, counts_of(&ContactTally::pushed));
  for_each_part(subject, &ContactTally::pushed, [&](const std::string& family, const PushTally& pushed) {
    const double left = pushed.largest_left.best().value();
    if (left <= most) return;
    subject.add_shown(
        found.failures, family, 1,
        fmt::format("a push by the depth along the worst normal leaves {:.6g} of it: {} is allowed", left, most),
        "most penetration left");
  });
  return found;
}

LevelFindings judge_point(const AskedLevel& asked, const Subject& subject) {
  const double most = number_argument(asked, scene_bound);
  const bool has_pair = has_measure(predicate_of(subject.record().plan), MeasureKind::point_b);
  LevelFindings found =
      has_pair
          ? look_at(subject, counts_of(&ContactTally::point_b), MeasureKind::point_b, "point", "a point to compare")
          : look_at(subject, counts_of(&ContactTally::point), MeasureKind::point, "point", "a point to compare");
  add_missing(subject, found, has_pair ? &ContactTally::point_b : &ContactTally::point, missing_texts::point);
  const auto check = [&](auto member, const char* what, const char* shown) {
    for_each_part(subject, member, [&](const std::string& family, const auto& tally) {
      add_worst(subject, found, family, tally.largest_error.best(), most, what, " of the scene", shown);
    });
  };
  check(&ContactTally::point, "point", "largest error of a contact's point");
  check(&ContactTally::point_a, "first point", "largest error of the first point");
  check(&ContactTally::point_b, "second point", "largest error of the second point");
  check(&ContactTally::points, "distance of the points from the separation", "largest difference between points");
  return found;
}

std::string feature_sentence(const AskedLevel& asked) {
  if (!asked.has_argument) return "no feature that is wrong or missing";
  return fmt::format("no feature that is missing, or from whose region the centre is more than {} of the scene",
                     number_argument(asked, scene_bound));
}

constexpr std::string_view in_u[] = {"64"}, shares[] = {"0.001"}, degrees[] = {"0.1"};

}  // namespace

extern const GateLevel early_level = {
    .usage = "early=U",
    .meaning = "no time before the best one by more than U, u of the displacement or a length of the way such as 1mm",
    .sentence =
        [](const AskedLevel& asked) {
          const SizeLimit bound = size_limit(asked, displacement_bound);
          return fmt::format(
              "no time of contact before the best one by more than {}{}, and none that is missing or outside [0, 1]",
              bound.text("u"), bound.is_length ? " of the way" : " of the displacement");
        },
    .judge = judge_early,
    .in_certificates = in_u};

extern const GateLevel separation_level = {
    .usage = "separation=E",
    .meaning =
        "no separation off by more than E, a share of the scene or a length such as 1mm, and none that "
        "contradicts its verdict",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("no separation that is off by more than {}, contradicts its verdict, or is missing",
                             size_limit(asked, separation_bound).text("of the scene"));
        },
    .judge = judge_separation,
    .in_certificates = shares};

extern const GateLevel feature_level = {
    .usage = "feature[=D]",
    .meaning = "no wrong feature; with D, none but where the centre is within D of the scene of its region",
    .sentence = feature_sentence,
    .judge = judge_feature,
    .in_certificates = shares};

extern const GateLevel normal_level = {
    .usage = "normal=DEG",
    .meaning = "no normal off by more than DEG degrees, where there is a single exact one, and none missing",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("no normal that is missing, or off by more than {} degrees",
                             number_argument(asked, angle_bound));
        },
    .judge = judge_normal,
    .in_certificates = degrees};

extern const GateLevel unit_level = {.usage = "unit=E",
                                     .meaning = "no normal that is longer or shorter than 1 by more than E",
                                     .sentence =
                                         [](const AskedLevel& asked) {
                                           return fmt::format(
                                               "no normal that is longer or shorter than 1 by more than {}",
                                               number_argument(asked, length_bound));
                                         },
                                     .judge = judge_unit,
                                     .in_certificates = shares};

extern const GateLevel no_flip_level = {
    "no-flip", "no normal to the other side, along which a push by the depth does not part the two",
    [](const AskedLevel&) { return std::string("no normal to the other side"); }, judge_no_flip};

extern const GateLevel left_level = {
    .usage = "left=F",
    .meaning = "no normal along which a push by the exact depth leaves more than F of it",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("no normal along which a push by the exact depth leaves more than {} of it",
                             number_argument(asked, left_bound));
        },
    .judge = judge_left,
    .in_certificates = shares};

extern const GateLevel point_level = {
    .usage = "point=D",
    .meaning = "no point of contact off by more than D of the scene, and none missing",
    .sentence =
        [](const AskedLevel& asked) {
          return fmt::format("no point of contact that is missing, or off by more than {} of the scene",
                             number_argument(asked, scene_bound));
        },
    .judge = judge_point,
    .in_certificates = shares};

}  // namespace axiscert
