// The moving centre as a segment against the triangle rounded by r, piece by piece: the form that engines use, and the
// rungs from its root b - sqrt(b^2 - a c) to one in which nothing cancels. No branch, so that it runs in lanes too.
#if defined(AXISCERT_PER_TARGET) || !defined(AXISCERT_KERNEL_MOVING_SPHERE_ROUNDED_H)
#define AXISCERT_KERNEL_MOVING_SPHERE_ROUNDED_H

#include "kernel/moving_sphere/branchless.h"

AXISCERT_BEFORE_NAMESPACE();
namespace axiscert {
namespace AXISCERT_TARGET {

// The first root of a t^2 - 2 b t + c.
//
// difference  (b - sqrt(b^2 - a c)) / a: far away, b^2 - a c loses (distance / r)^2 units of the last place, and the
//             outer difference distance / r more
// quotient    c / (b + sqrt(b^2 - a c)), for b > 0 and c > 0: the outer difference is gone; c <= 0 is inside
// products    the same with the discriminant as a difference of products of the degree of the geometry, a vertex's
//             rr D.D - W.W, an edge's e (rr M.M - delta^2): it loses distance / r
enum class RootForm { difference, quotient, products };

// The first time found, of those that are in [0, 1]; 2 where there is none. `feature` is as the measures number it: 0,
// 1, 2 a vertex, 3, 4, 5 an edge, 6 the face; -1 the start.
template <class T>
struct FirstHit {
  ComparisonResult<T> contact;
  T time, feature;
  AXISCERT_INLINE void take(const ComparisonResult<T>& holds, const T& t, double which) {
    const ComparisonResult<T> is_hit = both(holds, both(t >= T(0.0), T(1.0) >= t));
    const ComparisonResult<T> is_first = both(is_hit, time > t);
    time = chosen(is_first, t, time);
    feature = chosen(is_first, T(which), feature);
    contact = either(contact, is_hit);
  }
};

// A query seen from the centre's start.
template <class T>
struct Start {
  Vec3<T> a, b, c, d;
  T r, rr;
};
template <class T, class Query>
AXISCERT_INLINE Start<T> start_of(const Query& q) {
  return {q.a - q.p, q.b - q.p, q.c - q.p, q.d, q.r, q.r * q.r};
}

// The triangle's normal, its length, and the plane's offset.
template <class T>
struct FacePlane {
  Vec3<T> normal;
  T length, offset;
};
template <class T>
AXISCERT_INLINE FacePlane<T> face_plane(const Start<T>& q) {
  const Vec3<T> normal = cross(q.b - q.a, q.c - q.a);
  const T length = square_root(dot(normal, normal));
  return {normal, length, dot(q.a, normal) / length};
}

template <RootForm form>
struct RoundedPieces {
  // The root of a t^2 - 2 b t + c where there may be one; `products` is the discriminant as a difference of products.
  template <class T>
  AXISCERT_INLINE static void take_root(FirstHit<T>& hit, const ComparisonResult<T>& holds, const T& t, const T& b,
                                        const T& c, double which) {
    if constexpr (form == RootForm::difference) hit.take(holds, t, which);
    else hit.take(both(holds, both(b > T(0.0), c > T(0.0))), t, which);
  }
  template <class T>
  AXISCERT_INLINE static T root(const T& a, const T& b, const T& c, const T& products) {
    if constexpr (form == RootForm::difference) return (b - square_root(b * b - a * c)) / a;
    else if constexpr (form == RootForm::quotient) return c / (b + square_root(b * b - a * c));
    else return c / (b + square_root(products));
  }

