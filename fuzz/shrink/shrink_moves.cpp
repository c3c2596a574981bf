#include "fuzz/shrink/shrink_moves.h"

#include <bit>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "fuzz/queries/boundary.h"
#include "fuzz/shrink/query_size.h"

namespace axiscert {
namespace {

constexpr int points = 4, axes = 3, numbers = static_cast<int>(coordinate_count), radius = numbers - 1;

template <class Real>
using Coordinates = std::array<Real, coordinate_count>;

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
bool round_all(Coordinates<Real>& v, int bits) {
  bool changed = false;
  for (Real& x : v) {
    const auto down = rounded(x, bits, false), up = rounded(x, bits, true);
    if (!down) continue;
    x = std::fabs(x - *down) < std::fabs(*up - x) ? *down : *up;
    changed = true;
  }
  return changed;
}

template <class Real>
void scale_point(Coordinates<Real>& v, int point, int power) {
  for (int axis = 0; axis < axes; ++axis) {
    const Real p = v[static_cast<std::size_t>(9 + axis)];
    Real& x = v[static_cast<std::size_t>(3 * point + axis)];
    x = std::ldexp(x - p, power) + p;
  }
}

template <class Real>
bool apply(Coordinates<Real>& v, const Move& move) {
  const int i = move.i, j = move.j;
  const auto number = [&](int k) -> Real& { return v[static_cast<std::size_t>(k)]; };
  const auto on_axis = [&](int axis, auto&& change) {
    for (int point = 0; point < points; ++point) change(number(3 * point + axis));
  };
  const auto exponent = [&](int k) { return number(k) == 0 ? 0 : std::ilogb(number(k)); };
  switch (move.kind) {
    case MoveKind::translate:
      for (int axis = 0; axis < axes; ++axis) {
        const Real by = number(3 * i + axis);
        if (j == axis || j == axes) on_axis(axis, [&](Real& x) { x -= by; });
      }
      return true;
    case MoveKind::zero:
      number(i) = number(j) = 0;
      return true;
    case MoveKind::flatten:
      on_axis(i, [](Real& x) { x = 0; });
      return true;
    case MoveKind::round_all:
      return round_all(v, i);
    case MoveKind::copy_point:
      for (int axis = 0; axis < axes; ++axis) number(3 * i + axis) = number(3 * j + axis);
      return true;
    case MoveKind::align: {
      const int from = std::abs(j) % 3, power = std::abs(j) / 3 - 3;
      if (from == i) return false;
      for (int axis = 0; axis < axes; ++axis) {
        const Real p = number(9 + axis), x = std::ldexp(number(3 * from + axis) - p, power);
        number(3 * i + axis) = (j < 0 ? -x : x) + p;
      }
      return true;
    }
    case MoveKind::copy:
      number(i) = i == radius ? std::fabs(number(j)) : number(j);
      return true;
    case MoveKind::copy_negated:
      number(i) = -number(j);
      return i != radius;
    case MoveKind::scale_all: {
      const int power = -exponent(i);
      for (Real& x : v) x = std::ldexp(x, power);
      return power != 0;
    }
    case MoveKind::scale_point:
      scale_point(v, i, j);
      return true;
    case MoveKind::scale_axis:
      on_axis(i, [&](Real& x) { x = std::ldexp(x, j); });
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
      on_axis(i, [](Real& x) { x = -x; });
      return true;
    case MoveKind::negate:
      number(i) = -number(i);
      return true;
    case MoveKind::swap_axes:
      for (int point = 0; point < points; ++point) std::swap(number(3 * point + i), number(3 * point + j));
      return true;
    case MoveKind::swap_points:
      for (int axis = 0; axis < axes; ++axis) std::swap(number(3 * i + axis), number(3 * j + axis));
      return true;
    case MoveKind::trade_down:
    case MoveKind::trade_up: {
      if (number(i) == 0) return false;
      const auto bits = static_cast<int>(std::bit_width(binary_digits(number(i)).digits));
      const auto x = rounded(number(i), bits - 1, move.kind == MoveKind::trade_up);
      const int other = j < 0 ? -1 - j : j;
      if (!x || bits < 2) return false;
      number(i) = *x;
      number(other) += j < 0 ? -last_unit(number(other)) : last_unit(number(other));
      return true;
    }
    case MoveKind::nudge:
      number(i) = i == radius ? step_radius(number(i), j) : step_ulps(number(i), j);
      return true;
  }
  return false;
}

}  // namespace

template <class Real>
std::vector<Move> moves() {
  using enum MoveKind;
  constexpr int digits = std::numeric_limits<Real>::digits;
  std::vector<Move> all;
  const auto add = [&](MoveKind kind, int i, int j = 0) { all.push_back({kind, i, j}); };
  for (const int axis : {3, 0, 1, 2}) {
    for (const int point : {3, 0, 1, 2}) add(translate, point, axis);
  }
  for (int axis = 0; axis < axes; ++axis) add(flatten, axis);
  for (int distance = 0; distance < numbers; ++distance) {
    for (int i = 0; i + distance < numbers; ++i) add(zero, i, i + distance);
  }
  for (int bits = 1; bits < digits; ++bits) add(round_all, bits);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < points; ++j) {
      if (i != j) add(copy_point, i, j);
    }
  }
  for (int i = 0; i < 3; ++i) {
    for (int j = -20; j <= 20; ++j) add(align, i, j);
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
    for (int point = 0; point < 3; ++point) add(scale_point, point, power);
    for (int axis = 0; axis < axes; ++axis) add(scale_axis, axis, power);
  }
  for (int i = 0; i < numbers; ++i) {
    add(centre, i);
    for (const int power : {-16, 16, -4, 4, -1, 1}) add(scale, i, power);
  }
  for (int axis = 0; axis < axes; ++axis) add(reflect, axis);
  for (int i = 0; i < numbers; ++i) add(negate, i);
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < i; ++j) {
      add(swap_axes, i, j);
      add(swap_points, i, j);
    }
  }
  return all;
}
template std::vector<Move> moves<float>();
template std::vector<Move> moves<double>();

std::vector<Move> nudges() {
  std::vector<Move> all;
  for (int i = 0; i < numbers; ++i) {
    for (const int floats : {-16, -4, -2, -1, 1, 2, 4, 16}) all.push_back({MoveKind::nudge, i, floats});
  }
  return all;
}

template <class Real>
std::optional<Query<Real>> moved(const Query<Real>& q, const Move& move) {
  Coordinates<Real> v = coordinates(q);
  if (!apply(v, move)) return std::nullopt;
  const Query<Real> out = from_coordinates(v);
  return is_valid(out) ? std::optional(out) : std::nullopt;
}
template std::optional<Query<float>> moved<float>(const Query<float>&, const Move&);
template std::optional<Query<double>> moved<double>(const Query<double>&, const Move&);

}  // namespace axiscert
