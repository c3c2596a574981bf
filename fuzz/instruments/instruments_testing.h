// Kernels with a planted fault, for the tests of the instruments.
#pragma once

#include <string>

#include "kernel/kernel.h"
#include "kernel/sphere_triangle/names.h"

namespace axiscert {

// `published` with every answer to one comparison inverted; its verdicts are unchanged.
inline Kernel published_with_a_wrong_bit(Comparison which) {
  Kernel kernel = find_kernel("published");
  kernel.id = "wrong-bit";
  kernel.is_reference = false;
  const auto inverted = [which]<class Real>(Implementation<Real> right) {
    return Implementation<Real>{right.verdicts, [=](const QueryColumns<Real>& batch, Answers<Real>& out) {
                                  right.explain(batch, out);
                                  for (std::size_t i = 0; i < batch.size; ++i) {
                                    out.bits[i] ^= one_bit<ComparisonBits>(which);
                                  }
                                }};
  };
  kernel.binary32 = [=](std::string_view target) { return inverted(find_kernel("published").on<float>(target)); };
  kernel.binary64 = [=](std::string_view target) { return inverted(find_kernel("published").on<double>(target)); };
  return kernel;
}

// `published`, but separated for every radius from 2^20 to 2^30.
inline Kernel published_with_a_gap() {
  Kernel kernel = find_kernel("published");
  kernel.id = "gap";
  kernel.is_reference = false;
  const auto with_gap = []<class Real>(Implementation<Real> right) {
    return Implementation<Real>{[=](const QueryColumns<Real>& batch, Verdict* out) {
                                  right.verdicts(batch, out);
                                  for (std::size_t i = 0; i < batch.size; ++i) {
                                    const Real r = batch.column[12][i];
                                    if (r >= Real(0x1p20) && r <= Real(0x1p30)) out[i] = Verdict::separated;
                                  }
                                },
                                right.explain};
  };
  kernel.binary32 = [=](std::string_view target) { return with_gap(find_kernel("published").on<float>(target)); };
  kernel.binary64 = [=](std::string_view target) { return with_gap(find_kernel("published").on<double>(target)); };
  return kernel;
}

// `certified`, by its verdict alone, with `instead` in place of every contact, or of every verdict.
inline Kernel saying(Verdict instead, bool everywhere) {
  Kernel kernel = find_kernel("certified");
  kernel.id = "saying";
  kernel.formulae.clear();
  kernel.exposes = Exposure::verdict;
  kernel.is_reference = false;
  const auto made = [instead, everywhere]<class Real>(Implementation<Real> right) {
    return Implementation<Real>{[=](const QueryColumns<Real>& batch, Verdict* out) {
      right.verdicts(batch, out);
      for (std::size_t i = 0; i < batch.size; ++i) {
        if (everywhere || out[i] == Verdict::contact) out[i] = instead;
      }
    }};
  };
  kernel.binary32 = [=](std::string_view target) { return made(find_kernel("certified").on<float>(target)); };
  kernel.binary64 = [=](std::string_view target) { return made(find_kernel("certified").on<double>(target)); };
  return kernel;
}

}  // namespace axiscert
