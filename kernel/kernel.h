// What a kernel is to the harness: functions over a batch, per precision and instruction set.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "kernel/names.h"
#include "kernel/query.h"

namespace axiscert {

// Where a kernel writes the full story of a batch: the comparison bits and the sixteen pairs of computed sides.
template <class Real>
struct Answers {
  std::vector<ComparisonBits> bits;
  std::array<std::vector<Real>, comparison_count> lhs, rhs;

  void resize(std::size_t n) {
    bits.resize(n);
    for (auto& column : lhs) column.resize(n);
    for (auto& column : rhs) column.resize(n);
  }
};

// One kernel in one precision on one instruction set. Both functions are total: any bits in, no trap, no allocation.
template <class Real>
struct Implementation {
  // Verdict only; `out` holds batch.size entries. `separated` or `contact`: a kernel does not look for bad input.
  void (*verdicts)(const QueryColumns<Real>& batch, Verdict* out) = nullptr;
  // Comparison bits and computed sides; `out` is sized to the batch. Null for a kernel that shows only verdicts.
  void (*explain)(const QueryColumns<Real>& batch, Answers<Real>& out) = nullptr;
};

// An instruction set that a kernel can be asked to run on. `scalar` is the reference itself; the rest are Highway's
// names. Best first.
std::vector<std::string> available_targets();
inline constexpr std::string_view scalar_target = "scalar";
// The name as `available_targets` spells it (any case is accepted; `auto` is the best). Throws Error with what exists.
std::string resolve_target(std::string_view name);

struct Kernel {
  std::string_view id;
  std::string_view summary;  // one line
  Strictness strictness;     // of the formulae that it claims to compute
  Implementation<float> (*binary32)(std::string_view target);
  Implementation<double> (*binary64)(std::string_view target);

  template <class Real>
  Implementation<Real> on(std::string_view target) const {
    if constexpr (sizeof(Real) == 4) return binary32(target);
    else return binary64(target);
  }
};

std::span<const Kernel> kernels();
// Throws Error naming the kernels that exist.
const Kernel& find_kernel(std::string_view id);

}  // namespace axiscert
