// What is wrong with the numbers that a kernel gives beside its verdict on one query.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "exact/judge/contact_judgement.h"
#include "fuzz/record/contact_tally.h"
#include "kernel/base/enums.h"
#include "kernel/predicate.h"

namespace axiscert {

// The worst first.
enum class MeasureFault : std::uint8_t {
  no_time,
  late_time,
  inconsistent,
  flip,
  feature,
  early_time,
  separation,
  normal,
  left,
  length,
  point,
  point_a,
  point_b,
  points
};
template <>
inline constexpr std::size_t enum_count<MeasureFault> = 14;
inline constexpr EnumArray<MeasureFault, std::string_view> measure_fault_names = {"no time",
                                                                                  "late time",
                                                                                  "numbers that contradict each other",
                                                                                  "normal to the other side",
                                                                                  "wrong feature",
                                                                                  "early time",
                                                                                  "separation",
                                                                                  "normal",
                                                                                  "penetration left along the normal",
                                                                                  "length of the normal",
                                                                                  "point",
                                                                                  "point of the first body",
                                                                                  "point of the second body",
                                                                                  "points and separation"};
constexpr std::string_view name(MeasureFault which) { return measure_fault_names[which]; }
// As --what has them, and a search its aims: those of the levels that they are for.
inline constexpr EnumArray<MeasureFault, std::string_view> measure_fault_words = {
    "no-time", "late", "inconsistent", "flip",  "feature", "early",   "separation",
    "normal",  "left", "unit",         "point", "point_a", "point_b", "points"};
constexpr std::string_view word(MeasureFault which) { return measure_fault_words[which]; }

// What the faults are of, as --what has it: the kind of the measure.
MeasureKind measure_of(MeasureFault which);
// Whether a kernel with so many of the predicate's measures can have it.
bool can_have(const Predicate& predicate, std::size_t measure_count, MeasureFault which);
// Those of a predicate's measures that are judged, each once; and the words of their faults.
std::vector<std::string_view> judged_measures(const Predicate& predicate);
std::vector<std::string_view> fault_words(const Predicate& predicate);
// Whether a fault is of that measure, or is the one of that word.
bool is_named(MeasureFault which, std::string_view what);

// By how much it is off: a time in u of the displacement, a normal in radians, its length, what is left of a
// penetration as a share of it, all else as shares of the scene; of numbers that contradict each other, 0.
struct MeasureError {
  double size;
  std::string text;  // "late by 2.5 ulps"
  Decimal6 rounded;  // the size, up; of what is left as it was judged
};
std::string_view unit_of(MeasureFault which);  // of the size: "of the scene"
// Whether the fault could be seen: the answer has what it is of, and that was compared.
bool is_judged(const ContactJudgement& judgement, MeasureFault which);
// Empty where the judgement does not have the fault.
std::optional<MeasureError> measure_error(const ContactJudgement& judgement, MeasureFault which);

// The queries with the greatest errors that a run counted, by position; none of faults that have no size.
struct CountedFault {
  double size;
  std::uint64_t position;
};
std::vector<CountedFault> worst_counted(const ContactTally& tally, MeasureFault which);
// The answers of that run of which is_judged() holds.
std::uint64_t judged_counted(const ContactTally& tally, MeasureFault which);

}  // namespace axiscert
