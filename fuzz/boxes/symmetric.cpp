// Two boxes and their images: the boxes exchanged, each turned half round about an axis of its own, which is the same
// body, and the world's axes exchanged or turned round. Every image is exact, so that no exact answer differs.
#include "fuzz/boxes/parts.h"
#include "fuzz/queries/image_groups.h"
#include "fuzz/sphere_triangle/families/parts/images.h"

namespace axiscert::boxes {

extern const std::array<ImageGroup, 2> symmetric_groups;  // for clear_boxes.cpp, where the groups are listed

namespace {

// The images: 1 has the boxes exchanged; 2 to 4 have A turned about its axes, 5 to 7 B; of matrices 8 to 12 have the
// world's axes in another order, and 13 to 19 have some of them turned round.
constexpr std::size_t first_of_axes = 8, first_of_signs = 13, images_of_matrices = 20, images_of_turns = first_of_axes;

ImageKind kind_of_symmetric(std::size_t image) {
  if (image == 1) return ImageKind::swap;
  if (image < first_of_axes) return ImageKind::turn;
  return image < first_of_signs ? ImageKind::axes : ImageKind::mirror;
}

template <class Real>
Vec3<Real> turned_round(const Vec3<Real>& v) {
  return {-v.x, -v.y, -v.z};
}
template <class Real>
void half_turn(OrientedBox<Real>& box, std::size_t about) {
  box.axis[next(about)] = turned_round(box.axis[next(about)]);
  box.axis[last(about)] = turned_round(box.axis[last(about)]);
}
// q times i, j or k.
template <class Real>
void half_turn(TurnedBox<Real>& box, std::size_t about) {
  const auto [w, x, y, z] = box.q;
  if (about == 0) box.q = {-x, w, z, -y};
  if (about == 1) box.q = {-y, -z, w, x};
  if (about == 2) box.q = {-z, y, -x, w};
}

template <class Real>
Numbers<Real> on_other_axes(const BoxPair<Real>& q, std::size_t image) {
  static constexpr std::array<std::array<std::uint8_t, 3>, 6> orders = {
      {{1, 2, 0}, {2, 0, 1}, {1, 0, 2}, {0, 2, 1}, {2, 1, 0}, {0, 1, 2}}};
  const bool has_order = image < first_of_signs;
  const auto signs = static_cast<std::uint8_t>(has_order ? 0 : image - first_of_signs + 1);
  return exact_images::with_axes(numbers_of(q), box_box_predicate().entries[MatrixBoxes::entry],
                                 orders[has_order ? image - first_of_axes : 5], signs);
}
template <class Real>
Numbers<Real> on_other_axes(const TurnedPair<Real>& q, std::size_t) {
  return numbers_of(q);
}

template <class Pair>
Numbers<RealOf<Pair>> image_of(const Pair& base, std::size_t image) {
  if (image == 0) return numbers_of(base);
  if (image >= first_of_axes) return on_other_axes(base, image);
  Pair q = base;
  if (image == 1) std::swap(q.a, q.b);
  else half_turn(image < 5 ? q.a : q.b, (image - 2) % 3);
  return numbers_of(q);
}

// Near touching, where a rounding decides.
template <class Pair>
Pair symmetric_base(Stream& random, std::uint64_t base) {
  Pair q = anywhere<Pair>(random, base);
  solve_tangent(q);
  nudge(random, 2, q);
  return q;
}

template <class Pair, std::size_t images>
void fill_symmetric(const StreamName& name, std::uint64_t first, const MutableColumns<RealOf<Pair>>& out) {
  fill_groups(name, first, out, images, symmetric_base<Pair>,
              [](Stream&, const Pair& q, std::uint64_t, std::size_t i) { return image_of(q, i); });
}

template <class Entry, std::size_t images>
constexpr Family symmetric_family(std::string_view name, std::string_view purpose) {
  return {.predicate = Entry::description,
          .name = name,
          .purpose = purpose,
          .version = 1,
          .exact_arithmetic = false,
          .binary32 = fill_symmetric<typename Entry::template Problem<float>, images>,
          .binary64 = fill_symmetric<typename Entry::template Problem<double>, images>,
          .situation = &box_box_situation::touching,
          .entry = Entry::entry};
}

constexpr std::array<std::uint8_t, 3> order_as_it_is(std::size_t) { return {0, 1, 2}; }

}  // namespace

const std::array<ImageGroup, 2> symmetric_groups = {
    {{box_box_predicate, "box-box/symmetric", images_of_matrices, order_as_it_is, kind_of_symmetric},
     {box_box_predicate, "box-box/symmetric_turned", images_of_turns, order_as_it_is, kind_of_symmetric}}};

extern const Family box_box_symmetric_family = symmetric_family<MatrixBoxes, images_of_matrices>(
    "box-box/symmetric", "tangent, and nineteen images: boxes exchanged, half turns of each, axes and mirrors");
extern const Family box_box_symmetric_turned_family = symmetric_family<QuaternionBoxes, images_of_turns>(
    "box-box/symmetric_turned", "tangent, and seven images: boxes exchanged, half turns of each, as quaternions");

}  // namespace axiscert::boxes
