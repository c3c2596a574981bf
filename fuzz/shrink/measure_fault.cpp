#include "fuzz/shrink/measure_fault.h"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "fuzz/record/motion_tally.h"

namespace axiscert {
namespace {

std::optional<MeasureError> time_error(const MotionJudgement& judgement, TimeVerdict which) {
  if (judgement.time != which) return std::nullopt;
  return MeasureError{
      judgement.in_u.value(),
      fmt::format("{} by {}", name(which), time_error_text(judgement.ulps, judgement.share, judgement.length))};
}

std::optional<MeasureError> above_zero(const std::optional<double>& error, std::string_view unit) {
  if (!error || *error == 0) return std::nullopt;
  return MeasureError{*error, fmt::format("off by {:.6g} {}", *error, unit)};
}

}  // namespace

std::string_view measure_of(MeasureFault which) {
  switch (which) {
    case MeasureFault::no_time:
    case MeasureFault::late_time:
    case MeasureFault::early_time:
      return measure_names[0];
    case MeasureFault::feature:
      return measure_names[1];
    case MeasureFault::normal:
    case MeasureFault::length:
      return measure_names[2];
    case MeasureFault::point:
      return measure_names[3];
  }
  return "";
}

std::optional<MeasureError> measure_error(const MotionJudgement& judgement, MeasureFault which) {
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
  }
  return std::nullopt;
}

}  // namespace axiscert
