// The cells of a grid about a mesh's triangles: cubes beside them, of the file's own corners, agreed upon by the
// oracles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "exact/trait/oracles.h"
#include "fuzz/meshes/mesh.h"
#include "fuzz/meshes/mesh_testing.h"
#include "fuzz/queries/source.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/kernel.h"
#include "kernel/sphere_triangle/description.h"

namespace axiscert {
namespace {

TEST(MeshVoxels, AreCellsBesideTheFilesTriangles) {
  const SourcePtr spheres = mesh_source(model("OBJ/spider.obj"), sphere_triangle_predicate()),
                  voxels = mesh_source(model("OBJ/spider.obj"), box_triangle_predicate());
  EXPECT_EQ(voxels->entry(), mesh_queries_of(box_triangle_predicate()).entry);
  EXPECT_EQ(mesh_queries_of(sphere_triangle_predicate()).entry, 0u);
  EXPECT_TRUE(voxels->address_name().starts_with("box-triangle/mesh-"));
  const Oracles& oracles = oracles_of(box_triangle_predicate(), voxels->entry());
  std::size_t contacts = 0;
  constexpr std::uint64_t asked = 300;
  for (std::uint64_t position = 0; position < asked; ++position) {
    const Numbers<float> q = voxels->make<float>(1, position), placed = spheres->make<float>(1, position);
    EXPECT_TRUE(std::equal(q.begin() + 6, q.end(), placed.begin())) << position << ": the triangle is the file's";
    const float cell = q[3] - q[0];
    EXPECT_EQ(std::ldexp(1.0f, std::ilogb(cell)), cell) << position;
    for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(std::fmod(q[k], cell), 0) << position;
    const Truth truth = oracles.truth(q);
    EXPECT_NE(truth.verdict, Verdict::invalid) << position;
    EXPECT_NE(oracles.truth(voxels->make<double>(1, position)).verdict, Verdict::invalid) << position;
    contacts += truth.verdict == Verdict::contact;
  }
  EXPECT_GT(contacts, asked / 10);
  EXPECT_LT(contacts, asked * 9 / 10);
}

}  // namespace
}  // namespace axiscert
