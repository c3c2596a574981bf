#include "fuzz/certify/margin_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "exact/sphere_triangle/measures/input_class.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

constexpr int decade_of_nothing = -400;  // below that of every number

// The decimal exponent of a positive number, by its shortest decimal: the same on every machine.
int scene_decade(double size) {
  if (size == 0) return decade_of_nothing;
  const std::string text = fmt::format("{:e}", size);
  const std::size_t e = text.find('e') + 1;
  int decade = 0;
  std::from_chars(text.data() + e + (text[e] == '+'), text.data() + text.size(), decade);
  return decade;
}

}  // namespace

SceneMeasure::SceneMeasure(const TestDescription& test) : columns_(test.entries[0].columns), centre_(columns_.size()) {
  const std::vector<ColumnGroup> groups = groups_of(test.entries[0]);
  for (const ColumnGroup& group : groups) {
    for (const auto& [name, first] : {std::pair("a", &a_), {"b", &b_}, {"c", &c_}, {"p", &p_}, {"r", &r_}})
      if (group.name == name) *first = group.first;
  }
  if (!p_) return;
  for (const ColumnGroup& group : groups) {
    for (std::size_t k = 0; k < group.size && group.size == 3; ++k)
      if (columns_[group.first + k].role == Role::coordinate) centre_[group.first + k] = *p_ + k;
  }
}

template <class Real>
double SceneMeasure::size(const Numbers<Real>& query) const {
  double size = 0;
  for (std::size_t k = 0; k < columns_.size(); ++k) {
    double x = static_cast<double>(query[k]);
    if (centre_[k]) x -= static_cast<double>(query[*centre_[k]]);
    size = std::max(size, std::abs(x));
  }
  return size;
}
template double SceneMeasure::size(const Numbers<float>&) const;
template double SceneMeasure::size(const Numbers<double>&) const;

template <class Real>
MarginScene SceneMeasure::of(const Numbers<Real>& query) const {
  MarginScene scene{false, scene_decade(size(query))};
  if (!(a_ && b_ && c_ && p_ && r_)) return scene;
  const auto point = [&](std::size_t first) { return Vec3<Real>{query[first], query[first + 1], query[first + 2]}; };
  for (const InputClass which : shape_classes(Query<Real>{point(*a_), point(*b_), point(*c_), point(*p_), query[*r_]}))
    scene.is_degenerate |= which != InputClass::far;
  return scene;
}
template MarginScene SceneMeasure::of(const Numbers<float>&) const;
template MarginScene SceneMeasure::of(const Numbers<double>&) const;

}  // namespace axiscert
