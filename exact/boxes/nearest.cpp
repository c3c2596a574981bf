#include "exact/boxes/nearest.h"

#include <algorithm>
#include <optional>

#include "exact/numbers/binary_fraction.h"
#include "kernel/base/error.h"

namespace axiscert::boxes {
namespace {

using portable::cross, portable::dot;
using Number = BinaryNumber;
using Vector = BinaryPoint;

// A vertex of A minus a vertex of B.
struct Corner {
  std::size_t a, b;
  Vector at;
};

// Corners, and the point of their simplex that is nearest to 0, strictly inside it: the sum of weight times corner over
// `total`, every weight positive.
struct Simplex {
  std::vector<Corner> corners;
  std::vector<Number> weights;
  Number total;
  Vector nearest;  // times `total`
};

// The weights, up to a common factor, that make the point nearest to 0 on the line, plane or space through the corners.
// Their sum is 0 where the corners are dependent.
std::vector<Number> affine_weights(const std::vector<Corner>& corners) {
  switch (corners.size()) {
    case 1:
      return {Number(1)};
    case 2: {
      const Vector &p = corners[0].at, &q = corners[1].at, along = q - p;
      return {dot(q, along), -dot(p, along)};
    }
    case 3: {
      const Vector &p = corners[0].at, &q = corners[1].at, &r = corners[2].at;
      const Vector normal = cross(Vector(q - p), Vector(r - p));
      return {dot(normal, cross(q, r)), dot(normal, cross(r, p)), dot(normal, cross(p, q))};
    }
    default: {
      const Vector &p = corners[0].at, &q = corners[1].at, &r = corners[2].at, &s = corners[3].at;
      const Vector rs = cross(r, s), pq = cross(p, q);
      std::vector<Number> weights = {dot(q, rs), -dot(p, rs), dot(s, pq), -dot(r, pq)};
      if ((weights[0] + weights[1] + weights[2] + weights[3]).sign() < 0) {
        for (Number& w : weights) w = -w;
      }
      return weights;
    }
  }
}

// Empty where the nearest point of the corners' affine hull is not strictly inside their simplex.
std::optional<Simplex> simplex_of(std::vector<Corner> corners) {
  Simplex found{std::move(corners), {}, {}, {}};
  found.weights = affine_weights(found.corners);
  const auto is_positive = [](const Number& w) { return w.sign() > 0; };
  if (!std::all_of(found.weights.begin(), found.weights.end(), is_positive)) return std::nullopt;
  for (std::size_t i = 0; i < found.weights.size(); ++i) {
    found.total = found.total + found.weights[i];
    found.nearest = found.nearest + found.corners[i].at * found.weights[i];
  }
  return found;
}

// Whether `corner` is no nearer to 0 than the simplex's nearest point, along the direction to that. `least` is the
// square of that, times the square of the total.
bool is_beyond(const Simplex& simplex, const Number& least, const Vector& corner) {
  return simplex.total * dot(simplex.nearest, corner) >= least;
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
    const Number least = dot(found->nearest, found->nearest);
    for (std::size_t i = 0; i < old && is_least; ++i) {
      is_least = (kept >> i & 1) != 0 || is_beyond(*found, least, before.corners[i].at);
    }
    if (is_least) return *std::move(found);
  }
  throw HarnessFault("nearest_points: no subset of a simplex has its nearest point");
}

// The vertex that is least along the direction, or along its opposite.
std::size_t least_along(const Vector& direction, const BinaryHull& hull, bool opposite) {
  std::size_t best = 0;
  std::optional<Number> least;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    Number here = dot(direction, hull[i]);
    if (least && (opposite ? here <= *least : here >= *least)) continue;
    least = std::move(here);
    best = i;
  }
  return best;
}

Vector combined(const BinaryHull& hull, const std::vector<Number>& weights) {
  Vector sum;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    if (weights[i].sign() != 0) sum = sum + hull[i] * weights[i];
  }
  return sum;
}

// The points times `scale`, a common denominator.
BinaryHull in_integers(const Hull& hull, const mpz_class& scale) {
  BinaryHull points;
  const auto times = [&](const Rational& x) {
    return Number(mpz_class(x.get_num() * (scale / x.get_den())).get_mpz_t());
  };
  for (const Point& p : hull) points.push_back({times(p.x), times(p.y), times(p.z)});
  return points;
}

}  // namespace

NearestPoints nearest_points(const BinaryHull& a, const BinaryHull& b) {
  const auto corner = [&](std::size_t i, std::size_t j) { return Corner{i, j, a[i] - b[j]}; };
  Simplex simplex = *simplex_of({corner(0, 0)});
  for (;;) {
    const Corner ahead = corner(least_along(simplex.nearest, a, false), least_along(simplex.nearest, b, true));
    if (is_beyond(simplex, dot(simplex.nearest, simplex.nearest), ahead.at)) break;
    simplex = nearer(simplex, ahead);
  }
  NearestPoints found{std::vector<Number>(a.size()), std::vector<Number>(b.size()), simplex.total, simplex.nearest};
  for (std::size_t i = 0; i < simplex.corners.size(); ++i) {
    Number &of_a = found.weights_a[simplex.corners[i].a], &of_b = found.weights_b[simplex.corners[i].b];
    of_a = of_a + simplex.weights[i];
    of_b = of_b + simplex.weights[i];
  }
  if (const std::string reason = refutation_text(found, a, b); !reason.empty()) {
    throw HarnessFault("nearest_points: its result does not prove the distance: " + reason);
  }
  return found;
}

