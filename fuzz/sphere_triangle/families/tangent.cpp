// Radii solved onto each of the seven radius boundaries, with the centre in the region where that axis decides.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/floats.h"
#include "kernel/sphere_triangle/query.h"
#include "fuzz/sphere_triangle/families/parts/lanes.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/tangent.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Tangent {
  static constexpr bool solves = true;

  static std::size_t axis(std::uint64_t position) { return position % axis_count; }
  static int ulps(std::uint64_t position) { return static_cast<int>(position / axis_count % 9) - 4; }
  // The vertex at the axis's feature; an edge runs from there to the next.
  static std::size_t vertex(std::uint64_t position) { return axis(position) == 0 ? 0 : (axis(position) - 1) % 3; }

  // A centre whose nearest triangle point lies inside the feature that the axis is named after. Local vertex 0 is at
  // the feature. Together with the normal of either sign, the outward direction of an edge spans the half plane of
  // directions whose nearest triangle point lies on that edge; those of a vertex's two edges span, with the normal, the
  // cone of directions at that vertex.
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    const T kind = in_turn<Random, axis_count>(first, [](std::uint64_t p) {
      return axis(p) == 0 ? 0 : axis(p) < 4 ? 1 : 2;
    });
    const auto at_face = hn::Lt(kind.v, Random::constant(1).v), at_vertex = hn::Eq(kind.v, Random::constant(1).v);
    const auto v = vertices_in_cube(random);
    const Vec3<T> normal = unit_normal(v), across = outward(v[0], v[1], normal), other = outward(v[2], v[0], normal);

    const Vec3<T> in_face = inside(random, v), on_edge = v[0] + (v[1] - v[0]) * share_of_edge(random);
    const Vec3<T> foot = select(at_face, in_face, select(at_vertex, v[0], on_edge));
    const T least = Random::constant(0x1p-5);
    const T first_share = random.unit() + least, second_share = random.unit() + least, up = random.symmetric();
    const Vec3<T> on_side = across * first_share;
    const Vec3<T> beside = select(at_vertex, on_side + other * second_share, on_side) + normal * up;
    const Vec3<T> straight =
        normal * select(hn::Lt(up.v, Random::constant(0).v), Random::constant(-1), Random::constant(1));
    LaneQuery<T> q;
    q.p = foot + at_unit_length(select(at_face, straight, beside)) * height(random);

    // Local vertex 0 is the query's vertex `i`: A is the local vertex 3 - i.
    const T a = in_turn<Random, axis_count>(first, [](std::uint64_t p) { return (3 - vertex(p)) % 3; });
    const T b = in_turn<Random, axis_count>(first, [](std::uint64_t p) { return (4 - vertex(p)) % 3; });
    q.v = arranged(v, a, b);
    q.r = Random::constant(0);
    return q;
  }

  template <class Real>
  static void finish(std::uint64_t first, const MutableColumns<Real>& queries, const shapes::Wishes<Real>&) {
    for (std::size_t i = 0; i < queries.size; ++i) {
      const Comparison which = radius_comparison(static_cast<Axis>(axis(first + i)));
      queries.column[12][i] = step_radius(radius_on_boundary(query_from(queries[i]), which), ulps(first + i));
    }
  }
};

}  // namespace
AXISCERT_FILL(tangent, Tangent)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(tangent)
extern const Family tangent_family = {
    sphere_triangle_predicate,
    "tangent",
    "radius on the boundary of each radius comparison in turn, -4 to +4 ulp, where that axis decides",
    2,
    false,
    tangent_queries<float>,
    tangent_queries<double>,
    TrustGroup::resting};
}  // namespace axiscert
#endif
