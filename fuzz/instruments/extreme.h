// The least or greatest measured value and its position: the same one in whatever order results are merged.
#pragma once

#include <cstdint>
#include <optional>

#include "exact/numbers/decimal6.h"

namespace axiscert {

struct Measured {
  Decimal6 value;
  std::uint64_t position;
  bool operator==(const Measured&) const = default;
};

// Among equal values the one at the earlier position is kept.
inline void keep_greatest(std::optional<Measured>& kept, const Measured& other) {
  if (!kept || other.value > kept->value || (other.value == kept->value && other.position < kept->position)) {
    kept = other;
  }
}
inline void keep_least(std::optional<Measured>& kept, const Measured& other) {
  if (!kept || other.value < kept->value || (other.value == kept->value && other.position < kept->position)) {
    kept = other;
  }
}

// How two are merged.
struct GreatestMeasured {
  static void merge(std::optional<Measured>& kept, const std::optional<Measured>& other) {
    if (other) keep_greatest(kept, *other);
  }
};
struct LeastMeasured {
  static void merge(std::optional<Measured>& kept, const std::optional<Measured>& other) {
    if (other) keep_least(kept, *other);
  }
};

}  // namespace axiscert
