// CGAL's do_intersect in the kernel with exact predicates; see cgal_triangle.h.
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "kernel/peers/boxes/cgal_triangle.h"

const axiscert_kernel* axiscert_plugin(std::uint32_t index) {
  return axiscert::peer::cells_kernel<CGAL::Exact_predicates_inexact_constructions_kernel>(
      index, {"cgal-epick", "CGAL's do_intersect of an Iso_cuboid_3 and a Triangle_3, Epick",
              AXISCERT_TOUCHING_IS_CONTACT, AXISCERT_SOURCE});
}
