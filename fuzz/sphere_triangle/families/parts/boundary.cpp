#include "fuzz/sphere_triangle/families/parts/boundary.h"

#include "exact/sphere_triangle/oracles/second_oracle.h"
#include "exact/sphere_triangle/oracles/exact_truth.h"
#include "exact/sphere_triangle/measures/nearest_root.h"

namespace axiscert {
namespace {

template <class Real>
BinaryNumber in_binary(Real x) {
  return BinaryNumber(static_cast<double>(x));
}

template <class Real>
Real& coordinate_of(Vec3<Real>& v, int coordinate) {
  return coordinate == 0 ? v.x : coordinate == 1 ? v.y : v.z;
}

template <class Real>
Rational margin(const Query<Real>& q, Comparison which) {
  const ExactSides sides = exact_sides(q);
  return rational(sides.lhs[index_of(which)].over - sides.rhs[index_of(which)].over);
}

template <class Real>
Real root_of(const Ratio<BinaryNumber>& ratio) {
  const Rational n = rational(ratio.numerator), d = rational(ratio.denominator);
  return nearest_sqrt<Real>(n.get_num() * d.get_den(), n.get_den() * d.get_num());
}

}  // namespace

template <class Real>
Real exact_radius_on_boundary(const Query<Real>& q, Comparison which) {
  auto centred = centred_as<BinaryNumber>(q, in_binary<Real>);
  centred.rr = BinaryNumber(1);
  const ExactSides sides = exact_sides(centred);
  if (sides.rhs[index_of(which)].over.is_zero()) return 0;
  return root_of<Real>({sides.lhs[index_of(which)].over, sides.rhs[index_of(which)].over});
}

template <class Real>
Real exact_radius_at_distance(const Query<Real>& q) {
  // Several times faster than CGAL's, and a generator needs no independence; the tests compare the two.
  const auto by_value = [](const BinaryNumber& x, const BinaryNumber& y) { return order(x, y); };
  return root_of<Real>(
      walked_squared_distance(centred_as<BinaryNumber>(q, in_binary<Real>), BinaryNumber(), BinaryNumber(1), by_value));
}

template <class Real>
Real exact_coordinate_on_boundary(const Query<Real>& q, Comparison side_comparison, int coordinate) {
  Query<Real> at = q;
  Real& x = coordinate_of(at.p, coordinate);
  const Real given = x;
  x = 0;
  const Rational at_zero = margin(at, side_comparison);
  x = 1;
  const Rational slope = margin(at, side_comparison) - at_zero;
  if (sgn(slope) == 0) return given;
  return nearest<Real>(-at_zero / slope);
}

template <class Real>
Real radius_on_boundary(const Query<Real>& q, Comparison which) {
  const auto found = nearest_tie_radius(q, which);
  return found ? *found : exact_radius_on_boundary(q, which);
}

template <class Real>
Real radius_at_distance(const Query<Real>& q) {
  const auto found = nearest_distance(q);
  return found ? *found : exact_radius_at_distance(q);
}

template <class Real>
Real coordinate_on_boundary(const Query<Real>& q, Comparison side_comparison, int coordinate) {
  const auto found = nearest_tie_coordinate(q, side_comparison, coordinate);
  return found ? *found : exact_coordinate_on_boundary(q, side_comparison, coordinate);
}

#define AXISCERT_INSTANTIATE(Real)                                                 \
  template Real radius_on_boundary<Real>(const Query<Real>&, Comparison);          \
  template Real radius_at_distance<Real>(const Query<Real>&);                      \
  template Real coordinate_on_boundary<Real>(const Query<Real>&, Comparison, int); \
  template Real exact_radius_on_boundary<Real>(const Query<Real>&, Comparison);    \
  template Real exact_radius_at_distance<Real>(const Query<Real>&);                \
  template Real exact_coordinate_on_boundary<Real>(const Query<Real>&, Comparison, int);
AXISCERT_INSTANTIATE(float)
AXISCERT_INSTANTIATE(double)
#undef AXISCERT_INSTANTIATE

}  // namespace axiscert
