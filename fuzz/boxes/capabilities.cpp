#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "exact/boxes/measures.h"
#include "fuzz/boxes/capability_parts.h"
#include "fuzz/boxes/situations.h"
#include "fuzz/diagnosis/scenes.h"
#include "fuzz/files/mesh.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
// Queries of a box and a triangle by two corners (entry `minmax`): at each position the triangle that
// fill_mesh_queries() has there, and the cell of a grid in which a point of it is, or one beside that; `cells` names
// the stream of the cells. Their sides are powers of two, a quarter to eight times the triangle's longest side along an
// axis. Every number is finite.
template <class Real>
void fill_mesh_voxels(const Mesh& mesh, const StreamName& placed, const StreamName& cells, std::uint64_t first,
                      const MutableColumns<Real>& out);

extern const MeshQueries box_triangle_mesh;

// The triangles of a mesh against the cells of a grid, as a voxelizer asks. Floors, sums, products and powers of two
// alone.

namespace mesh_voxel {
namespace {

// 2^k: from a quarter of the triangle's longest side along an axis to eight times it; 1 where the triangle is a point.
double cell_of(Stream& random, const std::array<Vec3<double>, 3>& corner) {
  double longest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<double> side = corner[(k + 1) % 3] - corner[k];
    for (const double x : {side.x, side.y, side.z}) longest = std::max(longest, std::fabs(x));
  }
  const auto finer = static_cast<int>(random.integer(-2, 3));
  const int exponent = longest > 0 && std::isfinite(longest) ? std::ilogb(longest) : 0;
  return std::ldexp(1.0, std::clamp(exponent + finer, -100, 100));
}

// The number of the cell in which x is, or of one beside it.
double number_of(Stream& random, double x, double cell) {
  return std::floor(x / cell) + static_cast<double>(random.integer(-1, 1));
}

template <class Real>
Numbers<Real> query_of(Stream& random, const std::array<Vec3<Real>, 3>& corner) {
  std::array<Vec3<double>, 3> v;
  for (std::size_t k = 0; k < 3; ++k) {
    v[k] = {static_cast<double>(corner[k].x), static_cast<double>(corner[k].y), static_cast<double>(corner[k].z)};
  }
  const double cell = cell_of(random, v), s = random.unit<double>(), t = random.unit<double>();
  const bool is_beyond = s + t > 1;
  const Vec3<double> at = v[0] + (v[1] - v[0]) * (is_beyond ? 1 - s : s) + (v[2] - v[0]) * (is_beyond ? 1 - t : t);
  const double x = number_of(random, at.x, cell), y = number_of(random, at.y, cell), z = number_of(random, at.z, cell);
  const auto finite = [](double number) {
    constexpr auto most = static_cast<double>(std::numeric_limits<Real>::max());
    return static_cast<Real>(std::clamp(number, -most, most));
  };
  const auto corner_at = [&](double by) {
    return Vec3<Real>{finite((x + by) * cell), finite((y + by) * cell), finite((z + by) * cell)};
  };
  return boxes::numbers_of(boxes::CornersAndTriangle<Real>{corner_at(0), corner_at(1), corner});
}

}  // namespace
}  // namespace mesh_voxel

template <class Real>
void fill_mesh_voxels(const Mesh& mesh, const StreamName& placed, const StreamName& cells, std::uint64_t first,
                      const MutableColumns<Real>& out) {
  constexpr std::size_t block = 512;
  QueryBatch<Real> places(std::min(block, out.size), coordinate_count);
  for (std::size_t begin = 0; begin < out.size; begin += block) {
    places.resize(std::min(block, out.size - begin));
    fill_mesh_queries(mesh, placed, first + begin, places.mutable_columns());
    for (std::size_t i = 0; i < places.size(); ++i) {
      Stream random(cells, first + begin + i);
      const Query<Real> q = places[i];
      out.set(begin + i, mesh_voxel::query_of<Real>(random, {q.a, q.b, q.c}));
    }
  }
}
template void fill_mesh_voxels<float>(const Mesh&, const StreamName&, const StreamName&, std::uint64_t,
                                      const MutableColumns<float>&);
