// Scenes that one axis decides by a clear margin: two bodies apart along that axis alone, or as deep in contact along
// it as along no other. Places are proposed in doubles, from the query's own numbers; what a place is worth is the
// least margin over all axes.
#pragma once

#include <algorithm>
#include <vector>

#include "fuzz/boxes/parts.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/sphere_triangle/families/parts/lattice_bounds.h"
#include "kernel/boxes/thirteen.h"

namespace axiscert::boxes {

// Two convex bodies by their corners, A from the centre of its box and B from a point of its own, and the unit vectors
// of all axes, 0 where two edges are parallel.
struct ClearScene {
  std::vector<Arrow> a, b, axis;
  double size;  // of the larger body, from its own point
};
ClearScene scene_of(const BoxPair<double>& q);
ClearScene scene_of(const BoxAndTriangle<double>& q);

enum class Side { apart, in_contact };

// Where B's point is from A's centre, and by what length all axes agree: apart by so much along one, or in contact
// along all by so much or more. 0 where the axis decides nowhere.
struct ClearPlace {
  Arrow by;
  double margin;
};

// A place at random where `axis` decides. The margin is from a quarter to half of what the other axes leave, and at
// most `most`.
ClearPlace place_on_axis(Stream& random, const ClearScene& scene, std::size_t axis, Side side, double most);

// The greatest gap over all axes with B's point there: positive apart, negative in contact.
double gap_at(const ClearScene& scene, const Arrow& by);

// A wish for a scene, in parts of the size of its larger body.
struct ClearWish {
  std::size_t axis;
  Side side;
  double most = 0.25;    // the greatest margin
  double enough = 0.02;  // no further scene is drawn where the margin is as great
};

// A query, and the margin as a part of what is enough.
template <class Query>
struct Attempt {
  Query query;
  double worth;
};

// The first of so many attempts that is worth 1, or the best of them.
template <class Try>
auto best_of(Stream& random, int attempts, const Try& attempt) {
  auto best = attempt(random);
  for (int k = 1; k < attempts && best.worth < 1; ++k) {
    const auto next = attempt(random);
    if (next.worth > best.worth) best = next;
  }
  return best.query;
}

// A rotation for a scene that is drawn several times: its matrix in doubles, each entry rounded once; its quaternion
// between 1 and 4 long.
template <class Real>
void turn_quickly(OrientedBox<Real>& box, const Quaternion& q) {
  const OrientedBox<double> wide = with_matrix(TurnedBox<double>{{0, 0, 0}, {1, 1, 1}, q});
  for (std::size_t k = 0; k < 3; ++k) box.axis[k] = rounded_arrow<Real>(wide.axis[k]);
}
template <class Real>
void turn_quickly(TurnedBox<Real>& box, const Quaternion& q) {
  double most = 0;
  for (const double x : q) most = std::max(most, std::fabs(x));
  for (std::size_t k = 0; k < 4; ++k) box.q[k] = static_cast<Real>(std::ldexp(q[k], -std::ilogb(most)));
}

inline double worth_of(const ClearPlace& place, const ClearScene& scene, const ClearWish& wish) {
  return place.margin / (scene.size * std::min(wish.enough, wish.most / 2));
}

// B of two boxes put where the axis decides.
template <class Pair>
Attempt<Pair> placed_box(Stream& random, Pair q, const ClearWish& wish) {
  const ClearScene scene = scene_of(BoxPair<double>{box_in_doubles(q.a), box_in_doubles(q.b)});
  const ClearPlace place = place_on_axis(random, scene, wish.axis, wish.side, scene.size * wish.most);
  q.b.centre = rounded_arrow<RealOf<Pair>>(arrow_of(q.a.centre) + place.by);
  return {q, worth_of(place, scene, wish)};
}

// The wishes of a family over all its axes, round by round: twice apart and once in contact, by a clear margin; and
// either by 2^-7 to 2^-18 of the scene (binary64: 2^-42).
template <class Real>
ClearWish wish_in_turn(Stream& random, std::uint64_t round, std::size_t axis) {
  constexpr std::uint64_t powers = sizeof(Real) == 4 ? 12 : 36;
  if (round % 4 < 3) return {axis, round % 4 == 2 ? Side::in_contact : Side::apart};
  const double most = std::ldexp(1.0, -7 - static_cast<int>(round / 4 % powers));
  return {axis, random.coin() ? Side::in_contact : Side::apart, most, most};
}

// In another unit of length: every place and length times 2^exponent, and no axis or quaternion.
template <class Real>
Numbers<Real> with_lengths_times_power(Numbers<Real> numbers, const PredicateEntry& entry, int exponent) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (entry.columns[k].role != Role::direction) numbers[k] = std::ldexp(numbers[k], exponent);
  }
  return numbers;
}

