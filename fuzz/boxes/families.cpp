// The families of two boxes, and of a box and a triangle: one line each, in the order of the reports.
#include "fuzz/queries/family.h"

#define AXISCERT_BOX_FAMILIES(X) \
  X(general)                     \
  X(lattice)                     \
  X(tangent)                     \
  X(stacked)                     \
  X(resting)                     \
  X(level)                       \
  X(crossed)                     \
  X(edge_edge)                   \
  X(vertex_face)                 \
  X(parallel)                    \
  X(thin)                        \
  X(flat)                        \
  X(rectangles)                  \
  X(scale)                       \
  X(far)                         \
  X(bits)                        \
  X(stack)                       \
  X(pile)                        \
  X(ramp)                        \
  X(beams)                       \
  X(corridor)                    \
  X(int_scaled)                  \
  X(one_axis)                    \
  X(units)                       \
  X(spans)                       \
  X(plates)                      \
  X(aligned)                     \
  X(coincident)                  \
  X(symmetric)                   \
  X(general_turned)              \
  X(lattice_turned)              \
  X(tangent_turned)              \
  X(resting_turned)              \
  X(level_turned)                \
  X(crossed_turned)              \
  X(edge_edge_turned)            \
  X(vertex_face_turned)          \
  X(parallel_turned)             \
  X(stack_turned)                \
  X(pile_turned)                 \
  X(ramp_turned)                 \
  X(beams_turned)                \
  X(corridor_turned)             \
  X(one_axis_turned)             \
  X(units_turned)                \
  X(spans_turned)                \
  X(plates_turned)               \
  X(aligned_turned)              \
  X(coincident_turned)           \
  X(symmetric_turned)            \
  X(lengths_turned)              \
  X(slight_turned)               \
  X(general_minmax)              \
  X(lattice_minmax)              \
  X(touching_minmax)             \
  X(crates_minmax)               \
  X(one_axis_minmax)             \
  X(units_minmax)                \
  X(spans_minmax)                \
  X(plates_minmax)               \
  X(general_mixed)               \
  X(lattice_mixed)               \
  X(tangent_mixed)               \
  X(crates_mixed)                \
  X(one_axis_mixed)              \
  X(units_mixed)

#define AXISCERT_TRIANGLE_FAMILIES(X) \
  X(general)                          \
  X(touching)                         \
  X(lattice)                          \
  X(degenerate)                       \
  X(terrain)                          \
  X(ramp)                             \
  X(level_voxel)                      \
  X(one_axis)                         \
  X(units)                            \
  X(spans)                            \
  X(thin)                             \
  X(aligned)                          \
  X(general_minmax)                   \
  X(touching_minmax)                  \
  X(lattice_minmax)                   \
  X(voxel)                            \
  X(terrain_minmax)                   \
  X(ramp_minmax)                      \
  X(level_voxel_minmax)               \
  X(one_axis_minmax)                  \
  X(units_minmax)                     \
  X(spans_minmax)                     \
  X(thin_minmax)                      \
  X(aligned_minmax)                   \
  X(general_oriented)                 \
  X(touching_oriented)                \
  X(lattice_oriented)                 \
  X(terrain_oriented)                 \
  X(ramp_oriented)                    \
  X(one_axis_oriented)                \
  X(units_oriented)                   \
  X(spans_oriented)                   \
  X(thin_oriented)                    \
  X(aligned_oriented)                 \
  X(general_turned)                   \
  X(touching_turned)                  \
  X(lattice_turned)                   \
  X(terrain_turned)                   \
  X(ramp_turned)                      \
  X(one_axis_turned)                  \
  X(units_turned)                     \
  X(spans_turned)                     \
  X(thin_turned)                      \
  X(aligned_turned)

namespace axiscert {
namespace boxes {

#define AXISCERT_DECLARE(name) extern const Family box_box_##name##_family;
AXISCERT_BOX_FAMILIES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE
#define AXISCERT_DECLARE(name) extern const Family box_triangle_##name##_family;
AXISCERT_TRIANGLE_FAMILIES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

}  // namespace boxes

std::span<const Family* const> box_box_families() {
#define AXISCERT_POINT(name) &boxes::box_box_##name##_family,
  static const Family* const all[] = {AXISCERT_BOX_FAMILIES(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

std::span<const Family* const> box_triangle_families() {
#define AXISCERT_POINT(name) &boxes::box_triangle_##name##_family,
  static const Family* const all[] = {AXISCERT_TRIANGLE_FAMILIES(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

}  // namespace axiscert

#undef AXISCERT_BOX_FAMILIES
#undef AXISCERT_TRIANGLE_FAMILIES
