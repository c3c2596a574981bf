#include "fuzz/meshes/mesh.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <span>

#include "exact/numbers/surd.h"
#include "fuzz/queries/capabilities.h"
#include "fuzz/text/file_bytes.h"
#include "kernel/base/sha256.h"
#include "fuzz/queries/source.h"
#include "kernel/base/error.h"

namespace axiscert {
namespace {

bool has_zero_area(const MeshTriangle& t) {
  const auto binary = [](const Vec3<float>& v) {
    return Vec3<BinaryNumber>{BinaryNumber(v.x), BinaryNumber(v.y), BinaryNumber(v.z)};
  };
  const Vec3<BinaryNumber> a = binary(t[0]);
  const Vec3<BinaryNumber> normal = portable::cross(binary(t[1]) - a, binary(t[2]) - a);
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
  MeshSource(const std::string& path, const std::string& bytes, const Predicate& predicate)
      : mesh_(load_mesh(path, bytes.size())), predicate_(predicate), queries_(mesh_queries_of(predicate)) {
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
  std::string address_name() const override { return id_prefix(predicate_) + "mesh-" + file_.sha256; }
  std::string purpose() const override { return std::string(queries_.purpose); }
  int version() const override { return queries_.version; }
  std::size_t entry() const override { return queries_.entry; }
  const Predicate& predicate() const override { return predicate_; }
  std::uint64_t base_triangles(Precision, std::uint64_t trials) const override {
    return std::min(trials, file_.triangles);
  }
  std::optional<FileInfo> file() const override { return file_; }

  template <class Real>
  void fill_columns(std::uint64_t seed, std::uint64_t first, const MutableColumns<Real>& out) const {
    const StreamName placed(seed, placements_, placements_version, precision_of<Real>);
    const StreamName own(seed, generator_, version(), precision_of<Real>);
    if constexpr (sizeof(Real) == 4) queries_.in_binary32(mesh_, placed, own, first, out);
    else queries_.in_binary64(mesh_, placed, own, first, out);
  }

 private:
  Mesh mesh_;
  const Predicate& predicate_;
  const MeshQueries& queries_;
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

std::vector<const Predicate*> mesh_predicates() {
  std::vector<const Predicate*> served;
  for (const Predicate* predicate : predicates()) {
    if (capabilities_of(*predicate).mesh != nullptr) served.push_back(predicate);
  }
  return served;
}

const MeshQueries& mesh_queries_of(const Predicate& predicate) {
  const MeshQueries* const queries = capabilities_of(predicate).mesh;
  if (queries == nullptr) throw Error(fmt::format("a mesh has no queries of the predicate {}", predicate.id));
  return *queries;
}

SourcePtr mesh_source(const std::string& path, const Predicate& predicate) {
  return std::make_shared<MeshSource>(path, read_bytes(path), predicate);
}

}  // namespace axiscert
