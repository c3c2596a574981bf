#include "exact/boxes/clipping.h"

#include <algorithm>
#include <optional>
#include <vector>

#include "exact/boxes/scaled.h"

namespace axiscert::boxes {
namespace {

using Number = DyadicNumber;
using Vector = Vec3<Number>;
using Box = OrientedBox<Number>;

const Number zero(0.0), one(1.0);

// The number over / under; `under` is positive.
struct Quotient {
  Number over = zero, under = one;
};
bool is_less(const Quotient& s, const Quotient& t) { return t.over * s.under > s.over * t.under; }

// A range of t; nothing where first > last.
struct Range {
  Quotient first{zero - one, one}, last{one, one};
};

// Leaves of the range, which is in [-1, 1], the t for which start + t slope <= most; false where none is left.
bool keep_below(Range& range, const Number& start, const Number& slope, const Number& most) {
  const Number rest = most - start, size = magnitude(slope);
  if (rest >= size) return true;
  if (zero - size > rest) return false;
  if (slope > zero) {
    Quotient t{rest, slope};
    if (is_less(t, range.last)) range.last = std::move(t);
  } else {
    Quotient t{zero - rest, size};
    if (is_less(range.first, t)) range.first = std::move(t);
  }
  return !is_less(range.last, range.first);
}

// `middle` + t `along`, |t| <= 1.
struct Edge {
  Vector middle, along;
};
// The value at t, times t.under, of a linear function that is `start` at the middle and grows by `slope` along the
// edge.
Number at(const Quotient& t, const Number& start, const Number& slope) { return start * t.under + slope * t.over; }

// The three slabs of a box: |normal[k].(x - centre)| <= width[k].
class Slabs {
 public:
  explicit Slabs(const Box& box) : centre_(box.centre) {
    const Number volume = magnitude(determinant(box));
    for (std::size_t k = 0; k < 3; ++k) {
      normal_[k] = cross(box.axis[next(k)], box.axis[last(k)]);
      width_[k] = box.half[k] * volume;
      // A slab without a width has no inside: all of it is as far in as can be.
      is_off_[k] = {!(width_[k] > zero), !(width_[k] > zero)};
    }
  }

  // The part of the edge in the slabs.
  std::optional<Range> clipped(const Edge& edge) const {
    Range range;
    const Vector from = edge.middle - centre_;
    for (std::size_t k = 0; k < 3; ++k) {
      const Number start = dot(normal_[k], from), slope = dot(normal_[k], edge.along);
      if (!keep_below(range, start, slope, width_[k])) return std::nullopt;
      if (!keep_below(range, zero - start, zero - slope, width_[k])) return std::nullopt;
    }
    return range;
  }

  // Takes note of a point of the box: that it is off some of the bounding planes.
  void note(const Edge& edge, const Quotient& t) {
    const Vector from = edge.middle - centre_;
    for (std::size_t k = 0; k < 3; ++k) {
      auto& [below, above] = is_off_[k];
      if (below && above) continue;
      const Number here = at(t, dot(normal_[k], from), dot(normal_[k], edge.along)), limit = width_[k] * t.under;
      below = below || limit > here;
      above = above || here > zero - limit;
    }
  }
  // Whether the mean of the points noted, one or more, is in the relative interior: strictly inside each slab that has
  // a width.
  bool mean_is_inside() const {
    return std::all_of(is_off_.begin(), is_off_.end(), [](const auto& off) { return off[0] && off[1]; });
  }

 private:
  Vector centre_;
  std::array<Vector, 3> normal_;
  std::array<Number, 3> width_;
  std::array<std::array<bool, 2>, 3> is_off_;  // the upper and the lower plane of each
};

// A triangle: its plane, and the side of each edge on which it is.
class TriangleBody {
 public:
  explicit TriangleBody(const std::array<Vector, 3>& corner)
      : corner_(corner), normal_(cross(corner[1] - corner[0], corner[2] - corner[0])) {
    has_area_ = dot(normal_, normal_) > zero;
    for (std::size_t j = 0; j < 3; ++j) {
      const Vector along = corner[next(j)] - corner[j];
      inwards_[j] = cross(normal_, along);
      if (!along_ && dot(along, along) > zero) along_ = along;
    }
    if (has_area_ || !along_) return;
    for (std::size_t k = 0; k < 3; ++k) {
      const Number here = dot(*along_, corner[k]);
      if (k == 0 || least_ > here) least_ = here;
      if (k == 0 || here > greatest_) greatest_ = here;
    }
  }

