// CGAL over float. Its behaviour and faults are described in cgal_inexact.h.
#include "kernel/peers/cgal_inexact.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  using Peer = axiscert::peer::CgalInexact<float>;
  return axiscert::peer::kernel<Peer>(
      index, {"cgal-float", "CGAL's squared_distance, Simple_cartesian<float>", Peer::touching, AXISCERT_SOURCE});
}
