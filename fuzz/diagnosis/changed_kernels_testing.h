// Kernels of any predicate that show a verdict alone, each with one property that is known because it is made so:
// another kernel, of which the query or the answer is changed. And what a probe finds of them.
#pragma once

#include <map>
#include <string>

#include "fuzz/diagnosis/other_units.h"
#include "fuzz/diagnosis/probes.h"
#include "kernel/ask.h"
#include "kernel/kernel.h"

namespace axiscert {
inline constexpr Precision single = Precision::binary32, twice = Precision::binary64;
}

namespace axiscert::made {

template <class Real>
Verdict verdict_by(const Implementation<Real>& kernel, const Numbers<Real>& query) {
  return axiscert::ask(kernel, query).verdicts[0];
}

// A kernel that answers a query by `answer(base, implementation of it, query)`.
template <class Answer>
Kernel answered_by(const Kernel& base, const std::string& suffix, Answer answer) {
  Kernel kernel = base;
  kernel.id += "-" + suffix;
  kernel.exposes = Exposure::verdict;
  const auto made = [base, answer]<class Real>(std::string_view target) {
    const Implementation<Real> right = base.on<Real>(target);
    Implementation<Real> implementation;
    implementation.verdicts = [base, answer, right](const QueryColumns<Real>& batch, Verdict* out) {
      for (std::size_t i = 0; i < batch.size; ++i) {
        Numbers<Real> query(batch.count);
        for (std::size_t k = 0; k < batch.count; ++k) query[k] = batch.column[k][i];
        out[i] = answer(base, right, query);
      }
    };
    return implementation;
  };
  kernel.binary32 = [made](std::string_view target) { return made.template operator()<float>(target); };
  kernel.binary64 = [made](std::string_view target) { return made.template operator()<double>(target); };
  return kernel;
}

// Every length, as radii and half extents are, taken as at least 0.01.
inline Kernel clamped(const Kernel& base) {
  return answered_by(base, "clamped", []<class Real>(const Kernel& of, const auto& right, Numbers<Real> query) {
    const std::vector<PredicateColumn>& columns = of.predicate->entries[of.entry].columns;
    for (std::size_t k = 0; k < columns.size(); ++k) {
      if (columns[k].role == Role::length && query[k] < Real(0.01)) query[k] = Real(0.01);
    }
    return verdict_by(right, query);
  });
}

// A quaternion shorter than 1e-6 taken for no rotation.
inline Kernel without_short_quaternions(const Kernel& base) {
  return answered_by(base, "short-quaternions",
                     []<class Real>(const Kernel& of, const auto& right, Numbers<Real> query) {
                       for (const diagnosis::Scaling& turn : diagnosis::quaternions(of)) {
                         Real squared = 0;
                         for (const std::size_t k : turn.columns) squared += query[k] * query[k];
                         if (!(squared < Real(1e-12))) continue;
                         for (const std::size_t k : turn.columns)
                           query[k] = k == turn.columns.front() ? Real(1) : Real(0);
                       }
                       return verdict_by(right, query);
                     });
}

template <class Real>
diagnosis::ProbeFinding found_of(const Kernel& kernel, const std::string& property, std::uint64_t seed) {
  using namespace diagnosis;
  const std::map<std::string, ProbeFinding (*)(Subject<Real>&)> probes = {
      {"touching", at_touching<Real>},
      {"sides", sides_hit<Real>},
      {"overlap_at_start", overlap_at_start<Real>},
      {"degenerate_triangles", degenerate_triangles<Real>},
      {"subnormal_numbers", subnormal_numbers<Real>},
      {"operation_order", operation_order<Real>},
      {"inner_precision", inner_precision<Real>},
      {"absolute_threshold", absolute_thresholds<Real>},
      {"range_window", range_window<Real>},
      {"nearest_form", nearest_form<Real>}};
  DiagnosisOptions options;
  options.precision = precision_of<Real>;
  options.seed = seed;
  Subject<Real> subject(kernel, options);
  return probes.at(property)(subject);
}
inline diagnosis::ProbeFinding found_of(const Kernel& kernel, Precision precision, const std::string& property,
                                        std::uint64_t seed = 1) {
  return precision == Precision::binary32 ? found_of<float>(kernel, property, seed)
                                          : found_of<double>(kernel, property, seed);
}

}  // namespace axiscert::made
