#include "exact/moving_sphere/least_distance.h"

#include <algorithm>
#include <optional>

#include "exact/moving_sphere/pieces.h"

namespace axiscert::moving_sphere {
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
  return {scaled(*least, 2 * motion.exponent), crosses_the_face(motion)};
}

}  // namespace axiscert::moving_sphere
