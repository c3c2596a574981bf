// libccd has no sweep: what the sphere covers on its way is a capsule, here a static one against the triangle, in
// double: ccdGJKIntersect. A verdict alone. Faults of libccd's GJK (../libccd_gjk.cpp) are faults here too.
#include "kernel/peers/libccd_shapes.h"
#include "kernel/peers/moving_sphere/sweep.h"

namespace axiscert::peer {
namespace {

const Sweep<double>& sweep_of(const void* query) { return *static_cast<const Sweep<double>*>(query); }

void capsule_centre(const void* query, ccd_vec3_t* centre) {
  const Sweep<double>& q = sweep_of(query);
  const Vec3<double> middle = q.p + q.d * 0.5;
  ccdVec3Set(centre, middle.x, middle.y, middle.z);
}

// The end of the path that is farther in this direction, and r beyond it.
void capsule_support(const void* query, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const Sweep<double>& q = sweep_of(query);
  const Vec3<double> along = {direction->v[0], direction->v[1], direction->v[2]};
  const Vec3<double> end = dot(along, q.d) > 0 ? end_of(q) : q.p;
  ccdVec3Set(farthest, end.x, end.y, end.z);
  const double length = std::sqrt(ccdVec3Len2(direction));
  if (length == 0) return;
  ccd_vec3_t reach = *direction;
  ccdVec3Scale(&reach, q.r / length);
  ccdVec3Add(farthest, &reach);
}

struct LibccdCapsule {
  using Real = double;
  static constexpr std::size_t measure_count = 0;

  int operator()(const Sweep<double>& q, FirstContact<double>&) const {
    ccd_t ccd = sphere_and_triangle();
    ccd.support1 = capsule_support;
    ccd.center1 = capsule_centre;
    const Query<double> triangle = {q.a, q.b, q.c, q.p, q.r};
    return verdict_of(ccdGJKIntersect(&q, &triangle, &ccd) != 0);
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::sweep_kernel<axiscert::peer::LibccdCapsule>(
      index, {"libccd-capsule", "libccd's ccdGJKIntersect of a capsule and the triangle, double",
              AXISCERT_TOUCHING_IS_EITHER, AXISCERT_SOURCE});
}
