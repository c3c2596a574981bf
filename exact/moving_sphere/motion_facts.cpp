#include "exact/moving_sphere/motion_facts.h"

namespace axiscert::moving_sphere {
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
  const Rational unit = scaled(1, motion.exponent);
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
