#include "exact/sphere_triangle/measures/input_class.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <type_traits>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/enclosed_triangle.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"

namespace axiscert {
namespace {

// The sign of |x - y| factor - bound, exactly; factor is a power of two, at least 1. A difference rounds to the wrong
// side of no number that a double can hold, and where it rounds to `bound` its error decides. A subnormal difference is
// exact, so `factor` loses nothing; an infinite one is beyond every bound.
int order_of_difference(double x, double y, double factor, double bound) {
  const double difference = x - y, scaled = std::fabs(difference) * factor;
  if (scaled != bound) return scaled < bound ? -1 : 1;
  const double rest = arithmetic::two_sum(x, -y).error;
  if (rest == 0) return 0;
  return (rest > 0) == (difference > 0) ? 1 : -1;
}

// Pairs of points whose differences are a length of the scene.
using Pair = std::array<const Vec3<double>*, 2>;

// The greatest |coordinate| of these differences, and `radius`, compared with a bound.
struct Extent {
  std::array<Pair, 3> pairs;
  double radius;

  int order(double factor, double bound) const {
    int most = -1;
    const auto add = [&](int order) { most = std::max(most, order); };
    for (const auto& [x, y] : pairs) {
      add(order_of_difference(x->x, y->x, factor, bound));
      add(order_of_difference(x->y, y->y, factor, bound));
      add(order_of_difference(x->z, y->z, factor, bound));
    }
    add(order_of_difference(radius, 0, factor, bound));
    return most;
  }
  bool is_zero() const { return order(1, 0) == 0; }
};

template <class Real>
bool is_outside_window(const Extent& extent) {
  if (extent.is_zero()) return false;
  using Window = ScaleWindow<Real>;
  return extent.order(1, std::ldexp(1.0, Window::greatest_exponent)) > 0 ||
         extent.order(1, std::ldexp(1.0, Window::least_exponent)) < 0;
}

bool are_equal(const Vec3<double>& x, const Vec3<double>& y) { return x.x == y.x && x.y == y.y && x.z == y.z; }

// A triangle whose vertices are three points: whether it has an area, and if it has, whether its least height is below
// 2^-sliver_bits of its longest edge. With V twice the area and e the longest edge's square, height / longest = |V| /
// e.
struct Thinness {
  bool is_collinear, is_sliver;
};
constexpr double height_factor = double(1u << (2 * sliver_bits));

// Empty where the enclosures overlap.
template <class T>
std::optional<Thinness> enclosed_thinness(const EnclosedTriangle<T>& t) {
  const EnclosedVector<T> normal = enclosed_normal(t);
  const EnclosedNumber<double> area = as_double(dot(normal, normal));
  double low = 0, high = 0;
  for (const EnclosedVector<T>& edge : t.edge) {
    const EnclosedNumber<double> square = as_double(dot(edge, edge));
    low = std::max(low, square.low());
    high = std::max(high, square.high());
  }
  // A rounding of each product and square: `more` covers them. The least value that matters is far above an underflow:
  // enclosures have added more than that to their bounds.
  if (area.low() * height_factor * less > high * high * more) return Thinness{false, false};
  if (area.low() > 0 && area.high() * height_factor * more < low * low * less) return Thinness{false, true};
  return std::nullopt;
}

template <class Real>
Thinness exact_thinness(const Query<Real>& q) {
  const Vec3<BinaryNumber> normal = exact_normal(q);
  const BinaryNumber area = portable::dot(normal, normal);
  if (area.is_zero()) return {true, false};
  const auto square_of = [](const Vec3<Real>& u, const Vec3<Real>& v) {
    const auto square = [](Real x, Real y) {
      const BinaryNumber difference = BinaryNumber(double(x)) - BinaryNumber(double(y));
      return difference * difference;
    };
    return square(u.x, v.x) + square(u.y, v.y) + square(u.z, v.z);
  };
  const BinaryNumber longest = std::max({square_of(q.b, q.a), square_of(q.c, q.b), square_of(q.a, q.c)});
  return {false, area * BinaryNumber(height_factor) < longest * longest};
}

template <class Real>
Thinness thinness(const Query<Real>& q, bool use_filter) {
  std::optional<Thinness> found;
  if (use_filter) {
    if constexpr (sizeof(Real) == 4) found = enclosed_thinness(enclosed_triangle_of(q));
    else found = enclosed_thinness(doubled_triangle_of(q));
  }
  return found ? *found : exact_thinness(q);
}

}  // namespace

template <class Real>
InputClassSet shape_classes(const Query<Real>& query, bool use_filter) {
  const Query<double> q = widened(query);
  const Extent reach{{{{&q.a, &q.p}, {&q.b, &q.p}, {&q.c, &q.p}}}, q.r};
  const Extent edges{{{{&q.b, &q.a}, {&q.c, &q.b}, {&q.a, &q.c}}}, 0};
  InputClassSet meets;
  const bool has_small_radius = q.r > 0 && q.r < std::ldexp(1.0, ScaleWindow<Real>::least_radius_exponent);
  if (has_small_radius || is_outside_window<Real>(reach) || is_outside_window<Real>(edges)) {
    meets.insert(InputClass::scale);
  }
  if (are_equal(q.a, q.b) || are_equal(q.b, q.c) || are_equal(q.c, q.a)) {
    meets.insert(InputClass::repeated);
  } else {
    const Thinness thin = thinness(query, use_filter);
    if (thin.is_collinear) meets.insert(InputClass::collinear);
    if (thin.is_sliver) meets.insert(InputClass::sliver);
  }
  double greatest = 0;
  for (const Vec3<double>* v : {&q.a, &q.b, &q.c, &q.p}) {
    greatest = std::max({greatest, std::fabs(v->x), std::fabs(v->y), std::fabs(v->z)});
  }
  if (!reach.is_zero() && reach.order(far_from_origin, greatest) <= 0) meets.insert(InputClass::far);
  return meets;
}
template InputClassSet shape_classes(const Query<float>&, bool);
template InputClassSet shape_classes(const Query<double>&, bool);

template <class Real>
InputClassSet input_classes(const Query<Real>& q, bool is_touching, double depth) {
  InputClassSet meets = shape_classes(q);
  if (is_touching) meets.insert(InputClass::tie);
  else if (depth <= near_tie_depth<Real>) meets.insert(InputClass::near_tie);
  if (meets.empty()) meets.insert(InputClass::ordinary);
  return meets;
}
template InputClassSet input_classes(const Query<float>&, bool, double);
template InputClassSet input_classes(const Query<double>&, bool, double);

template <class Real>
InputClassSet input_classes(const Query<Real>& q, const Rational& squared_distance) {
  const Rational r = exact(q.r);
  return input_classes(q, squared_distance == r * r, depth(q, squared_distance));
}
template InputClassSet input_classes(const Query<float>&, const Rational&);
template InputClassSet input_classes(const Query<double>&, const Rational&);

namespace {

constexpr double greatest_engine_coordinate = 0x1p20, least_engine_radius = 0x1p-20, greatest_engine_radius = 0x1p20;

template <class Real>
bool is_engine_coordinate(Real x) {
  const Real size = std::abs(x);
  const bool is_within =
      (size >= std::numeric_limits<Real>::min()) & (size <= static_cast<Real>(greatest_engine_coordinate));
  return (size == 0) | is_within;
}
template <class Real>
bool is_engine_radius(Real r) {
  return (r >= static_cast<Real>(least_engine_radius)) & (r <= static_cast<Real>(greatest_engine_radius));
}

}  // namespace

template <class Real>
bool is_engine_like(const Query<Real>& q) {
  for (const Vec3<Real>& point : {q.a, q.b, q.c, q.p}) {
    for (const Real x : {point.x, point.y, point.z}) {
      if (!is_engine_coordinate(x)) return false;
    }
  }
  return is_engine_radius(q.r);
}
template bool is_engine_like(const Query<float>&);
template bool is_engine_like(const Query<double>&);

template <class Real>
void find_engine_like(const QueryColumns<Real>& columns, std::vector<std::uint8_t>& all) {
  // Blocks of a fixed size and flags as wide as a number: a compiler makes vectors of these loops.
  constexpr std::size_t radius = coordinate_count - 1, block = 64;
  using Flag = std::conditional_t<sizeof(Real) == 4, std::int32_t, std::int64_t>;
  all.resize(columns.size);
  const auto put_from = [&](std::size_t first, auto size) {
    std::array<Flag, block> flags;
    const Real* radii = columns.column[radius] + first;
    for (std::size_t i = 0; i < size; ++i) flags[i] = is_engine_radius(radii[i]);
    for (std::size_t c = 0; c < radius; ++c) {
      const Real* x = columns.column[c] + first;
      for (std::size_t i = 0; i < size; ++i) flags[i] &= Flag{is_engine_coordinate(x[i])};
    }
    for (std::size_t i = 0; i < size; ++i) all[first + i] = static_cast<std::uint8_t>(flags[i]);
  };
  std::size_t first = 0;
  for (; first + block <= columns.size; first += block) put_from(first, std::integral_constant<std::size_t, block>());
  put_from(first, columns.size - first);
}
template void find_engine_like(const QueryColumns<float>&, std::vector<std::uint8_t>&);
template void find_engine_like(const QueryColumns<double>&, std::vector<std::uint8_t>&);

}  // namespace axiscert
