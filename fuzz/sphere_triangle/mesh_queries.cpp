// Places spheres about the triangles of a mesh, one vector of queries with the same placement at a time. Everything is
// in binary64 with + - * / sqrt and powers of two, so that an address gives the same query everywhere; the query's own
// precision enters only with the last rounding.
#include "fuzz/sphere_triangle/families/parts/boundary.h"
#include "fuzz/queries/floats.h"
#include "fuzz/sphere_triangle/families/parts/lanes.h"
#include "fuzz/sphere_triangle/mesh_queries.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "fuzz/sphere_triangle/mesh_queries.cpp"
#include "hwy/foreach_target.h"
#include "hwy/highway.h"

#define AXISCERT_PER_TARGET
#include "fuzz/sphere_triangle/mesh_placement-inl.h"

#ifndef AXISCERT_MESH_QUERY_H
#define AXISCERT_MESH_QUERY_H
namespace axiscert {

inline constexpr std::size_t mesh_block_size = 512;

// The values to solve for when the vertices and the centre of a block's queries are known: the radius is the distance,
// moved by `ulps` floats, times the factor; if the factor is 0 the radius remains as it is.
struct MeshWishes {
  std::array<double, mesh_block_size> ulps, factor;
};

}  // namespace axiscert
#endif

HWY_BEFORE_NAMESPACE();
namespace axiscert::HWY_NAMESPACE {
namespace {

// Queries with the same placement: `count` of them, at most one per lane, at positions `first + index`. Their triangles
// are given.
template <class Real>
void make_vector(const Mesh& mesh, const StreamName& name, Placement placement, std::uint64_t first,
                 const std::uint16_t* index, const std::uint64_t* triangle, std::size_t count,
                 const MutableColumns<Real>& out, MeshWishes& wishes) {
  HWY_ALIGN double number_of[coordinate_count + 2][lanes];
  std::uint64_t position[lanes];
  for (std::size_t i = 0; i < lanes; ++i) {
    const std::size_t from = i < count ? index[i] : index[0];  // lanes without a query repeat the first
    position[i] = first + from;
    const MeshTriangle& own = mesh.triangles[triangle[from]];
    for (std::size_t k = 0; k < 3; ++k) {
      number_of[3 * k][i] = own[k].x;
      number_of[3 * k + 1][i] = own[k].y;
      number_of[3 * k + 2][i] = own[k].z;
    }
  }
  const auto loaded = [&](std::size_t k) HWY_ATTR { return T{hn::Load(Random::D(), number_of[k])}; };
  LaneVertices<T> v = {Point{loaded(0), loaded(1), loaded(2)}, Point{loaded(3), loaded(4), loaded(5)},
                       Point{loaded(6), loaded(7), loaded(8)}};
  Random random(name, position);
  T diagonal = number(mesh.diagonal);
  if constexpr (sizeof(Real) == 8) {
    const ScaledRotation placed = drawn_placement(random);
    for (Point& vertex : v) vertex = placed(vertex);
    diagonal = diagonal * placed.scale;
  }
  const Frame frame(v, diagonal, random);
  const LaneQuery<T> q = placed_query<Real>(placement, frame, random);

  const T greatest = number(static_cast<double>(std::numeric_limits<Real>::max()));
  const T least = number(-static_cast<double>(std::numeric_limits<Real>::max()));
  const T all[coordinate_count] = {q.v[0].x, q.v[0].y, q.v[0].z, q.v[1].x, q.v[1].y, q.v[1].z, q.v[2].x,
                                   q.v[2].y, q.v[2].z, q.p.x,    q.p.y,    q.p.z,    q.r};
  for (std::size_t k = 0; k < coordinate_count; ++k) {
    hn::Store(hn::Min(hn::Max(all[k].v, least.v), greatest.v), Random::D(), number_of[k]);
  }
  for (std::size_t k = 0; k < 2; ++k) hn::Store(q.wishes[k].v, Random::D(), number_of[coordinate_count + k]);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t k = 0; k < coordinate_count; ++k) out.column[k][index[i]] = static_cast<Real>(number_of[k][i]);
    wishes.ulps[index[i]] = number_of[coordinate_count][i];
    wishes.factor[index[i]] = number_of[coordinate_count + 1][i];
  }
}

