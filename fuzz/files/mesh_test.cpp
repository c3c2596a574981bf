#include "fuzz/files/mesh.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <filesystem>
#include <set>

#include "exact/sphere_triangle/measures/depth.h"
#include "exact/sphere_triangle/oracles/geometric_oracle.h"
#include "exact/sphere_triangle/asked_sphere_triangle.h"
#include "fuzz/files/mesh_testing.h"
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/lane_testing.h"
#include "kernel/base/sha256.h"
#include "fuzz/queries/source.h"
#include "fuzz/sphere_triangle/mesh_queries.h"
#include "kernel/base/error.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {
namespace {

std::string mesh_refusal(const std::string& path) {
  try {
    const auto file = mesh_source(path, sphere_triangle_predicate())->file();
    return fmt::format("accepted with {} triangles", file->triangles);
  } catch (const Error& wrong) {
    return wrong.what();
  }
}

struct ExpectedCounts {
  const char* file;
  std::uint64_t triangles, degenerate, skipped;
};

TEST(Mesh, RealModelsGiveTheirTriangles) {
  const std::vector<ExpectedCounts> models = {
      {"OBJ/spider.obj", 1368, 56, 0},  {"STL/Spider_binary.stl", 1368, 56, 0},
      {"PLY/cube.ply", 12, 0, 0},       {"OFF/Cube.off", 12, 0, 0},
      {"OBJ/testmixed.obj", 12, 0, 42}, {"glTF2/IndexOutOfRange/IndexOutOfRange.gltf", 11, 0, 0}};
  for (const ExpectedCounts& expected : models) {
    const auto file = mesh_source(model(expected.file), sphere_triangle_predicate())->file();
    EXPECT_EQ(file->triangles, expected.triangles) << expected.file;
    EXPECT_EQ(file->degenerate_triangles, expected.degenerate) << expected.file;
    EXPECT_EQ(file->skipped_primitives, expected.skipped) << expected.file;
  }
}

TEST(Mesh, DegenerateTrianglesAreKeptAndCounted) {
  const OwnMesh own("degenerate.obj", degenerate_obj);
  const Mesh mesh = load_mesh(own.path, degenerate_obj.size());
  ASSERT_EQ(mesh.triangles.size(), 3u);
  EXPECT_EQ(mesh.degenerate_triangles, 2u);
  EXPECT_EQ(mesh.skipped_primitives, 1u);
  EXPECT_EQ(mesh.diagonal, std::sqrt(17.0));
}

TEST(Mesh, AFileWithoutTrianglesIsRefusedInOneLineThatNamesIt) {
  const std::string infinite = model("glTF2/BoxWithInfinites-glTF-Binary/BoxWithInfinites.glb");
  const OwnMesh spaces("not a mesh.obj", "hello\n"), stranger("mesh.jsonl", "{}\n"), nothing("empty.stl", "");
  for (const std::string& path :
       {model("OBJ/point_cloud.obj"), model("OBJ/testline.obj"), infinite, model("glTF2/wrongTypes/badArray.gltf"),
        model("glTF2/IndexOutOfRange/AllIndicesOutOfRange.gltf"), model("glTF2/RecursiveNodes/RecursiveNodes.gltf"),
        model("invalid/malformed.obj"), model("invalid/empty.ply"), model("nowhere.obj"), model("OBJ"), spaces.path,
        stranger.path, nothing.path}) {
    const std::string message = mesh_refusal(path);
    EXPECT_EQ(message.substr(0, path.size() + 2), path + ": ");
    EXPECT_GT(message.size(), path.size() + 10) << message;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "No such file or directory", mesh_refusal(model("nowhere.obj")));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "Invalid face index", mesh_refusal(model("invalid/malformed.obj")));
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "12 faces", mesh_refusal(infinite));
}

