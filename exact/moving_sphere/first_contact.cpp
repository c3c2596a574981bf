#include "exact/moving_sphere/first_contact.h"

#include <mpfr.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscert::moving_sphere {
namespace {

// r^2 in squares of the motion's unit.
Rational limit_of(const GivenMotion& q, const MotionPieces& motion) {
  const Rational r = times_power(exact(q.r), -motion.exponent);
  return r * r;
}

// Squared distance less the limit, times the divisor, which is positive.
Rational excess(const Piece& piece, const Rational& limit, const Rational& t) {
  return (piece.a * t - 2 * piece.b) * t + piece.c - limit * piece.divisor;
}

// The first time of the piece at which the squared distance is not above the limit.
std::optional<RootTime> first_within(const Piece& piece, const Rational& limit) {
  if (excess(piece, limit, piece.first) <= 0) return RootTime{piece.first, 0};
  if (piece.a == 0) return std::nullopt;
  // It begins above the limit, so the lesser root comes later, if at all: where the parabola is still falling, and
  // where it is at or below the limit at its lowest, or by the end of the piece.
  const Rational lowest = quotient(piece.b, piece.a);
  if (lowest <= piece.first || excess(piece, limit, std::min(lowest, piece.last)) > 0) return std::nullopt;
  const Rational c = piece.c - limit * piece.divisor;
  return RootTime{lowest, lowest * lowest - c / piece.a};
}

Start start_of(const MotionPieces& motion, const Rational& limit) {
  const int order = sgn(excess(motion.pieces.front(), limit, 0));  // the first piece begins at 0
  return order < 0 ? Start::overlap : order == 0 ? Start::touching : Start::clear;
}

FeatureSet nearest_at(const MotionPieces& motion, const RootTime& t) {
  FeatureSet nearest;
  for (const Piece& piece : motion.pieces) {
    const bool open = std::all_of(piece.gates.begin(), piece.gates.end(),
                                  [&](const Gate& gate) { return sign_at(t, gate.value, gate.slope) >= 0; });
    if (open) nearest.insert(piece.feature);
  }
  return nearest;
}

}  // namespace

int sign_at(const RootTime& t, const Rational& value, const Rational& slope) {
  // rest - slope sqrt(square), by signs, then by squares.
  const Rational rest = value + slope * t.rest;
  const int rest_sign = sgn(rest), root_sign = -sgn(slope) * sgn(t.square);
  if (rest_sign == 0 || root_sign == 0 || rest_sign == root_sign) return rest_sign != 0 ? rest_sign : root_sign;
  return rest_sign * cmp(rest * rest, slope * slope * t.square);
}

MovingPoint nearest_point(const MotionPieces& motion, Feature feature) {
  using RationalVector = portable::Vec3<Rational>;
  const RationalVector d = rationals(motion.d);
  const std::size_t i = index_of(feature);
  const auto vertex = [&](std::size_t k) { return rationals(motion.vertex[k % 3]); };
  if (i < index_of(Feature::edge_ab)) return {vertex(i), {}};
  if (feature == Feature::face) {
    const RationalVector n = rationals(motion.normal);
    const Rational square = portable::dot(n, n);
    return {n * Rational(portable::dot(vertex(0), n) / square), d - n * Rational(portable::dot(d, n) / square)};
  }
  const RationalVector from = vertex(i), edge = vertex(i + 1) - from;
  const Rational square = portable::dot(edge, edge);
  return {from - edge * Rational(portable::dot(from, edge) / square), edge * Rational(portable::dot(d, edge) / square)};
}

std::optional<FirstContact> first_contact(const GivenMotion& q) { return first_contact(q, MotionPieces(q)); }

std::optional<FirstContact> first_contact(const GivenMotion& q, const MotionPieces& motion) {
  const Rational limit = limit_of(q, motion);
  for (const Piece& piece : motion.pieces) {
    if (const std::optional<RootTime> t = first_within(piece, limit)) {
      return FirstContact{start_of(motion, limit), *t, nearest_at(motion, *t)};
    }
  }
  return std::nullopt;
}

