// A box and a triangle that one axis decides, clearly: each of the thirteen in turn, in other units of length, of very
// different sizes, thin, and parallel or nearly so.
#include "fuzz/boxes/clear.h"
#include "fuzz/boxes/triangles.h"

namespace axiscert::boxes {
namespace {

constexpr int triangle_attempts = 24;

// The triangle, of the shape that it has, moved to where the axis decides.
template <class Query>
Attempt<Query> moved_triangle(Stream& random, Query q, const ClearWish& wish) {
  const BoxAndTriangle<double> wide = wide_query(q);
  const ClearScene scene = scene_of(wide);
  const ClearPlace place = place_on_axis(random, scene, wish.axis, wish.side, scene.size * wish.most);
  for (std::size_t k = 0; k < 3; ++k) {
    const Arrow at = wide.box.centre + (place.by + (wide.corner[k] - wide.corner[0]));
    q.corner[k] = rounded_arrow<RealOf<Query>>(at);
  }
  return {q, worth_of(place, scene, wish)};
}

// A half extent times a factor.
template <class Real>
void stretch(CentredAndTriangle<Real>& q, std::size_t k, Real factor) {
  q.half[k] *= factor;
}
template <class Real>
void stretch(BoxAndTriangle<Real>& q, std::size_t k, Real factor) {
  q.box.half[k] *= factor;
}
template <class Real>
void stretch(TurnedAndTriangle<Real>& q, std::size_t k, Real factor) {
  q.box.half[k] *= factor;
}
template <class Real>
void stretch(CornersAndTriangle<Real>& q, std::size_t k, Real factor) {
  const std::array<Real*, 3> low = {&q.low.x, &q.low.y, &q.low.z}, high = {&q.high.x, &q.high.y, &q.high.z};
  *high[k] = *low[k] + (*high[k] - *low[k]) * factor;
}

template <class Query>
void put_box_quickly(Stream& random, Query& q) {
  if constexpr (requires { q.box; }) {
    CentredAndTriangle<RealOf<Query>> given{};
    put_box(random, given);
    q.box.centre = given.centre;
    q.box.half = given.half;
    turn_quickly(q.box, random_turn(random));
  } else {
    put_box(random, q);
  }
}

template <class Query>
Query box_and_triangle(Stream& random) {
  using Real = RealOf<Query>;
  Query q{};
  put_box_quickly(random, q);
  for (Vec3<Real>& corner : q.corner) corner = point_in_cube<Real>(random) * Real(1.5);
  return q;
}

template <class Query>
Query decided_triangle(Stream& random, const ClearWish& wish) {
  return best_of(random, triangle_attempts,
                 [&](Stream& from) { return moved_triangle(from, box_and_triangle<Query>(from), wish); });
}

struct OneAxisOfThirteen {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    return decided_triangle<Query>(
        random, wish_in_turn<RealOf<Query>>(random, position / thirteen_count, position % thirteen_count));
  }
};

// The box or the triangle is 2^-1 to 2^-20 of its size, in turn. Every other query is decided by a part of the larger
// one where the axis allows it, the others by one of the smaller. Half of the rounds are tiny.
struct TriangleSpans {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    const std::uint64_t round = position / 40, axis = round % thirteen_count;
    const int power = 1 + static_cast<int>(position / 2 % 20);
    const auto smaller = std::ldexp(Real(1), -power);
    ClearWish wish{axis, round % 2 == 0 ? Side::apart : Side::in_contact};
    wish.enough = static_cast<double>(smaller) / 32;
    if (random.coin()) wish.most = static_cast<double>(smaller) / 2;
    Query q = best_of(random, triangle_attempts, [&](Stream& from) {
      Query made = box_and_triangle<Query>(from);
      for (std::size_t k = 0; k < 3; ++k) {
        if (position % 2 == 0) stretch(made, k, smaller);
        else made.corner[k] = made.corner[k] * smaller;
      }
      return moved_triangle(from, made, wish);
    });
    scale_query(q, unit_in_turn<Real>(round, power));
    return q;
  }
};

