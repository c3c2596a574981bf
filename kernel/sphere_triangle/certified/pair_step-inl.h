// The first step for a single query: one lane for each vertex and the edge that begins there. No include guard:
// included once for each of Highway's instruction sets, after coarse_step-inl.h.
//
// Each lane has what coarse_step computes for the same triangle with its vertices renamed in turn: S, E, the axes of
// the vertex called A and of the edge AB, and the plane's. So what is certain in a lane is certain for the query, and
// the three lanes together have all axes.
HWY_BEFORE_NAMESPACE();
namespace axiscert::certified {
namespace HWY_NAMESPACE {

// Four lanes: A, B, C and again A.
template <class D>
class PairStep {
 public:
  using T = Lanes<D>;
  using Real = hn::TFromD<D>;
  static_assert(hn::MaxLanes(D()) == 4);

  // triangle: ax ay az bx by bz cx cy cz. sphere: px py pz r.
  AXISCERT_INLINE PairStep(const Real* triangle, const Real* sphere) noexcept {
    const D d;
    const auto column = [&](std::size_t k) HWY_ATTR {
      alignas(32) const Real x[4] = {triangle[k], triangle[3 + k], triangle[6 + k], triangle[k]};
      return T{hn::Load(d, x)};
    };
    const auto set = [&](std::size_t k) HWY_ATTR { return T{hn::Set(d, sphere[k])}; };
    const Vec3<T> vertex = {column(0), column(1), column(2)};
    const Vec3<T> A = vertex - Vec3<T>{set(0), set(1), set(2)};
    const Vec3<T> along = next(vertex) - vertex, before = last(along);
    const T r = set(3), rr = r * r, aa = dot(A, A), e = dot(along, along);
    const T bb = next(aa), cc = last(aa), e_before = last(e);
    const T S = ((aa + bb) + cc) + rr;
    const T E = ((e + next(e)) + e_before) + constant(least_relative_triangle) * S;

    const T vertices = least(least(aa - rr, (bb - aa) - e), (cc - aa) - e_before);
    const Vec3<T> V = cross(before, along), N = cross(A, along);
    const T edges = least(T::minus_product(dot(N, N), rr, e), -dot(N, V));
    const T offset = dot(A, V);
    const T plane = T::minus_product(offset * offset, rr, dot(V, V));

    const CoarseLimits<D, true> limits(S, E);
    const auto in_range = limits.in_range(S, r);
    separated_ = !hn::AllFalse(d, hn::And(in_range, limits.any_beyond(vertices, edges, plane)));
    contact_ = hn::AllTrue(d, hn::And(in_range, limits.all_within(vertices, edges, plane)));
  }
  // If neither is true, the query is passed on.
  bool separated() const noexcept { return separated_; }
  bool contact() const noexcept { return contact_; }

 private:
  AXISCERT_INLINE static T constant(double x) { return {hn::Set(D(), static_cast<Real>(x))}; }
  template <int a, int b, int c>
  AXISCERT_INLINE static T permuted(const T& x) {
    using Index = hn::TFromD<hn::RebindToSigned<D>>;
    alignas(32) static constexpr Index from[4] = {a, b, c, a};
    return {hn::TableLookupLanes(x.v, hn::SetTableIndices(D(), from))};
  }
  AXISCERT_INLINE static T next(const T& x) { return permuted<1, 2, 0>(x); }
  AXISCERT_INLINE static T last(const T& x) { return permuted<2, 0, 1>(x); }
  AXISCERT_INLINE static Vec3<T> next(const Vec3<T>& v) { return {next(v.x), next(v.y), next(v.z)}; }
  AXISCERT_INLINE static Vec3<T> last(const Vec3<T>& v) { return {last(v.x), last(v.y), last(v.z)}; }

  bool separated_, contact_;
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert::certified
HWY_AFTER_NAMESPACE();
