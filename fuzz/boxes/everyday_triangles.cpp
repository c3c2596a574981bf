// A box and a triangle of a game, in metres: crates and characters on a terrain and on large ramps, and the cells of a
// voxel grid at the walls, floors and ramps of a level. The box's farthest points in a direction lie on the triangle's,
// or as far from there as a solver leaves them: then the direction decides.
#include "fuzz/boxes/everyday.h"
#include "fuzz/boxes/triangles.h"

namespace axiscert::boxes {
namespace {

using Corners = std::array<Arrow, 3>;

constexpr Arrow upwards = {0, 1, 0};

// As an engine holds it in each entry. Those without a rotation leave it out.
template <class Real>
void put_body(CentredAndTriangle<Real>& q, const std::array<Real, 3>& half, const Quaternion&, const Arrow& centre) {
  q.centre = rounded_arrow<Real>(centre);
  q.half = half;
}
template <class Real>
void put_body(CornersAndTriangle<Real>& q, const std::array<Real, 3>& half, const Quaternion&, const Arrow& centre) {
  const Arrow wide = arrow_of(Vec3<Real>{half[0], half[1], half[2]});
  q.low = rounded_arrow<Real>(centre - wide);
  q.high = rounded_arrow<Real>(centre + wide);
}
template <class Query, class Real>
void put_body(Query& q, const std::array<Real, 3>& half, const Quaternion& turn, const Arrow& centre) {
  q.box.centre = rounded_arrow<Real>(centre);
  q.box.half = half;
  turn_in_floats(q.box, unit_quaternion<Real>(turn));
}

// The point of the triangle farthest along `direction`; of an edge or a face across it, any point.
Arrow farthest_of_triangle(Stream& random, const Corners& corner, const Arrow& direction) {
  constexpr double level = 0x1p-30;  // metres
  std::array<double, 3> at;
  for (std::size_t k = 0; k < 3; ++k) at[k] = dot(direction, corner[k]);
  const double most = std::max({at[0], at[1], at[2]});
  Arrow sum{0, 0, 0};
  double weights = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = 0x1p-5 + random.unit<double>();
    if (at[k] < most - level) continue;
    sum = sum + corner[k] * weight;
    weights += weight;
  }
  return sum / weights;
}

// In turn what meets: the triangle's face, a facet of the box, or an edge of each. The direction is to the side of the
// triangle's normal.
constexpr std::uint64_t contact_count = 3;
Arrow contact_direction(Stream& random, std::uint64_t turn, const OrientedBox<double>& box, const Corners& corner,
                        const Arrow& normal) {
  const auto edge = random.below(3), axis = random.below(3);
  const Arrow product = cross(box.axis[axis], corner[next(edge)] - corner[edge]);
  Arrow along = normal;
  if (turn % contact_count == 1) along = facet_normal(box, axis);
  if (turn % contact_count == 2 && dot(product, product) > 0x1p-20) along = product;
  const Arrow unit = scenes::at_unit_length(along);
  return dot(unit, normal) < 0 ? unit * -1.0 : unit;
}

// Where the box's centre is, so that its foot is `gap` beyond the triangle along `direction`.
Arrow centre_beyond(Stream& random, const OrientedBox<double>& box, const Corners& corner, const Arrow& direction,
                    double gap) {
  const Arrow foot = farthest_of_box(random, box, direction * -1.0),
              at = farthest_of_triangle(random, corner, direction);
  return at + (direction * gap - foot);
}

// The body on the triangle of corners about `origin`, of normal `up`. In turn it is upright, along the slope and yawed
// on it, the last two but for what a solver leaves.
template <class Query>
Query standing_on(Stream& random, std::uint64_t position, const Corners& corner, const Arrow& origin, const Arrow& up,
                  const Quaternion& along) {
  using Real = RealOf<Query>;
  Query q{};
  std::array<Real, 3> half;
  set_body(random, half);
  const Quaternion yaw = any_yaw(random), left = disturbance(random);
  const auto pose = random.below(3);
  const Quaternion on_it = product(pose == 1 ? along : product(along, yaw), left), turn = pose == 0 ? yaw : on_it;
  put_body(q, half, turn, {0, 0, 0});
  const OrientedBox<double> box = wide_query(q).box;
  const double gap = gap_in_turn(random, position);
  const Arrow direction = contact_direction(random, position / gap_count, box, corner, up);
  put_body(q, half, turn, origin + centre_beyond(random, box, corner, direction, gap));
  for (std::size_t k = 0; k < 3; ++k) q.corner[k] = rounded_arrow<Real>(origin + corner[k]);
  return q;
}

// One of the two triangles of a square of a height field, whose side is a power of two or any length.
struct Terrain {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    const double any = scenes::length(random, 0.25, 4, 4), relief = random.unit<double>() * 0.5;
    const bool is_power = random.coin(), is_other = random.coin(), is_second = random.coin();
    const double cell = is_power ? std::ldexp(1.0, std::ilogb(any)) : any;
    std::array<Arrow, 4> square = {{{0, 0, 0}, {cell, 0, 0}, {cell, 0, cell}, {0, 0, cell}}};
    for (Arrow& v : square) v.y = random.symmetric<double>() * (relief * cell);
    // Across one diagonal or the other, and the half on either side of it.
    const std::size_t first = is_other ? 1 : 0;
    const Corners corner = {square[first], square[is_second ? first + 1 : (first + 2) % 4],
                            square[is_second ? (first + 2) % 4 : (first + 3) % 4]};
    const Arrow normal = scenes::at_unit_length(cross(corner[1] - corner[0], corner[2] - corner[0]));
    const Arrow up = normal.y < 0 ? normal * -1.0 : normal;

