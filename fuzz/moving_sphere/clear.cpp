// Motions whose contact is clear: that reach each region of a triangle first, or stop short of it; that start in
// contact, leave, or stand still; that pass at a distance, along the face and edges, far and hardly at all.
#include <algorithm>

#include "fuzz/moving_sphere/parts.h"
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
    take({corners[vertex], corners[(1 + vertex) % 3], corners[(2 + vertex) % 3]});
  }
  explicit Target(const Corners& corners) { take(corners); }
  MovingQuery<Real> query(const Point& p, const Point& d, double r) const {
    return {
        rounded[0],          rounded[1], rounded[2], regions::rounded_place<Real>(p), regions::rounded_place<Real>(d),
        static_cast<Real>(r)};
  }
  std::array<Vec3<Real>, 3> rounded{};
  Corners exact{};

 private:
  void take(const Corners& corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      rounded[k] = regions::rounded_place<Real>(corners[k]);
      exact[k] = regions::wide(rounded[k]);
    }
  }
};

// Near to one of equal sides, where roundings are least.
template <class Real>
Target<Real> well_shaped(Stream& random) {
  const double cosine = 0.25 + 0.5 * random.unit<double>(), second = 1 + 0.25 * random.unit<double>();
  return Target<Real>(regions::with_corner(random, cosine, 1, second));
}

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

// The sphere reaches the region first, at P + t D with t 1 / (1 + part), or stops short of it, where 1 / t is 1 - part.
template <class Real>
MovingQuery<Real> to_region(Stream& random, const Target<Real>& target, std::size_t region, double r, double reach,
                            bool is_reached, double part) {
  const regions::Aim aim = regions::aim(random, target.exact, region, r * 2);
  const Point way = towards(random, aim.away), at_contact = aim.at + aim.away * r;
  return target.query(at_contact - way * reach, way * (reach * (is_reached ? 1 + part : 1 - part)), r);
}

// By 2^-7 to 2^-15 of the way (binary64: 2^-40): a large sphere that comes from afar.
template <class Real>
Numbers<Real> just_reaching(Stream& random, std::size_t region, std::uint64_t turn, bool is_reached) {
  constexpr std::uint64_t parts = sizeof(Real) == 4 ? 9 : 34;
  const Target<Real> target = well_shaped<Real>(random);
  const double r = 1 + random.unit<double>(), reach = 2 + 2 * random.unit<double>();
  return to_region<Real>(random, target, region, r, reach, is_reached,
                         std::ldexp(1.0, -7 - static_cast<int>(turn % parts)));
}

