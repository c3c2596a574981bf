#include "fuzz/boxes/traits.h"

#include <algorithm>
#include <array>
#include <bit>
#include <optional>
#include <vector>

#include "exact/boxes/scaled.h"
#include "fuzz/sphere_triangle/traits.h"
#include "kernel/base/enums.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert {
namespace boxes {
namespace {

using Big = BinaryNumber;
using BigBox = OrientedBox<Big>;

// Which axes part two bodies, or on which they are least deep in each other: bit i of axis i.
struct DecidingAxes {
  std::uint32_t parting = 0, least = 0;
};

// On axis i, what is left of the extents beside the distance, times |L|; |L|^2, which is 0 where there is no axis.
struct Rest {
  Big rest, squared_length;
};

template <class RestOf>
DecidingAxes deciding(std::size_t count, const RestOf& rest_of) {
  DecidingAxes found;
  std::optional<Rest> least;
  for (std::size_t i = 0; i < count; ++i) {
    const Rest one = rest_of(i);
    if (one.squared_length.is_zero()) continue;
    if (one.rest.sign() < 0) found.parting |= one_bit<std::uint32_t>(i);
    if (found.parting != 0) continue;
    // rest / |L| of both, by squares.
    const int compared =
        least ? order(one.rest * one.rest * least->squared_length, least->rest * least->rest * one.squared_length) : -1;
    if (compared > 0) continue;
    if (compared < 0) {
      found.least = 0;
      least = one;
    }
    found.least |= one_bit<std::uint32_t>(i);
  }
  if (found.parting != 0) found.least = 0;
  return found;
}

// Whether x is below y / factor, both not negative.
bool is_below(const Big& x, const Big& y, double factor) { return x * Big(factor) < y; }

// Cosine above 0.9999 or so: the sine is below a hundredth.
bool is_nearly_parallel(const Vec3<Big>& u, const Vec3<Big>& v) {
  const Big product = squared_length(cross(u, v));
  return !product.is_zero() && is_below(product, squared_length(u) * squared_length(v), 1e4);
}
bool is_parallel(const Vec3<Big>& u, const Vec3<Big>& v) { return squared_length(cross(u, v)).is_zero(); }

Vec3<Big> half_edge(const BigBox& box, std::size_t k) { return box.axis[k] * box.half[k]; }
Big squared_size(const BigBox& box) {
  return squared_length(half_edge(box, 0)) + squared_length(half_edge(box, 1)) + squared_length(half_edge(box, 2));
}
bool is_flat(const BigBox& box) {
  return std::ranges::any_of(box.half, [](const Big& half) { return half.is_zero(); });
}
// With its shortest edge above 0 and below a thousandth of its longest.
bool is_thin(const BigBox& box) {
  std::array<Big, 3> squares;
  for (std::size_t k = 0; k < 3; ++k) squares[k] = squared_length(half_edge(box, k));
  std::ranges::sort(squares, [](const Big& x, const Big& y) { return x < y; });
  return !squares[0].is_zero() && is_below(squares[0], squares[2], 1e6);
}
bool is_inside(const Vec3<Big>& point, const BigBox& box) {
  const Vec3<Big> from = point - box.centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<Big> normal = facet_normal(box, k);
    if (box.half[k] * magnitude(dot(box.axis[k], normal)) < magnitude(dot(from, normal))) return false;
  }
  return true;
}
// Each axis along one of the world's.
bool is_level(const BigBox& box) {
  return std::ranges::all_of(
      box.axis, [](const Vec3<Big>& axis) { return axis.x.is_zero() + axis.y.is_zero() + axis.z.is_zero() == 2; });
}

std::vector<double> doubles(const auto& numbers) { return {numbers.begin(), numbers.end()}; }

// Two boxes.

enum class PairTrait : std::uint8_t {
  a0,
  a1,
  a2,
  b0,
  b1,
  b2,
  a0b0,
  a0b1,
  a0b2,
  a1b0,
  a1b1,
  a1b2,
  a2b0,
  a2b1,
  a2b2,
  facet_of_a,
  facet_of_b,
  facet,
  edges,
  several,
  shallow_facet,
  shallow_edges,
  parallel,
  nearly_parallel,
  same_axes,
  a_level,
  b_level,
  both_level,
  flat,
  thin,
  larger,
  inside,
  same_centre,
  short_quaternion,
  long_quaternion,
  other_norm,
  tiny_w,
  identity,
  scaled_axes,
  small,
  large,
  far,
};

}  // namespace
}  // namespace boxes
template <>
inline constexpr std::size_t enum_count<boxes::PairTrait> = 42;
namespace boxes {
namespace {

constexpr EnumArray<PairTrait, Trait> pair_traits = {{
    {"a0_alone", "parted by a0 alone", "regions"},
    {"a1_alone", "parted by a1 alone", "regions"},
    {"a2_alone", "parted by a2 alone", "regions"},
    {"b0_alone", "parted by b0 alone", "regions"},
    {"b1_alone", "parted by b1 alone", "regions"},
    {"b2_alone", "parted by b2 alone", "regions"},
    {"a0b0_alone", "parted by a0 x b0 alone", "regions"},
    {"a0b1_alone", "parted by a0 x b1 alone", "regions"},
    {"a0b2_alone", "parted by a0 x b2 alone", "regions"},
    {"a1b0_alone", "parted by a1 x b0 alone", "regions"},
    {"a1b1_alone", "parted by a1 x b1 alone", "regions"},
    {"a1b2_alone", "parted by a1 x b2 alone", "regions"},
    {"a2b0_alone", "parted by a2 x b0 alone", "regions"},
    {"a2b1_alone", "parted by a2 x b1 alone", "regions"},
    {"a2b2_alone", "parted by a2 x b2 alone", "regions"},
    {"facet_of_a_alone", "parted by one facet of A alone", "regions"},
    {"facet_of_b_alone", "parted by one facet of B alone", "regions"},
    {"facet_alone", "parted by one facet alone", "regions"},
    {"edges_alone", "parted by one product of edges alone", "regions"},
    {"several", "parted by several axes", "regions"},
    {"shallow_facet", "least deep along a facet", "regions"},
    {"shallow_edges", "least deep along a product of edges", "regions"},
    {"parallel", "with parallel edges", "parallel"},
    {"nearly_parallel", "with edges within 1 % of parallel", "parallel"},
    {"same_axes", "with all edges parallel", "parallel"},
    {"a_level", "with A along the axes", "aligned"},
    {"b_level", "with B along the axes", "aligned"},
    {"both_level", "with both along the axes", "aligned"},
    {"flat", "with a box without volume", "flat"},
    {"thin", "with a box less than a thousandth as thick as long", "flat"},
    {"larger", "with one a hundred times as large as the other"},
    {"inside", "with the centre of one inside the other"},
    {"same_centre", "with the same centre"},
    {"short_quaternion", "with a quaternion shorter than a thousandth"},
    {"long_quaternion", "with a quaternion longer than a thousand"},
    {"other_norm", "with a quaternion not within 1 % of length 1"},
    {"tiny_w", "with w below a thousandth of its quaternion"},
    {"identity", "with a quaternion that does not turn"},
    {"scaled_axes", "with an axis not within 1 % of length 1"},
    {"small", "with all numbers below 1e-3"},
    {"large", "with a number of 1e4 or more"},
    {"far", "with the origin 64 times as far away as the scene is long"},
}};

PairTrait pair_axis(std::size_t i) { return static_cast<PairTrait>(i); }

// Whether a squared length is from 0.99^2 to 1.01^2.
bool is_about_one(const Big& squared) { return squared >= Big(0.9801) && squared <= Big(1.0201); }

void put_quaternion(TraitBits<PairTrait>& found, const TurnedBox<double>& box) {
  using enum PairTrait;
  Big square;
  for (const double x : box.q) square = square + Big(x) * Big(x);
  found.put(short_quaternion, square < Big(1e-6));
  found.put(long_quaternion, square > Big(1e6));
  found.put(other_norm, !is_about_one(square));
  found.put(tiny_w, Big(box.q[0]) * Big(box.q[0]) * Big(1e6) < square);
  found.put(identity, box.q[1] == 0 && box.q[2] == 0 && box.q[3] == 0);
}
void put_given(TraitBits<PairTrait>& found, const TurnedPair<double>& q) {
  put_quaternion(found, q.a);
  put_quaternion(found, q.b);
}
void put_given(TraitBits<PairTrait>& found, const BoxPair<double>& q) {
  for (const OrientedBox<double>* box : {&q.a, &q.b}) {
    for (const Vec3<double>& axis : box->axis)
      found.put(PairTrait::scaled_axes, !is_about_one(squared_length(exact_vector(axis))));
  }
}

template <class Given>
TraitSet pair_traits_of(const Given& given) {
  using enum PairTrait;
  const BoxPair<Big> q = scaled<Big>(given);
  const Vec3<Big> between = q.b.centre - q.a.centre;
  TraitBits<PairTrait> found;
  const DecidingAxes axes = deciding(axis_count, [&](std::size_t i) {
    const Vec3<Big> along = direction(q, i);
    return Rest{half_extent(q.a, along) + half_extent(q.b, along) - magnitude(dot(between, along)),
                squared_length(along)};
  });
  if (std::popcount(axes.parting) == 1) {
    const std::size_t i = first_bit(axes.parting);
    found.put(pair_axis(i));
    found.put(facet_of_a, i < 3);
    found.put(facet_of_b, i >= 3 && i < 6);
    found.put(facet, i < 6);
    found.put(edges, i >= 6);
  }
  found.put(several, std::popcount(axes.parting) > 1);
  found.put(shallow_facet, (axes.least & 0x3f) != 0);
  found.put(shallow_edges, (axes.least & ~0x3fu) != 0);

  std::size_t pairs = 0;
  for (const Vec3<Big>& u : q.a.axis) {
    for (const Vec3<Big>& v : q.b.axis) {
      pairs += is_parallel(u, v);
      found.put(nearly_parallel, is_nearly_parallel(u, v));
    }
  }
  found.put(parallel, pairs != 0);
  found.put(same_axes, pairs == 3);
  found.put(a_level, is_level(q.a));
  found.put(b_level, is_level(q.b));
  found.put(both_level, is_level(q.a) && is_level(q.b));

  found.put(flat, is_flat(q.a) || is_flat(q.b));
  found.put(thin, is_thin(q.a) || is_thin(q.b));
  const Big size_a = squared_size(q.a), size_b = squared_size(q.b);
  found.put(larger, is_below(size_a, size_b, 1e4) || is_below(size_b, size_a, 1e4));
  found.put(inside, is_inside(q.b.centre, q.a) || is_inside(q.a.centre, q.b));
  found.put(same_centre, squared_length(between).is_zero());
  put_given(found, given);
  // Of the lengths and places, without the axes.
  std::vector<double> sizes;
  double extent = 0;
  for (const auto* box : {&given.a, &given.b}) {
    for (const double x : {box->centre.x, box->centre.y, box->centre.z}) sizes.push_back(x);
    for (const double x : box->half) {
      sizes.push_back(x);
      extent = std::max(extent, x);
    }
  }
  found.put(small, is_small_scene(sizes));
  found.put(large, is_large_scene(sizes));
  const std::array centres = {given.a.centre, given.b.centre};
  found.put(far, is_far_away(centres, extent));
  return found.bits();
}

template <class Entry>
auto given_of(const std::vector<double>& numbers) {
  return Entry::template problem<double>([&](std::size_t k) { return numbers[k]; });
}

class BoxBoxTraits final : public Traits {
 public:
  std::string_view noun() const override { return "pairs of boxes"; }
  std::span<const Trait> all() const override { return {pair_traits.begin(), pair_traits.end()}; }
  TraitSet of(const Numbers<float>& q, std::size_t entry) const override { return found(doubles(q), entry); }
  TraitSet of(const Numbers<double>& q, std::size_t entry) const override { return found(doubles(q), entry); }

 private:
  static TraitSet found(const std::vector<double>& numbers, std::size_t entry) {
    if (entry == MatrixBoxes::entry) return pair_traits_of(given_of<MatrixBoxes>(numbers));
    return pair_traits_of(given_of<QuaternionBoxes>(numbers));
  }
};

// A box and a triangle.

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

const Traits& box_box_traits() {
  static const boxes::BoxBoxTraits traits;
  return traits;
}
const Traits& box_triangle_traits() {
  static const boxes::BoxTriangleTraits traits;
  return traits;
}

}  // namespace axiscert