    // A knot of the grid, within 8, 64 or 512 m of the origin in turn.
    const double reach = std::array<double, 3>{8, 64, 512}[position / (gap_count * contact_count) % 3];
    const auto knots = static_cast<std::int64_t>(reach / cell);
    const auto i = static_cast<double>(random.integer(-knots, knots)),
               j = static_cast<double>(random.integer(-knots, knots));
    const double height = random.symmetric<double>() * (reach / 8);
    // From upright to the slope.
    const Quaternion along = {1 + up.y, up.z, 0, -up.x};
    return standing_on<Query>(random, position, corner, {i * cell, height, j * cell}, up, along);
  }
};

// One of the two triangles of a rectangle of 10 to 50 m that rises by 5 to 45 degrees, every fourth time of a floor.
struct RampTriangle {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    const double x = 10 + 40 * random.unit<double>(), z = 10 + 40 * random.unit<double>();
    const Quaternion yaw = any_yaw(random);
    const auto slope = static_cast<double>(random.integer(90, 848));  // the tangent of half the angle times 2048
    const bool is_second = random.coin(), is_floor = random.below(4) == 0;
    const Quaternion frame = product(yaw, {2048, 0, 0, is_floor ? 0 : slope});
    const OrientedBox<double> axes = with_matrix(TurnedBox<double>{{0, 0, 0}, {1, 1, 1}, frame});
    const Arrow far_x = axes.axis[0] * x, far_z = axes.axis[2] * z;
    const Corners corner = {Arrow{0, 0, 0}, is_second ? far_x + far_z : far_x, is_second ? far_z : far_x + far_z};
    const Arrow origin = scenes::place(random, position / (gap_count * contact_count));
    return standing_on<Query>(random, position, corner, origin, axes.axis[1], frame);
  }
};

// Cell i, j, k of a grid that begins at the origin.
template <class Real>
void put_cell(CentredAndTriangle<Real>& q, const Vec3<Real>& cell, Real size) {
  const Real half(0.5);
  q.centre = Vec3<Real>{cell.x + half, cell.y + half, cell.z + half} * size;
  q.half = {size * half, size * half, size * half};
}
template <class Real>
void put_cell(CornersAndTriangle<Real>& q, const Vec3<Real>& cell, Real size) {
  q.low = cell * size;
  q.high = Vec3<Real>{cell.x + 1, cell.y + 1, cell.z + 1} * size;
}

// A cell of 0.1 to 0.5 m within 8, 64 or 512 m of the origin in turn, and half of a wall, a floor or a ramp, which is
// along the grid every other time.
struct LevelVoxel {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    constexpr std::array<double, 5> usual = {0.1, 0.125, 0.2, 0.25, 0.5};
    const std::uint64_t round = position / (gap_count * contact_count), piece = round % 3;
    const auto which = random.below(usual.size());
    const double share = random.unit<double>();
    const bool is_usual = random.coin();
    const Real size = static_cast<Real>(is_usual ? usual[which] : 0.1 + 0.4 * share);
    const auto reach =
        static_cast<std::int64_t>(std::array<double, 3>{8, 64, 512}[round / 3 % 3] / static_cast<double>(size));
    Query q{};
    const auto i = random.integer(-reach, reach - 1), j = random.integer(-reach, reach - 1);
    const auto k = random.integer(-reach, reach - 1);
    put_cell(q, Vec3<Real>{static_cast<Real>(i), static_cast<Real>(j), static_cast<Real>(k)}, size);
    const OrientedBox<double> box = wide_query(q).box;

