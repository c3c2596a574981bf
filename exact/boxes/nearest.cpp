#include "exact/boxes/nearest.h"

#include <algorithm>
#include <optional>

#include "kernel/base/error.h"

namespace axiscert::boxes {
namespace {

using portable::cross, portable::dot;
using Integer = mpz_class;
using Whole = portable::Vec3<Integer>;

// A vertex of A minus a vertex of B.
struct Corner {
  std::size_t a, b;
  Whole at;
};

// Corners, and the point of their simplex that is nearest to 0, strictly inside it: the sum of weight times corner over
// `total`, every weight positive.
struct Simplex {
  std::vector<Corner> corners;
  std::vector<Integer> weights;
  Integer total;
  Whole nearest;  // times `total`
};

Integer determinant(const Whole& a, const Whole& b, const Whole& c) { return dot(a, cross(b, c)); }

// The weights, up to a common factor, that make the point nearest to 0 on the line, plane or space through the corners.
// Their sum is 0 where the corners are dependent.
std::vector<Integer> affine_weights(const std::vector<Corner>& corners) {
  switch (corners.size()) {
    case 1:
      return {1};
    case 2: {
      const Whole &p = corners[0].at, &q = corners[1].at, along = q - p;
      return {dot(q, along), -dot(p, along)};
    }
    case 3: {
      const Whole &p = corners[0].at, &q = corners[1].at, &r = corners[2].at;
      const Whole normal = cross(Whole(q - p), Whole(r - p));
      return {dot(normal, cross(q, r)), dot(normal, cross(r, p)), dot(normal, cross(p, q))};
    }
    default: {
      const Whole &p = corners[0].at, &q = corners[1].at, &r = corners[2].at, &s = corners[3].at;
      std::vector<Integer> weights = {determinant(q, r, s), -determinant(p, r, s), determinant(p, q, s),
                                      -determinant(p, q, r)};
      if (weights[0] + weights[1] + weights[2] + weights[3] < 0) {
        for (Integer& w : weights) w = -w;
      }
      return weights;
    }
  }
}

// Empty where the nearest point of the corners' affine hull is not strictly inside their simplex.
std::optional<Simplex> simplex_of(std::vector<Corner> corners) {
  Simplex found{std::move(corners), {}, 0, {0, 0, 0}};
  found.weights = affine_weights(found.corners);
  for (std::size_t i = 0; i < found.weights.size(); ++i) {
    if (found.weights[i] <= 0) return std::nullopt;
    found.total += found.weights[i];
    found.nearest = found.nearest + found.corners[i].at * found.weights[i];
  }
  return found;
}

// Whether `corner` is no nearer to 0 than the simplex's nearest point, along the direction to that.
bool is_beyond(const Simplex& simplex, const Whole& corner) {
  return simplex.total * dot(simplex.nearest, corner) >= dot(simplex.nearest, simplex.nearest);
}

// The nearest point of the simplex with one corner more, which comes nearer than without it: so the new corner is among
// those that it lies between, and of their subsets exactly one has its nearest point inside and all others beyond.
Simplex nearer(const Simplex& before, const Corner& corner) {
  const std::size_t old = before.corners.size();
  for (std::size_t kept = 0; kept < std::size_t{1} << old; ++kept) {
    std::vector<Corner> corners = {corner};
    for (std::size_t i = 0; i < old; ++i) {
      if (kept >> i & 1) corners.push_back(before.corners[i]);
    }
    std::optional<Simplex> found = simplex_of(std::move(corners));
    if (!found) continue;
    bool is_least = true;
    for (std::size_t i = 0; i < old; ++i) {
      is_least = is_least && ((kept >> i & 1) != 0 || is_beyond(*found, before.corners[i].at));
    }
    if (is_least) return *std::move(found);
  }
  throw HarnessFault("nearest_points: no subset of a simplex has its nearest point");
}

// The points times a common denominator.
std::vector<Whole> in_integers(const Hull& hull, const Integer& scale) {
  std::vector<Whole> points;
  const auto times = [&](const Rational& x) { return Integer(x.get_num() * (scale / x.get_den())); };
  for (const Point& p : hull) points.push_back({times(p.x), times(p.y), times(p.z)});
  return points;
}
Integer common_denominator(const Hull& a, const Hull& b) {
  Integer scale = 1;
  for (const Hull* hull : {&a, &b}) {
    for (const Point& p : *hull) {
      for (const Rational* x : {&p.x, &p.y, &p.z}) scale = lcm(scale, x->get_den());
    }
  }
  return scale;
}

std::size_t least_along(const Whole& direction, const std::vector<Whole>& points, int sign) {
  std::size_t best = 0;
  Integer least = sign * dot(direction, points[0]);
  for (std::size_t i = 1; i < points.size(); ++i) {
    Integer here = sign * dot(direction, points[i]);
    if (here >= least) continue;
    least = std::move(here);
    best = i;
  }
  return best;
}

Point combined(const Hull& hull, const std::vector<Rational>& weights) {
  Point sum{0, 0, 0};
  for (std::size_t i = 0; i < hull.size(); ++i) sum = sum + hull[i] * weights[i];
  return sum;
}

}  // namespace

NearestPoints nearest_points(const Hull& a, const Hull& b) {
  const Integer scale = common_denominator(a, b);
  const std::vector<Whole> of_a = in_integers(a, scale), of_b = in_integers(b, scale);
  const auto corner = [&](std::size_t i, std::size_t j) { return Corner{i, j, of_a[i] - of_b[j]}; };
  Simplex simplex = *simplex_of({corner(0, 0)});
  for (;;) {
    const Corner ahead = corner(least_along(simplex.nearest, of_a, 1), least_along(simplex.nearest, of_b, -1));
    if (is_beyond(simplex, ahead.at)) break;
    simplex = nearer(simplex, ahead);
  }
  NearestPoints found{std::vector<Rational>(a.size()), std::vector<Rational>(b.size()), {}};
  for (std::size_t i = 0; i < simplex.corners.size(); ++i) {
    Rational weight(simplex.weights[i], simplex.total);
    weight.canonicalize();
    found.weights_a[simplex.corners[i].a] += weight;
    found.weights_b[simplex.corners[i].b] += weight;
  }
  found.apart = combined(a, found.weights_a) - combined(b, found.weights_b);
  if (const std::string reason = refuted(found, a, b); !reason.empty()) {
    throw HarnessFault("nearest_points: its result does not prove the distance: " + reason);
  }
  return found;
}

std::string refuted(const NearestPoints& found, const Hull& a, const Hull& b) {
  if (found.weights_a.size() != a.size() || found.weights_b.size() != b.size())
    return "there is not one weight a vertex";
  for (const std::vector<Rational>* weights : {&found.weights_a, &found.weights_b}) {
    Rational sum;
    for (const Rational& w : *weights) {
      if (w < 0) return "a weight is negative";
      sum += w;
    }
    if (sum != 1) return "the weights of a hull do not sum to 1";
  }
  const Point at_a = combined(a, found.weights_a), at_b = combined(b, found.weights_b), &apart = found.apart;
  const Point between = at_a - at_b;
  if (between.x != apart.x || between.y != apart.y || between.z != apart.z) return "the points are not `apart`";
  const Rational from = dot(apart, at_a), to = dot(apart, at_b);
  if (std::any_of(a.begin(), a.end(), [&](const Point& p) { return dot(apart, p) < from; })) {
    return "a vertex of A is nearer along `apart`";
  }
  if (std::any_of(b.begin(), b.end(), [&](const Point& p) { return dot(apart, p) > to; })) {
    return "a vertex of B is nearer along `apart`";
  }
  return "";
}

}  // namespace axiscert::boxes