// In turn: a box without one half extent, with one of a 2^-10th, and a rod without one; a needle, whose two corners are
// 2^-1 to 2^-10 of its size apart, a sliver, whose corner is as near to the middle of an edge, and one 64 times as
// large.
struct ThinTriangles {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    const std::uint64_t kind = position % 6, round = position / 6;
    const Side side = round % 3 == 2 ? Side::in_contact : Side::apart;
    const Real thin = std::ldexp(Real(1), -1 - static_cast<int>(round % 10));
    return best_of(random, triangle_attempts, [&](Stream& from) {
      Query q = box_and_triangle<Query>(from);
      const auto which = from.below(3), axis = from.below(thirteen_count);
      Vec3<Real>&a = q.corner[which], &b = q.corner[next(which)], &c = q.corner[last(which)];
      const Vec3<Real> aside = c * thin;
      if (kind < 2) stretch(q, which, kind == 0 ? Real(0) : Real(0x1p-10));
      if (kind == 2) {
        stretch(q, which, Real(0));
        stretch(q, next(which), Real(0x1p-10));
      }
      if (kind == 3) c = a + aside;
      if (kind >= 4) c = (a + b) * Real(0.5) + aside;
      if (kind == 5) {
        for (Vec3<Real>& corner : q.corner) corner = corner * Real(64);
      }
      return moved_triangle(from, q, {axis, side, 0.25, kind == 5 ? 0.002 : 0.01});
    });
  }
};

// In turn an edge along an axis of the box, but for 2^-2 to 2^-19 of its length, and the plane along a facet, but for
// as much; every fourth of each exactly. Every other time the product of that edge and axis decides, or any axis.
struct AlignedTriangles {
  template <class Query>
  static Query make(Stream& random, std::uint64_t position) {
    using Real = RealOf<Query>;
    const std::uint64_t kind = position % 2, round = position / 2;
    const double tilt = round % 4 == 3 ? 0 : std::ldexp(1.0, -2 - static_cast<int>(round / 4 % 18));
    const Side side = round % 3 == 2 ? Side::in_contact : Side::apart;
    const bool by_product = round % 2 == 0 && kind == 0 && tilt != 0;
    return best_of(random, triangle_attempts, [&](Stream& from) {
      Query q = box_and_triangle<Query>(from);
      const BoxAndTriangle<double> wide = wide_query(q);
      const auto which = from.below(3), edge = from.below(3), any = from.below(thirteen_count);
      const Arrow along = wide.box.axis[which];
      // Edge `edge` along the axis, or all corners across it.
      std::array<Arrow, 3> corner = wide.corner;
      const auto across = [&](const Arrow& v, double part) { return v - along * (dot(v, along) * (1 - part)); };
      if (kind == 0) {
        const Arrow way = corner[next(edge)] - corner[edge];
        corner[next(edge)] = corner[edge] + along * (1 + 4 * from.unit<double>()) + way * tilt;
      } else {
        for (Arrow& v : corner) v = across(v, tilt);
      }
      for (std::size_t k = 0; k < 3; ++k) q.corner[k] = rounded_arrow<Real>(corner[k]);
      const ClearWish wish{by_product ? edge_axis(which, edge) : any, side, 0.25,
                           by_product ? std::min(0.02, tilt / 16) : 0.02};
      return moved_triangle(from, q, wish);
    });
  }
};

// A base of images in other units of length.
template <class Query>
Numbers<RealOf<Query>> unit_triangle(Stream& random, std::uint64_t base) {
  const Side side = base % 3 == 2 ? Side::in_contact : Side::apart;
  return numbers_of(decided_triangle<Query>(random, {base % thirteen_count, side}));
}
template <class Entry>
constexpr Family family_of_unit_triangles(std::string_view name, std::string_view purpose) {
  return family_of_units<Entry, unit_triangle<typename Entry::template Problem<float>>,
                         unit_triangle<typename Entry::template Problem<double>>>(name, box_triangle_situation::units,
                                                                                  purpose);
}

constexpr std::array<ImageGroup, 4> unit_groups_of_triangles = {
    unit_group_of(box_triangle_predicate, "box-triangle/units"),
    unit_group_of(box_triangle_predicate, "box-triangle/units_minmax"),
    unit_group_of(box_triangle_predicate, "box-triangle/units_oriented"),
    unit_group_of(box_triangle_predicate, "box-triangle/units_turned")};

}  // namespace

extern const Family box_triangle_one_axis_family = triangle_family<OneAxisOfThirteen, CentreEntry>(
    "box-triangle/one_axis", box_triangle_situation::everyday,
    "each of the thirteen axes in turn alone separates, or is least, clearly; every fourth round by 2^-7 or less");
extern const Family box_triangle_units_family = family_of_unit_triangles<CentreEntry>(
    "box-triangle/units", "clear boxes and triangles, and times seven powers of two, 2^-10 to 2^15 or 2^-160 to 2^164");
