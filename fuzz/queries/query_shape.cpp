#include "fuzz/queries/query_shape.h"

#include <cmath>

namespace axiscert {

QueryShape shape_of(const TestEntry& entry) {
  QueryShape shape;
  shape.numbers = entry.columns.size();
  for (const ColumnGroup& group : groups_of(entry)) {
    const Role role = entry.columns[group.first].role;
    if (role == Role::coordinate && shape.axes == 0) shape.axes = group.size;
    if (role == Role::coordinate && group.size == shape.axes) shape.points.push_back(group.first);
  }
  for (const ColumnGroup& group : groups_of(entry)) {
    const bool is_direction = entry.columns[group.first].role == Role::direction && group.size == shape.axes;
    if (is_direction) shape.directions.push_back(group.first);
  }
  for (std::size_t k = 0; k < shape.numbers; ++k) shape.is_length[k] = entry.columns[k].role == Role::length;
  return shape;
}

template <class Real>
bool may_be_valid(const QueryShape& shape, const Numbers<Real>& q) {
  for (std::size_t k = 0; k < q.size(); ++k) {
    if (!std::isfinite(q[k]) || (shape.is_length[k] && q[k] < 0)) return false;
  }
  return true;
}
template bool may_be_valid(const QueryShape&, const Numbers<float>&);
template bool may_be_valid(const QueryShape&, const Numbers<double>&);

}  // namespace axiscert
