// The first step: the margins of the reduced form in the input's precision, one query a lane, against one threshold for
// each degree (kernel/certified/thresholds.h has the derivation). No guard: included once for each of Highway's
// instruction sets.
//
// Costs less than the test that it certifies: each axis is the least of its margins, the axes of a degree are the
// greatest of these, and only that is compared; dot products need not be in the published order, so they are fused.
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using axiscert::HWY_NAMESPACE::cross, axiscert::HWY_NAMESPACE::dot, axiscert::HWY_NAMESPACE::Problem,
    axiscert::HWY_NAMESPACE::Vec3;

// N queries at once; dot and cross products fused where the instruction set can and where that is wanted.
template <class D, bool fused = true>
struct Lanes {
  using V = hn::Vec<D>;
  V v;
  AXISCERT_INLINE friend Lanes operator+(const Lanes& a, const Lanes& b) { return {hn::Add(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a, const Lanes& b) { return {hn::Sub(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator*(const Lanes& a, const Lanes& b) { return {hn::Mul(a.v, b.v)}; }
  AXISCERT_INLINE friend Lanes operator-(const Lanes& a) { return {hn::Neg(a.v)}; }
  // c - a b.
  AXISCERT_INLINE static Lanes minus_product(const Lanes& c, const Lanes& a, const Lanes& b) {
    if constexpr (fused) return {hn::NegMulAdd(a.v, b.v, c.v)};
    else return c - a * b;
  }
  AXISCERT_INLINE static Lanes dot(const Vec3<Lanes>& a, const Vec3<Lanes>& b)
    requires fused
  {
    return {hn::MulAdd(a.z.v, b.z.v, hn::MulAdd(a.y.v, b.y.v, hn::Mul(a.x.v, b.x.v)))};
  }
  AXISCERT_INLINE static Vec3<Lanes> cross(const Vec3<Lanes>& a, const Vec3<Lanes>& b)
    requires fused
  {
    return {minus_product(a.y * b.z, a.z, b.y), minus_product(a.z * b.x, a.x, b.z), minus_product(a.x * b.y, a.y, b.x)};
  }
};
template <class D, bool fused>
AXISCERT_INLINE Lanes<D, fused> least(const Lanes<D, fused>& a, const Lanes<D, fused>& b) {
  return {hn::Min(a.v, b.v)};
}
template <class D, bool fused>
AXISCERT_INLINE Lanes<D, fused> greatest(const Lanes<D, fused>& a, const Lanes<D, fused>& b) {
  return {hn::Max(a.v, b.v)};
}

// Lanes in neither are passed on: a margin within its threshold, a size outside the range, or no valid query.
template <class D>
struct Decided {
  hn::Mask<D> separated, contact;
};

// The thresholds of a query of magnitude S whose triangle has the size E, and what margins are to them: the greatest of
// the axes of each degree.
template <class D, bool fused>
struct CoarseLimits {
  using T = Lanes<D, fused>;
  using Real = hn::TFromD<D>;
  T degree2, degree4, degree6;

  AXISCERT_INLINE CoarseLimits(const T& S, const T& E) {
    constexpr double u = unit_roundoff<Real>;
    const auto constant = [](double x) HWY_ATTR { return T{hn::Set(D(), static_cast<Real>(x))}; };
    const T SE = S * E;
    degree2 = constant(filter::CoarseBounds::degree_2 * u) * S;
    degree4 = constant(filter::CoarseBounds::degree_4 * u) * SE;
    degree6 = constant(filter::CoarseBounds::degree_6 * u) * (SE * E);
  }
  AXISCERT_INLINE hn::Mask<D> any_beyond(const T& vertices, const T& edges, const T& plane) const {
    return hn::Or(hn::Or(hn::Gt(vertices.v, degree2.v), hn::Gt(edges.v, degree4.v)), hn::Gt(plane.v, degree6.v));
  }
  AXISCERT_INLINE hn::Mask<D> all_within(const T& vertices, const T& edges, const T& plane) const {
    return hn::And(hn::And(hn::Lt(vertices.v, hn::Neg(degree2.v)), hn::Lt(edges.v, hn::Neg(degree4.v))),
                   hn::Lt(plane.v, hn::Neg(degree6.v)));
  }
  // S is neither in the range nor out of it where a number is not finite; r >= 0 has to be asked.
  AXISCERT_INLINE static hn::Mask<D> in_range(const T& S, const T& r) {
    return hn::And(
        hn::And(hn::Ge(S.v, hn::Set(D(), least_square<Real>)), hn::Le(S.v, hn::Set(D(), greatest_square<Real>))),
        hn::Ge(r.v, hn::Zero(D())));
  }
};

template <class D, bool fused>
AXISCERT_INLINE Decided<D> coarse_step(D d, const Problem<Lanes<D, fused>>& q) {
  using T = Lanes<D, fused>;
  using Real = hn::TFromD<D>;
  const auto constant = [d](double x) HWY_ATTR { return T{hn::Set(d, static_cast<Real>(x))}; };
  const Vec3<T> A = q.a - q.p, B = q.b - q.p, C = q.c - q.p;
  const Vec3<T> AB = q.b - q.a, BC = q.c - q.b, CA = q.a - q.c;
  const T aa = dot(A, A), bb = dot(B, B), cc = dot(C, C), rr = q.r * q.r;
  const T e1 = dot(AB, AB), e2 = dot(BC, BC), e3 = dot(CA, CA);
  const T S = ((aa + bb) + cc) + rr;
  const T E = ((e1 + e2) + e3) + constant(least_relative_triangle) * S;

  // 2 A.AB = (B.B - A.A) - e1, and so on.
  const T ab = bb - aa, ac = cc - aa, bc = cc - bb;
  const T vertex_a = least(least(aa - rr, ab - e1), ac - e3);
  const T vertex_b = least(least(bb - rr, -ab - e1), bc - e2);
  const T vertex_c = least(least(cc - rr, -ac - e3), -bc - e2);
  const T vertices = greatest(greatest(vertex_a, vertex_b), vertex_c);

  const Vec3<T> V = cross(CA, AB);  // AB x AC
  const auto edge = [&](const Vec3<T>& from, const Vec3<T>& along, const T& e) HWY_ATTR {
    const Vec3<T> N = cross(from, along);
    return least(T::minus_product(dot(N, N), rr, e), -dot(N, V));
  };
  const T edges = greatest(greatest(edge(A, AB, e1), edge(B, BC, e2)), edge(C, CA, e3));

  const T offset = dot(A, V);
  const T plane = T::minus_product(offset * offset, rr, dot(V, V));

  const CoarseLimits<D, fused> limits(S, E);
  const auto in_range = limits.in_range(S, q.r);
  return {hn::And(in_range, limits.any_beyond(vertices, edges, plane)),
          hn::And(in_range, limits.all_within(vertices, edges, plane))};
}

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
