#include "exact/judge/clear.h"

#include <algorithm>

namespace axiscert {
namespace {

// The greatest |x| of the numbers in `group`, or of their differences from those of another.
template <class Real>
double greatest_of(const Numbers<Real>& q, const ColumnGroup& group, const ColumnGroup* other = nullptr) {
  double found = 0;
  for (std::size_t i = 0; i < group.size; ++i) {
    const double from = other != nullptr ? static_cast<double>(q[other->first + i]) : 0;
    found = std::max(found, std::fabs(static_cast<double>(q[group.first + i]) - from));
  }
  return found;
}

}  // namespace

double barycentric_length(const portable::Vec3<double>& a, const portable::Vec3<double>& b,
                          const portable::Vec3<double>& c) {
  const portable::Vec3<double> ab = b - a, ac = c - a, bc = c - b, normal = cross(ab, ac);
  const double longest = std::sqrt(std::max({dot(ab, ab), dot(ac, ac), dot(bc, bc)}));
  return longest * (longest * (longest / std::sqrt(dot(normal, normal))));
}

void SceneLengths::note(double length) {
  if (length == 0) return;
  longest = std::max(longest, length);
  shortest = std::min(shortest, length);
}

SceneColumns::SceneColumns(const PredicateEntry& entry) {
  for (const PredicateColumn& column : entry.columns) roles_.push_back(column.role);
  for (const ColumnGroup& group : groups_of(entry)) {
    switch (entry.columns[group.first].role) {
      case Role::coordinate:
        points_.push_back(group);
        break;
      case Role::direction:
        directions_.push_back(group);
        break;
      case Role::length:
        for (std::size_t k = 0; k < group.size; ++k) lengths_.push_back(group.first + k);
        break;
      case Role::time:
        break;
    }
  }
}

template <class Real>
SceneLengths SceneColumns::lengths(const Numbers<Real>& q) const {
  SceneLengths scene;
  for (const ColumnGroup& direction : directions_) scene.note(greatest_of(q, direction));
  for (const std::size_t k : lengths_) scene.note(std::fabs(static_cast<double>(q[k])));
  for (std::size_t i = 0; i < points_.size(); ++i) {
    scene.farthest = std::max(scene.farthest, greatest_of(q, points_[i]));
    for (std::size_t j = 0; j < i; ++j) {
      if (points_[j].size == points_[i].size) scene.note(greatest_of(q, points_[i], &points_[j]));
    }
  }
  return scene;
}
template SceneLengths SceneColumns::lengths(const Numbers<float>&) const;
template SceneLengths SceneColumns::lengths(const Numbers<double>&) const;

}  // namespace axiscert
