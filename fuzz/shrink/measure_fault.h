// What is wrong with the numbers that a kernel gives beside a contact, of a predicate of motions, on one query.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "exact/judge/motion_judgement.h"
#include "kernel/base/enums.h"

namespace axiscert {

// The worst first.
enum class MeasureFault : std::uint8_t { no_time, late_time, feature, early_time, normal, length, point };
template <>
inline constexpr std::size_t enum_count<MeasureFault> = 7;
inline constexpr EnumArray<MeasureFault, std::string_view> measure_fault_names = {
    "no time", "late time", "wrong feature", "early time", "normal", "length of the normal", "point"};
constexpr std::string_view name(MeasureFault which) { return measure_fault_names[which]; }

// What the faults are of, as --what has it.
inline constexpr std::string_view measure_names[] = {"time", "feature", "normal", "point"};
std::string_view measure_of(MeasureFault which);

// By how much it is off: a time in u of the displacement, a normal in radians, its length, a feature and a point as
// shares of the scene.
struct MeasureError {
  double size;
  std::string text;  // "late by 2.5 ulps"
};
// Empty where the judgement does not have the fault.
std::optional<MeasureError> measure_error(const MotionJudgement& judgement, MeasureFault which);

}  // namespace axiscert
