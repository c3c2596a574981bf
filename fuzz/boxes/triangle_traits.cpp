#include "fuzz/boxes/traits.h"

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

enum class CornerTrait : std::uint8_t {
  x,
  y,
  z,
  plane,
  x_ab,
  x_bc,
  x_ca,
  y_ab,
  y_bc,
  y_ca,
  z_ab,
  z_bc,
  z_ca,
  facet,
  edges,
  several,
  vertex_inside,
  all_inside,
  crosses,
  parallel,
  nearly_parallel,
  axis_plane,
  axis_edge,
  flat_triangle,
  flat_box,
  thin_triangle,
  thin_box,
  large_triangle,
  small_triangle,
  obtuse,
  small,
  large,
  far,
};

}  // namespace
}  // namespace boxes
template <>
inline constexpr std::size_t enum_count<boxes::CornerTrait> = 33;
namespace boxes {
namespace {

constexpr EnumArray<CornerTrait, Trait> corner_traits = {{
    {"x_alone", "parted by the box's facet x alone", "regions"},
    {"y_alone", "parted by the box's facet y alone", "regions"},
    {"z_alone", "parted by the box's facet z alone", "regions"},
    {"plane_alone", "parted by the triangle's plane alone", "regions"},
    {"x_ab_alone", "parted by x x ab alone", "regions"},
    {"x_bc_alone", "parted by x x bc alone", "regions"},
    {"x_ca_alone", "parted by x x ca alone", "regions"},
    {"y_ab_alone", "parted by y x ab alone", "regions"},
    {"y_bc_alone", "parted by y x bc alone", "regions"},
    {"y_ca_alone", "parted by y x ca alone", "regions"},
    {"z_ab_alone", "parted by z x ab alone", "regions"},
    {"z_bc_alone", "parted by z x bc alone", "regions"},
    {"z_ca_alone", "parted by z x ca alone", "regions"},
    {"facet_alone", "parted by one facet of the box alone", "regions"},
    {"edges_alone", "parted by one product of edges alone", "regions"},
    {"several", "parted by several axes", "regions"},
    {"vertex_inside", "with a vertex in the box", "on_triangle"},
    {"all_inside", "with all vertices in the box", "on_triangle"},
    {"centre_inside", "with the box's centre in the triangle's plane", "on_triangle"},
    {"parallel", "with parallel edges", "parallel"},
    {"nearly_parallel", "with edges within 1 % of parallel", "parallel"},
    {"axis_plane", "of a triangle in a plane x, y or z = constant", "aligned"},
    {"axis_edge", "of a triangle with an edge along an axis", "aligned"},
    {"flat_triangle", "of a triangle without area", "flat"},
    {"flat_box", "of a box without volume", "flat"},
    {"thin_triangle", "of a triangle less than a thousandth as high as long"},
    {"thin_box", "of a box less than a thousandth as thick as long"},
    {"large_triangle", "of a triangle a hundred times as large as the box"},
    {"small_triangle", "of a triangle less than a hundredth as large as the box"},
    {"obtuse", "of an obtuse triangle", "obtuse"},
    {"small", "with all numbers below 1e-3"},
    {"large", "with a number of 1e4 or more"},
    {"far", "with the origin 64 times as far away as the scene is long"},
}};

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
    return Rest{half_extent(q.box, along) - beyond_zero(dot(along, from[0]), dot(along, from[1]), dot(along, from[2])),
                squared_length(along)};
  });
  if (std::popcount(axes.parting) == 1) {
    const std::size_t i = first_bit(axes.parting);
    found.put(static_cast<CornerTrait>(i));
    found.put(facet, i < 3);
    found.put(edges, i > plane_axis);
  }
  found.put(several, std::popcount(axes.parting) > 1);
  std::size_t inside = 0;
  for (const Vec3<Big>& corner : q.corner) inside += is_inside(corner, q.box);
  found.put(vertex_inside, inside != 0);
  found.put(all_inside, inside == 3);
  found.put(crosses, !triangle.is_flat() && dot(from[0], direction(q, plane_axis)).is_zero());

  for (std::size_t j = 0; j < 3; ++j) {
    const Vec3<Big>& edge = triangle.edge[j];
    if (squared_length(edge).is_zero()) continue;
    for (const Vec3<Big>& axis : q.box.axis) {
      found.put(parallel, is_parallel(axis, edge));
      found.put(nearly_parallel, is_nearly_parallel(axis, edge));
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

class BoxTriangleTraits final : public Traits {
 public:
  std::string_view noun() const override { return "boxes and triangles"; }
  std::span<const Trait> all() const override { return {corner_traits.begin(), corner_traits.end()}; }
  TraitSet of(const Numbers<float>& q, std::size_t entry) const override { return found(doubles(q), entry); }
  TraitSet of(const Numbers<double>& q, std::size_t entry) const override { return found(doubles(q), entry); }

 private:
  static TraitSet found(const std::vector<double>& numbers, std::size_t entry) {
    if (entry == CentreEntry::entry) {
      const auto given = given_of<CentreEntry>(numbers);
      return corner_traits_of(given, numbers, given.centre);
    }
    if (entry == MinmaxEntry::entry) {
      const auto given = given_of<MinmaxEntry>(numbers);
      return corner_traits_of(given, numbers, given.low);
    }
    const auto given = given_of<OrientedEntry>(numbers);
    std::vector<double> sizes = numbers;  // without the axes
    sizes.erase(sizes.begin() + 6, sizes.begin() + 15);
    return corner_traits_of(given, sizes, given.box.centre);
  }
};

}  // namespace
}  // namespace boxes

const Traits& box_triangle_traits() {
  static const boxes::BoxTriangleTraits traits;
  return traits;
}

}  // namespace axiscert
