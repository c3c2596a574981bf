#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/squared_distance_3.h>

#include "fuzz/bench/naive_judges.h"

namespace axiscert {

// The same as kernel/peers/cgal_epick.cpp, without a plug-in around it.
template <class Real>
std::uint64_t contacts_by_epick(const std::vector<Query<Real>>& queries) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  const auto point = [](const Vec3<Real>& v) { return Kernel::Point_3(v.x, v.y, v.z); };
  const auto order = Kernel().compare_squared_distance_3_object();
  std::uint64_t contacts = 0;
  for (const Query<Real>& q : queries) {
    if (!is_valid(q)) continue;
    const Kernel::Triangle_3 triangle(point(q.a), point(q.b), point(q.c));
    contacts += order(point(q.p), triangle, Kernel::Point_3(0, 0, 0), Kernel::Point_3(q.r, 0, 0)) != CGAL::LARGER;
  }
  return contacts;
}
template std::uint64_t contacts_by_epick<float>(const std::vector<Query<float>>&);
template std::uint64_t contacts_by_epick<double>(const std::vector<Query<double>>&);

}  // namespace axiscert