extern const Family box_triangle_spans_family = triangle_family<TriangleSpans, CentreEntry>(
    "box-triangle/spans", box_triangle_situation::sizes,
    "the box or the triangle is 2^-1 to 2^-20 of its size, half of the scenes tiny; each axis in turn decides, clearly",
    false, 2);
extern const Family box_triangle_thin_family = triangle_family<ThinTriangles, CentreEntry>(
    "box-triangle/thin", box_triangle_situation::thin,
    "boxes of thickness 0 or 2^-10, needles and slivers to 2^-10, up to 64 long; any axis decides");
extern const Family box_triangle_aligned_family = triangle_family<AlignedTriangles, CentreEntry>(
    "box-triangle/aligned", box_triangle_situation::parallel,
    "an edge or the plane parallel to the box, but for 2^-2 to 2^-19; their product or any axis decides");

extern const Family box_triangle_one_axis_minmax_family = triangle_family<OneAxisOfThirteen, MinmaxEntry>(
    "box-triangle/one_axis_minmax", box_triangle_situation::everyday, "one_axis, the box by two corners");
extern const Family box_triangle_units_minmax_family =
    family_of_unit_triangles<MinmaxEntry>("box-triangle/units_minmax", "units, the box by two corners");
extern const Family box_triangle_spans_minmax_family = triangle_family<TriangleSpans, MinmaxEntry>(
    "box-triangle/spans_minmax", box_triangle_situation::sizes, "spans, the box by two corners", false, 2);
extern const Family box_triangle_thin_minmax_family = triangle_family<ThinTriangles, MinmaxEntry>(
    "box-triangle/thin_minmax", box_triangle_situation::thin, "thin, the box by two corners");
extern const Family box_triangle_aligned_minmax_family = triangle_family<AlignedTriangles, MinmaxEntry>(
    "box-triangle/aligned_minmax", box_triangle_situation::parallel, "aligned, the box by two corners");

extern const Family box_triangle_one_axis_oriented_family = triangle_family<OneAxisOfThirteen, OrientedEntry>(
    "box-triangle/one_axis_oriented", box_triangle_situation::everyday,
    "one_axis, the box turned by any rotation, rounded");
extern const Family box_triangle_units_oriented_family = family_of_unit_triangles<OrientedEntry>(
    "box-triangle/units_oriented", "units, the box turned by any rotation, rounded");
extern const Family box_triangle_spans_oriented_family =
    triangle_family<TriangleSpans, OrientedEntry>("box-triangle/spans_oriented", box_triangle_situation::sizes,
                                                  "spans, the box turned by any rotation, rounded", false, 2);
extern const Family box_triangle_thin_oriented_family = triangle_family<ThinTriangles, OrientedEntry>(
    "box-triangle/thin_oriented", box_triangle_situation::thin, "thin, the box turned by any rotation, rounded");
extern const Family box_triangle_aligned_oriented_family =
    triangle_family<AlignedTriangles, OrientedEntry>("box-triangle/aligned_oriented", box_triangle_situation::parallel,
                                                     "aligned, the box turned by any rotation, rounded");

extern const Family box_triangle_one_axis_turned_family = triangle_family<OneAxisOfThirteen, TurnedEntry>(
    "box-triangle/one_axis_turned", box_triangle_situation::everyday, "one_axis, the box by a quaternion");
extern const Family box_triangle_units_turned_family =
    family_of_unit_triangles<TurnedEntry>("box-triangle/units_turned", "units, the box by a quaternion");
extern const Family box_triangle_spans_turned_family = triangle_family<TriangleSpans, TurnedEntry>(
    "box-triangle/spans_turned", box_triangle_situation::sizes, "spans, the box by a quaternion");
extern const Family box_triangle_thin_turned_family = triangle_family<ThinTriangles, TurnedEntry>(
    "box-triangle/thin_turned", box_triangle_situation::thin, "thin, the box by a quaternion");
extern const Family box_triangle_aligned_turned_family = triangle_family<AlignedTriangles, TurnedEntry>(
    "box-triangle/aligned_turned", box_triangle_situation::parallel, "aligned, the box by a quaternion");

}  // namespace axiscert::boxes

namespace axiscert {

std::span<const ImageGroup* const> box_triangle_image_groups() {
  static const ImageGroup* const all[] = {&boxes::unit_groups_of_triangles[0], &boxes::unit_groups_of_triangles[1],
                                          &boxes::unit_groups_of_triangles[2], &boxes::unit_groups_of_triangles[3]};
  return all;
}

}  // namespace axiscert
