// CGAL's do_intersect over doubles; see cgal_triangle.h.
#include <CGAL/Simple_cartesian.h>

#include "kernel/peers/boxes/cgal_triangle.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::cells_kernel<CGAL::Simple_cartesian<double>>(
      index, {"cgal-double", "CGAL's do_intersect of an Iso_cuboid_3 and a Triangle_3, double",
              AXISCERT_TOUCHING_IS_CONTACT, AXISCERT_SOURCE});
}