// assimp requests 16 GB for this file of 300 bytes, and aborts if it gets them.
TEST(Mesh, AFileThatBreaksAssimpIsAnError) {
  EXPECT_PRED_FORMAT2(testing::IsSubstring, "OutOfMemory.off: ", mesh_refusal(model("invalid/OutOfMemory.off")));
  EXPECT_EQ(mesh_refusal(model("invalid/OutOfMemory.off")).find("accepted"), std::string::npos);
}

TEST(Mesh, AFileOnWhichAssimpNeverEndsIsAnError) {
  const OwnMesh endless("endless.ply", "ply\nformat ascii 1.0         ]\nelement vertex 8\nend_h4ader\n0 0 0\n");
  try {
    import_mesh(endless.path, {.bytes = std::uint64_t{1} << 30, .seconds = 1});
    FAIL();
  } catch (const Error& wrong) {
    EXPECT_PRED_FORMAT2(testing::IsSubstring, "stopped after 1 s", wrong.what());
  }
}

// One of `stride` models of the package; the paths are sorted, so that they are the same ones everywhere.
void expect_models_load_or_are_refused(std::size_t stride) {
  std::vector<std::string> paths;
  for (const char* folder : {"OBJ", "PLY", "STL", "OFF", "glTF2", "invalid"}) {
    for (const auto& entry : std::filesystem::recursive_directory_iterator(model(folder))) {
      if (entry.is_regular_file()) paths.push_back(entry.path());
    }
  }
  std::sort(paths.begin(), paths.end());
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  std::size_t loaded = 0, refused = 0;
  std::string wrong;
  for (std::size_t i = 0; i < paths.size(); i += stride) {
    const std::string message = mesh_refusal(paths[i]);
    if (message.starts_with("accepted")) ++loaded;
    else if (message.starts_with(paths[i] + ": ") && message.find('\n') == std::string::npos) ++refused;
    else wrong += message + "\n";
  }
  EXPECT_EQ(testing::internal::GetCapturedStdout() + testing::internal::GetCapturedStderr(), "");
  EXPECT_EQ(wrong, "");
  EXPECT_GE(loaded, 40 / stride);
  EXPECT_GE(refused, 20 / stride);
}

// Where trials are divided the build is slow, and its quick test asks for one model in five.
TEST(Mesh, EveryModelLoadsOrIsRefusedAndNothingIsPrinted) {
  expect_models_load_or_are_refused(TRIAL_DIVISOR == 1 ? 1 : 5);
}
TEST(MeshLong, EveryModelLoadsOrIsRefusedAndNothingIsPrinted) {
  if (TRIAL_DIVISOR != 1) expect_models_load_or_are_refused(1);
}

// The property that each placement promises, checked by the exact oracles.
template <class Real>
void expect_placement(const Query<Real>& q, Placement placement) {
  const ExactTruth truth = exact_truth(q, false);
  ASSERT_NE(truth.verdict, Verdict::invalid);
  const double off = depth(q, squared_distance(q));
  // 4.5 ulps of r, relative to a distance of at least r; for a subnormal distance an ulp is relatively more.
  const double graze = std::ldexp(9.0, -std::numeric_limits<Real>::digits);
  switch (placement) {
    case Placement::resting:
    case Placement::edge_graze:
    case Placement::vertex_graze:
      EXPECT_LE(off, graze);
      break;
    case Placement::sinking:
      EXPECT_EQ(truth.verdict, Verdict::contact);
      break;
    case Placement::hovering:
    case Placement::far:
      EXPECT_EQ(truth.verdict, Verdict::separated);
      break;
    case Placement::centre_on: {
      // P's rounding and a margin: 16 ulps of the greatest coordinate.
      Real greatest = 0;
      for (const Real x : coordinates(q)) greatest = std::max(greatest, std::abs(x));
      EXPECT_LE(radius_at_distance(q), std::ldexp(greatest, 4 - std::numeric_limits<Real>::digits));
      break;
    }
  }
}

