#include "fuzz/boxes/capability_parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/boxes/scaled.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/boxes/boxes.h"

namespace axiscert::boxes {
namespace {

using Double3 = Vec3<double>;
using DoubleBox = OrientedBox<double>;

double extent_of(const Double3& v) { return std::sqrt(dot(v, v)); }

// The half of a box's extent along L, where no half extent is less than `least`.
double reach(const DoubleBox& box, const Double3& l, double least) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += std::max(box.half[k], least) * std::abs(dot(box.axis[k], l));
  return sum;
}

// Appends u x v, but where they are parallel, or so nearly that rounding makes the product.
void add_product(std::vector<Double3>& all, const Double3& u, const Double3& v) {
  const Double3 product = cross(u, v);
  if (dot(product, product) > 1e-20 * dot(u, u) * dot(v, v)) all.push_back(product);
}

// The square of the farthest corner's distance from the centre.
double squared_reach(const DoubleBox& box) {
  double greatest = 0;
  for (const Double3& corner : corners_of(DoubleBox{{}, box.half, box.axis}))
    greatest = std::max(greatest, dot(corner, corner));
  return greatest;
}

struct TwoBoxes {
  DoubleBox a, b;

  double squared_extent() const {
    const Double3 between = b.centre - a.centre;
    return std::max({dot(between, between), squared_reach(a), squared_reach(b)});
  }
  std::vector<double> halves() const { return {a.half[0], a.half[1], a.half[2], b.half[0], b.half[1], b.half[2]}; }
  double apart(const Double3& l, double least) const {
    return std::abs(dot(b.centre - a.centre, l)) - reach(a, l, least) - reach(b, l, least);
  }
  std::vector<Double3> axes() const {
    std::vector<Double3> all;
    for (const DoubleBox* box : {&a, &b}) {
      for (std::size_t k = 0; k < 3; ++k) add_product(all, box->axis[(k + 1) % 3], box->axis[(k + 2) % 3]);
    }
    for (const Double3& u : a.axis) {
      for (const Double3& v : b.axis) add_product(all, u, v);
    }
    return all;
  }
};

struct BoxWithTriangle {
  DoubleBox box;
  std::array<Double3, 3> corner;  // seen from the box's centre

