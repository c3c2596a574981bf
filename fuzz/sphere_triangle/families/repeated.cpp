// Triangles with equal vertices: each pair in turn, then all three.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/repeated.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct RepeatedVertices : AimedRadii {
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t first) {
    const T which = in_turn<Random, 4>(first, [](std::uint64_t position) { return position; });
    const auto is = [&](int k) HWY_ATTR { return hn::Eq(which.v, Random::constant(static_cast<float>(k)).v); };
    LaneQuery<T> q;
    const auto v = vertices_in_cube(random);
    q.v[0] = select(is(2), v[2], v[0]);
    q.v[1] = select(hn::Or(is(0), is(3)), v[0], v[1]);
    q.v[2] = select(is(3), v[0], select(is(1), v[1], v[2]));
    q.p = in_cube(random);
    aim(random, q);
    return q;
  }
};

}  // namespace
AXISCERT_FILL(repeated, RepeatedVertices)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(repeated)
extern const Family repeated_family = {
    sphere_triangle_predicate,
    "repeated",
    "two equal vertices (A = B, B = C, C = A) or three, in turn; otherwise arbitrary",
    2,
    false,
    repeated_queries<float>,
    repeated_queries<double>,
    TrustGroup::degenerate};
}  // namespace axiscert
#endif