bool is_promised(const MotionPolicy& policy, const GivenMotion& q) {
  const MotionPieces motion(q);
  if (policy.still == StillPolicy::ignored && portable::dot(motion.d, motion.d) == 0) return false;
  if (policy.sides == SidesPolicy::front && sgn(portable::dot(motion.d, motion.normal)) >= 0) return false;
  if (policy.start == StartPolicy::reported || start_of(motion, limit_of(q, motion)) == Start::clear) return true;
  // At time 0 the squared distance falls by 2 b; it is smooth, so every piece that begins there has the same.
  return policy.start == StartPolicy::approaching && sgn(motion.pieces.front().b) > 0;
}

// The guess is the nearest number or one beside it; what is returned is decided by comparisons.
template <class Real>
Real rounded_down(const RootTime& t) {
  Real not_late = nearest<Real>(approximate(t));
  while (compare(t, exact(not_late)) < 0) not_late = std::nextafter(not_late, Real(0));
  for (Real next; (next = std::nextafter(not_late, Real(2))) <= 1 && compare(t, exact(next)) >= 0;) not_late = next;
  return not_late;
}
template float rounded_down<float>(const RootTime&);
template double rounded_down<double>(const RootTime&);

Rational apart(const RootTime& t, const Rational& s) {
  // rest - sqrt(square) - s, as a sum of numbers of one sign.
  const Rational rest = t.rest - s, root = root_below(t.square);
  if (rest <= 0) return root - rest;
  return abs(Rational(rest * rest - t.square)) / (rest + root);
}

double rounded_apart(const RootTime& t, const Rational& s, const Rational& about, const Rational& squared_length) {
  // 2^-240 exceeds the error of `about`, and of four roundings: where both bounds round alike, so does the exact
  // number.
  MPFR_DECL_INIT(size, 256);
  MPFR_DECL_INIT(other, 256);
  mpfr_set_q(size, about.get_mpq_t(), MPFR_RNDN);
  mpfr_set_q(other, squared_length.get_mpq_t(), MPFR_RNDN);
  mpfr_sqrt(other, other, MPFR_RNDN);
  mpfr_mul(size, size, other, MPFR_RNDN);
  const auto rounded = [&](long sign) {
    mpfr_mul_2si(other, size, -240, MPFR_RNDN);
    mpfr_mul_si(other, other, sign, MPFR_RNDN);
    mpfr_add(other, size, other, MPFR_RNDN);
    return std::min(mpfr_get_d(other, MPFR_RNDN), std::numeric_limits<double>::max());
  };
  const double low = rounded(-1), high = rounded(1);
  if (low == high) return low;
  // Neighbours, between which their middle decides, by squares: (rest - root)^2 = rest^2 + square - 2 rest root.
  const Rational middle = (exact(low) + exact(high)) / 2, rest = t.rest - s;
  const int order =
      sign_at({0, t.square}, squared_length * (rest * rest + t.square) - middle * middle, 2 * rest * squared_length);
  return order < 0 ? low : order > 0 ? high : nearest<double>(middle);
}

Tunnel tunnel_of(const Rational& r, const Rational& least_squared) {
  if (least_squared == 0) return {round_up(Rational(1)), true};
  const Rational rr = r * r, size = (rr - least_squared) / (r * (r + root_below(least_squared)));
  if (sgn(size) <= 0) return {{}, false};
  // The tunnel is at least F exactly where least <= (1 - F) r.
  const auto reaches = [&](const Decimal6& depth) {
    const Rational rest = 1 - exact(depth);
    return sgn(rest) >= 0 && least_squared <= rest * rest * rr;
  };
  Decimal6 depth = round_up(size);
  while (!reaches(depth)) depth = previous(depth);
  while (reaches(next(depth))) depth = next(depth);
  return {depth, false};
}

