#include "kernel/capsule_triangle/capsule.h"
#include "kernel/capsule_triangle/contact.h"
#include "kernel/moving_sphere/twenty.h"
#include "kernel/permitted/graph.h"

namespace axiscert {
namespace {

using moving_sphere::Twenty, moving_sphere::TwentyNonstrict;

// The segment's distance from the triangle, of Q - P rounded.
struct SegmentDistance {
  static constexpr std::size_t measure_count = boxes::contact_measures;
  template <class Real>
  static bool separated(const EndsQuery<Real>& q) {
    return moving_sphere::Segment::separated(MovingQuery<Real>{q.a, q.b, q.c, q.p, q.p1 - q.p, q.r});
  }
  template <class Real>
  static void measure(const EndsQuery<Real>& q, Real* out) {
    capsule::put_contact(q, separated(q), out);
  }
};

}  // namespace

std::vector<Kernel> capsule_triangle_kernels() {
  return {
      formulae_kernel<Capsule, Twenty>("capsule-triangle/twenty",
                                       "a ball against the prism that the triangle sweeps: 20 axes"),
      formulae_kernel<Capsule, TwentyNonstrict>("capsule-triangle/twenty-nonstrict",
                                                "the same with >= in the sides: over the reals right for every query"),
      method_kernel<Capsule, SegmentDistance>(
          "capsule-triangle/segment",
          "the distance of the segment from the triangle, by its ends and edges, with the contact"),
      method_kernel<Capsule, capsule::ReferencePoint>("capsule-triangle/reference-point",
                                                      "one sphere, beside where the capsule's line meets the plane"),
      method_kernel<Capsule, capsule::Alternating>(
          "capsule-triangle/alternating", "nearest points of segment and triangle in turns, from three starts"),
  };
}

// The twenty axes for kernel/permitted.
permitted::Recorder permitted::capsule_triangle_recorder(const Kernel& kernel) {
  Recorder found;
  put_recorder<Capsule, Twenty>(kernel, found);
  put_recorder<Capsule, TwentyNonstrict>(kernel, found);
  return found;
}

}  // namespace axiscert
