#include "fuzz/testing/point_box/point_box.h"

namespace axiscert {
namespace {

// Planted: the last face is compared with the height of another.
struct WrongFace {
  static constexpr std::string_view name = PointBoxFaces::name;
  template <class T, class Sink>
  static void comparisons(const PointBox::Problem<T>& q, Sink& sink) {
    const auto planted = [&](std::size_t i, const T& lhs, const T& rhs) { sink(i, lhs, i == 5 ? q.high.y : rhs); };
    PointBoxFaces::comparisons<T>(q, planted);
  }
};

}  // namespace

std::vector<Kernel> point_box_kernels() {
  return {
      formulae_kernel<PointBox, PointBoxFaces>("point-box/strict", "beyond a face, by six comparisons"),
      formulae_kernel<PointBox, WrongFace>("point-box/fault", "the same with z.above against hy: wrong"),
  };
}

}  // namespace axiscert
