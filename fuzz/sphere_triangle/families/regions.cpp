// Spheres that are clearly in contact or clearly not, seen from each of the regions of a triangle in turn: of one with
// an obtuse corner, and of needles, slivers and triangles that are 200 times as long as wide.
#include "fuzz/sphere_triangle/families/parts/regions.h"

#include "fuzz/queries/family.h"

#include <cmath>

namespace axiscert {
namespace {

using regions::at_unit_length, regions::Point;

// The vertices are rounded first, the centre is seen from the rounded ones. Edges near an end are met within twice the
// distance: outside of two edges where the corner is obtuse, and yet nearest to one.
template <class Real>
Query<Real> seen_from(Stream& random, const regions::Corners& corners, std::size_t first, std::size_t region,
                      double distance, bool in_contact) {
  shapes::Vertices<Real> v;
  regions::Corners exact;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = regions::rounded_place<Real>(corners[(k + first) % 3]);
    exact[k] = regions::wide(v[k]);
  }
  const regions::Aim aim = regions::aim(random, exact, region, distance * 2);
  const double part = regions::clear_part(random);
  return shapes::query(v, regions::rounded_place<Real>(aim.at + aim.away * distance),
                       static_cast<Real>(distance * (in_contact ? 1 + part : 1 - part)));
}

// A sphere without a radius beside edge i, in the plane of the triangle, which is one of two axes: no rounding moves it
// out of that plane.
template <class Real>
Query<Real> level_point(Stream& random, std::size_t i, double distance) {
  const Point from = shapes::in_cube<double>(random), any = shapes::in_cube<double>(random);
  const double cosine = 0.9 * random.symmetric<double>(), second = 0.5 + random.unit<double>(),
               along = 0.25 + 0.5 * random.unit<double>();
  const auto axis = random.below(3);
  const Point way = dot(any, any) - any.z * any.z < 0x1p-8 ? Point{1, 0, 0} : at_unit_length(Point{any.x, any.y, 0}),
              aside = {-way.y, way.x, 0};
  const regions::Corners corners = {from, from + way,
                                    from + (way * cosine + aside * std::sqrt(1 - cosine * cosine)) * second};
  shapes::Vertices<Real> v{};
  regions::Corners exact{};
  for (std::size_t k = 0; k < 3; ++k) {
    const auto [x, y, z] = corners[k];
    v[k] = regions::rounded_place<Real>(axis == 0 ? Point{z, x, y} : axis == 1 ? Point{y, z, x} : Point{x, y, z});
    exact[k] = regions::wide(v[k]);
  }
  const Point at = exact[i] + (exact[shapes::next(i)] - exact[i]) * along;
  return shapes::query(v, regions::rounded_place<Real>(at + regions::outwards(exact, i) * distance));
}

// Three of four have an obtuse corner, of any vertex. The distances are 2^-10 to 2^3 in turn. Every eighth round is of
// points beside the edges, at 2^-6 to 2^-12.
template <class Real>
Query<Real> at_corners(Stream& random, std::uint64_t position) {
  const std::uint64_t round = position / regions::count;
  const std::size_t region = position % regions::count;
  if (round % 8 == 7 && regions::is_edge(region))
    return level_point<Real>(random, region % 3, std::ldexp(1.0, -6 - static_cast<int>(round / 8 % 7)));
  const bool is_obtuse = random.below(4) != 0;
  const double share = random.unit<double>(), cosine = is_obtuse ? -0.05 - 0.9 * share : 0.9 * share;
  const double first = 0.5 + random.unit<double>(), second = 0.5 + random.unit<double>();
  const double distance = std::ldexp(0.5 + random.unit<double>() / 2, 3 - static_cast<int>(round / 2 % 14));
  const auto vertex = random.below(3);
  const auto corners = regions::with_corner(random, cosine, first, second);
  return seen_from<Real>(random, corners, vertex, region, distance, round % 2 == 0);
}

// In turn a needle, two of whose vertices are 2^-1 to 2^-12 of its length apart; a sliver, one of whose vertices is as
// near to the edge of the others; and a triangle 200 long and 1 wide. From a 64th of its width to 4 times its length.
template <class Real>
Query<Real> beside_slender(Stream& random, std::uint64_t position) {
  const std::uint64_t round = position / regions::count, kind = round / 2 % 3;
  const double thin = kind == 2 ? 1.0 / 200 : std::ldexp(1.0, -1 - static_cast<int>(round / 6 % 12));
  const double length = kind == 2 ? 200 : 0.5 + random.unit<double>(), share = random.unit<double>();
  const double cosine = random.symmetric<double>() / 2, aside = 1 - thin * thin;
  // The angle at the first vertex, and the side from it: short, or nearly along the other.
  const auto corners = kind == 1 ? regions::with_corner(random, aside, length, length * (0.25 + share / 2))
                                 : regions::with_corner(random, cosine, length, length * thin);
  const auto octaves = static_cast<std::uint64_t>(8 - std::ilogb(thin));
  const int halvings = static_cast<int>(random.below(octaves));
  const double distance = std::ldexp(length * (0.5 + random.unit<double>() / 2), 2 - halvings);
  const auto vertex = random.below(3);
  return seen_from<Real>(random, corners, vertex, position % regions::count, distance, round % 2 == 0);
}

}  // namespace

extern const Family corners_family = {
    sphere_triangle_predicate,
    "corners",
    "clear: from each region of a triangle in turn, most with an obtuse corner, at 2^-10 to 2^3; points beside edges",
    2,
    false,
    fill_one_by_one<at_corners<float>, float>,
    fill_one_by_one<at_corners<double>, double>};
extern const Family slender_family = {
    sphere_triangle_predicate,
    "slender",
    "clear: from each region of needles and slivers to 2^-12 and of triangles 200 by 1, near and far",
    1,
    false,
    fill_one_by_one<beside_slender<float>, float>,
    fill_one_by_one<beside_slender<double>, double>};

}  // namespace axiscert
