#include "fuzz/record/measure_fault.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

namespace axiscert {
namespace {

std::optional<MeasureError> time_error(const ContactJudgement& judgement, TimeVerdict which) {
  if (judgement.time != which) return std::nullopt;
  return MeasureError{
      judgement.in_u.value(),
      fmt::format("{} by {}", name(which), time_error_text(judgement.ulps, judgement.share, judgement.length)),
      judgement.in_u};
}

MeasureError sized(double size, std::string text) {
  return {size, std::move(text), std::isfinite(size) ? round_up(exact(size)) : Decimal6()};
}

std::optional<MeasureError> above_zero(const std::optional<double>& error, std::string_view unit) {
  if (!error || *error == 0) return std::nullopt;
  return sized(*error, fmt::format("off by {:.6g} {}", *error, unit));
}

std::optional<MeasureError> left_error(const Pushed& pushed) {
  if (pushed.left.is_zero()) return std::nullopt;
  return MeasureError{pushed.left.value(), fmt::format("{} of the depth is left", pushed.left.text()), pushed.left};
}

}  // namespace

MeasureKind measure_of(MeasureFault which) {
  switch (which) {
    case MeasureFault::no_time:
    case MeasureFault::late_time:
    case MeasureFault::early_time:
      return MeasureKind::time;
    case MeasureFault::inconsistent:
    case MeasureFault::separation:
    case MeasureFault::points:
      return MeasureKind::separation;
    case MeasureFault::feature:
      return MeasureKind::feature;
    case MeasureFault::flip:
    case MeasureFault::normal:
    case MeasureFault::left:
    case MeasureFault::length:
      return MeasureKind::normal;
    case MeasureFault::point:
      return MeasureKind::point;
    case MeasureFault::point_a:
      return MeasureKind::point_a;
    case MeasureFault::point_b:
      return MeasureKind::point_b;
  }
  return MeasureKind::other;
}

bool can_have(const Predicate& predicate, std::size_t measure_count, MeasureFault which) {
  const bool is_of_points = which == MeasureFault::points;
  return gives_measure(predicate, measure_count, is_of_points ? MeasureKind::point_b : measure_of(which));
}

std::string_view unit_of(MeasureFault which) {
  if (measure_of(which) == MeasureKind::time) return "u of the displacement";
  if (which == MeasureFault::normal) return "radians";
  if (which == MeasureFault::flip || which == MeasureFault::left) return "of the depth";
  return which == MeasureFault::length ? "of 1" : "of the scene";
}

std::vector<std::string_view> judged_measures(const Predicate& predicate) {
  std::vector<std::string_view> names;
  for (const MeasureKind kind : enumerators<MeasureKind>) {
    if (kind != MeasureKind::other && has_measure(predicate, kind)) names.push_back(name(kind));
  }
  return names;
}

std::vector<std::string_view> fault_words(const Predicate& predicate) {
  std::vector<std::string_view> words;
  for (const MeasureFault which : enumerators<MeasureFault>) {
    if (can_have(predicate, predicate.measures.size(), which)) words.push_back(word(which));
  }
  return words;
}

bool is_named(MeasureFault which, std::string_view what) {
  return word(which) == what || name(measure_of(which)) == what;
}

bool is_judged(const ContactJudgement& judgement, MeasureFault which) {
  switch (which) {
    case MeasureFault::no_time:
    case MeasureFault::late_time:
    case MeasureFault::early_time:
      return judgement.time.has_value();
    case MeasureFault::inconsistent:
      return judgement.consistency.has_value();
    case MeasureFault::flip:
    case MeasureFault::left:
      return judgement.pushed.has_value();
    case MeasureFault::feature:
      return judgement.feature_is_right.has_value();
    case MeasureFault::separation:
      return judgement.separation.has_value();
    case MeasureFault::normal:
      return judgement.normal_angle.has_value();
    case MeasureFault::length:
      return judgement.normal_length_error.has_value();
    case MeasureFault::point:
      return judgement.point_error.has_value();
    case MeasureFault::point_a:
      return judgement.point_a_error.has_value();
    case MeasureFault::point_b:
      return judgement.point_b_error.has_value();
    case MeasureFault::points:
      return judgement.points_apart.has_value();
  }
  return false;
}

std::optional<MeasureError> measure_error(const ContactJudgement& judgement, MeasureFault which) {
  switch (which) {
    case MeasureFault::no_time:
      if (judgement.time == TimeVerdict::none) return sized(0, "a contact without a time");
      if (judgement.time == TimeVerdict::invalid) return sized(0, "a time outside [0, 1]");
      return std::nullopt;
    case MeasureFault::late_time:
      return time_error(judgement, TimeVerdict::late);
    case MeasureFault::early_time:
      return time_error(judgement, TimeVerdict::early);
    case MeasureFault::feature: {
      if (judgement.feature_is_right.value_or(true)) return std::nullopt;
      const double error = judgement.feature_error.value_or(0);
      if (std::isinf(error)) return sized(std::numeric_limits<double>::max(), "a feature that there is not");
      return sized(error, fmt::format("off by {:.6g} of the scene", error));
    }
    case MeasureFault::normal:
      return above_zero(judgement.normal_angle, unit_of(which));
    case MeasureFault::length:
      return above_zero(judgement.normal_length_error, unit_of(which));
    case MeasureFault::point:
      return above_zero(judgement.point_error, unit_of(which));
    case MeasureFault::point_a:
      return above_zero(judgement.point_a_error, unit_of(which));
    case MeasureFault::point_b:
      return above_zero(judgement.point_b_error, unit_of(which));
    case MeasureFault::points:
      return above_zero(judgement.points_apart, unit_of(which));
    case MeasureFault::inconsistent:
      if (judgement.consistency.value_or(Consistency::consistent) == Consistency::consistent) return std::nullopt;
      return sized(0, std::string(consistency_words[*judgement.consistency]));
    case MeasureFault::separation:
      if (!judgement.separation) return std::nullopt;
      if (const auto& less = judgement.separation_less_margin; less && less->share < judgement.separation->share)
        return above_zero(less->share, unit_of(which));
      return above_zero(judgement.separation->share, unit_of(which));
    case MeasureFault::flip:
      return judgement.pushed && judgement.pushed->is_flip ? left_error(*judgement.pushed) : std::nullopt;
    case MeasureFault::left:
      return judgement.pushed ? left_error(*judgement.pushed) : std::nullopt;
  }
  return std::nullopt;
}

namespace {

template <class Rank>
std::vector<CountedFault> counted(const Leaders<Rank>& leaders) {
  std::vector<CountedFault> all;
  for (const auto& [rank, position] : leaders.candidates()) {
    if constexpr (std::is_same_v<Rank, Decimal6>) all.push_back({rank.value(), position});
    else all.push_back({rank, position});
  }
  return all;
}

template <class Part, class Rank>
std::vector<CountedFault> counted(const std::optional<Part>& part, Leaders<Rank> Part::*leaders) {
  return part ? counted((*part).*leaders) : std::vector<CountedFault>();
}

}  // namespace

std::vector<CountedFault> worst_counted(const ContactTally& tally, MeasureFault which) {
  switch (which) {
    case MeasureFault::late_time:
      return tally.time ? counted(tally.time->late_errors.largest_in_u) : std::vector<CountedFault>();
    case MeasureFault::early_time:
      return tally.time ? counted(tally.time->early_errors.largest_in_u) : std::vector<CountedFault>();
    case MeasureFault::separation:
      return counted(tally.separation, &SeparationTally::largest_error);
    case MeasureFault::feature:
      return counted(tally.feature, &FeatureTally::largest_error);
    case MeasureFault::normal:
      return counted(tally.normal, &NormalTally::largest_angle);
    case MeasureFault::length:
      return counted(tally.normal, &NormalTally::largest_length_error);
    case MeasureFault::flip:
    case MeasureFault::left:
      return counted(tally.pushed, &PushTally::largest_left);
    case MeasureFault::point:
      return counted(tally.point, &PointTally::largest_error);
    case MeasureFault::point_a:
      return counted(tally.point_a, &PointTally::largest_error);
    case MeasureFault::point_b:
      return counted(tally.point_b, &PointTally::largest_error);
    case MeasureFault::points:
      return counted(tally.points, &PointsTally::largest_error);
    case MeasureFault::no_time:
    case MeasureFault::inconsistent:
      return {};
  }
  return {};
}

std::uint64_t judged_counted(const ContactTally& tally, MeasureFault which) {
  const auto judged = [](const auto& part) { return part ? part->judged : std::uint64_t{0}; };
  switch (which) {
    case MeasureFault::no_time:
    case MeasureFault::late_time:
    case MeasureFault::early_time:
      return tally.time ? tally.answers : 0;
    case MeasureFault::inconsistent:
      return judged(tally.consistency);
    case MeasureFault::flip:
    case MeasureFault::left:
      return judged(tally.pushed);
    case MeasureFault::feature:
      return judged(tally.feature);
    case MeasureFault::separation:
      return judged(tally.separation);
    case MeasureFault::normal:
      return judged(tally.normal);
    case MeasureFault::length:
      return tally.normal ? tally.normal->lengths : 0;
    case MeasureFault::point:
      return judged(tally.point);
    case MeasureFault::point_a:
      return judged(tally.point_a);
    case MeasureFault::point_b:
      return judged(tally.point_b);
    case MeasureFault::points:
      return judged(tally.points);
  }
  return 0;
}

}  // namespace axiscert
