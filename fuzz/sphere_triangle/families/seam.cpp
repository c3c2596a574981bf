// Centres solved onto each of the nine side boundaries, which are the seams between the regions of two features.
//
// On a seam the distances to both features are equal, so either axis separates and a wrong side is masked by the other
// feature's radius comparison, unless the radius is within rounding of the distance, where both can be wrong at once.
// Hence half of the radii are chosen there.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/floats.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/seam.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Seam {
  static constexpr bool solves = true;

  struct Side {
    Comparison comparison;
    // True: between the regions of vertex `from` and of the edge towards `to`; false: between those of the edge from
    // `from` to `to` and the face.
    bool at_vertex;
    std::uint8_t from, to;
    // The index of a vertex of the query among the local ones: `from`, `to` and the third.
    constexpr int local(std::size_t vertex) const { return vertex == from ? 0 : vertex == to ? 1 : 2; }
  };
  static constexpr std::array<Side, 9> sides = {{
      {Comparison::vertex_a_side_b, true, 0, 1},
      {Comparison::vertex_a_side_c, true, 0, 2},
      {Comparison::vertex_b_side_a, true, 1, 0},
      {Comparison::vertex_b_side_c, true, 1, 2},
      {Comparison::vertex_c_side_a, true, 2, 0},
      {Comparison::vertex_c_side_b, true, 2, 1},
      {Comparison::edge_ab_side_c, false, 0, 1},
      {Comparison::edge_bc_side_a, false, 1, 2},
      {Comparison::edge_ca_side_b, false, 2, 0},
  }};
  static const Side& side(std::uint64_t position) { return sides[position % 9]; }
  static bool radius_at_boundary(std::uint64_t position) { return position / 9 % 2 == 0; }
  static int ulps(std::uint64_t position) { return static_cast<int>(position / 18 % 9) - 4; }

  // One of the coordinates in which the gradient is at least half as large as in its largest coordinate: 0, 1 or 2.
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static T effective_coordinate(Random& random, const Vec3<T>& gradient) {
    const T zero = Random::constant(0), one = Random::constant(1), two = Random::constant(2);
    const T effect[3] = {magnitude(gradient.x), magnitude(gradient.y), magnitude(gradient.z)};
    const T least = greater_of(greater_of(effect[0], effect[1]), effect[2]) * Random::constant(0.5);
    T eligible[3];  // 1 or 0
    for (int k = 0; k < 3; ++k) eligible[k] = select(hn::Ge(effect[k].v, least.v), one, zero);
    const T count = eligible[0] + eligible[1] + eligible[2];
    // Six is divisible by two and by three: the index among the eligible coordinates, counted from 0.
    const T sixths = random.integer(0, 5) * count, six = Random::constant(6), twelve = Random::constant(12);
    const T which = select(hn::Ge(sixths.v, six.v), one, zero) + select(hn::Ge(sixths.v, twelve.v), one, zero);
    const auto takes = [&](int k, const T& before)
                           HWY_ATTR { return hn::And(hn::Eq(eligible[k].v, one.v), hn::Eq(which.v, before.v)); };
    return select(takes(0, zero), zero, select(takes(1, eligible[0]), one, two));
  }

  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    const T vertex_seam = in_turn<Random, 9>(first, [](std::uint64_t p) { return side(p).at_vertex; });
    const auto at_vertex = hn::Gt(vertex_seam.v, Random::constant(0).v);
    const auto v = vertices_in_cube(random);
    const Vec3<T> normal = unit_normal(v), across = outward(v[0], v[1], normal), along = v[1] - v[0];
    const T up = random.symmetric(), share = random.unit() + Random::constant(0x1p-5);
    const Vec3<T> foot = select(at_vertex, v[0], v[0] + along * share_of_edge(random));
    const Vec3<T> direction = select(at_vertex, normal * up + across * share, normal * up);
    LaneQuery<T> q;
    q.p = foot + at_unit_length(direction) * height(random);
    q.wishes[0] = effective_coordinate(random, select(at_vertex, along, across));
    q.wishes[1] = random.integer(-2, 2);
    q.r = random.unit() * Random::constant(2);
    const T a = in_turn<Random, 9>(first, [](std::uint64_t p) { return side(p).local(0); });
    const T b = in_turn<Random, 9>(first, [](std::uint64_t p) { return side(p).local(1); });
    q.v = arranged(v, a, b);
    return q;
  }

  // Wishes: the coordinate to solve for; the difference in ulps between a radius at the distance and the distance.
  template <class Real>
  static void finish(std::uint64_t first, const MutableColumns<Real>& queries, const shapes::Wishes<Real>& wishes) {
    for (std::size_t i = 0; i < queries.size; ++i) {
      const std::uint64_t position = first + i;
      const auto k = static_cast<int>(wishes[0][i]);
      queries.column[static_cast<std::size_t>(9 + k)][i] =
          step_ulps(coordinate_on_boundary(query_from(queries[i]), side(position).comparison, k), ulps(position));
      if (!radius_at_boundary(position)) continue;
      queries.column[12][i] = step_radius(radius_at_distance(query_from(queries[i])), static_cast<int>(wishes[1][i]));
    }
  }
};

}  // namespace
AXISCERT_FILL(seam, Seam)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(seam)
extern const Family seam_family = {
    sphere_triangle_predicate,
    "seam",
    "centre on the boundary of each side comparison in turn, -4 to +4 ulp, half of the radii at the distance",
    2,
    false,
    seam_queries<float>,
    seam_queries<double>};
}  // namespace axiscert
#endif
