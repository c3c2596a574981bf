// Boxes that touch, but for the rounding of B's centre and some ulps: in any direction, at two edges, at a vertex and a
// facet, and with extents that are far from each other.
#include "fuzz/boxes/parts.h"

namespace axiscert::boxes {
namespace {

struct Tangent {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    Pair q = anywhere<Pair>(random, position);
    solve_tangent(q);
    nudge(random, 2, q);
    return q;
  }
};

// One extent of A and every other time one of B times 2^-10 or 2^-20, in turn.
struct Thin {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q = anywhere<Pair>(random, position);
    const Real factor = position / 2 % 2 == 0 ? Real(0x1p-10) : Real(0x1p-20);
    const auto of_a = random.below(3), of_b = random.below(3);
    q.a.half[of_a] *= factor;
    if (random.coin()) q.b.half[of_b] *= factor;
    solve_tangent(q);
    nudge(random, 2, q);
    return q;
  }
};

// The point of the box farthest along `direction`, seen from its centre. Where an edge or a facet is at right angles to
// it, any point of that, at eighths of the edges.
Point farthest(Stream& random, const ExactBox& box, const Point& direction) {
  Point sum{0, 0, 0};
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational slope = dot(direction, box.axis[k]);
    Rational t(random.integer(-7, 7), 8);
    t.canonicalize();
    if (slope != 0) t = slope > 0 ? 1 : -1;
    sum = sum + box.axis[k] * Rational(box.half[k] * t);
  }
  return sum;
}

// The axis' plane has A on one side and B on the other and a point of both in it, so they touch; then every other time
// some ulps. Parallel edges, whose axis is 0, leave the query as it is.
template <class Pair>
Pair touching_on(Stream& random, std::uint64_t position, std::size_t axis) {
  Pair q = anywhere<Pair>(random, position);
  const ExactPair exact = exactly(q);
  const Point product = direction(exact, axis), along = random.coin() ? product : product * Rational(-1);
  const Point of_a = farthest(random, exact.a, along), of_b = farthest(random, exact.b, along * Rational(-1));
  if (dot(along, along) != 0) q.b.centre = rounded_point<RealOf<Pair>>(exact.a.centre + of_a - of_b);
  if (position / 2 % 2 == 1) nudge(random, 2, q);
  return q;
}

struct EdgeEdge {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    return touching_on<Pair>(random, position, edges(0, 0) + position / 4 % 9);
  }
};
struct VertexFace {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    return touching_on<Pair>(random, position, position / 4 % 6);
  }
};

// A's centre 2^k from 0 in each coordinate before the place of contact is solved and rounded.
struct Far {
  template <class Pair>
  static Pair make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Pair>;
    Pair q = anywhere<Pair>(random, position);
    const int least = 4, count = sizeof(Real) == 4 ? 16 : 44;
    const Real offset = std::ldexp(Real(1), least + static_cast<int>(position % static_cast<unsigned>(count)));
    const Vec3<Real> by{random.coin() ? offset : -offset, offset, -offset};
    const Vec3<Real> between = q.b.centre - q.a.centre;
    q.a.centre = q.a.centre + by;
    q.b.centre = q.a.centre + between;
    solve_tangent(q);
    nudge(random, 1, q);
    return q;
  }
};

}  // namespace

extern const Family box_box_tangent_family = matrix_family<Tangent, 2>(
    "box-box/tangent", box_box_situation::touching,
    "any two rotations, rounded; B's centre where they touch, and up to four ulps from there");
extern const Family box_box_thin_family = matrix_family<Thin, 2>(
    "box-box/thin", box_box_situation::flat, "tangent, with an extent of A, or one of each, times 2^-10 or 2^-20");
extern const Family box_box_edge_edge_family = matrix_family<EdgeEdge, 2>(
    "box-box/edge_edge", box_box_situation::touching,
    "an edge of A touches an edge of B, each pair of edges in turn; every other one up to 4 ulps");
extern const Family box_box_vertex_face_family =
    matrix_family<VertexFace, 2>("box-box/vertex_face", box_box_situation::touching,
                                 "a vertex touches a facet, the six normals in turn; every other one up to 4 ulps");
extern const Family box_box_far_family = matrix_family<Far, 2>("box-box/far", box_box_situation::far,
                                                               "tangent, 2^4 to 2^19 (binary64: 2^47) from the origin");

extern const Family box_box_tangent_turned_family = turned_family<Tangent, 2>(
    "box-box/tangent_turned", box_box_situation::touching, "tangent, as quaternions of integers");
extern const Family box_box_edge_edge_turned_family = turned_family<EdgeEdge, 2>(
    "box-box/edge_edge_turned", box_box_situation::touching, "edge_edge, as quaternions of integers");
extern const Family box_box_vertex_face_turned_family = turned_family<VertexFace, 2>(
    "box-box/vertex_face_turned", box_box_situation::touching, "vertex_face, as quaternions of integers");

}  // namespace axiscert::boxes
