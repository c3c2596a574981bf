#include "fuzz/meshes/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/sphere_triangle/oracles/formula_oracle.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/sha256.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/moving_sphere/moving_sphere.h"

namespace axiscert {
namespace {

bool has_zero_area(const MeshTriangle& t) {
  const auto ring = [](const Vec3<float>& v) { return Vec3<Ring>{Ring(v.x), Ring(v.y), Ring(v.z)}; };
  const Vec3<Ring> a = ring(t[0]);
  const Vec3<Ring> normal = portable::cross(ring(t[1]) - a, ring(t[2]) - a);
  return normal.x.is_zero() && normal.y.is_zero() && normal.z.is_zero();
}

double box_diagonal(const std::vector<MeshTriangle>& triangles) {
  const Vec3<float> first = triangles[0][0];
  std::array<float, 3> low = {first.x, first.y, first.z}, high = low;
  for (const MeshTriangle& t : triangles) {
    for (const Vec3<float>& v : t) {
      const std::array<float, 3> at = {v.x, v.y, v.z};
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], at[k]);
        high[k] = std::max(high[k], at[k]);
      }
    }
  }
  double sum = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double side = static_cast<double>(high[k]) - static_cast<double>(low[k]);
    sum = sum + side * side;
  }
  return std::sqrt(sum);
}

class MeshSource final : public ColumnSource<MeshSource> {
 public:
  MeshSource(const std::string& path, const std::string& bytes, const TestDescription& test)
      : mesh_(load_mesh(path, bytes.size())), test_(test) {
    file_.path = path;
    file_.name = base_name(path);
    file_.kind = "mesh";
    file_.sha256 = sha256_hex(std::as_bytes(std::span(bytes)));
    file_.triangles = mesh_.triangles.size();
    file_.degenerate_triangles = mesh_.degenerate_triangles;
    file_.skipped_primitives = mesh_.skipped_primitives;
    generator_ = name_hash(address_name());
    placements_ = name_hash("mesh-" + file_.sha256);
  }

  std::string name() const override { return "mesh/" + file_.name; }
  std::string address_name() const override { return id_prefix(test_) + "mesh-" + file_.sha256; }
  std::string purpose() const override {
    if (&test_ == &box_triangle_test()) return "a real mesh's triangles against the cells of a grid";
    if (&test_ == &moving_sphere_test()) {
      return "a real mesh's triangles: steps of a walking sphere, balls dropped on edges and vertices, bullets, "
             "arrivals from afar, a shaking camera";
    }
    return "a real mesh's triangles: spheres resting on them, sinking in, hovering, grazing edges and vertices, "
           "centred on them, far";
  }
  int version() const override { return &test_ == &first_test() ? placements_version : 1; }
  std::size_t entry() const override { return mesh_entry(test_); }
  const TestDescription& test() const override { return test_; }
  std::uint64_t base_triangles(Precision, std::uint64_t trials) const override {
    return std::min(trials, file_.triangles);
  }
  std::optional<FileInfo> file() const override { return file_; }

  template <class Real>
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    const StreamName placed(seed, placements_, placements_version, precision_of<Real>);
    if (&test_ == &first_test()) return mesh_queries(mesh_, placed, first, out);
    const StreamName own(seed, generator_, version(), precision_of<Real>);
    if (&test_ == &box_triangle_test()) return mesh_voxels(mesh_, placed, own, first, out);
    mesh_motions(mesh_, placed, own, first, out);
  }

 private:
  static constexpr int placements_version = 2;
  Mesh mesh_;
  const TestDescription& test_;
  FileInfo file_;
  std::uint64_t generator_ = 0, placements_ = 0;  // names of streams, hashed
};

}  // namespace

Mesh load_mesh(const std::string& path, std::uint64_t file_size) {
  ImportedMesh imported = import_mesh(path, limits_for(file_size));
  if (imported.triangles.empty()) {
    throw Error(fmt::format("{}: no triangles in this mesh ({} faces are points, lines or not finite)", path,
                            imported.skipped_primitives));
  }
  Mesh mesh;
  mesh.triangles = std::move(imported.triangles);
  mesh.skipped_primitives = imported.skipped_primitives;
  mesh.degenerate_triangles =
      static_cast<std::uint64_t>(std::count_if(mesh.triangles.begin(), mesh.triangles.end(), has_zero_area));
  mesh.diagonal = box_diagonal(mesh.triangles);
  return mesh;
}

std::vector<const TestDescription*> mesh_tests() {
  return {&first_test(), &moving_sphere_test(), &box_triangle_test()};
}

std::size_t mesh_entry(const TestDescription& test) {
  return &test == &box_triangle_test() ? boxes::MinmaxEntry::entry : 0;
}

SourcePtr mesh_source(const std::string& path, const TestDescription& test) {
  const std::vector<const TestDescription*> served = mesh_tests();
  if (std::find(served.begin(), served.end(), &test) == served.end()) {
    throw Error(fmt::format("{}: a mesh has no queries of the test {}", path, test.id));
  }
  return std::make_shared<MeshSource>(path, read_bytes(path), test);
}

}  // namespace axiscert
