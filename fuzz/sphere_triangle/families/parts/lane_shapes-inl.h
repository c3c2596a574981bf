// The shapes of shapes.h in lanes: one query per lane, selects instead of branches. Every draw is made in every lane,
// whether its query needs it or not.
#include "fuzz/queries/lane_stream-inl.h"

HWY_BEFORE_NAMESPACE();
namespace axiscert {
namespace HWY_NAMESPACE {

template <class T>
using LaneVertices = std::array<Vec3<T>, 3>;

template <class T, class M>
AXISCERT_INLINE T select(M mask, const T& yes, const T& no) {
  return {hn::IfThenElse(mask, yes.v, no.v)};
}
template <class T, class M>
AXISCERT_INLINE Vec3<T> select(M mask, const Vec3<T>& yes, const Vec3<T>& no) {
  return {select(mask, yes.x, no.x), select(mask, yes.y, no.y), select(mask, yes.z, no.z)};
}
template <class T>
AXISCERT_INLINE T square_root(const T& x) {
  return {hn::Sqrt(x.v)};
}
template <class T>
AXISCERT_INLINE T magnitude(const T& x) {
  return {hn::Abs(x.v)};
}
template <class T>
AXISCERT_INLINE T greater_of(const T& x, const T& y) {
  return select(hn::Gt(y.v, x.v), y, x);
}
template <class T>
AXISCERT_INLINE T length(const Vec3<T>& v) {
  return square_root(dot(v, v));
}

// A value that a query's position determines: number(position) in each lane, from the position of lane 0.
template <class Random, class Number, class Real = hn::TFromD<typename Random::D>>
AXISCERT_INLINE typename Random::T by_position(std::uint64_t first, Number number) {
  HWY_ALIGN Real each[Random::lanes];
  for (std::size_t i = 0; i < Random::lanes; ++i) each[i] = static_cast<Real>(number(first + i));
  return {hn::Load(typename Random::D(), each)};
}
// number(position), where it is periodic: from a table.
template <class Number, class Element, std::uint64_t period, std::size_t lanes>
std::array<Element, period + lanes> periodic_table(Number number) {
  std::array<Element, period + lanes> table;
  for (std::uint64_t i = 0; i < table.size(); ++i) table[i] = static_cast<Element>(number(i % period));
  return table;
}
template <class Random, std::uint64_t period, class Number, class Real = hn::TFromD<typename Random::D>>
AXISCERT_INLINE typename Random::T in_turn(std::uint64_t first, Number number) {
  static const auto table = periodic_table<Number, Real, period, Random::lanes>(number);
  return {hn::LoadU(typename Random::D(), table.data() + first % period)};
}
template <class Random, std::uint64_t period, class Number, class Word = hn::TFromD<typename Random::DW>>
AXISCERT_INLINE typename Random::W in_turn_words(std::uint64_t first, Number number) {
  static const auto table = periodic_table<Number, Word, period, Random::lanes>(number);
  return hn::LoadU(typename Random::DW(), table.data() + first % period);
}

// 2^-times, with `times` at most 126: exact.
template <class Random>
AXISCERT_INLINE typename Random::T halved_one(typename Random::W times) {
  using Real = hn::TFromD<typename Random::D>;
  constexpr int fraction_bits = std::numeric_limits<Real>::digits - 1;
  const auto bias = hn::Set(typename Random::DW(), std::numeric_limits<Real>::max_exponent - 1);
  return {hn::BitCast(typename Random::D(), hn::ShiftLeft<fraction_bits>(hn::Sub(bias, times)))};
}

template <class Random, class T = typename Random::T>
AXISCERT_INLINE Vec3<T> in_cube(Random& random) {
  const T x = random.symmetric(), y = random.symmetric(), z = random.symmetric();
  return {x, y, z};
}
template <class Random, class T = typename Random::T>
AXISCERT_INLINE LaneVertices<T> vertices_in_cube(Random& random) {
  const Vec3<T> a = in_cube(random), b = in_cube(random), c = in_cube(random);
  return {a, b, c};
}

// Integers in [-bound, bound], never all zero.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE Vec3<T> integers(Random& random, std::int32_t bound) {
  const T x = random.integer(-bound, bound), y = random.integer(-bound, bound), z = random.integer(-bound, bound);
  const T zero = Random::constant(0);
  const auto all_zero = hn::And(hn::And(hn::Eq(x.v, zero.v), hn::Eq(y.v, zero.v)), hn::Eq(z.v, zero.v));
  return {select(all_zero, Random::constant(1), x), y, z};
}

// v scaled to length one, up to rounding; a zero vector stays zero.
template <class T>
AXISCERT_INLINE Vec3<T> at_unit_length(const Vec3<T>& v) {
  const T size = length(v);
  return select(hn::Gt(size.v, hn::Xor(size.v, size.v)), v / size, v);
}

// The local vertices in another order: A is local[a], B is local[b], C the third. The indices may differ from lane to
// lane.
template <class T>
AXISCERT_INLINE LaneVertices<T> arranged(const LaneVertices<T>& local, const T& a, const T& b) {
  const auto one = hn::Set(hn::DFromV<decltype(a.v)>(), 1);
  const auto at = [&](const T& which) HWY_ATTR {
    return select(hn::Lt(which.v, one), local[0], select(hn::Eq(which.v, one), local[1], local[2]));
  };
  const T three = T{hn::Set(hn::DFromV<decltype(a.v)>(), 3)};
  return {at(a), at(b), at(three - a - b)};
}

// One of the six orders, all equally likely.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE LaneVertices<T> shuffled(Random& random, const LaneVertices<T>& vertices) {
  const T first = random.integer(0, 2);
  const auto swapped = random.coin();
  const T two = Random::constant(2), after = first + Random::constant(1), before = first + two;
  const T three = Random::constant(3);
  const auto wrapped = [&](const T& n) HWY_ATTR { return select(hn::Ge(n.v, three.v), n - three, n); };
  return arranged(vertices, first, wrapped(select(swapped, before, after)));
}

