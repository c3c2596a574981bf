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

#define AXISCERT_PAIR_TRAITS(X)                                                      \
  X(a0_alone, "parted by a0 alone", "regions", true)                                 \
  X(a1_alone, "parted by a1 alone", "regions", true)                                 \
  X(a2_alone, "parted by a2 alone", "regions", true)                                 \
  X(b0_alone, "parted by b0 alone", "regions", true)                                 \
  X(b1_alone, "parted by b1 alone", "regions", true)                                 \
  X(b2_alone, "parted by b2 alone", "regions", true)                                 \
  X(a0b0_alone, "parted by a0 x b0 alone", "regions", true)                          \
  X(a0b1_alone, "parted by a0 x b1 alone", "regions", true)                          \
  X(a0b2_alone, "parted by a0 x b2 alone", "regions", true)                          \
  X(a1b0_alone, "parted by a1 x b0 alone", "regions", true)                          \
  X(a1b1_alone, "parted by a1 x b1 alone", "regions", true)                          \
  X(a1b2_alone, "parted by a1 x b2 alone", "regions", true)                          \
  X(a2b0_alone, "parted by a2 x b0 alone", "regions", true)                          \
  X(a2b1_alone, "parted by a2 x b1 alone", "regions", true)                          \
  X(a2b2_alone, "parted by a2 x b2 alone", "regions", true)                          \
  X(facet_of_a_alone, "parted by one facet of A alone", "regions")                   \
  X(facet_of_b_alone, "parted by one facet of B alone", "regions")                   \
  X(facet_alone, "parted by one facet alone", "regions")                             \
  X(edges_alone, "parted by one product of edges alone", "regions")                  \
  X(several, "parted by several axes", "regions")                                    \
  X(shallow_facet, "least deep along a facet", "regions")                            \
  X(shallow_edges, "least deep along a product of edges", "regions")                 \
  X(a0_decides, "decided by a0", {}, true)                                           \
  X(a1_decides, "decided by a1", {}, true)                                           \
  X(a2_decides, "decided by a2", {}, true)                                           \
  X(b0_decides, "decided by b0", {}, true)                                           \
  X(b1_decides, "decided by b1", {}, true)                                           \
  X(b2_decides, "decided by b2", {}, true)                                           \
  X(a0b0_decides, "decided by a0 x b0", {}, true)                                    \
  X(a0b1_decides, "decided by a0 x b1", {}, true)                                    \
  X(a0b2_decides, "decided by a0 x b2", {}, true)                                    \
  X(a1b0_decides, "decided by a1 x b0", {}, true)                                    \
  X(a1b1_decides, "decided by a1 x b1", {}, true)                                    \
  X(a1b2_decides, "decided by a1 x b2", {}, true)                                    \
  X(a2b0_decides, "decided by a2 x b0", {}, true)                                    \
  X(a2b1_decides, "decided by a2 x b1", {}, true)                                    \
  X(a2b2_decides, "decided by a2 x b2", {}, true)                                    \
  X(no_edge_of_a, "of which no edge of A meets B")                                   \
  X(no_edge_of_b, "of which no edge of B meets A")                                   \
  X(parallel, "with parallel edges", "parallel")                                     \
  X(nearly_parallel, "with edges within 1 % of parallel", "parallel")                \
  X(same_axes, "with all edges parallel", "parallel")                                \
  X(perpendicular, "with edges at right angles")                                     \
  X(a_level, "with A along the axes", "aligned")                                     \
  X(b_level, "with B along the axes", "aligned")                                     \
  X(both_level, "with both along the axes", "aligned")                               \
  X(flat, "with a box without volume", "flat")                                       \
  X(thin, "with a box less than a thousandth as thick as long", "flat")              \
  X(larger, "with one a hundred times as large as the other")                        \
  X(inside, "with the centre of one inside the other")                               \
  X(same_centre, "with the same centre")                                             \
  X(short_quaternion, "with a quaternion shorter than a thousandth")                 \
  X(long_quaternion, "with a quaternion longer than a thousand")                     \
  X(other_norm, "with a quaternion not within 1 % of length 1")                      \
  X(tiny_w, "with w below a thousandth of its quaternion")                           \
  X(identity, "with a quaternion that does not turn")                                \
  X(tiny_turn, "with the vector part of a quaternion below 1e-3 of w, and not 0")    \
  X(tiniest_turn, "with the vector part of a quaternion below 1e-6 of w, and not 0") \
  X(scaled_axes, "with an axis not within 1 % of length 1")                          \
  X(small, "with all numbers below 1e-3")                                            \
  X(large, "with a number of 1e4 or more")                                           \
  X(far, "with the origin 64 times as far away as the scene is long")

