// Formulae of one's own: the published test, written once for every number type.
#include <axiscert/formulae.hpp>

using axiscert::formulae::Query;
using axiscert::formulae::Vec;

struct MyFormulae {
  // Whether one of seven axes separates the sphere from the triangle: the plane's, three vertices', three edges'.
  template <class T>
  static bool separated(const Query<T>& q) {
    const Vec<T> a = q.a - q.p, b = q.b - q.p, c = q.c - q.p;
    const T rr = q.r * q.r;
    const Vec<T> normal = cross(b - a, c - a);
    const T d = dot(a, normal);
    if (d * d > dot(normal, normal) * rr) return true;
    return vertex(a, b, c, rr) || vertex(b, a, c, rr) || vertex(c, a, b, rr) || edge(a, b, c, rr) ||
           edge(b, c, a, rr) || edge(c, a, b, rr);
  }

 private:
  // The vertex is out of reach, and the others lie beyond the plane through it that faces the centre.
  template <class T>
  static bool vertex(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, const T& rr) {
    const T aa = dot(a, a);
    return aa > rr && dot(a, b) > aa && dot(a, c) > aa;
  }

  // The line of the edge is out of reach, and the third vertex lies beyond the plane through it that faces the centre.
  template <class T>
  static bool edge(const Vec<T>& a, const Vec<T>& b, const Vec<T>& c, const T& rr) {
    const Vec<T> along = b - a;
    const T e = dot(along, along);
    const Vec<T> nearest =
        a * e - along * dot(a, along);  // e times the point of the line that is nearest to the centre
    return dot(nearest, nearest) > rr * e * e && dot(nearest, c * e - nearest) > T(0);
  }
};

AXISCERT_FORMULAE("my-formulae", MyFormulae)