// Unit directions at a triangle with area: its normal, and the direction in its plane across the edge from vertex 0 to
// vertex 1.
template <class T>
AXISCERT_INLINE Vec3<T> unit_normal(const LaneVertices<T>& v) {
  return at_unit_length(cross(v[1] - v[0], v[2] - v[0]));
}
template <class T>
AXISCERT_INLINE Vec3<T> outward(const Vec3<T>& from, const Vec3<T>& to, const Vec3<T>& normal) {
  return at_unit_length(cross(to - from, normal));
}

// A point inside the triangle, a few per cent away from its edges.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE Vec3<T> inside(Random& random, const LaneVertices<T>& v) {
  T weight[3];
  for (T& w : weight) w = random.unit() + Random::constant(0x1p-5);
  const T sum = (weight[0] + weight[1]) + weight[2];
  return (v[0] * (weight[0] / sum) + v[1] * (weight[1] / sum)) + v[2] * (weight[2] / sum);
}

// A fraction of an edge, from a few per cent to all but a few per cent.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE T share_of_edge(Random& random) {
  return Random::constant(0x1p-5) + random.unit() * Random::constant(0.9375);
}

// A length in [2^-7, 2), with its logarithm spread evenly over the octaves.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE T height(Random& random) {
  const T significand = Random::constant(1) + random.unit();
  return significand * halved_one<Random>(random.below(8));
}

template <class T>
struct LaneQuery {
  LaneVertices<T> v;
  Vec3<T> p;
  T r;
  T wishes[2];  // for the code that finishes the query; see the family
};

// A triangle built around the origin, where floats are dense, with a centre in the cube or, for one query in four, up
// to `halvings` octaves nearer to the origin. Half of the queries are then moved away, where rounding limits how fine a
// shape can be.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE void place(Random& random, typename Random::W halvings, LaneQuery<T>& q) {
  const Vec3<T> anywhere = in_cube(random);
  const typename Random::W none = hn::Zero(typename Random::DW());
  const auto nearer = hn::Eq(random.below(4), none);
  const auto times = random.below(hn::Add(halvings, hn::Set(typename Random::DW(), 1)));
  q.p = anywhere * halved_one<Random>(hn::IfThenElse(nearer, times, none));
  const auto moved = random.coin();
  const Vec3<T> offset = in_cube(random);
  for (Vec3<T>& v : q.v) v = select(moved, v + offset, v);
  q.p = select(moved, q.p + offset, q.p);
}

// A quarter of the radii within 4 ulp of the exact distance, a quarter different from it by a factor 1 +- 2^-1 ..
// 2^-20, and half uniform up to the farthest vertex. The first two are solved when the rest of the query is known: the
// wishes are the number of ulps to step from the distance and the factor to multiply by afterwards, which is 0 if the
// radius is already set.
template <class Random, class T = typename Random::T>
AXISCERT_INLINE void aim(Random& random, LaneQuery<T>& q) {
  const T how = random.integer(0, 3), ulps = random.integer(-4, 4), sign = random.sign();
  const auto times = hn::Add(random.below(20), hn::Set(typename Random::DW(), 1));
  const T share = random.unit();
  const T zero = Random::constant(0), one = Random::constant(1);
  const auto near = hn::Eq(how.v, zero.v), off = hn::Eq(how.v, one.v);
  const Vec3<T> a = q.v[0] - q.p, b = q.v[1] - q.p, c = q.v[2] - q.p;
  q.r = share * square_root(greater_of(greater_of(dot(a, a), dot(b, b)), dot(c, c)));
  q.wishes[0] = select(near, ulps, zero);
  q.wishes[1] = select(near, one, select(off, one + sign * halved_one<Random>(times), zero));
}

struct AimedRadii {
  static constexpr bool solves = true;
  template <class Real>
  static void finish(std::uint64_t, const MutableColumns<Real>& queries, const shapes::Wishes<Real>& wishes) {
    shapes::solve_aimed_radii(queries, wishes);
  }
};

}  // namespace HWY_NAMESPACE
}  // namespace axiscert
HWY_AFTER_NAMESPACE();
