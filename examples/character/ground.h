// The ground on which the character walks: an indexed mesh for the narrow phase, and a tree of its triangles' boxes for
// the broad phase.
#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "fuzz/files/mesh.h"
#include "kernel/sphere_triangle/query.h"
#include "kernel/include/axiscert/certified.h"

namespace axiscert::character {

struct Sphere {
  Vec3<float> centre;
  float radius;
};

using Point = std::array<double, 3>;  // need not be exact in float
inline Point point(const Vec3<float>& v) { return {v.x, v.y, v.z}; }

// A box in which a sphere's centre is.
struct CentreBox {
  Point low, high;
};

// CGAL's AABB_tree: kept as long as the mesh, and asked once per sphere.
class BroadPhase {
 public:
  explicit BroadPhase(const std::vector<MeshTriangle>& triangles);  // must stay in place
  ~BroadPhase();
  // The triangles whose boxes intersect the sphere's, ascending: every contact is among them.
  void candidates(const Sphere& sphere, std::vector<std::uint32_t>& out) const;
  // The same of a sphere that is anywhere in the boxes.
  void candidates(std::span<const CentreBox> boxes, float radius, std::vector<std::uint32_t>& out) const;

 private:
  struct Tree;
  std::unique_ptr<Tree> tree_;
};

class Ground {
 public:
  // `up` is the axis opposite to gravity: 0, 1 or 2. At most 2^30 triangles.
  Ground(std::vector<MeshTriangle> triangles, std::size_t up);
  Ground(const Ground&) = delete;

  std::size_t size() const { return triangles_.size(); }
  const MeshTriangle& triangle(std::size_t t) const { return triangles_[t]; }
  bool has_area(std::size_t t) const { return has_area_[t]; }
  std::size_t up() const { return up_; }
  const Point& low() const { return low_; }  // the box of all triangles
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

// The axis along which the mesh is thinnest, of equal ones the last: levels are mostly flat.
std::size_t thinnest_axis(const std::vector<MeshTriangle>& triangles);

// The point of the closed triangle nearest to p, computed in double and rounded: it decides the direction of a push,
// not whether there is contact.
Point nearest_point(const MeshTriangle& triangle, const Point& p);

}  // namespace axiscert::character
