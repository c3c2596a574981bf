// The families of sphere-triangle: one line each, in the order of the reports.
#include "fuzz/queries/family.h"

#define AXISCERT_FAMILIES(X) \
  X(general)                 \
  X(tangent)                 \
  X(seam)                    \
  X(sliver)                  \
  X(needle)                  \
  X(collinear)               \
  X(repeated)                \
  X(tie)                     \
  X(speck)                   \
  X(lattice)                 \
  X(units)                   \
  X(spans)                   \
  X(far)                     \
  X(scale)                   \
  X(ratio)                   \
  X(on)                      \
  X(grid)                    \
  X(sunken)                  \
  X(bits)                    \
  X(subnormal)               \
  X(nonfinite)               \
  X(scene_walk)              \
  X(scene_edge)              \
  X(patch)                   \
  X(extents)                 \
  X(corners)                 \
  X(slender)                 \
  X(orders)                  \
  X(axes)                    \
  X(inverted)                \
  X(scaled)                  \
  X(translated)

namespace axiscert {

#define AXISCERT_DECLARE(name) extern const Family name##_family;
AXISCERT_FAMILIES(AXISCERT_DECLARE)
#undef AXISCERT_DECLARE

std::span<const Family* const> sphere_triangle_families() {
#define AXISCERT_POINT(name) &name##_family,
  static const Family* const all[] = {AXISCERT_FAMILIES(AXISCERT_POINT)};
#undef AXISCERT_POINT
  return all;
}

}  // namespace axiscert

#undef AXISCERT_FAMILIES
