#include "fuzz/moving_sphere/capability_parts.h"

#include <algorithm>
#include <array>
#include <optional>
#include <vector>

#include "exact/moving_sphere/first_contact.h"
#include "fuzz/sphere_triangle/traits.h"
#include "kernel/base/enums.h"

namespace axiscert {
namespace moving_sphere {
namespace {

using Integer = mpz_class;
using portable::cross, portable::dot;

// For a motion without contact, nearest is meant where the centre comes nearest.
#define AXISCERT_MOTION_TRAITS(X)                                                    \
  X(vertex_a, "that meet or pass vertex a first", "regions")                         \
  X(vertex_b, "that meet or pass vertex b first", "regions")                         \
  X(vertex_c, "that meet or pass vertex c first", "regions")                         \
  X(edge_ab, "that meet or pass edge ab first", "regions")                           \
  X(edge_bc, "that meet or pass edge bc first", "regions")                           \
  X(edge_ca, "that meet or pass edge ca first", "regions")                           \
  X(face, "that meet or pass the face first", "regions")                             \
  X(vertex, "that meet or pass a vertex first", "regions")                           \
  X(edge, "that meet or pass an edge first", "regions")                              \
  X(obtuse_there, "with an obtuse corner there", "obtuse")                           \
  X(overlap, "that overlap at the start")                                            \
  X(clear, "that are clear at the start")                                            \
  X(leaving, "that begin to move away")                                              \
  X(still, "that do not move")                                                       \
  X(early, "with the contact in the first 5 %")                                      \
  X(earliest, "with the contact in the first 0.1 %")                                 \
  X(late, "with the contact in the last 5 %")                                        \
  X(beyond_end, "that come nearest at their end")                                    \
  X(before_start, "that come nearest at their start")                                \
  X(parallel, "parallel to the face, or still", "parallel")                          \
  X(nearly_parallel, "within 1 % of parallel to the face", "parallel")               \
  X(along_edge, "parallel to an edge", "parallel")                                   \
  X(nearly_along_edge, "within 1 % of parallel to an edge", "parallel")              \
  X(head_on, "within 1 % of head on to the face")                                    \
  X(from_front, "that move against the normal")                                      \
  X(from_behind, "that move along the normal")                                       \
  X(through, "through the triangle's plane")                                         \
  X(tiny_motion, "that move less than a thousandth of the radius")                   \
  X(short_motion, "that move less than the radius")                                  \
  X(long_motion, "that move a hundred times the longest edge")                       \
  X(on_triangle, "with the centre on the triangle at the start", "on_triangle")      \
  X(in_plane, "with the centre in the triangle's plane at the start", "on_triangle") \
  X(obtuse, "of an obtuse triangle", "obtuse")                                       \
  X(flat, "of a triangle without area", "flat")                                      \
  X(thin, "of a triangle less than a thousandth as high as long")                    \
  X(axis_plane, "of a triangle in a plane x, y or z = constant", "aligned")          \
  X(axis_edge, "of a triangle with an edge along an axis", "aligned")                \
  X(zero_radius, "of radius 0")                                                      \
  X(large_sphere, "with a radius above the longest edge")                            \
  X(small_sphere, "with a radius below a hundredth of the longest edge")             \
  X(small, "with all numbers below 1e-3")                                            \
  X(large, "with a number of 1e4 or more")                                           \
  X(far, "with the origin 64 times as far away as the scene is long")

enum class MotionTrait : std::uint8_t { AXISCERT_MOTION_TRAITS(AXISCERT_TRAIT_ENUMERATOR) };
constexpr Trait motion_traits[] = {AXISCERT_MOTION_TRAITS(AXISCERT_TRAIT_ROW)};
static_assert(std::size(motion_traits) <= most_traits);
static_assert(static_cast<int>(MotionTrait::face) == static_cast<int>(Feature::face));
MotionTrait of_feature(Feature feature) { return static_cast<MotionTrait>(index_of(feature)); }

// Where the centre comes nearest: the features, and the time, the first where there are several.
struct Nearest {
  FeatureSet features;
  Rational squared, time;
};

Nearest nearest_of(const MotionPieces& motion) {
  std::optional<Nearest> least;
  for (const Piece& piece : motion.pieces) {
    Rational t = piece.first;
    if (piece.a != 0) t = std::max(piece.first, std::min(piece.last, quotient(piece.b, piece.a)));
    const Rational squared = ((piece.a * t - 2 * piece.b) * t + piece.c) / piece.divisor;
    if (least && squared > least->squared) continue;
    if (!least || squared < least->squared) least = Nearest{{}, squared, t};
    least->features.insert(piece.feature);
  }
  return *least;
}

TraitSet traits_of(const GivenMotion& q, const std::vector<double>& numbers) {
  using enum MotionTrait;
  const MotionPieces motion(q);
  const ExactTriangle triangle({q.a, q.b, q.c});
  TraitBits<MotionTrait> found;

  const Nearest nearest = nearest_of(motion);
  const std::optional<FirstContact> contact = first_contact(q, motion);
  const FeatureSet features = contact ? contact->features : nearest.features;
  for (const Feature feature : features) {
    found.put(of_feature(feature));
    found.put(vertex, feature <= Feature::vertex_c);
    found.put(edge, feature >= Feature::edge_ab && feature <= Feature::edge_ca);
    found.put(obtuse_there, feature <= Feature::vertex_c && triangle.is_obtuse_at(index_of(feature)));
  }
  found.put(overlap, contact && contact->start == Start::overlap);
  found.put(clear, !contact || contact->start == Start::clear);
  if (contact && contact->start == Start::clear) {
    found.put(early, compare(contact->time, Rational(1, 20)) < 0);
    found.put(earliest, compare(contact->time, Rational(1, 1000)) < 0);
    found.put(late, compare(contact->time, Rational(19, 20)) > 0);
  }
  const Integer moved = dot(motion.d, motion.d), normal = dot(motion.normal, motion.normal);
  found.put(still, moved == 0);
  found.put(parallel, normal != 0 && dot(motion.d, motion.normal) == 0);
  found.put(leaving, sgn(motion.pieces.front().b) < 0);
  if (moved != 0) {
    found.put(beyond_end, nearest.time == 1);
    found.put(before_start, nearest.time == 0);
    const Integer along = dot(motion.d, motion.normal), squared = along * along;
    if (normal != 0) {
      found.put(nearly_parallel, along != 0 && squared * 10000 < moved * normal);
      found.put(head_on, squared * 10000 > moved * normal * 9999);
      found.put(from_front, along < 0);
      found.put(from_behind, along > 0);
      const Integer offset = dot(motion.vertex[0], motion.normal);  // at time t: offset - t along
      found.put(through, sgn(offset) * sgn(Integer(offset - along)) < 0);
    }
    for (std::size_t i = 0; i < 3; ++i) {
      const auto side = motion.vertex[(i + 1) % 3] - motion.vertex[i];
      const auto product = cross(motion.d, side);
      const Integer length = dot(side, side), sine = dot(product, product);
      if (length == 0) continue;
      found.put(along_edge, sine == 0);
      found.put(nearly_along_edge, sine != 0 && sine * 10000 < moved * length);
    }
  }
  const Integer offset = dot(motion.vertex[0], motion.normal);
  found.put(on_triangle, motion.pieces.front().c == 0);
  found.put(in_plane, normal != 0 && offset == 0 && motion.pieces.front().c != 0);

  found.put(obtuse, triangle.is_obtuse());
  found.put(flat, triangle.is_flat());
  found.put(thin, triangle.is_thin());
  found.put(axis_plane, triangle.is_in_plane_of_axes());
  found.put(axis_edge, triangle.has_edge_along_axis());

  const BinaryNumber r(q.r), squared_radius = r * r;
  const ExactVector d = q.displacement<BinaryNumber>([](double x) { return BinaryNumber(x); });
  const BinaryNumber way = squared_length(d);
  found.put(tiny_motion, moved != 0 && way * BinaryNumber(1e6) < squared_radius);
  found.put(short_motion, moved != 0 && way < squared_radius);
  found.put(long_motion, way > triangle.squared_longest() * BinaryNumber(1e4));
  found.put(zero_radius, q.r == 0);
  found.put(large_sphere, squared_radius > triangle.squared_longest());
  found.put(small_sphere, squared_radius * BinaryNumber(1e4) < triangle.squared_longest());
  found.put(small, is_small_scene(numbers));
  found.put(large, is_large_scene(numbers));
  const std::array points = {q.p, q.a, q.b, q.c};
  found.put(far, is_far_away(points, q.r));
  return found.bits();
}

TraitSet traits_of_numbers(const std::vector<double>& numbers, std::size_t entry) {
  const auto load = [&](std::size_t k) { return numbers[k]; };
  if (entry == MovingSphere::entry) return traits_of(MovingSphere::problem<double>(load), numbers);
  return traits_of(MovingEnds::problem<double>(load), numbers);
}

}  // namespace
}  // namespace moving_sphere

const Traits& moving_sphere_traits() {
  static constexpr Traits traits = {"motions", moving_sphere::motion_traits, moving_sphere::traits_of_numbers};
  return traits;
}

}  // namespace axiscert
