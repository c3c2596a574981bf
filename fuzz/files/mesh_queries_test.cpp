// Motions past the triangles of a mesh, and cells of a grid about them: of the file's own corners, as long as they say,
// and the same bytes everywhere.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <set>
#include <span>
#include <vector>

#include "exact/judge/oracles.h"
#include "fuzz/files/mesh.h"
#include "fuzz/files/mesh_testing.h"
#include "fuzz/moving_sphere/mesh_motion.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "kernel/base/sha256.h"
#include "kernel/boxes/box_triangle.h"
#include "kernel/kernel.h"
#include "kernel/moving_sphere/moving_sphere.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

// Motions past the same triangles and spheres.
TEST(MeshMotions, AreOfTheFilesTrianglesAndAgreedUponByTheOracles) {
  const SourcePtr still = mesh_source(model("OBJ/spider.obj"), sphere_triangle_predicate()),
                  moving = mesh_source(model("OBJ/spider.obj"), moving_sphere_predicate());
  const Oracles& oracles = oracles_of(moving_sphere_predicate());
  std::set<MeshMotion> met;
  std::size_t contacts = 0, asked = 0;
  // Two rounds of placements over the first triangles, in each of which every placement is.
  for (std::uint64_t round = 0; round < 2 * placement_count; ++round) {
    for (std::uint64_t triangle = 0; triangle < 21; ++triangle) {
      const std::uint64_t position = round * 1368 + triangle;
      met.insert(mesh_motion_at(position, 1368));
      const Numbers<float> q = moving->make<float>(1, position), placed = still->make<float>(1, position);
      EXPECT_TRUE(std::equal(q.begin(), q.begin() + 9, placed.begin())) << position;
      const Truth truth = oracles.truth(q);
      EXPECT_NE(truth.verdict, Verdict::invalid) << position;
      EXPECT_EQ(oracles.truth(moving->make<double>(1, position)).verdict == Verdict::invalid, false) << position;
      contacts += truth.verdict == Verdict::contact;
      ++asked;
    }
  }
  EXPECT_EQ(met.size(), 5u);
  EXPECT_GT(contacts, asked / 5);
  EXPECT_LT(contacts, asked * 4 / 5);
}

// A step is shorter than the walker, a bullet's longer than its triangle, and a shaking camera's hardly any.
TEST(MeshMotions, AreAsLongAsTheySay) {
  const Mesh spider = load_mesh(model("OBJ/spider.obj"), 0);
  const SourcePtr moving = mesh_source(model("OBJ/spider.obj"), moving_sphere_predicate());
  std::size_t characters = 0, walks = 0;
  for (std::uint64_t position = 0; position < 4000; ++position) {
    const Numbers<double> q = moving->make<double>(1, position);
    const double step = std::sqrt(q[12] * q[12] + q[13] * q[13] + q[14] * q[14]), r = q[15];
    switch (mesh_motion_at(position, spider.triangles.size())) {
      case MeshMotion::walking:
        ++walks;
        characters += r == static_cast<double>(0.3f);
        EXPECT_LE(step, r * 1.001) << position;
        break;
      case MeshMotion::shaking:
        EXPECT_LE(step, r * 0x1.01p-6) << position;
        break;
      case MeshMotion::dropped:
      case MeshMotion::bullet:
      case MeshMotion::arriving:
        EXPECT_GT(step, 0) << position;
        break;
    }
  }
  EXPECT_GT(characters, walks / 3);
  EXPECT_LT(characters, walks * 2 / 3);
}

TEST(MeshMotions, ABatchIsItsQueriesAndAnAddressGivesTheSameBytes) {
  const OwnMesh own("motions.obj", degenerate_obj);
  const SourcePtr source = mesh_source(own.path, moving_sphere_predicate());
  QueryBatch<float> batch(1100, source->columns().size());
  source->fill(11, 1000, 1100, batch);
  for (std::size_t i = 0; i < 1100; i += 7) {
    const Numbers<float> q = source->make<float>(11, 1000 + i), in_batch = batch[i];
    ASSERT_EQ(std::memcmp(q.data(), in_batch.data(), q.size() * sizeof(float)), 0) << i;
  }
  const auto digest_of = [&]<class Real>() {
    std::vector<Real> numbers;
    for (std::uint64_t position = 0; position < 500; ++position) {
      const Numbers<Real> q = source->make<Real>(1, position);
      numbers.insert(numbers.end(), q.begin(), q.end());
    }
    return sha256_hex(std::as_bytes(std::span(numbers)));
  };
  EXPECT_EQ(digest_of.operator()<float>(), "8d2be83292bd2eed18e1fa8f8f3689cc1d74e7e28997a997e607b6aa3e48cc18");
  EXPECT_EQ(digest_of.operator()<double>(), "2667a3b71bacc579f91431d02b2978f2082c8c2d2b8a85b9768881ea6d7c77b3");
}

TEST(MeshMotions, OfExtremeCoordinatesAreFinite) {
  const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  Mesh mesh;
  mesh.triangles = {{{{-huge, 0, 0}, {huge, huge, 0}, {0, -huge, huge}}},
                    {{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}},
                    {{{huge, huge, huge}, {huge, huge, huge}, {huge, huge, huge}}},
                    {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
  mesh.diagonal = 0x1p+129;
  const StreamName placed(1, 2, 2, Precision::binary32), moving(1, 3, 1, Precision::binary32);
  for (std::uint64_t position = 0; position < 500; ++position) {
    const auto q =
        filled_numbers<float>(16, [&](const auto& one) { fill_mesh_motions(mesh, placed, moving, position, one); });
    ASSERT_TRUE(std::all_of(q.begin(), q.end(), [](float x) { return std::isfinite(x); })) << position;
    ASSERT_GE(q[15], 0) << position;
  }
}

TEST(MeshSource, ItsAddressesNameAPredicateOtherThanTheFirst) {
  const OwnMesh own("tests.obj", degenerate_obj);
  const SourcePtr still = mesh_source(own.path, sphere_triangle_predicate()),
                  moving = mesh_source(own.path, moving_sphere_predicate());
  EXPECT_EQ(moving->address_name(), "moving-sphere/" + still->address_name());
  EXPECT_EQ(moving->name(), still->name()) << "a record is of one predicate";
  EXPECT_EQ(&moving->predicate(), &moving_sphere_predicate());
  EXPECT_EQ(moving->version(), 1);
}

}  // namespace

// The cells of a grid about a mesh's triangles: cubes beside them, of the file's own corners, agreed upon by the
// oracles.

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
