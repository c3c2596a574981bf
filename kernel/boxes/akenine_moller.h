// Box and triangle as the code published with the paper has them: the same thirteen axes, other roundings.
#pragma once

#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {

// The box moved to the origin. Along a product with an edge two corners are asked, of which one is the third and the
// other an end, not always the same; for the plane the two corners of the box that are farthest along the normal. Right
// over the reals. Degrees 1 > 1, 3 > 0 for the plane, 2 > 2. Source: T. Akenine-Moller, Fast 3D Triangle-Box Overlap
// Testing, Journal of Graphics Tools 6 (2001), and its program as it stands since 2001.
struct AkenineMoller {
  static constexpr std::string_view name = "akenine-moller";
  static constexpr FormulaeKind kind = FormulaeKind::rung;

  template <class T, class Problem, class Sink>
  static void comparisons(const Problem& given, Sink& sink) {
    // The corners asked along the box's axis i times edge j.
    static constexpr std::array<std::array<std::array<std::size_t, 2>, 3>, 3> asked = {
        {{{{0, 2}, {0, 2}, {0, 1}}}, {{{0, 2}, {0, 2}, {0, 1}}}, {{{1, 2}, {0, 1}, {1, 2}}}}};
    const CentredAndTriangle<T> q = centred(given);
    const std::array<T, 3>& half = q.half;
    std::array<std::array<T, 3>, 3> v{}, edge{};
    for (std::size_t k = 0; k < 3; ++k) v[k] = numbers(q.corner[k] - q.centre);
    for (std::size_t j = 0; j < 3; ++j) {
      for (std::size_t k = 0; k < 3; ++k) edge[j][k] = v[next(j)][k] - v[j][k];
    }
    for (std::size_t i = 0; i < 3; ++i) {
      sink(i, beyond_zero(v[0][i], v[1][i], v[2][i]), half[i]);
      for (std::size_t j = 0; j < 3; ++j) {
        const std::size_t i1 = next(i), i2 = last(i);
        const T &e1 = edge[j][i1], &e2 = edge[j][i2];
        const auto along = [&](std::size_t k) { return e2 * v[k][i1] - e1 * v[k][i2]; };
        const T one = along(asked[i][j][0]), other = along(asked[i][j][1]);
        sink(edge_axis(i, j), greater(lesser(one, other), T(0.0) - greater(one, other)),
             magnitude(e2) * half[i1] + magnitude(e1) * half[i2]);
      }
    }
    const auto& [a, b, c] = edge;
    const Vec3<T> normal = cross(Vec3<T>{a[0], a[1], a[2]}, Vec3<T>{b[0], b[1], b[2]});
    const std::array<T, 3> n = numbers(normal);
    std::array<T, 3> least{}, greatest{};
    for (std::size_t k = 0; k < 3; ++k) {
      const T low = (T(0.0) - half[k]) - v[0][k], high = half[k] - v[0][k];
      const bool is_up = n[k] > T(0.0);
      least[k] = is_up ? low : high;
      greatest[k] = is_up ? high : low;
    }
    const auto distance = [&](const std::array<T, 3>& p) { return dot(normal, Vec3<T>{p[0], p[1], p[2]}); };
    sink(plane_axis, greater(distance(least), T(0.0) - distance(greatest)), T(0.0));
  }

 private:
  template <class T>
  static std::array<T, 3> numbers(const Vec3<T>& p) {
    return {p.x, p.y, p.z};
  }
};

}  // namespace axiscert::boxes
