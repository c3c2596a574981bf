#include "fuzz/boxes/capability_parts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <vector>

#include "fuzz/boxes/trait_parts.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert {
namespace boxes {
namespace {

using namespace traits;

#define AXISCERT_CORNER_TRAITS(X)                                                        \
  X(x_alone, "parted by the box's facet x alone", "regions", true)                       \
  X(y_alone, "parted by the box's facet y alone", "regions", true)                       \
  X(z_alone, "parted by the box's facet z alone", "regions", true)                       \
  X(plane_alone, "parted by the triangle's plane alone", "regions", true)                \
  X(x_ab_alone, "parted by x x ab alone", "regions", true)                               \
  X(x_bc_alone, "parted by x x bc alone", "regions", true)                               \
  X(x_ca_alone, "parted by x x ca alone", "regions", true)                               \
  X(y_ab_alone, "parted by y x ab alone", "regions", true)                               \
  X(y_bc_alone, "parted by y x bc alone", "regions", true)                               \
  X(y_ca_alone, "parted by y x ca alone", "regions", true)                               \
  X(z_ab_alone, "parted by z x ab alone", "regions", true)                               \
  X(z_bc_alone, "parted by z x bc alone", "regions", true)                               \
  X(z_ca_alone, "parted by z x ca alone", "regions", true)                               \
  X(facet_alone, "parted by one facet of the box alone", "regions")                      \
  X(edges_alone, "parted by one product of edges alone", "regions")                      \
  X(several, "parted by several axes", "regions")                                        \
  X(below_x, "that meet the box made longer to lower x", {}, true, true)                 \
  X(above_x, "that meet the box made longer to higher x", {}, true, true)                \
  X(below_y, "that meet the box made longer to lower y", {}, true, true)                 \
  X(above_y, "that meet the box made longer to higher y", {}, true, true)                \
  X(below_z, "that meet the box made longer to lower z", {}, true, true)                 \
  X(above_z, "that meet the box made longer to higher z", {}, true, true)                \
  X(shallow_facet, "least deep along a facet of the box", "regions")                     \
  X(shallow_plane, "least deep along the triangle's plane", "regions")                   \
  X(shallow_edges, "least deep along a product of edges", "regions")                     \
  X(no_edge, "of which no edge of the triangle meets the box")                           \
  X(by_ab, "of which edge ab alone meets the box", {}, true)                             \
  X(by_bc, "of which edge bc alone meets the box", {}, true)                             \
  X(by_ca, "of which edge ca alone meets the box", {}, true)                             \
  X(by_x, "of which the box's edges along x alone meet the triangle", {}, true)          \
  X(by_y, "of which the box's edges along y alone meet the triangle", {}, true)          \
  X(by_z, "of which the box's edges along z alone meet the triangle", {}, true)          \
  X(reached_by_a, "with edge bc beyond a facet of the box, and a not", {}, true)         \
  X(reached_by_b, "with edge ca beyond a facet of the box, and b not", {}, true)         \
  X(reached_by_c, "with edge ab beyond a facet of the box, and c not", {}, true)         \
  X(beyond_ab, "with edge ab beyond the box along a product of it, and c not", {}, true) \
  X(beyond_bc, "with edge bc beyond the box along a product of it, and a not", {}, true) \
  X(beyond_ca, "with edge ca beyond the box along a product of it, and b not", {}, true) \
  X(front, "with the box's centre in front of the triangle", {}, false, true)            \
  X(behind, "with the box's centre behind the triangle", {}, false, true)                \
  X(vertex_inside, "with a vertex in the box", "on_triangle")                            \
  X(all_inside, "with all vertices in the box", "on_triangle")                           \
  X(centre_inside, "with the box's centre in the triangle's plane", "on_triangle")       \
  X(parallel, "with parallel edges", "parallel")                                         \
  X(nearly_parallel, "with edges within 1 % of parallel", "parallel")                    \
  X(level_edge, "with an edge at right angles to an axis of the box")                    \
  X(axis_plane, "of a triangle in a plane x, y or z = constant", "aligned")              \
  X(axis_edge, "of a triangle with an edge along an axis", "aligned")                    \
  X(flat_triangle, "of a triangle without area", "flat")                                 \
  X(flat_box, "of a box without volume", "flat")                                         \
  X(thin_triangle, "of a triangle less than a thousandth as high as long")               \
  X(thin_box, "of a box less than a thousandth as thick as long")                        \
  X(large_triangle, "of a triangle a hundred times as large as the box")                 \
  X(small_triangle, "of a triangle less than a hundredth as large as the box")           \
  X(obtuse, "of an obtuse triangle", "obtuse")                                           \
  X(small, "with all numbers below 1e-3")                                                \
  X(large, "with a number of 1e4 or more")                                               \
  X(far, "with the origin 64 times as far away as the scene is long")

enum class CornerTrait : std::uint8_t { AXISCERT_CORNER_TRAITS(AXISCERT_TRAIT_ENUMERATOR) };
constexpr Trait corner_traits[] = {AXISCERT_CORNER_TRAITS(AXISCERT_TRAIT_ROW)};
static_assert(std::size(corner_traits) <= most_traits);

// The corners are seen from the box's centre.
Big reach(const std::array<Vec3<Big>, 3>& from, const Vec3<Big>& along) {
  return beyond_zero(dot(along, from[0]), dot(along, from[1]), dot(along, from[2]));
}
// Whether no axis of the thirteen parts the two, of which either may be flat, a segment or a point.
bool meets(const BoxAndTriangle<Big>& q) {
  const std::array<Vec3<Big>, 3> from = {q.corner[0] - q.box.centre, q.corner[1] - q.box.centre,
                                         q.corner[2] - q.box.centre};
  for (std::size_t i = 0; i < thirteen_count; ++i) {
    const Vec3<Big> along = direction(q, i);
    if (half_extent(q.box, along) < reach(from, along)) return false;
  }
  return true;
}
// With axis k's facet on one side moved away, so far that it is beyond the triangle.
BoxAndTriangle<Big> made_longer(BoxAndTriangle<Big> q, std::size_t k, bool is_below) {
  const Vec3<Big> normal = facet_normal(q.box, k);
  // Along the axis by `more` of it, which is above every corner's distance from the centre: |from . n| / |axis . n|.
  const Big unit = magnitude(dot(q.box.axis[k], normal));
  Big more = Big(1.0);
  for (const Vec3<Big>& corner : q.corner) {
    const Big distance = magnitude(dot(corner - q.box.centre, normal));
    while (more * unit < distance) more = more * Big(0x1p40);
  }
  q.box.half[k] = q.box.half[k] + more;
  q.box.centre = is_below ? q.box.centre - q.box.axis[k] * more : q.box.centre + q.box.axis[k] * more;
  return q;
}

// Where the two are apart: the sides of the box on which the triangle is, where it would meet the box if it went on
// there.
void put_sides(TraitBits<CornerTrait>& found, const BoxAndTriangle<Big>& q) {
  for (std::size_t k = 0; k < 3; ++k) {
    for (const bool is_below : {true, false}) {
      const auto which = static_cast<CornerTrait>(index_of(CornerTrait::below_x) + 2 * k + (is_below ? 0 : 1));
      found.put(which, meets(made_longer(q, k, is_below)));
    }
  }
}

// Where they are in contact: the edges of either that meet the other, and corners without which they would be apart.
void put_meeting(TraitBits<CornerTrait>& found, const BoxAndTriangle<Big>& q, const std::array<Vec3<Big>, 3>& from) {
  using enum CornerTrait;
  std::array<bool, 3> edge{}, along{};
  for (std::size_t j = 0; j < 3; ++j) {
    BoxAndTriangle<Big> one = q;
    one.corner = {q.corner[j], q.corner[(j + 1) % 3], q.corner[(j + 1) % 3]};
    edge[j] = meets(one);
    for (std::size_t corner = 0; corner < 4; ++corner) {
      BoxAndTriangle<Big> bar = q;
      for (std::size_t i = 1; i < 3; ++i) {
        const std::size_t k = (j + i) % 3;
        const Vec3<Big> to = half_edge(q.box, k);
        bar.box.centre = has_bit(corner, i - 1) ? bar.box.centre + to : bar.box.centre - to;
        bar.box.half[k] = Big();
      }
      along[j] = along[j] || meets(bar);
    }
  }
  const auto only = [](const std::array<bool, 3>& of, std::size_t j) { return of[j] && of[0] + of[1] + of[2] == 1; };
  found.put(no_edge, !edge[0] && !edge[1] && !edge[2]);
  for (std::size_t j = 0; j < 3; ++j) {
    const auto which = [&](CornerTrait first) { return static_cast<CornerTrait>(index_of(first) + j); };
    found.put(which(by_ab), only(edge, j));
    found.put(which(by_x), only(along, j));
    const std::size_t next_corner = (j + 1) % 3, other = (j + 2) % 3;
    for (std::size_t i = 0; i < 3; ++i) {
      const Vec3<Big> facet = direction(q, i), product = direction(q, edge_axis(i, j));
      const auto is_beyond = [&](const Vec3<Big>& l, std::size_t one, std::size_t two) {
        const Big first = dot(l, from[one]), second = dot(l, from[two]), most = half_extent(q.box, l);
        return (most < first && most < second) || (first < -most && second < -most);
      };
      found.put(which(reached_by_a), is_beyond(facet, next_corner, other));
      found.put(which(beyond_ab), is_beyond(product, j, next_corner));
    }
  }
}

template <class Given>
TraitSet corner_traits_of(const Given& given, const std::vector<double>& sizes, const portable::Vec3<double>& of_box) {
  using enum CornerTrait;
  const BoxAndTriangle<Big> q = scaled<Big>(given);
  const ExactTriangle triangle({given.corner[0], given.corner[1], given.corner[2]});
  std::array<Vec3<Big>, 3> from;
  for (std::size_t k = 0; k < 3; ++k) from[k] = q.corner[k] - q.box.centre;
  TraitBits<CornerTrait> found;
  const DecidingAxes axes = deciding(thirteen_count, [&](std::size_t i) {
    const Vec3<Big> along = direction(q, i);
    return Rest{half_extent(q.box, along) - reach(from, along), squared_length(along)};
  });
  if (std::popcount(axes.parting) == 1) {
    const std::size_t i = first_bit(axes.parting);
    found.put(static_cast<CornerTrait>(i));
    found.put(facet_alone, i < 3);
    found.put(edges_alone, i > plane_axis);
  }
  found.put(several, std::popcount(axes.parting) > 1);
  if (axes.parting != 0) put_sides(found, q);
  else put_meeting(found, q, from);
  found.put(shallow_facet, (axes.least & 0x7) != 0);
  found.put(shallow_plane, has_bit(axes.least, plane_axis));
  found.put(shallow_edges, axes.least >> (plane_axis + 1) != 0);
  const int side = dot(from[0], direction(q, plane_axis)).sign();
  found.put(front, side < 0);
  found.put(behind, side > 0);
  std::size_t inside = 0;
  for (const Vec3<Big>& corner : q.corner) inside += is_inside(corner, q.box);
  found.put(vertex_inside, inside != 0);
  found.put(all_inside, inside == 3);
  found.put(centre_inside, !triangle.is_flat() && side == 0);

  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3<Big>& edge = triangle.edge[j];
    if (squared_length(edge).is_zero()) continue;
    for (const Vec3<Big>& axis : q.box.axis) {
      found.put(parallel, is_parallel(axis, edge));
      found.put(nearly_parallel, is_nearly_parallel(axis, edge));
      found.put(level_edge, dot(axis, edge).is_zero());
    }
  }
  found.put(axis_plane, triangle.is_in_plane_of_axes());
  found.put(axis_edge, triangle.has_edge_along_axis());
  found.put(flat_triangle, triangle.is_flat());
  found.put(flat_box, is_flat(q.box));
  found.put(thin_triangle, triangle.is_thin());
  found.put(thin_box, is_thin(q.box));
  // By edges, in the query's scale.
  Big longest;
  for (std::size_t j = 0; j < 3; ++j) {
    const Big squared = squared_length(q.corner[(j + 1) % 3] - q.corner[j]);
    if (longest < squared) longest = squared;
  }
  const Big box = squared_size(q.box) * Big(4.0);
  found.put(large_triangle, is_below(box, longest, 1e4));
  found.put(small_triangle, is_below(longest, box, 1e4));
  found.put(obtuse, triangle.is_obtuse());
  found.put(small, is_small_scene(sizes));
  found.put(large, is_large_scene(sizes));
  const std::array points = {given.corner[0], given.corner[1], given.corner[2], of_box};
  found.put(far, is_far_away(points));
  return found.bits();
}

TraitSet traits_of_box_and_triangle(const std::vector<double>& numbers, std::size_t entry) {
  if (entry == CentreEntry::entry) {
    const auto given = given_of<CentreEntry>(numbers);
    return corner_traits_of(given, numbers, given.centre);
  }
  if (entry == MinmaxEntry::entry) {
    const auto given = given_of<MinmaxEntry>(numbers);
    return corner_traits_of(given, numbers, given.low);
  }
  std::vector<double> sizes = numbers;  // without the axes, or the quaternion
  sizes.erase(sizes.begin() + 6, sizes.end() - 9);
  const auto traits_of = [&](const auto& given) { return corner_traits_of(given, sizes, given.box.centre); };
  if (entry == TurnedEntry::entry) return traits_of(given_of<TurnedEntry>(numbers));
  return traits_of(given_of<OrientedEntry>(numbers));
}

}  // namespace
}  // namespace boxes

const Traits& box_triangle_traits() {
  static constexpr Traits traits = {"boxes and triangles", boxes::corner_traits, boxes::traits_of_box_and_triangle};
  return traits;
}

}  // namespace axiscert