template void fill_mesh_voxels<double>(const Mesh&, const StreamName&, const StreamName&, std::uint64_t,
                                       const MutableColumns<double>&);

extern const MeshQueries box_triangle_mesh = {"a real mesh's triangles against the cells of a grid", 1,
                                              boxes::MinmaxEntry::entry, fill_mesh_voxels<float>,
                                              fill_mesh_voxels<double>};

namespace {

constexpr diagnosis::DiagnosisScenes box_scenes = {.words = {.length = "half extents",
                                                             .sided = "boxes",
                                                             .front = "the centre of the box is in front of the face",
                                                             .behind = "the centre of the box is behind the face",
                                                             .first = "A's place",
                                                             .second = "B's place"}};

constexpr std::string_view section_of_forms = "docs/boxes.md#from-the-definition-to-the-books";

template <class Entry>
auto given_in(const Numbers<double>& q) {
  return Entry::template problem<double>([&](std::size_t k) { return q[k]; });
}

std::vector<ExactFact> facts_of_pair(const Numbers<double>& q, std::size_t entry) {
  using namespace boxes;
  if (entry == QuaternionBoxes::entry) return exact_facts(exact_pair(given_in<QuaternionBoxes>(q)));
  if (entry == MinmaxBoxes::entry) return exact_facts(exact_pair(given_in<MinmaxBoxes>(q)));
  if (entry == MixedBoxes::entry) return exact_facts(exact_pair(given_in<MixedBoxes>(q)));
  return exact_facts(exact_pair(given_in<MatrixBoxes>(q)));
}

std::vector<ExactFact> facts_of_triangle(const Numbers<double>& q, std::size_t entry) {
  using namespace boxes;
  if (entry == MinmaxEntry::entry) return exact_facts(exact_box_and_triangle(given_in<MinmaxEntry>(q)));
  if (entry == OrientedEntry::entry) return exact_facts(exact_box_and_triangle(given_in<OrientedEntry>(q)));
  if (entry == TurnedEntry::entry) return exact_facts(exact_box_and_triangle(given_in<TurnedEntry>(q)));
  return exact_facts(exact_box_and_triangle(given_in<CentreEntry>(q)));
}

}  // namespace

}  // namespace axiscert

namespace axiscert::boxes {
// Numbers that kernels give in place of those of a contact.

namespace {

BoxPair<double> pair_of(const Numbers<double>& q, std::size_t entry) {
  const auto both = [](const auto& given) { return BoxPair<double>{with_matrix(given.a), with_matrix(given.b)}; };
  if (entry == QuaternionBoxes::entry) return both(given_in<QuaternionBoxes>(q));
  if (entry == MinmaxBoxes::entry) return both(given_in<MinmaxBoxes>(q));
  if (entry == MixedBoxes::entry) return both(given_in<MixedBoxes>(q));
  return given_in<MatrixBoxes>(q);
}
BoxAndTriangle<double> box_and_triangle_of(const Numbers<double>& q, std::size_t entry) {
  if (entry == MinmaxEntry::entry) return oriented(given_in<MinmaxEntry>(q));
  if (entry == OrientedEntry::entry) return given_in<OrientedEntry>(q);
  if (entry == TurnedEntry::entry) return oriented(given_in<TurnedEntry>(q));
  return oriented(given_in<CentreEntry>(q));
}

std::vector<double> unit_numbers(const Vec3<double>& v) {
  const double size = std::sqrt(dot(v, v));
  return size > 0 ? std::vector{v.x / size, v.y / size, v.z / size} : std::vector<double>();
}
double half_along(const OrientedBox<double>& box, const Vec3<double>& d) {
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += box.half[k] * std::fabs(dot(box.axis[k], d));
  return sum;
}

std::vector<double> from_centre_to_centre(const Numbers<double>& q, std::size_t entry) {
  const auto [a, b] = pair_of(q, entry);
  return unit_numbers(b.centre - a.centre);
}
std::vector<double> beyond_faces_of_a(const Numbers<double>& q, std::size_t entry) {
  const auto [a, b] = pair_of(q, entry);
  std::vector<double> most;
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3<double> normal = cross(a.axis[next(k)], a.axis[last(k)]);
    const double beyond =
        (std::fabs(dot(b.centre - a.centre, normal)) - half_along(a, normal) - half_along(b, normal)) /
        std::sqrt(dot(normal, normal));
    if (most.empty() || beyond > most[0]) most = {beyond};
  }
  return most;
}

std::vector<double> from_centre_to_triangle(const Numbers<double>& q, std::size_t entry) {
  const auto [box, corner] = box_and_triangle_of(q, entry);
  return unit_numbers((corner[0] + corner[1] + corner[2]) / 3.0 - box.centre);
}
std::vector<double> beyond_triangle(const Numbers<double>& q, std::size_t entry) {
  const auto [box, corner] = box_and_triangle_of(q, entry);
  const Vec3<double> normal = cross(corner[1] - corner[0], corner[2] - corner[0]);
  const double size = std::sqrt(dot(normal, normal));
  if (!(size > 0)) return {};
  return {(std::fabs(dot(box.centre - corner[0], normal)) - half_along(box, normal)) / size};
}

}  // namespace

