// Scenes of sphere-triangle in small integers, times a power of two: whatever the formulae, hardly an operation is
// rounded.
#pragma once

#include <string_view>
#include <vector>

#include "fuzz/queries/random.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert::diagnosis {

// The draws of one probe: the same for a seed on every machine.
inline Stream stream_of(std::uint64_t seed, std::string_view probe, Precision precision, std::uint64_t position) {
  return Stream(seed, name_hash(probe), 1, precision, position);
}

// The part of the triangle that is nearest to the centre.
enum class Part : std::uint8_t { face, edge, vertex };

// The distance is `distance`, a small integer times a power of two, exactly: lengths of edges are powers of two, and
// distances sides of triangles of integers, so that a method that divides and takes roots is exact too. The radius is
// the distance.
template <class Real>
struct TouchingScene {
  Query<Real> query;
  Part part;
};
template <class Real>
std::vector<TouchingScene<Real>> touching_scenes(std::uint64_t seed, std::size_t of_each);

// The centre lies over the inside of the face, at half the radius from its plane: contact.
template <class Real>
struct SidedScene {
  Query<Real> query;
  bool is_front;  // on the side of (B - A) x (C - A)
};
template <class Real>
std::vector<SidedScene<Real>> sided_scenes(std::uint64_t seed, std::size_t count);

// Vertices on a line, exactly. The sphere is in contact with a radius of four distances or more, or apart by three
// radii or more.
enum class Flat : std::uint8_t { point, two_equal, collinear };
inline constexpr std::string_view flat_names[] = {"point", "two_equal", "collinear"};
template <class Real>
struct FlatScene {
  Query<Real> query;
  Flat flat;
  bool is_contact;
};
template <class Real>
std::vector<FlatScene<Real>> flat_scenes(std::uint64_t seed, std::size_t of_each);

}  // namespace axiscert::diagnosis
