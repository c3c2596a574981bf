#include "kernel/permitted/recording.h"

#include "kernel/base/error.h"

namespace axiscert::permitted {

std::size_t comparison_index(Recording& recording, Value lhs, Value rhs, bool nonstrict) {
  auto& sides = recording.sides;
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i] == std::pair(lhs, rhs) && has_bit(recording.nonstrict, i) == nonstrict) return i;
  }
  if (sides.size() == most_comparisons) throw HarnessFault("a method of too many comparisons to try its ways");
  recording.nonstrict |= bit_if<ComparisonBits>(nonstrict, sides.size());
  sides.emplace_back(lhs, rhs);
  return sides.size() - 1;
}

Recorder recorder_of(const Kernel& kernel) {
  for (const auto room : {sphere_triangle_recorder, moving_sphere_recorder, capsule_triangle_recorder, box_recorder}) {
    if (const Recorder found = room(kernel)) return found;
  }
  return {};
}

}  // namespace axiscert::permitted
