// Two boxes for libccd's algorithms, which know a shape only by its support function and its centre. The description
// applies to libccd 2.1 in double (Debian's build).
#pragma once

#include <ccd/ccd.h>

#include "kernel/peers/boxes/box_pair.h"

namespace axiscert::peer {

static_assert(sizeof(ccd_real_t) == 8);

inline void box_centre(const void* box, ccd_vec3_t* centre) {
  const Vec3<double>& m = static_cast<const Box<double>*>(box)->centre;
  ccdVec3Set(centre, m.x, m.y, m.z);
}

// The corner that is farthest in this direction.
inline void box_support(const void* box, const ccd_vec3_t* direction, ccd_vec3_t* farthest) {
  const auto& q = *static_cast<const Box<double>*>(box);
  const Vec3<double> along = {direction->v[0], direction->v[1], direction->v[2]};
  const double half[] = {q.half.x, q.half.y, q.half.z};
  Vec3<double> corner = q.centre;
  for (std::size_t k = 0; k < 3; ++k) corner = corner + q.axis[k] * (dot(along, q.axis[k]) < 0 ? -half[k] : half[k]);
  ccdVec3Set(farthest, corner.x, corner.y, corner.z);
}

// At most 500 iterations: libccd's own default is unlimited.
inline ccd_t two_boxes() {
  ccd_t ccd;
  CCD_INIT(&ccd);
  ccd.support1 = ccd.support2 = box_support;
  ccd.center1 = ccd.center2 = box_centre;
  ccd.max_iterations = 500;
  return ccd;
}

// The verdict of a function that answers yes or no, and of boxes in contact what the penetration's says: it is a second
// question, and may be answered by no. It says one point, and not of which body.
template <auto intersect, auto penetrate>
struct LibccdBoxes {
  using Real = double;
  static constexpr std::size_t measure_count = contact_without_points;

  int operator()(const Boxes<double>& q, BoxContact<double>& contact) const {
    const ccd_t ccd = two_boxes();
    if (intersect(&q.a, &q.b, &ccd) == 0) return AXISCERT_SEPARATED;
    ccd_real_t depth = 0;
    ccd_vec3_t way, place;
    if (penetrate(&q.a, &q.b, &ccd, &depth, &way, &place) == 0) {
      contact.separation = -depth;
      contact.normal = {way.v[0], way.v[1], way.v[2]};
    }
    return AXISCERT_CONTACT;
  }
};

}  // namespace axiscert::peer
