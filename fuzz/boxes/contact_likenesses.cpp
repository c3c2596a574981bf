#include "fuzz/boxes/contact_likenesses.h"

#include <cmath>

#include "kernel/boxes/box_triangle.h"

namespace axiscert::boxes {
namespace {

// Calls see(query) with the problem of the entry that has so many columns, of those given.
template <class... Entries, class See>
std::vector<double> seen_by_columns(const Numbers<double>& q, const See& see) {
  std::vector<double> found;
  const auto ask = [&]<class Entry>() {
    if (Entry::description().entries[Entry::entry].columns.size() == q.size())
      found = see(Entry::template problem<double>([&](std::size_t k) { return q[k]; }));
  };
  (ask.template operator()<Entries>(), ...);
  return found;
}

Vec3<double> centre_of(const CornersBox<double>& box) { return (box.low + box.high) * 0.5; }
template <class Box>
Vec3<double> centre_of(const Box& box) {
  return box.centre;
}
Vec3<double> centre_of_box(const CentredAndTriangle<double>& q) { return q.centre; }
template <class Problem>
Vec3<double> centre_of_box(const Problem& q) {
  return q.box.centre;
}

std::vector<double> unit_numbers(const Vec3<double>& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? std::vector{v.x / size, v.y / size, v.z / size} : std::vector<double>();
}

std::vector<double> from_centre_to_centre(const Numbers<double>& q) {
  return seen_by_columns<MatrixBoxes, QuaternionBoxes, MinmaxBoxes, MixedBoxes>(
      q, [](const auto& pair) { return unit_numbers(centre_of(pair.b) - centre_of(pair.a)); });
}

// The entries of a box by centre and by corners have as many columns: the first is taken.
std::vector<double> from_centre_to_triangle(const Numbers<double>& q) {
  return seen_by_columns<CentreEntry, OrientedEntry, TurnedEntry>(q, [](const auto& given) {
    return unit_numbers((given.corner[0] + given.corner[1] + given.corner[2]) / 3.0 - centre_of_box(given));
  });
}

}  // namespace

std::span<const ContactLikeness* const> box_box_contact_likenesses() {
  static constexpr ContactLikeness centres = {MeasureKind::normal, "of_centres", "It goes from centre to centre",
                                              from_centre_to_centre};
  static constexpr const ContactLikeness* all[] = {&centres};
  return all;
}

std::span<const ContactLikeness* const> box_triangle_contact_likenesses() {
  static constexpr ContactLikeness centres = {MeasureKind::normal, "of_centres",
                                              "It goes from the centre of the box to the middle of the triangle",
                                              from_centre_to_triangle};
  static constexpr const ContactLikeness* all[] = {&centres};
  return all;
}

}  // namespace axiscert::boxes