template <class Real>
Query<Real> mesh_query(const Mesh& mesh, const StreamName& name, std::uint64_t position) {
  return filled_numbers<Real>(coordinate_count, [&](const auto& one) { fill_mesh_queries(mesh, name, position, one); });
}

template <class Real>
void expect_promises(const Mesh& mesh, std::uint64_t count) {
  std::set<Placement> met;
  for (std::uint64_t position = 0; position < count; ++position) {
    const auto q = mesh_query<Real>(mesh, StreamName(7, name_hash("mesh_test"), 1, precision_of<Real>), position);
    const Placement placement = placement_at(position, mesh.triangles.size());
    SCOPED_TRACE(fmt::format("position {}, placement {}", position, static_cast<int>(placement)));
    met.insert(placement);
    expect_placement(q, placement);
    if (testing::Test::HasFailure()) return;
  }
  EXPECT_EQ(met.size(), placement_count);
}

TEST(Mesh, EveryPlacementKeepsItsPromise) {
  const Mesh spider = load_mesh(model("OBJ/spider.obj"), 0);
  expect_promises<float>(spider, 1500);
  expect_promises<double>(spider, 1500);
  const OwnMesh own("promises.obj", degenerate_obj);
  const Mesh degenerate = load_mesh(own.path, 0);
  expect_promises<float>(degenerate, 400);
  expect_promises<double>(degenerate, 400);
}

TEST(Mesh, ExtremeCoordinatesGiveFiniteQueries) {
  const float huge = std::numeric_limits<float>::max(), tiny = std::numeric_limits<float>::denorm_min();
  Mesh mesh;
  mesh.triangles = {{{{-huge, 0, 0}, {huge, huge, 0}, {0, -huge, huge}}},
                    {{{0, 0, 0}, {tiny, 0, 0}, {0, tiny, 0}}},
                    {{{huge, huge, huge}, {huge, huge, huge}, {huge, huge, huge}}},
                    {{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}}}};
  for (const double diagonal : {0.0, 0x1p+129}) {
    mesh.diagonal = diagonal;
    for (std::uint64_t position = 0; position < 500; ++position) {
      const StreamName singles(1, 2, 1, Precision::binary32), doubles(1, 2, 1, Precision::binary64);
      ASSERT_TRUE(is_valid(mesh_query<float>(mesh, singles, position))) << position;
      ASSERT_TRUE(is_valid(mesh_query<double>(mesh, doubles, position))) << position;
    }
  }
}

TEST(MeshSource, Binary32AsksAboutTheFilesOwnTriangles) {
  const SourcePtr source = mesh_source(model("OBJ/spider.obj"), sphere_triangle_predicate());
  const Mesh mesh = load_mesh(model("OBJ/spider.obj"), 0);
  for (const std::uint64_t position : {0ul, 1ul, 1367ul, 1368ul, 2000000ul}) {
    const Query<float> q = source->make<float>(1, position);
    const MeshTriangle own = mesh.triangles[position % 1368];
    EXPECT_EQ(std::memcmp(&q.a, &own[0], sizeof own), 0);
  }
}

TEST(MeshSource, Binary64TurnsAndScalesTheTriangle) {
  const SourcePtr source = mesh_source(model("OFF/Cube.off"), sphere_triangle_predicate());
  const auto length = [](const auto& v) { return std::sqrt(static_cast<double>(portable::dot(v, v))); };
  for (std::uint64_t position = 0; position < 200; ++position) {
    const Query<float> own = source->make<float>(3, position);
    const Query<double> turned = source->make<double>(3, position);
    const double scale = length(turned.b - turned.a) / length(own.b - own.a);
    EXPECT_GE(scale, 0x1p-4 * (1 - 1e-12));
    EXPECT_LT(scale, 0x1p+5);
    EXPECT_NEAR(length(turned.c - turned.b) / length(own.c - own.b), scale, scale * 1e-12);
    EXPECT_NEAR(length(turned.a - turned.c) / length(own.a - own.c), scale, scale * 1e-12);
  }
}

