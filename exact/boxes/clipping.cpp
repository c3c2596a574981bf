#include "exact/boxes/clipping.h"

#include <algorithm>
#include <optional>

namespace axiscert::boxes {
namespace {

using portable::cross, portable::dot;

Point plus(const Point& p, const Point& d, const Rational& t) { return {p.x + d.x * t, p.y + d.y * t, p.z + d.z * t}; }

// The three slabs of a box: |normal[k].(x - centre)| <= width[k].
struct Slabs {
  Point centre;
  std::array<Point, 3> normal;
  std::array<Rational, 3> width;

  explicit Slabs(const ExactBox& box) : centre(box.centre) {
    const Rational volume = abs(determinant(box));
    for (std::size_t k = 0; k < 3; ++k) {
      normal[k] = cross(box.axis[next(k)], box.axis[last(k)]);
      width[k] = box.half[k] * volume;
    }
  }

  // Whether p is in the relative interior: strictly inside each slab that has a width.
  bool is_inside(const Point& p) const {
    const Point from = p - centre;
    for (std::size_t k = 0; k < 3; ++k) {
      const Rational at = abs(dot(normal[k], from));
      if (width[k] == 0 ? at != 0 : at >= width[k]) return false;
    }
    return true;
  }
};

// A range of t; nothing where first > last.
struct Range {
  Rational first = -1, last = 1;
};

// Leaves of the range the t for which start + t slope <= most; false where none is left.
bool keep_below(Range& range, const Rational& start, const Rational& slope, const Rational& most) {
  if (slope == 0) return start <= most;
  const Rational t = (most - start) / slope;
  if (slope > 0 && t < range.last) range.last = t;
  if (slope < 0 && t > range.first) range.first = t;
  return range.first <= range.last;
}

// The part of the edge `middle` + t `along`, |t| <= 1, in the slabs.
std::optional<Range> clipped(const Point& middle, const Point& along, const Slabs& slabs) {
  Range range;
  const Point from = middle - slabs.centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational start = dot(slabs.normal[k], from), slope = dot(slabs.normal[k], along);
    if (!keep_below(range, start, slope, slabs.width[k])) return std::nullopt;
    if (!keep_below(range, Rational(-start), Rational(-slope), slabs.width[k])) return std::nullopt;
  }
  return range;
}

// A triangle: its plane, and the side of each edge on which it is.
struct TriangleBody {
  const std::array<Point, 3>& corner;
  Point normal;

  explicit TriangleBody(const std::array<Point, 3>& corners)
      : corner(corners), normal(cross(corners[1] - corners[0], corners[2] - corners[0])) {}
  bool has_area() const { return dot(normal, normal) != 0; }
  // Positive on the inner side of edge j.
  Rational side(std::size_t j, const Point& p) const {
    return dot(cross(normal, corner[next(j)] - corner[j]), p - corner[j]);
  }

  // Whether p, a point of the triangle, is in its relative interior: not on an edge; without an area, not an end of the
  // segment that it then is. A point is its own interior.
  bool is_inside(const Point& p) const {
    if (has_area()) return side(0, p) > 0 && side(1, p) > 0 && side(2, p) > 0;
    for (std::size_t j = 0; j < 3; ++j) {
      const Point along = corner[next(j)] - corner[j];
      if (dot(along, along) == 0) continue;
      std::array<Rational, 3> at;
      for (std::size_t k = 0; k < 3; ++k) at[k] = dot(along, corner[k]);
      const auto [least, greatest] = std::minmax_element(at.begin(), at.end());
      const Rational here = dot(along, p);
      return *least < here && here < *greatest;
    }
    return true;
  }
};

// The part of the edge in the triangle; nothing where that has no area, since its edges then are all of it.
std::optional<Range> clipped(const Point& middle, const Point& along, const TriangleBody& triangle) {
  if (!triangle.has_area()) return std::nullopt;
  Range range;
  const Rational start = dot(triangle.normal, middle - triangle.corner[0]), slope = dot(triangle.normal, along);
  if (!keep_below(range, start, slope, 0)) return std::nullopt;
  if (!keep_below(range, Rational(-start), Rational(-slope), 0)) return std::nullopt;
  for (std::size_t j = 0; j < 3; ++j) {
    const Point inwards = cross(triangle.normal, triangle.corner[next(j)] - triangle.corner[j]);
    if (!keep_below(range, Rational(-triangle.side(j, middle)), Rational(-dot(inwards, along)), 0)) return std::nullopt;
  }
  return range;
}

// The ends of the parts of `box`'s twelve edges that are in the other body.
template <class Body>
void add_ends(const ExactBox& box, const Body& body, std::vector<Point>& ends) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point along = box.axis[k] * box.half[k];
    const Point one = box.axis[next(k)] * box.half[next(k)], other = box.axis[last(k)] * box.half[last(k)];
    for (const int sign_of_one : {-1, 1}) {
      for (const int sign_of_other : {-1, 1}) {
        const Point middle = plus(plus(box.centre, one, sign_of_one), other, sign_of_other);
        if (const auto range = clipped(middle, along, body)) {
          ends.push_back(plus(middle, along, range->first));
          ends.push_back(plus(middle, along, range->last));
        }
      }
    }
  }
}

void add_edges(const ExactBox& box, std::vector<Point>& edges) {
  for (std::size_t k = 0; k < 3; ++k) {
    if (box.half[k] != 0) edges.push_back(box.axis[k]);
  }
}

// Whether these edges span the space.
bool spans(const std::vector<Point>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Point normal = cross(edges[i], edges[j]);
      for (std::size_t k = j + 1; k < edges.size(); ++k) {
        if (dot(normal, edges[k]) != 0) return true;
      }
    }
  }
  return false;
}

Point mean_of(const std::vector<Point>& points) {
  Point mean{0, 0, 0};
  for (const Point& p : points) mean = mean + p;
  return mean / Rational(static_cast<unsigned long>(points.size()));
}

}  // namespace

Common common_of(const ExactPair& q) {
  const Slabs of_a(q.a), of_b(q.b);
  std::vector<Point> ends;
  add_ends(q.a, of_b, ends);
  add_ends(q.b, of_a, ends);
  if (ends.empty()) return {false, false};
  const Point mean = mean_of(ends);
  std::vector<Point> edges;
  add_edges(q.a, edges);
  add_edges(q.b, edges);
  return {true, of_a.is_inside(mean) && of_b.is_inside(mean) && spans(edges)};
}

Common common_of(const ExactBoxAndTriangle& q) {
  const Slabs of_box(q.box);
  const TriangleBody triangle(q.corner);
  std::vector<Point> ends, edges;
  add_ends(q.box, triangle, ends);
  const Rational half(1, 2);
  for (std::size_t j = 0; j < 3; ++j) {
    const Point along = (q.corner[next(j)] - q.corner[j]) * half, middle = q.corner[j] + along;
    edges.push_back(along);
    if (const auto range = clipped(middle, along, of_box)) {
      ends.push_back(plus(middle, along, range->first));
      ends.push_back(plus(middle, along, range->last));
    }
  }
  if (ends.empty()) return {false, false};
  const Point mean = mean_of(ends);
  add_edges(q.box, edges);
  return {true, of_box.is_inside(mean) && triangle.is_inside(mean) && spans(edges)};
}

}  // namespace axiscert::boxes