// Every fourth round is in another unit of length, 2^-16 to 2^12 (binary64: 2^-100 to 2^100); another fourth all but
// reaches the region, or just does.
template <class Real>
Numbers<Real> reaching(Stream& random, std::uint64_t position) {
  constexpr int least = sizeof(Real) == 4 ? -16 : -100, greatest = sizeof(Real) == 4 ? 12 : 100;
  const std::size_t region = position % regions::count;
  const std::uint64_t round = position / regions::count, unit = round / 4;
  const bool is_scaled = round / 2 % 4 == 3, is_reached = round % 2 == 0;
  if (round / 2 % 4 == 1) return just_reaching<Real>(random, region, round / 8, is_reached);
  const double r = radius_in_turn(random, round / 8, 1, is_scaled ? 3 : 10);
  const Target<Real> target(random);
  const double reach = 0.25 + random.unit<double>(), part = clear_part(random);
  const MovingQuery<Real> q = to_region<Real>(random, target, region, r, reach, is_reached, part);
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

// From above the plane to as far below it, through a point of the inside by that angle, a sphere of a 16th of the
// height; or short of it by a quarter of the height.
template <class Real>
Numbers<Real> through_face(Stream& random, double angle, bool in_contact) {
  const Target<Real> target = well_shaped<Real>(random);
  const regions::Aim aim = regions::aim(random, target.exact, regions::count - 1, 0);
  const Point middle = (target.exact[0] + target.exact[1] + target.exact[2]) / 3,
              way = regions::at_right_angles(random, aim.away), down = regions::at_unit_length(way - aim.away * angle);
  const double half = 0.25 + 0.15 * random.unit<double>();
  return target.query((aim.at + middle * 3) / 4 - down * half, down * (half * (in_contact ? 2 : 0.75)),
                      half * angle / 16);
}

// Along an edge beside it, or in the plane of the face above it: along an edge or anyhow. Every fourth round exactly,
// but for roundings; the others by 2^-3 to 2^-8 (binary64: 2^-20) in turn, away from where the sphere starts or towards
// where it ends. Half of those beside the face go through its inside instead.
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
  if (is_face && which % 2 == 0)
    return through_face<Real>(random, angle * (1 + 0.25 * random.unit<double>()), in_contact);
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

// By 2^-27 to 2^-10 radii in turn, any way: where the sphere is decides. Every third time by 2^-4 to 2^-9 radii towards
// the region, from half a step outside or from one and a half: the motion alone decides.
template <class Real>
Numbers<Real> hardly_moving(Stream& random, std::uint64_t position) {
  const std::uint64_t round = position / regions::count;
  const bool in_contact = round % 2 == 0, is_stepping = round / 2 % 3 == 2;
  const Target<Real> target(random);
  const double r = is_stepping ? radius_in_turn(random, round / 36, 1, 3) : radius_in_turn(random, round / 36, 1, 6),
               part = clear_part(random);
  const regions::Aim aim = regions::aim(random, target.exact, position % regions::count, r * 2);
  if (is_stepping) {
    const double step = std::ldexp(r, -4 - static_cast<int>(round / 6 % 6));
    return target.query(aim.at + aim.away * (r + step * (in_contact ? 0.5 : 1.5)), aim.away * -step, r);
  }
  Point way = shapes::in_cube<double>(random);
  if (dot(way, way) < 0x1p-16) way = {1, 0, 0};
  const double step = std::ldexp(r, -27 + static_cast<int>(round / 2 % 18));
  return target.query(aim.at + aim.away * (r * (in_contact ? 1 - part : 1 + part)), regions::at_unit_length(way) * step,
                      r);
}

// Through the plane of a triangle eight times as high as edge `edge` is long, within 2^-12 to 2^-10 of its height from
// that edge: a point, or a sphere of half of that.
template <class Real>
MovingQuery<Real> beside_edge(Stream& random, std::size_t edge, bool in_contact) {
  const double width = 0.25 + 0.25 * random.unit<double>(), height = 8 * width;
  const Corners made = regions::with_corner(random, 0, width, height);
  // The right angle is at either end of the edge.
  const bool is_turned = random.coin();
  Corners corners;
  corners[edge] = made[is_turned ? 1 : 0];
  corners[shapes::next(edge)] = made[is_turned ? 0 : 1];
  corners[(edge + 2) % 3] = made[2];
  const Target<Real> target(corners);
  const Corners& v = target.exact;
  const int halvings = random.coin() ? 11 : 12;
  const double share = 0.3 + 0.4 * random.unit<double>(),
               by = std::ldexp(height * (1 + random.unit<double>()), -halvings),
               half = width * (0.25 + 0.25 * random.unit<double>());
  const Point at = v[edge] + (v[shapes::next(edge)] - v[edge]) * share +
                   regions::outwards(v, edge) * (in_contact ? -by : by),
              normal = regions::at_unit_length(cross(v[1] - v[0], v[2] - v[0])),
              down = random.coin() ? normal : normal * -1.0;
  const Real r = !in_contact && random.coin() ? Real(0) : static_cast<Real>(by / 2);
  return target.query(at - down * half, down * (half * 2), r);
}

// Beside an edge near one of its ends, by as little that the end alone would not reach or would: the edge a little
// shorter or longer decides.
template <class Real>
MovingQuery<Real> beside_end(Stream& random, std::size_t region, double near, double r, bool in_contact) {
  const Target<Real> target(random);
  const regions::Aim aim = regions::aim(random, target.exact, region, near);
  const double far = 0.25 + random.unit<double>(), passed = 0.25 + 0.5 * random.unit<double>(),
               by = std::min(near * near / (8 * r), r / 4) * (0.25 + random.unit<double>());
  const Point across = regions::at_right_angles(random, aim.away),
              nearest = aim.at + aim.away * (in_contact ? r - by : r + by);
  return target.query(nearest - across * (far * passed), across * far, r);
}

// A sphere of 2^-3 to 2^-6 (binary64: 2^-13) at the ends of edges. In turn it passes, or arrives or stops short, at
// the vertex itself or within a 20th of the end on either edge (binary64: a 1000th); passes beside the end as closely
// as decides where the edge ends; and goes through the plane close beside an edge.
template <class Real>
Numbers<Real> at_edge_ends(Stream& random, std::uint64_t position) {
  constexpr std::size_t ends = 9;
  constexpr std::uint64_t octaves = sizeof(Real) == 4 ? 3 : 7;
  const std::uint64_t round = position / ends, kind = round / 2 % 4;
  const std::size_t which = position % ends, region = which < 3 ? which : 3 + which;
  const bool in_contact = round % 2 == 0;
  const double r = radius_in_turn(random, round / 8, 3, sizeof(Real) == 4 ? 4 : 11),
               near = std::ldexp(0.05, -static_cast<int>(random.below(octaves)));
  if (kind == 2) return beside_end<Real>(random, region, near, r, in_contact);
  if (kind == 3) return beside_edge<Real>(random, which % 3, in_contact);
  const Target<Real> target(random);
  const regions::Aim aim = regions::aim(random, target.exact, region, near);
  if (kind == 0) {
    const Point across = regions::at_right_angles(random, aim.away);
    const double far = 0.25 + random.unit<double>();
    return passing<Real>(random, target, aim, across, far, r, in_contact);
  }
  const Point way = towards(random, aim.away);
  const double reach = 4 * r * (1 + random.unit<double>()), part = clear_part(random);
  return target.query(aim.at + aim.away * r - way * reach, way * (reach * (in_contact ? 1 + part : 1 - part)), r);
}

}  // namespace

