// One sphere against the triangles of a mesh that a broad phase has left; the hits are compacted.
#include <axiscert/certified.hpp>
#include <cstdint>
#include <cstdio>
#include <vector>

int main() {
  // A strip of eight triangles in z = 0, over x from 0 to 4.
  std::vector<float> vertices;
  for (int i = 0; i < 5; ++i) {
    const float x = static_cast<float>(i);
    vertices.insert(vertices.end(), {x, 0, 0, x, 1, 0});
  }
  std::vector<std::uint32_t> indices;
  for (std::uint32_t i = 0; i < 8; i += 2) indices.insert(indices.end(), {i, i + 1, i + 2, i + 1, i + 3, i + 2});

  const float sphere[4] = {2, 0.5f, 0.5f, 0.5f};  // touches the plane at (2, 0.5, 0), on an edge of two triangles
  const std::vector<std::uint32_t> near = {2, 3, 4, 5};
  std::vector<std::uint32_t> hits(near.size());
  const axiscert_mesh_f32 mesh{vertices.data(), 3, indices.data()};
  const axiscert_counts counts = axiscert::certified::mesh_list(
      sphere, mesh, near.data(), near.size(), AXISCERT_CLOSED_SPHERE, {nullptr, nullptr, hits.data()});
  for (std::size_t i = 0; i < counts.contacts; ++i) std::printf("%u\n", static_cast<unsigned>(hits[i]));
  return counts.contacts == 2 && hits[0] == 3 && hits[1] == 4 ? 0 : 1;
}