  // The part of the edge in the triangle; nothing where that has no area, since its edges then are all of it.
  std::optional<Range> clipped(const Edge& edge) const {
    if (!has_area_) return std::nullopt;
    Range range;
    const Number start = dot(normal_, edge.middle - corner_[0]), slope = dot(normal_, edge.along);
    if (!keep_below(range, start, slope, zero)) return std::nullopt;
    if (!keep_below(range, zero - start, zero - slope, zero)) return std::nullopt;
    for (std::size_t j = 0; j < 3; ++j) {
      const Number outside = dot(inwards_[j], corner_[j] - edge.middle);
      if (!keep_below(range, outside, zero - dot(inwards_[j], edge.along), zero)) return std::nullopt;
    }
    return range;
  }

  // Takes note of a point of the triangle: that it is off some of the edges, or without an area off an end of the
  // segment that it then is.
  void note(const Edge& edge, const Quotient& t) {
    if (has_area_) {
      for (std::size_t j = 0; j < 3; ++j) {
        if (is_off_[j]) continue;
        is_off_[j] = at(t, dot(inwards_[j], edge.middle - corner_[j]), dot(inwards_[j], edge.along)) > zero;
      }
    } else if (along_) {
      const Number here = at(t, dot(*along_, edge.middle), dot(*along_, edge.along));
      is_off_[0] = is_off_[0] || here > least_ * t.under;
      is_off_[1] = is_off_[1] || greatest_ * t.under > here;
    }
  }
  // Whether the mean of the points noted is in the relative interior. A point is its own interior.
  bool mean_is_inside() const {
    if (has_area_) return is_off_[0] && is_off_[1] && is_off_[2];
    return !along_ || (is_off_[0] && is_off_[1]);
  }

 private:
  const std::array<Vector, 3>& corner_;
  Vector normal_;
  std::array<Vector, 3> inwards_;  // at right angles to each edge, in the plane; 0 without an area
  bool has_area_;
  std::optional<Vector> along_;  // the first edge that is not 0
  Number least_, greatest_;      // of the corners along it, without an area
  std::array<bool, 3> is_off_{};
};

std::vector<Edge> edges_of(const Box& box) {
  std::vector<Edge> edges;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vector along = box.axis[k] * box.half[k];
    const Vector side = box.axis[next(k)] * box.half[next(k)], other = box.axis[last(k)] * box.half[last(k)];
    for (const Vector& middle : {box.centre - side, box.centre + side}) {
      edges.push_back({middle - other, along});
      edges.push_back({middle + other, along});
    }
  }
  return edges;
}
std::vector<Edge> edges_of(const std::array<Vector, 3>& corner) {
  std::vector<Edge> edges;
  const Number half(0.5);
  for (std::size_t j = 0; j < 3; ++j) {
    const Vector along = (corner[next(j)] - corner[j]) * half;
    edges.push_back({corner[j] + along, along});
  }
  return edges;
}

// Whether these edges span the space.
bool span(const std::vector<Vector>& edges) {
  for (std::size_t i = 0; i < edges.size(); ++i) {
    for (std::size_t j = i + 1; j < edges.size(); ++j) {
      const Vector normal = cross(edges[i], edges[j]);
      for (std::size_t k = j + 1; k < edges.size(); ++k) {
        if (magnitude(dot(normal, edges[k])) > zero) return true;
      }
    }
  }
  return false;
}

// Whether a part of one of the edges of `from` is in `to`. The ends of such parts are noted in both.
template <class From, class To>
bool note_ends(const std::vector<Edge>& edges, From& from, To& to) {
  bool meets = false;
  for (const Edge& edge : edges) {
    if (meets && from.mean_is_inside() && to.mean_is_inside()) break;  // more points do not change that
    const std::optional<Range> range = to.clipped(edge);
    if (!range) continue;
    meets = true;
    for (const Quotient* t : {&range->first, &range->last}) {
      from.note(edge, *t);
      to.note(edge, *t);
    }
  }
  return meets;
}

template <class A, class B>
Common common_of(const std::vector<Edge>& edges_of_a, A& a, const std::vector<Edge>& edges_of_b, B& b) {
  const bool first = note_ends(edges_of_a, a, b), second = note_ends(edges_of_b, b, a);
  if (!first && !second) return {false, false};
  if (!a.mean_is_inside() || !b.mean_is_inside()) return {true, false};
  std::vector<Vector> along;
  for (const std::vector<Edge>* edges : {&edges_of_a, &edges_of_b}) {
    // Each fourth edge of a box has a direction of its own.
    for (std::size_t i = 0, step = edges->size() == 3 ? 1 : 4; i < edges->size(); i += step) {
      along.push_back((*edges)[i].along);
    }
  }
  return {true, span(along)};
}

}  // namespace

Common common_of(const BoxPair<Number>& q) {
  Slabs a(q.a), b(q.b);
  return common_of(edges_of(q.a), a, edges_of(q.b), b);
}

Common common_of(const BoxAndTriangle<Number>& q) {
  Slabs box(q.box);
  TriangleBody triangle(q.corner);
  return common_of(edges_of(q.box), box, edges_of(q.corner), triangle);
}

}  // namespace axiscert::boxes
