// The C interface of certified.h in C++17, with the same names for float and double.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>

#include "certified.h"

namespace axiscert::certified {

template <class Real>
using Mesh = std::conditional_t<sizeof(Real) == 4, axiscert_mesh_f32, axiscert_mesh_f64>;

inline bool passed_self_check() noexcept { return axiscert_passed_self_check() != 0; }

inline axiscert_verdict pair(const float* triangle, const float* sphere,
                             axiscert_question question = AXISCERT_CLOSED_SPHERE) noexcept {
  return axiscert_pair_f32(triangle, sphere, question);
}
inline axiscert_verdict pair(const double* triangle, const double* sphere,
                             axiscert_question question = AXISCERT_CLOSED_SPHERE) noexcept {
  return axiscert_pair_f64(triangle, sphere, question);
}

inline axiscert_counts pairs(const std::array<const float*, 13>& columns, std::size_t size, axiscert_question question,
                             const axiscert_results& results) noexcept {
  return axiscert_pairs_f32(columns.data(), size, question, &results);
}
inline axiscert_counts pairs(const std::array<const double*, 13>& columns, std::size_t size, axiscert_question question,
                             const axiscert_results& results) noexcept {
  return axiscert_pairs_f64(columns.data(), size, question, &results);
}

inline axiscert_counts triangles(const float* sphere, const std::array<const float*, 9>& columns, std::size_t size,
                                 axiscert_question question, const axiscert_results& results) noexcept {
  return axiscert_triangles_f32(sphere, columns.data(), size, question, &results);
}
inline axiscert_counts triangles(const double* sphere, const std::array<const double*, 9>& columns, std::size_t size,
                                 axiscert_question question, const axiscert_results& results) noexcept {
  return axiscert_triangles_f64(sphere, columns.data(), size, question, &results);
}

inline axiscert_counts mesh_range(const float* sphere, const axiscert_mesh_f32& mesh, std::size_t first,
                                  std::size_t count, axiscert_question question,
                                  const axiscert_results& results) noexcept {
  return axiscert_mesh_range_f32(sphere, &mesh, first, count, question, &results);
}
inline axiscert_counts mesh_range(const double* sphere, const axiscert_mesh_f64& mesh, std::size_t first,
                                  std::size_t count, axiscert_question question,
                                  const axiscert_results& results) noexcept {
  return axiscert_mesh_range_f64(sphere, &mesh, first, count, question, &results);
}

inline axiscert_counts mesh_list(const float* sphere, const axiscert_mesh_f32& mesh, const std::uint32_t* triangles,
                                 std::size_t count, axiscert_question question,
                                 const axiscert_results& results) noexcept {
  return axiscert_mesh_list_f32(sphere, &mesh, triangles, count, question, &results);
}
inline axiscert_counts mesh_list(const double* sphere, const axiscert_mesh_f64& mesh, const std::uint32_t* triangles,
                                 std::size_t count, axiscert_question question,
                                 const axiscert_results& results) noexcept {
  return axiscert_mesh_list_f64(sphere, &mesh, triangles, count, question, &results);
}

}  // namespace axiscert::certified
