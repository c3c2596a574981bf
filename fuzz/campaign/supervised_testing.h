// For tests: supervised kernels, as the harness sees foreign code, with planted faults.
#pragma once

#include <string>

#include "kernel/ask.h"
#include "kernel/sphere_triangle/query.h"

namespace axiscert {

// Changes the answer to query `i` of a batch, or adds a finding about it. The query is widened, exactly.
using Plant =
    std::function<void(const Query<double>& q, std::size_t i, Verdict& verdict, std::vector<Finding>& findings)>;

template <class Real>
Implementation<Real> supervised_implementation(const Implementation<Real>& right, const Plant& plant) {
  const auto supervised = [right, plant](const QueryColumns<Real>& batch, Verdict* out, Answers<Real>& answers,
                                         Watched& watched) {
    right.verdicts(batch, out);
    if (right.explain) right.explain(batch, answers);
    for (std::size_t i = 0; i < batch.size; ++i) {
      std::array<Real, coordinate_count> numbers;
      for (std::size_t k = 0; k < coordinate_count; ++k) numbers[k] = batch.column[k][i];
      plant(widened(from_coordinates(numbers)), i, out[i], watched.findings);
    }
  };
  const auto verdicts = [supervised](const QueryColumns<Real>& batch, Verdict* out) {
    Answers<Real> answers;
    answers.resize(batch.size, comparison_count);
    Watched ignored;
    supervised(batch, out, answers, ignored);
  };
  return {verdicts, right.explain, supervised};
}

// `base` as a plug-in that evaluates its formulae in an order of its own.
inline Kernel supervised_kernel(const std::string& id, const Plant& plant, const std::string& base = "published") {
  Kernel kernel = find_kernel(base);
  kernel.id = id;
  kernel.is_reference = false;
  kernel.has_simd = kernel.takes_arithmetic = false;
  kernel.binary32 = [plant, base](std::string_view) {
    return supervised_implementation(find_kernel(base).on<float>(scalar_target), plant);
  };
  kernel.binary64 = [plant, base](std::string_view) {
    return supervised_implementation(find_kernel(base).on<double>(scalar_target), plant);
  };
  return kernel;
}

// The same, but exposing only its verdict and claiming no formulae.
inline Kernel black_box(const std::string& id, const Plant& plant, const std::string& base = "minkowski") {
  Kernel kernel = supervised_kernel(id, plant, base);
  kernel.formulae.clear();
  kernel.exposes = Exposure::verdict;
  kernel.measure_count = 0;
  return kernel;
}

// A plug-in that could not be loaded.
inline Kernel unloadable_kernel(const std::string& id, const std::string& why) {
  Kernel kernel;
  kernel.id = id;
  kernel.summary = "not loaded";
  kernel.predicate = &sphere_triangle_predicate();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  kernel.findings = {{FindingKind::load, 0, why}};
  return kernel;
}

}  // namespace axiscert
