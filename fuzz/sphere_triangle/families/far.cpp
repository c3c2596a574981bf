// Queries far from the origin, where the grid of the floats is coarse compared with the triangle.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/far.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct Far : AimedRadii {
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    static constexpr double decades[5] = {1e2, 1e3, 1e4, 1e5, 1e6};
    LaneQuery<T> q;
    q.v = vertices_in_cube(random);
    q.p = in_cube(random);
    const T decade = in_turn<Random, 5>(first, [](std::uint64_t position) { return decades[position]; });
    const Vec3<T> offset = at_unit_length(in_cube(random)) * decade;
    for (Vec3<T>& v : q.v) v = v + offset;
    q.p = q.p + offset;
    aim(random, q);  // relative to the rounded query
    return q;
  }
};

}  // namespace
AXISCERT_FILL(far, Far)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(far)
extern const Family far_family = {
    sphere_triangle_predicate,
    "far",
    "triangles of size one at 10^2 to 10^6 from the origin, half of the radii near the distance",
    2,
    false,
    far_queries<float>,
    far_queries<double>,
    TrustGroup::far};
}  // namespace axiscert
#endif
