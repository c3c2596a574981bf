// Images of a query of any predicate by the roles and groups of its columns: nothing is rounded but where a sum is that
// the caller has to leave room for.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

#include "kernel/base/geometry.h"
#include "kernel/names.h"
#include "kernel/predicate.h"

namespace axiscert::exact_images {

// Whether the columns from `first` on are the three of a place or a direction.
inline bool is_vector(const PredicateEntry& entry, std::size_t first) {
  const auto& columns = entry.columns;
  const auto is_role = [&](std::size_t k) {
    return columns[k].role == Role::coordinate || columns[k].role == Role::direction;
  };
  return first + 3 <= columns.size() && is_role(first) && columns[first].group == columns[first + 1].group &&
         columns[first].group == columns[first + 2].group;
}

// Coordinate i of every vector of the image is coordinate axes[i] of the original, negated if bit i of `signs` is set.
template <class Real>
Numbers<Real> with_axes(const Numbers<Real>& numbers, const PredicateEntry& entry,
                        const std::array<std::uint8_t, 3>& axes, std::uint8_t signs) {
  Numbers<Real> image = numbers;
  for (std::size_t k = 0; k < numbers.size(); k += is_vector(entry, k) ? 3 : 1) {
    if (!is_vector(entry, k)) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const Real x = numbers[k + axes[i]];
      image[k + i] = has_bit(signs, i) ? -x : x;
    }
  }
  return image;
}

// Vertex i of the image is vertex order[i] of the original; the vertices are the first three groups of three columns.
template <class Real>
Numbers<Real> with_order(const Numbers<Real>& numbers, const std::array<std::uint8_t, 3>& order) {
  Numbers<Real> image = numbers;
  for (std::size_t v = 0; v < 3; ++v) {
    for (std::size_t i = 0; i < 3; ++i) image[3 * v + i] = numbers[3 * std::size_t{order[v]} + i];
  }
  return image;
}

// Every place moved; directions and lengths stay. One rounding a coordinate.
template <class Real>
Numbers<Real> moved(const Numbers<Real>& numbers, const PredicateEntry& entry, const portable::Vec3<Real>& by) {
  Numbers<Real> image = numbers;
  const std::array<Real, 3> step = {by.x, by.y, by.z};
  for (std::size_t k = 0; k < numbers.size(); k += is_vector(entry, k) ? 3 : 1) {
    if (!is_vector(entry, k) || entry.columns[k].role != Role::coordinate) continue;
    for (std::size_t i = 0; i < 3; ++i) image[k + i] = numbers[k + i] + step[i];
  }
  return image;
}

}  // namespace axiscert::exact_images
