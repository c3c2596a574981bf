#include "exact/sphere_triangle/measures/nearest_root.h"

#include <bit>
#include <cstdint>
#include <limits>

#include "exact/sphere_triangle/oracles/distance_bounds.h"

namespace axiscert {
namespace {

// Half the distances from a float to its neighbours, times 2^exponent: numbers strictly between these midpoints round
// to it. The distances are not exact for the greatest float, nor for a value below 2^-300 after scaling: is_usable is
// false then.
template <class Real>
struct Rounding {
  double value, towards_zero, away;
  bool is_usable;

  Rounding(Real x, int exponent) {
    using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
    const Real size = std::fabs(x);
    is_usable = size > 0 && size < std::numeric_limits<Real>::max();
    if (!is_usable) return;
    const Bits bits = std::bit_cast<Bits>(size);
    value = x;
    towards_zero = double(size) - double(std::bit_cast<Real>(bits - 1));
    away = double(std::bit_cast<Real>(bits + 1)) - double(size);
    if (exponent != 0) {
      value = std::ldexp(value, exponent);
      towards_zero = std::ldexp(towards_zero, exponent);
      away = std::ldexp(away, exponent);
    }
    towards_zero *= 0.5;
    away *= 0.5;
    is_usable = std::fabs(value) >= 0x1p-300;
  }
};

// Below this bound a product of bounds may have underflowed.
constexpr double least_bound = 0x1p-950;

template <class Real>
Real unscaled(double x, int exponent) {
  return static_cast<Real>(exponent == 0 ? x : std::ldexp(x, -exponent));
}

// x^2, exact: for a binary32 number in double, for any number in double-double, above 2^-300.
template <class T>
EnclosedNumber<T> exact_square(double x) {
  if constexpr (std::is_same_v<T, DoublePair>) {
    const auto square = exact_product(x, x);
    return {{square.value, square.error}, 0};
  } else {
    return {x * x, 0};
  }
}

// sqrt(s) rounded, with d^2 D in [N - below, N + above] and D > 0. With g the half distances, d rounds to y if
// (y - g)^2 D < d^2 D < (y + g)^2 D. In terms of the residual R = N - y^2 D that is, slightly stricter above,
//   below - R < g (2 y - g) D   and   R + above < 2 g y D.
template <class Real, class T>
std::optional<Real> nearest_root(const EnclosedSquare<T>& s, int exponent) {
  const double divisor = as_double(s.divisor).low();
  if (!(divisor > 0)) return std::nullopt;
  double root = std::sqrt(leading(s.numerator.value) / leading(s.divisor.value));
  if (!(root >= 0x1p-300)) return std::nullopt;
  const auto residual = [&](double x) { return s.numerator - exact_square<T>(x) * s.divisor; };
  // In doubles the root may be an ulp off; a Newton step corrects that.
  if (std::is_same_v<T, DoublePair>) root += leading(residual(root).value) / (2 * root * leading(s.divisor.value));
  const Real nearest = unscaled<Real>(root, exponent);
  const Rounding<Real> y(nearest, exponent);
  if (!y.is_usable) return std::nullopt;
  const EnclosedNumber<T> rest = residual(y.value);
  const double short_by = s.below - rest.low(), beyond = rest.high() + s.above;
  const double down = y.towards_zero * (2 * y.value - y.towards_zero) * divisor * less;
  const double up = 2 * y.away * y.value * divisor * less;
  return down > least_bound && up > least_bound && short_by * more < down && beyond * more < up ? std::optional(nearest)
                                                                                                : std::nullopt;
}

// The result of `solve` in double, for binary32; otherwise, or if that is empty, in double-double.
template <class Real, class Solve>
std::optional<Real> solved(const Query<Real>& q, Solve&& solve) {
  if constexpr (sizeof(Real) == 4) {
    if (const auto found = solve(enclosed_triangle_of(q))) return found;
  }
  return solve(doubled_triangle_of(q));
}

template <class Real, class T>
std::optional<Real> tie_radius(const EnclosedTriangle<T>& t, Axis axis) {
  const auto number = index_of(axis);
  if (axis == Axis::plane) {
    if (has_zero_edge(t)) return Real(0);
    return nearest_root<Real>(plane_square(t, enclosed_normal(t)), t.exponent);
  }
  if (number < 4) {
    if (is_zero(t.vertex[number - 1])) return Real(0);
    return nearest_root<Real>(vertex_square(t, number - 1), t.exponent);
  }
  if (is_zero(t.edge[number - 4])) return Real(0);
  return nearest_root<Real>(line_square(t, number - 4), t.exponent);
}

// A side's margin and its derivative with respect to each coordinate of p, both times a factor that is not zero and
// does not depend on p.
template <class T>
struct Margin {
  EnclosedNumber<T> value;
  EnclosedVector<T> slope;  // negated
  bool is_given;            // the slope is a difference of given numbers
  bool is_constant;         // independent of every coordinate of p
};

// Vertex X, side of Y: X.(Y - X). Edge: -(v x e).V; Q.QC is e^2 times that.
template <class T>
Margin<T> side_margin(const EnclosedTriangle<T>& t, Comparison side) {
  const auto vertex = [&](std::size_t i, std::size_t edge) -> Margin<T> {
    return {dot(t.vertex[i], t.edge[edge]), t.edge[edge], true, false};
  };
  const auto edge = [&](std::size_t i) -> Margin<T> {
    if (has_zero_edge(t)) return {{}, {}, false, true};
    const EnclosedVector<T> normal = enclosed_normal(t);
    return {inward(t, i, normal), cross(t.edge[i], normal), false, false};
  };
  using enum Comparison;
  switch (side) {
    case vertex_a_side_b:
      return vertex(0, 0);
    case vertex_a_side_c:
      return vertex(0, 2);
    case vertex_b_side_a:
      return vertex(1, 0);
    case vertex_b_side_c:
      return vertex(1, 1);
    case vertex_c_side_a:
      return vertex(2, 2);
    case vertex_c_side_b:
      return vertex(2, 1);
    case edge_ab_side_c:
      return edge(0);
    case edge_bc_side_a:
      return edge(1);
    case edge_ca_side_b:
      return edge(2);
    case plane_radius:
    case vertex_a_radius:
    case vertex_b_radius:
    case vertex_c_radius:
    case edge_ab_radius:
    case edge_bc_radius:
    case edge_ca_radius:
      break;  // not a side comparison
  }
  return {{}, {}, false, true};
}

template <class V>
auto component(const V& v, int coordinate) {
  return coordinate == 0 ? v.x : coordinate == 1 ? v.y : v.z;
}

// The margin at y, m + (y - p) m', has different signs at the two rounding midpoints: the root lies between them.
template <class Real, class T>
std::optional<Real> tie_coordinate(const EnclosedTriangle<T>& t, Real given, Comparison side, int coordinate) {
  const Margin<T> margin = side_margin(t, side);
  if (margin.is_constant) return given;
  const EnclosedNumber<T> falls = {component(margin.slope.value, coordinate), margin.slope.error};
  if (margin.is_given && leading(falls.value) == 0 && t.scaling_error == 0) return given;
  const double sign = leading(falls.value) < 0 ? -1 : 1;
  const double slope = sign > 0 ? falls.low() : -falls.high();
  const double from = std::ldexp(static_cast<double>(given), t.exponent);
  double root = from + leading(margin.value.value) / leading(falls.value);
  // A second round starts from the result of the first, which may have moved far.
  for (int round = 0; round < 2; ++round) {
    const Real nearest = unscaled<Real>(root, t.exponent);
    const Rounding<Real> y(nearest, t.exponent);
    if (!y.is_usable) return std::nullopt;
    const EnclosedNumber<T> rest = margin.value - enclosed_difference<T>(y.value, from, t.scaling_error) * falls;
    // Bounds on how far the root can be above and below y, times the slope.
    const double above = sign > 0 ? rest.high() : -rest.low(), below = sign > 0 ? -rest.low() : rest.high();
    const double up = (y.value > 0 ? y.away : y.towards_zero) * slope * less;
    const double down = (y.value > 0 ? y.towards_zero : y.away) * slope * less;
    if (!(up > least_bound && down > least_bound)) return std::nullopt;
    if (above * more < up && below * more < down) return nearest;
    root = y.value + leading(rest.value) / leading(falls.value);
  }
  return std::nullopt;
}

}  // namespace

template <class Real>
std::optional<Real> nearest_distance(const Query<Real>& q) {
  return solved(q, [](const auto& t) -> std::optional<Real> {
    if (is_zero(t.vertex[0]) || is_zero(t.vertex[1]) || is_zero(t.vertex[2])) return Real(0);
    return nearest_root<Real>(distance_bounds(t), t.exponent);
  });
}

template <class Real>
std::optional<Real> nearest_tie_radius(const Query<Real>& q, Comparison which) {
  return solved(q, [&](const auto& t) { return tie_radius<Real>(t, info(which).axis); });
}

template <class Real>
std::optional<Real> nearest_tie_coordinate(const Query<Real>& q, Comparison which, int coordinate) {
  const Real given = component(q.p, coordinate);
  return solved(q, [&](const auto& t) { return tie_coordinate(t, given, which, coordinate); });
}

#define AXISCERT_INSTANTIATE(Real)                                                 \
  template std::optional<Real> nearest_distance(const Query<Real>&);               \
  template std::optional<Real> nearest_tie_radius(const Query<Real>&, Comparison); \
  template std::optional<Real> nearest_tie_coordinate(const Query<Real>&, Comparison, int);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