extern const Family moving_sphere_reach_family =
    moving_family<reaching<float>, reaching<double>, 2>("moving-sphere/reach", situation::everyday,
                                                        "clear: arrives first at each region of a triangle in turn, or "
                                                        "stops short of it, by 1 to 30 % or 2^-6 to 2^-15 (2^-40)");
extern const Family moving_sphere_starts_family = moving_family<starting<float>, starting<double>>(
    "moving-sphere/starts", situation::starts,
    "clear: starts in contact or apart at each region in turn, and leaves, stands still or goes on");
extern const Family moving_sphere_alongside_family = moving_family<alongside<float>, alongside<double>, 2>(
    "moving-sphere/alongside", situation::parallel,
    "clear: along an edge or the face, exactly or by an angle of 2^-3 to 2^-8 (2^-20), nearer than r or farther, and "
    "through the face");
extern const Family moving_sphere_far_past_family = moving_family<passing_far<float>, passing_far<double>>(
    "moving-sphere/far_past", situation::far, "clear: 2^4 to 2^20 radii past each region of a triangle in turn");
extern const Family moving_sphere_moves_family = moving_family<hardly_moving<float>, hardly_moving<double>, 2>(
    "moving-sphere/moves", situation::no_motion,
    "clear: by 2^-27 to 2^-10 radii at each region of a triangle in turn, and by 2^-4 to 2^-9 towards it");
extern const Family moving_sphere_edge_ends_family = moving_family<at_edge_ends<float>, at_edge_ends<double>, 2>(
    "moving-sphere/edge_ends", situation::everyday,
    "clear: spheres at vertices, within 5 % of the ends of edges and beyond them, and through the plane beside edges");

}  // namespace axiscert::moving_sphere
