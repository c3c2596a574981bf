// The families of the moving sphere: one line each, in the order of the reports.
#include "fuzz/queries/family.h"

#define AXISCERT_MOVING_FAMILIES(X) \
  X(general)                        \
  X(graze)                          \
  X(touch_end)                      \
  X(touch_start)                    \
  X(exact_time)                     \
  X(slide)                          \
  X(skim)                           \
  X(along_edge)                     \
  X(seam_time)                      \
  X(overlap_ulp)                    \
  X(approach)                       \
  X(huge_d)                         \
  X(tiny_d)                         \
  X(zero_d)                         \
  X(line_sweep)                     \
  X(repeated_sweep)                 \
  X(point)                          \
  X(lattice)                        \
  X(one_axis)                       \
  X(units)                          \
  X(scale)                          \
  X(scene_walk)                     \
  X(scene_fall)                     \
  X(scene_bullet)                   \
  X(scene_shake)                    \
  X(reach)                          \
  X(starts)                         \
  X(alongside)                      \
  X(far_past)                       \
  X(moves)                          \
  X(edge_ends)                      \
  X(orders)                         \
  X(axes)                           \
  X(inverted)                       \
  X(translated)                     \
  X(reversed)                       \
  X(split)                          \
  X(halved)                         \
  X(ends_general)                   \
  X(ends_graze)                     \
  X(ends_touch)                     \
  X(ends_slide)                     \
  X(ends_along)                     \
  X(ends_approach)                  \
  X(ends_huge)                      \
  X(ends_still)                     \
  X(ends_line)                      \
  X(ends_point)                     \
  X(ends_lattice)                   \
  X(ends_walk)                      \
  X(ends_reach)                     \
  X(ends_starts)                    \
  X(ends_alongside)                 \
  X(ends_far_past)

namespace axiscert {
namespace moving_sphere {

#define AXISCERT_DECLARE(name) extern const Family moving_sphere_##name##_family;
AXISCERT_MOVING_FAMILIES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

}  // namespace moving_sphere

std::span<const Family* const> moving_sphere_families() {
#define AXISCERT_POINT(name) &moving_sphere::moving_sphere_##name##_family,
  static const Family* const all[] = {AXISCERT_MOVING_FAMILIES(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

}  // namespace axiscert

#undef AXISCERT_MOVING_FAMILIES
