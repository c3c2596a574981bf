// Triangles and centres anywhere in a cube, any radius up to the cube's size: the queries of a uniform fuzzer.
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "kernel/sphere_triangle/query.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/families/general.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/families/parts/lane_family-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

struct General {
  static constexpr bool solves = false;
  template <class Random, class T = typename Random::T>
  AXISCERT_INLINE static LaneQuery<T> make(Random& random, std::uint64_t) {
    LaneQuery<T> q;
    q.v = vertices_in_cube(random);
    q.p = in_cube(random);
    q.r = random.unit() * Random::constant(2);
    return q;
  }
};

}  // namespace
AXISCERT_FILL(general, General)
}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
AXISCERT_DISPATCH_FILL(general)
extern const Family general_family = {
    sphere_triangle_predicate,
    "general",
    "uniform coordinates in [-1, 1), radius in [0, 2): finds nothing, and shows that it does",
    2,
    false,
    general_queries<float>,
    general_queries<double>};
}  // namespace axiscert
#endif