    const Arrow u = level_direction(random), across = cross(u, upwards);
    const double rise = 0.08 + 0.92 * random.unit<double>(), height = 2 + 2 * random.unit<double>();
    const double length = scenes::length(random, 1, 6, 50), width = scenes::length(random, 1, 6, 50);
    const Arrow v = piece == 0 ? upwards : piece == 1 ? across : scenes::at_unit_length(across + upwards * rise);
    const Arrow far_u = u * length, far_v = v * (piece == 0 ? height : width);
    const bool is_second = random.coin(), is_behind = random.coin();
    const Corners corner = {Arrow{0, 0, 0}, is_second ? far_u + far_v : far_u, is_second ? far_v : far_u + far_v};
    const Arrow normal = cross(u, v);
    const double gap = gap_in_turn(random, position);
    const Arrow direction =
        contact_direction(random, position / gap_count, box, corner, is_behind ? normal * -1.0 : normal);
    const Arrow origin = box.centre - centre_beyond(random, box, corner, direction, gap);
    for (std::size_t n = 0; n < 3; ++n) q.corner[n] = rounded_arrow<Real>(origin + corner[n]);
    return q;
  }

 private:
  // Along an axis of the world every other time.
  static Arrow level_direction(Stream& random) {
    const bool is_aligned = random.coin(), is_other = random.coin();
    const double tangent = is_aligned ? 0 : random.symmetric<double>(), scale = 1 + tangent * tangent;
    const double cosine = (1 - tangent * tangent) / scale, sine = 2 * tangent / scale;
    return is_other ? Arrow{sine, 0, cosine} : Arrow{cosine, 0, sine};
  }
};

}  // namespace

extern const Family box_triangle_terrain_family = in_metres(triangle_family<Terrain, CentreEntry>(
    "box-triangle/terrain", box_triangle_situation::everyday,
    "metres: crates and characters on a height field's triangles of 0.25 to 4 m, half within 1 cm of touching"));
extern const Family box_triangle_ramp_family = in_metres(triangle_family<RampTriangle, CentreEntry>(
    "box-triangle/ramp", box_triangle_situation::everyday,
    "metres: crates and characters on triangles of 10 to 50 m of floors and ramps, half within 1 cm of touching"));
extern const Family box_triangle_level_voxel_family =
    in_metres(triangle_family<LevelVoxel, CentreEntry>("box-triangle/level_voxel", box_triangle_situation::everyday,
                                                       "metres: cells of 0.1 to 0.5 m at a level's walls, floors and "
                                                       "ramps, up to 512 m out, half within 1 cm of touching"));

extern const Family box_triangle_terrain_minmax_family = in_metres(triangle_family<Terrain, MinmaxEntry>(
    "box-triangle/terrain_minmax", box_triangle_situation::everyday, "terrain, the box by two corners"));
extern const Family box_triangle_ramp_minmax_family = in_metres(triangle_family<RampTriangle, MinmaxEntry>(
    "box-triangle/ramp_minmax", box_triangle_situation::everyday, "ramp, the box by two corners"));
extern const Family box_triangle_level_voxel_minmax_family = in_metres(triangle_family<LevelVoxel, MinmaxEntry>(
    "box-triangle/level_voxel_minmax", box_triangle_situation::everyday, "level_voxel, the box by two corners"));

extern const Family box_triangle_terrain_oriented_family = in_metres(triangle_family<Terrain, OrientedEntry>(
    "box-triangle/terrain_oriented", box_triangle_situation::everyday,
    "terrain, the box upright at any yaw, or turned with the slope but for what a solver leaves"));
extern const Family box_triangle_ramp_oriented_family = in_metres(triangle_family<RampTriangle, OrientedEntry>(
    "box-triangle/ramp_oriented", box_triangle_situation::everyday,
    "ramp, the box upright at any yaw, or turned with the slope but for what a solver leaves"));

extern const Family box_triangle_terrain_turned_family = in_metres(triangle_family<Terrain, TurnedEntry>(
    "box-triangle/terrain_turned", box_triangle_situation::everyday, "terrain_oriented, the box by a quaternion"));
extern const Family box_triangle_ramp_turned_family = in_metres(triangle_family<RampTriangle, TurnedEntry>(
    "box-triangle/ramp_turned", box_triangle_situation::everyday, "ramp_oriented, the box by a quaternion"));

}  // namespace axiscert::boxes
