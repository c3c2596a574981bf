#include "fuzz/shrink/shrink_moves.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fuzz/queries/floats.h"
#include "fuzz/shrink/query_properties.h"

namespace axiscert {
namespace {

// x rounded to `bits` significant bits; empty if it has no more than that.
template <class Real>
std::optional<Real> rounded(Real x, int bits, bool away_from_zero) {
  if (x == 0) return std::nullopt;
  const auto [digits, exponent] = binary_digits(x);
  const int surplus = static_cast<int>(std::bit_width(digits)) - bits;
  if (surplus <= 0) return std::nullopt;
  const std::uint64_t kept = (digits >> surplus) + away_from_zero;
  return std::copysign(static_cast<Real>(std::ldexp(static_cast<double>(kept), exponent + surplus)), x);
}

// The unit of x's last significant bit.
template <class Real>
Real last_unit(Real x) {
  return x == 0 ? Real(0) : std::ldexp(Real(1), binary_digits(x).exponent);
}

template <class Real>
bool round_all(Numbers<Real>& v, int bits) {
  bool changed = false;
  for (Real& x : v) {
    const auto down = rounded(x, bits, false), up = rounded(x, bits, true);
    if (!down) continue;
    x = std::fabs(x - *down) < std::fabs(*up - x) ? *down : *up;
    changed = true;
  }
  return changed;
}

// A move at work on the numbers of one query.
template <class Real>
class QueryMover {
 public:
  QueryMover(const QueryShape& shape, Numbers<Real>& v) : shape_(shape), v_(v) {}

  // Whether the move has a meaning.
  bool apply(const Move& move);

 private:
  Real& number(int k) { return v_[static_cast<std::size_t>(k)]; }
  Real& point(int i, std::size_t axis) { return v_[shape_.points[static_cast<std::size_t>(i)] + axis]; }
  Real& direction(int i, std::size_t axis) { return v_[shape_.directions[static_cast<std::size_t>(i)] + axis]; }
  bool is_length(int k) const { return shape_.is_length[static_cast<std::size_t>(k)]; }
  int exponent(int k) { return number(k) == 0 ? 0 : std::ilogb(number(k)); }
  int last() const { return static_cast<int>(shape_.vertices()); }

  // change(i) for the first number of each point, and then of each direction.
  template <class Change>
  void for_each_point(Change&& change) {
    for (const std::size_t first : shape_.points) change(first);
  }
  template <class Change>
  void for_each_point_and_direction(Change&& change) {
    for_each_point(change);
    for (const std::size_t first : shape_.directions) change(first);
  }
  template <class Change>
  void for_each_on_axis(int axis, Change&& change) {
    for_each_point_and_direction([&](std::size_t first) { change(v_[first + static_cast<std::size_t>(axis)]); });
  }
  std::size_t frame(int i) const { return shape_.frames[static_cast<std::size_t>(i)]; }
  void make_upright(std::size_t first) {
    for (std::size_t k = 0; k < 9; ++k) v_[first + k] = k % 4 == 0 ? Real(1) : Real(0);
  }
  bool move_into_frame(std::size_t first);
  bool translate(int i, int axis);
  bool align(int i, int from, int power, bool is_beyond);
  bool trade(const Move& move);

