// CGAL's exact predicate in its inexact-constructions kernel: Compare_squared_distance_3 of EPICK. The description
// applies to CGAL 5.5; no wrong answer is known. It is not independent of the geometric truth, which is CGAL too.
//
// The four-argument form compares two distances; the three-argument form takes r r, which rounds in double.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include "kernel/peers/peer.h"

namespace axiscert::peer {
namespace {

struct CgalEpick {
  using Real = double;

  int operator()(const Query<double>& q) const {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    const auto point = [](const Vec3<double>& v) { return Kernel::Point_3(v.x, v.y, v.z); };
    const Kernel::Triangle_3 triangle(point(q.a), point(q.b), point(q.c));
    const CGAL::Comparison_result order = Kernel().compare_squared_distance_3_object()(
        point(q.p), triangle, Kernel::Point_3(0, 0, 0), Kernel::Point_3(q.r, 0, 0));
    return verdict_of(order != CGAL::LARGER);
  }
};

}  // namespace
}  // namespace axiscert::peer

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::CgalEpick>(
      index, {"cgal-epick", "CGAL's compare_squared_distance_3 in EPICK, exact", AXISCERT_TOUCHING_IS_CONTACT,
              AXISCERT_SOURCE});
}
