// The margins of the reduced test (kernel/sphere_triangle/forms/reduced.h) over several number types: integers of a
// fixed number of words, nonzero digits and balls.
#pragma once

namespace axiscert::certified {

template <class Number>
struct Vector {
  Number x, y, z;
  friend Vector operator-(const Vector& u, const Vector& v) noexcept { return {u.x - v.x, u.y - v.y, u.z - v.z}; }
  bool is_zero() const noexcept { return x.is_zero() && y.is_zero() && z.is_zero(); }
};

// a b - c d.
template <class Result, class A, class B, class C, class D>
Result difference_of_products(const A& a, const B& b, const C& c, const D& d) noexcept {
  return product<Result>(a, b) - product<Result>(c, d);
}
template <class Result, class U, class V>
Result dot(const Vector<U>& u, const Vector<V>& v) noexcept {
  return (product<Result>(u.x, v.x) + product<Result>(u.y, v.y)) + product<Result>(u.z, v.z);
}
template <class Result, class Number>
Vector<Result> cross(const Vector<Number>& u, const Vector<Number>& v) noexcept {
  return {difference_of_products<Result>(u.y, v.z, u.z, v.y), difference_of_products<Result>(u.z, v.x, u.x, v.z),
          difference_of_products<Result>(u.x, v.y, u.y, v.x)};
}

// Numbers::Value<degree> is the type of the values of a degree in the query's numbers.
template <class Numbers>
class ExactMargins {
 public:
  using One = typename Numbers::template Value<1>;
  using Two = typename Numbers::template Value<2>;
  using Three = typename Numbers::template Value<3>;
  using Four = typename Numbers::template Value<4>;
  using Six = typename Numbers::template Value<6>;
  using Point = Vector<One>;
  using Normal = Vector<Two>;

  // ax ay az bx by bz cx cy cz px py pz r.
  explicit ExactMargins(const One (&q)[13]) noexcept
      : vertex_{point(q, 0), point(q, 1), point(q, 2)}, rr_(product<Two>(q[12], q[12])) {
    const Point centre = point(q, 3);
    for (int i = 0; i < 3; ++i) from_centre_[i] = vertex_[i] - centre;
  }

  const Point& from_centre(int i) const noexcept { return from_centre_[i]; }
  static int next(int i) noexcept { return i == 2 ? 0 : i + 1; }
  static int last(int i) noexcept { return i == 0 ? 2 : i - 1; }
  // A difference of the vertices themselves. Computed from their differences with a far centre, it would be a ball too
  // wide to tell anything.
  Point between(int i, int to) const noexcept { return vertex_[to] - vertex_[i]; }
  Point along(int i) const noexcept { return between(i, next(i)); }
  Normal plane_normal() const noexcept { return cross<Two>(between(0, 1), between(0, 2)); }
  Normal edge_normal(int i, const Point& along) const noexcept { return cross<Two>(from_centre_[i], along); }

  Two vertex_radius(int i) const noexcept { return dot<Two>(from_centre_[i], from_centre_[i]) - rr_; }
  Two vertex_side(int i, int to) const noexcept { return dot<Two>(from_centre_[i], between(i, to)); }
  Three plane_offset(const Normal& V) const noexcept { return dot<Three>(from_centre_[0], V); }
  Six plane_radius(const Normal& V) const noexcept {
    const Three d = plane_offset(V);
    return difference_of_products<Six>(d, d, rr_, dot<Four>(V, V));
  }
  Four edge_radius(const Normal& N, const Point& along) const noexcept {
    return dot<Four>(N, N) - product<Four>(rr_, dot<Two>(along, along));
  }
  Four edge_side(const Normal& N, const Normal& V) const noexcept { return dot<Four>(N, V); }

 private:
  static Point point(const One (&q)[13], int i) noexcept { return {q[3 * i], q[3 * i + 1], q[3 * i + 2]}; }

  Point vertex_[3], from_centre_[3];
  Two rr_;
};

}  // namespace axiscert::certified