Rational squared_scene(const GivenMotion& q) {
  const Rational r(q.r);
  Rational scene = r * r;
  const auto rational = [](double x) { return Rational(x); };
  const portable::Vec3<Rational> d = q.displacement<Rational>(rational),
                                 p{Rational(q.p.x), Rational(q.p.y), Rational(q.p.z)};
  for (const auto& v : {q.a, q.b, q.c}) {
    const portable::Vec3<Rational> start = portable::Vec3<Rational>{Rational(v.x), Rational(v.y), Rational(v.z)} - p,
                                   end = start - d;
    scene = std::max({scene, portable::dot(start, start), portable::dot(end, end)});
  }
  return scene;
}

namespace {

using RationalVector = portable::Vec3<Rational>;
using portable::dot;

// (from + along t) factor + offset.
RootNumber at_time(const RootTime& t, const Rational& from, const Rational& along, const Rational& factor,
                   const Rational& offset) {
  const Rational slope = along * factor;
  return {offset + from * factor + slope * t.rest, slope * slope * t.square, -sgn(slope)};
}

}  // namespace

ExactPlace exact_place(const GivenMotion& q, const MotionPieces& motion, const FirstContact& contact) {
  const MovingPoint point = nearest_point(motion, *contact.features.begin());
  const MovingPoint away{RationalVector{} - point.from, rationals(motion.d) - point.along};
  const RootTime& t = contact.time;
  const Rational unit = times_power(1, motion.exponent);
  ExactPlace found{{at_time(t, point.from.x, point.along.x, unit, exact(q.p.x)),
                    at_time(t, point.from.y, point.along.y, unit, exact(q.p.y)),
                    at_time(t, point.from.z, point.along.z, unit, exact(q.p.z))},
                   {}};
  if (sgn(t.square) == 0) {
    const RationalVector v = away.from + away.along * t.rest;
    const Rational square = dot(v, v);
    for (const Rational* x : {&v.x, &v.y, &v.z}) {
      if (sgn(square) != 0) found.normal.push_back(share_of_length(*x, square));
    }
    return found;
  }
  // A time that is a root is that of the distance r, which is then not 0.
  const Rational share = unit / exact(q.r);
  for (const auto& [from, along] : {std::pair(&away.from.x, &away.along.x), std::pair(&away.from.y, &away.along.y),
                                    std::pair(&away.from.z, &away.along.z)})
    found.normal.push_back(at_time(t, *from, *along, share, 0));
  return found;
}

std::vector<ExactFact> exact_facts(const GivenMotion& q) {
  const Rational least = least_distance(q).squared, r = exact(q.r), scene = squared_scene(q);
  const bool is_apart = least > r * r;
  std::vector<ExactFact> facts = {
      is_apart ? length_fact("distance", {-r, least}) : length_fact("penetration", {r, least, -1}),
      depth_fact({least, r, sgn(scene) == 0 ? Rational(1) : scene}),
      length_fact("centre_distance", {0, least}),
  };
  const MotionPieces motion(q);
  const std::optional<FirstContact> contact = first_contact(q, motion);
  if (!contact) return facts;
  const ExactPlace place = exact_place(q, motion, *contact);
  facts.push_back({"time", {RootNumber{contact->time.rest, contact->time.square, -1}}});
  ExactFact features{"features"}, point{"nearest_point"}, normal{"normal"};
  for (const Feature feature : contact->features) features.names.push_back(feature_names[feature]);
  point.numbers.assign(place.point.begin(), place.point.end());
  normal.numbers.assign(place.normal.begin(), place.normal.end());
  if (normal.numbers.empty()) normal.note = "not one: the centre is on the triangle";
  for (ExactFact* const fact : {&features, &point, &normal}) facts.push_back(std::move(*fact));
  return facts;
}

}  // namespace axiscert::moving_sphere
