// Parts that all predicates of a box by separating axes share: the extent of a box, and of a triangle, in a direction.
#pragma once

#include "kernel/boxes/boxes.h"
#include "kernel/boxes/names.h"

namespace axiscert::boxes {

// Half the extent of a box in direction d, times |d|: s0 |d.b0| + s1 |d.b1| + s2 |d.b2|. Degree 2 + that of d.
// Source: M. Larcombe, comp.graphics.algorithms, 11 October 1995.
template <class T>
constexpr T half_extent(const OrientedBox<T>& box, const Vec3<T>& d) {
  const auto term = [&](std::size_t k) { return box.half[k] * magnitude(dot(d, box.axis[k])); };
  return (term(0) + term(1)) + term(2);
}

// The normal of the facets of `box` that do not have the edge axis[k]. Degree 2; 0 for dependent axes alone.
template <class T>
constexpr Vec3<T> facet_normal(const OrientedBox<T>& box, std::size_t k) {
  return cross(box.axis[next(k)], box.axis[last(k)]);
}

// The axis of comparison i as a vector: products of the boxes' own vectors, degree 2. It is 0 for parallel edges.
template <class T>
constexpr Vec3<T> direction(const BoxPair<T>& q, std::size_t i) {
  if (i < 3) return facet_normal(q.a, i);
  if (i < 6) return facet_normal(q.b, i - 3);
  return cross(q.a.axis[(i - 6) / 3], q.b.axis[(i - 6) % 3]);
}

template <class T>
constexpr T lesser(const T& a, const T& b) {
  return a > b ? b : a;
}
template <class T>
constexpr T greater(const T& a, const T& b) {
  return a > b ? a : b;
}

// The distance from 0 of the range of three numbers, negative where 0 is inside: max(min p, -max p).
template <class T>
constexpr T beyond_zero(const T& p, const T& q, const T& r) {
  return greater(lesser(lesser(p, q), r), T(0.0) - greater(greater(p, q), r));
}

}  // namespace axiscert::boxes
