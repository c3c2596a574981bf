// The lattice in other units of length: small integers times powers of two, on which the published formulae never round
// and never leave the range. A kernel that is right on the integers and wrong on an image has a length in it.
#include <algorithm>

#include "fuzz/sphere_triangle/families/parts/images.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"
#include "fuzz/sphere_triangle/families/parts/shapes.h"
#include "fuzz/queries/family.h"

namespace axiscert {
namespace {

// As in `lattice`: the smallest integers, where vertices coincide and comparisons tie, alternate with the largest; four
// times the largest exceeds most distances between them.
template <class Real>
Query<Real> lattice_query(Stream& random, std::uint64_t base) {
  using Bounds = LatticeBounds<Real>;
  constexpr std::array<std::int64_t, 3> sizes = {1, 2, Bounds::m};
  const std::int64_t m = sizes[base % sizes.size()];
  const auto point = [&] {
    const auto draw = [&] { return static_cast<Real>(random.integer(-m, m)); };
    const Real x = draw(), y = draw(), z = draw();
    return Vec3<Real>{x, y, z};
  };
  Query<Real> q;
  for (Vec3<Real>* corner : {&q.a, &q.b, &q.c, &q.p}) *corner = point();
  q.r = static_cast<Real>(random.integer(0, std::min(8 * m, Bounds::radius_in_halves))) / 2;
  return q;
}

template <class Real>
constexpr PowerRange units_range = range_of_degree_6<Real>(LatticeBounds<Real>::m);

template <class Real>
void units(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  fill_groups(name, first, out, unit_images::count, lattice_query<Real>,
              [](Stream&, const Query<Real>& q, std::uint64_t base, std::size_t i) {
                return times_power(q, unit_images::exponent(units_range<Real>, base, i));
              });
}

PowerRange units_range_in(Precision precision) {
  return precision == Precision::binary32 ? units_range<float> : units_range<double>;
}

}  // namespace

extern const ImageGroup units_group = {sphere_triangle_predicate,
                                       "units",
                                       unit_images::count,
                                       [](std::size_t) {
                                         return std::array<std::uint8_t, 3>{0, 1, 2};
                                       },
                                       [](std::size_t) { return ImageKind::scale; },
                                       [](Precision precision, std::uint64_t base, std::size_t i) {
                                         return unit_images::exponent(units_range_in(precision), base, i);
                                       },
                                       units_range_in};

extern const Family units_family = {
    sphere_triangle_predicate,
    "units",
    "small integers, and times seven powers of two, 2^-20 to 2^17 or 2^-170 to 2^161: every operation is exact",
    1,
    true,
    units<float>,
    units<double>};

}  // namespace axiscert
