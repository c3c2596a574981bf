#include "fuzz/queries/query_shape.h"

#include <cmath>
#include <limits>
#include <string_view>

namespace axiscert {

QueryShape shape_of(const PredicateEntry& entry) {
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
  const std::vector<ColumnGroup> groups = groups_of(entry);
  const auto is_axis = [&](std::size_t g, char number) {
    const std::string_view name = groups[g].name;
    return entry.columns[groups[g].first].role == Role::direction && groups[g].size == 3 && name.size() > 2 &&
           name[name.size() - 2] == '.' && name.back() == number;
  };
  for (std::size_t g = 0; g + 2 < groups.size(); ++g) {
    if (is_axis(g, '0') && is_axis(g + 1, '1') && is_axis(g + 2, '2')) shape.frames.push_back(groups[g].first);
  }
  for (std::size_t k = 0; k < shape.numbers; ++k) shape.is_length[k] = entry.columns[k].role == Role::length;
  return shape;
}

namespace {

using FrameAxis = std::array<double, 3>;

double frame_dot(const FrameAxis& u, const FrameAxis& v) { return (u[0] * v[0] + u[1] * v[1]) + u[2] * v[2]; }
FrameAxis frame_rest(const FrameAxis& u, double times, const FrameAxis& v) {
  return {u[0] - times * v[0], u[1] - times * v[1], u[2] - times * v[2]};
}

template <class Real>
std::array<FrameAxis, 3> read_frame(const Numbers<Real>& q, std::size_t first) {
  std::array<FrameAxis, 3> frame;
  for (std::size_t k = 0; k < 9; ++k) frame[k / 3][k % 3] = static_cast<double>(q[first + k]);
  return frame;
}

}  // namespace

template <class Real>
bool is_nearly_rotation(const Numbers<Real>& q, std::size_t first) {
  const std::array<FrameAxis, 3> frame = read_frame(q, first);
  const double most = std::ldexp(8.0, -std::numeric_limits<Real>::digits);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t k = 0; k <= i; ++k) {
      if (!(std::fabs(frame_dot(frame[i], frame[k]) - (i == k ? 1 : 0)) <= most)) return false;
    }
  }
  return true;
}
template bool is_nearly_rotation(const Numbers<float>&, std::size_t);
template bool is_nearly_rotation(const Numbers<double>&, std::size_t);

template <class Real>
void make_rotation(Numbers<Real>& q, std::size_t first) {
  constexpr double least = 0x1p-40;  // of a length that is left of an axis, for it to have a direction
  std::array<FrameAxis, 3> frame = read_frame(q, first);
  bool has_three = true;
  // Twice: what rounding leaves of the others after the first time is gone after the second.
  for (int round = 0; round < 2; ++round) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < i; ++k) frame[i] = frame_rest(frame[i], frame_dot(frame[i], frame[k]), frame[k]);
      const double length = std::sqrt(frame_dot(frame[i], frame[i]));
      has_three = has_three && length > least && length < 0x1p100;
      if (has_three) frame[i] = {frame[i][0] / length, frame[i][1] / length, frame[i][2] / length};
    }
  }
  for (std::size_t k = 0; k < 9; ++k) {
    q[first + k] = static_cast<Real>(has_three ? frame[k / 3][k % 3] : k % 4 == 0 ? 1.0 : 0.0);
  }
}
template void make_rotation(Numbers<float>&, std::size_t);
template void make_rotation(Numbers<double>&, std::size_t);

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
