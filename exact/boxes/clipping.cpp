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
      normal[k] = facet_normal(box, k);
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

// The part of the edge `middle` + t `along`, |t| <= 1, in the slabs.
std::optional<Range> clipped(const Point& middle, const Point& along, const Slabs& slabs) {
  Range range;
  const Point from = middle - slabs.centre;
  for (std::size_t k = 0; k < 3; ++k) {
    const Rational start = dot(slabs.normal[k], from), slope = dot(slabs.normal[k], along);
    if (slope == 0) {
      if (abs(start) > slabs.width[k]) return std::nullopt;
      continue;
    }
    Rational one = (slabs.width[k] - start) / slope, other = (-slabs.width[k] - start) / slope;
    if (one < other) std::swap(one, other);
    if (other > range.first) range.first = other;
    if (one < range.last) range.last = one;
    if (range.first > range.last) return std::nullopt;
  }
  return range;
}

// The ends of the parts of `box`'s twelve edges that are in the slabs.
void add_ends(const ExactBox& box, const Slabs& slabs, std::vector<Point>& ends) {
  for (std::size_t k = 0; k < 3; ++k) {
    const Point along = box.axis[k] * box.half[k];
    const Point one = box.axis[next(k)] * box.half[next(k)], other = box.axis[last(k)] * box.half[last(k)];
    for (const int sign_of_one : {-1, 1}) {
      for (const int sign_of_other : {-1, 1}) {
        const Point middle = plus(plus(box.centre, one, sign_of_one), other, sign_of_other);
        if (const auto range = clipped(middle, along, slabs)) {
          ends.push_back(plus(middle, along, range->first));
          ends.push_back(plus(middle, along, range->last));
        }
      }
    }
  }
}

// Whether the edges of both boxes together span the space.
bool spans(const ExactPair& q) {
  std::vector<Point> edges;
  for (const ExactBox* box : {&q.a, &q.b}) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (box->half[k] != 0) edges.push_back(box->axis[k]);
    }
  }
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

}  // namespace

Common common_of(const ExactPair& q) {
  const Slabs of_a(q.a), of_b(q.b);
  std::vector<Point> ends;
  add_ends(q.a, of_b, ends);
  add_ends(q.b, of_a, ends);
  if (ends.empty()) return {false, false};
  Point mean{0, 0, 0};
  for (const Point& end : ends) mean = mean + end;
  mean = mean / Rational(static_cast<unsigned long>(ends.size()));
  return {true, of_a.is_inside(mean) && of_b.is_inside(mean) && spans(q)};
}

}  // namespace axiscert::boxes
