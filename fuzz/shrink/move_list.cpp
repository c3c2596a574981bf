// The moves in the order in which they are tried.
#include <algorithm>
#include <limits>

#include "fuzz/shrink/shrink_moves.h"

namespace axiscert {

template <class Real>
std::vector<Move> moves(const QueryShape& shape) {
  using enum MoveKind;
  constexpr int digits = std::numeric_limits<Real>::digits;
  const auto numbers = static_cast<int>(shape.numbers), axes = static_cast<int>(shape.axes),
             points = static_cast<int>(shape.points.size()), vertices = static_cast<int>(shape.vertices()),
             directions = static_cast<int>(shape.directions.size());
  std::vector<Move> all;
  const auto add = [&](MoveKind kind, int i, int j = 0) { all.push_back({kind, i, j}); };
  // The last first: from there the query is seen.
  const auto last_first = [](int count, auto&& visit) {
    for (int k = 0; k < count; ++k) visit((k + count - 1) % count);
  };
  last_first(axes + 1, [&](int axis) { last_first(points, [&](int point) { add(translate, point, axis); }); });
  for (int i = 0; i < static_cast<int>(shape.frames.size()); ++i) {
    add(into_frame, i);
    add(upright, i);
    for (int j = 0; j < static_cast<int>(shape.frames.size()); ++j) {
      if (i != j) add(copy_frame, i, j);
    }
  }
  for (int axis = 0; axis < axes; ++axis) add(flatten, axis);
  for (int i = 0; i < directions; ++i) add(zero_direction, i);
  for (int distance = 0; distance < numbers; ++distance) {
    for (int i = 0; i + distance < numbers; ++i) add(zero, i, i + distance);
  }
  for (int bits = 1; bits < digits; ++bits) add(round_all, bits);
  for (int i = 0; i < vertices; ++i) {
    for (int j = 0; j < points; ++j) {
      if (i != j) add(copy_point, i, j);
    }
  }
  for (int i = 0; i < vertices; ++i) {
    for (int j = 1 - 7 * vertices; j < 7 * vertices; ++j) add(align, i, j);
  }
  for (int i = 0; i < directions; ++i) {
    for (const int power : {0, -1, -2}) add(along, i, power);
    add(reverse, i);
    for (int j = 0; j < points * points; ++j) {
      if (j / points != j % points) add(between, i, j);
    }
  }
  for (int i = 0; i < numbers; ++i) add(scale_all, i);
  for (int i = 0; i < numbers; ++i) {
    for (int bits = 1; bits < digits; ++bits) {
      add(round_down, i, bits);
      add(round_up, i, bits);
    }
  }
  for (int i = 0; i < numbers; ++i) {
    for (int j = 0; j < numbers; ++j) {
      if (i == j) continue;
      add(copy, i, j);
      add(copy_negated, i, j);
    }
  }
  for (int i = 0; i < numbers; ++i) {
    for (int j = -numbers; j < numbers; ++j) {
      if ((j < 0 ? -1 - j : j) == i) continue;
      add(trade_down, i, j);
      add(trade_up, i, j);
    }
  }
  for (const int power : {-16, 16, -4, 4, -1, 1}) {
    for (int vertex = 0; vertex < vertices; ++vertex) add(scale_point, vertex, power);
    for (int i = 0; i < directions; ++i) add(scale_direction, i, power);
    for (int axis = 0; axis < axes; ++axis) add(scale_axis, axis, power);
  }
  for (int i = 0; i < numbers; ++i) {
    add(centre, i);
    for (const int power : {-16, 16, -4, 4, -1, 1}) add(scale, i, power);
  }
  for (int axis = 0; axis < axes; ++axis) add(reflect, axis);
  for (int i = 0; i < numbers; ++i) add(negate, i);
  for (int i = 0; i < std::max(axes, vertices); ++i) {
    for (int j = 0; j < i; ++j) {
      if (i < axes) add(swap_axes, i, j);
      if (i < vertices) add(swap_points, i, j);
    }
  }
  return all;
}
template std::vector<Move> moves<float>(const QueryShape&);
template std::vector<Move> moves<double>(const QueryShape&);

std::vector<Move> nudges(const QueryShape& shape) {
  std::vector<Move> all;
  for (int i = 0; i < static_cast<int>(shape.numbers); ++i) {
    for (const int floats : {-16, -4, -2, -1, 1, 2, 4, 16}) all.push_back({MoveKind::nudge, i, floats});
  }
  return all;
}

}  // namespace axiscert