enum class PairTrait : std::uint8_t { AXISCERT_PAIR_TRAITS(AXISCERT_TRAIT_ENUMERATOR) };
constexpr Trait pair_traits[] = {AXISCERT_PAIR_TRAITS(AXISCERT_TRAIT_ROW)};
static_assert(std::size(pair_traits) <= most_traits);

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
  const bool does_turn = box.q[1] != 0 || box.q[2] != 0 || box.q[3] != 0;
  found.put(identity, !does_turn);
  const Big w = Big(box.q[0]) * Big(box.q[0]), vector = square - w;
  found.put(tiny_turn, does_turn && is_below(vector, w, 1e6));
  found.put(tiniest_turn, does_turn && is_below(vector, w, 1e12));
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

bool meets(const BoxPair<Big>& q) {
  const Vec3<Big> between = q.b.centre - q.a.centre;
  for (std::size_t i = 0; i < axis_count; ++i) {
    const Vec3<Big> along = direction(q, i);
    if (half_extent(q.a, along) + half_extent(q.b, along) < magnitude(dot(between, along))) return false;
  }
  return true;
}
// Whether one of the box's twelve edges has a point of the other.
bool does_edge_meet(const BigBox& box, const BigBox& other) {
  for (std::size_t edge = 0; edge < 12; ++edge) {
    BigBox bar = box;
    for (std::size_t i = 1; i < 3; ++i) {
      const std::size_t k = (edge / 4 + i) % 3;
      const Vec3<Big> to = half_edge(box, k);
      bar.centre = has_bit(edge, i - 1) ? bar.centre + to : bar.centre - to;
      bar.half[k] = Big();
    }
    if (meets({bar, other})) return true;
  }
  return false;
}
void put_given(TraitBits<PairTrait>&, const CornersPair<double>&) {}
void put_given(TraitBits<PairTrait>& found, const MixedPair<double>& q) { put_quaternion(found, q.b); }

// Its centre and half extents, in doubles.
template <class Box>
const Box& placed(const Box& box) {
  return box;
}
OrientedBox<double> placed(const CornersBox<double>& box) { return with_matrix(box); }

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
    found.put(static_cast<PairTrait>(i));
    found.put(facet_of_a_alone, i < 3);
    found.put(facet_of_b_alone, i >= 3 && i < 6);
    found.put(facet_alone, i < 6);
    found.put(edges_alone, i >= 6);
  }
  found.put(several, std::popcount(axes.parting) > 1);
  found.put(shallow_facet, (axes.least & 0x3f) != 0);
  found.put(shallow_edges, (axes.least & ~0x3fu) != 0);
  // An axis decides that parts the two alone, or along which alone they are least deep.
  const std::uint32_t deciding_axes = axes.parting | axes.least;
  if (std::popcount(deciding_axes) == 1)
    found.put(static_cast<PairTrait>(index_of(a0_decides) + first_bit(deciding_axes)));
  found.put(no_edge_of_a, axes.parting == 0 && !does_edge_meet(q.a, q.b));
  found.put(no_edge_of_b, axes.parting == 0 && !does_edge_meet(q.b, q.a));

  std::size_t pairs = 0;
  for (const Vec3<Big>& u : q.a.axis) {
    for (const Vec3<Big>& v : q.b.axis) {
      pairs += is_parallel(u, v);
      found.put(nearly_parallel, is_nearly_parallel(u, v));
      found.put(perpendicular, dot(u, v).is_zero());
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
  // The lengths and places, without the axes.
  std::vector<double> sizes;
  double extent = 0;
  const auto add = [&](const auto& box) {
    for (const double x : {box.centre.x, box.centre.y, box.centre.z}) sizes.push_back(x);
    for (const double x : box.half) {
      sizes.push_back(x);
      extent = std::max(extent, x);
    }
    return box.centre;
  };
  const std::array centres = {add(placed(given.a)), add(placed(given.b))};
  found.put(small, is_small_scene(sizes));
  found.put(large, is_large_scene(sizes));
  found.put(far, is_far_away(centres, extent));
  return found.bits();
}

TraitSet traits_of_pair(const std::vector<double>& numbers, std::size_t entry) {
  if (entry == MinmaxBoxes::entry) return pair_traits_of(given_of<MinmaxBoxes>(numbers));
  if (entry == MixedBoxes::entry) return pair_traits_of(given_of<MixedBoxes>(numbers));
  if (entry == MatrixBoxes::entry) return pair_traits_of(given_of<MatrixBoxes>(numbers));
  return pair_traits_of(given_of<QuaternionBoxes>(numbers));
}

}  // namespace
}  // namespace boxes

const Traits& box_box_traits() {
  static constexpr Traits traits = {"pairs of boxes", boxes::pair_traits, boxes::traits_of_pair};
  return traits;
}

}  // namespace axiscert