// A block's queries, with those of the same placement grouped together.
template <class Real>
void make_block(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out,
                MeshWishes& wishes) {
  std::array<std::array<std::uint16_t, mesh_block_size>, placement_count> alike;
  std::array<std::size_t, placement_count> counts{};
  std::array<std::uint64_t, mesh_block_size> triangle;
  const std::uint64_t triangles = mesh.triangles.size();
  std::uint64_t at = first % triangles, round = first / triangles;
  for (std::size_t i = 0; i < out.size; ++i) {
    const auto placement = static_cast<std::size_t>((at + round) % placement_count);
    triangle[i] = at;
    alike[placement][counts[placement]++] = static_cast<std::uint16_t>(i);
    if (++at == triangles) {
      at = 0;
      ++round;
    }
  }
  for (std::size_t k = 0; k < placement_count; ++k) {
    for (std::size_t i = 0; i < counts[k]; i += lanes) {
      make_vector(mesh, name, static_cast<Placement>(k), first, &alike[k][i], triangle.data(),
                  std::min(lanes, counts[k] - i), out, wishes);
    }
  }
}

}  // namespace

void fill_mesh_block32(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<float>& out,
                       MeshWishes& wishes) {
  make_block(mesh, name, first, out, wishes);
}
void fill_mesh_block64(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<double>& out,
                       MeshWishes& wishes) {
  make_block(mesh, name, first, out, wishes);
}

}  // namespace axiscert::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace axiscert {
HWY_EXPORT(fill_mesh_block32);
HWY_EXPORT(fill_mesh_block64);

template <class Real>
void fill_mesh_queries(const Mesh& mesh, const StreamName& name, std::uint64_t first, const MutableColumns<Real>& out) {
  constexpr double greatest = static_cast<double>(std::numeric_limits<Real>::max());
  MeshWishes wishes;
  for (std::size_t begin = 0; begin < out.size; begin += mesh_block_size) {
    const auto block = out.part(begin, std::min(mesh_block_size, out.size - begin));
    if constexpr (sizeof(Real) == 4) HWY_DYNAMIC_DISPATCH(fill_mesh_block32)(mesh, name, first + begin, block, wishes);
    else HWY_DYNAMIC_DISPATCH(fill_mesh_block64)(mesh, name, first + begin, block, wishes);
    for (std::size_t i = 0; i < block.size; ++i) {
      if (wishes.factor[i] == 0) continue;
      const Real near = step_radius(radius_at_distance(query_from(block[i])), static_cast<int>(wishes.ulps[i]));
      block.column[12][i] = static_cast<Real>(std::min(static_cast<double>(near) * wishes.factor[i], greatest));
    }
  }
}
template void fill_mesh_queries<float>(const Mesh&, const StreamName&, std::uint64_t, const MutableColumns<float>&);
template void fill_mesh_queries<double>(const Mesh&, const StreamName&, std::uint64_t, const MutableColumns<double>&);

namespace {

template <class Real>
void fill_mesh_placements(const Mesh& mesh, const StreamName& placed, const StreamName&, std::uint64_t first,
                          const MutableColumns<Real>& out) {
  fill_mesh_queries(mesh, placed, first, out);
}

}  // namespace

extern const MeshQueries sphere_triangle_mesh = {
    "a real mesh's triangles: spheres resting on them, sinking in, hovering, grazing edges and vertices, centred on "
    "them, far",
    placements_version, 0, fill_mesh_placements<float>, fill_mesh_placements<double>};

}  // namespace axiscert
#endif
