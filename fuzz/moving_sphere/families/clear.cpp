// Motions whose contact is clear: that reach each region of a triangle first, or stop short of it; that start in
// contact, leave, or stand still; that pass at a distance, along the face and edges, far and hardly at all.
#include "fuzz/moving_sphere/families/parts.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/regions.h"

namespace axiscert::moving_sphere {
namespace {

using regions::clear_part, regions::Corners, regions::Point;

// A triangle of any shape, the numbers rounded; every other one with an obtuse corner.
template <class Real>
struct Target {
  explicit Target(Stream& random) {
    const double share = random.unit<double>(), cosine = random.coin() ? -0.05 - 0.85 * share : 0.9 * share;
    const double first = 0.5 + random.unit<double>(), second = 0.5 + random.unit<double>();
    const Corners corners = regions::with_corner(random, cosine, first, second);
    const auto vertex = random.below(3);
    for (std::size_t k = 0; k < 3; ++k) {
      rounded[k] = regions::rounded_place<Real>(corners[(k + vertex) % 3]);
      exact[k] = regions::wide(rounded[k]);
    }
  }
  MovingQuery<Real> query(const Point& p, const Point& d, double r) const {
    return {
        rounded[0],          rounded[1], rounded[2], regions::rounded_place<Real>(p), regions::rounded_place<Real>(d),
        static_cast<Real>(r)};
  }
  std::array<Vec3<Real>, 3> rounded;
  Corners exact;
};

// From 2^-k to twice that, k from `least` on in turn.
double radius_in_turn(Stream& random, std::uint64_t round, int least, std::uint64_t powers) {
  return std::ldexp(1 + random.unit<double>(), -least - 1 - static_cast<int>(round % powers));
}

// A way by which the distance from the region becomes less.
Point towards(Stream& random, const Point& away) {
  const Point aside = regions::at_right_angles(random, away);
  const double inwards = 0.25 + random.unit<double>(), sideways = random.unit<double>();
  return regions::at_unit_length(aside * sideways - away * inwards);
}

// The sphere reaches the region first, at P + t D with t 1 / (1 + m), or stops short of it, as far as 1 / t = 1 - m.
template <class Real>
MovingQuery<Real> to_region(Stream& random, std::size_t region, double r, bool is_reached) {
  const Target<Real> target(random);
  const regions::Aim aim = regions::aim(random, target.exact, region, r * 2);
  const Point way = towards(random, aim.away), at_contact = aim.at + aim.away * r;
  const double reach = 0.25 + random.unit<double>(), part = clear_part(random);
  return target.query(at_contact - way * reach, way * (reach * (is_reached ? 1 + part : 1 - part)), r);
}

// Every fourth round is in another unit of length, 2^-16 to 2^12 (binary64: 2^-100 to 2^100).
template <class Real>
Numbers<Real> reaching(Stream& random, std::uint64_t position) {
  constexpr int least = sizeof(Real) == 4 ? -16 : -100, greatest = sizeof(Real) == 4 ? 12 : 100;
  const std::uint64_t round = position / regions::count, unit = round / 4;
  const bool is_scaled = round / 2 % 4 == 3;
  const double r = radius_in_turn(random, round / 8, 1, is_scaled ? 3 : 10);
  const MovingQuery<Real> q = to_region<Real>(random, position % regions::count, r, round % 2 == 0);
  const int power = is_scaled ? least + static_cast<int>(unit % (greatest - least + 1)) : 0;
  return times_power<Real>(Numbers<Real>(q), power);
}

// In turn: a start in contact that leaves, one apart that leaves, either without a motion, and one in contact that goes
// on inwards.
template <class Real>
Numbers<Real> starting(Stream& random, std::uint64_t position) {
  const std::uint64_t kind = position / regions::count % 5;
  const bool in_contact = kind == 0 || kind == 2 || kind == 4;
  const Target<Real> target(random);
  const double r = radius_in_turn(random, position / regions::count / 5, 1, 8), part = clear_part(random),
               reach = 0.25 + random.unit<double>();
  const regions::Aim aim = regions::aim(random, target.exact, position % regions::count, r * 2);
  const Point inwards = towards(random, aim.away);
  const double step = kind == 2 || kind == 3 ? 0 : kind == 4 ? reach : -reach;
  return target.query(aim.at + aim.away * (r * (in_contact ? 1 - part : 1 + part)), inwards * step, r);
}

// Past the region, at right angles to the way from it: nearest at a part of the motion from a hundredth to all but one.
template <class Real>
Numbers<Real> passing(Stream& random, const Target<Real>& target, const regions::Aim& aim, const Point& way, double far,
                      double r, bool in_contact) {
  const double part = clear_part(random), passed = 0.01 + 0.98 * random.unit<double>();
  const Point nearest = aim.at + aim.away * (r * (in_contact ? 1 - part : 1 + part));
  return target.query(nearest - way * (far * passed), way * far, r);
}

// Along an edge beside it, or in the plane of the face above it: along an edge or anyhow. Every fourth round exactly,
// but for roundings; the others by 2^-3 to 2^-8 (binary64: 2^-20) in turn, away from where the sphere starts or towards
// where it ends.
template <class Real>
Numbers<Real> alongside(Stream& random, std::uint64_t position) {
  constexpr std::size_t faces = 5, edge_regions = 9;  // the face is as often as half of the regions of edges
  const std::size_t which = position % (edge_regions + faces);
  const std::uint64_t round = position / (edge_regions + faces);
  const Target<Real> target(random);
  const bool is_face = which >= edge_regions, in_contact = round % 2 == 0;
  const double r = radius_in_turn(random, round / 2, 1, 8);
  const regions::Aim aim = regions::aim(random, target.exact, is_face ? regions::count - 1 : 3 + which, r * 2);
  const std::size_t edge = which % 3;
  const Point side = regions::at_unit_length(target.exact[shapes::next(edge)] - target.exact[edge]);
  const Point along = is_face && random.coin() ? regions::at_right_angles(random, aim.away) : side;
  const bool is_back = random.coin();
  const Point way = is_back ? along * -1.0 : along;
  const double far = 0.5 + 3 * random.unit<double>();
  if (round / 2 % 4 == 3) return passing<Real>(random, target, aim, way, far, r, in_contact);
  constexpr std::uint64_t angles = sizeof(Real) == 4 ? 6 : 18;
  const double angle = std::ldexp(1.0, -3 - static_cast<int>(round / 8 % angles)), part = clear_part(random);
  const bool leaves = random.coin();
  const Point tilted = regions::at_unit_length(way + aim.away * (leaves ? angle : -angle)),
              nearest = aim.at + aim.away * (r * (in_contact ? 1 - part : 1 + part));
  return target.query(leaves ? nearest : nearest - tilted * far, tilted * far, r);
}

// 2^4 to 2^20 radii in turn.
template <class Real>
Numbers<Real> passing_far(Stream& random, std::uint64_t position) {
  const std::uint64_t round = position / regions::count;
  const Target<Real> target(random);
  const double r = radius_in_turn(random, round / 34, 1, 4);
  const double far = std::ldexp(r, 4 + static_cast<int>(round / 2 % 17));
  const regions::Aim aim = regions::aim(random, target.exact, position % regions::count, r * 2);
  return passing<Real>(random, target, aim, regions::at_right_angles(random, aim.away), far, r, round % 2 == 0);
}

// By 2^-27 to 2^-10 radii in turn, any way: where the sphere is decides.
template <class Real>
Numbers<Real> hardly_moving(Stream& random, std::uint64_t position) {
  const std::uint64_t round = position / regions::count;
  const bool in_contact = round % 2 == 0;
  const Target<Real> target(random);
  const double r = radius_in_turn(random, round / 36, 1, 6), part = clear_part(random);
  const regions::Aim aim = regions::aim(random, target.exact, position % regions::count, r * 2);
  Point way = shapes::in_cube<double>(random);
  if (dot(way, way) < 0x1p-16) way = {1, 0, 0};
  const double step = std::ldexp(r, -27 + static_cast<int>(round / 2 % 18));
  return target.query(aim.at + aim.away * (r * (in_contact ? 1 - part : 1 + part)), regions::at_unit_length(way) * step,
                      r);
}

// A sphere of 2^-6 to 2^-13 at the ends of edges: in turn within a 20th to a 1000th of the end on either edge, and
// about the vertex itself; every other two it passes, the others it arrives at or stops short of.
template <class Real>
Numbers<Real> at_edge_ends(Stream& random, std::uint64_t position) {
  constexpr std::size_t ends = 9;
  const std::uint64_t round = position / ends;
  const std::size_t which = position % ends, region = which < 3 ? which : 3 + which;
  const double r = radius_in_turn(random, round / 4, 6, 7), near = std::ldexp(0.05, -static_cast<int>(random.below(7)));
  const Target<Real> target(random);
  const regions::Aim aim = regions::aim(random, target.exact, region, near);
  if (round / 2 % 2 == 0) {
    const Point across = regions::at_right_angles(random, aim.away);
    const double far = 0.25 + random.unit<double>();
    return passing<Real>(random, target, aim, across, far, r, round % 2 == 0);
  }
  const Point way = towards(random, aim.away);
  const double reach = 4 * r * (1 + random.unit<double>()), part = clear_part(random);
  return target.query(aim.at + aim.away * r - way * reach, way * (reach * (round % 2 == 0 ? 1 + part : 1 - part)), r);
}

}  // namespace

extern const Family moving_sphere_reach_family = moving_family<reaching<float>, reaching<double>>(
    "moving-sphere/reach", situation::everyday,
    "clear: arrives first at each region of a triangle in turn, or stops 1 to 30 % short of it");
extern const Family moving_sphere_starts_family = moving_family<starting<float>, starting<double>>(
    "moving-sphere/starts", situation::starts,
    "clear: starts in contact or apart at each region in turn, and leaves, stands still or goes on");
extern const Family moving_sphere_alongside_family = moving_family<alongside<float>, alongside<double>>(
    "moving-sphere/alongside", situation::parallel,
    "clear: along an edge or the face, exactly or by an angle of 2^-3 to 2^-8 (2^-20), nearer than r or farther");
extern const Family moving_sphere_far_past_family = moving_family<passing_far<float>, passing_far<double>>(
    "moving-sphere/far_past", situation::far, "clear: 2^4 to 2^20 radii past each region of a triangle in turn");
extern const Family moving_sphere_moves_family = moving_family<hardly_moving<float>, hardly_moving<double>>(
    "moving-sphere/moves", situation::no_motion,
    "clear: by 2^-27 to 2^-10 radii at each region of a triangle in turn; where the sphere is decides");
extern const Family moving_sphere_edge_ends_family = moving_family<at_edge_ends<float>, at_edge_ends<double>>(
    "moving-sphere/edge_ends", situation::everyday,
    "clear: small spheres at vertices and within 0.1 to 5 % of the ends of edges");

}  // namespace axiscert::moving_sphere
