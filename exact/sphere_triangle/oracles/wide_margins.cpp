#include "exact/sphere_triangle/oracles/wide_margins.h"

#include <limits>

namespace axiscert {
namespace {

using Vector = Vec3<WideEnclosed>;

Vector difference(const Vec3<double>& u, const Vec3<double>& v) {
  return {WideEnclosed::difference(u.x, v.x), WideEnclosed::difference(u.y, v.y), WideEnclosed::difference(u.z, v.z)};
}
WideEnclosed narrowest(const WideEnclosed& a, const WideEnclosed& b, const WideEnclosed& c) {
  return WideEnclosed::narrower(WideEnclosed::narrower(a, b), c);
}
// Separate functions: the cost of a call is small beside that of so many operations.
[[gnu::noinline]] Vector cross_product(const Vector& u, const Vector& v) { return cross(u, v); }
[[gnu::noinline]] WideEnclosed dot_product(const Vector& u, const Vector& v) { return dot(u, v); }
Vector narrowest(const Vector& a, const Vector& b, const Vector& c) {
  return {narrowest(a.x, b.x, c.x), narrowest(a.y, b.y, c.y), narrowest(a.z, b.z, c.z)};
}

// x 2^exponent, where x is a quotient with one rounding and the result may not be representable: rounded away from the
// quantity that it bounds.
double bound_above(double x, int exponent) {
  return std::ldexp(x, std::clamp(exponent, -3000, 3000)) * (1 + 0x1p-50) + std::numeric_limits<double>::denorm_min();
}
double bound_below(double x, int exponent) {
  const double least = std::ldexp(x, std::clamp(exponent, -3000, 3000)) * (1 - 0x1p-50);
  return std::min(least < 0x1p-1000 ? 0 : least, std::numeric_limits<double>::max());
}

}  // namespace

// Evaluated in the reduced form, whose signs are the published ones (exact/sphere_triangle/oracles/grid_signs.cpp). If
// the thirteen numbers have thirteen magnitudes, one of them dominates a difference, and two differences that share it
// cancel in one form of a product and not in another:
//   V = AB x BC = BC x CA = CA x AB,  N of an edge from X to Y = X x XY = Y x XY = X x Y,  d = A.V = B.V = C.V.
// Over the reals the forms are equal; each component is taken from the form with the least error.
WideMargins::WideMargins(const Query<double>& q) {
  using enum Comparison;
  const std::array<Vector, 3> vertex = {difference(q.a, q.p), difference(q.b, q.p), difference(q.c, q.p)};
  const std::array<Vector, 3> edge = {difference(q.b, q.a), difference(q.c, q.b), difference(q.a, q.c)};
  const WideEnclosed r(q.r), rr = r * r;
  std::array<WideEnclosed, 3> squares;
  for (std::size_t i = 0; i < 3; ++i) squares[i] = dot_product(vertex[i], vertex[i]);

  const Vector normal =
      narrowest(cross_product(edge[0], edge[1]), cross_product(edge[1], edge[2]), cross_product(edge[2], edge[0]));
  const WideEnclosed offset =
      narrowest(dot_product(vertex[0], normal), dot_product(vertex[1], normal), dot_product(vertex[2], normal));
  const auto emit = [&](Comparison which, const WideEnclosed& margin, const WideEnclosed& lhs, const WideEnclosed& rhs,
                        int along = -1) {
    margins_[which] = {margin, lhs, rhs, along};
  };
  const auto emit_radius = [&](Comparison which, const WideEnclosed& lhs, const WideEnclosed& rhs, int along = -1) {
    emit(which, lhs - rhs, lhs, rhs, along);
  };
  emit_radius(plane_radius, offset * offset, rr * dot_product(normal, normal));

  // lhs = X.Y, rhs = X.X: the margin is X.(Y - X).
  const auto vertex_side = [&](Comparison which, std::size_t from, const WideEnclosed& margin) {
    emit(which, margin, squares[from] + margin, squares[from]);
  };
  const auto along = [&](std::size_t from, std::size_t i) { return dot_product(vertex[from], edge[i]); };
  emit_radius(vertex_a_radius, squares[0], rr);
  vertex_side(vertex_a_side_b, 0, along(0, 0));
  vertex_side(vertex_a_side_c, 0, -along(0, 2));
  emit_radius(vertex_b_radius, squares[1], rr);
  vertex_side(vertex_b_side_a, 1, -along(1, 0));
  vertex_side(vertex_b_side_c, 1, along(1, 1));
  emit_radius(vertex_c_radius, squares[2], rr);
  vertex_side(vertex_c_side_a, 2, along(2, 2));
  vertex_side(vertex_c_side_b, 2, -along(2, 1));

  static constexpr std::array<std::array<Comparison, 2>, 3> of_edge = {
      {{edge_ab_radius, edge_ab_side_c}, {edge_bc_radius, edge_bc_side_a}, {edge_ca_radius, edge_ca_side_b}}};
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector &from = vertex[i], &to = vertex[(i + 1) % 3];
    const Vector n = narrowest(cross_product(from, edge[i]), cross_product(to, edge[i]), cross_product(from, to));
    edge_squares_[i] = dot_product(edge[i], edge[i]);
    emit_radius(of_edge[i][0], dot_product(n, n), rr * edge_squares_[i], static_cast<int>(i));
    const WideEnclosed side = -dot_product(n, normal);
    emit(of_edge[i][1], side, side, WideEnclosed(), static_cast<int>(i));
  }
}

std::optional<Signs> WideMargins::signs() const {
  Signs signs;
  for (std::size_t k = 0; k < comparison_count; ++k) {
    const WideEnclosed& margin = margins_[k].difference;
    const auto bit = one_bit<SignBits>(k);
    if (margin.is_positive()) signs.strict |= bit;
    else if (margin.is_zero()) signs.ties |= bit;
    else if (!margin.is_negative()) return std::nullopt;
  }
  return signs;
}

WideMargins::ErrorRange WideMargins::error(Comparison which, EdgeSides sides, double lhs, double rhs,
                                           int digits) const {
  const Margin& of = margins_[which];
  WideEnclosed difference = of.difference, scale = of.lhs.magnitude() + of.rhs;
  if (sides == EdgeSides::published && of.edge >= 0) {
    const WideEnclosed& e = edge_squares_[static_cast<std::size_t>(of.edge)];
    difference = difference * e;
    scale = scale * e;
  }
  const WideEnclosed distance = WideEnclosed::difference(lhs, rhs) - difference;
  const double least_scale = scale.least();
  if (!(least_scale > 0)) return {0, std::numeric_limits<double>::infinity(), std::numeric_limits<int>::max()};
  const int exponent = distance.exponent - scale.exponent + digits;
  const double greatest = distance.greatest() / least_scale;
  int exponent_above = 0;
  std::frexp(greatest * (1 + 0x1p-50), &exponent_above);
  return {bound_below(distance.least() / scale.greatest(), exponent), bound_above(greatest, exponent),
          exponent_above + exponent};
}

}  // namespace axiscert
