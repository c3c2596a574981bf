// The feature of a triangle that is nearest to the origin, determined in doubles: with certainty, or as a guess.
// Features are numbered as the axes are: 0 the face, 1 + i vertex i, 4 + i edge i.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>

#include "exact/sphere_triangle/oracles/enclosed_triangle.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

inline constexpr std::size_t unclear_feature = axis_count;

// The nearest feature is vertex i if v.e_i >= 0 and v.e_i-1 <= 0; edge i if the foot on its line lies within and the
// plane's foot is not inside, m_i <= 0 with m_i = (v_i x e_i).V; the face if m_i >= 0 for all i. Each sign is certain
// if the double is farther from zero than its error, with u = 2^-53 and |.| a vector's sum of magnitudes. A double here
// is within u of the number that it leads.
// clang-format off
//   v.e   2u from its numbers, 3u from three products and two sums: 5.01 u |v| |e|; 6u with the bound's own rounding.
//   V, M  V = a x b, M_i = v_i x e_i: 2u from the numbers, u from the products and u from the difference, so components
//         that are off by 4.01 u |a| |b| in sum.
//   m     3.01 u from products and sums, 4.01 u from each of V and M: 11.1 u |v| |e| |a| |b|; 12u.
// clang-format on
// Underflow of products adds 2^-1074, and bits lost in scaling add 2^-1073; at most four of the other numbers, all
// below 2^102, multiply these errors: the results, below 2^-900 and 2^-700, are added. An edge that is exactly zero
// makes its v.e and all m so.
template <class T>
AXISCERT_INLINE std::size_t certain_feature(const EnclosedTriangle<T>& t) {
  std::array<Vec3<double>, 3> v, edge;
  std::array<double, 3> v_size, edge_size, at_start, at_end, start_error, end_error;
  for (std::size_t i = 0; i < 3; ++i) {
    v[i] = leading(t.vertex[i].value);
    edge[i] = leading(t.edge[i].value);
    v_size[i] = t.vertex[i].size;
    edge_size[i] = t.edge[i].size;
  }
  for (std::size_t i = 0; i < 3; ++i) {
    at_start[i] = dot(v[i], edge[i]);
    at_end[i] = dot(v[next_vertex(i)], edge[i]);
    start_error[i] = 0x1.8p-51 * v_size[i] * edge_size[i] + 0x1p-900;
    end_error[i] = 0x1.8p-51 * v_size[next_vertex(i)] * edge_size[i] + 0x1p-900;
  }
  const bool may_be_zero = t.scaling_error == 0;
  const auto is_zero_edge = [&](std::size_t i) { return may_be_zero && edge_size[i] == 0; };
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t previous = previous_vertex(i);
    if ((at_start[i] > start_error[i] || is_zero_edge(i)) &&
        (at_end[previous] < -end_error[previous] || is_zero_edge(previous))) {
      return 1 + i;
    }
  }
  std::size_t longest = edge_size[1] > edge_size[0] ? 1 : 0;
  if (edge_size[2] > edge_size[longest]) longest = 2;
  const std::size_t j = next_vertex(longest), k = previous_vertex(longest);
  const Vec3<double> normal = cross(edge[j], edge[k]);
  const double normal_error = 0x1.8p-50 * edge_size[j] * edge_size[k];
  const bool flat = is_zero_edge(j) || is_zero_edge(k);
  bool inside = !flat;
  for (std::size_t i = 0; i < 3; ++i) {
    const double m = dot(cross(v[i], edge[i]), normal);
    const double error = normal_error * v_size[i] * edge_size[i] + 0x1p-700;
    if ((m < -error || flat) && at_start[i] < -start_error[i] && at_end[i] > end_error[i]) return 4 + i;
    inside = inside && m > error;
  }
  return inside ? 0 : unclear_feature;
}

// The feature that seems nearest.
template <class T>
std::size_t likely_feature(const EnclosedTriangle<T>& t, const EnclosedVector<T>& enclosed_normal) {
  const Vec3<double> normal = leading(enclosed_normal.value);
  std::array<Vec3<double>, 3> moment;
  bool inside = true;
  for (std::size_t i = 0; i < 3; ++i) {
    moment[i] = cross(leading(t.vertex[i].value), leading(t.edge[i].value));
    inside = inside && dot(moment[i], normal) >= 0;
  }
  if (inside && as_double(dot(as_doubles(enclosed_normal), as_doubles(enclosed_normal))).low() > 0) return 0;
  std::size_t feature = 0;
  double least = HUGE_VAL;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3<double> v = leading(t.vertex[i].value), edge = leading(t.edge[i].value);
    const double along = -dot(v, edge), length2 = dot(edge, edge);
    const std::size_t end = along <= 0 ? i : along >= length2 ? next_vertex(i) : 3;
    const Vec3<double> to = end < 3 ? leading(t.vertex[end].value) : moment[i];
    const double square = end < 3 ? dot(to, to) : dot(to, to) / length2;
    if (square < least) {
      least = square;
      feature = end < 3 ? 1 + end : 4 + i;
    }
  }
  return feature;
}

}  // namespace axiscert