// 512 queries are placed together; the mesh has three triangles, so that rounds begin within a batch.
template <class Real>
void expect_batches_are_their_queries(const Source& source) {
  constexpr std::uint64_t seed = 11, start = (std::uint64_t{1} << 32) - 40;
  constexpr std::size_t most = 1100;
  std::vector<Query<Real>> expected(most + 20);
  for (std::size_t i = 0; i < expected.size(); ++i) expected[i] = source.make<Real>(seed, start + i);
  for_each_instruction_set([&](const std::string& target) {
    QueryBatch<Real> batch(most, coordinate_count);
    for (const std::size_t count : {0, 1, 6, 7, 50, 511, 512, 513, 1100}) {
      for (const std::size_t offset : {0, 1, 2, 3, 10, 20}) {
        source.fill(seed, start + offset, count, batch);
        ASSERT_EQ(batch.size(), count);
        for (std::size_t i = 0; i < count; ++i) {
          const Query<Real> q = batch[i];
          ASSERT_EQ(std::memcmp(&q, &expected[offset + i], sizeof q), 0)
              << target << ", seed " << seed << ", first " << start + offset << ", count " << count << ", query " << i;
        }
      }
    }
  });
}
TEST(MeshSource, ABatchIsItsQueriesOnEveryInstructionSet) {
  const OwnMesh own("batch.obj", degenerate_obj);
  const SourcePtr source = mesh_source(own.path, sphere_triangle_predicate());
  expect_batches_are_their_queries<float>(*source);
  expect_batches_are_their_queries<double>(*source);
}

template <class Real>
std::string digest(const Source& source, std::uint64_t count) {
  std::vector<Query<Real>> queries(count), again(count);
  for (std::uint64_t i = 0; i < count; ++i) queries[i] = source.make<Real>(1, i);
  for (std::uint64_t i = count; i-- > 0;) again[i] = source.make<Real>(1, i);
  EXPECT_EQ(std::memcmp(queries.data(), again.data(), count * sizeof(Query<Real>)), 0);
  return sha256_hex(std::as_bytes(std::span(queries)));
}

TEST(MeshSource, AnAddressGivesTheSameBytesEverywhere) {
  const OwnMesh own("digest.obj", degenerate_obj);
  const SourcePtr source = mesh_source(own.path, sphere_triangle_predicate());
  EXPECT_EQ(digest<float>(*source, 2000), "cf810bf5cc40e377f6aff35604070d8ca229843b8e7abcb7e3c100e014fea92c");
  EXPECT_EQ(digest<double>(*source, 2000), "cc4bf99dbd874098883336eb666417e9c482708a34ecc493b9ab5ff32bab729c");
}

TEST(MeshSource, NamesItsFileByBaseNameAndHash) {
  const OwnMesh own("named.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
  const SourcePtr source = mesh_source(own.path, sphere_triangle_predicate());
  const std::string hash = "697b00ab13410c52a542d2e9c63711fcc04e9cbf6c0d3439a9b43cc812e6e713";  // sha256sum
  EXPECT_EQ(source->name(), "mesh/named.obj");
  EXPECT_EQ(source->address_name(), "mesh-" + hash);
  EXPECT_EQ(source->file()->sha256, hash);
  EXPECT_EQ(source->file()->kind, "mesh");
  EXPECT_EQ(source->version(), 2);
  EXPECT_EQ(source->base_triangles(Precision::binary32, 1000), 1u);
  EXPECT_EQ(source->cluster(Precision::binary32, 999), 0u);
  EXPECT_EQ(source->cluster_run(), 0u);
  EXPECT_EQ(source->fixed_size(Precision::binary32), std::nullopt);
}

}  // namespace
}  // namespace axiscert
