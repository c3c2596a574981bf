// The walk as SVG, seen from above: one panel for the walk, and one for each kernel with the contacts that it missed
// and invented.
#pragma once

#include <algorithm>
#include <cmath>
#include <compare>
#include <span>
#include <string>

#include "examples/character/comparison.h"
#include "examples/character/ground.h"

namespace axiscert::character {
// The projection from above into a panel of a picture: the axis up comes out of the page, and right-handed stays
// right-handed.

struct Pixel {
  double x, y;
};

// A point of a panel in tenths of a pixel, so that points that cannot be told apart are one.
struct Place {
  int x, y;
  auto operator<=>(const Place&) const = default;
  Place operator-(const Place& o) const { return {x - o.x, y - o.y}; }
};
inline double dot(const Place& a, const Place& b) { return double(a.x) * b.x + double(a.y) * b.y; }
inline double cross(const Place& a, const Place& b) { return double(a.x) * b.y - double(a.y) * b.x; }

class Projection {
 public:
  // The mesh's box with `margin` around it, scaled to at most this width and height.
  Projection(const Ground& ground, double margin, double width, double height)
      : right_(ground.up() == 0 ? 1 : 0), across_(ground.up() == 2 ? 1 : 2), sign_(ground.up() == 1 ? 1 : -1) {
    const double w = ground.high()[right_] - ground.low()[right_] + 2 * margin;
    const double h = ground.high()[across_] - ground.low()[across_] + 2 * margin;
    scale_ = std::min(width / w, height / h);
    left_ = ground.low()[right_] - margin;
    top_ = (sign_ > 0 ? ground.low()[across_] : ground.high()[across_]) - sign_ * margin;
    size_ = {w * scale_, h * scale_};
  }

  Place operator()(const Vec3<float>& v) const {
    const Point p = point(v);
    const auto tenths = [&](double length) { return static_cast<int>(std::lround(10 * scale_ * length)); };
    return {tenths(p[right_] - left_), tenths((p[across_] - top_) * sign_)};
  }
  Pixel size() const { return size_; }

 private:
  std::size_t right_, across_;
  double sign_, scale_, left_, top_;
  Pixel size_;
};

std::string picture(const Ground& ground, const Walk& walk, std::span<const Comparison> comparisons,
                    const std::string& title);

}  // namespace axiscert::character
