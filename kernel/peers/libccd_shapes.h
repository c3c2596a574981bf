// A sphere and a triangle for libccd's algorithms, which know a shape only by its support function and its centre. The
// description applies to libccd 2.1 in double (Debian's build).
#pragma once

#include <ccd/ccd.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {

static_assert(sizeof(ccd_real_t) == 8);

inline void sphere_centre(const void* query, ccd_vec3_t* centre) {
  const Vec3<double>& p = static_cast<const Query<double>*>(query)->p;
  ccdVec3Set(centre, p.x, p.y, p.z);
}

inline void sphere_support(const void* query, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  sphere_centre(query, farthest);
  const double length = std::sqrt(ccdVec3Len2(direction));
  if (length == 0) return;
  ccd_vec3_t reach = *direction;
  ccdVec3Scale(&reach, static_cast<const Query<double>*>(query)->r / length);
  ccdVec3Add(farthest, &reach);
}

inline void triangle_centre(const void* query, ccd_vec3_t* centre) {
  const auto& q = *static_cast<const Query<double>*>(query);
  ccdVec3Set(centre, (q.a.x + q.b.x + q.c.x) / 3, (q.a.y + q.b.y + q.c.y) / 3, (q.a.z + q.b.z + q.c.z) / 3);
}

inline void triangle_support(const void* query, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const auto& q = *static_cast<const Query<double>*>(query);
  double greatest = 0;
  const Vec3<double>* vertices[] = {&q.a, &q.b, &q.c};
  for (const Vec3<double>* v : vertices) {
    ccd_vec3_t vertex;
    ccdVec3Set(&vertex, v->x, v->y, v->z);
    const double along = ccdVec3Dot(direction, &vertex);
    if (v == &q.a || along > greatest) {
      greatest = along;
      *farthest = vertex;
    }
  }
}

// The object of both shapes is the query itself. At most 500 iterations: libccd's own default is unlimited.
inline ccd_t sphere_and_triangle() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = sphere_support;
  ccd.center1 = sphere_centre;
  ccd.support2 = triangle_support;
  ccd.center2 = triangle_centre;
  ccd.max_iterations = 500;
  return ccd;
}

// The verdict of a function that answers yes or no, and of the two in contact what the penetration's says: it is a
// second question, and may be answered by no. It says in which direction the triangle is pushed, and one point, which
// is of neither of them.
template <auto intersect, auto penetrate>
struct LibccdSphere {
  using Real = double;
  static constexpr std::size_t measure_count = up_to_normal;

  int operator()(const Query<double>& q, Contact<double>& said) const {
    const ccd_t ccd = sphere_and_triangle();
    if (intersect(&q, &q, &ccd) == 0) return AXISCERT_SEPARATED;
    ccd_real_t depth = 0;
    ccd_vec3_t way, place;
    if (penetrate(&q, &q, &ccd, &depth, &way, &place) == 0) {
      said.separation = -depth;
      said.normal = {-way.v[0], -way.v[1], -way.v[2]};
    }
    return AXISCERT_CONTACT;
  }
};

}  // namespace axiscert::peer
