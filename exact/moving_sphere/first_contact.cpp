#include "exact/moving_sphere/first_contact.h"

#include <algorithm>
#include <cmath>

#include "exact/moving_sphere/sizes.h"

namespace axiscert::moving_sphere {
namespace {

// r^2 in squares of the motion's unit.
Rational limit_of(const GivenMotion& q, const MotionPieces& motion) {
  const Rational r = scaled(exact(q.r), -motion.exponent);
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

}  // namespace axiscert::moving_sphere