  const QueryShape& shape_;
  Numbers<Real>& v_;
};

template <class Real>
bool QueryMover<Real>::translate(int i, int along) {
  for (std::size_t axis = 0; axis < shape_.axes; ++axis) {
    const Real by = point(i, axis);
    if (along != static_cast<int>(axis) && along != static_cast<int>(shape_.axes)) continue;
    for_each_point([&](std::size_t first) { v_[first + axis] -= by; });
  }
  return true;
}

template <class Real>
bool QueryMover<Real>::move_into_frame(std::size_t first) {
  std::array<double, 9> axes;
  for (std::size_t k = 0; k < 9; ++k) axes[k] = static_cast<double>(v_[first + k]);
  const auto turn = [&](std::size_t at, const std::array<double, 3>& from) {
    std::array<double, 3> turned;
    for (std::size_t k = 0; k < 3; ++k) {
      turned[k] = 0;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        turned[k] += axes[3 * k + axis] * (static_cast<double>(v_[at + axis]) - from[axis]);
      }
    }
    for (std::size_t k = 0; k < 3; ++k) v_[at + k] = static_cast<Real>(turned[k]);
  };
  std::array<double, 3> origin;
  for (std::size_t axis = 0; axis < 3; ++axis) origin[axis] = static_cast<double>(v_[shape_.points.front() + axis]);
  for_each_point([&](std::size_t at) { turn(at, origin); });
  for (const std::size_t other : shape_.frames) {
    if (other == first) continue;
    for (std::size_t k = 0; k < 9; k += 3) turn(other + k, {0, 0, 0});
    make_rotation(v_, other);
  }
  make_upright(first);
  return true;
}

template <class Real>
bool QueryMover<Real>::align(int i, int from, int power, bool is_beyond) {
  if (from == i) return false;
  for (std::size_t axis = 0; axis < shape_.axes; ++axis) {
    const Real p = point(last(), axis), x = std::ldexp(point(from, axis) - p, power);
    point(i, axis) = (is_beyond ? -x : x) + p;
  }
  return true;
}

template <class Real>
bool QueryMover<Real>::trade(const Move& move) {
  const int i = move.i, j = move.j;
  if (number(i) == 0) return false;
  const auto bits = static_cast<int>(std::bit_width(binary_digits(number(i)).digits));
  const auto x = rounded(number(i), bits - 1, move.kind == MoveKind::trade_up);
  const int other = j < 0 ? -1 - j : j;
  if (!x || bits < 2) return false;
  number(i) = *x;
  number(other) += j < 0 ? -last_unit(number(other)) : last_unit(number(other));
  return true;
}

template <class Real>
bool QueryMover<Real>::apply(const Move& move) {
  const int i = move.i, j = move.j, vertices = last();
  switch (move.kind) {
    case MoveKind::translate:
      return translate(i, j);
    case MoveKind::zero:
      number(i) = number(j) = 0;
      return true;
    case MoveKind::flatten:
      for_each_on_axis(i, [](Real& x) { x = 0; });
      return true;
    case MoveKind::round_all:
      return round_all(v_, i);
    case MoveKind::copy_point:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) point(i, axis) = point(j, axis);
      return true;
    case MoveKind::align:
      return align(i, std::abs(j) % vertices, std::abs(j) / vertices - 3, j < 0);
    case MoveKind::copy:
      number(i) = is_length(i) ? std::fabs(number(j)) : number(j);
      return true;
    case MoveKind::copy_negated:
      number(i) = -number(j);
      return !is_length(i);
    case MoveKind::scale_all: {
      const int power = -exponent(i);
      scale_by_power_of_two(v_, power);
      return power != 0;
    }
    case MoveKind::scale_point:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) {
        const Real p = point(vertices, axis);
        point(i, axis) = std::ldexp(point(i, axis) - p, j) + p;
      }
      return true;
    case MoveKind::scale_axis:
      for_each_on_axis(i, [&](Real& x) { x = std::ldexp(x, j); });
      return true;
    case MoveKind::centre:
      number(i) = std::ldexp(number(i), -exponent(i));
      return true;
    case MoveKind::scale:
      number(i) = std::ldexp(number(i), j);
      return true;
    case MoveKind::round_down:
    case MoveKind::round_up:
      if (const auto x = rounded(number(i), j, move.kind == MoveKind::round_up)) {
        number(i) = *x;
        return true;
      }
      return false;
    case MoveKind::reflect:
      for_each_on_axis(i, [](Real& x) { x = -x; });
      return true;
    case MoveKind::negate:
      number(i) = -number(i);
      return true;
    case MoveKind::swap_axes:
      for_each_point_and_direction([&](std::size_t first) {
        std::swap(v_[first + static_cast<std::size_t>(i)], v_[first + static_cast<std::size_t>(j)]);
      });
      return true;
    case MoveKind::swap_points:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) std::swap(point(i, axis), point(j, axis));
      return true;
    case MoveKind::trade_down:
    case MoveKind::trade_up:
      return trade(move);
    case MoveKind::nudge:
      number(i) = is_length(i) ? step_radius(number(i), j) : step_ulps(number(i), j);
      return true;
    case MoveKind::zero_direction:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) direction(i, axis) = 0;
      return true;
    case MoveKind::scale_direction:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) direction(i, axis) = std::ldexp(direction(i, axis), j);
      return true;
    case MoveKind::along:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) point(vertices, axis) += std::ldexp(direction(i, axis), j);
      return true;
    case MoveKind::reverse:
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) {
        point(vertices, axis) += direction(i, axis);
        direction(i, axis) = -direction(i, axis);
      }
      return true;
    case MoveKind::between: {
      const int from = j / (vertices + 1), to = j % (vertices + 1);
      for (std::size_t axis = 0; axis < shape_.axes; ++axis) direction(i, axis) = point(to, axis) - point(from, axis);
      return true;
    }
    case MoveKind::upright:
      make_upright(frame(i));
      return true;
    case MoveKind::copy_frame:
      for (std::size_t k = 0; k < 9; ++k) v_[frame(i) + k] = v_[frame(j) + k];
      return true;
    case MoveKind::into_frame:
      return move_into_frame(frame(i));
  }
  return false;
}

}  // namespace

template <class Real>
std::optional<Numbers<Real>> moved(const QueryShape& shape, const Numbers<Real>& q, const Move& move) {
  Numbers<Real> v = q;
  if (!QueryMover<Real>(shape, v).apply(move) || !may_be_valid(shape, v)) return std::nullopt;
  return v;
}
template std::optional<Numbers<float>> moved(const QueryShape&, const Numbers<float>&, const Move&);
template std::optional<Numbers<double>> moved(const QueryShape&, const Numbers<double>&, const Move&);

// The moves in the order in which they are tried.

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
