#include "fuzz/shrink/measure_fault.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fuzz/record/contact_tally.h"

namespace axiscert {
namespace {

std::optional<MeasureError> time_error(const ContactJudgement& judgement, TimeVerdict which) {
  if (judgement.time != which) return std::nullopt;
  return MeasureError{
      judgement.in_u.value(),
      fmt::format("{} by {}", name(which), time_error_text(judgement.ulps, judgement.share, judgement.length))};
}

std::optional<MeasureError> above_zero(const std::optional<double>& error, std::string_view unit) {
  if (!error || *error == 0) return std::nullopt;
  return MeasureError{*error, fmt::format("off by {:.6g} {}", *error, unit)};
}

std::optional<MeasureError> left_error(const Pushed& pushed) {
  if (pushed.left.is_zero()) return std::nullopt;
  return MeasureError{pushed.left.value(), fmt::format("{} of the depth is left", pushed.left.text())};
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

std::vector<std::string_view> judged_measures(const Predicate& predicate) {
  std::vector<std::string_view> names;
  for (const MeasureKind kind : enumerators<MeasureKind>) {
    if (kind != MeasureKind::other && has_measure(predicate, kind)) names.push_back(name(kind));
  }
  return names;
}

std::optional<MeasureError> measure_error(const ContactJudgement& judgement, MeasureFault which) {
  switch (which) {
    case MeasureFault::no_time:
      if (judgement.time == TimeVerdict::none) return MeasureError{0, "a contact without a time"};
      if (judgement.time == TimeVerdict::invalid) return MeasureError{0, "a time outside [0, 1]"};
      return std::nullopt;
    case MeasureFault::late_time:
      return time_error(judgement, TimeVerdict::late);
    case MeasureFault::early_time:
      return time_error(judgement, TimeVerdict::early);
    case MeasureFault::feature: {
      if (judgement.feature_is_right.value_or(true)) return std::nullopt;
      const double error = judgement.feature_error.value_or(0);
      if (std::isinf(error)) return MeasureError{std::numeric_limits<double>::max(), "a feature that there is not"};
      return MeasureError{error, fmt::format("off by {:.6g} of the scene", error)};
    }
    case MeasureFault::normal:
      return above_zero(judgement.normal_angle, "radians");
    case MeasureFault::length:
      return above_zero(judgement.normal_length_error, "of 1");
    case MeasureFault::point:
      return above_zero(judgement.point_error, "of the scene");
    case MeasureFault::point_a:
      return above_zero(judgement.point_a_error, "of the scene");
    case MeasureFault::point_b:
      return above_zero(judgement.point_b_error, "of the scene");
    case MeasureFault::points:
      return above_zero(judgement.points_apart, "of the scene");
    case MeasureFault::inconsistent:
      if (judgement.consistency.value_or(Consistency::consistent) == Consistency::consistent) return std::nullopt;
      return MeasureError{0, std::string(consistency_words[*judgement.consistency])};
    case MeasureFault::separation:
      if (!judgement.separation) return std::nullopt;
      return above_zero(judgement.separation->share, "of the scene");
    case MeasureFault::flip:
      return judgement.pushed && judgement.pushed->is_flip ? left_error(*judgement.pushed) : std::nullopt;
    case MeasureFault::left:
      return judgement.pushed ? left_error(*judgement.pushed) : std::nullopt;
  }
  return std::nullopt;
}

}  // namespace axiscert
