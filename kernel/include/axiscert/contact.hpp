// The C interface of contact.h in C++17, with the same names for float and double.
#pragma once

#include "certified.hpp"
#include "contact.h"

namespace axiscert::certified {

template <class Real>
using ContactData = std::conditional_t<sizeof(Real) == 4, axiscert_contact_data_f32, axiscert_contact_data_f64>;
template <class Real>
using ContactArrays = std::conditional_t<sizeof(Real) == 4, axiscert_contact_arrays_f32, axiscert_contact_arrays_f64>;

inline axiscert_verdict contact(const float* triangle, const float* sphere, ContactData<float>& data,
                                axiscert_question question = AXISCERT_CLOSED_SPHERE) noexcept {
  return axiscert_contact_f32(triangle, sphere, question, &data);
}
inline axiscert_verdict contact(const double* triangle, const double* sphere, ContactData<double>& data,
                                axiscert_question question = AXISCERT_CLOSED_SPHERE) noexcept {
  return axiscert_contact_f64(triangle, sphere, question, &data);
}

inline axiscert_counts contact_pairs(const std::array<const float*, 13>& columns, std::size_t size,
                                     axiscert_question question, const ContactArrays<float>& arrays) noexcept {
  return axiscert_contact_pairs_f32(columns.data(), size, question, &arrays);
}
inline axiscert_counts contact_pairs(const std::array<const double*, 13>& columns, std::size_t size,
                                     axiscert_question question, const ContactArrays<double>& arrays) noexcept {
  return axiscert_contact_pairs_f64(columns.data(), size, question, &arrays);
}

inline axiscert_counts contact_mesh_range(const float* sphere, const axiscert_mesh_f32& mesh, std::size_t first,
                                          std::size_t count, axiscert_question question, std::uint32_t* hits,
                                          const ContactArrays<float>& arrays) noexcept {
  return axiscert_contact_mesh_range_f32(sphere, &mesh, first, count, question, hits, &arrays);
}
inline axiscert_counts contact_mesh_range(const double* sphere, const axiscert_mesh_f64& mesh, std::size_t first,
                                          std::size_t count, axiscert_question question, std::uint32_t* hits,
                                          const ContactArrays<double>& arrays) noexcept {
  return axiscert_contact_mesh_range_f64(sphere, &mesh, first, count, question, hits, &arrays);
}

inline axiscert_counts contact_mesh_list(const float* sphere, const axiscert_mesh_f32& mesh,
                                         const std::uint32_t* triangles, std::size_t count, axiscert_question question,
                                         std::uint32_t* hits, const ContactArrays<float>& arrays) noexcept {
  return axiscert_contact_mesh_list_f32(sphere, &mesh, triangles, count, question, hits, &arrays);
}
inline axiscert_counts contact_mesh_list(const double* sphere, const axiscert_mesh_f64& mesh,
                                         const std::uint32_t* triangles, std::size_t count, axiscert_question question,
                                         std::uint32_t* hits, const ContactArrays<double>& arrays) noexcept {
  return axiscert_contact_mesh_list_f64(sphere, &mesh, triangles, count, question, hits, &arrays);
}

}  // namespace axiscert::certified
