// Scenes in which the exact answer turns at a known place: a path from a query to a query, along which one length
// grows.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/base/geometry.h"
#include "kernel/kernel.h"
#include "kernel/query.h"

namespace axiscert {

// A length of the scene that a slack may be a part of.
struct SceneLength {
  std::string_view name;  // "r", after "1e-4"
  double length = 0;      // 0: the scene has none of it, and shows no part of it
};

// The queries base + x step, x > 0, of which every number is in double and is rounded to the query's precision. The
// exact answer turns at x = 1, but for what rounding and the making of the scene do to it: slacks are far above that,
// and both sides are asked of the oracles.
struct SlackScene {
  // The queries in words, after "on 61 of 64 queries": all that change in one way, "nearest to any feature"; those of
  // them that one kind of feature decides, "nearest to an edge"; and one feature alone, "nearest to edge ab".
  std::string_view path, kind, part;
  Numbers<double> base, step;
  double unit = 1;                  // the length by which the two come nearer where x grows by 1
  double greatest = 4;              // x up to which is asked; from 1 / 4 on
  bool turns_to_separated = false;  // where x grows: else to contact
  double scene = 1;                 // the greatest coordinate and length
  double apart = 1;                 // the length that formulae may take for the difference of squares of the scene
  std::array<SceneLength, 2> lengths = {};  // those without a name are none
};

// Those of a predicate. None in an entry that has no such scenes.
struct SlackScenes {
  std::vector<SlackScene> (*make)(std::size_t entry, Precision precision, std::uint64_t seed);
};

// Parts of scenes.
using ScenePoint = portable::Vec3<double>;
inline double norm_of(const ScenePoint& v) { return std::sqrt(dot(v, v)); }
inline ScenePoint unit_of(const ScenePoint& v) { return v / norm_of(v); }
inline double greatest_of(const ScenePoint& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
inline void put(Numbers<double>& numbers, std::size_t first, const ScenePoint& v) {
  numbers[first] = v.x;
  numbers[first + 1] = v.y;
  numbers[first + 2] = v.z;
}
inline Numbers<double> zeros(std::size_t count) {
  Numbers<double> numbers(count);
  std::fill(numbers.begin(), numbers.end(), 0.0);
  return numbers;
}

}  // namespace axiscert