std::string refutation_text(const NearestPoints& found, const BinaryHull& a, const BinaryHull& b) {
  if (found.weights_a.size() != a.size() || found.weights_b.size() != b.size())
    return "there is not one weight a vertex";
  if (found.total.sign() <= 0) return "the total is not positive";
  for (const std::vector<Number>* weights : {&found.weights_a, &found.weights_b}) {
    Number sum;
    for (const Number& w : *weights) {
      if (w.sign() < 0) return "a weight is negative";
      sum = sum + w;
    }
    if (!(sum == found.total)) return "the weights of a hull do not sum to the total";
  }
  const Vector at_a = combined(a, found.weights_a), at_b = combined(b, found.weights_b), &apart = found.apart;
  const Vector between = at_a - at_b;
  if (!(between.x == apart.x && between.y == apart.y && between.z == apart.z)) return "the points are not `apart`";
  const Number from = dot(apart, at_a), to = dot(apart, at_b);
  const auto along = [&](const Vector& p) { return found.total * dot(apart, p); };
  if (std::any_of(a.begin(), a.end(), [&](const Vector& p) { return along(p) < from; })) {
    return "a vertex of A is nearer along `apart`";
  }
  if (std::any_of(b.begin(), b.end(), [&](const Vector& p) { return along(p) > to; })) {
    return "a vertex of B is nearer along `apart`";
  }
  return "";
}

namespace {

struct InIntegers {
  mpz_class scale = 1;
  NearestPoints nearest;
};
InIntegers nearest_in_integers(const Hull& a, const Hull& b) {
  InIntegers found;
  for (const Hull* hull : {&a, &b}) {
    for (const Point& p : *hull) {
      for (const Rational* x : {&p.x, &p.y, &p.z}) {
        if (!mpz_divisible_p(found.scale.get_mpz_t(), x->get_den_mpz_t())) found.scale = lcm(found.scale, x->get_den());
      }
    }
  }
  found.nearest = nearest_points(in_integers(a, found.scale), in_integers(b, found.scale));
  return found;
}

Point weighted(const Hull& hull, const std::vector<Number>& weights, const Number& total) {
  Point sum;
  for (std::size_t i = 0; i < hull.size(); ++i) sum = sum + hull[i] * rational(weights[i]);
  return sum / rational(total);
}

// The vectors in the plane of this normal from a point of a hull, on its boundary there, to its corners in that plane.
std::vector<Point> edges_from(const Point& point, const Point& normal, const Hull& hull) {
  std::vector<Point> found;
  for (const Point& corner : hull) {
    const Point edge = corner - point;
    if (dot(edge, normal) == 0 && dot(edge, edge) != 0) found.push_back(edge);
  }
  return found;
}

// Whether a vector of the plane is a sum of these, each times a number that is not negative; two are enough.
bool is_in_cone(const Point& vector, const std::vector<Point>& edges, const Point& normal) {
  const auto turn = [&](const Point& u, const Point& v) { return Rational(dot(normal, cross(u, v))); };
  for (const Point& u : edges) {
    if (turn(u, vector) == 0 && dot(u, vector) > 0) return true;
    for (const Point& v : edges) {
      if (turn(u, v) > 0 && turn(u, vector) >= 0 && turn(vector, v) >= 0) return true;
    }
  }
  return false;
}

}  // namespace

Rational squared_distance(const Hull& a, const Hull& b) {
  const auto [scale, found] = nearest_in_integers(a, b);
  const Rational length = rational(found.total) * scale;
  return rational(dot(found.apart, found.apart)) / (length * length);
}

NearestPair nearest_pair(const Hull& a, const Hull& b) {
  const NearestPoints found = nearest_in_integers(a, b).nearest;
  return {weighted(a, found.weights_a, found.total), weighted(b, found.weights_b, found.total)};
}

// Other pairs are the pair moved along the plane within both hulls: there are some exactly where the cones of their
// edges at the two points have a vector in common, and then one has an edge of the other.
bool is_only_pair(const NearestPair& nearest, const Point& normal, const Hull& a, const Hull& b) {
  const std::vector<Point> of_a = edges_from(nearest.a, normal, a), of_b = edges_from(nearest.b, normal, b);
  const auto has_one_of = [&](const std::vector<Point>& cone, const std::vector<Point>& edges) {
    return std::any_of(edges.begin(), edges.end(), [&](const Point& edge) { return is_in_cone(edge, cone, normal); });
  };
  return !has_one_of(of_a, of_b) && !has_one_of(of_b, of_a);
}

}  // namespace axiscert::boxes
