#include "kernel/registry/self_check.h"

#include <fmt/format.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>

#include "kernel/base/error.h"
#include "kernel/formulae_list.h"
#include "kernel/sphere_triangle/forms/evaluate.h"
#include "kernel/sphere_triangle/forms/formulae_types.h"
#include "kernel/kernel.h"

namespace axiscert {
namespace {

// A number type that stores every result to memory, so that each operation rounds once whatever the compiler was told.
template <class Real>
struct StoredNumber {
  Real value;
  friend StoredNumber operator+(StoredNumber a, StoredNumber b) { return store(a.value + b.value); }
  friend StoredNumber operator-(StoredNumber a, StoredNumber b) { return store(a.value - b.value); }
  friend StoredNumber operator*(StoredNumber a, StoredNumber b) { return store(a.value * b.value); }
  friend StoredNumber operator/(StoredNumber a, StoredNumber b) { return store(a.value / b.value); }
  friend StoredNumber square_root(StoredNumber a) { return store(std::sqrt(a.value)); }
  friend StoredNumber magnitude(StoredNumber a) { return store(std::fabs(a.value)); }
  friend bool operator>(StoredNumber a, StoredNumber b) { return a.value > b.value; }

 private:
  static StoredNumber store(Real result) {
    volatile Real memory = result;
    return {memory};
  }
};

// Whether a and b have the same bits or are both NaN (no order of operations determines the payload).
template <class Real>
bool same(Real a, Real b) {
  using Bits = std::conditional_t<sizeof(Real) == 4, std::uint32_t, std::uint64_t>;
  return std::bit_cast<Bits>(a) == std::bit_cast<Bits>(b) || (a != a && b != b);
}

// Checks the modes of the processor on fixed operands. With u = 2^-p: 1 + u is a tie, which rounds to even; 1 + 3u is
// the other tie; half the least normal number is subnormal and not zero.
template <class Real>
std::optional<std::string> check_environment() {
  volatile Real u = std::numeric_limits<Real>::epsilon() / 2, one = 1, least = std::numeric_limits<Real>::min();
  volatile Real up = one + u, down = -one - u, above = one + 3 * u;
  if (up != one || down != -one || above != one + 4 * u) return "the rounding mode is not to nearest even";
  volatile Real half = least / 2;
  if (half == 0) return "subnormal results are flushed to zero";
  volatile Real doubled = half * 2;
  if (doubled != least) return "subnormal operands are read as zero";
  return std::nullopt;
}

// Queries on which contraction shows: repeated vertices (cross(u, u) turns into noise) and full-width significands, at
// an ordinary and at a nearly subnormal scale. The numbers come from a fixed linear congruence; they only have to use
// all bits.
template <class Real>
QueryBatch<Real> check_queries() {
  QueryBatch<Real> batch(
      67, coordinate_count);  // not a multiple of a vector's length, so that the remainder loop is checked too
  std::uint64_t state = 1;
  const auto next = [&] {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<Real>(static_cast<std::int64_t>(state) >> 11) / static_cast<Real>(std::int64_t{1} << 52);
  };
  for (int i = 0; i < 67; ++i) {
    std::array<Real, coordinate_count> v;
    const Real scale = i % 3 == 2 ? std::numeric_limits<Real>::min() * 4096 : Real(1);
    for (Real& x : v) x = next() * scale;
    if (i % 3 == 1)
      for (int k = 0; k < 3; ++k) v[3 + k] = v[k];
    if (v[12] < 0) v[12] = -v[12];
    batch.push_back(from_coordinates(v));
  }
  return batch;
}

template <class Real>
using StoredSides = Sides<StoredNumber<Real>> (*)(const Query<Real>&);

template <class F, class Real>
Sides<StoredNumber<Real>> sides_through_memory(const Query<Real>& q) {
  return sides_of<F>(problem_as<StoredNumber<Real>>(q, [](Real x) { return StoredNumber<Real>{x}; }));
}

template <class F, class Real>
constexpr StoredSides<Real> stored_function() {
  if constexpr (requires(portable::Problem<Real> p) { F::separated(p); }) return nullptr;
  else return sides_through_memory<F, Real>;
}

// The sides of any set of formulae that has comparisons, with every result stored.
template <class Real>
Sides<StoredNumber<Real>> stored_sides(Formulae formulae, const Query<Real>& q) {
  static constexpr EnumArray<Formulae, StoredSides<Real>> functions = {
#define AXISCERT_FUNCTION(name, type, kind) stored_function<type, Real>(),
      AXISCERT_FORMULAE(AXISCERT_FUNCTION)
#undef AXISCERT_FUNCTION
  };
  return functions[formulae](q);
}

}  // namespace

template <class Real>
std::optional<std::string> self_check(const Kernel& kernel, std::string_view target) {
  if (const auto wrong = check_environment<Real>()) return wrong;
  const Implementation<Real> implementation = kernel.on<Real>(target);
  const QueryBatch<Real> batch = check_queries<Real>();
  Answers<Real> answers;
  answers.resize(batch.size(), comparison_count);
  implementation.explain(batch.columns(), answers);
  for (std::size_t i = 0; i < batch.size(); ++i) {
    const auto expected = stored_sides(formulae_of(kernel), query_from(batch[i]));
    for (std::size_t k = 0; k < comparison_count; ++k) {
      const Real lhs = expected.lhs[k].value, rhs = expected.rhs[k].value;
      if (same(answers.lhs[k][i], lhs) && same(answers.rhs[k][i], rhs)) continue;
      return fmt::format(
          "kernel {} ({}, target {}), {}, self-check query {}: computed {:a} > {:a}, but {:a} > {:a} when each "
          "operation is rounded once; was the kernel compiled without -ffp-contract=off?",
          kernel.id, name(precision_of<Real>), target, comparisons[k].name, i, answers.lhs[k][i], answers.rhs[k][i],
          lhs, rhs);
    }
  }
  return std::nullopt;
}
template std::optional<std::string> self_check<float>(const Kernel&, std::string_view);
template std::optional<std::string> self_check<double>(const Kernel&, std::string_view);

void require_uncontracted(std::string_view target) {
  for (const Kernel& kernel : kernels()) {
    // Kernels of sphere-triangle alone: its formulae are compiled in every form.
    if (!kernel.is_reference || kernel.exposes != Exposure::sides || formulae_of(kernel) == Formulae::none) continue;
    if (target != scalar_target && !kernel.has_simd) continue;
    auto wrong = self_check<float>(kernel, target);
    if (!wrong) wrong = self_check<double>(kernel, target);
    if (wrong) throw HarnessFault("self-check: " + *wrong);
  }
}

}  // namespace axiscert
