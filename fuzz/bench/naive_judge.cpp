#include "exact/sphere_triangle/oracles/cgal_distance.h"
#include "fuzz/bench/naive_judges.h"

namespace axiscert {

template <class Real>
std::uint64_t separated_by_distance(const std::vector<Query<Real>>& queries) {
  std::uint64_t separated = 0;
  for (const Query<Real>& q : queries) {
    if (is_valid(q)) separated += cgal_squared_distance(q) > cgal_squared_radius(q);
  }
  return separated;
}
template std::uint64_t separated_by_distance<float>(const std::vector<Query<float>>&);
template std::uint64_t separated_by_distance<double>(const std::vector<Query<double>>&);

}  // namespace axiscert