  template <class T>
  AXISCERT_INLINE static void edge(const Start<T>& q, const Vec3<T>& from, const Vec3<T>& to, double which,
                                   FirstHit<T>& hit) {
    const Vec3<T> along = to - from, n = cross(from, along), m = cross(q.d, along);
    const T e = dot(along, along), a = dot(m, m), b = dot(n, m), c = dot(n, n) - q.rr * e;
    T products = T(0.0);
    if constexpr (form == RootForm::products) {
      const T delta = dot(from, m);
      products = e * (q.rr * a - delta * delta);
    }
    const T t = root(a, b, c, products), foot = dot(q.d * t - from, along);
    take_root(hit, both(foot >= T(0.0), e >= foot), t, b, c, which);
  }
  template <class T>
  AXISCERT_INLINE static void vertex(const Start<T>& q, const Vec3<T>& at, double which, FirstHit<T>& hit) {
    const T a = dot(q.d, q.d), b = dot(at, q.d), c = dot(at, at) - q.rr;
    T products = T(0.0);
    if constexpr (form == RootForm::products) {
      const Vec3<T> w = cross(at, q.d);
      products = q.rr * a - dot(w, w);
    }
    const T t = root(a, b, c, products);
    take_root(hit, t >= T(0.0), t, b, c, which);
  }

  template <class T>
  AXISCERT_INLINE static ComparisonResult<T> is_left(const Vec3<T>& foot, const Vec3<T>& from, const Vec3<T>& to,
                                                     const Vec3<T>& normal) {
    return dot(cross(to - from, foot - from), normal) >= T(0.0);
  }
  template <class T>
  AXISCERT_INLINE static void face(const Start<T>& q, const FacePlane<T>& plane, FirstHit<T>& hit) {
    const T radius = chosen(T(0.0) > plane.offset, T(0.0) - q.r, q.r);
    const T t = (plane.offset - radius) / (dot(q.d, plane.normal) / plane.length);
    const Vec3<T> foot = q.d * t + plane.normal * (radius / plane.length);
    hit.take(both(is_left(foot, q.a, q.b, plane.normal),
                  both(is_left(foot, q.b, q.c, plane.normal), is_left(foot, q.c, q.a, plane.normal))),
             t, 6);
  }

  // The first time at which the centre, from outside, meets the face moved out by r, the inside of an edge's cylinder
  // or a vertex's sphere.
  template <class T>
  AXISCERT_INLINE static FirstHit<T> first(const Start<T>& q, const FacePlane<T>& plane) {
    FirstHit<T> hit{T(0.0) > T(0.0), T(2.0), T(-1.0)};
    face(q, plane, hit);
    edge(q, q.a, q.b, 3, hit);
    edge(q, q.b, q.c, 4, hit);
    edge(q, q.c, q.a, 5, hit);
    vertex(q, q.a, 0, hit);
    vertex(q, q.b, 1, hit);
    vertex(q, q.c, 2, hit);
    return hit;
  }
};

// Contact where the start overlaps, or where a piece is met at a time in [0, 1]. Over the reals it is right for every
// triangle with area and D != 0.
// Source: the method of C. Ericson, Real-Time Collision Detection (2005), section 5.3; closest point 5.1.5.
template <RootForm form>
struct RoundedForm {
  template <class T, class Query>
  AXISCERT_INLINE static FirstHit<T> first(const Query& query) {
    const Start<T> q = start_of<T>(query);
    const FacePlane<T> plane = face_plane(q);
    FirstHit<T> hit = RoundedPieces<form>::first(q, plane);
    const Vec3<T> nearest = nearest_point(q.a, q.b, q.c);
    const ComparisonResult<T> overlap = both(q.r >= magnitude(plane.offset), q.rr >= dot(nearest, nearest));
    return {either(hit.contact, overlap), chosen(overlap, T(0.0), hit.time), chosen(overlap, T(-1.0), hit.feature)};
  }
};

using RoundedDifference = RoundedForm<RootForm::difference>;
using RoundedQuotient = RoundedForm<RootForm::quotient>;
using RoundedProducts = RoundedForm<RootForm::products>;

}  // namespace AXISCERT_TARGET
}  // namespace axiscert
AXISCERT_AFTER_NAMESPACE();
#endif
