// What the character walks on: an indexed mesh for the narrow phase, and a tree of its triangles' boxes, the broad
// phase.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "fuzz/meshes/mesh.h"
#include "kernel/include/axiscert/certified.h"

namespace axiscert::character {

struct Sphere {
  Vec3<float> centre;
  float radius;
};

using Point = std::array<double, 3>;  // exact in float or not
inline Point point(const Vec3<float>& v) { return {v.x, v.y, v.z}; }

// CGAL's AABB_tree: kept for as long as the mesh is, asked once a sphere.
class BroadPhase {
 public:
  explicit BroadPhase(const std::vector<MeshTriangle>& triangles);  // which stay where they are
  ~BroadPhase();
  // The triangles whose boxes meet the sphere's, ascending: every contact is among them.
  void candidates(const Sphere& sphere, std::vector<std::uint32_t>& out) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

class Ground {
 public:
  // `up` is the axis against which things fall: 0, 1 or 2. Not more than 2^30 triangles.
  Ground(std::vector<MeshTriangle> triangles, std::size_t up);
  Ground(const Ground&) = delete;

  std::size_t size() const { return triangles_.size(); }
  const MeshTriangle& triangle(std::size_t t) const { return triangles_[t]; }
  bool has_area(std::size_t t) const { return has_area_[t]; }
  std::size_t up() const { return up_; }
  const Point& low() const { return low_; }  // the box of all
  const Point& high() const { return high_; }
  const BroadPhase& broad_phase() const { return broad_phase_; }
  axiscert_mesh_f32 mesh() const { return {&triangles_[0][0].x, 3, indices_.data()}; }
  Query<float> query(const Sphere& sphere, std::size_t t) const {
    return {triangles_[t][0], triangles_[t][1], triangles_[t][2], sphere.centre, sphere.radius};
  }

 private:
  std::vector<MeshTriangle> triangles_;
  std::vector<std::uint32_t> indices_;
  std::vector<bool> has_area_;
  std::size_t up_;
  Point low_, high_;
  BroadPhase broad_phase_;
};

// The axis along which the mesh is thinnest, of equal ones the last: a level lies flat.
std::size_t thinnest_axis(const std::vector<MeshTriangle>& triangles);

// Of the closed triangle, the point nearest to p, in double and rounded: for which way to push, not for whether.
Point nearest_point(const MeshTriangle& triangle, const Point& p);

}  // namespace axiscert::character