  double squared_extent() const {
    double greatest = squared_reach(box);
    for (const Double3& v : corner) greatest = std::max(greatest, dot(v, v));
    return greatest;
  }
  std::vector<double> halves() const { return {box.half.begin(), box.half.end()}; }
  Double3 edge(std::size_t k) const { return corner[(k + 1) % 3] - corner[k]; }
  Double3 normal() const { return cross(edge(0), edge(1)); }
  double apart(const Double3& l, double least) const {
    const std::array<double, 3> at = {dot(corner[0], l), dot(corner[1], l), dot(corner[2], l)};
    const auto [low, high] = std::ranges::minmax(at);
    return std::max(low, -high) - reach(box, l, least);
  }
  std::vector<Double3> axes() const {
    std::vector<Double3> all;
    add_product(all, edge(0), edge(1));
    for (std::size_t k = 0; k < 3; ++k) {
      add_product(all, box.axis[(k + 1) % 3], box.axis[(k + 2) % 3]);
      for (const Double3& u : box.axis) add_product(all, u, edge(k));
    }
    return all;
  }
};

// The greatest gap that an axis shows; where none separates, less than 0: the least overlap.
double gap_on_axes(const auto& scene, double least) {
  double greatest = -std::numeric_limits<double>::infinity();
  for (const Double3& l : scene.axes()) greatest = std::max(greatest, scene.apart(l, least) / extent_of(l));
  return greatest;
}

double rough_depth_of(const auto& scene) {
  const double squared = scene.squared_extent();
  return squared > 0 ? -gap_on_axes(scene, 0) / std::sqrt(squared) : 0;
}

// The length |L| of the product of edges that parts the two the most; 0 where a facet or a plane does, or nothing.
double parting_product(const auto& scene, const auto& products) {
  double greatest = std::max(0.0, gap_on_axes(scene, 0)), length = 0;
  for (const Double3& l : products) {
    const double size = extent_of(l), gap = size > 0 ? scene.apart(l, 0) / size : 0;
    // By far no rounding less: the same axis in another length.
    if (gap > 0 && gap >= greatest * (1 - 1e-9)) length = size;
  }
  return length;
}

// The size to which all half extents that are less have to be raised for contact; 0 where there is contact already.
double size_of_contact(const auto& scene) {
  const double apart = gap_on_axes(scene, 0);
  if (!(apart > 0)) return 0;
  double low = 0, high = apart;
  while (gap_on_axes(scene, high) > 0) high *= 2;
  for (int step = 0; step < 24; ++step) {
    const double middle = (low + high) / 2;
    (gap_on_axes(scene, middle) > 0 ? low : high) = middle;
  }
  return high;
}

void add_sizes_of_both(const auto& scene, std::vector<double>& values) {
  const std::vector<double> halves = scene.halves();
  values.push_back(size_of_contact(scene));
  values.push_back(std::ranges::min(halves));
  values.push_back(std::ranges::max(halves));
  values.push_back(std::abs(gap_on_axes(scene, 0)));
}

constexpr std::string_view raised = "the half extent to which all that are less have to be raised for contact",
                           least_half = "the least half extent", greatest_half = "the greatest half extent",
                           least_gap = "the greatest gap on an axis, or the least overlap";

constexpr Quantity names_of_boxes[] = {{raised, 1},
                                       {least_half, 1},
                                       {greatest_half, 1},
                                       {least_gap, 1},
                                       {"the distance |T| of the centres", 1},
                                       {"the least half extent of A", 1},
                                       {"the least half extent of B", 1},
                                       {"the greatest half extent of A", 1},
                                       {"the greatest half extent of B", 1},
                                       {"the greatest coordinate", 1, true},
                                       {"|edge x edge| of the half edges whose product parts the two", 2},
                                       {"the volume of A", 3},
                                       {"the volume of B", 3}};

double greatest_length(const Double3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }
double volume(const DoubleBox& box) { return 8 * box.half[0] * box.half[1] * box.half[2]; }

std::vector<double> values_of(const TwoBoxes& q) {
  std::vector<double> values;
  add_sizes_of_both(q, values);
  values.push_back(extent_of(q.b.centre - q.a.centre));
  for (const DoubleBox* box : {&q.a, &q.b}) values.push_back(std::ranges::min(box->half));
  for (const DoubleBox* box : {&q.a, &q.b}) values.push_back(std::ranges::max(box->half));
  values.push_back(std::max(greatest_length(q.a.centre), greatest_length(q.b.centre)));
  std::vector<Double3> products;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) products.push_back(cross(q.a.axis[i] * q.a.half[i], q.b.axis[j] * q.b.half[j]));
  }
  values.push_back(parting_product(q, products));
  for (const DoubleBox* box : {&q.a, &q.b}) values.push_back(volume(*box));
  return values;
}

constexpr Quantity names_of_triangle[] = {{raised, 1},
                                          {least_half, 1},
                                          {greatest_half, 1},
                                          {least_gap, 1},
                                          {"the shortest edge", 1},
                                          {"the longest edge", 1},
                                          {"the least |edge x axis| that is not 0", 1},
                                          {"|edge x axis| of the product that parts the two", 1},
                                          {"the distance of the box's centre from the plane", 1},
                                          {"the distance of the box's centre from the nearest vertex", 1},
                                          {"|AB x AC|", 2},
                                          {"(A - centre) . (AB x AC)", 3},
                                          {"the volume of the box", 3}};