std::span<const ContactLikeness* const> box_box_contact_likenesses() {
  static constexpr ContactLikeness centres = {MeasureKind::normal, "of_centres", "It goes from centre to centre",
                                              from_centre_to_centre},
                                   faces = {MeasureKind::separation, "against_plane",
                                            "It is the distance to the plane of the first box's nearest face",
                                            beyond_faces_of_a};
  static constexpr const ContactLikeness* all[] = {&centres, &faces};
  return all;
}

std::span<const ContactLikeness* const> box_triangle_contact_likenesses() {
  static constexpr ContactLikeness centres = {MeasureKind::normal, "of_centres",
                                              "It goes from the centre of the box to the middle of the triangle",
                                              from_centre_to_triangle},
                                   plane = {MeasureKind::separation, "against_plane",
                                            "It is the box's distance to the triangle's plane", beyond_triangle};
  static constexpr const ContactLikeness* all[] = {&centres, &plane};
  return all;
}

}  // namespace axiscert::boxes

namespace axiscert {

// clear_boxes.cpp, clear_triangles.cpp
std::span<const ImageGroup* const> box_box_image_groups();
std::span<const ImageGroup* const> box_triangle_image_groups();

const Capabilities& box_box_capabilities() {
  static const Capabilities all = {.image_groups = box_box_image_groups(),
                                   .quantities = &boxes::box_box_quantities(),
                                   .section_of_forms = section_of_forms,
                                   .situations = &boxes::box_box_situation::all,
                                   .diagnosis_scenes = &box_scenes,
                                   .slack_scenes = &box_box_slack_scenes,
                                   .traits = &box_box_traits(),
                                   .contact_likenesses = boxes::box_box_contact_likenesses(),
                                   .exact_facts = facts_of_pair};
  return all;
}

const Capabilities& box_triangle_capabilities() {
  static const Capabilities all = {.image_groups = box_triangle_image_groups(),
                                   .mesh = &box_triangle_mesh,
                                   .quantities = &boxes::box_triangle_quantities(),
                                   .section_of_forms = section_of_forms,
                                   .situations = &boxes::box_triangle_situation::all,
                                   .diagnosis_scenes = &box_scenes,
                                   .slack_scenes = &box_triangle_slack_scenes,
                                   .traits = &box_triangle_traits(),
                                   .contact_likenesses = boxes::box_triangle_contact_likenesses(),
                                   .exact_facts = facts_of_triangle};
  return all;
}

}  // namespace axiscert
