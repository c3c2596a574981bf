// The least or greatest measured value and its position: the same one in whatever order results are merged.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/numbers/rational.h"

namespace axiscert {

struct MeasuredValue {
  Decimal6 value;
  std::uint64_t position;
  bool operator==(const MeasuredValue&) const = default;
};

// Among equal values the one at the earlier position is kept.
inline void keep_greatest(std::optional<MeasuredValue>& kept, const MeasuredValue& other) {
  if (!kept || other.value > kept->value || (other.value == kept->value && other.position < kept->position)) {
    kept = other;
  }
}
inline void keep_least(std::optional<MeasuredValue>& kept, const MeasuredValue& other) {
  if (!kept || other.value < kept->value || (other.value == kept->value && other.position < kept->position)) {
    kept = other;
  }
}

// How two are merged.
struct GreatestMeasured {
  static void merge(std::optional<MeasuredValue>& kept, const std::optional<MeasuredValue>& other) {
    if (other) keep_greatest(kept, *other);
  }
};
struct LeastMeasured {
  static void merge(std::optional<MeasuredValue>& kept, const std::optional<MeasuredValue>& other) {
    if (other) keep_least(kept, *other);
  }
};

}  // namespace axiscert
