// FCL's general convex test in double, GJKSolver_libccd::shapeTriangleIntersect, as used for a shape without a test of
// its own: a sphere would be sent to the test of fcl_detector.h; an ellipsoid of three equal radii is sent to this one.
// The description applies to FCL 0.7.0 over libccd 2.1.
//
// For a yes-or-no question FCL calls libccd's MPR here, whatever the solver's name says; so it may never return, and
// its tolerance is smaller than libccd's own. The support point of an ellipsoid of radius 0 is 0/0, and it never hits.
// Tracker: fcl 375, 527, 569.
#include <fcl/narrowphase/detail/gjk_solver_libccd.h>

#include "kernel/peers/fcl_detector.h"

namespace axiscert::peer {
namespace {

struct FclGjk {
  using Real = double;
  static constexpr std::size_t measure_count = up_to_normal;

  // The verdict of the yes-or-no question; the numbers are those of another, which may be answered by no. Its depth is
  // positive, its normal goes from the ellipsoid to the triangle, and its point is of neither of them.
  int operator()(const Query<double>& q, Contact<double>& said) const {
    const fcl::detail::GJKSolver_libccd<double> solver;
    const auto ask = [&](fcl::Vector3<double>* point, double* depth, fcl::Vector3<double>* normal) {
      return solver.shapeTriangleIntersect(fcl::Ellipsoid<double>(q.r, q.r, q.r), fcl_translation(q.p), fcl_vector(q.a),
                                           fcl_vector(q.b), fcl_vector(q.c), point, depth, normal);
    };
    if (!ask(nullptr, nullptr, nullptr)) return AXISCERT_SEPARATED;
    fcl::Vector3<double> point, normal;
    double depth;
    if (ask(&point, &depth, &normal)) {
      said.separation = -depth;
      said.normal = plain<double>(-normal);
    }
    return AXISCERT_CONTACT;
  }
};

}  // namespace
}  // namespace axiscert::peer

// Touching is either, as in libccd's MPR.
const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::kernel<axiscert::peer::FclGjk>(
      index, {"fcl-gjk", "FCL's GJKSolver_libccd on an ellipsoid of equal radii, double", AXISCERT_TOUCHING_IS_EITHER,
              AXISCERT_SOURCE});
}
