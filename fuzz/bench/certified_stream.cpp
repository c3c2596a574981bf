#include "fuzz/bench/certified_stream.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <functional>
#include <random>
#include <vector>

#include "fuzz/bench/bench_table.h"
#include "fuzz/campaign/thread_seconds.h"
#include "kernel/include/axiscert/certified.hpp"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {
namespace {

constexpr std::uint32_t side = 2049;  // vertices per side: 2^23 triangles, 288 MiB of binary32
constexpr std::size_t triangle_count = std::size_t{2} * (side - 1) * (side - 1);
constexpr int repetitions = 9;

// Rolling ground with cells of one unit, as an indexed mesh and as columns.
template <class Real>
struct Ground {
  std::vector<Real> vertices;
  std::vector<std::uint32_t> indices;
  std::array<std::vector<Real>, 9> columns;

  Ground() {
    for (std::uint32_t y = 0; y < side; ++y) {
      for (std::uint32_t x = 0; x < side; ++x) {
        const double height = 3 * std::sin(0.11 * x) * std::cos(0.07 * y);
        vertices.insert(vertices.end(), {static_cast<Real>(x), static_cast<Real>(y), static_cast<Real>(height)});
      }
    }
    for (std::uint32_t y = 0; y + 1 < side; ++y) {
      for (std::uint32_t x = 0; x + 1 < side; ++x) {
        const std::uint32_t at = y * side + x;
        indices.insert(indices.end(), {at, at + 1, at + side, at + 1, at + side + 1, at + side});
      }
    }
    for (std::size_t k = 0; k < 9; ++k) {
      for (std::size_t i = 0; i < triangle_count; ++i) {
        columns[k].push_back(vertices[3 * std::size_t{indices[3 * i + k / 3]} + k % 3]);
      }
    }
  }
  // Puts the mesh's triangles in an order independent of their places.
  void shuffle() {
    std::mt19937_64 random(20101230);
    for (std::size_t i = triangle_count - 1; i > 0; --i) {
      const std::size_t other = random() % (i + 1);
      std::swap_ranges(&indices[3 * i], &indices[3 * i] + 3, &indices[3 * other]);
    }
  }
};

// A read of the bytes alone: the sum of their words, in eight sums that do not wait for each other.
template <class Element>
std::uint64_t sum_of(const std::vector<Element>& all) {
  std::uint64_t sums[8] = {}, words[8];
  const char* bytes = reinterpret_cast<const char*>(all.data());
  const std::size_t size = all.size() * sizeof(Element);
  for (std::size_t i = 0; i + sizeof words <= size; i += sizeof words) {
    std::memcpy(words, bytes + i, sizeof words);
    for (int k = 0; k < 8; ++k) sums[k] += words[k];
  }
  std::uint64_t sum = 0;
  for (const std::uint64_t s : sums) sum += s;
  return sum;
}

double seconds(const std::function<void()>& pass) {
  const double start = thread_seconds();
  pass();
  return thread_seconds() - start;
}

// The two are timed in turns, so that other load on the machine affects both.
void print_row(std::string_view shape, Precision precision, std::size_t bytes, const std::function<void()>& ask,
               const std::function<void()>& read) {
  std::vector<double> asks, reads;
  for (int i = 0; i < repetitions; ++i) {
    asks.push_back(seconds(ask));
    reads.push_back(seconds(read));
  }
  const double asked = median(asks), read_alone = median(reads), size = static_cast<double>(bytes);
  fmt::print("| {} | {} | {:.0f} | {:.2f} | {:.1f} | {:.1f} | {:.0f} % |\n", shape, name(precision), size / 0x1p20,
             asked / static_cast<double>(triangle_count) * 1e9, size / asked * 1e-9, size / read_alone * 1e-9,
             100 * read_alone / asked);
}

template <class Real, class Mesh>
void print_streams(Precision precision) {
  Ground<Real> ground;
  const Real middle = side / 2, sphere[4] = {middle, middle, Real(2), Real(2.5)};
  std::vector<std::uint64_t> contacts(triangle_count / 64 + 1);
  const axiscert_results results{nullptr, contacts.data(), nullptr};
  std::uint64_t sum = 0;

  std::array<const Real*, 9> columns;
  for (std::size_t k = 0; k < 9; ++k) columns[k] = ground.columns[k].data();
  print_row(
      "structure of arrays", precision, 9 * sizeof(Real) * triangle_count,
      [&] { certified::triangles(sphere, columns, triangle_count, AXISCERT_CLOSED_SPHERE, results); },
      [&] {
        for (const auto& column : ground.columns) sum += sum_of(column);
      });
  const Mesh mesh{ground.vertices.data(), 3, ground.indices.data()};
  const auto print_mesh = [&](std::string_view shape) {
    print_row(
        shape, precision, sizeof(Real) * ground.vertices.size() + 4 * ground.indices.size(),
        [&] { certified::mesh_range(sphere, mesh, 0, triangle_count, AXISCERT_CLOSED_SPHERE, results); },
        [&] { sum += sum_of(ground.vertices) + sum_of(ground.indices); });
  };
  print_mesh("indexed mesh");
  ground.shuffle();
  print_mesh("the same, shuffled");
  if (sum == 0) fmt::print("\n");  // uses the sum, so that the read is not removed
}

}  // namespace

void print_certified_streams() {
  fmt::print(
      "\nOne sphere against 2^23 triangles of rolling ground, one thread, medians of {} passes; read: a plain sum over "
      "the same bytes.\n\n"
      "| shape | precision | MiB | ns a triangle | GB/s | read, GB/s | of it |\n|---|---|---:|---:|---:|---:|---:|\n",
      repetitions);
  print_streams<float, axiscert_mesh_f32>(Precision::binary32);
  print_streams<double, axiscert_mesh_f64>(Precision::binary64);
}

}  // namespace axiscert
