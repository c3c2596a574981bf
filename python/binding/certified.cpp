// libaxiscert on arrays (axiscert/certified.h, axiscert/contact.h).
#include <fmt/format.h>

#include <algorithm>
#include <type_traits>

#include "kernel/base/error.h"
#include "kernel/include/axiscert/contact.h"
#include "python/binding/common.h"

namespace axiscert::python {
namespace {

constexpr std::size_t columns_of_pair = 13;

template <class Real>
using ContactArrays = std::conditional_t<sizeof(Real) == 4, axiscert_contact_arrays_f32, axiscert_contact_arrays_f64>;
template <class Real>
using Mesh = std::conditional_t<sizeof(Real) == 4, axiscert_mesh_f32, axiscert_mesh_f64>;

// Room for what is said of so many pairs.
template <class Real>
struct Said {
  py::array_t<std::uint8_t> verdict, feature;
  py::array_t<bool> has_normal;
  py::array_t<Real> separation, normal, point;  // vectors: (3, n)

  explicit Said(py::ssize_t n)
      : verdict(n), feature(n), has_normal(n), separation(n), normal({py::ssize_t{3}, n}), point({py::ssize_t{3}, n}) {}
  ContactArrays<Real> arrays(std::size_t n, bool with_contacts) {
    ContactArrays<Real> to{};
    to.verdict = verdict.mutable_data();
    if (!with_contacts) return to;
    to.feature = feature.mutable_data();
    to.has_normal = reinterpret_cast<std::uint8_t*>(has_normal.mutable_data());
    to.separation = separation.mutable_data();
    for (std::size_t axis = 0; axis < 3; ++axis) {
      to.normal[axis] = normal.mutable_data() + axis * n;
      to.point[axis] = point.mutable_data() + axis * n;
    }
    return to;
  }
};

axiscert_question question_of(const std::string& name) {
  if (name == "closed") return AXISCERT_CLOSED_SPHERE;
  if (name == "open") return AXISCERT_OPEN_SPHERE;
  if (name == "conservative") return AXISCERT_CONSERVATIVE;
  throw Error(fmt::format("question='{}': there are: closed, open, conservative", name));
}

py::array certified_verdicts(const py::array& numbers, const std::string& question) {
  const GivenColumns given(entry_named("", ""), numbers);
  const axiscert_question asked = question_of(question);
  py::array_t<std::uint8_t> verdict(static_cast<py::ssize_t>(given.size()));
  const axiscert_results results{verdict.mutable_data(), nullptr, nullptr};
  given.visit([&]<class Real>(const QueryColumns<Real>& columns) {
    static_assert(columns_of_pair <= most_columns);
    const Unlocked unlocked;
    if constexpr (sizeof(Real) == 4) axiscert_pairs_f32(columns.column.data(), columns.size, asked, &results);
    else axiscert_pairs_f64(columns.column.data(), columns.size, asked, &results);
  });
  return verdict;
}

template <class Real>
py::tuple in_python(const Said<Real>& said) {
  return py::make_tuple(said.verdict, said.feature, said.has_normal, said.separation, said.normal, said.point);
}

py::tuple certified_contacts(const py::array& numbers, const std::string& question) {
  const GivenColumns given(entry_named("", ""), numbers);
  const axiscert_question asked = question_of(question);
  return given.visit([&]<class Real>(const QueryColumns<Real>& columns) -> py::tuple {
    Said<Real> said(static_cast<py::ssize_t>(columns.size));
    const ContactArrays<Real> to = said.arrays(columns.size, true);
    {
      const Unlocked unlocked;
      if constexpr (sizeof(Real) == 4) axiscert_contact_pairs_f32(columns.column.data(), columns.size, asked, &to);
      else axiscert_contact_pairs_f64(columns.column.data(), columns.size, asked, &to);
    }
    return in_python(said);
  });
}

// The triangles of a mesh that are in contact with one sphere: (their numbers, what is said of them).
template <class Real>
py::tuple mesh_of(const py::array_t<Real>& sphere, const py::array_t<Real>& vertices,
                  const py::array_t<std::uint32_t>& indices, const py::array_t<std::uint32_t>& triangles,
                  axiscert_question asked) {
  const auto size = static_cast<std::size_t>(triangles.size());
  const auto stride = static_cast<std::size_t>(vertices.strides(0)) / sizeof(Real);
  const Mesh<Real> mesh{vertices.data(), stride, indices.data()};
  Said<Real> said(static_cast<py::ssize_t>(size));
  ContactArrays<Real> to = said.arrays(size, true);
  to.verdict = nullptr;
  py::array_t<std::uint32_t> hits(static_cast<py::ssize_t>(size));
  std::uint32_t* const h = hits.mutable_data();
  const Real* const s = sphere.data();
  const std::uint32_t* const t = triangles.data();
  axiscert_counts counts;
  {
    const Unlocked unlocked;
    if constexpr (sizeof(Real) == 4) counts = axiscert_contact_mesh_list_f32(s, &mesh, t, size, asked, h, &to);
    else counts = axiscert_contact_mesh_list_f64(s, &mesh, t, size, asked, h, &to);
  }
  return py::make_tuple(counts.contacts, counts.invalid, hits, in_python(said));
}

}  // namespace

void bind_certified(py::module_& m) {
  m.def("certified_verdicts", &certified_verdicts);
  m.def("certified_contacts", &certified_contacts);
  // The package has checked shapes and indices.
  m.def("certified_mesh",
        [](const py::array& sphere, const py::array& vertices, const py::array_t<std::uint32_t>& indices,
           const py::array_t<std::uint32_t>& triangles, const std::string& question) {
          const axiscert_question asked = question_of(question);
          if (py::isinstance<py::array_t<float>>(vertices))
            return mesh_of<float>(sphere, vertices, indices, triangles, asked);
          return mesh_of<double>(sphere, vertices, indices, triangles, asked);
        });
}

}  // namespace axiscert::python
