#include "exact/boxes/hull_axes.h"

#include <algorithm>

namespace axiscert::boxes {
namespace {

using portable::cross, portable::dot;

bool is_zero(const Point& v) { return v.x == 0 && v.y == 0 && v.z == 0; }

// Whether no point has more along `normal` than `at`, or none less.
bool is_on_one_side(const Hull& hull, const Point& normal, const Rational& at) {
  const auto none = [&](int sign) {
    return std::none_of(hull.begin(), hull.end(),
                        [&](const Point& p) { return sgn(Rational(dot(normal, p) - at)) == sign; });
  };
  return none(1) || none(-1);
}

bool is_in_plane(const Hull& hull, const Point& normal) {
  return std::all_of(hull.begin(), hull.end(),
                     [&](const Point& p) { return dot(normal, p) == dot(normal, hull.front()); });
}

// The first product of two of these that is not 0, or 0.
Point first_product(const std::vector<Point>& directions) {
  for (const Point& one : directions) {
    for (const Point& other : directions) {
      if (Point product = cross(one, other); !is_zero(product)) return product;
    }
  }
  return {0, 0, 0};
}

struct Shape {
  std::vector<Point> normals;  // of the planes that have all points on one side and three of them, not in line, in it
  std::vector<Point> edges;    // directions; of a hull in a plane those of its outline
};

Shape shape_of(const Hull& hull) {
  std::vector<Point> all;
  for (const Point& p : hull) {
    if (Point along = p - hull.front(); !is_zero(along)) all.push_back(along);
  }
  if (all.empty()) return {};
  const Point plane = first_product(all);
  if (is_zero(plane)) return {{}, {all.front()}};
  Shape shape;
  const auto add_edges = [&](const Point& normal, const Rational& at) {
    for (const Point& p : hull) {
      for (const Point& q : hull) {
        const Point along = q - p;
        if (is_zero(along) || dot(normal, p) != at || dot(normal, q) != at) continue;
        // An edge of the face: the rest of the face is on one side of it.
        const Point across = cross(normal, along);
        Hull face;
        std::copy_if(hull.begin(), hull.end(), std::back_inserter(face),
                     [&](const Point& r) { return dot(normal, r) == at; });
        if (is_on_one_side(face, across, dot(across, p))) shape.edges.push_back(along);
      }
    }
  };
  const bool is_flat = is_in_plane(hull, plane);
  for (std::size_t i = 0; i < hull.size(); ++i) {
    for (std::size_t j = i + 1; j < hull.size(); ++j) {
      for (std::size_t k = j + 1; k < hull.size(); ++k) {
        const Point normal = cross(hull[j] - hull[i], hull[k] - hull[i]);
        const Rational at = dot(normal, hull[i]);
        if (is_zero(normal) || !is_on_one_side(hull, normal, at)) continue;
        shape.normals.push_back(normal);
        add_edges(normal, at);
        if (is_flat) return shape;
      }
    }
  }
  return shape;
}

}  // namespace

std::vector<Point> separating_axes(const Hull& a, const Hull& b, InPlane in_plane) {
  const Shape of_a = shape_of(a), of_b = shape_of(b);
  std::vector<Point> edges = of_a.edges;
  edges.insert(edges.end(), of_b.edges.begin(), of_b.edges.end());
  const Point between = a.front() - b.front(), normal = first_product(edges);
  std::vector<Point> axes;
  const auto add = [&](const Point& axis) {
    if (!is_zero(axis)) axes.push_back(axis);
  };
  if (edges.empty()) {
    add(between);
    return axes;
  }
  if (is_zero(normal)) {
    const Point& line = edges.front();
    add(line);
    add(between * Rational(dot(line, line)) - line * Rational(dot(line, between)));
    return axes;
  }
  const bool span_a_plane =
      std::all_of(edges.begin(), edges.end(), [&](const Point& edge) { return dot(normal, edge) == 0; });
  if (span_a_plane) {
    add(normal);
    if (in_plane == InPlane::left_out) return axes;
    for (const Point& edge : edges) add(cross(normal, edge));
    return axes;
  }
  for (const Shape* shape : {&of_a, &of_b}) {
    for (const Point& of_facet : shape->normals) add(of_facet);
  }
  for (const Point& one : of_a.edges) {
    for (const Point& other : of_b.edges) add(cross(one, other));
  }
  return axes;
}

bool are_apart_on(const std::vector<Point>& axes, const Hull& a, const Hull& b) {
  return std::any_of(axes.begin(), axes.end(), [&](const Point& axis) {
    const auto range = [&](const Hull& hull) {
      Rational least = dot(axis, hull.front()), greatest = least;
      for (const Point& p : hull) {
        const Rational at = dot(axis, p);
        least = std::min(least, at);
        greatest = std::max(greatest, at);
      }
      return std::pair{least, greatest};
    };
    const auto [least_a, greatest_a] = range(a);
    const auto [least_b, greatest_b] = range(b);
    return greatest_a < least_b || greatest_b < least_a;
  });
}

}  // namespace axiscert::boxes
