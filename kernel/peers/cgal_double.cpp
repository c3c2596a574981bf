// CGAL over double. Its behaviour and faults are described in cgal_inexact.h.
#include "kernel/peers/cgal_inexact.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Peer = axiscert::peer::CgalInexact<double>;
  return axiscert::peer::kernel<Peer>(
      index, {"cgal-double", "CGAL's squared_distance, Simple_cartesian<double>", Peer::touching, AXISCERT_SOURCE});
}