std::vector<double> values_of(const BoxWithTriangle& q) {
  std::vector<double> values;
  add_sizes_of_both(q, values);
  std::array<double, 3> edges, vertices;
  double product = std::numeric_limits<double>::infinity();
  std::vector<Double3> products;
  for (std::size_t k = 0; k < 3; ++k) {
    edges[k] = extent_of(q.edge(k));
    vertices[k] = extent_of(q.corner[k]);
    for (const Double3& axis : q.box.axis) {
      products.push_back(cross(axis, q.edge(k)));
      if (const double size = extent_of(products.back()); size > 0) product = std::min(product, size);
    }
  }
  const double area = extent_of(q.normal()), height = std::abs(dot(q.corner[0], q.normal()));
  values.insert(values.end(), {std::ranges::min(edges), std::ranges::max(edges), product, parting_product(q, products),
                               area > 0 ? height / area : 0, std::ranges::min(vertices), area, height, volume(q.box)});
  return values;
}

// The axes of the box that a quaternion of any length turns.
DoubleBox turned(const TurnedBox<double>& box) {
  double squared = 0;
  for (const double x : box.q) squared += x * x;
  const double to_one = 1 / std::sqrt(squared), w = box.q[0] * to_one, x = box.q[1] * to_one, y = box.q[2] * to_one,
               z = box.q[3] * to_one;
  return {box.centre,
          box.half,
          {{{1 - 2 * (y * y + z * z), 2 * (x * y + w * z), 2 * (x * z - w * y)},
            {2 * (x * y - w * z), 1 - 2 * (x * x + z * z), 2 * (y * z + w * x)},
            {2 * (x * z + w * y), 2 * (y * z - w * x), 1 - 2 * (x * x + y * y)}}}};
}

template <class Entry>
BoxWithTriangle scene_with_triangle(const auto& load) {
  const BoxAndTriangle<double> q = oriented(Entry::template problem<double>(load));
  const Double3& from = q.box.centre;
  return {q.box, {q.corner[0] - from, q.corner[1] - from, q.corner[2] - from}};
}

TwoBoxes scene_of_pair(std::size_t entry, const Numbers<double>& query) {
  const auto load = [&](std::size_t k) { return query[k]; };
  if (entry == QuaternionBoxes::entry) {
    const TurnedPair<double> q = QuaternionBoxes::problem<double>(load);
    return {turned(q.a), turned(q.b)};
  }
  if (entry == MixedBoxes::entry) {
    const MixedPair<double> q = MixedBoxes::problem<double>(load);
    return {with_matrix(q.a), turned(q.b)};
  }
  const BoxPair<double> q = entry == MinmaxBoxes::entry ? with_matrices(MinmaxBoxes::problem<double>(load))
                                                        : MatrixBoxes::problem<double>(load);
  return {q.a, q.b};
}

BoxWithTriangle scene_of_triangle(std::size_t entry, const Numbers<double>& query) {
  const auto load = [&](std::size_t k) { return query[k]; };
  if (entry == CentreEntry::entry) return scene_with_triangle<CentreEntry>(load);
  if (entry == MinmaxEntry::entry) return scene_with_triangle<MinmaxEntry>(load);
  if (entry == TurnedEntry::entry) return scene_with_triangle<TurnedEntry>(load);
  return scene_with_triangle<OrientedEntry>(load);
}

template <auto scene_of>
constexpr Quantities quantities_of(std::span<const Quantity> names) {
  return {names, [](std::size_t entry, const Numbers<double>& q) { return values_of(scene_of(entry, q)); },
          [](std::size_t entry, const Numbers<double>& q) { return rough_depth_of(scene_of(entry, q)); }};
}

}  // namespace

const Quantities& box_box_quantities() {
  static constexpr Quantities all = quantities_of<scene_of_pair>(names_of_boxes);
  return all;
}
const Quantities& box_triangle_quantities() {
  static constexpr Quantities all = quantities_of<scene_of_triangle>(names_of_triangle);
  return all;
}

}  // namespace axiscert::boxes