// Every other two rounds of a family whose bodies differ by 2^k in size, as a power of two: the least unit of length in
// which forms of degree 8 stay within the range.
template <class Real>
int unit_in_turn(std::uint64_t round, int k) {
  // The shortest length times the longest, of which the fourth power has to be normal: with two bits to spare.
  constexpr int least = (std::numeric_limits<Real>::min_exponent + 11) / 4;
  return round / 2 % 2 == 0 ? 0 : (least + std::abs(k)) / 2;
}

// Places and lengths cut off to multiples of 2^-10, so that powers of two leave their digits alone. They are below 16.
template <class Real>
Numbers<Real> on_unit_grid(Numbers<Real> numbers, const PredicateEntry& entry) {
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (entry.columns[k].role == Role::direction) continue;
    numbers[k] = static_cast<Real>(static_cast<std::int64_t>(numbers[k] * Real(0x1p10))) * Real(0x1p-10);
  }
  return numbers;
}
// The powers of two times which no form of degree 6 in them over- or underflows.
template <class Real>
constexpr PowerRange unit_grid_range = {range_of_degree_6<Real>(16).least + 10, range_of_degree_6<Real>(16).greatest};

// The group of a family of clear scenes in other units of length, and the images that it consists of.
inline PowerRange unit_grid_range_in(Precision precision) {
  return precision == Precision::binary32 ? unit_grid_range<float> : unit_grid_range<double>;
}
constexpr ImageGroup unit_group_of(const Predicate& (*predicate)(), std::string_view family) {
  return {predicate,
          family,
          unit_images::count,
          [](std::size_t) {
            return std::array<std::uint8_t, 3>{0, 1, 2};
          },
          [](std::size_t) { return ImageKind::scale; },
          [](Precision precision, std::uint64_t base, std::size_t i) {
            return unit_images::exponent(unit_grid_range_in(precision), base, i);
          },
          unit_grid_range_in};
}

// `make` draws a base from its stream, as numbers of the entry.
template <class Entry, class Real, Numbers<Real> (*make)(Stream&, std::uint64_t)>
void fill_units_of(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  const PredicateEntry& entry = Entry::description().entries[Entry::entry];
  fill_groups(
      name, first, out, unit_images::count,
      [&](Stream& random, std::uint64_t base) { return on_unit_grid(make(random, base), entry); },
      [&](Stream&, const Numbers<Real>& q, std::uint64_t base, std::size_t i) {
        return with_lengths_times_power(q, entry, unit_images::exponent(unit_grid_range<Real>, base, i));
      });
}

template <class Entry, auto make32, auto make64>
constexpr Family family_of_units(std::string_view name, const Situation& situation, std::string_view purpose) {
  return {.predicate = Entry::description,
          .name = name,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = false,
          .binary32 = fill_units_of<Entry, float, make32>,
          .binary64 = fill_units_of<Entry, double, make64>,
          .situation = &situation,
          .entry = Entry::entry};
}

}  // namespace axiscert::boxes
