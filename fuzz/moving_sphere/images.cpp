// A motion near tangency, and its images: in six vertex orders, in 48 permutations and reflections of the axes, with
// all signs changed, translated, turned round, in two parts, and going on. Every image is exact, so that no exact
// answer differs.
#include <algorithm>
#include <limits>

#include "fuzz/moving_sphere/parts.h"
#include "fuzz/sphere_triangle/families/parts/images.h"
#include "fuzz/queries/image_groups.h"

namespace axiscert::moving_sphere {
namespace {

const PredicateEntry& columns() { return moving_sphere_predicate().entries[0]; }

// In turn: past a vertex, an edge and the face, the centre at X + n at s / k of its way, along the surface or against
// it; and small integers, zero areas among them. All are integers below 2^digits / 8, so that a translation by as much
// leaves them exact; D is a multiple of 4, so that its quarters are integers, and every other radius is moved by up to
// four ulps.
template <class Real>
Numbers<Real> base_motion(Stream& random, std::uint64_t base) {
  std::array<Whole, 3> vertex;
  Whole p, d;
  std::int64_t r = 0;
  if (base % 4 == 3) {
    for (Whole& v : vertex) v = shapes::integers(random, 3);
    p = shapes::integers(random, 3);
    d = shapes::integers(random, 4) * 4;
    r = random.integer(0, 6);
  } else {
    const TouchedTriangle t = touched(random, static_cast<FeatureKind>(base % 4));
    const std::int64_t k = random.integer(1, 4), s = random.integer(0, k);
    const Whole step = (base / 4 % 2 == 0 ? across(random, t.normal) : against(random, t.normal)) * 4;
    vertex = t.vertex;
    p = t.at + t.normal - step * s;
    d = step * k;
    r = t.r;
  }
  std::int64_t greatest = r;
  for (const Whole& v : {vertex[0], vertex[1], vertex[2], p, d}) {
    for (const std::int64_t x : {v.x, v.y, v.z}) greatest = std::max(greatest, x < 0 ? -x : x);
  }
  const std::int64_t limit = std::int64_t{1} << (std::numeric_limits<Real>::digits - 3),
                     most = std::max<std::int64_t>(limit / std::max<std::int64_t>(greatest, 1) / 2 - 1, 0),
                     factor = 2 * random.integer(0, most) + 1;
  const auto real = [&](const Whole& v) {
    const Whole w = v * factor;
    return Vec3<Real>{static_cast<Real>(w.x), static_cast<Real>(w.y), static_cast<Real>(w.z)};
  };
  MovingQuery<Real> q{real(vertex[0]), real(vertex[1]), real(vertex[2]),
                      real(p),         real(d),         static_cast<Real>(r * factor)};
  const int ulps = static_cast<int>(random.integer(-4, 4));
  if (base / 8 % 2 == 1) q.r = step_radius(q.r, ulps);
  if (q.r < Real(0.5)) q.r = 0;  // up to four ulps from 0
  return q;
}

template <class Real>
MovingQuery<Real> named(const Numbers<Real>& v) {
  return MovingSphere::problem<Real>([&](std::size_t k) { return v[k]; });
}

template <class Real>
Numbers<Real> order_image(const Numbers<Real>& base, std::size_t i, Stream&) {
  return exact_images::with_order(base, symmetries()[48 * i].vertices);
}
template <class Real>
Numbers<Real> axes_image(const Numbers<Real>& base, std::size_t i, Stream&) {
  return exact_images::with_axes(base, columns(), symmetries()[i].axes, symmetries()[i].signs);
}
template <class Real>
Numbers<Real> inverted_image(const Numbers<Real>& base, std::size_t i, Stream& random) {
  return axes_image(base, i == 0 ? 0 : 7, random);
}
template <class Real>
Numbers<Real> translated_image(const Numbers<Real>& base, std::size_t i, Stream& random) {
  constexpr std::int64_t most = std::int64_t{3} << (std::numeric_limits<Real>::digits - 3);
  Vec3<Real> by{0, 0, 0};
  for (std::size_t k = 0; k < i; ++k) {
    const std::int64_t x = random.integer(-most, most), y = random.integer(-most, most),
                       z = random.integer(-most, most);
    by = {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(z)};
  }
  return exact_images::moved(base, columns(), by);
}
template <class Real>
Numbers<Real> reversed_image(const Numbers<Real>& base, std::size_t i, Stream&) {
  if (i == 0) return base;
  MovingQuery<Real> q = named(base);
  q.p = q.p + q.d;
  q.d = {-q.d.x, -q.d.y, -q.d.z};
  return q;
}
// Two parts that meet after a half of the way, after a quarter and after three quarters.
template <class Real>
Numbers<Real> part_of_motion(const Numbers<Real>& base, std::size_t i, Stream&) {
  if (i == 0) return base;
  constexpr std::array<Real, 3> shares = {Real(0.5), Real(0.25), Real(0.75)};
  MovingQuery<Real> q = named(base);
  const Real share = shares[(i - 1) / 2];
  const Vec3<Real> first = q.d * share;
  if (i % 2 == 1) {
    q.d = first;
  } else {
    q.p = q.p + first;
    q.d = q.d * (1 - share);
  }
  return q;
}

// The motion, and twice, four and eight times as far.
template <class Real>
Numbers<Real> motion_going_on(const Numbers<Real>& base, std::size_t i, Stream&) {
  MovingQuery<Real> q = named(base);
  q.d = q.d * static_cast<Real>(1 << i);
  return q;
}

using Order = std::array<std::uint8_t, 3>;
Order as_in_base(std::size_t) { return {0, 1, 2}; }
template <ImageKind kind>
constexpr ImageKind every_image(std::size_t) {
  return kind;
}
ImageKind mirror_or_axes(std::size_t image) { return image < 8 ? ImageKind::mirror : ImageKind::axes; }

constexpr std::array<ImageGroup, 7> groups = {{
    {moving_sphere_predicate, "moving-sphere/orders", 6,
     [](std::size_t image) -> Order { return symmetries()[48 * image].vertices; }, every_image<ImageKind::order>},
    {moving_sphere_predicate, "moving-sphere/axes", 48, as_in_base, mirror_or_axes},
    {moving_sphere_predicate, "moving-sphere/inverted", 2, as_in_base, every_image<ImageKind::mirror>},
    {moving_sphere_predicate, "moving-sphere/translated", 4, as_in_base, every_image<ImageKind::translation>},
    {moving_sphere_predicate, "moving-sphere/reversed", 2, as_in_base, every_image<ImageKind::reversal>},
    {moving_sphere_predicate, "moving-sphere/split", 7, as_in_base, every_image<ImageKind::split>, nullptr, nullptr, 2},
    {moving_sphere_predicate, "moving-sphere/halved", 4, as_in_base, every_image<ImageKind::halving>},
}};

template <class Real, std::size_t group, Numbers<Real> (*make_image)(const Numbers<Real>&, std::size_t, Stream&)>
void fill(const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  fill_groups(
      name, first, out, groups[group].size, base_motion<Real>,
      [](Stream& after, const Numbers<Real>& q, std::uint64_t, std::size_t i) { return make_image(q, i, after); });
}

template <std::size_t group, auto image_binary32, auto image_binary64>
constexpr Family family_of_images(std::string_view purpose) {
  return {.predicate = moving_sphere_predicate,
          .name = groups[group].family,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = false,
          .binary32 = fill<float, group, image_binary32>,
          .binary64 = fill<double, group, image_binary64>,
          .situation = &situation::touching};
}

}  // namespace

extern const ImageGroup moving_sphere_units_group;  // of the file of its family

extern const Family moving_sphere_orders_family = family_of_images<0, order_image<float>, order_image<double>>(
    "a motion near tangency in the six orders of the vertices");
extern const Family moving_sphere_axes_family = family_of_images<1, axes_image<float>, axes_image<double>>(
    "a motion near tangency in the 48 permutations and reflections of the axes");
extern const Family moving_sphere_inverted_family = family_of_images<2, inverted_image<float>, inverted_image<double>>(
    "a motion near tangency, and with all signs changed but the radius's");
extern const Family moving_sphere_translated_family =
    family_of_images<3, translated_image<float>, translated_image<double>>(
        "a motion near tangency, and translated three times, exactly");
extern const Family moving_sphere_reversed_family = family_of_images<4, reversed_image<float>, reversed_image<double>>(
    "a motion near tangency, and from its end to its start");
extern const Family moving_sphere_split_family = family_of_images<5, part_of_motion<float>, part_of_motion<double>>(
    "a motion near tangency, and three times in two parts, of which one touches where the whole does");
extern const Family moving_sphere_halved_family = family_of_images<6, motion_going_on<float>, motion_going_on<double>>(
    "a motion near tangency, and two, four and eight times as far, which touches where its half does");

}  // namespace axiscert::moving_sphere

namespace axiscert {

std::span<const ImageGroup* const> moving_sphere_image_groups() {
  static const std::vector<const ImageGroup*> all = [] {
    std::vector<const ImageGroup*> pointers;
    for (const ImageGroup& group : moving_sphere::groups) pointers.push_back(&group);
    pointers.push_back(&moving_sphere::moving_sphere_units_group);
    return pointers;
  }();
  return all;
}

}  // namespace axiscert
