#include "exact/moving_sphere/motion_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace axiscert::moving_sphere {
namespace {

using Integer = mpz_class;
using Vector = portable::Vec3<Integer>;
using portable::cross;
using portable::dot;

// The exponent of a finite number's last bit, as if each had 53.
int last_bit(double x) {
  int exponent = 0;
  std::frexp(x, &exponent);
  return exponent - std::numeric_limits<double>::digits;
}

// The least exponent of the query's numbers; 0 where all are 0.
int common_exponent(const GivenMotion& q) {
  std::optional<int> least;
  for (const auto& v : {q.a, q.b, q.c, q.p, q.to}) {
    for (const double x : {v.x, v.y, v.z}) {
      if (x != 0) least = std::min(least.value_or(last_bit(x)), last_bit(x));
    }
  }
  return least.value_or(0);
}

Integer integer(double x, int exponent) {
  if (x == 0) return 0;
  Integer whole(std::ldexp(x, -last_bit(x)));
  mpz_mul_2exp(whole.get_mpz_t(), whole.get_mpz_t(), static_cast<mp_bitcnt_t>(last_bit(x) - exponent));
  return whole;
}
Vector integers(const portable::Vec3<double>& v, int exponent) {
  return {integer(v.x, exponent), integer(v.y, exponent), integer(v.z, exponent)};
}

// A piece with the times in [0, 1] at which all gates are open, and nothing else; empty where there are none.
std::optional<Piece> opened(Feature feature, std::vector<Gate> gates) {
  // A gate's sign at both ends tells most: closed throughout, open throughout, or turning between.
  std::vector<const Gate*> turning;
  for (const Gate& gate : gates) {
    const bool at_first = gate.value >= 0, at_last = gate.value >= -gate.slope;
    if (!at_first && !at_last) return std::nullopt;
    if (!at_first || !at_last) turning.push_back(&gate);
  }
  Piece piece{feature, {}, 0, 1, {}, {}, {}, {}};
  for (const Gate* gate : turning) {
    const Rational turns = quotient(-gate->value, gate->slope);
    if (gate->slope > 0) piece.first = std::max(piece.first, turns);
    else piece.last = std::min(piece.last, turns);
  }
  if (piece.first > piece.last) return std::nullopt;
  piece.gates = std::move(gates);
  return piece;
}

}  // namespace

Rational quotient(const Integer& numerator, const Integer& denominator) {
  Rational q(numerator, denominator);
  q.canonicalize();
  return q;
}

MotionPieces::MotionPieces(const GivenMotion& q) : exponent(common_exponent(q)) {
  const Vector p = integers(q.p, exponent);
  vertex = {integers(q.a, exponent) - p, integers(q.b, exponent) - p, integers(q.c, exponent) - p};
  d = q.displacement<Integer>([&](double x) { return integer(x, exponent); });
  normal = cross(vertex[1] - vertex[0], vertex[2] - vertex[0]);

  const auto at = [&](std::size_t i) -> const Vector& { return vertex[i % 3]; };
  // The gate X.N >= 0 of a point X that is seen to move by -D.
  const auto gate = [&](const Vector& x, const Vector& n) { return Gate{dot(x, n), -dot(d, n)}; };
  // The gates (X x U).V of edges U at X: whether the centre is on the inner side of the edge's plane.
  std::vector<Gate> inner;
  // `squares` are a, b, c and the divisor.
  const auto add = [&](Feature feature, std::vector<Gate> gates, auto&& squares) {
    std::optional<Piece> piece = opened(feature, std::move(gates));
    if (!piece) return;
    std::tie(piece->a, piece->b, piece->c, piece->divisor) = squares();
    pieces.push_back(*std::move(piece));
  };
  for (std::size_t i = 0; i < 3; ++i) {
    const Vector &a = at(i), &b = at(i + 1), &c = at(i + 2);
    // Nearest is the vertex where the centre is beyond it along both of its edges.
    add(static_cast<Feature>(i), {gate(a, b - a), gate(a, c - a)},
        [&] { return std::tuple(dot(d, d), dot(a, d), dot(a, a), Integer(1)); });

    // Nearest is a point inside the edge where the foot is on it, and the centre on its outer side.
    const Vector along = b - a, n = cross(a, along), m = cross(d, along);
    const Integer e = dot(along, along);
    if (e == 0) continue;
    const Gate from = gate(a, along), to = gate(b, along);
    inner.push_back({dot(n, normal), -dot(m, normal)});
    const Gate& in = inner.back();
    add(static_cast<Feature>(3 + i), {{-from.value, -from.slope}, to, {-in.value, -in.slope}},
        [&] { return std::tuple(dot(m, m), dot(n, m), dot(n, n), e); });
  }
  if (const Integer v = dot(normal, normal); v != 0) {
    const Integer offset = dot(at(0), normal), m = dot(d, normal);
    // A triangle with area has three edges.
    add(Feature::face, std::move(inner),
        [&] { return std::tuple(Integer(m * m), Integer(offset * m), Integer(offset * offset), v); });
  }
  std::stable_sort(pieces.begin(), pieces.end(), [](const Piece& x, const Piece& y) { return x.first < y.first; });
}

namespace {

using Integer = mpz_class;
using portable::cross;
using portable::dot;

// A parabola that is nowhere negative is least at b / a, or at the end of the piece that is nearer to it.
Rational least_of(const Piece& piece) {
  const auto& [feature, gates, first, last, a, b, c, divisor] = piece;
  if (a == 0) return quotient(c, divisor);
  const Rational t = std::max(first, std::min(last, quotient(b, a)));
  return ((a * t - 2 * b) * t + c) / divisor;
}

bool crosses_the_face(const MotionPieces& motion) {
  const Integer offset = dot(motion.vertex[0], motion.normal), m = dot(motion.d, motion.normal);
  const int forwards = sgn(m);
  if (forwards == 0 || forwards * sgn(offset) <= 0 || abs(offset) >= abs(m)) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto along = motion.vertex[(i + 1) % 3] - motion.vertex[i];
    const Integer side =
        m * dot(cross(motion.vertex[i], along), motion.normal) - offset * dot(cross(motion.d, along), motion.normal);
    if (forwards * sgn(side) <= 0) return false;
  }
  return true;
}

}  // namespace

LeastDistance least_distance(const GivenMotion& q) {
  const MotionPieces motion(q);
  std::optional<Rational> least;
  for (const Piece& piece : motion.pieces) {
    Rational squared = least_of(piece);
    if (!least || squared < *least) least = std::move(squared);
  }
  return {times_power(*least, 2 * motion.exponent), crosses_the_face(motion)};
}

}  // namespace axiscert::moving_sphere
