// Faults of what is said beside the verdict of a sphere and a triangle, planted in a kernel that is right but for
// rounding; and right choices that only look like faults.
#pragma once

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <string>
#include <vector>

#include "kernel/kernel.h"

namespace axiscert {

// A kernel that is right, whose numbers beside its verdicts are changed after it gave them: a planted fault of
// contacts.

using MeasureColumns = std::vector<std::vector<float>>;  // by measure, then by query of the batch
using MeasureEdit = std::function<void(MeasureColumns& measures, const QueryColumns<float>& batch, std::size_t i)>;

// `right` has to outlive the kernel, which claims nothing and exists in binary32 alone.
inline Kernel with_edit(const Kernel& right, const char* name, MeasureEdit change) {
  Kernel kernel = right;
  kernel.id = fmt::format("{}~{}", right.id, name);
  kernel.exposes = Exposure::verdict;
  kernel.formulae = "";
  kernel.is_reference = false;
  kernel.binary64 = nullptr;
  kernel.binary32 = [change, &right](std::string_view) {
    const Implementation<float> of_right = right.on<float>(scalar_target);
    Implementation<float> made;
    made.verdicts = of_right.verdicts;
    made.measure = [of_right, change](const QueryColumns<float>& batch, Answers<float>& out) {
      of_right.measure(batch, out);
      for (std::size_t i = 0; i < batch.size; ++i) change(out.measures, batch, i);
    };
    return made;
  };
  return kernel;
}

struct PlantedContact {
  const char* name;
  MeasureEdit change;
};

inline std::vector<PlantedContact> planted_contacts() {
  using Batch = QueryColumns<float>;
  constexpr std::size_t separation = 0, feature = 1, normal = 2, point = 5, centre = 9, radius = 12;
  const auto scale_normal = [](MeasureColumns& m, std::size_t i, float by) {
    for (std::size_t k = 0; k < 3; ++k) m[normal + k][i] *= by;
  };
  const auto is_on_triangle = [](const MeasureColumns& m, const Batch& batch, std::size_t i) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (m[point + k][i] != batch.column[centre + k][i]) return false;
    }
    return true;
  };
  return {
      {"right", [](MeasureColumns&, const Batch&, std::size_t) {}},
      {"other-side-of-a-tie",
       [=](MeasureColumns& m, const Batch& batch, std::size_t i) {
         if (is_on_triangle(m, batch, i)) scale_normal(m, i, -1);
       }},
      {"nothing-beside-separated",
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         for (std::size_t k = m.size(); m[separation][i] > 0 && k-- > 0;) m[k][i] = std::nanf("");
       }},
      {"flipped", [=](MeasureColumns& m, const Batch&, std::size_t i) { scale_normal(m, i, -1); }},
      {"tilted",  // by 1e-3, about an axis that it is far from
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         const std::size_t other = std::fabs(m[normal + 2][i]) > 0.9f ? normal + 2 : normal + 1;
         const float x = m[normal][i], y = m[other][i], angle = 1e-3f;
         m[normal][i] = x * std::cos(angle) - y * std::sin(angle);
         m[other][i] = x * std::sin(angle) + y * std::cos(angle);
       }},
      {"not-normalised", [=](MeasureColumns& m, const Batch&, std::size_t i) { scale_normal(m, i, 1.001f); }},
      {"face-always", [](MeasureColumns& m, const Batch&, std::size_t i) { m[feature][i] = 6; }},
      {"depth-against-the-plane",
       [](MeasureColumns& m, const Batch& batch, std::size_t i) {
         const auto corner = [&](std::size_t c, std::size_t k) { return batch.column[3 * c + k][i]; };
         float u[3], v[3], h[3];
         for (std::size_t k = 0; k < 3; ++k) {
           u[k] = corner(1, k) - corner(0, k);
           v[k] = corner(2, k) - corner(0, k);
           h[k] = batch.column[centre + k][i] - corner(0, k);
         }
         const float n[3] = {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
         const float size = std::sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
         const float height = std::fabs(h[0] * n[0] + h[1] * n[1] + h[2] * n[2]) / size;
         if (size > 0) m[separation][i] = height - batch.column[radius][i];
       }},
      {"on-the-sphere",
       [](MeasureColumns& m, const Batch& batch, std::size_t i) {
         for (std::size_t k = 0; k < 3; ++k)
           m[point + k][i] = batch.column[centre + k][i] - batch.column[radius][i] * m[normal + k][i];
       }},
      {"margin-of-5-mm", [](MeasureColumns& m, const Batch&, std::size_t i) { m[separation][i] -= 0.005f; }},
      {"never-positive",
       [](MeasureColumns& m, const Batch&, std::size_t i) { m[separation][i] = std::min(0.0f, m[separation][i]); }},
      {"some-points-missing",
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         for (std::size_t k = 0; i % 37 == 0 && k < 3; ++k) m[point + k][i] = std::nanf("");
       }},
      {"some-normals-missing",
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         for (std::size_t k = 0; i % 37 == 0 && k < 3; ++k) m[normal + k][i] = std::nanf("");
       }},
      {"some-features-missing",
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         if (i % 37 == 0) m[feature][i] = std::nanf("");
       }},
      {"some-without-numbers",
       [](MeasureColumns& m, const Batch&, std::size_t i) {
         for (std::size_t k = 0; i % 37 == 0 && k < m.size(); ++k) m[k][i] = std::nanf("");
       }},
      {"no-separation", [](MeasureColumns& m, const Batch&, std::size_t i) { m[separation][i] = std::nanf(""); }},
  };
}

}  // namespace axiscert
